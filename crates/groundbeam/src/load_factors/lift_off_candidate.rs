//! Computes the load factor λ at which a contact pressure or force becomes tensile, if the pressure or force is linear in λ.

use crate::numeric::polynomial::{Coefficients, derivative, value};
use crate::numeric::roots::sign_changes;

/// Contact pressure on the stretch `x` of the beam, or a concentrated contact force. Its value at the load factor λ is
/// `staying` + λ · `growing`. Lift-off begins where this value becomes negative.
#[derive(Debug, Clone)]
pub(super) struct LiftOffCandidate {
    pub x: [f64; 2],
    pub staying: Side,
    pub growing: Side,
}

/// Pressure or force due to the constant loads, or due to the increasing loads at load factor 1, as a polynomial in
/// s ∈ \[−1, 1\]. Its rounding error is relative to `size`, the sum of the absolute values of its terms.
#[derive(Debug, Clone, Default)]
pub(super) struct Side {
    pub coefficients: Coefficients,
    pub size: f64,
}

/// Relative rounding error of a sum in which each term results from a few dozen operations.
const SUM_ROUNDING: f64 = 256.0 * f64::EPSILON;

/// Maximum number of Newton steps for one candidate. It is far above the number needed.
const CANDIDATE_STEPS: usize = 200;

impl LiftOffCandidate {
    /// Whether the pressure is tensile at factor 0.
    pub fn is_tensile_at_zero(&self) -> bool {
        lowest(&self.staying.coefficients).1 < -SUM_ROUNDING * self.staying.size
    }

    /// Returns the largest factor below `factor` without negative pressure, and the position where the pressure is then
    /// zero. Returns `None` if no pressure is negative at `factor`, which may be infinite.
    ///
    /// Newton's method decreases to the result without passing it, because the minimum of the pressure is concave in
    /// the factor.
    pub fn first_tension_below(&self, factor: f64) -> Option<(f64, f64)> {
        let (mut factor, mut found) = (factor, None);
        for _ in 0..CANDIDATE_STEPS {
            let Some(s) = self.tension_at(factor) else { break };
            let [stays, grows] =
                [&self.staying, &self.growing].map(|side| value(&side.coefficients, s));
            let next = (stays / -grows).max(0.0);
            if next >= factor {
                break;
            }
            factor = next;
            found = Some((factor, self.position(s)));
        }
        found
    }

    /// Whether a load factor is so small that the increasing loads, multiplied by it, change the pressure or
    /// force of this candidate only by rounding error.
    pub fn is_nothing(&self, factor: f64) -> bool {
        factor * self.growing.size <= SUM_ROUNDING * self.staying.size
    }

    /// Returns the s ∈ \[−1, 1\] at which the pressure is most negative at the load factor `factor`. Returns `None` if
    /// no pressure is negative beyond rounding error.
    fn tension_at(&self, factor: f64) -> Option<f64> {
        let (stays, grows) = (&self.staying, &self.growing);
        let (coefficients, size) = if factor.is_finite() {
            let both = stays.coefficients.iter().zip(grows.coefficients.iter());
            let sum = both.map(|(a, b)| a + factor * b).collect();
            (sum, stays.size + factor * grows.size)
        } else {
            (grows.coefficients, grows.size)
        };
        let (s, lowest) = lowest(&coefficients);
        (lowest < -SUM_ROUNDING * size).then_some(s)
    }

    fn position(&self, s: f64) -> f64 {
        let [from, to] = self.x;
        let half = 0.5 * (to - from);
        if s <= 0.0 { from + half * (1.0 + s) } else { to - half * (1.0 - s) }
    }
}

/// Returns the position and the value of the minimum of a polynomial on \[−1, 1\]. If a lower bound of the
/// minimum is not negative, the bound is returned in place of the minimum.
fn lowest(c: &[f64]) -> (f64, f64) {
    let spread: f64 = c.iter().skip(1).map(|a| a.abs()).sum();
    let bound = c.first().map_or(0.0, |constant| constant - spread);
    if bound >= 0.0 {
        return (-1.0, bound);
    }
    let mut places = vec![-1.0];
    sign_changes(&derivative(c), &mut places);
    places.push(1.0);
    let all = places.into_iter().map(|s| (s, value(c, s)));
    all.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((-1.0, bound))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn side(coefficients: &[f64], size: f64) -> Side {
        Side { coefficients: coefficients.into(), size }
    }

    /// Returns a candidate on the beam from x = 1 to x = 5, from the coefficients of the constant and of the increasing
    /// pressure. Rounding errors are relative to 1 for both pressures.
    fn between_1_and_5(staying: &[f64], growing: &[f64]) -> LiftOffCandidate {
        LiftOffCandidate { x: [1.0, 5.0], staying: side(staying, 1.0), growing: side(growing, 1.0) }
    }

    #[track_caller]
    fn near(found: f64, wanted: f64) {
        assert!((found - wanted).abs() <= 1e-14 * wanted.abs().max(1.0), "{found} {wanted}");
    }

    #[test]
    fn the_minimum_of_a_polynomial_is_at_an_end_or_a_turning_point() {
        assert_eq!(lowest(&[-2.0]), (-1.0, -2.0));
        assert_eq!(lowest(&[1.0, 2.0]), (-1.0, -1.0));
        assert_eq!(lowest(&[1.0, -2.0]), (1.0, -1.0));
        assert_eq!(lowest(&[-1.0, 0.0, 1.0]), (0.0, -1.0));
        // s⁴ − s²/2 has the minimum −1/16 at s = ±1/2. The left position is returned.
        let (s, least) = lowest(&[0.0, 0.0, -0.5, 0.0, 1.0]);
        near(s, -0.5);
        near(least, -0.0625);
        // The lower bound 3 − 1 − 1 = 1 of 3 + s − s² is not negative. So `lowest` returns this bound and the left end
        // s = −1.
        assert_eq!(lowest(&[3.0, 1.0, -1.0]), (-1.0, 1.0));
        assert_eq!(lowest(&[]), (-1.0, 0.0));
    }

    /// At the load factor λ, the pressure 2 − λ (1 + s) first becomes zero at s = 1, for λ = 1. The pressure
    /// 1 + s² − λ (1 + s) has the minimum 1 − λ − λ²/4 at s = λ/2, which is zero for λ = 2√2 − 2.
    #[test]
    fn the_factor_of_first_tension_agrees_with_closed_forms() {
        let at = |of: &LiftOffCandidate, from: f64| of.first_tension_below(from).expect("tension");
        let falling = between_1_and_5(&[2.0, 0.0], &[-1.0, -1.0]);
        for from in [f64::INFINITY, 8.0] {
            assert_eq!(at(&falling, from), (1.0, 5.0));
            assert_eq!(at(&between_1_and_5(&[2.0, 0.0], &[-1.0, 1.0]), from), (1.0, 1.0));
            for mirror in [1.0, -1.0] {
                let parabola = between_1_and_5(&[1.0, 0.0, 1.0], &[-1.0, -mirror, 0.0]);
                let root = 2.0 * 2.0_f64.sqrt() - 2.0;
                let (factor, x) = at(&parabola, from);
                near(factor, root);
                // The position of a minimum is known to the square root of the machine precision.
                assert!((x - (3.0 + mirror * root)).abs() < 1e-7, "{x}");
            }
        }
        // At λ = 1/2, the pressure 2 − λ (1 + s) is compressive on [−1, 1]. The pressure 1 + λ is compressive for
        // every λ.
        assert_eq!(falling.first_tension_below(0.5), None);
        assert_eq!(between_1_and_5(&[1.0], &[1.0]).first_tension_below(f64::INFINITY), None);
        // The pressure −1 + 2λ is negative at every factor λ below 1/2, so no factor below 0.25 is free of
        // tension.
        assert_eq!(between_1_and_5(&[-1.0], &[2.0]).first_tension_below(0.25), None);
        // If the constant part of the pressure and its part proportional to λ are both tensile, the returned
        // factor λ is 0.
        assert_eq!(at(&between_1_and_5(&[-1.0], &[-1.0]), 3.0), (0.0, 1.0));
    }

    /// The parts of the pressure have the sizes 2 and 3λ at the load factor λ. So the pressure is tensile if it is
    /// below −256 ε (2 + 3λ), with the machine epsilon ε.
    #[test]
    fn tension_exceeds_rounding_error() {
        let constant = |part: f64| {
            let [staying, growing] = [side(&[-SUM_ROUNDING * part], 2.0), side(&[0.0], 3.0)];
            LiftOffCandidate { x: [0.0, 1.0], staying, growing }
        };
        assert!(!constant(1.9).is_tensile_at_zero() && constant(2.1).is_tensile_at_zero());
        assert_eq!(constant(13.9).tension_at(4.0), None);
        assert_eq!(constant(14.1).tension_at(4.0), Some(-1.0));
        let grows = |part: f64| {
            let [staying, growing] = [side(&[1.0], 2.0), side(&[-SUM_ROUNDING * part], 3.0)];
            LiftOffCandidate { x: [0.0, 1.0], staying, growing }
        };
        assert_eq!(grows(2.9).tension_at(f64::INFINITY), None);
        assert_eq!(grows(3.1).tension_at(f64::INFINITY), Some(-1.0));
        // The load factor λ counts as zero if the size 3λ of the increasing part is at most 256 machine epsilons times
        // the size 2 of the constant part.
        assert!(constant(0.0).is_nothing(SUM_ROUNDING * 0.66));
        assert!(!constant(0.0).is_nothing(SUM_ROUNDING * 0.67));
        // The pressure of this candidate is zero at every load factor, so it is never tensile.
        let nothing = LiftOffCandidate {
            x: [0.0, 1.0],
            staying: side(&[0.0], 0.0),
            growing: side(&[0.0], 0.0),
        };
        assert!(!nothing.is_tensile_at_zero() && nothing.is_nothing(0.0));
        assert_eq!([1.0, f64::INFINITY].map(|factor| nothing.tension_at(factor)), [None; 2]);
    }

    /// The positions at s = −1 and s = 1 are exactly the ends of the part. They do not depend on the rounding
    /// of half its length.
    #[test]
    fn positions_at_the_ends_of_a_part_keep_their_bits() {
        let x = [0.2, 0.9];
        let of = LiftOffCandidate { x, ..between_1_and_5(&[1.0], &[1.0]) };
        assert_eq!([-1.0, 1.0].map(|s| of.position(s)), x);
        let of = between_1_and_5(&[1.0], &[1.0]);
        assert_eq!([-1.0, -0.5, 0.0, 0.5, 1.0].map(|s| of.position(s)), [1.0, 2.0, 3.0, 4.0, 5.0]);
    }
}
