//! Elementary functions in pure Rust, with the same bits on every platform.
//!
//! The functions of the standard library call the platform's library, whose last bits differ. `clippy.toml`
//! forbids them in this crate.

#[cfg(test)]
pub(crate) use libm::{asinh, cos, tan};
pub(crate) use libm::{cosh, exp, exp2, expm1, log2, pow, sinh, tanh};

/// xⁿ by n products.
#[inline]
pub(crate) fn power(x: f64, n: usize) -> f64 {
    std::iter::repeat_n(x, n).product()
}
