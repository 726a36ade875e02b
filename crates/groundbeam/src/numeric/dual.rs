//! Dual numbers: a value with its first derivatives with respect to N parameters.

use crate::numeric::real::Real;
use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// A value with its first derivatives with respect to N parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Dual<const N: usize> {
    pub value: f64,
    pub by: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// Applies a function to this number by the chain rule. `value` and `slope` are the value and the
    /// derivative of the function.
    #[inline]
    fn chain(self, value: f64, slope: f64) -> Self {
        Dual { value, by: self.by.map(|by| slope * by) }
    }
}

impl<const N: usize> Default for Dual<N> {
    #[inline]
    fn default() -> Self {
        Self::ZERO
    }
}

impl<const N: usize> From<f64> for Dual<N> {
    #[inline]
    fn from(value: f64) -> Self {
        Dual { value, by: [0.0; N] }
    }
}

impl<const N: usize> PartialEq<f64> for Dual<N> {
    fn eq(&self, other: &f64) -> bool {
        self.value == *other && self.by.iter().all(|by| *by == 0.0)
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Dual { value: -self.value, by: self.by.map(|by| -by) }
    }
}

impl<const N: usize> Mul for Dual<N> {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let mut product = self.chain(self.value * other.value, other.value);
        for (by, other) in product.by.iter_mut().zip(other.by) {
            *by += self.value * other;
        }
        product
    }
}

impl<const N: usize> Div for Dual<N> {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let (value, part) = (self.value / other.value, 1.0 / other.value);
        let by = |i: usize| (self.by[i] - value * other.by[i]) * part;
        Dual { value, by: std::array::from_fn(by) }
    }
}

impl<const N: usize> Mul<f64> for Dual<N> {
    type Output = Self;

    #[inline]
    fn mul(self, other: f64) -> Self {
        Dual { value: self.value * other, by: self.by.map(|by| by * other) }
    }
}

impl<const N: usize> Div<f64> for Dual<N> {
    type Output = Self;

    #[inline]
    fn div(self, other: f64) -> Self {
        Dual { value: self.value / other, by: self.by.map(|by| by / other) }
    }
}

impl<const N: usize> AddAssign for Dual<N> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        self.value += other.value;
        for (by, other) in self.by.iter_mut().zip(other.by) {
            *by += other;
        }
    }
}

impl<const N: usize> SubAssign for Dual<N> {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        self.value -= other.value;
        for (by, other) in self.by.iter_mut().zip(other.by) {
            *by -= other;
        }
    }
}

/// Implements operators for dual numbers: assignment operators such as `+=` from code blocks, and from them operators
/// such as `+`.
macro_rules! operators {
    ($($trait:ident<$other:ty>::$method:ident($own:ident, $by:ident) $change:block)*) => {$(
        impl<const N: usize> $trait<$other> for Dual<N> {
            #[inline]
            fn $method(&mut self, $by: $other) {
                let $own = self;
                $change
            }
        }
    )*};
    ($($trait:ident<$other:ty>::$method:ident by $assign:tt)*) => {$(
        impl<const N: usize> $trait<$other> for Dual<N> {
            type Output = Self;

            #[inline]
            fn $method(mut self, other: $other) -> Self {
                self $assign other;
                self
            }
        }
    )*};
}

operators! {
    AddAssign<f64>::add_assign(own, by) { own.value += by; }
    SubAssign<f64>::sub_assign(own, by) { own.value -= by; }
    MulAssign<f64>::mul_assign(own, by) { *own = *own * by; }
    MulAssign<Self>::mul_assign(own, by) { *own = *own * by; }
}

operators! {
    Add<f64>::add by +=
    Sub<f64>::sub by -=
    Add<Self>::add by +=
    Sub<Self>::sub by -=
}

impl<const N: usize> Sum for Dual<N> {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(Self::ZERO, |sum, term| sum + term)
    }
}

impl<const N: usize> Real for Dual<N> {
    const ZERO: Self = Dual { value: 0.0, by: [0.0; N] };
    const ONE: Self = Dual { value: 1.0, by: [0.0; N] };

    #[inline]
    fn value(self) -> f64 {
        self.value
    }

    /// Square root. At the value zero, its derivatives are set to 0.
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, if root > 0.0 { 0.5 / root } else { 0.0 })
    }

    fn exp(self) -> Self {
        let value = Real::exp(self.value);
        self.chain(value, value)
    }

    fn expm1(self) -> Self {
        self.chain(Real::expm1(self.value), Real::exp(self.value))
    }

    fn sinh(self) -> Self {
        self.chain(Real::sinh(self.value), Real::cosh(self.value))
    }

    fn cosh(self) -> Self {
        self.chain(Real::cosh(self.value), Real::sinh(self.value))
    }

    fn tanh(self) -> Self {
        let (value, cosh) = (Real::tanh(self.value), Real::cosh(self.value));
        self.chain(value, 1.0 / (cosh * cosh))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_of_every_function_are_limits_of_differences() {
        let functions: [(&str, fn(Dual<1>) -> Dual<1>); 9] = [
            ("product", |x| x * x * 3.0),
            ("quotient", |x| (x + 2.0) / (x * x)),
            ("difference", |x| -(x - 1.0) / 7.0),
            ("sqrt", Real::sqrt),
            ("exp", Real::exp),
            ("expm1", Real::expm1),
            ("sinh", Real::sinh),
            ("cosh", Real::cosh),
            ("tanh", Real::tanh),
        ];
        for (name, function) in functions {
            let at = |x: f64| function(Dual { value: x, by: [1.0] });
            for x in [0.3, 1.0, 2.5] {
                let h = 1e-6;
                let quotient = (at(x + h).value - at(x - h).value) / (2.0 * h);
                assert!(
                    (at(x).by[0] - quotient).abs() < 1e-8 * (1.0 + quotient.abs()),
                    "{name} {x}"
                );
            }
        }
    }

    #[test]
    fn a_zero_with_a_derivative_is_not_zero() {
        let zero = Dual::<2>::from(0.0);
        assert!(zero == 0.0 && Dual { value: 0.0, by: [0.0, 1.0] } != 0.0);
    }
}
