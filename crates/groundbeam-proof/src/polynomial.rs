//! Polynomials of t on a piece, with balls as coefficients, and bounds of how far they fall below zero.

use crate::scalar::Scalar;
use crate::size::Size;
use std::ops::{Add, Mul, Sub};

/// The highest degree of a claimed deflection.
pub(crate) const HIGHEST: usize = 25;
/// The highest degree of a coefficient that varies.
pub(crate) const HIGHEST_COURSE: usize = 5;

/// Σ cⱼ tʲ.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Polynomial<S> {
    c: Vec<S>,
}

impl<S: Scalar> Polynomial<S> {
    pub fn zero() -> Self {
        Polynomial { c: Vec::new() }
    }

    /// From the constant coefficient on.
    pub fn from_coefficients(coefficients: impl IntoIterator<Item = S>) -> Self {
        Polynomial { c: coefficients.into_iter().collect() }
    }

    /// c₀ + c₁t.
    pub fn line(c0: S, c1: S) -> Self {
        Self::from_coefficients([c0, c1])
    }

    pub fn coefficients(&self) -> &[S] {
        &self.c
    }

    /// The coefficient of tʲ.
    pub fn coefficient(&self, j: usize) -> S {
        self.c.get(j).copied().unwrap_or_else(S::zero)
    }

    pub fn derivative(&self) -> Self {
        Self::from_coefficients(self.derived())
    }

    /// The derivative times a factor.
    pub fn derivative_times(&self, factor: S) -> Self {
        Self::from_coefficients(self.derived().map(|c| c * factor))
    }

    /// The coefficients of the derivative.
    fn derived(&self) -> impl Iterator<Item = S> {
        self.c.iter().enumerate().skip(1).map(|(j, c)| *c * S::of(j as f64))
    }

    /// tᵏp.
    pub fn raised(&self, k: usize) -> Self {
        let zeros = std::iter::repeat_n(S::zero(), k);
        Self::from_coefficients(zeros.chain(self.coefficients().iter().copied()))
    }

    pub fn times(&self, factor: S) -> Self {
        Self::from_coefficients(self.coefficients().iter().map(|c| *c * factor))
    }

    pub fn value(&self, t: S) -> S {
        let mut from_top = self.coefficients().iter().rev();
        let Some(top) = from_top.next() else { return S::zero() };
        from_top.fold(*top, |sum, c| sum * t + *c)
    }

    /// p at one position less p at another, without the constant that both have.
    pub fn rise(&self, [from, to]: [S; 2]) -> S {
        let above = |t: S| {
            let terms = self.coefficients().iter().skip(1).rev();
            terms.fold(S::zero(), |sum, c| sum * t + *c) * t
        };
        above(to) - above(from)
    }

    /// The integral over t from one position to another.
    pub fn integral(&self, [from, to]: [S; 2]) -> S {
        let antiderivative = |t: S| {
            let terms = self.coefficients().iter().enumerate().rev();
            terms.fold(S::zero(), |sum, (j, c)| sum * t + c.div(S::of((j + 1) as f64))) * t
        };
        antiderivative(to) - antiderivative(from)
    }

    /// Σ|cⱼ|τʲ, a bound of the polynomial on |t| ≤ τ.
    pub fn size(&self, tau: f64) -> Size {
        Size::of(raised(self.coefficients(), tau, S::size))
    }

    /// The same without the constant coefficient.
    pub fn tail(&self, tau: f64) -> Size {
        match self.coefficients() {
            [] => Size::ZERO,
            [_, rest @ ..] => Size::of(raised(rest, tau, S::size)) * Size::of(tau),
        }
    }

    pub fn coarse(&self) -> Polynomial<S::Coarse> {
        Polynomial::from_coefficients(self.coefficients().iter().map(|c| c.coarse()))
    }

    /// The coefficients about another point: the polynomial of t − m.
    pub fn shifted(&self, m: f64) -> Self {
        let mut p = self.clone();
        if m == 0.0 {
            return p;
        }
        let m = S::of(m);
        for first in 0..p.c.len().saturating_sub(1) {
            for j in (first..p.c.len() - 1).rev() {
                p.c[j] = p.c[j] + p.c[j + 1] * m;
            }
        }
        p
    }
}

/// Σ size(cⱼ)τʲ, rounded up once: 2n roundings of 2⁻⁵³ each and at most n underflows.
fn raised<S: Copy>(coefficients: &[S], tau: f64, size: impl Fn(S) -> f64) -> f64 {
    let sum = coefficients.iter().rev().fold(0.0, |sum, c| sum * tau + size(*c));
    if sum == 0.0 { 0.0 } else { sum * (1.0 + 64.0 * f64::EPSILON) + f64::MIN_POSITIVE }
}

impl<S: Scalar> Add for &Polynomial<S> {
    type Output = Polynomial<S>;
    fn add(self, other: &Polynomial<S>) -> Polynomial<S> {
        let (longer, less) =
            if self.c.len() >= other.c.len() { (self, other) } else { (other, self) };
        let mut sum = longer.clone();
        for (c, more) in sum.c.iter_mut().zip(&less.c) {
            *c = *c + *more;
        }
        sum
    }
}

impl<S: Scalar> Sub for &Polynomial<S> {
    type Output = Polynomial<S>;
    fn sub(self, other: &Polynomial<S>) -> Polynomial<S> {
        let len = self.c.len().max(other.c.len());
        let mut c = Vec::with_capacity(len);
        c.extend_from_slice(&self.c);
        c.resize(len, S::zero());
        for (c, less) in c.iter_mut().zip(&other.c) {
            *c = *c - *less;
        }
        Polynomial { c }
    }
}

impl<S: Scalar> Mul for &Polynomial<S> {
    type Output = Polynomial<S>;
    fn mul(self, other: &Polynomial<S>) -> Polynomial<S> {
        let mut c = vec![S::zero(); (self.c.len() + other.c.len()).saturating_sub(1)];
        for (i, a) in self.c.iter().enumerate() {
            for (c, b) in c[i..].iter_mut().zip(&other.c) {
                *c = *c + *a * *b;
            }
        }
        Polynomial { c }
    }
}

/// How many halvings are left: on one piece, and on all of them together.
#[derive(Debug)]
pub(crate) struct Budget {
    piece: usize,
    all: usize,
}

impl Budget {
    /// Halvings allowed on one piece.
    const PIECE: usize = 4000;
    /// Halvings allowed on average.
    const AVERAGE: usize = 200;

    pub fn new(pieces: usize) -> Self {
        Budget { piece: 0, all: Self::AVERAGE * pieces }
    }

    /// Begins another piece.
    pub fn begin(&mut self) {
        self.piece = Self::PIECE;
    }

    /// Takes one halving; false if none is left.
    pub fn take(&mut self) -> bool {
        let left = self.piece > 0 && self.all > 0;
        if left {
            (self.piece, self.all) = (self.piece - 1, self.all - 1);
        }
        left
    }
}

/// Where a function may be negative: a bound of its depth, and of the measure of the set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Below {
    /// The function is at least −depth.
    pub depth: Size,
    /// The measure, in units of t.
    pub width: Size,
}

impl Below {
    pub const NOWHERE: Below = Below { depth: Size::ZERO, width: Size::ZERO };
}

/// How far a polynomial less a size falls below zero on an interval.
///
/// On an interval about m of half width r the value is at least c₀ − Σ_{j≥1}|cⱼ|rʲ, cⱼ the coefficients about m.
/// Where the derivative has one sign, |p′| ≥ σ > 0, the least value v is at an end, and p < 0 on at most −v/σ.
/// Otherwise the interval is halved, unless it is deep already in its middle or the
/// depth is negligible; when the budget is spent it counts with its
/// bound and its whole width.
pub(crate) fn below<C: Scalar>(
    p: &Polynomial<C>,
    less: Size,
    negligible: Size,
    [from, to]: [f64; 2],
    budget: &mut Budget,
) -> Below {
    let mut found = Below::NOWHERE;
    let mut open = vec![[from, to]];
    budget.begin();
    while let Some([a, b]) = open.pop() {
        let m = if a < 0.0 && b > 0.0 && a == from && b == to { 0.0 } else { 0.5 * (a + b) };
        let r = half_width(a, m, b);
        let about = p.shifted(m);
        let low = about.coefficient(0).low();
        let lost = about.tail(r) + less;
        if low >= lost.value() {
            continue;
        }
        let derivative = about.derivative();
        let slope = derivative.coefficient(0);
        let rising = slope.middle() > 0.0;
        let least = if rising { slope.low() } else { (-slope).low() };
        let least = (least - derivative.tail(r).value()).next_down();
        if least > 0.0 && (b - a) > 0.0 {
            let end = if rising { a } else { b };
            let value = p.value(C::of(end)).low() - less.value();
            let depth = Size::below_zero(value.next_down());
            if depth.value() > 0.0 {
                let reach = |t: f64| Size::of(if rising { t - a } else { b - t }.next_up());
                let mut width = Size::of((b - a).next_up()).least(depth.over(least));
                // The function is not negative beyond a place where it is not negative.
                let (mut t, mut step) = (m, 0.5 * (b - a));
                for _ in 0..30 {
                    step *= 0.5;
                    if p.value(C::of(t)).low() >= less.value() {
                        width = width.least(reach(t));
                        t = if rising { t - step } else { t + step };
                    } else {
                        t = if rising { t + step } else { t - step };
                    }
                    if step * 32.0 < width.value() {
                        break;
                    }
                }
                found.depth = found.depth.worst(depth);
                found.width += width;
            }
            continue;
        }
        let here = Size::below_zero((about.coefficient(0) - C::of(less.value())).low());
        let depth = Size::below_zero(low) + lost;
        // A depth that halving would not change much, one as small as the rounding, or one that does not matter.
        let c0 = about.coefficient(0);
        let blurred = Size::of(0.25 * (c0.high() - c0.low()));
        let enough = depth <= blurred + 1.25 * here || depth <= negligible;
        if !enough && a < m && m < b && budget.take() {
            open.extend([[a, m], [m, b]]);
        } else {
            found.depth = found.depth.worst(depth);
            found.width += Size::of((b - a).next_up());
        }
    }
    found
}

/// The larger distance of m from both ends, rounded up.
pub(crate) fn half_width(a: f64, m: f64, b: f64) -> f64 {
    let (left, right) = ((m - a).next_up(), (b - m).next_up());
    if left >= right { left } else { right }
}
