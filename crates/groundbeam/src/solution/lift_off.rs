//! Open parts of the beam: free spans, and ends that have lifted off.

use crate::solution::field::Field;
use crate::solution::fields::Extreme;
use crate::solution::solution::Solution;

/// An open part of the beam: a free span, or an end that has lifted off.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LiftOff {
    /// Left end of the open part \[m\].
    pub from: f64,
    /// Right end of the open part \[m\].
    pub to: f64,
    /// The largest distance between beam and ground, and its position.
    pub largest_gap: Extreme,
    /// Whether the open part reaches the left end of the beam, and whether it reaches the right end of the
    /// beam.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub reaches: [bool; 2],
}

impl LiftOff {
    /// The length of the open part of the beam \[m\].
    pub fn length(&self) -> f64 {
        self.to - self.from
    }
}

impl Solution {
    /// The parts of the beam that are out of contact, with their largest gaps, from left to right.
    pub fn lift_off(&self) -> Vec<LiftOff> {
        let mut found: Vec<LiftOff> = Vec::new();
        // With nodal contact there are narrow gaps between neighbouring nodes. Gaps within a contact zone do
        // not count as lift-off.
        let inside = |x: [f64; 2]| self.contact().iter().any(|c| c.from <= x[0] && x[1] <= c.to);
        for piece in self.pieces() {
            if piece.open.is_none() || inside(piece.x) {
                continue;
            }
            let mut largest = Extreme { x: piece.x[0], value: f64::NEG_INFINITY };
            for s in piece.candidates(Field::Gap) {
                let here = piece.fields(s).gap;
                if here > largest.value {
                    largest = Extreme { x: piece.global(s), value: here };
                }
            }
            let [from, to] = piece.x;
            let parted = self.contact().iter().any(|c| c.from == c.to && c.from == from);
            match found.last_mut() {
                Some(last) if last.to == from && !parted => {
                    last.to = to;
                    if largest.value > last.largest_gap.value {
                        last.largest_gap = largest;
                    }
                }
                _ => {
                    found.push(LiftOff { from, to, largest_gap: largest, reaches: [false; 2] });
                }
            }
        }
        for open in &mut found {
            open.reaches = [open.from <= 0.0, open.to >= self.model().beam.length];
        }
        found
    }

    /// The fraction of the beam's length that is not in contact.
    pub fn lifted_share(&self) -> f64 {
        let lifted: f64 = self.lift_off().iter().map(LiftOff::length).sum();
        lifted / self.model().beam.length
    }
}
