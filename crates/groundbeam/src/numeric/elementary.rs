//! Elementary functions in pure Rust, with the same bits on every platform.
//!
//! The functions of the standard library call the platform's library, whose last bits differ. `clippy.toml`
//! forbids them in this crate.

pub(crate) use libm::{asinh, cosh, exp, exp2, expm1, log2, pow, sinh, tanh};
#[cfg(test)]
pub(crate) use libm::{cos, tan};

/// xⁿ by n products.
#[inline]
pub(crate) fn power(x: f64, n: usize) -> f64 {
    std::iter::repeat_n(x, n).product()
}
