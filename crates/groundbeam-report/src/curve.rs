//! Computes fields along the beam as a list of points, with both sides of every jump.

use crate::size::Sizes;
use groundbeam::{
    Field, Solution,
    solution::{ByField, Fields, Side},
};

/// Jumps below this size, relative to the largest value of the field, are rounding error.
const JUMP: f64 = 1e-9;

/// Largest magnitude of each field, which distinguishes jumps from rounding errors.
pub(crate) struct Jumps {
    largest: ByField<f64>,
}

impl Jumps {
    pub fn of(solution: &Solution) -> Self {
        let sizes = Sizes::of(solution);
        let ranges = solution.ranges();
        let largest = Field::ALL.map(|field| {
            let range = ranges[field.index()];
            let size = range.min.value.abs().max(range.max.value.abs());
            sizes.value(field, size)
        });
        Jumps { largest }
    }

    /// Returns the fields just to the left and just to the right of a position. The left fields are `None` if
    /// no field jumps at the position.
    pub fn rows(&self, solution: &Solution, x: f64) -> (Option<Fields>, Fields) {
        let right = solution.at(x, Side::Right);
        let inside = x > 0.0 && x < solution.model().beam.length;
        let left = solution.at(x, Side::Left);
        let jumps = inside
            && Field::ALL.iter().zip(self.largest).any(|(&field, largest)| {
                let step = (left.get(field) - right.get(field)).abs();
                step > JUMP * largest && largest > 0.0
            });
        (jumps.then_some(left), right)
    }
}
