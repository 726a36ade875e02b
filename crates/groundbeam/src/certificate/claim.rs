//! What is claimed: the answer that is to be proven, piece by piece.

use crate::numeric::polynomial::{jet, value};

/// What is claimed, from left to right.
pub(crate) struct Claim<'a> {
    pub pieces: Vec<ClaimedPiece<'a>>,
    /// Concentrated contact forces: position, force up.
    pub forces: Vec<(f64, f64)>,
    /// Reactions of the supports: position, force up, moment.
    pub reactions: Vec<(f64, f64, f64)>,
    /// The part of the beam's own buckling load that its compression leaves: 1 for P ≥ 0.
    pub stability: f64,
}

/// A part of the beam on which w and p are polynomials of s ∈ \[−1, 1\].
#[derive(Debug)]
pub(crate) struct ClaimedPiece<'a> {
    pub x: [f64; 2],
    /// Half its length; the ends themselves are rounded.
    pub half: f64,
    pub deflection: &'a [f64],
    /// φ(s), the rotation of the sections; none where it is w'.
    pub rotation: &'a [f64],
    pub pressure: &'a [f64],
    /// u at both ends where the ground is free; none where it follows the beam.
    pub open: Option<[f64; 2]>,
}

impl Claim<'_> {
    /// w and φ at a position.
    pub fn deflection(&self, x: f64) -> [f64; 2] {
        let i = self.pieces.partition_point(|piece| piece.x[1] < x).min(self.pieces.len() - 1);
        let piece = &self.pieces[i];
        let half = piece.half;
        let s = ((x - 0.5 * (piece.x[0] + piece.x[1])) / half).clamp(-1.0, 1.0);
        let [w, dw, ..] = jet(piece.deflection, s);
        [w, if piece.rotation.is_empty() { dw / half } else { value(piece.rotation, s) }]
    }
}

/// Positions this close, as a part of the length, are the same: nodes within rounding of each other were
/// one node.
pub(crate) const NEAR: f64 = 16.0 * f64::EPSILON;

/// A change of any part of an answer shows in its certificate.
#[cfg(test)]
mod tests {
    use super::super::{Certificate, certify};
    use super::{Claim, ClaimedPiece};
    use crate::model::{Acts, Beam, Foundation, Hinge, Load, Model, Profile, Support};
    use crate::solution::candidate::Candidate;
    use crate::solution::solution::Solution;
    use crate::{Outcome, solve};

    fn models() -> Vec<(&'static str, Model)> {
        let kikuchi = || {
            Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
                .with_load(Load::point_force(0.5, 1.0))
        };
        let two_grounds = Foundation::pasternak(2.0, 0.5).with_segment(1.0, 2.5, 5.0, 2.0);
        vec![
            ("touching", kikuchi().with_load(Load::point_moment(0.5, 0.1))),
            ("lifted", kikuchi().with_load(Load::point_moment(0.5, 0.49))),
            (
                "on springs",
                Model::new(Beam::uniform(4.0, 1.0), Foundation::winkler(3.0))
                    .with_load(Load::point_force(1.0, 1.0)),
            ),
            (
                "two ends",
                Model::new(Beam::uniform(2.0, 1.0), Foundation::pasternak(1.0, 0.3))
                    .with_gap(0.0, 0.0)
                    .with_gap(1.0, 1.0)
                    .with_gap(2.0, 0.0)
                    .with_load(Load::point_force(0.7, 0.4)),
            ),
            (
                "supported",
                Model::new(Beam::uniform(3.0, 2.0), two_grounds)
                    .with_support(Support::pinned(0.0))
                    .with_support(Support::spring(2.0, 4.0, 0.7))
                    .with_load(Load::uniform_force(0.5, 3.0, 1.0))
                    .with_load(Load::point_moment(1.3, -0.2)),
            ),
            (
                "hinged",
                kikuchi()
                    .with_hinge(Hinge::free(0.4))
                    .with_hinge(Hinge::elastic(0.7, 0.8))
                    .with_load(Load::uniform_force(0.0, 1.0, 0.3)),
            ),
            (
                "a hinge that opens upward",
                Model::new(Beam::uniform(2.0, 1.0), Foundation::pasternak(1.0, 2.0))
                    .with_hinge(Hinge::free(1.0))
                    .with_load(Load::point_force(0.4, 1.0))
                    .with_load(Load::point_force(1.5, 1.0)),
            ),
            (
                "hung between hinges",
                Model::new(Beam::uniform(5.0, 1.0), Foundation::winkler(2.0))
                    .with_hinge(Hinge::free(2.0))
                    .with_hinge(Hinge::free(3.0))
                    .with_support(Support::fixed(0.0))
                    .with_gap(0.0, 5.0)
                    .with_gap(3.0, 5.0)
                    .with_gap(3.2, 0.0)
                    .with_load(Load::uniform_force(2.0, 5.0, 1.0)),
            ),
            (
                "on bearings",
                Model::new(Beam::uniform(3.0, 2.0), Foundation::pasternak(2.0, 0.5))
                    .with_support(Support::pinned(0.0).acting(Acts::Down))
                    .with_support(Support::spring(1.2, 4.0, 0.0).acting(Acts::Up))
                    .with_support(Support::pinned(2.0).acting(Acts::Up))
                    .with_support(Support::pinned(2.6).acting(Acts::Down))
                    .with_load(Load::point_force(1.4, 1.0))
                    .with_load(Load::point_force(3.0, 3.0)),
            ),
            ("varying", {
                let beam = Beam::uniform(2.0, 1.0).with_varying_segment(
                    0.0,
                    2.0,
                    Profile::linear(1.0, 0.6),
                );
                let ground = Foundation::winkler(1.0).with_varying_segment(
                    0.0,
                    2.0,
                    Profile::linear(1.0, 2.0),
                    Profile::linear(1.0, 0.6),
                );
                Model::new(beam, ground)
                    .with_load(Load::point_force(1.0, 1.0))
                    .with_load(Load::point_moment(1.0, 0.8))
            }),
            ("pulled", {
                let mut model = kikuchi().with_load(Load::point_moment(0.5, 0.7));
                model.beam.axial_force = 2.0;
                model
            }),
        ]
    }

    fn solved(model: &Model) -> Solution {
        match solve(model) {
            Ok(Outcome::Equilibrium(solution)) => *solution,
            other => panic!("{other:?}"),
        }
    }

    fn proof(solution: &Candidate) -> Certificate {
        let ends = solution.end_forces;
        let mut forces = vec![(0.0, ends.left)];
        forces.extend(solution.concentrated.iter().map(|c| (c.at, c.force)));
        forces.push((solution.model.beam.length, ends.right));
        let pieces = solution.pieces.iter().map(|stretch| ClaimedPiece {
            x: stretch.x,
            half: stretch.half,
            deflection: &stretch.deflection,
            rotation: &stretch.rotation,
            pressure: &stretch.pressure,
            open: stretch.open,
        });
        let claim = Claim {
            pieces: pieces.collect(),
            forces,
            reactions: solution.reactions.iter().map(|r| (r.at, r.force, r.moment)).collect(),
            stability: 1.0,
        };
        certify(&solution.model, &claim)
    }

    /// What the certificate sees: the error in the norm of the energies, or a violation.
    fn seen(solution: &Candidate) -> f64 {
        let proof = proof(solution);
        proof.relative_gap().sqrt().max(proof.violation())
    }

    const CHANGE: f64 = 1e-9;

    fn nudge(x: &mut f64) {
        *x *= 1.0 + CHANGE;
    }

    #[test]
    fn no_change_goes_unseen() {
        let mut unseen = Vec::new();
        for (name, model) in models() {
            let good = solved(&model).into_parts().0;
            assert!(seen(&good) < 3e-12, "{name}: {:?}", proof(&good));
            let mut check = |what: String, change: &dyn Fn(&mut Candidate)| {
                let mut changed = good.clone();
                change(&mut changed);
                let seen = seen(&changed);
                // A part of the change, since no single number weighs all of the answer.
                if seen.is_nan() || seen < 2e-3 * CHANGE {
                    unseen.push(format!("{name}: {what}: {seen:e}"));
                }
            };
            for (i, stretch) in good.pieces.iter().enumerate() {
                let largest = |c: &[f64]| c.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
                for j in 0..stretch.deflection.len() {
                    if stretch.deflection[j].abs() > 0.1 * largest(&stretch.deflection) {
                        check(format!("w[{i}][{j}]"), &|s| nudge(&mut s.pieces[i].deflection[j]));
                    }
                }
                for j in 0..stretch.pressure.len() {
                    if stretch.pressure[j].abs() > 0.1 * largest(&stretch.pressure) {
                        check(format!("p[{i}][{j}]"), &|s| nudge(&mut s.pieces[i].pressure[j]));
                    }
                }
                for end in 0..2 {
                    if stretch.open.is_some_and(|u| u[end] != 0.0) {
                        check(format!("u[{i}][{end}]"), &|s| {
                            if let Some(u) = &mut s.pieces[i].open {
                                nudge(&mut u[end]);
                            }
                        });
                    }
                }
                if i > 0 {
                    check(format!("edge {i}"), &|s| {
                        let move_by = CHANGE * s.model.beam.length;
                        s.pieces[i - 1].x[1] += move_by;
                        s.pieces[i - 1].half += 0.5 * move_by;
                        s.pieces[i].x[0] += move_by;
                        s.pieces[i].half -= 0.5 * move_by;
                    });
                    check(format!("joint {i}"), &|s| s.pieces[i].x[0] += CHANGE);
                }
                check(format!("half {i}"), &|s| nudge(&mut s.pieces[i].half));
                check(format!("a piece {i} left out"), &|s| {
                    s.pieces.remove(i);
                });
            }
            let ends = good.end_forces;
            if ends.left > 0.0 {
                check("p0".into(), &|s| nudge(&mut s.end_forces.left));
            }
            if ends.right > 0.0 {
                check("pl".into(), &|s| nudge(&mut s.end_forces.right));
            }
            for i in 0..good.concentrated.len() {
                check(format!("force {i}"), &|s| nudge(&mut s.concentrated[i].force));
            }
            for i in 0..good.reactions.len() {
                if good.reactions[i].force != 0.0 {
                    check(format!("reaction {i}"), &|s| nudge(&mut s.reactions[i].force));
                }
                if good.reactions[i].moment != 0.0 {
                    check(format!("turning {i}"), &|s| nudge(&mut s.reactions[i].moment));
                }
            }
        }
        assert!(unseen.is_empty(), "{}", unseen.join("\n"));
    }

    /// The numbers of Kikuchi's cases are proven to twelve digits.
    #[test]
    fn a_short_beam_is_proven_to_twelve_digits() {
        for (name, model) in models().into_iter().take(2) {
            let solution = solved(&model);
            let proof = solution.certificate();
            assert!(proof.relative_gap() < 1e-24, "{name}: {proof:?}");
            assert!(proof.settlement_bound() < 1e-12, "{name}: {proof:?}");
        }
    }

    #[test]
    fn without_loads_there_is_no_error() {
        let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
            .with_support(Support::pinned(0.0))
            .with_support(Support::pinned(1.0));
        let proof = *solved(&model).certificate();
        assert_eq!((proof.settlement_bound(), proof.gap()), (0.0, 0.0));
    }
}
