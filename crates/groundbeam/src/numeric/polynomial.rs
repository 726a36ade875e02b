//! Polynomials on one stretch of the beam, in the local coordinate s ∈ \[−1, 1\].
//!
//! A polynomial is a slice of its coefficients, starting with the constant term. Derivatives are computed from the
//! coefficients, never from differences.

use crate::numeric::real::Real;
use std::ops::{Deref, DerefMut};

/// Number of coefficients of the power series of deflection and rotation. In exact elements, the first omitted term is
/// less than 1/20! of the sum. See *Exact elements* in docs/methods.md.
pub(crate) const TERMS: usize = 20;

/// Maximum number of coefficients of a polynomial. The product of a rotation and a fifth-degree shear stiffness has
/// this number of coefficients.
pub(crate) const MOST_COEFFICIENTS: usize = 25;

/// Coefficients of a polynomial in an array of fixed size, so that polynomials need no heap memory.
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Coefficients<R = f64> {
    count: usize,
    held: [R; MOST_COEFFICIENTS],
}

impl<R: Real> Default for Coefficients<R> {
    fn default() -> Self {
        Self::zeros(0)
    }
}

impl<R: Real> Coefficients<R> {
    pub fn zeros(count: usize) -> Self {
        debug_assert!(count <= MOST_COEFFICIENTS);
        Coefficients { count: count.min(MOST_COEFFICIENTS), held: [R::ZERO; MOST_COEFFICIENTS] }
    }

    /// Returns the same polynomial with at least `count` coefficients, padded with zeros.
    pub fn at_least(mut self, count: usize) -> Self {
        debug_assert!(count <= MOST_COEFFICIENTS);
        self.count = self.count.max(count.min(MOST_COEFFICIENTS));
        self
    }

    /// Returns the same polynomial without the zero coefficients of its highest powers.
    pub fn without_zeros(mut self) -> Self {
        self.count = trimmed(&self).len();
        self
    }

    /// Removes and returns the coefficient of the highest power.
    pub fn pop(&mut self) -> Option<R> {
        self.count = self.count.checked_sub(1)?;
        Some(std::mem::take(&mut self.held[self.count]))
    }
}

impl<R> Deref for Coefficients<R> {
    type Target = [R];

    fn deref(&self) -> &[R] {
        &self.held[..self.count]
    }
}

impl<R> DerefMut for Coefficients<R> {
    fn deref_mut(&mut self) -> &mut [R] {
        &mut self.held[..self.count]
    }
}

impl<R: Real> From<&[R]> for Coefficients<R> {
    fn from(c: &[R]) -> Self {
        let mut all = Self::zeros(c.len());
        let count = all.count;
        all.copy_from_slice(&c[..count]);
        all
    }
}

impl<R: Real> FromIterator<R> for Coefficients<R> {
    fn from_iter<T: IntoIterator<Item = R>>(c: T) -> Self {
        let mut all = Self::default();
        for c in c {
            debug_assert!(all.count < MOST_COEFFICIENTS);
            if let Some(next) = all.held.get_mut(all.count) {
                *next = c;
                all.count += 1;
            }
        }
        all
    }
}

impl<R: std::fmt::Debug> std::fmt::Debug for Coefficients<R> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

/// Returns the values of dual numbers, without their derivatives.
pub(crate) fn values<R: Real>(c: &[R]) -> Coefficients {
    c.iter().map(|c| c.value()).collect()
}

/// Returns the coefficients without the zeros of the highest powers.
pub(crate) fn trimmed<R: Real>(c: &[R]) -> &[R] {
    &c[..c.iter().rposition(|c| *c != R::ZERO).map_or(0, |last| last + 1)]
}

/// Value of a polynomial f(s).
pub(crate) fn value<R: Real>(c: &[R], s: f64) -> R {
    c.iter().rev().fold(R::ZERO, |sum, &a| sum * s + a)
}

/// Values of a polynomial f(s) at N points. They are bitwise equal to those of [`value`].
pub(crate) fn values_at<R: Real, const N: usize>(c: &[R], points: &[f64; N]) -> [R; N] {
    let mut values = [R::ZERO; N];
    for a in c.iter().rev() {
        for (value, s) in values.iter_mut().zip(points) {
            *value = *value * *s + *a;
        }
    }
    values
}

/// Values of a polynomial f(s) and of its derivative f'(s) with respect to s.
pub(crate) fn with_slope<R: Real>(c: &[R], s: f64) -> [R; 2] {
    c.iter().rev().fold([R::ZERO; 2], |[f, d1], &a| [f * s + a, d1 * s + f])
}

/// Values of a polynomial f(s) and of its first three derivatives with respect to s.
pub(crate) fn jet<R: Real>(c: &[R], s: f64) -> [R; 4] {
    let [mut f, mut d1, mut d2, mut d3] = [R::ZERO; 4];
    // The deflection of cells out of contact has few nonzero coefficients, so zero coefficients of high order
    // are skipped.
    for &a in c.iter().rev().skip_while(|&&a| a == 0.0) {
        d3 = d3 * s + d2;
        d2 = d2 * s + d1;
        d1 = d1 * s + f;
        f = f * s + a;
    }
    [f, d1, d2 * 2.0, d3 * 6.0]
}

/// Values f(−1) and f(1) of a polynomial.
pub(crate) fn ends<R: Real>(c: &[R]) -> [R; 2] {
    let [mut even, mut odd] = [R::ZERO; 2];
    for powers in c.chunks(2).rev() {
        even += powers[0];
        odd += powers.get(1).copied().unwrap_or(R::ZERO);
    }
    [even - odd, even + odd]
}

/// Coefficients of the derivative df/ds of the polynomial f(s) with the coefficients `c`.
pub(crate) fn derivative<R: Real>(c: &[R]) -> Coefficients<R> {
    let mut out = Coefficients::zeros(c.len().saturating_sub(1));
    for (j, (out, a)) in out.iter_mut().zip(c.iter().skip(1)).enumerate() {
        *out = *a * (j + 1) as f64;
    }
    out
}

/// Coefficients of the integral of a polynomial on a stretch of half length `half`. Its value at the left end is
/// `start`.
pub(crate) fn integral(c: &[f64], half: f64, start: f64) -> Coefficients {
    let mut out = Coefficients::zeros(c.len() + 1);
    for ((out, a), part) in out.iter_mut().skip(1).zip(c).zip(&PARTS) {
        *out = half * a * part;
    }
    out[0] = start - ends(&out)[0];
    out
}

/// Factors 1/(j + 1) in the integrals s^(j+1)/(j + 1) of the powers sʲ, for j = 0, 1, …
const PARTS: [f64; MOST_COEFFICIENTS] = {
    let mut all = [0.0; MOST_COEFFICIENTS];
    let mut j = 0;
    while j < MOST_COEFFICIENTS {
        all[j] = 1.0 / (j + 1) as f64;
        j += 1;
    }
    all
};

/// Coefficients of the quotient f(s)/(s − r) without the remainder, by synthetic division.
pub(crate) fn divided(c: &[f64], r: f64) -> Coefficients {
    let mut quotient = Coefficients::zeros(c.len().saturating_sub(1));
    let mut sum = 0.0;
    for (to, c) in quotient.iter_mut().zip(c.iter().skip(1)).rev() {
        sum = c + r * sum;
        *to = sum;
    }
    quotient
}

/// Coefficients of the polynomial f(middle + half·t) in t ∈ \[−1, 1\].
pub(crate) fn rescale<R: Real>(c: &[R], middle: f64, half: f64) -> Coefficients<R> {
    let mut c = Coefficients::from(c);
    rescale_in_place(&mut c, middle, half);
    c
}

/// Replaces the coefficients of a polynomial as [`rescale`] does.
pub(crate) fn rescale_in_place<R: Real>(c: &mut [R], middle: f64, half: f64) {
    // Repeated synthetic division by (s − middle) gives the coefficients about `middle`. Powers of `half` then
    // scale them.
    for first in 0..c.len() {
        for j in (first..c.len().saturating_sub(1)).rev() {
            let next = c[j + 1] * middle;
            c[j] += next;
        }
    }
    let mut power = 1.0;
    for a in c.iter_mut() {
        *a *= power;
        power *= half;
    }
}

/// Coefficients of the product f·g.
pub(crate) fn product<R: Real>(f: &[R], g: &[R]) -> Coefficients<R> {
    let mut out = Coefficients::zeros((f.len() + g.len()).saturating_sub(1));
    for (i, a) in f.iter().enumerate().filter(|(_, a)| **a != 0.0) {
        for (j, b) in g.iter().enumerate() {
            out[i + j] += *a * *b;
        }
    }
    out
}

/// Integral ∫ f⁽ⁿ⁾ g⁽ⁿ⁾ ds over \[−1, 1\] of the derivatives of order n = `order`.
pub(crate) fn inner<R: Real>(f: &[R], g: &[R], order: usize) -> R {
    if order > 0 {
        return inner(&derivative(f), &derivative(g), order - 1);
    }
    debug_assert!(f.len().max(g.len()) <= MOST_COEFFICIENTS);
    // The integral ∫ s^(i+j) ds over [−1, 1] is 2/(i+j+1) for even i + j and zero for odd i + j. Loops of constant
    // length let the compiler use vector instructions.
    let of_parity = |first: usize| {
        let [f, g] = [f, g].map(|c| c.iter().skip(first).step_by(2));
        let mut moments = [R::ZERO; HALF];
        for (i, a) in f.enumerate() {
            for (moment, power) in moments.iter_mut().zip(&POWERS[i + first..][..HALF]) {
                *moment += *a * *power;
            }
        }
        g.zip(moments).map(|(b, moment)| *b * moment).sum::<R>()
    };
    of_parity(0) + of_parity(1)
}

/// Maximum number of even powers in a polynomial. It has at most as many odd powers.
const HALF: usize = MOST_COEFFICIENTS.div_ceil(2);

/// Integrals ∫ s^(2n) ds over \[−1, 1\] for n = 0, 1, …
const POWERS: [f64; 2 * HALF] = {
    let mut all = [0.0; 2 * HALF];
    let mut n = 0;
    while n < all.len() {
        all[n] = 2.0 / (2 * n + 1) as f64;
        n += 1;
    }
    all
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn jet_of_a_cubic() {
        // The values of f = 1 + 2s + 3s² + 4s³ and of its derivatives at s = ½ are computed by hand.
        assert_eq!(jet(&[1.0, 2.0, 3.0, 4.0], 0.5), [3.25, 8.0, 18.0, 24.0]);
    }

    #[test]
    fn values_at_many_points_are_those_at_each_point() {
        let c = [0.5, -0.75, 0.25, 1.5, -1.0];
        let points = [-1.0, -0.3, 0.0, 0.7];
        assert_eq!(values_at(&c, &points), points.map(|s| value(&c, s)));
        assert_eq!(ends(&c), [-1.0, 1.0].map(|s| value(&c, s)));
    }

    #[test]
    fn a_quotient_times_its_divisor_is_the_polynomial() {
        // The product (s + 1)(2 − s + 3s²) = 2 + s + 2s² + 3s³ is computed by hand.
        assert_eq!(*divided(&[2.0, 1.0, 2.0, 3.0], -1.0), [2.0, -1.0, 3.0]);
    }

    #[test]
    fn rescaling_is_substitution() {
        let c = [1.0, -2.0, 0.5, 3.0, -1.0];
        let r = rescale(&c, 0.3, 0.2);
        for t in [-1.0, -0.25, 0.0, 0.7, 1.0] {
            assert!((value(&r, t) - value(&c, 0.3 + 0.2 * t)).abs() < 1e-14);
        }
    }
}
