//! Vector (SIMD) arithmetic for one or two eliminations along the beam at the same time, with one number for each elimination.

use std::ops::{Add, Mul, Sub};

/// One number for each elimination along the beam.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lanes<const N: usize>(pub [f64; N]);

impl<const N: usize> Lanes<N> {
    /// Creates one value for each elimination sweep along the beam. `number(i)` returns the value
    /// for sweep i.
    pub fn of(number: impl FnMut(usize) -> f64) -> Self {
        Lanes(std::array::from_fn(number))
    }

    /// 1/x.
    #[inline(always)]
    pub fn inverse(self) -> Self {
        Lanes(self.0.map(|x| 1.0 / x))
    }
}

impl<const N: usize> Add for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Lanes(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }
}

impl<const N: usize> Sub for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Lanes(std::array::from_fn(|i| self.0[i] - other.0[i]))
    }
}

impl<const N: usize> Mul for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Lanes(std::array::from_fn(|i| self.0[i] * other.0[i]))
    }
}
