//! An interval that encloses a real number: a midpoint that is the sum of two doubles (106 bits), and a radius.
//!
//! Each operation increases the radius by 16·2⁻¹⁰⁶ of the result. The rounding error is at most 3·2⁻¹⁰⁶ for a sum and
//! 5·2⁻¹⁰⁶ for a product (Joldes, Muller and Popescu, *ACM Trans. Math. Softw.* 44 (2017)).

use crate::ball::Ball;
use crate::float::{ABOVE, HUGE, TINY, magnitude, magnitude_scaled, times_power_of_two};
use crate::scalar::{Scalar, expm1_by_series};
use std::ops::{Add, Mul, Neg, Sub};

/// The interval of all numbers x with |x − (h + l)| ≤ r, where |l| is at most half a unit in the last place
/// of h.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wide {
    h: f64,
    l: f64,
    r: f64,
}

/// 16·2⁻¹⁰⁶.
const CHARGE: f64 = 4.0 * f64::EPSILON * f64::EPSILON;

/// Returns the rounded sum a + b and its exact rounding error.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let bb = s - a;
    (s, (a - (s - bb)) + (b - bb))
}

/// Returns the result of [`two_sum`] with fewer operations, for |a| ≥ |b|.
fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

/// Splits a double into two doubles with half the digits each. The sum of the two doubles is exact.
fn split(a: f64) -> (f64, f64) {
    let c = 134_217_729.0 * a;
    let high = c - (c - a);
    (high, a - high)
}

/// Returns the rounded product a·b and its rounding error, which is exact unless it underflows.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

impl Wide {
    /// The ball of all numbers.
    pub(crate) const ALL: Wide = Wide { h: 0.0, l: 0.0, r: f64::INFINITY };

    /// Creates the ball with the midpoint h + l and the radius r. A ball out of range becomes [`Wide::ALL`], and
    /// a tiny midpoint becomes zero.
    fn new(h: f64, l: f64, r: f64) -> Self {
        let size = magnitude(h);
        // A comparison with NaN is false, so NaN takes the first branch.
        if !(r <= HUGE && size <= HUGE && magnitude(l) <= HUGE) {
            Wide::ALL
        } else if size < TINY && (size > 0.0 || l != 0.0) {
            Wide { h: 0.0, l: 0.0, r: (r + magnitude(l) + TINY) * ABOVE }
        } else {
            Wide { h, l, r }
        }
    }

    /// Bound of the rounding error of a result, including underflow.
    fn rounding(h: f64) -> f64 {
        magnitude(h) * CHARGE + f64::MIN_POSITIVE
    }

    /// Converts the number to a ball whose midpoint is one double.
    pub fn ball(self) -> Ball {
        Ball::new(self.h, (self.r + magnitude(self.l)) * ABOVE)
    }

    /// The radius.
    pub fn radius(self) -> f64 {
        self.r
    }

    /// The midpoint, as two doubles whose exact sum is the midpoint. The second double is the small remainder.
    pub fn midpoint(self) -> [f64; 2] {
        [self.h, self.l]
    }

    /// The midpoint as an interval of radius zero.
    fn centre(self) -> Wide {
        Wide { r: 0.0, ..self }
    }
}

impl Add for Wide {
    type Output = Wide;
    fn add(self, other: Wide) -> Wide {
        let (sh, sl) = two_sum(self.h, other.h);
        let (th, tl) = two_sum(self.l, other.l);
        let (vh, vl) = fast_two_sum(sh, sl + th);
        let (h, l) = fast_two_sum(vh, tl + vl);
        Wide::new(h, l, (self.r + other.r + Wide::rounding(h)) * ABOVE)
    }
}

impl Neg for Wide {
    type Output = Wide;
    fn neg(self) -> Wide {
        Wide { h: -self.h, l: -self.l, r: self.r }
    }
}

impl Sub for Wide {
    type Output = Wide;
    fn sub(self, other: Wide) -> Wide {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Wide;
    fn mul(self, other: Wide) -> Wide {
        let (ch, cl) = two_product(self.h, other.h);
        let cross = self.h * other.l + self.l * other.h;
        let (h, l) = fast_two_sum(ch, cl + cross);
        // The size |h + l| may exceed |h| by the rounding error of a double. The factor `ABOVE` covers this.
        let propagated =
            magnitude(self.h) * other.r + magnitude(other.h) * self.r + self.r * other.r;
        Wide::new(h, l, (propagated + Wide::rounding(h)) * ABOVE)
    }
}

impl Scalar for Wide {
    type Coarse = Ball;
    const ENCLOSES: bool = true;

    fn of(x: f64) -> Self {
        Wide::new(x, 0.0, 0.0)
    }

    fn div(self, other: Self) -> Self {
        let least = if other.low() > 0.0 { other.low() } else { (-other).low() };
        if !(least > 0.0) {
            return Wide::ALL;
        }
        // The error of the quotient is the residual divided by the divisor. The factor of at least 1 + 12·2⁻⁵³ in
        // `size` covers the rounding errors of the last line. The smallest normal number covers underflow.
        let first = self.h / other.h;
        let rest = self.centre() - Wide::of(first) * other.centre();
        let (h, l) = fast_two_sum(first, rest.h / other.h);
        let q = Wide::new(h, l, 0.0);
        let rest = self - q * other;
        q.widened(rest.size() / least + f64::MIN_POSITIVE)
    }

    fn sqrt(self) -> Self {
        if self.h == 0.0 && self.r == 0.0 {
            return self;
        }
        if !(self.low() >= 0.0) {
            return Wide::ALL;
        }
        // The error of the root q is at most the residual divided by q. The radius of the residual is at least 2⁻¹⁰²q²,
        // so the division does not underflow.
        let first = self.h.sqrt();
        let rest = self.centre() - Wide::of(first).square();
        let (h, l) = fast_two_sum(first, rest.h / (2.0 * first));
        let q = Wide::new(h, l, 0.0);
        let least = q.low();
        if !(least > 0.0) {
            return Wide::ALL;
        }
        let rest = self - q * q;
        q.widened(rest.size() / least)
    }

    fn expm1(self) -> Self {
        // The remainder of the series after 18 terms is below 2⁻¹²⁷ of the result.
        expm1_by_series(self, 18)
    }

    fn scaled(self, exponent: i32) -> Self {
        let (h, l) = (times_power_of_two(self.h, exponent), times_power_of_two(self.l, exponent));
        let (Some(h), Some(l)) = (h, l) else { return Wide::ALL };
        let mut r = magnitude_scaled(self.r, exponent);
        if l != 0.0 && magnitude(l) < TINY {
            // The scaling may have rounded `l` to a subnormal number.
            r = (r + f64::MIN_POSITIVE) * ABOVE;
        }
        Wide::new(h, l, r)
    }

    fn size(self) -> f64 {
        (magnitude(self.h) + magnitude(self.l) + self.r) * ABOVE
    }

    fn low(self) -> f64 {
        -(-self).high()
    }

    fn high(self) -> f64 {
        if self.r == 0.0 && self.l == 0.0 {
            return self.h;
        }
        let x = (self.h + self.r) + self.l;
        let sum = magnitude(self.h) + magnitude(self.l) + self.r;
        // The rounding error of each addition is at most 2⁻⁵³ times the sum of all absolute values.
        x + 2.0 * f64::EPSILON * sum + f64::MIN_POSITIVE
    }

    fn middle(self) -> f64 {
        self.h
    }

    fn parts(self) -> [f64; 3] {
        [self.h, self.l, self.r]
    }

    fn coarse(self) -> Ball {
        self.ball()
    }

    fn widened(self, by: f64) -> Self {
        Wide::new(self.h, self.l, (self.r + magnitude(by)) * ABOVE)
    }
}
