//! Numbers of the model: the value of a constant course, and the checks of a sign and a range.

use crate::coefficient::Coefficient;
use crate::model::Course;
use crate::refusal::NotProven;
use crate::scalar::Scalar;

/// The value of a constant course.
pub(crate) fn constant<S: Scalar>(course: &Course<S>) -> Result<S, NotProven> {
    match course {
        Course::Constant(value) => Ok(*value),
        Course::Varying(_) => Err(NotProven::new("ground beside the beam varies along a segment")),
    }
}

/// Checks that a coefficient is positive all along, and neither too small nor too large to compute with.
pub(crate) fn in_range<S: Scalar>(
    coefficient: &Coefficient<S>,
    name: &str,
) -> Result<(), NotProven> {
    if coefficient.low() >= 1e-60 && coefficient.high() <= 1e60 {
        Ok(())
    } else {
        Err(NotProven::new(format!("{name} is out of range, relative to length and loads")))
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
