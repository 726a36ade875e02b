//! The rotation and the moment of each hinge, from a solution.

use crate::model::Hinge;
use crate::solution::fields::Side;
use crate::solution::solution::Solution;

/// The rotation and the moment of a hinge.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct HingeTurn {
    /// Position of the hinge \[m\].
    pub at: f64,
    /// The jump of the rotation of the cross-sections at the hinge, right minus left \[rad\]. It is positive if
    /// the parts of the beam rotate as under a hogging moment.
    pub rotation: f64,
    /// The moment that the hinge transmits, positive in sagging \[N·m\]: minus its rotational stiffness times its
    /// rotation.
    pub moment: f64,
}

impl Solution {
    /// The rotations and the moments of all hinges, in the order of the model's hinges.
    pub fn hinges(&self) -> Vec<HingeTurn> {
        let turn = |hinge: &Hinge| {
            let [left, right] =
                [Side::Left, Side::Right].map(|side| self.at(hinge.at, side).rotation);
            let rotation = right - left;
            // Adding zero changes −0 to 0.
            let moment = 0.0 - hinge.rotational_spring * rotation + 0.0;
            HingeTurn { at: hinge.at, rotation, moment }
        };
        self.model().hinges.iter().map(turn).collect()
    }
}
