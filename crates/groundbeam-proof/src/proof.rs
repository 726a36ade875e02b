//! Proves a claimed solution by an admissible deflection, a balanced pressure, and a bound of the difference of their energies.

use crate::answer::Answer;
use crate::bounds::{Bound, Bounds, ReactionBound, Scales};
use crate::contact_set::ContactSet;
use crate::energies::Energies;
use crate::fields::Fields;
use crate::frame::{Frame, Span};
use crate::given::frame;
use crate::idle;
use crate::log::Log;
use crate::model::Model;
use crate::pointwise::{PieceBounds, Pointwise};
use crate::polynomial::Polynomial;
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::scales::FieldScales;
use crate::size::Size;

/// What is proven about a claimed solution, with error bounds.
#[derive(Debug, Clone, PartialEq)]
pub struct Proof {
    /// Upper bound E \[N·m\] of the error energy. It bounds the sum of two energies: that of the errors of deflection
    /// and settlement, and that of the errors of moment and pressure.
    pub energy: f64,
    /// Estimate of the strain energy of beam, ground and springs \[N·m\]. The bound of the error energy is compared
    /// with it.
    pub strain_energy: f64,
    /// Error bounds of the fields. Each bound holds at every point of the beam. A finite bound of w proves that a
    /// solution exists.
    pub bounds: Bounds,
    /// Error bounds of the reactions, for each support of the model.
    pub reactions: Vec<ReactionBound>,
    /// The exact contact set, with an interval for every contact edge and concentrated force, or the reason why it is
    /// not proven. All other bounds hold in either case.
    pub contact: Result<ContactSet, NotProven>,
    /// `Ok` if the solution is unique.
    pub unique: Result<(), NotProven>,
    /// `Ok` if each one-way support is proven to be active or proven to be inactive. All error bounds hold even if this
    /// is not proven.
    pub supports: Result<(), NotProven>,
    /// The scales with which the errors of contact edges and of concentrated forces are compared.
    pub scales: Scales,
}

impl Proof {
    /// The first reason why the claimed solution is not proven; `None` if it is proven.
    ///
    /// A claimed solution is proven if an exact solution exists and is unique, if the contact set and the active
    /// supports are proven, and if every error bound is at most 10⁻⁶ of its scale.
    pub fn shortfall(&self) -> Option<NotProven> {
        if !(self.bounds.deflection.error < f64::INFINITY) {
            return Some(NotProven::new(
                "no equilibrium is proven, because the deflection has no error bound",
            ));
        }
        let too_large = |name: &str, bound: Bound| {
            let Bound { error, scale } = bound;
            let what = format!(
                "the error bound of the {name} is too large: {error:.1e} is more than a millionth of the scale {scale:.1e}"
            );
            (!bound.is_small()).then(|| NotProven::new(what))
        };
        let unique = self.unique.as_ref().err().cloned();
        let set = unique.or_else(|| self.contact.as_ref().err().cloned());
        let set = set.or_else(|| self.supports.as_ref().err().cloned());
        let fields = || {
            let named = self.bounds.named().into_iter();
            named.filter_map(|(name, bound)| too_large(&name.replace('_', " "), bound)).next()
        };
        let supports = || {
            let both = self.reactions.iter().flat_map(|r| [r.force, r.moment]);
            both.filter_map(|bound| too_large("reactions", bound)).next()
        };
        set.or_else(fields).or_else(|| self.intervals(too_large)).or_else(supports)
    }

    /// Reports the first contact edge or concentrated force whose interval is too wide; `None` if all intervals are
    /// narrow enough.
    fn intervals(&self, too_large: impl Fn(&str, Bound) -> Option<NotProven>) -> Option<NotProven> {
        let set = self.contact.as_ref().ok()?;
        let width = |[low, high]: [f64; 2]| (high - low).next_up();
        let mut edges = set.regions.iter().flat_map(|region| [region.from, region.to]);
        let scale = self.scales.length;
        let edge =
            edges.find_map(|x| too_large("edges of contact", Bound { error: width(x), scale }));
        let mut forces = set.forces.iter().map(|force| force.force);
        let scale = self.scales.force;
        edge.or_else(|| {
            forces.find_map(|f| too_large("concentrated forces", Bound { error: width(f), scale }))
        })
    }
}

/// Proves a claimed solution. Calls `conclude` with the fields constructed from the claimed solution and with the
/// proof. Writes a log if one is given.
pub(crate) fn proven<S: Scalar, T>(
    model: &Model<S>,
    answer: &Answer,
    mut log: Option<&mut Log>,
    conclude: impl FnOnce(&Fields<S>, Proof) -> T,
) -> Result<T, NotProven> {
    let mut placed = Vec::new();
    loop {
        let frame = frame(model, answer, None, &placed)?;
        let fields = Fields::of(&frame)?;
        match of_fields(&fields, answer, log.as_deref_mut())? {
            Attempt::Done(proof) => return Ok(conclude(&fields, *proof)),
            Attempt::Close(supports) => placed.extend(supports),
        }
    }
}

/// The result of an attempt to prove a claimed solution.
enum Attempt {
    Done(Box<Proof>),
    /// Supports at which nodes must be added, because the beam may touch these supports in the exact solution.
    Close(Vec<usize>),
}

/// Attempts to prove the claimed solution from which `fields` were constructed.
fn of_fields<S: Scalar>(
    fields: &Fields<S>,
    answer: &Answer,
    log: Option<&mut Log>,
) -> Result<Attempt, NotProven> {
    let frame = fields.frame;
    let has_loaded_winkler_ground = |span: &Span<S>| !span.layered && span.ground_load.is_some();
    if frame
        .spans
        .iter()
        .any(|span| has_loaded_winkler_ground(span) && span.spring.even().is_none())
    {
        return Err(NotProven::new("not covered: a load on Winkler ground whose k varies"));
    }
    let (energy, balanced) = fields.energy()?;
    if !(energy.value() < f64::INFINITY) {
        return Err(NotProven::new(
            "the bound on the energy of the claimed solution's error is infinite",
        ));
    }
    let pointwise = Pointwise { fields, balanced: &balanced, energy };
    let mut pieces = pointwise.bounds();
    let close = idle::close(frame, &pieces);
    if !close.is_empty() {
        return Ok(Attempt::Close(close));
    }
    let shown = pointwise.contact(&mut pieces);
    let of_supports = pointwise.reactions(&pieces);
    let supports = idle::decided(frame, &pieces, &of_supports);
    let unique = pointwise.unique(&shown, &of_supports);
    if let Some(log) = log {
        log.record(&pointwise, &pieces, &shown);
        log.supports(frame, &of_supports, supports.is_ok());
        log.unique(unique.is_ok());
    }
    add_stored(answer, fields, &mut pieces);
    let scales = FieldScales::of(fields, &pieces);
    let units = frame.units;
    Ok(Attempt::Done(Box::new(Proof {
        energy: units.restored(energy.value(), 1, 1),
        strain_energy: units.restored(Energies::of(fields).strain, 1, 1),
        bounds: largest(frame, &pieces, &scales, shown.failed[0].is_none()),
        reactions: reactions(frame, &of_supports, &scales),
        unique,
        contact: shown.result(),
        scales: Scales {
            length: units.restored(frame.length.low(), 0, 1),
            force: units.restored(scales.force, 1, 0),
        },
        supports,
    })))
}

/// Adds to the error bounds of pressure and settlement the difference between the stored values and the values that
/// follow from the deflection.
fn add_stored<S: Scalar>(answer: &Answer, fields: &Fields<S>, bounds: &mut [PieceBounds]) {
    let units = fields.frame.units;
    for (i, (piece, bounds)) in answer.pieces.iter().zip(bounds).enumerate() {
        let span = &fields.frame.spans[i];
        if !piece.pressure.is_empty() {
            let stored = piece.pressure.iter().map(|c| units.scaled(S::of(*c), 1, -1));
            let differs = <Polynomial<_>>::from_coefficients(stored) - &fields.pressures[i].field;
            bounds.pressure += differs.size(span.tau);
        }
        let ends = settled_ends(fields, i);
        let off_the_ends = |stored: [S; 2]| {
            let [left, right] = [0, 1].map(|end| Size::of((stored[end] - ends[end]).size()));
            left.worst(right)
        };
        if let Some(stored) = span.stored {
            bounds.settlement += off_the_ends(stored);
        }
        if let Some(stored) = span.settlement.as_deref() {
            bounds.settlement += match &fields.surface.pieces[i].along {
                Some(along) => (*stored - along).size(span.tau),
                None if span.touches => (*stored - &span.obstacle()).size(span.tau),
                // The difference y of stored and computed settlement satisfies ky − (μy′)′ = ρ, with the residual ρ. By
                // the maximum principle, |y| is at most max|ρ|/k plus the larger |y| at both ends.
                None => {
                    let missed = span.missed_by(stored).size(span.tau);
                    off_the_ends(span.t.map(|t| stored.value(t))) + missed.over(span.spring.low())
                }
            };
        }
    }
}

/// The settlement u at both ends of a piece.
fn settled_ends<S: Scalar>(fields: &Fields<S>, i: usize) -> [S; 2] {
    let span = &fields.frame.spans[i];
    let at_ends = |field: Polynomial<S>| span.t.map(|t| field.value(t));
    match (fields.surface.pieces[i].open, span.free_field()) {
        _ if span.touches => at_ends(span.obstacle()),
        (Some(ends), _) => ends,
        (None, Some(free)) => at_ends(Polynomial::zero() + &free),
        (None, None) => [S::zero(); 2],
    }
}

/// Converts an error bound and its scale to the units of the model.
fn bound<S>(frame: &Frame<S>, error: Size, scale: f64, force: i32, length: i32) -> Bound {
    let restored = |x: f64| frame.units.restored(x, force, length);
    Bound { error: restored(error.value()), scale: restored(scale) }
}

/// Largest error bound of each field over all pieces, in the units of the model. On a shear layer, the pressure has no
/// bound if the contact set is not proven.
fn largest<S: Scalar>(
    frame: &Frame<S>,
    pieces: &[PieceBounds],
    scales: &FieldScales,
    layers_shown: bool,
) -> Bounds {
    let most =
        |of: &dyn Fn(&PieceBounds) -> Size| pieces.iter().map(of).fold(Size::ZERO, Size::worst);
    let pressures =
        frame.spans.iter().zip(pieces).map(|(span, piece)| match (span.layered, span.touches) {
            (true, _) if !layers_shown => Size::INFINITE,
            (true, false) => Size::ZERO,
            _ => piece.pressure,
        });
    let pressure = pressures.fold(Size::ZERO, Size::worst);
    Bounds {
        deflection: bound(frame, most(&|p| p.deflection), scales.deflection, 0, 1),
        slope: bound(frame, most(&|p| p.slope), scales.slope, 0, 0),
        rotation: bound(frame, most(&|p| p.rotation), scales.slope, 0, 0),
        moment: bound(frame, most(&|p| p.moment), scales.moment, 1, 1),
        shear_force: bound(frame, most(&|p| p.shear_force), scales.shear_force, 1, 0),
        settlement: bound(frame, most(&|p| p.settlement), scales.deflection, 0, 1),
        pressure: bound(frame, pressure, scales.pressure, 1, -1),
    }
}

fn reactions<S>(
    frame: &Frame<S>,
    errors: &[[Size; 2]],
    scales: &FieldScales,
) -> Vec<ReactionBound> {
    let of = |[force, moment]: &[Size; 2]| ReactionBound {
        force: bound(frame, *force, scales.force, 1, 0),
        moment: bound(frame, *moment, scales.turning, 1, 1),
    };
    errors.iter().map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact_set::{ContactForce, ContactRegion};
    use crate::given_claim::with_fields;
    use serde_json::json;

    /// A proof in which all error bounds are zero, with a contact region from 0 to 1 and a concentrated contact force.
    fn exact() -> Proof {
        let none = Bound { error: 0.0, scale: 1.0 };
        let bounds = Bounds {
            deflection: none,
            slope: none,
            rotation: none,
            moment: none,
            shear_force: none,
            settlement: none,
            pressure: none,
        };
        Proof {
            energy: 0.0,
            strain_energy: 1.0,
            bounds,
            reactions: vec![ReactionBound { force: none, moment: none }],
            contact: Ok(ContactSet {
                regions: vec![ContactRegion { from: [0.0; 2], to: [1.0; 2] }],
                forces: vec![ContactForce { x: 0.0, force: [3.0; 2] }],
            }),
            unique: Ok(()),
            supports: Ok(()),
            scales: Scales { length: 2.0, force: 8.0 },
        }
    }

    /// Each error of a proven solution is at most 10⁻⁶ of its scale. Here the scale is 1 for fields and reactions, 2
    /// for edges, and 8 for concentrated forces.
    #[test]
    fn every_error_of_a_proven_answer_is_small() {
        let set = |proof: &mut Proof, change: fn(&mut ContactSet, f64), width: f64| {
            change(proof.contact.as_mut().expect("a set"), width);
        };
        type Change = (&'static str, f64, fn(&mut ContactSet, f64));
        let changes: [Change; 3] = [
            ("edges", 2e-6, |set, width| set.regions[0].from = [0.0, width]),
            ("edges", 2e-6, |set, width| set.regions[0].to = [1.0 - width, 1.0]),
            ("concentrated forces", 8e-6, |set, width| set.forces[0].force = [3.0, 3.0 + width]),
        ];
        assert_eq!(exact().shortfall(), None);
        for (name, most, change) in changes {
            for (part, small) in [(0.99, true), (1.01, false)] {
                let mut proof = exact();
                set(&mut proof, change, part * most);
                let why = proof.shortfall();
                assert_eq!(why.is_none(), small, "{name} {why:?}");
                assert!(why.is_none_or(|why| why.what.contains(name)));
            }
        }
        let wide = Bound { error: 1.01e-6, scale: 1.0 };
        let changes: [fn(&mut Proof, Bound); 9] = [
            |proof, wide| proof.bounds.deflection = wide,
            |proof, wide| proof.bounds.slope = wide,
            |proof, wide| proof.bounds.rotation = wide,
            |proof, wide| proof.bounds.moment = wide,
            |proof, wide| proof.bounds.shear_force = wide,
            |proof, wide| proof.bounds.settlement = wide,
            |proof, wide| proof.bounds.pressure = wide,
            |proof, wide| proof.reactions[0].force = wide,
            |proof, wide| proof.reactions[0].moment = wide,
        ];
        for change in changes {
            let mut proof = exact();
            change(&mut proof, wide);
            assert!(proof.shortfall().is_some());
        }
        let mut proof = exact();
        proof.bounds.deflection.error = f64::INFINITY;
        assert!(proof.shortfall().is_some_and(|why| why.what.contains("no equilibrium")));
        for part in 0..3 {
            let (mut proof, why) = (exact(), NotProven::new("not decided"));
            match part {
                0 => proof.unique = Err(why.clone()),
                1 => proof.contact = Err(why.clone()),
                _ => proof.supports = Err(why.clone()),
            }
            assert_eq!(proof.shortfall(), Some(why));
        }
    }

    /// Winkler ground with k = 2 settles by ½ under the load 1. Stored end values `open` add their largest difference
    /// from ½ to the error bound. A constant `settlement` adds its difference twice: at the ends and as a residual.
    #[test]
    fn a_stored_surface_of_open_springs_adds_its_error() {
        let model = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 2\nmu = 0\n\
                     [[ground_load]]\ndistributed = 1\nfrom = 0\nto = 1\n";
        let piece = |stored: serde_json::Value| {
            let mut piece = json!({"x": [0, 1], "half": 0.5, "touches": false, "deflection": [-1]});
            piece
                .as_object_mut()
                .expect("a piece")
                .extend(stored.as_object().expect("a surface").clone());
            json!({ "pieces": [piece] })
        };
        for (stored, error) in [
            (json!({}), 0.0),
            (json!({"open": [0.5, 0.5]}), 0.0),
            (json!({"open": [0.5, 0.75]}), 0.25),
            (json!({"open": [-0.5, 0.5]}), 1.0),
            (json!({"settlement": [0.5]}), 0.0),
            (json!({"settlement": [0.75]}), 0.5),
            // The settlement equals w − g₀ = −1 only in contact, but this ground is out of contact.
            (json!({"settlement": [-1.0]}), 3.0),
        ] {
            let document = piece(stored);
            let answer = Answer::from_json(&document.to_string()).expect("an answer");
            with_fields(model, &document, |fields| {
                let mut bounds = [PieceBounds::EXACT];
                add_stored(&answer, fields, &mut bounds);
                let found = bounds[0].settlement.value();
                assert!(error <= found && found <= error + 1e-12, "{document}: {found} {error}");
            });
        }
    }
}
