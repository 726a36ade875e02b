//! Numbers of the model: the value of a constant course, and the checks of a sign and a range.

use crate::model::Course;
use crate::refusal::NotProven;
use crate::scalar::Scalar;

/// The value of a covered course.
pub(crate) fn constant<S: Scalar>(course: &Course<S>) -> S {
    match course {
        Course::Constant(value) => *value,
        // Refused before: a kind that is not covered.
        Course::Varying(values) => values.first().copied().unwrap_or_else(S::zero),
    }
}

/// A number that is positive and neither too small nor too large to compute with.
pub(crate) fn positive<S: Scalar>(x: S, name: &str) -> Result<S, NotProven> {
    if x.low() >= 1e-60 && x.high() <= 1e60 {
        Ok(x)
    } else {
        Err(NotProven::new(format!("{name} is out of range, relative to length and loads")))
    }
}

/// The same, or exactly zero.
pub(crate) fn not_negative<S: Scalar>(x: S, name: &str) -> Result<S, NotProven> {
    if x == S::zero() { Ok(x) } else { positive(x, name) }
}
