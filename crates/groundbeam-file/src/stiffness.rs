//! Reads a stiffness, given as one number or as a product of two: EI or E and I, k or `subgrade_modulus` and
//! `width`. A segment inherits missing factors from its parent.

use crate::code;
use crate::fault::Fault;
use crate::profile::Along;
use crate::reader::{Field, Reader};
use crate::table::Section;

/// Keys of a stiffness and its factors.
pub(crate) struct Keys {
    pub product: &'static str,
    pub factors: [&'static str; 2],
    /// Text that names another way to give the second factor, such as " or …"; may be empty.
    pub instead: &'static str,
}

/// Stiffness data of one table.
#[derive(Debug, Clone, Default)]
pub(crate) struct Given {
    pub product: Option<Along>,
    pub factors: [Option<Along>; 2],
}

/// Result of combining a table with its parent.
pub(crate) enum Stiffness {
    Known(Along),
    /// The table has no data for this stiffness.
    NotGiven,
    /// Only the first (0) or the second (1) factor is known.
    Half(usize, Along),
}

impl Given {
    /// The data for a part of the stretch.
    pub fn between(&self, way: [f64; 2]) -> Self {
        let part = |given: &Option<Along>| given.as_ref().map(|given| given.between(way));
        Given { product: part(&self.product), factors: [0, 1].map(|i| part(&self.factors[i])) }
    }

    /// The stiffness of a table. Missing factors come from `parent`.
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
    /// The value of a required stiffness. Missing values are reported.
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

    /// Each factor must be positive: the product of two negative ones would be accepted.
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

/// Whether the stretches cover 0 to `length`. Unreadable stretches count as covering, because their fault has
/// been reported.
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
