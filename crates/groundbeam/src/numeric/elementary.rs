//! Elementary functions in pure Rust, which have the same bits on every platform.
//!
//! Those of the standard library come from the platform: their last bit differs between platforms. `clippy.toml` forbids
//! them in this crate.

#[cfg(test)]
pub(crate) use libm::{asinh, cos, tan};
pub(crate) use libm::{cosh, exp, exp2, expm1, log2, pow, sinh, tanh};

/// xⁿ by n products.
#[inline]
pub(crate) fn power(x: f64, n: usize) -> f64 {
    std::iter::repeat_n(x, n).product()
}
