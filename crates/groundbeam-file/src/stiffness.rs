//! Reads a stiffness from one number, such as EI, or as the product of two factors, such as E and I.
//!
//! A segment inherits missing factors from the whole beam or ground.

use crate::code;
use crate::fault::Fault;
use crate::profile::Along;
use crate::reader::{Field, Reader};
use crate::table::Section;

/// Keys for a stiffness and for its two factors.
pub(crate) struct Keys {
    pub product: &'static str,
    pub factors: [&'static str; 2],
    /// End of an error message that names a replacement of the second factor, such as " or a `section`"; may be empty.
    pub instead: &'static str,
}

/// A stiffness, such as EI, and its two factors, such as E and I, as one table of the file gives them.
#[derive(Debug, Clone, Default)]
pub(crate) struct Given {
    pub product: Option<Along>,
    pub factors: [Option<Along>; 2],
}

/// Stiffness that follows from a table and its parent table.
pub(crate) enum Stiffness {
    Known(Along),
    /// The table has no data for this stiffness.
    NotGiven,
    /// Only one of the two factors is known. The variant contains the index of this factor (0 or 1) and its
    /// value.
    Half(usize, Along),
}

impl Given {
    /// Returns the stiffness data on a part of the stretch. `way` contains the start and the end of the part as
    /// fractions of the length of the stretch.
    pub fn between(&self, way: [f64; 2]) -> Self {
        let part = |given: &Option<Along>| given.as_ref().map(|given| given.between(way));
        Given { product: part(&self.product), factors: [0, 1].map(|i| part(&self.factors[i])) }
    }

    /// Computes the stiffness that the table gives directly or as a product of two factors, such as E·I. A factor that
    /// the table does not give is taken from `parent`.
    pub fn resolve(&self, reader: &mut Reader, parent: &Given, keys: &Keys) -> Stiffness {
        let own = self.factors.iter().position(|factor| factor.is_some());
        if let Some(product) = &self.product {
            if let Some((i, factor)) = own.and_then(|i| Some((i, self.factors[i].as_ref()?))) {
                let (name, [a, b]) = (keys.product, keys.factors);
                let hint = format!("give `{name}`, or `{a}` and `{b}`{}", keys.instead);
                reader.exclusive((name, &product.span), (keys.factors[i], &factor.span), &hint);
            }
            return Stiffness::Known(product.clone());
        }
        let Some(own) = own else { return Stiffness::NotGiven };
        let factor = |i: usize| self.factors[i].as_ref().or(parent.factors[i].as_ref());
        match (factor(0), factor(1)) {
            (Some(a), Some(b)) => {
                let place = self.factors[own].as_ref().unwrap_or(a);
                Stiffness::Known(a.times(b, &place.span))
            }
            (Some(a), None) => Stiffness::Half(0, a.clone()),
            (None, Some(b)) => Stiffness::Half(1, b.clone()),
            (None, None) => Stiffness::NotGiven,
        }
    }
}

impl Reader<'_> {
    /// Returns the value of a required stiffness. A missing stiffness or a missing factor is reported.
    pub fn settle(&mut self, stiffness: Stiffness, section: &Section, keys: &Keys) -> Along {
        match stiffness {
            Stiffness::Known(known) => return known,
            Stiffness::NotGiven => {
                let (name, [a, b]) = (keys.product, keys.factors);
                let [product, first, second] = [name, a, b].map(|key| self.line(section.keys, key));
                let example = format!("{product}; or {first} and {second}{}", keys.instead);
                self.missing(section, &[name, a, b], &format!("`{name}`"), &example);
            }
            Stiffness::Half(given, half) => {
                let [name, other] = [given, 1 - given].map(|i| keys.factors[i]);
                let message = format!("`{name}` is given without `{other}`");
                let instead = if given == 0 { keys.instead } else { "" };
                let hint = format!("add {}{instead}", self.line(section.keys, other));
                self.report(Fault::new(code::INCOMPLETE, half.span, message, "", hint));
            }
        }
        Along::unreadable(section.span.clone())
    }

    /// Reports a factor that is not positive. Without this check, the product of two negative factors would be
    /// accepted.
    pub fn positive(&mut self, key: &str, factor: Field) -> Field {
        if factor.value <= 0.0 {
            let state = if factor.value == 0.0 { "zero" } else { "negative" };
            let message = format!("`{key}` is {state}");
            let span = factor.span.clone();
            self.report(Fault::new(code::FACTOR, span, message, "", "it must be positive"));
            return Field::unreadable(factor.span);
        }
        factor
    }
}

/// Whether the stretches cover the interval from 0 to `length`. Also true if an end is unreadable (reported before).
pub(crate) fn cover(length: f64, stretches: impl Iterator<Item = (f64, f64)>) -> bool {
    let mut stretches: Vec<(f64, f64)> = stretches.collect();
    let unknown = |&(from, to): &(f64, f64)| from.is_nan() || to.is_nan();
    if stretches.iter().any(unknown) || (length.is_nan() && !stretches.is_empty()) {
        return true;
    }
    stretches.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut reached = 0.0;
    for (from, to) in stretches {
        if from > reached {
            return false;
        }
        reached = to.max(reached);
    }
    reached > 0.0 && reached >= length
}

#[cfg(test)]
mod tests {
    use super::cover;

    #[test]
    fn adjoining_stretches_cover_the_beam() {
        let cover = |stretches: &[(f64, f64)]| cover(10.0, stretches.iter().copied());
        assert!(cover(&[(0.0, 10.0)]));
        assert!(cover(&[(4.0, 12.0), (-1.0, 4.0)]));
        assert!(cover(&[(f64::NAN, 1.0)]));
        assert!(!cover(&[]));
        assert!(!cover(&[(0.0, 4.0), (5.0, 10.0)]));
        assert!(!cover(&[(1.0, 10.0)]));
        assert!(!cover(&[(0.0, 9.0)]));
    }
}
