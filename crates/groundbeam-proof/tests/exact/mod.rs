//! Exact arithmetic for tests: whole numbers times powers of two, and random operands.
#![allow(dead_code)]

use num_bigint::{BigInt, Sign};
use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

/// n·2ᵉ.
#[derive(Debug, Clone)]
pub struct Exact {
    n: BigInt,
    e: i64,
}

impl Exact {
    pub fn of(x: f64) -> Self {
        assert!(x.is_finite(), "{x}");
        let bits = x.to_bits();
        let exponent = (bits >> 52 & 0x7ff) as i64;
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        let (n, e) = match exponent {
            0 => (fraction, -1074),
            _ => (fraction | 1 << 52, exponent - 1075),
        };
        Exact { n: BigInt::from(if x < 0.0 { -n } else { n }), e }
    }

    pub fn whole(n: i64) -> Self {
        Exact { n: BigInt::from(n), e: 0 }
    }

    pub fn is_zero(&self) -> bool {
        self.n.sign() == Sign::NoSign
    }

    pub fn is_negative(&self) -> bool {
        self.n.sign() == Sign::Minus
    }

    pub fn magnitude(&self) -> Self {
        Exact { n: BigInt::from(self.n.magnitude().clone()), e: self.e }
    }

    pub fn times_power_of_two(self, exponent: i32) -> Self {
        Exact { e: self.e + i64::from(exponent), ..self }
    }

    /// Both as whole numbers over the same power of two.
    fn aligned(self, other: Self) -> (BigInt, BigInt, i64) {
        let e = self.e.min(other.e);
        (self.n << (self.e - e) as u64, other.n << (other.e - e) as u64, e)
    }
}

impl Add for Exact {
    type Output = Exact;
    fn add(self, other: Exact) -> Exact {
        let (a, b, e) = self.aligned(other);
        Exact { n: a + b, e }
    }
}

impl Sub for Exact {
    type Output = Exact;
    fn sub(self, other: Exact) -> Exact {
        let (a, b, e) = self.aligned(other);
        Exact { n: a - b, e }
    }
}

impl Mul for Exact {
    type Output = Exact;
    fn mul(self, other: Exact) -> Exact {
        Exact { n: self.n * other.n, e: self.e + other.e }
    }
}

impl PartialEq for Exact {
    fn eq(&self, other: &Exact) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl PartialOrd for Exact {
    fn partial_cmp(&self, other: &Exact) -> Option<Ordering> {
        let (a, b, _) = self.clone().aligned(other.clone());
        Some(a.cmp(&b))
    }
}

pub fn power_of_ten(n: u32) -> Exact {
    Exact { n: BigInt::from(10).pow(n), e: 0 }
}

/// Bounds of exp(x) − 1 for −1000 < x ≤ 0, in whole multiples of 2⁻⁴⁰⁰: the series of x·2⁻²⁰, doubled twenty times.
pub fn expm1(x: f64) -> [Exact; 2] {
    const BITS: i64 = 400;
    let exact = Exact::of(x).times_power_of_two(-20);
    let shift = exact.e + BITS;
    let y = if shift >= 0 { exact.n << shift as u64 } else { exact.n >> (-shift) as u64 };
    let (mut term, mut sum) = (y.clone(), y.clone());
    for j in 2..60 {
        term = ((term * &y) >> BITS as u64) / j;
        sum += &term;
    }
    let two = BigInt::from(1) << (BITS + 1) as u64;
    for _ in 0..20 {
        sum = (&sum * (&sum + &two)) >> BITS as u64;
    }
    // Each of some hundred steps is off by at most a few units, doubled at most twenty times.
    let off = BigInt::from(1) << 60_u64;
    [Exact { n: &sum - &off, e: -BITS }, Exact { n: sum + off, e: -BITS }]
}

/// A generator of random numbers (xorshift64*).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    pub fn bits(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    pub fn below(&mut self, n: u64) -> u64 {
        self.bits() % n
    }

    /// In 0 ≤ x < 1.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number of random sign: mostly of moderate size, sometimes subnormal, tiny, huge, whole or zero.
    pub fn number(&mut self) -> f64 {
        let fraction = (self.unit() - 0.5) * 2.0;
        match self.below(12) {
            0 => f64::from_bits(self.below(1 << 52)) * fraction.signum(),
            1 => fraction * 2.0_f64.powi(self.below(400) as i32 - 1060),
            2 => fraction * 2.0_f64.powi(self.below(500) as i32 + 450),
            3 => self.below(1000) as f64 * fraction.signum(),
            4 if self.below(4) == 0 => 0.0,
            5 | 6 => fraction * 2.0_f64.powi(self.below(400) as i32 - 200),
            _ => fraction * 2.0_f64.powi(self.below(40) as i32 - 20),
        }
    }
}
