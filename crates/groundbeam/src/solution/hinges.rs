//! The rotation and the moment of each hinge, from a solution.

use crate::model::Hinge;
use crate::solution::fields::Side;
use crate::solution::solution::Solution;

/// The rotation and the moment of a hinge.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct HingeTurn {
    /// Position \[m\].
    pub at: f64,
    /// The jump of the rotation of the sections, right minus left \[rad\]. It is positive if the parts rotate
    /// as under a hogging moment.
    pub rotation: f64,
    /// The transmitted moment, M = −k_φ·rotation, sagging positive; zero at a free hinge \[N·m\].
    pub moment: f64,
}

impl Solution {
    /// Rotation and moment of the hinges, in the order of the model's hinges.
    pub fn hinges(&self) -> Vec<HingeTurn> {
        let turn = |hinge: &Hinge| {
            let [left, right] =
                [Side::Left, Side::Right].map(|side| self.at(hinge.at, side).rotation);
            let rotation = right - left;
            // Adding zero turns −0 into 0.
            let moment = 0.0 - hinge.rotational_spring * rotation + 0.0;
            HingeTurn { at: hinge.at, rotation, moment }
        };
        self.model().hinges.iter().map(turn).collect()
    }
}
