//! Sizes: nonnegative upper bounds of norms. Each operation is rounded up.

use std::ops::{Add, AddAssign, Mul};

/// An upper bound of a norm. NaN becomes infinity, so that NaN never passes a comparison with a limit.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(crate) struct Size(f64);

impl Size {
    pub const ZERO: Size = Size(0.0);
    pub const INFINITE: Size = Size(f64::INFINITY);

    /// Creates a size from a bound that is already rounded up.
    pub fn of(x: f64) -> Self {
        if x >= 0.0 { Size(x) } else { Size::INFINITE }
    }

    /// Returns the absolute value of a lower bound if the bound is negative, and otherwise zero.
    pub fn below_zero(low: f64) -> Self {
        if low >= 0.0 { Size::ZERO } else { Size::of(-low) }
    }

    pub fn value(self) -> f64 {
        self.0
    }

    /// Divides by a lower bound of the divisor and rounds up. The quotient is infinite unless the lower bound is
    /// positive.
    pub fn over(self, low: f64) -> Self {
        let quotient = if low > 0.0 { self.0 / low } else { f64::INFINITY };
        Size::rounded_up(quotient, self.0 == 0.0)
    }

    pub fn root(self) -> Self {
        Size::rounded_up(self.0.sqrt(), self.0 == 0.0)
    }

    pub fn square(self) -> Self {
        self * self
    }

    /// The larger of two sizes.
    pub fn worst(self, other: Size) -> Self {
        if other.0 <= self.0 { self } else { other }
    }

    /// The smaller of two sizes.
    pub fn least(self, other: Size) -> Self {
        if other.0 < self.0 { other } else { self }
    }

    /// Rounds `x` up to the next double, unless it is exact. Infinity remains, and NaN becomes infinity. The operators
    /// `&` and `|` avoid branches.
    fn rounded_up(x: f64, is_exact: bool) -> Self {
        let Size(x) = Size::of(x);
        Size(f64::from_bits(x.to_bits() + u64::from(!is_exact & (x < f64::INFINITY))))
    }
}

impl Add for Size {
    type Output = Size;
    fn add(self, other: Size) -> Size {
        Size::rounded_up(self.0 + other.0, (self.0 == 0.0) | (other.0 == 0.0))
    }
}

impl AddAssign for Size {
    fn add_assign(&mut self, other: Size) {
        *self = *self + other;
    }
}

impl Mul for Size {
    type Output = Size;
    fn mul(self, other: Size) -> Size {
        Size::rounded_up(self.0 * other.0, (self.0 == 0.0) | (other.0 == 0.0))
    }
}

impl Mul<Size> for f64 {
    type Output = Size;
    fn mul(self, size: Size) -> Size {
        Size::of(self) * size
    }
}

impl std::iter::Sum for Size {
    fn sum<I: Iterator<Item = Size>>(sizes: I) -> Size {
        sizes.fold(Size::ZERO, |sum, size| sum + size)
    }
}

#[cfg(test)]
mod tests {
    use super::Size;

    #[test]
    fn nan_and_negative_numbers_are_infinite() {
        for x in [f64::NAN, -1.0] {
            assert_eq!(Size::of(x).value(), f64::INFINITY);
        }
        assert_eq!((Size::ZERO * Size::INFINITE).value(), f64::INFINITY);
        assert_eq!((Size::INFINITE * Size::ZERO).value(), f64::INFINITY);
        assert_eq!(Size::ZERO.over(0.0).value(), f64::INFINITY);
        assert_eq!(Size::ZERO.over(-1.0).value(), f64::INFINITY);
        assert_eq!((Size::INFINITE + Size::of(1.0)).value(), f64::INFINITY);
        assert_eq!(Size::of(1.0).over(0.0).value(), f64::INFINITY);
        assert_eq!(Size::of(1.0).over(f64::NAN).value(), f64::INFINITY);
        assert_eq!(Size::of(2.0).worst(Size::of(f64::NAN)).value(), f64::INFINITY);
        assert_eq!(Size::below_zero(f64::NAN).value(), f64::INFINITY);
        assert_eq!(Size::below_zero(1.0).value(), 0.0);
    }

    #[test]
    fn products_and_quotients_of_zero_are_zero() {
        assert_eq!(Size::ZERO.over(2.0), Size::ZERO);
        assert_eq!(Size::ZERO * Size::of(2.0), Size::ZERO);
        assert_eq!(Size::of(2.0) * Size::ZERO, Size::ZERO);
    }

    #[test]
    fn squares_do_not_underflow_to_zero() {
        assert!(Size::of(1e-200).square().value() > 0.0);
        assert!(Size::of(1e-200).square().root().value() >= 0.0);
    }
}
