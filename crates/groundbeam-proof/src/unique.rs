//! Uniqueness of the solution. Two solutions have the same u and p. They differ by a rigid motion that
//! vanishes at all supports and wherever p* > 0. It does not rotate an elastic hinge, because both solutions
//! have the same M. The solution is unique if every part between free hinges is held in two positions, or in one
//! position with its rotation prevented.

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
    /// Whether the left and the right end of the part are held positions.
    ends: [bool; 2],
}

impl Holds {
    fn is_enough(self) -> bool {
        self.places + usize::from(self.turning) > 1
    }
}

/// The first part that is a mechanism. A restrained part holds the neighbours at the common hinges; such a hinge
/// counts as one position.
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
    /// Whether the solution is unique. Contact forces count if the contact set proves them, one-way supports if their
    /// reaction exceeds the bound of its error.
    pub fn unique(&self, shown: &Shown, reactions: &[[Size; 2]]) -> Result<(), NotProven> {
        let frame = self.fields.frame;
        if frame.compression.is_some() {
            // The two-way supports alone make the energy of the beam strictly convex.
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

    /// The supports, forces and pressures that hold a part. A support at a hinge holds both parts.
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

    /// Whether p* > 0 is proven in both halves of an interval of a piece: a function z ≥ 0 with p_m∫z > s₂‖z‖_b.
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

/// For z = 1 − (2t/h)² on a length h that lies between two bounds: a lower bound of ∫z = 2h/3, and a bound of ‖z‖_b, ‖z‖_b²
/// = 8kh/15 + 16μ/(3h).
fn bump([low, high]: [f64; 2], [ground, layer]: [Size; 2]) -> (f64, Size) {
    let norm = (8.0 * (ground * Size::of(high))).over(15.0) + (16.0 * layer).over(3.0).over(low);
    ((0.666 * low).next_down(), norm.root())
}

#[cfg(test)]
mod tests {
    use super::{Holds, bump, first_mechanism};
    use crate::size::Size;
    use crate::test_functions::tests::integral;

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
        // The support at the hinge holds both parts; the second one may rotate about it.
        assert_eq!(first_mechanism(&[clamped, alone(1, [true, false])]), Some(1));
        assert_eq!(first_mechanism(&[alone(1, [false, true]), clamped]), Some(0));
        assert_eq!(first_mechanism(&[clamped, alone(2, [true, false])]), None);
        assert_eq!(first_mechanism(&[clamped, alone(1, [false, true])]), None);
        assert_eq!(first_mechanism(&[clamped, alone(0, [false, false])]), Some(1));
        // A part between two restrained parts.
        assert_eq!(first_mechanism(&[clamped, alone(0, [false, false]), clamped]), None);
        assert_eq!(first_mechanism(&[clamped, alone(1, [true, false]), clamped]), None);
        // A prevented rotation without a held position is not sufficient, nor is a held position without a
        // prevented rotation.
        let turning = Holds { places: 0, turning: true, ends: [false; 2] };
        assert_eq!(first_mechanism(&[turning]), Some(0));
        assert_eq!(first_mechanism(&[Holds { places: 1, ..turning }]), None);
        assert_eq!(first_mechanism(&[alone(1, [true, false])]), Some(0));
    }
}
