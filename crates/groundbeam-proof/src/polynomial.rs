//! Polynomials in the coordinate t of a piece, with balls as coefficients, and bounds of their negative part.

use crate::scalar::Scalar;
use crate::size::Size;
use std::ops::{Add, Mul, Sub};

/// The highest degree of a claimed deflection.
pub(crate) const HIGHEST: usize = 25;
/// The highest degree of a coefficient that varies along a piece, such as EI or k.
pub(crate) const HIGHEST_COURSE: usize = 5;

/// Maximum number of coefficients of a polynomial. The product of a field and a stiffness, each with its highest degree,
/// has this number.
pub(crate) const CAPACITY: usize = HIGHEST + HIGHEST_COURSE + 1;

/// 1, 2, 3, …
const NUMBERS: [f64; CAPACITY] = {
    let mut numbers = [1.0; CAPACITY];
    let mut j = 1;
    while j < CAPACITY {
        numbers[j] = numbers[j - 1] + 1.0;
        j += 1;
    }
    numbers
};

/// The polynomial Σ cⱼ tʲ with at most N coefficients, stored without heap memory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Polynomial<S, const N: usize = CAPACITY> {
    len: usize,
    /// Zero from `len` on.
    c: [S; N],
}

/// c₀ + c₁t.
pub(crate) type Line<S> = Polynomial<S, 2>;

impl<S: Scalar, const N: usize> Polynomial<S, N> {
    pub fn zero() -> Self {
        Polynomial { len: 0, c: [S::zero(); N] }
    }

    /// Stops compilation if the number of coefficients exceeds the capacity.
    const fn has_capacity_for<const M: usize>() {
        let _ = const { N - M };
    }

    /// Creates a polynomial from at most N coefficients, in ascending order of the powers.
    pub fn from_coefficients(coefficients: impl IntoIterator<Item = S>) -> Self {
        let (mut len, mut c) = (0, [S::zero(); N]);
        for coefficient in coefficients {
            c[len] = coefficient;
            len += 1;
        }
        Polynomial { len, c }
    }

    pub fn coefficients(&self) -> &[S] {
        &self.c[..self.len]
    }

    /// The coefficient of tʲ.
    pub fn coefficient(&self, j: usize) -> S {
        self.coefficients().get(j).copied().unwrap_or_else(S::zero)
    }

    pub fn derivative(&self) -> Self {
        self.derivative_times(S::one())
    }

    /// The derivative with respect to t, multiplied by a factor.
    pub fn derivative_times(&self, factor: S) -> Self {
        let mut derived = Self::zero();
        derived.len = self.len.saturating_sub(1);
        let above = self.coefficients().iter().skip(1);
        for ((derived, c), j) in derived.c.iter_mut().zip(above).zip(&NUMBERS) {
            *derived = *c * S::of(*j) * factor;
        }
        derived
    }

    pub fn times(mut self, factor: S) -> Self {
        for c in &mut self.c[..self.len] {
            *c = *c * factor;
        }
        self
    }

    pub fn value(&self, t: S) -> S {
        let mut from_top = self.coefficients().iter().rev();
        let Some(top) = from_top.next() else { return S::zero() };
        from_top.fold(*top, |sum, c| sum * t + *c)
    }

    /// The difference of the polynomial's values at two positions, computed without the constant coefficient.
    pub fn rise(&self, [from, to]: [S; 2]) -> S {
        let above = |t: S| {
            let terms = self.coefficients().iter().skip(1).rev();
            terms.fold(S::zero(), |sum, c| sum * t + *c) * t
        };
        above(to) - above(from)
    }

    /// Σ|cⱼ|τʲ, an upper bound of the polynomial's absolute value on |t| ≤ τ.
    pub fn size(&self, tau: f64) -> Size {
        Size::of(raised(self.coefficients(), tau, S::size))
    }

    /// Upper bound of |p(t) − p(0)| for |t| ≤ τ, where p is this polynomial.
    pub fn tail(&self, tau: f64) -> Size {
        match self.coefficients() {
            [] => Size::ZERO,
            [_, rest @ ..] => Size::of(raised(rest, tau, S::size)) * Size::of(tau),
        }
    }

    pub fn coarse(&self) -> Polynomial<S::Coarse, N> {
        Polynomial { len: self.len, c: self.c.map(S::coarse) }
    }

    /// Returns the polynomial in powers of t − m.
    pub fn shifted(mut self, m: f64) -> Self {
        if m == 0.0 {
            return self;
        }
        let m = S::of(m);
        for first in 0..self.len.saturating_sub(1) {
            for j in (first..self.len - 1).rev() {
                self.c[j] = self.c[j] + self.c[j + 1] * m;
            }
        }
        self
    }
}

/// Upper bound of Σ size(cⱼ)τʲ. The sum is increased once at the end, to cover its rounding errors and underflows.
fn raised<S: Copy>(coefficients: &[S], tau: f64, size: impl Fn(S) -> f64) -> f64 {
    let sum = coefficients.iter().rev().fold(0.0, |sum, c| sum * tau + size(*c));
    // A sum of nonzero terms may underflow to zero. It counts as zero only if all coefficients are zero.
    let is_zero = sum == 0.0 && coefficients.iter().all(|c| size(*c) == 0.0);
    if is_zero { 0.0 } else { sum * (1.0 + 64.0 * f64::EPSILON) + f64::MIN_POSITIVE }
}

impl<S: Scalar, const N: usize, const M: usize> Add<&Polynomial<S, M>> for Polynomial<S, N> {
    type Output = Self;
    fn add(mut self, other: &Polynomial<S, M>) -> Self {
        Self::has_capacity_for::<M>();
        for (c, more) in self.c.iter_mut().zip(other.coefficients()) {
            *c = *c + *more;
        }
        self.len = self.len.max(other.len);
        self
    }
}

impl<S: Scalar, const N: usize, const M: usize> Sub<&Polynomial<S, M>> for Polynomial<S, N> {
    type Output = Self;
    fn sub(mut self, other: &Polynomial<S, M>) -> Self {
        Self::has_capacity_for::<M>();
        for (c, less) in self.c.iter_mut().zip(other.coefficients()) {
            *c = *c - *less;
        }
        self.len = self.len.max(other.len);
        self
    }
}

impl<S: Scalar> Mul for &Polynomial<S> {
    type Output = Polynomial<S>;
    fn mul(self, other: &Polynomial<S>) -> Polynomial<S> {
        let mut product = Polynomial::zero();
        for (i, a) in self.coefficients().iter().enumerate() {
            for (c, b) in product.c[i..].iter_mut().zip(other.coefficients()) {
                *c = *c + *a * *b;
            }
        }
        product.len = (self.len + other.len).saturating_sub(1);
        product
    }
}

/// Numbers of interval halvings that are still allowed: on the current piece, and on all pieces together.
#[derive(Debug)]
pub(crate) struct Budget {
    piece: usize,
    all: usize,
}

impl Budget {
    /// Maximum number of interval halvings on one piece.
    const PIECE: usize = 4000;
    /// Maximum number of interval halvings per piece, averaged over all pieces.
    const AVERAGE: usize = 200;

    pub fn new(pieces: usize) -> Self {
        Budget { piece: 0, all: Self::AVERAGE * pieces }
    }

    /// Starts a new piece: resets the number of halvings that remain for one piece to its maximum.
    pub fn begin(&mut self) {
        self.piece = Self::PIECE;
    }

    /// Counts one interval halving. Returns `false` if no more halvings are allowed.
    pub fn take(&mut self) -> bool {
        let left = self.piece > 0 && self.all > 0;
        if left {
            (self.piece, self.all) = (self.piece - 1, self.all - 1);
        }
        left
    }
}

/// Bounds of the negative part of a function: its depth, and the measure of the set where the function is negative.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Below {
    /// The function is at least −depth.
    pub depth: Size,
    /// Upper bound of the total length on which the function is negative, in units of its variable t.
    pub width: Size,
}

impl Below {
    pub const NOWHERE: Below = Below { depth: Size::ZERO, width: Size::ZERO };
}

/// Bounds the negative part of q = `p` − `less` on an interval: its depth, and the length on which q is negative.
/// Intervals are halved until q is positive or strictly monotone, or until the bound of the depth is accepted.
pub(crate) fn below<C: Scalar>(
    p: &Polynomial<C>,
    less: Size,
    negligible: Size,
    [from, to]: [f64; 2],
    budget: &mut Budget,
) -> Below {
    let mut found = Below::NOWHERE;
    let mut open = Vec::new();
    let mut next = Some([from, to]);
    budget.begin();
    while let Some([a, b]) = next.take().or_else(|| open.pop()) {
        let m = if a < 0.0 && b > 0.0 && a == from && b == to { 0.0 } else { 0.5 * (a + b) };
        let r = half_width(a, m, b);
        let shifted;
        let about = if m == 0.0 {
            p
        } else {
            shifted = p.shifted(m);
            &shifted
        };
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
                // The function is monotone, so bisection bounds the length on which it is negative.
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
        // The interval is not halved if `depth` is negligible, or at most the rounding error plus 1.25 times the depth
        // at the middle.
        let c0 = about.coefficient(0);
        let blurred = Size::of(0.25 * (c0.high() - c0.low()));
        let enough = depth <= blurred + 1.25 * here || depth <= negligible;
        if !enough && a < m && m < b && budget.take() {
            open.extend([[a, m], [m, b]]);
        } else {
            // The function counts as negative on the whole interval.
            found.depth = found.depth.worst(depth);
            found.width += Size::of((b - a).next_up());
        }
    }
    found
}

/// The larger of the two distances of `m` from the ends `a` and `b`, rounded up.
pub(crate) fn half_width(a: f64, m: f64, b: f64) -> f64 {
    let (left, right) = ((m - a).next_up(), (b - m).next_up());
    if left >= right { left } else { right }
}

#[cfg(test)]
mod tests {
    use super::{Budget, Polynomial, below, raised};
    use crate::ball::Ball;
    use crate::random::numbers;
    use crate::scalar::Scalar;
    use crate::size::Size;

    /// Checks for random cubic polynomials that the bounds of the depth and of the length of the negative part hold
    /// and are nearly attained.
    #[test]
    fn the_negative_part_of_a_polynomial_is_bounded() {
        let mut random = numbers();
        let [mut shallow, mut negative] = [0; 2];
        for case in 0..1000 {
            let mut c = [0; 4].map(|_| random());
            c[0] += 0.5;
            if case % 3 == 0 {
                (c[2], c[3]) = (0.05 * c[2], 0.05 * c[3]);
            }
            let less = 0.2 * random().abs();
            let ends = match case % 4 {
                0 => [-1.0, 1.0],
                1 => [-random().abs(), random().abs()],
                2 => [0.1 + 0.4 * random().abs(), 0.6 + 0.4 * random().abs()],
                _ => [-0.6 - 0.4 * random().abs(), -0.1 - 0.4 * random().abs()],
            };
            let p = |t: f64| c[0] + t * (c[1] + t * (c[2] + t * c[3])) - less;
            let step = (ends[1] - ends[0]) / 4000.0;
            let values = (0..4000).map(|i| p(ends[0] + step * (f64::from(i) + 0.5)));
            let depth = values.clone().fold(0.0, |depth, value| f64::max(depth, -value));
            let width = step * values.filter(|value| *value < 0.0).count() as f64;
            let field = <Polynomial<Ball>>::from_coefficients(c.map(Ball::of));
            let found = below(&field, Size::of(less), Size::ZERO, ends, &mut Budget::new(4));
            let [most, long] = [found.depth, found.width].map(Size::value);
            assert!(
                most >= depth && long >= width - 2.0 * step,
                "{case}: {most} {depth} {long} {width}"
            );
            let slack = 1.5 * depth + 1.2 * less + 1e-3;
            assert!(
                most <= slack && long <= 3.0 * width + 0.2,
                "{case}: {most} {depth} {long} {width}"
            );
            shallow += i32::from(depth == 0.0);
            negative += i32::from(depth > 0.0);
        }
        assert!(shallow > 100 && negative > 100, "{shallow} {negative}");
    }

    #[test]
    fn halvings_are_limited_on_a_piece_and_on_all_pieces() {
        let mut budget = Budget::new(30);
        budget.begin();
        let taken = |budget: &mut Budget| (0..10_000).filter(|_| budget.take()).count();
        assert_eq!(taken(&mut budget), 4000);
        budget.begin();
        assert_eq!(taken(&mut budget), 2000);
    }

    /// The function s + 4s² with s = 1 ± t/τ increases with s on |t| ≤ τ. So it is smaller than its value at s₀ on a
    /// length τs₀.
    #[test]
    fn the_negative_part_of_a_monotone_function_is_found_by_bisection() {
        for (sign, tau) in [(1.0, 1.0), (-1.0, 1.0), (1.0, 1e-10), (-1.0, 1e-10)] {
            let c = [5.0, sign * 9.0 / tau, 4.0 / (tau * tau)];
            let field = <Polynomial<Ball>>::from_coefficients(c.map(Ball::of));
            for s in [0.001, 0.01, 0.1, 0.3, 0.5, 0.9, 1.0, 1.1, 1.5, 1.9] {
                let less = Size::of(s + 4.0 * s * s);
                let found = below(&field, less, Size::ZERO, [-tau, tau], &mut Budget::new(1));
                let depth = found.depth.value() / less.value();
                let width = found.width.value() / (tau * s);
                assert!((1.0 - 1e-9..1.0 + 1e-9).contains(&depth), "{s}: {depth}");
                assert!((1.0 - 1e-9..1.07).contains(&width), "{sign} {tau} {s}: {width}");
            }
        }
    }

    /// For the constant negative function −1 − ½ = −1.5, the bound on the whole interval is exact, so the interval is
    /// not halved.
    #[test]
    fn a_constant_function_needs_no_halving() {
        let field = <Polynomial<Ball>>::from_coefficients([Ball::of(-1.0)]);
        let mut budget = Budget::new(1);
        let found = below(&field, Size::of(0.5), Size::ZERO, [-1.0, 1.0], &mut budget);
        assert!((found.depth.value() - 1.5).abs() < 1e-12, "{found:?}");
        assert_eq!((0..1000).filter(|_| budget.take()).count(), 200);
    }

    /// Checks that Σ|cⱼ|τʲ, the bound of a polynomial with the coefficients cⱼ on |t| ≤ τ, is not rounded down, even
    /// if it is close to the smallest positive double or below it.
    #[test]
    fn a_sum_of_the_smallest_numbers_is_rounded_up() {
        let power = |n: i32| 2.0_f64.powi(500 + n) * 2.0_f64.powi(-500);
        for (coefficients, tau, exact) in [
            (&[power(-1020)][..], 1.0, power(-1020)),
            (&[0.0, power(-1074)], 0.5, power(-1074)),
            (&[power(-1021), power(-1021)], 0.75, 1.75 * power(-1021)),
            (&[0.0, 0.0, 0.0, 1e-280], 1e-20, power(-1074)),
            (&[0.0, 0.0], 1.0, 0.0),
        ] {
            let found = raised(coefficients, tau, |c| c);
            assert!(
                found >= exact && (found == 0.0) == (exact == 0.0),
                "{coefficients:?}: {found:e}"
            );
        }
    }
}
