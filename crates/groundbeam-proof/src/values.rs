//! Numbers of the model: the value of a constant profile, and the checks of sign and range.

use crate::coefficient::Coefficient;
use crate::model::Course;
use crate::refusal::NotProven;
use crate::scalar::Scalar;

/// Returns the value of a constant profile, and an error for a varying profile.
pub(crate) fn constant<S: Scalar>(course: &Course<S>) -> Result<S, NotProven> {
    match course {
        Course::Constant(value) => Ok(*value),
        Course::Varying(_) => {
            Err(NotProven::new("k or mu varies in a segment of the ground outside the beam"))
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

/// Returns the number if it is positive and within the range of the computation.
pub(crate) fn positive<S: Scalar>(x: S, name: &str) -> Result<S, NotProven> {
    if x.low() >= 1e-60 && x.high() <= 1e60 {
        Ok(x)
    } else {
        Err(NotProven::new(format!("{name} is out of range, relative to length and loads")))
    }
}

/// Returns the number if it is zero, or if it is positive and within the range of the computation.
pub(crate) fn not_negative<S: Scalar>(x: S, name: &str) -> Result<S, NotProven> {
    if x == S::zero() { Ok(x) } else { positive(x, name) }
}
