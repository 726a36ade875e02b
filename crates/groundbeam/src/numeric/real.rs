//! Number types of the mechanical equations: `f64`, or a value with derivatives.
//!
//! Numbers of type `Real` cannot be compared by size. Every decision uses the value only, so derivatives cannot change
//! it. The comparison `==` includes the derivatives.

use std::fmt::Debug;
use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// Type of the numbers in the data and in the solution of a model.
pub(crate) trait Real:
    Copy
    + Default
    + Debug
    + PartialEq
    + PartialEq<f64>
    + From<f64>
    + Sum
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + AddAssign<f64>
    + SubAssign<f64>
    + MulAssign<f64>
{
    const ZERO: Self;
    const ONE: Self;

    /// Value of the number, without its derivatives with respect to the parameters of the model.
    fn value(self) -> f64;

    fn sqrt(self) -> Self;
    fn exp(self) -> Self;
    /// eˣ − 1.
    fn expm1(self) -> Self;
    fn sinh(self) -> Self;
    fn cosh(self) -> Self;
    fn tanh(self) -> Self;
}

impl Real for f64 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;

    #[inline]
    fn value(self) -> f64 {
        self
    }

    #[inline]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }

    #[inline]
    fn exp(self) -> Self {
        libm::exp(self)
    }

    #[inline]
    fn expm1(self) -> Self {
        libm::expm1(self)
    }

    #[inline]
    fn sinh(self) -> Self {
        libm::sinh(self)
    }

    #[inline]
    fn cosh(self) -> Self {
        libm::cosh(self)
    }

    #[inline]
    fn tanh(self) -> Self {
        libm::tanh(self)
    }
}

/// Sum of N terms, from the first to the last. The compiler unrolls this loop for every `Real`, but not the
/// `sum` of an iterator.
#[inline(always)]
pub(crate) fn sum<R: Real, const N: usize>(term: impl Fn(usize) -> R) -> R {
    let mut sum = term(0);
    for i in 1..N {
        sum += term(i);
    }
    sum
}
