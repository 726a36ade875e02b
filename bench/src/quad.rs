//! Arithmetic with about 32 digits, on unevaluated sums of two doubles (Dekker, Knuth).

use std::ops::{Add, Div, Mul, Neg, Sub};

/// Number with about 32 digits, the sum of two doubles.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Quad {
    high: f64,
    low: f64,
}

impl Quad {
    /// Returns the nearest double.
    pub fn double(self) -> f64 {
        self.high
    }
}

impl From<f64> for Quad {
    fn from(high: f64) -> Self {
        Quad { high, low: 0.0 }
    }
}

/// Returns the rounded sum a + b and its rounding error.
fn sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let from_b = s - a;
    (s, (a - (s - from_b)) + (b - from_b))
}

fn split(a: f64) -> (f64, f64) {
    let scaled = 134_217_729.0 * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

fn renormalised(high: f64, low: f64) -> Quad {
    let s = high + low;
    Quad { high: s, low: low - (s - high) }
}

impl Add for Quad {
    type Output = Quad;
    fn add(self, other: Quad) -> Quad {
        let (s, e) = sum(self.high, other.high);
        let (t, f) = sum(self.low, other.low);
        let first = renormalised(s, e + t);
        renormalised(first.high, first.low + f)
    }
}

impl Neg for Quad {
    type Output = Quad;
    fn neg(self) -> Quad {
        Quad { high: -self.high, low: -self.low }
    }
}

impl Sub for Quad {
    type Output = Quad;
    fn sub(self, other: Quad) -> Quad {
        self + -other
    }
}

impl Mul for Quad {
    type Output = Quad;
    fn mul(self, other: Quad) -> Quad {
        let p = self.high * other.high;
        let ((a, b), (c, d)) = (split(self.high), split(other.high));
        let e = ((a * c - p) + a * d + b * c) + b * d;
        renormalised(p, e + (self.high * other.low + self.low * other.high))
    }
}

impl Div for Quad {
    type Output = Quad;
    fn div(self, other: Quad) -> Quad {
        let first = self.high / other.high;
        let rest = self - other * Quad::from(first);
        let second = rest.high / other.high;
        let rest = rest - other * Quad::from(second);
        renormalised(first, second) + Quad::from(rest.high / other.high)
    }
}
