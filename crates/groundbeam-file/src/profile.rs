//! Reads a quantity that may vary along the beam: one value, or a list of values from left to right.
//!
//! Two values define a linear variation. More values are the Bernstein coefficients of a polynomial ([`Profile`]).

use crate::code;
use crate::fault::Fault;
use crate::keys::Value;
use crate::reader::{Field, Reader};
use crate::table::Section;
use groundbeam::model::Profile;
use std::ops::Range;
use toml::de::DeValue;

/// A quantity along a stretch, and its location in the file.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Along {
    pub profile: Profile,
    pub span: Range<usize>,
}

impl Along {
    /// Placeholder for a quantity that is missing or cannot be read.
    pub fn unreadable(span: Range<usize>) -> Self {
        Along { profile: Profile::constant(f64::NAN), span }
    }

    pub fn is_readable(&self) -> bool {
        !self.profile.control_values().iter().any(|value| value.is_nan())
    }

    /// Returns the first value of the list, with the place of the list in the file; NaN if the list could not be
    /// read.
    pub fn field(&self) -> Field {
        let value = if self.is_readable() { self.profile.start() } else { f64::NAN };
        Field::new(value, self.span.clone())
    }

    /// Returns the quantity on the part of its stretch between two fractions of the stretch's length.
    pub fn between(&self, [from, to]: [f64; 2]) -> Self {
        Along { profile: self.profile.part(from, to), span: self.span.clone() }
    }

    /// Returns the product of two quantities. Messages about the product refer to the place `span` in the file.
    pub fn times(&self, other: &Along, span: &Range<usize>) -> Self {
        // The file format limits the degree of each factor so that the product has at most `Profile::MOST`
        // coefficients. Therefore, the value NaN below is never used.
        let profile = self.profile.times(&other.profile);
        Along { profile: profile.unwrap_or(Profile::constant(f64::NAN)), span: span.clone() }
    }
}

impl Reader<'_> {
    /// Reads the quantity under `key` in `section`, if given: one value, or a list of values.
    pub fn along(&mut self, section: &Section, key: &str) -> Option<Along> {
        let Value::Along(kind, most) = section.key(key).value else { return None };
        let value = section.value(key)?;
        let DeValue::Array(array) = value.get_ref() else {
            let Field { value, span } = self.field(key, value, kind);
            return Some(Along { profile: Profile::constant(value), span });
        };
        if !(2..=most).contains(&array.len()) {
            let (count, noun) = match array.len() {
                1 => (1, "value"),
                count => (count, "values"),
            };
            let curve = match (most, key) {
                (2, _) => String::new(),
                // The subgrade modulus k and the shear constant μ may vary at most quadratically, so at most three values are
                // allowed (diagnostic GB204).
                (_, "k" | "mu") => ", or three control values of a Bézier curve".to_owned(),
                _ => format!(", or up to {most} control values of a Bézier curve"),
            };
            let hint = format!(
                "give one value, or two for a quantity that varies linearly from one end to the \
                 other{curve}"
            );
            let message = format!("`{key}` has {count} {noun}");
            self.report(Fault::new(code::WRONG_TYPE, value.span(), message, "", hint));
            return Some(Along::unreadable(value.span()));
        }
        let read = |element| self.field(key, element, kind).value;
        let numbers: Vec<f64> = array.iter().map(read).collect();
        let profile = Profile::by_control_values(&numbers);
        Some(Along { profile: profile.unwrap_or(Profile::constant(f64::NAN)), span: value.span() })
    }

    /// Reports an error if the factor of a stiffness, such as E in EI, is not positive. Without this check,
    /// the product of two negative factors would be accepted.
    pub fn positive_along(&mut self, key: &str, factor: Along) -> Along {
        let wrong = factor.profile.control_values().iter().find(|value| **value <= 0.0);
        let Some(&value) = wrong else { return factor };
        self.positive(key, Field::new(value, factor.span.clone()));
        Along::unreadable(factor.span)
    }
}

/// Returns the parts of the interval from 0 to `length` that the stretches do not cover, from left to
/// right. The list is empty if a stretch is unreadable.
pub(crate) fn left_out(length: f64, stretches: impl Iterator<Item = (f64, f64)>) -> Vec<[f64; 2]> {
    let mut stretches: Vec<(f64, f64)> = stretches.collect();
    let unknown = |&(from, to): &(f64, f64)| from.is_nan() || to.is_nan();
    if length.is_nan() || stretches.iter().any(unknown) {
        return Vec::new();
    }
    stretches.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut rest = Vec::new();
    let mut reached = 0.0;
    for (from, to) in stretches {
        if from.min(length) > reached {
            rest.push([reached, from.min(length)]);
        }
        reached = to.max(reached);
    }
    if length > reached {
        rest.push([reached, length]);
    }
    rest
}

#[cfg(test)]
mod tests {
    use super::left_out;

    #[test]
    fn parts_outside_the_segments() {
        let rest = |stretches: &[(f64, f64)]| left_out(10.0, stretches.iter().copied());
        assert_eq!(rest(&[]), [[0.0, 10.0]]);
        assert_eq!(rest(&[(4.0, 12.0), (-1.0, 2.0)]), [[2.0, 4.0]]);
        assert_eq!(rest(&[(3.0, 5.0), (5.0, 6.0)]), [[0.0, 3.0], [6.0, 10.0]]);
        assert!(rest(&[(0.0, 10.0)]).is_empty());
        assert!(rest(&[(f64::NAN, 10.0)]).is_empty());
    }
}
