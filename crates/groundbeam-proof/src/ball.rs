//! An interval that encloses a real number, as a midpoint and a radius, both doubles.

use crate::float::{ABOVE, HUGE, TINY, magnitude, magnitude_scaled, times_power_of_two};
use crate::scalar::{Scalar, expm1_by_series};
use std::ops::{Add, Mul, Neg, Sub};

/// An interval of real numbers, stored as its midpoint `m` and its radius `r`.
///
/// Each operation adds a bound of its rounding error to the radius. The rounding mode stays unchanged.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    m: f64,
    r: f64,
}

impl Ball {
    /// The ball of all numbers.
    pub(crate) const ALL: Ball = Ball { m: 0.0, r: f64::INFINITY };

    /// Returns the ball with the midpoint `m` and the radius `r`. NaN and huge numbers give the ball of all numbers.
    /// A tiny midpoint becomes 0, with a larger radius.
    pub(crate) fn new(m: f64, r: f64) -> Self {
        let size = magnitude(m);
        // A comparison with NaN is false, so NaN takes the first branch.
        if !(r <= HUGE && size <= HUGE) {
            Ball::ALL
        } else if size < TINY && size > 0.0 {
            Ball { m: 0.0, r: (r + TINY) * ABOVE }
        } else {
            Ball { m, r }
        }
    }

    /// Returns a bound of the sum of rounding error and underflow error of an operation with the result `m`.
    fn rounding(m: f64) -> f64 {
        magnitude(m) * f64::EPSILON + f64::MIN_POSITIVE
    }

    /// Returns the radius.
    pub fn radius(self) -> f64 {
        self.r
    }
}

impl Add for Ball {
    type Output = Ball;
    fn add(self, other: Ball) -> Ball {
        let m = self.m + other.m;
        Ball::new(m, (self.r + other.r + Ball::rounding(m)) * ABOVE)
    }
}

impl Neg for Ball {
    type Output = Ball;
    fn neg(self) -> Ball {
        Ball { m: -self.m, r: self.r }
    }
}

impl Sub for Ball {
    type Output = Ball;
    fn sub(self, other: Ball) -> Ball {
        self + -other
    }
}

impl Mul for Ball {
    type Output = Ball;
    fn mul(self, other: Ball) -> Ball {
        let m = self.m * other.m;
        let propagated =
            magnitude(self.m) * other.r + magnitude(other.m) * self.r + self.r * other.r;
        Ball::new(m, (propagated + Ball::rounding(m)) * ABOVE)
    }
}

impl Scalar for Ball {
    type Coarse = Ball;
    const ENCLOSES: bool = true;

    fn of(x: f64) -> Self {
        Ball::new(x, 0.0)
    }

    fn div(self, other: Self) -> Self {
        let least = if other.low() > 0.0 { other.low() } else { (-other).low() };
        if !(least > 0.0) {
            return Ball::ALL;
        }
        // The error of `q` is (`self` − q · `other`)/`other`, and `rest` contains the numerator.
        let q = self.m / other.m;
        let rest = self - Ball::new(q, 0.0) * other;
        // `rest.size()` is at least 1 + 12·2⁻⁵³ times the numerator, which covers the rounding errors of the radius.
        // `MIN_POSITIVE` covers an underflow of the quotient.
        Ball::new(q, rest.size() / least + f64::MIN_POSITIVE)
    }

    fn sqrt(self) -> Self {
        if self.m == 0.0 && self.r == 0.0 {
            return self;
        }
        if !(self.low() >= 0.0) {
            return Ball::ALL;
        }
        // The error of `q` as a root of a = `self` is |√a − q| = |a − q²|/(√a + q), which is at most |a − q²|/q.
        let q = self.m.sqrt();
        let root = Ball::new(q, 0.0);
        let rest = self - root * root;
        // `rest.size()` is at least 1 + 12·2⁻⁵³ times |a − q²|, which covers the rounding error of the radius. The
        // quotient does not underflow, because the radius of `rest` is at least 2⁻⁵² q².
        Ball::new(q, rest.size() / q)
    }

    fn expm1(self) -> Self {
        // The remainder of the series after 12 terms is below 2⁻⁷⁸ of the result.
        expm1_by_series(self, 12)
    }

    fn scaled(self, exponent: i32) -> Self {
        let r = magnitude_scaled(self.r, exponent);
        match times_power_of_two(self.m, exponent) {
            Some(m) => Ball::new(m, r),
            None => Ball::ALL,
        }
    }

    fn size(self) -> f64 {
        (magnitude(self.m) + self.r) * ABOVE
    }

    fn low(self) -> f64 {
        -(-self).high()
    }

    fn high(self) -> f64 {
        if self.r == 0.0 {
            return self.m;
        }
        let x = self.m + self.r;
        // The sum of the midpoint m and the radius r is rounded twice, each time by at most 2⁻⁵³ (|m| + r).
        x + 2.0 * f64::EPSILON * (magnitude(self.m) + self.r) + f64::MIN_POSITIVE
    }

    fn middle(self) -> f64 {
        self.m
    }

    fn parts(self) -> [f64; 3] {
        [self.m, 0.0, self.r]
    }

    fn coarse(self) -> Ball {
        self
    }

    fn widened(self, by: f64) -> Self {
        Ball::new(self.m, (self.r + magnitude(by)) * ABOVE)
    }
}
