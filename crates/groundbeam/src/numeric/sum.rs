//! Compensated sums, and sizes of values, which distinguish values from rounding error.

use crate::numeric::tolerance::SUM_ROUNDING;

/// A compensated sum, and the sum of the absolute values of its terms. The second sum decides whether the first
/// sum is rounding error.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sum {
    pub sum: f64,
    compensation: f64,
    /// The sum of the absolute values of all terms.
    pub size: f64,
}

impl Sum {
    pub fn add(&mut self, term: f64) {
        // With Neumaier's summation, the sum is accurate to one or two units in the last place.
        let sum = self.sum + term;
        self.compensation += if self.sum.abs() >= term.abs() {
            (self.sum - sum) + term
        } else {
            (term - sum) + self.sum
        };
        self.sum = sum;
        self.size += term.abs();
    }

    pub fn finished(mut self) -> Self {
        self.sum += self.compensation;
        self.compensation = 0.0;
        if self.is_zero() {
            self.sum = 0.0;
        }
        self
    }

    pub fn plus(self, other: Sum) -> Sum {
        Sum { sum: self.sum + other.sum, compensation: 0.0, size: self.size + other.size }
    }

    pub fn is_zero(&self) -> bool {
        self.sum.abs() <= SUM_ROUNDING * self.size
    }

    pub fn is_negative(&self) -> bool {
        self.sum < 0.0 && !self.is_zero()
    }
}

/// A value, and a size to which its rounding error is at most proportional.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Rounded {
    pub value: f64,
    pub size: f64,
}

impl Rounded {
    pub fn add(&mut self, term: f64) {
        self.value += term;
        self.size += term.abs();
    }

    /// Returns this value, or `other` if its size is smaller. If this size is zero, `other` is not computed.
    pub fn or_if_smaller(self, other: impl FnOnce() -> Rounded) -> f64 {
        if self.size == 0.0 {
            return self.value;
        }
        let other = other();
        if other.size < self.size { other.value } else { self.value }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sum(terms: &[f64]) -> Sum {
        let mut sum = Sum::default();
        terms.iter().for_each(|term| sum.add(*term));
        sum.finished()
    }

    /// Neumaier's summation keeps small terms that plain summation loses. Plain summation would lose every term of
    /// 0.01 · 2⁻⁵² that is added to 1.
    #[test]
    fn sums_are_exact_to_the_last_bit() {
        let small = 0.01 * f64::EPSILON;
        let many = vec![small; 400];
        let exact = 1.0 + 4.0 * f64::EPSILON;
        let first = [vec![1.0], many.clone()].concat();
        let last = [many, vec![1.0]].concat();
        for sign in [1.0, -1.0] {
            let signed = |terms: &[f64]| terms.iter().map(|term| sign * term).collect::<Vec<_>>();
            assert_eq!(sum(&signed(&first)).sum, sign * exact);
            assert_eq!(sum(&signed(&last)).sum, sign * exact);
        }
        assert_eq!(sum(&[3.0, -4.0]).size, 7.0);
    }

    /// A sum below 8 · 2⁻⁵² times the sum of the absolute values of its terms is rounding error and becomes 0.
    #[test]
    fn sums_within_rounding_error_become_zero() {
        let eps = f64::EPSILON;
        let of = |sum: f64| Sum { sum, compensation: 0.0, size: 2.0 };
        for (value, zero) in [(16.0 * eps, true), (17.0 * eps, false), (0.0, true), (1.0, false)] {
            assert_eq!(of(value).is_zero(), zero);
            assert_eq!(of(-value).is_zero(), zero);
            assert_eq!(of(-value).is_negative(), !zero);
            assert!(!of(value).is_negative());
            assert_eq!(of(value).finished().sum, if zero { 0.0 } else { value });
        }
        assert!(Sum::default().is_zero());
        let both = of(3.0).plus(Sum { sum: -5.0, compensation: 0.0, size: 5.0 });
        assert_eq!((both.sum, both.size), (-2.0, 7.0));
    }
}
