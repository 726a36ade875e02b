//! Computes the displacement of ground without contact between two points: solves μu″ = ku with given values at both ends.

use crate::frame::Span;
use crate::scalar::Scalar;
use crate::size::Size;

/// Displacement u of open ground of length h with the end values u_L and u_R. With b = √(k/μ), z = bh and the distance
/// x from the left end,
///
/// ```text
/// u = (u_R − u_L) sinh(bx)/sinh z + u_L cosh(b(h/2 − x))/cosh(z/2).
/// ```
#[derive(Debug)]
pub(crate) struct Arc<C> {
    ends: [C; 2],
    decay: C,
    /// The product z = bh.
    z: C,
    length: C,
    /// Factors exp(−2z) − 1 and exp(−z) + 1 of the denominators sinh z = −½eᶻ(e⁻²ᶻ − 1) and cosh(z/2) = ½e^(z/2)(e⁻ᶻ + 1).
    divisors: [C; 2],
}

impl<C: Scalar> Arc<C> {
    pub fn of<S: Scalar<Coarse = C>>(span: &Span<S>, ends: [S; 2]) -> Self {
        let decay = span.spring.least().div(span.shear.least()).sqrt().coarse();
        let length = span.h.coarse();
        let z = decay * length;
        let divisors = [(-z.scaled(1)).expm1(), (-z).expm1() + C::of(2.0)];
        Arc { ends: ends.map(|u| u.coarse()), decay, z, length, divisors }
    }

    /// Returns b² = k/μ.
    pub fn curvature_factor(&self) -> C {
        self.decay.square()
    }

    /// Returns a lower bound of the ground displacement u on the piece. It is the smallest of zero and the two end
    /// values, because u has no negative minimum inside the piece.
    pub fn least(&self) -> f64 {
        let lows = self.ends.map(|u| u.low());
        -Size::below_zero(if lows[0] <= lows[1] { lows[0] } else { lows[1] }).value()
    }

    /// Returns the larger of the absolute values of the ground displacement u at the two ends of the piece.
    pub fn size(&self) -> f64 {
        self.ends[0].size().max(self.ends[1].size())
    }

    /// Returns the ground displacement u and its slope u′ at the distance x from the left end of the piece. x lies
    /// between 0 and the length h of the piece.
    pub fn at(&self, x: C) -> [C; 2] {
        let two = C::of(2.0);
        let [difference, left] = [self.ends[1] - self.ends[0], self.ends[0]];
        let a = self.decay * x;
        // The quotients sinh a/sinh z and cosh a/sinh z are computed from exponentials of negative arguments.
        let (fallen, double) = (exponential(a - self.z), (-a.scaled(1)).expm1());
        let sinh = (fallen * double).div(self.divisors[0]);
        let cosh = -(fallen * (double + two)).div(self.divisors[0]);
        // The second term of u is u_L cosh(c)/cosh(z/2); see [`Arc`].
        let c = self.decay * (self.length.scaled(-1) - x);
        let negative = c.middle() < 0.0;
        let size = if negative { -c } else { c };
        let fallen = exponential(size - self.z.scaled(-1));
        let double = (-size.scaled(1)).expm1();
        let even = (fallen * (double + two)).div(self.divisors[1]);
        let odd = -(fallen * double).div(self.divisors[1]);
        let odd = if negative { -odd } else { odd };
        [difference * sinh + left * even, self.decay * (difference * cosh - left * odd)]
    }
}

/// Returns exp(x) for x ≤ 0, with a small relative error even if exp(x) is small.
fn exponential<C: Scalar>(x: C) -> C {
    let mut halvings = 0;
    let mut size = x.size();
    while size > 1.0 && halvings < 60 {
        (size, halvings) = (0.5 * size, halvings + 1);
    }
    let mut value = x.scaled(-halvings).expm1() + C::one();
    for _ in 0..halvings {
        value = value.square();
    }
    value
}

#[cfg(test)]
mod tests {
    use super::{Arc, exponential};
    use crate::answer::Piece;
    use crate::ball::Ball;
    use crate::coefficient::Coefficient;
    use crate::frame::Span;
    use crate::scalar::Scalar;
    use crate::units::Units;
    use crate::wide::Wide;

    /// Checks the bounds of the ground displacement u on a piece: its lower bound is the smallest of zero and the end
    /// values, and the bound of |u| is the larger absolute end value.
    #[test]
    fn the_surface_is_bounded_by_its_ends() {
        for (ends, least, most) in [
            ([0.5, 2.0], 0.0, 2.0),
            ([-0.5, 2.0], -0.5, 2.0),
            ([0.5, -2.0], -2.0, 2.0),
            ([-0.5, -2.0], -2.0, 2.0),
            ([-3.0, -2.0], -3.0, 3.0),
        ] {
            let piece =
                Piece { x: [0.0, 2.0], half: 1.0, deflection: vec![0.0], ..Piece::default() };
            let units = Units { length: 0, force: 0 };
            let mut span = Span::of(&piece, [0.0, 2.0].map(Wide::of), units).expect("a piece");
            (span.spring, span.shear) =
                (Coefficient::Even(Wide::of(3.0)), Coefficient::Even(Wide::of(0.5)));
            let arc = Arc::of(&span, ends.map(Wide::of));
            assert!(arc.least() == least && (most..most + 1e-12).contains(&arc.size()), "{ends:?}");
        }
    }

    #[test]
    fn a_small_exponential_keeps_its_digits() {
        for x in [0.0, -0.5, -1.0, -1.5, -20.0, -60.0] {
            let found = exponential(Ball::of(x));
            let ratio = found.middle() / f64::exp(x);
            assert!((ratio - 1.0).abs() < 1e-12 && found.radius() < 1e-12 * found.middle(), "{x}");
        }
        assert_eq!(exponential(Ball::of(f64::NEG_INFINITY)).size(), f64::INFINITY);
    }
}
