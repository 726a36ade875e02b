//! The answer of beam and ground to a parameter, forward.

use super::change::Change;
use super::linearised::Linearised;
use super::{NotDifferentiable, Output, Solution};

impl Solution {
    pub(super) fn forward(
        &self,
        _lin: &Linearised,
        _outputs: &[Output],
        _changes: &[Change],
    ) -> Result<Vec<Vec<f64>>, NotDifferentiable> {
        Err(NotDifferentiable::NoSuchOutput)
    }
}
