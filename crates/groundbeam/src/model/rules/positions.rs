//! Rules for positions and stretches: loads and supports lie on the beam, stretches have positive length, no segments overlap.

use super::places;
use crate::model::Model;
use crate::model::problem::{Part, Problem, in_range};

impl Model {
    /// Requires that a position is a finite number between the ends of the beam.
    pub(super) fn check_position(&self, found: &mut Vec<Problem>, part: Part, at: f64) {
        self.check_on_beam(found, part, "at", at);
    }

    pub(super) fn check_on_beam(
        &self,
        found: &mut Vec<Problem>,
        part: Part,
        field: &'static str,
        x: f64,
    ) {
        // If the length is invalid, positions are not checked.
        let length_is_right = in_range(self.beam.length) && self.beam.length > 0.0;
        if length_is_right && !(x >= 0.0 && x <= self.beam.length) {
            let (message, hint) = if x.is_finite() {
                (
                    "{0} lies outside the beam",
                    "the beam extends from 0 to {1}, measured from its left end",
                )
            } else {
                ("the position is not a finite number", "the beam extends from 0 to {1}")
            };
            let problem = Problem::new("GB301", part, field, message, hint);
            found.push(problem.with_numbers(&[x, self.beam.length]));
        }
    }

    pub(super) fn check_stretch(&self, found: &mut Vec<Problem>, part: Part, from: f64, to: f64) {
        self.check_on_beam(found, part, "from", from);
        self.check_on_beam(found, part, "to", to);
        check_order(found, part, from, to);
    }
}

pub(super) fn check_order(found: &mut Vec<Problem>, part: Part, from: f64, to: f64) {
    if from >= to {
        let message = "the stretch from {0} to {1} has no length";
        let hint = "`to` must lie to the right of `from`";
        found.push(Problem::new("GB303", part, "to", message, hint).with_numbers(&[from, to]));
    } else if !(from.is_finite() && to.is_finite()) {
        let field = if from.is_finite() { "to" } else { "from" };
        let message = "an end of the stretch is not a finite number";
        found.push(Problem::new("GB303", part, field, message, "give both ends as numbers"));
    }
}

pub(super) fn overlaps(
    found: &mut Vec<Problem>,
    spans: &[(f64, f64)],
    part: impl Fn(usize) -> Part,
) {
    for (i, j) in places::overlapping(spans) {
        let ((from, to), (other_from, other_to)) = (spans[i], spans[j]);
        let message =
            format!("this segment ({{0}} to {{1}}) overlaps segment {} ({{2}} to {{3}})", j + 1);
        let hint = "segments may touch but not overlap";
        let problem = Problem::new("GB304", part(i), "from", message, hint);
        found.push(problem.with_numbers(&[from, to, other_from, other_to]));
    }
}
