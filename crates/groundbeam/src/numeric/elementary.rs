//! Elementary functions in pure Rust, with identical results on every platform.
//!
//! The results of the standard library differ between platforms in the last bits, so `clippy.toml` forbids its
//! functions in this crate.

use crate::numeric::real::Real;
pub(crate) use libm::{asinh, exp2, log2, pow};
#[cfg(test)]
pub(crate) use libm::{cos, tan};

#[inline]
pub(crate) fn exp<R: Real>(x: R) -> R {
    x.exp()
}

/// eˣ − 1.
#[inline]
pub(crate) fn expm1<R: Real>(x: R) -> R {
    x.expm1()
}

#[inline]
pub(crate) fn sinh<R: Real>(x: R) -> R {
    x.sinh()
}

#[inline]
pub(crate) fn cosh<R: Real>(x: R) -> R {
    x.cosh()
}

#[inline]
pub(crate) fn tanh<R: Real>(x: R) -> R {
    x.tanh()
}

/// xⁿ by n products.
#[inline]
pub(crate) fn power<R: Real>(x: R, n: usize) -> R {
    (0..n).fold(R::ONE, |product, _| product * x)
}
