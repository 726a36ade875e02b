//! Converts model and solution to the input of the proof, which treats their doubles as exact numbers.

use crate::model::support::Reaction;
use crate::model::{Action, Acts, Extent, GapPoint, GroundEnd, Hinge, Load, Model, Profile};
use crate::model::{Support, SupportKind};
use crate::solution::candidate::Candidate;
use crate::solution::fields::Side;
use groundbeam_proof::{self as proof, Answer, NotProven, Proof, Scalar, Wide};

/// The beam counts as close to a support if the distance between beam and support is at most this fraction of the
/// larger of beam deflection and support settlement.
const CLOSE_TO_SUPPORT: f64 = 1e-6;

/// The proof of a solution.
pub(super) fn prove(candidate: &Candidate) -> Result<Proof, NotProven> {
    proof::prove(&candidate.model.to_prove::<Wide>(), &answer(candidate))
}

impl Model {
    /// Converts the model to the input of the proof, with its doubles as exact numbers. Soil data are replaced by the
    /// constants k and μ in the foundation.
    pub fn to_prove<S: Scalar>(&self) -> proof::Model<S> {
        let hinge = |hinge: &Hinge| proof::Hinge {
            at: S::of(hinge.at),
            rotational_spring: S::of(hinge.rotational_spring),
        };
        let corner = |corner: &GapPoint| proof::GapCorner {
            at: S::of(corner.at),
            value: S::of(corner.value),
        };
        proof::Model {
            beam: beam(self),
            ground: ground(self),
            loads: self.loads.iter().map(load).collect(),
            supports: self.supports.iter().map(support).collect(),
            hinges: self.hinges.iter().map(hinge).collect(),
            gap: self.gap.iter().map(corner).collect(),
        }
    }
}

fn course<S: Scalar>(profile: &Profile) -> proof::Course<S> {
    if profile.is_constant() {
        return proof::Course::Constant(S::of(profile.start()));
    }
    proof::Course::Varying(profile.control_values().iter().map(|value| S::of(*value)).collect())
}

fn beam<S: Scalar>(model: &Model) -> proof::Beam<S> {
    let beam = &model.beam;
    let segments = beam.segments.iter().map(|segment| proof::BeamSegment {
        from: S::of(segment.from),
        to: S::of(segment.to),
        bending_stiffness: course(&segment.bending_stiffness),
        shear_stiffness: segment.shear_stiffness.as_ref().map(course),
    });
    proof::Beam {
        length: S::of(beam.length),
        bending_stiffness: S::of(beam.bending_stiffness),
        shear_stiffness: beam.shear_stiffness.map(S::of),
        segments: segments.collect(),
        axial_force: S::of(beam.axial_force),
    }
}

fn ground<S: Scalar>(model: &Model) -> proof::Ground<S> {
    let ground = &model.foundation;
    let segments = ground.segments.iter().map(|segment| proof::GroundSegment {
        from: S::of(segment.from),
        to: S::of(segment.to),
        spring: course(&segment.subgrade),
        shear: course(&segment.shear_layer),
    });
    let end = |end: GroundEnd| match end {
        GroundEnd::Endless => proof::GroundEnd::Endless,
        GroundEnd::Free { at } => proof::GroundEnd::Free(S::of(at)),
        GroundEnd::Held { at } => proof::GroundEnd::Held(S::of(at)),
    };
    proof::Ground {
        spring: S::of(ground.subgrade),
        shear: S::of(ground.shear_layer),
        segments: segments.collect(),
        ends: ground.ends.map(end),
    }
}

fn load<S: Scalar>(load: &Load) -> proof::Load<S> {
    proof::Load {
        action: match load.action() {
            Action::Force => proof::Action::Force,
            Action::Moment => proof::Action::Moment,
            Action::Curvature => proof::Action::Curvature,
        },
        extent: match load.extent() {
            Extent::Point { at, size } => proof::Extent::Point { at: S::of(at), size: S::of(size) },
            Extent::Distributed { from, to, start, end } => proof::Extent::Distributed {
                from: S::of(from),
                to: S::of(to),
                start: S::of(start),
                end: S::of(end),
            },
        },
        on_ground: load.is_on_ground(),
    }
}

fn support<S: Scalar>(support: &Support) -> proof::Support<S> {
    proof::Support {
        at: S::of(support.at),
        kind: match support.kind {
            SupportKind::Pinned => proof::SupportKind::Pinned,
            SupportKind::Fixed => proof::SupportKind::Fixed,
            SupportKind::Spring { spring, rotational_spring } => proof::SupportKind::Spring {
                spring: S::of(spring),
                rotational_spring: S::of(rotational_spring),
            },
        },
        settlement: S::of(support.settlement),
        acts: match support.acts {
            Acts::Both => proof::Acts::Both,
            Acts::Up => proof::Acts::Up,
            Acts::Down => proof::Acts::Down,
        },
    }
}

/// Converts the solution to the input of the proof, piece by piece.
pub(super) fn answer(candidate: &Candidate) -> Answer {
    let mut pieces: Vec<proof::Piece> = Vec::with_capacity(candidate.pieces.len());
    for piece in candidate.pieces.iter().filter(|piece| has_inside(piece.x)) {
        let own = [-1.0, 1.0].map(|s| piece.cell.free_field_at(s)[0]);
        let from = pieces.last().map_or(0.0, |last| last.x[1]);
        // Out of contact, w has few nonzero coefficients. The proof requires at least one coefficient.
        let deflection = piece.deflection.without_zeros().at_least(1);
        pieces.push(proof::Piece {
            x: [from, piece.x[1]],
            half: piece.half,
            touches: piece.open.is_none(),
            deflection: deflection.to_vec(),
            rotation: piece.rotation.to_vec(),
            pressure: piece.pressure.to_vec(),
            open: piece.open.map(|ends| [ends[0] + own[0], ends[1] + own[1]]),
            settlement: piece.settlement.to_vec(),
        });
    }
    if let Some(last) = pieces.last_mut() {
        last.x[1] = candidate.model.beam.length;
    }
    for support in candidate.model.supports.iter().zip(&candidate.reactions) {
        end_at_support(candidate, support, &mut pieces);
    }
    let ends = candidate.end_forces;
    let force = |x: f64, force: f64| proof::Force { x, force };
    let mut forces = vec![force(0.0, ends.left)];
    forces.extend(candidate.concentrated.iter().map(|c| force(c.at, c.force)));
    forces.push(force(candidate.model.beam.length, ends.right));
    // On Winkler ground, the proof uses the distributed pressure only. Ground forces at mesh nodes on Winkler
    // ground are omitted.
    let layered = |x: f64| {
        let after = candidate.pieces.partition_point(|piece| piece.x[1] < x);
        let mut beside = candidate.pieces[after..].iter().take(2);
        beside.any(|piece| piece.x[0] <= x && piece.cell.shear_layer > 0.0)
    };
    forces.retain(|force| force.force == 0.0 || layered(force.x));
    let reactions = candidate.reactions.iter().enumerate().map(|(support, reaction)| {
        proof::Reaction { support, force: reaction.force, moment: reaction.moment }
    });
    Answer { pieces, forces, reactions: reactions.collect() }
}

/// Whether a double lies strictly between the ends of a piece. A piece between two adjacent doubles has no such double.
fn has_inside([from, to]: [f64; 2]) -> bool {
    let middle = 0.5 * (from + to);
    from < middle && middle < to
}

/// Splits a piece at an inactive one-way support that the beam nearly reaches. The proof can then treat the
/// support as undecided.
fn end_at_support(
    candidate: &Candidate,
    (support, reaction): (&Support, &Reaction),
    pieces: &mut Vec<proof::Piece>,
) {
    let at = support.at;
    let here = candidate.at(at, Side::Right);
    let largest = here.deflection.abs().max(support.settlement.abs());
    let close = (here.deflection - support.settlement).abs() <= CLOSE_TO_SUPPORT * largest;
    if !(support.is_one_way() && reaction.force == 0.0 && close) {
        return;
    }
    // No split is necessary at a support within rounding error of an end of a piece.
    let apart = 64.0 * f64::EPSILON * candidate.model.beam.length;
    let inside = |piece: &proof::Piece| piece.x[0] + apart < at && at + apart < piece.x[1];
    let Some(i) = pieces.iter().position(inside) else { return };
    let piece = pieces[i].clone();
    let settled = |side: usize| {
        let mut ends = piece.open?;
        ends[1 - side] = here.settlement;
        Some(ends)
    };
    pieces[i] = part(&piece, [piece.x[0], at], settled(0));
    pieces.insert(i + 1, part(&piece, [at, piece.x[1]], settled(1)));
}

/// Returns a part of a piece, with the functions of the piece in the local coordinate t of this part.
fn part(piece: &proof::Piece, x: [f64; 2], open: Option<[f64; 2]>) -> proof::Piece {
    let half = 0.5 * (x[1] - x[0]);
    let offset = (0.5 * (x[0] + x[1]) - 0.5 * (piece.x[0] + piece.x[1])) / piece.half;
    let ratio = half / piece.half;
    // `moved` computes the coefficients of p(offset + ratio · t), a polynomial in t, from the coefficients of the
    // polynomial p by Horner's rule.
    let moved = |coefficients: &[f64]| {
        let mut sum: Vec<f64> = Vec::new();
        for c in coefficients.iter().rev() {
            let times_t = std::iter::once(0.0).chain(sum.iter().map(|s| s * ratio));
            let kept = sum.iter().map(|s| s * offset).chain(std::iter::once(0.0));
            sum = times_t.zip(kept).map(|(a, b)| a + b).collect();
            if let Some(first) = sum.first_mut() {
                *first += c;
            }
            sum.truncate(coefficients.len());
        }
        sum
    };
    proof::Piece {
        x,
        half,
        touches: piece.touches,
        deflection: moved(&piece.deflection),
        rotation: moved(&piece.rotation),
        pressure: moved(&piece.pressure),
        open,
        settlement: moved(&piece.settlement),
    }
}
