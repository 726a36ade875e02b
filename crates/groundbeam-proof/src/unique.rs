//! Proves that the solution is unique.
//!
//! Two solutions differ only by a rigid motion of each part between free hinges. The motion vanishes at supports and
//! wherever the pressure is positive. See section 7 of docs/proof.md.

use crate::anchors::parts_of;
use crate::contact_set::Shown;
use crate::model::Acts;
use crate::pointwise::Pointwise;
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;
use std::ops::Range;

/// The restraints of a part of the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Holds {
    places: usize,
    turning: bool,
    /// Whether supports or contact forces prevent the deflection of the left end and of the right end of the part.
    ends: [bool; 2],
}

impl Holds {
    fn is_enough(self) -> bool {
        self.places + usize::from(self.turning) > 1
    }
}

/// Returns the index of the first part that is a mechanism. A restrained part restrains its neighbours at the
/// common hinges. Each of these hinges counts as one held position.
fn first_mechanism(holds: &[Holds]) -> Option<usize> {
    let mut held = vec![false; holds.len()];
    let next = |held: &[bool]| {
        (0..held.len()).find(|&j| {
            let beside = [j.wrapping_sub(1), j + 1].into_iter().zip(holds[j].ends);
            let hinges = beside.filter(|(i, counted)| held.get(*i) == Some(&true) && !counted);
            let places = holds[j].places + hinges.count();
            !held[j] && Holds { places, ..holds[j] }.is_enough()
        })
    };
    while let Some(j) = next(&held) {
        held[j] = true;
    }
    held.iter().position(|held| !held)
}

impl<S: Scalar> Pointwise<'_, S> {
    /// Proves that the solution is unique. A contact force or a one-way support is a restraint only if its force is
    /// proven to be positive.
    pub fn unique(&self, shown: &Shown, reactions: &[[Size; 2]]) -> Result<(), NotProven> {
        let frame = self.fields.frame;
        if frame.compression.is_some() {
            // Under compression, the two-way supports alone make the energy of the beam strictly convex, so the
            // solution is unique.
            return Ok(());
        }
        let mut pressed = match shown.failed[0] {
            None => shown.pressed.clone(),
            Some(_) => vec![false; shown.pressed.len()],
        };
        for (held, [error, _]) in frame.supports.iter().zip(reactions) {
            let Some(node) = held.node else { continue };
            let acting = frame.nodes[node].acts.towards(held.claimed[0]).low() > error.value();
            pressed[node] |= acting && frame.nodes[node].acts != Acts::Both;
        }
        let parts = self.joined_parts();
        let holds: Vec<Holds> = parts.iter().map(|part| self.holds(part, &pressed)).collect();
        // A part under tension that is held at one point cannot rotate.
        if frame.tension.is_some() && holds.iter().any(|part| part.places > 0) {
            return Ok(());
        }
        match first_mechanism(&holds) {
            None => Ok(()),
            Some(j) => {
                let what = "the solution is not proven to be unique: a part of the beam may move";
                Err(NotProven::new(what).at(frame.place(parts[j].start)))
            }
        }
    }

    /// Counts the supports, contact forces and pressures that restrain a part. A support at a hinge restrains
    /// both adjacent parts.
    fn holds(&self, part: &Range<usize>, pressed: &[bool]) -> Holds {
        let nodes = &self.fields.frame.nodes;
        let inside = part.start..=part.end;
        let held = |i: usize| {
            let both = nodes[i].acts == Acts::Both;
            pressed[i] || (both && (nodes[i].rigid.is_some() || nodes[i].spring.is_some()))
        };
        let at_nodes = inside.clone().filter(|i| held(*i)).count();
        let turning = inside.clone().any(|i| nodes[i].clamped || nodes[i].turning.is_some());
        let pieces = if part.clone().any(|i| self.presses(i)) { 2 } else { 0 };
        Holds { places: at_nodes + pieces, turning, ends: [held(part.start), held(part.end)] }
    }

    /// Whether the exact pressure is proven to be positive at two positions of the piece. See section 7 of
    /// docs/proof.md.
    fn presses(&self, i: usize) -> bool {
        let span = &self.fields.frame.spans[i];
        if !span.touches {
            return false;
        }
        parts_of(span).any(|part| {
            let least = self.least_pressure(i, part);
            // Half of |t| ≤ part.
            let h = [(part * span.half.low()).next_down(), (part * span.half.high()).next_up()];
            let (area, norm) = bump(h, [span.spring.high(), span.shear.size()].map(Size::of));
            area * least > (self.s2() * norm).value().next_up()
        })
    }
}

/// Returns a lower bound of the integral and an upper bound of the energy norm of the weight function 1 − (2t/h)² on
/// |t| ≤ h/2. The length h lies between `low` and `high`.
fn bump([low, high]: [f64; 2], [ground, layer]: [Size; 2]) -> (f64, Size) {
    let norm = (8.0 * (ground * Size::of(high))).over(15.0) + (16.0 * layer).over(3.0).over(low);
    ((0.666 * low).next_down(), norm.root())
}

#[cfg(test)]
mod tests {
    use super::{Holds, bump, first_mechanism};
    use crate::contact_set::Shown;
    use crate::given_claim::{balanced, with_fields};
    use crate::pointwise::Pointwise;
    use crate::size::Size;
    use crate::test_functions::tests::integral;
    use crate::wide::Wide;
    use serde_json::json;

    #[test]
    fn the_area_and_the_norm_of_the_bump_are_bounded() {
        for (h, ground, layer) in [(0.3, 2.0, 0.7), (2.0, 0.5, 3.0), (11.0, 1.0, 1e-3)] {
            let z = |t: f64| 1.0 - (2.0 * t / h - 1.0).powi(2);
            let slope = |t: f64| -4.0 * (2.0 * t / h - 1.0) / h;
            let (area, norm) = bump([h; 2], [ground, layer].map(Size::of));
            let exact = integral(h, |t| ground * z(t).powi(2) + layer * slope(t).powi(2)).sqrt();
            assert!(exact <= norm.value() * (1.0 + 1e-12) && norm.value() <= exact * (1.0 + 1e-9));
            let exact = integral(h, z);
            assert!(area <= exact && 0.998 * exact <= area, "{area} {exact}");
        }
    }

    #[test]
    fn a_support_at_a_hinge_counts_as_one_position() {
        let clamped = Holds { places: 2, turning: true, ends: [true, true] };
        let alone = |places: usize, ends: [bool; 2]| Holds { places, turning: false, ends };
        // A part whose only support is at its hinge to a clamped part can rotate about this support.
        assert_eq!(first_mechanism(&[clamped, alone(1, [true, false])]), Some(1));
        assert_eq!(first_mechanism(&[alone(1, [false, true]), clamped]), Some(0));
        assert_eq!(first_mechanism(&[clamped, alone(2, [true, false])]), None);
        assert_eq!(first_mechanism(&[clamped, alone(1, [false, true])]), None);
        assert_eq!(first_mechanism(&[clamped, alone(0, [false, false])]), Some(1));
        // A part without supports that is hinged to a restrained part at each end is not a mechanism.
        assert_eq!(first_mechanism(&[clamped, alone(0, [false, false]), clamped]), None);
        assert_eq!(first_mechanism(&[clamped, alone(1, [true, false]), clamped]), None);
        // A beam of one part is a mechanism if only its rotation is prevented, or if it is held at only one position.
        let turning = Holds { places: 0, turning: true, ends: [false; 2] };
        assert_eq!(first_mechanism(&[turning]), Some(0));
        assert_eq!(first_mechanism(&[Holds { places: 1, ..turning }]), None);
        assert_eq!(first_mechanism(&[alone(1, [true, false])]), Some(0));
    }

    /// Calls `of` with a beam of length 1.5 and the claimed deflection w = 2. `text` is the rest of the model file, and
    /// `energy` is the bound of the error energy.
    fn with_beam<T>(
        text: &str,
        touches: bool,
        energy: f64,
        of: impl FnOnce(&Pointwise<Wide>) -> T,
    ) -> T {
        let model = format!("[beam]\nlength = 1.5\nEI = 1\n{text}");
        let piece = json!({"x": [0, 1.5], "half": 0.75, "touches": touches, "deflection": [2]});
        with_fields(&model, &json!({"pieces": [piece]}), |fields| {
            let balanced = balanced(1);
            of(&Pointwise { fields, balanced: &balanced, energy: Size::of(energy) })
        })
    }

    /// Checks `presses` just below and just above the largest permitted error energy. The first tried interval permits
    /// the largest energy. It is half of the middle 90 % of the beam, so h = 0.9 · 0.75.
    #[test]
    fn a_pressure_holds_the_beam_if_the_error_cannot_remove_it() {
        for layer in [0.0, 0.5] {
            let h: f64 = 0.675;
            let norm = (8.0 * h / 15.0 + 16.0 * layer / (3.0 * h)).sqrt();
            let most = 0.5 * (2.0 * 2.0 * h / 3.0 / norm).powi(2);
            let ground = format!("[foundation]\nk = 1\nmu = {layer:?}\n");
            for (energy, touches, expected) in [
                (0.99 * most, true, true),
                (1.01 * most, true, false),
                (0.0, true, true),
                (0.0, false, false),
            ] {
                let found = with_beam(&ground, touches, energy, |pointwise| pointwise.presses(0));
                assert_eq!(found, expected, "{layer} {energy} {touches}");
            }
        }
    }

    /// A beam out of contact that is held at only one point can rotate freely, unless it is under axial tension.
    #[test]
    fn a_beam_under_tension_needs_one_point() {
        let ground = "[foundation]\nk = 1\n";
        for (tension, held, unique) in [
            ("1", 0, false),
            ("1", 1, true),
            ("1", 2, true),
            ("0", 0, false),
            ("0", 1, false),
            ("0", 2, true),
        ] {
            let text = format!("axial_force = {tension}\n{ground}");
            with_beam(&text, false, 0.0, |pointwise| {
                let mut shown = Shown::nothing(2);
                shown.pressed = vec![held > 0, held > 1];
                assert_eq!(pointwise.unique(&shown, &[]).is_ok(), unique, "{tension} {held}");
            });
        }
    }
}
