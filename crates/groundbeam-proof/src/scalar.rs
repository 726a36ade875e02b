//! The number type of the proof: `f64` for an estimate, `Ball` and `Wide` for enclosures, which make the proof rigorous.

use crate::decimal::Decimal;
use crate::float::{HUGE, scale};
use crate::size::Size;
use std::fmt::Debug;
use std::ops::{Add, Mul, Neg, Sub};

/// A real number, or an interval that contains it.
///
/// With `Ball` or `Wide`, each operation encloses all exact results, so a proven inequality is a theorem. With `f64`,
/// the same formulas give an estimate.
pub trait Scalar:
    Copy
    + Debug
    + PartialEq
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
{
    /// A type with fewer digits, sufficient for the signs of clearances.
    type Coarse: Scalar;

    /// Whether values of this type enclose their rounding error. Doubles do not, so a proof in doubles is only an
    /// estimate.
    const ENCLOSES: bool;

    /// The exact value of a double. A value that is not finite gives a ball of infinite radius.
    fn of(x: f64) -> Self;

    /// Reads a decimal number: an optional sign, digits with an optional point, and an optional exponent (`-0.8`,
    /// `1e-5`). Returns `None` if the text is not such a number.
    fn decimal(text: &str) -> Option<Self> {
        let read = Decimal::read(text)?;
        let mut value: Self = of_digits(read.digits, read.exponent)?;
        if read.cut {
            value = value.widened(of_digits::<Self>(1, read.exponent)?.size());
        }
        (value.size() <= HUGE).then_some(if read.negative { -value } else { value })
    }

    /// The quotient of `self` and `other`. Its radius is infinite if `other` contains 0.
    fn div(self, other: Self) -> Self;

    /// The square root. Its radius is infinite if `self` contains a negative number.
    fn sqrt(self) -> Self;

    /// exp(x) − 1 for x ≤ 0.
    fn expm1(self) -> Self;

    /// The value times 2ⁿ, without rounding.
    fn scaled(self, exponent: i32) -> Self;

    /// An upper bound of |x|.
    fn size(self) -> f64;

    /// A lower bound of x.
    fn low(self) -> f64;

    /// An upper bound of x.
    fn high(self) -> f64;

    /// The midpoint of the ball, as a double. It may guide a search, but it is never a bound.
    fn middle(self) -> f64;

    /// Middle, correction of the middle and radius of the ball. They represent the ball exactly.
    fn parts(self) -> [f64; 3];

    /// The same number in the type with fewer digits.
    fn coarse(self) -> Self::Coarse;

    /// The ball with its radius increased by `by`. An `f64` is returned unchanged.
    fn widened(self, by: f64) -> Self;

    /// Zero.
    fn zero() -> Self {
        Self::of(0.0)
    }

    /// One.
    fn one() -> Self {
        Self::of(1.0)
    }

    /// x².
    fn square(self) -> Self {
        self * self
    }
}

/// Computes exp(x) − 1 for x ≤ 0 by the first `terms` terms of its power series. `terms` must be at most 18, so that
/// the coefficients are exact doubles.
pub(crate) fn expm1_by_series<S: Scalar>(x: S, terms: u32) -> S {
    if !(x.high() <= 1.0) {
        return S::of(f64::INFINITY);
    }
    if !(x.low() >= -700.0) {
        // exp(x) − 1 lies between −1 and exp(high) − 1, where `high` is the upper end of x.
        return if x.high() < -690.0 {
            S::of(-1.0).widened(1e-280)
        } else {
            S::of(0.0).widened(2.0)
        };
    }
    let mut halvings = 0;
    let mut size = x.size();
    while size > 0.0625 {
        (size, halvings) = (0.5 * size, halvings + 1);
    }
    let y = x.scaled(-halvings);
    // With n = `terms`, the sum of yʲ/j! from j = 1 to n is y/n! times a polynomial with the integer coefficients
    // n!/j!.
    let (mut sum, mut coefficient) = (S::one(), 1.0);
    for j in (1..terms).rev() {
        coefficient *= f64::from(j + 1);
        sum = sum * y + S::of(coefficient);
    }
    let size = Size::of(size);
    // The remainder is at most 2|y|ⁿ⁺¹/(n+1)!.
    let mut rest = (2.0 * size).over(f64::from(terms + 1));
    for _ in 0..terms {
        rest = rest * size;
    }
    let mut e = (y * sum).div(S::of(coefficient)).widened(rest.over(coefficient).value());
    for _ in 0..halvings {
        // For e = exp(x) − 1, both (e + 1)² − 1 and e(e + 2) are exp(2x) − 1. The first formula has a small radius
        // near e = −1, and the second has a small relative error near e = 0.
        let square = (e + S::one()).square() - S::one();
        e = if e.size() > 0.5 { square } else { e * (e + S::of(2.0)) };
    }
    e
}

/// Returns a ball that contains max(y, 0) for every number y in the ball `x`.
pub(crate) fn positive_part<S: Scalar>(x: S) -> S {
    if x.low() >= 0.0 {
        x
    } else if x.high() <= 0.0 {
        S::zero()
    } else {
        let half = 0.5 * x.high();
        S::of(half).widened(half.next_up())
    }
}

/// An integer as a number of this type.
fn whole<S: Scalar>(n: u128) -> S {
    let h = n as f64;
    // All integers here are below 2¹²³, so the nearest double is an integer that fits `u128`.
    let rounded = h as u128;
    let l = n.abs_diff(rounded) as f64;
    let lost = n.abs_diff(rounded).abs_diff(l as u128) as f64;
    match (l == 0.0, rounded <= n) {
        (true, _) => S::of(h),
        (_, true) => (S::of(h) + S::of(l)).widened(lost),
        (_, false) => (S::of(h) - S::of(l)).widened(lost),
    }
}

/// 5ⁿ.
fn power_of_five<S: Scalar>(n: u32) -> S {
    match n {
        0..=48 => whole(5_u128.pow(n)),
        _ => power_of_five::<S>(n / 2) * power_of_five(n - n / 2),
    }
}

/// The number digits·10ⁿ with n = `exponent`, exact if the number type can represent it. Returns `None` if |n| >
/// 400.
fn of_digits<S: Scalar>(mut digits: u128, mut exponent: i32) -> Option<S> {
    if digits == 0 {
        return Some(S::zero());
    }
    if !(-400..=400).contains(&exponent) {
        return None;
    }
    let twos = exponent;
    while digits.is_multiple_of(5) {
        (digits, exponent) = (digits / 5, exponent + 1);
    }
    while exponent > 0 && digits < 1 << 120 {
        (digits, exponent) = (5 * digits, exponent - 1);
    }
    let (whole, fives) = (whole::<S>(digits), power_of_five(exponent.unsigned_abs()));
    let value = match exponent {
        0 => whole,
        1.. => whole * fives,
        _ => whole.div(fives),
    };
    Some(value.scaled(twos))
}

impl Scalar for f64 {
    type Coarse = f64;
    const ENCLOSES: bool = false;

    fn of(x: f64) -> Self {
        x
    }

    fn decimal(text: &str) -> Option<Self> {
        Decimal::read(text)?;
        text.parse().ok().filter(|x: &f64| x.abs() <= HUGE)
    }

    fn div(self, other: Self) -> Self {
        self / other
    }

    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }

    fn expm1(self) -> Self {
        expm1_by_series(self, 12)
    }

    fn scaled(self, exponent: i32) -> Self {
        scale(self, exponent)
    }

    fn size(self) -> f64 {
        self.abs()
    }

    fn low(self) -> f64 {
        self
    }

    fn high(self) -> f64 {
        self
    }

    fn middle(self) -> f64 {
        self
    }

    fn parts(self) -> [f64; 3] {
        [self, 0.0, 0.0]
    }

    fn coarse(self) -> f64 {
        self
    }

    fn widened(self, _: f64) -> Self {
        self
    }
}

#[cfg(test)]
mod tests {
    use super::expm1_by_series;
    use crate::scalar::Scalar;
    use crate::{Ball, Wide};

    /// With few terms, the remainder of the series of exp(x) − 1 exceeds all rounding errors. The bound of the
    /// remainder is twice its first term.
    #[test]
    fn the_remainder_of_the_series_is_bounded() {
        for terms in 2..=5 {
            for x in [-0.0625, -0.04, -0.01, -0.24] {
                let exact = Wide::of(x).expm1();
                let (wide, ball) =
                    (expm1_by_series(Wide::of(x), terms), expm1_by_series(Ball::of(x), terms));
                for [middle, radius] in
                    [[wide.middle(), wide.radius()], [ball.middle(), ball.radius()]]
                {
                    let ratio = radius / (exact - Wide::of(middle)).size();
                    assert!((1.0..2.5).contains(&ratio), "{terms} {x}: {ratio}");
                }
            }
        }
    }
}
