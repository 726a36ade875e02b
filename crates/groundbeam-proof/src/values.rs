//! Reads the value of a constant profile, and checks the sign and range of the numbers of a model.

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

/// Checks that a coefficient lies between 10⁻⁶⁰ and 10⁶⁰ everywhere.
pub(crate) fn in_range<S: Scalar>(
    coefficient: &Coefficient<S>,
    name: &str,
) -> Result<(), NotProven> {
    if coefficient.low() >= 1e-60 && coefficient.high() <= 1e60 {
        Ok(())
    } else {
        Err(NotProven::new(format!(
            "{name} is out of range: in units of the beam's length and the largest load, it must lie between 1e-60 and 1e60"
        )))
    }
}

/// Returns the number if it lies between 10⁻⁶⁰ and 10⁶⁰.
pub(crate) fn positive<S: Scalar>(x: S, name: &str) -> Result<S, NotProven> {
    if x.low() >= 1e-60 && x.high() <= 1e60 {
        Ok(x)
    } else {
        Err(NotProven::new(format!(
            "{name} is out of range: in units of the beam's length and the largest load, it must lie between 1e-60 and 1e60"
        )))
    }
}

/// Returns the number if it is zero or lies between 10⁻⁶⁰ and 10⁶⁰.
pub(crate) fn not_negative<S: Scalar>(x: S, name: &str) -> Result<S, NotProven> {
    if x == S::zero() { Ok(x) } else { positive(x, name) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wide::Wide;

    #[test]
    fn numbers_out_of_range_are_refused() {
        let is_accepted = |x: Wide, inside: bool| {
            assert_eq!(in_range(&Coefficient::Even(x), "k").is_ok(), inside, "{x:?}");
            assert_eq!(positive(x, "k").is_ok(), inside, "{x:?}");
            assert_eq!(not_negative(x, "k").is_ok(), inside || x == Wide::zero(), "{x:?}");
        };
        for (exact, inside) in [
            (1.1e-60, true),
            (1.0, true),
            (0.9e60, true),
            (0.9e-60, false),
            (1.1e60, false),
            (0.0, false),
            (-1.0, false),
            (f64::INFINITY, false),
        ] {
            is_accepted(Wide::of(exact), inside);
        }
        is_accepted(Wide::of(1.0).widened(0.5), true);
        is_accepted(Wide::of(1.0).widened(2.0), false);
        is_accepted(Wide::of(0.8e60).widened(0.3e60), false);
    }
}
