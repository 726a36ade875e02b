//! Numbers of the model: the value of a constant profile, and the checks of sign and range.

use crate::coefficient::Coefficient;
use crate::model::Course;
use crate::refusal::NotProven;
use crate::scalar::Scalar;

/// The value of a constant profile.
pub(crate) fn constant<S: Scalar>(course: &Course<S>) -> Result<S, NotProven> {
    match course {
        Course::Constant(value) => Ok(*value),
        Course::Varying(_) => {
            Err(NotProven::new("a segment of the ground outside the beam has varying constants"))
        }
    }
}

/// Checks that a coefficient is positive everywhere, and within the range of the computation.
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

/// A positive number within the range of the computation.
pub(crate) fn positive<S: Scalar>(x: S, name: &str) -> Result<S, NotProven> {
    if x.low() >= 1e-60 && x.high() <= 1e60 {
        Ok(x)
    } else {
        Err(NotProven::new(format!("{name} is out of range, relative to length and loads")))
    }
}

/// As `positive`, but zero is allowed.
pub(crate) fn not_negative<S: Scalar>(x: S, name: &str) -> Result<S, NotProven> {
    if x == S::zero() { Ok(x) } else { positive(x, name) }
}
