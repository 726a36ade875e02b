//! Computes the end forces of a stretch of ground without contact from its end settlements, (2.2)–(2.5) of Kikuchi's paper.
//!
//! Unloaded ground, −(μu')' + ku = 0, acts between the two ends of a stretch like three springs, which form a
//! *two-port*: `series` between the ends, `shunt_left` and `shunt_right` under the ends. All three stiffnesses are
//! positive. So the connection of two two-ports in series loses no digits by cancellation.
//!
//! The stiffness matrix of consecutive two-ports is tridiagonal. It is the inverse of the full matrix (5.8) of the
//! paper.

use crate::model::GroundOutside;
use crate::model::outside::OutsideLayer;
use crate::numeric::elementary::{exp, expm1, power, sinh, tanh};
use crate::numeric::polynomial::{Coefficients, derivative, ends, trimmed};
use crate::numeric::real::Real;

/// The three springs that are equivalent to a stretch of unloaded ground, for forces at its left and its right end.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct TwoPort<R = f64> {
    /// Stiffness of the spring between the left and the right end \[N/m\].
    pub series: R,
    /// Stiffness of the spring under the left end of the stretch \[N/m\].
    pub shunt_left: R,
    /// Stiffness of the spring under the right end of the stretch \[N/m\].
    pub shunt_right: R,
}

impl<R: Real> TwoPort<R> {
    /// The two-port of a stretch of length zero. Its series stiffness is practically infinite, so both ends have the
    /// same settlement.
    pub fn rigid() -> Self {
        TwoPort { series: R::from(f64::MAX), shunt_left: R::ZERO, shunt_right: R::ZERO }
    }

    /// The two-port (the three equivalent springs) of a uniform stretch of ground of length h, with k > 0 and μ > 0.
    pub fn uniform(k: R, mu: R, h: f64) -> Self {
        Self::of_decay((k * mu).sqrt(), (k / mu).sqrt() * h)
    }

    /// The two-port of a uniform stretch of ground of the length `bh`, in decay lengths √(μ/k). `stiffness` is √(kμ).
    pub fn of_decay(stiffness: R, bh: R) -> Self {
        // The formula uses e^(−bh), because sinh(bh) would overflow.
        let decay = exp(-bh);
        let series = stiffness * 2.0 * decay / -expm1(bh * -2.0);
        let shunt = stiffness * tanh(bh * 0.5);
        TwoPort { series, shunt_left: shunt, shunt_right: shunt }
    }

    /// The two-port (the three equivalent springs) of a short stretch of ground of length 2·`half`. `spring` and
    /// `shear` are the coefficients of k(s) and μ(s) in powers of s ∈ \[−1, 1\].
    pub fn varying(spring: &[R], shear: &[R], half: f64) -> Self {
        Pair::new(spring, shear, half).link(shear, half)
    }

    /// The mirrored two-port.
    pub fn mirrored(self) -> Self {
        let TwoPort { series, shunt_left, shunt_right } = self;
        TwoPort { series, shunt_left: shunt_right, shunt_right: shunt_left }
    }

    /// Connects two two-ports in series. The point between them carries no external force.
    pub fn then(self, next: TwoPort<R>) -> Self {
        let outer = self.shunt_right + next.shunt_left;
        let whole = self.series + next.series + outer;
        if whole.value() <= 0.0 {
            return TwoPort { series: R::ZERO, ..self };
        }
        TwoPort {
            series: self.series * (next.series / whole),
            shunt_left: self.shunt_left + self.series * (outer / whole),
            shunt_right: next.shunt_right + next.series * (outer / whole),
        }
    }

    /// The force on the ground at the left point, for given settlements of both points.
    pub fn force_left(&self, left: R, right: R) -> R {
        self.shunt_left * left + self.series * (left - right)
    }

    /// The force on the ground at the right point, for given settlements of both points.
    pub fn force_right(&self, left: R, right: R) -> R {
        self.shunt_right * right + self.series * (right - left)
    }
}

/// Number of terms in the power series of the ground displacement on a stretch of at most two decay lengths √(μ/k). The
/// first omitted term is about 1/20! of the first term.
const SURFACE_TERMS: usize = 20;

/// A coefficient of these power series is neglected if it does not change this number. Then it is below 10⁻²⁰ of the
/// leading coefficient, which is 1, and has no derivatives.
const UNCHANGED: f64 = 1e-4;

/// Returns the coefficients of the ground displacement in powers of s ∈ \[−1, 1\] on a short stretch with varying k and
/// μ. `ends` contains the displacements of both ends.
pub(crate) fn settled<R: Real>(
    spring: &[R],
    shear: &[R],
    half: f64,
    ends: [R; 2],
) -> Coefficients<R> {
    Pair::new(spring, shear, half).between(ends)
}

/// Two solutions of −(μu')' + ku = 0 on a short stretch of ground, as power series in s ∈ \[−1, 1\]: `one` = 1 + O(s²)
/// and `rising` = s + O(s²).
pub(crate) struct Pair<R> {
    one: [R; SURFACE_TERMS],
    rising: [R; SURFACE_TERMS],
}

impl<R: Real> Pair<R> {
    pub fn new(spring: &[R], shear: &[R], half: f64) -> Self {
        let [spring, shear] = [spring, shear].map(trimmed);
        let reach = spring.len().max(shear.len());
        let solution = |first: [R; 2]| {
            let mut c = [R::ZERO; SURFACE_TERMS];
            c[..2].copy_from_slice(&first);
            for j in 0..SURFACE_TERMS - 2 {
                // If all coefficients in the recurrence are negligible, the remaining coefficients are negligible too.
                let used = &c[(j + 1).saturating_sub(reach)..j + 2];
                if used.iter().all(|c| *c + UNCHANGED == UNCHANGED) {
                    break;
                }
                // The coefficient of sʲ in (μu')' = `half`² k u gives c[j + 2]. Primes are derivatives with
                // respect to s.
                let push: R = spring.iter().zip(c[..=j].iter().rev()).map(|(k, c)| *k * *c).sum();
                let mut flux = push * (half * half) / (j + 1) as f64;
                for (i, mu) in shear.iter().enumerate().skip(1).take_while(|(i, _)| *i <= j + 1) {
                    flux -= *mu * (j + 2 - i) as f64 * c[j + 2 - i];
                }
                c[j + 2] = flux / (shear[0] * (j + 2) as f64);
            }
            c
        };
        Pair { one: solution([R::ONE, R::ZERO]), rising: solution([R::ZERO, R::ONE]) }
    }

    /// Returns the factors of `one` and `rising` in the displacement with the given end values, and the determinant of
    /// the equations for these factors. The split into even and odd powers avoids cancellation.
    fn amplitudes(&self, [left, right]: [R; 2]) -> ([R; 2], R) {
        let parts = |c: &[R; SURFACE_TERMS]| {
            let even: R = c.iter().copied().step_by(2).sum();
            let odd: R = c.iter().copied().skip(1).step_by(2).sum();
            [even, odd]
        };
        let ([one, tilt], [lift, rising]) = (parts(&self.one), parts(&self.rising));
        let determinant = (one * rising - tilt * lift) * 2.0;
        let level = rising * (left + right) - lift * (right - left);
        let rise = one * (right - left) - tilt * (left + right);
        ([level / determinant, rise / determinant], determinant)
    }

    /// Returns the power series coefficients of the ground displacement u on the stretch, from the values `ends` of u
    /// at both ends.
    pub fn between(&self, ends: [R; 2]) -> Coefficients<R> {
        let ([level, rise], _) = self.amplitudes(ends);
        self.one.iter().zip(&self.rising).map(|(a, b)| level * *a + rise * *b).collect()
    }

    /// Returns the two-port (the three equivalent springs) of the stretch. The series stiffness is μ times the
    /// Wronskian of `one` and `rising`, a constant, divided by the determinant of `amplitudes`.
    pub fn link(&self, shear: &[R], half: f64) -> TwoPort<R> {
        let ([level, rise], determinant) = self.amplitudes([R::ONE; 2]);
        let [one, rising] = [&self.one, &self.rising].map(|c| ends(&derivative(c)));
        let mu = ends(shear);
        let fluxes = [0, 1].map(|i| (level * one[i] + rise * rising[i]) * mu[i] / half);
        TwoPort {
            series: shear[0] / (determinant * half),
            shunt_left: -fluxes[0],
            shunt_right: fluxes[1],
        }
    }
}

/// Returns the stiffness of the ground outside one end of the beam, condensed to this end. It is √(kμ) if the
/// ground is uniform and infinite.
pub(crate) fn outside<R: Real>(beyond: &GroundOutside<R>) -> R {
    beyond.layers.iter().rev().fold(outermost(beyond), condensed)
}

/// Returns, for each layer outside the beam, the condensed stiffness of this layer and all layers beyond it.
/// The last entry is the stiffness at the outer end of the ground.
fn stiffnesses<R: Real>(beyond: &GroundOutside<R>) -> Vec<R> {
    let mut springs = vec![outermost(beyond)];
    for layer in beyond.layers.iter().rev() {
        springs.push(condensed(springs[springs.len() - 1], layer));
    }
    springs.reverse();
    springs
}

/// Returns the stiffness at the outer end of the ground: infinite if the ground is fixed there, zero otherwise.
fn outermost<R: Real>(beyond: &GroundOutside<R>) -> R {
    R::from(if beyond.held { f64::INFINITY } else { 0.0 })
}

/// Returns the condensed stiffness of a layer and all layers beyond it. `behind` is the condensed stiffness of the
/// layers beyond it.
fn condensed<R: Real>(behind: R, layer: &OutsideLayer<R>) -> R {
    if layer.length == f64::INFINITY {
        return (layer.subgrade * layer.shear_layer).sqrt();
    }
    let link = TwoPort::uniform(layer.subgrade, layer.shear_layer, layer.length);
    link.shunt_left + link.series * (R::ONE - follows(&link, behind))
}

/// Returns the ground displacement at the right end of a two-port if the displacement at its left end is 1. The right
/// end rests on a spring of stiffness `spring`.
fn follows<R: Real>(link: &TwoPort<R>, spring: R) -> R {
    if spring.value() == f64::INFINITY {
        return R::ZERO;
    }
    link.series / (link.series + (link.shunt_right + spring))
}

/// Returns the ground displacement at a distance from the beam's end, from its value `u` at this end.
pub(crate) fn beside<R: Real>(beyond: &GroundOutside<R>, mut u: R, mut distance: f64) -> R {
    let springs = stiffnesses(beyond);
    for (layer, &spring) in beyond.layers.iter().zip(&springs[1..]) {
        let b = (layer.subgrade / layer.shear_layer).sqrt();
        if layer.length == f64::INFINITY {
            return u * exp(-b * distance);
        }
        let link = TwoPort::uniform(layer.subgrade, layer.shear_layer, layer.length);
        let next = u * follows(&link, spring);
        // The tolerance allows for rounding error in the position of the layer's outer end.
        if distance <= layer.length * (1.0 + 8.0 * f64::EPSILON) {
            return between(u, next, b * layer.length, (distance / layer.length).min(1.0));
        }
        (u, distance) = (next, distance - layer.length);
    }
    R::ZERO
}

/// Length of the pieces into which ground out of contact is divided, in decay lengths √(μ/k). On such a piece, a
/// polynomial represents the ground displacement to rounding error.
pub(crate) const PIECE: f64 = 2.0;
/// Farther than this many decay lengths √(μ/k) from both ends of a stretch of ground without contact, the ground
/// displacement counts as zero, because e⁻⁴⁰ is below rounding error.
const FAR: f64 = 40.0;

/// Adds to `cuts` the positions at which a stretch of ground without contact is divided near both ends of the stretch,
/// where the surface of the ground is curved.
pub(crate) fn cut([from, to]: [f64; 2], decay: f64, cuts: &mut Vec<f64>) {
    let reach = (FAR * decay).min(to - from);
    let mut step = PIECE * decay;
    while step < reach {
        cuts.extend([from + step, to - step]);
        step += PIECE * decay;
    }
    cuts.extend([from + reach, to - reach]);
}

/// Returns the ground displacement at the fraction `t` of an unloaded uniform stretch, from its values at both ends.
/// The unit of `length` is the decay length √(μ/k).
pub(crate) fn between<R: Real>(left: R, right: R, length: R, t: f64) -> R {
    sinh_ratio(length, 1.0 - t) * left + sinh_ratio(length, t) * right
}

/// Returns the slope of the ground displacement, divided by √(k/μ), at the fraction `t` of an unloaded uniform stretch.
/// The unit of `length` is the decay length √(μ/k).
pub(crate) fn slope_between<R: Real>(left: R, right: R, length: R, t: f64) -> R {
    // With z = `length`, the result is (right·cosh(t·z) − left·cosh((1 − t)·z))/sinh z. The formula for z < 1 has no
    // cancellation if `left` and `right` are equal.
    let series = exp(-length) * 2.0 / -expm1(length * -2.0);
    let cosh_less_one = |z: R| power(sinh(z * 0.5), 2) * 2.0;
    if length.value() < 1.0 {
        series
            * ((right - left) + right * cosh_less_one(length * t)
                - left * cosh_less_one(length * (1.0 - t)))
    } else {
        let cosh_ratio =
            |r: f64| (exp(length * -(1.0 - r)) + exp(length * -(1.0 + r))) / -expm1(length * -2.0);
        cosh_ratio(t) * right - cosh_ratio(1.0 - t) * left
    }
}

/// Returns sinh(r·z)/sinh(z) for 0 ≤ r ≤ 1 and any z > 0, without overflow.
fn sinh_ratio<R: Real>(z: R, r: f64) -> R {
    exp(z * -(1.0 - r)) * expm1(z * (-2.0 * r)) / expm1(z * -2.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::elementary::cosh;
    use crate::numeric::polynomial::value;

    #[test]
    fn two_halves_in_series_equal_the_whole() {
        for bh in [1e-9, 1e-3, 1.0, 30.0, 700.0] {
            let whole = TwoPort::uniform(2.0, 0.5, bh);
            let parts =
                TwoPort::uniform(2.0, 0.5, 0.3 * bh).then(TwoPort::uniform(2.0, 0.5, 0.7 * bh));
            for (a, b) in [
                (whole.series, parts.series),
                (whole.shunt_left, parts.shunt_left),
                (whole.shunt_right, parts.shunt_right),
            ] {
                // The relative rounding error of exp(−bh) is proportional to bh.
                assert!((a - b).abs() <= 4e-16 * (4.0 + 2.0 * bh) * a, "{bh}: {a} {b}");
            }
        }
    }

    #[test]
    fn constant_data_give_the_closed_form() {
        let (k, mu, half) = (3.0, 0.7, 0.4);
        let [uniform, series] =
            [TwoPort::uniform(k, mu, 2.0 * half), TwoPort::varying(&[k], &[mu], half)];
        assert!((uniform.series / series.series - 1.0).abs() < 1e-15);
        assert!((uniform.shunt_left / series.shunt_left - 1.0).abs() < 1e-15);
        assert!((uniform.shunt_left / series.shunt_right - 1.0).abs() < 1e-15);
    }

    #[test]
    fn ground_whose_solution_is_a_power_of_x() {
        // For μ = x² and k = 6, the equation −(x²u')' + 6u = 0 has the solutions x² and x⁻³. The middle of the
        // stretch is at x = 5, and its half-length is ½.
        let (middle, half) = (5.0, 0.5);
        let shear = [middle * middle, 2.0 * middle * half, half * half];
        let ends = [4.5_f64, 5.5];
        let (a, b) = (0.3, -20.0);
        let exact = |x: f64| a * x * x + b / (x * x * x);
        let flux = |x: f64| x * x * (2.0 * a * x - 3.0 * b / power(x, 4));
        let held = ends.map(exact);
        let u = settled(&[6.0], &shear, half, held);
        for s in [-1.0, -0.4, 0.0, 0.8] {
            assert!((value(&u, s) - exact(middle + half * s)).abs() < 1e-14);
        }
        let link = TwoPort::varying(&[6.0], &shear, half);
        assert!((link.force_left(held[0], held[1]) + flux(4.5)).abs() < 1e-12);
        assert!((link.force_right(held[0], held[1]) - flux(5.5)).abs() < 1e-12);
    }

    #[test]
    fn ground_beside_the_beam_is_one_spring() {
        let layer = |length: f64, spring: f64, shear: f64| OutsideLayer {
            length,
            subgrade: spring,
            shear_layer: shear,
        };
        let spring = |layers: &[OutsideLayer], held: bool| {
            outside(&GroundOutside { layers: layers.to_vec(), held })
        };
        let (k, mu, h) = (3.0_f64, 0.7_f64, 0.9);
        let (stiffness, bh) = ((k * mu).sqrt(), (k / mu).sqrt() * h);
        let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-15, "{a} {b}");
        near(spring(&[layer(h, k, mu)], false), stiffness * tanh(bh));
        near(spring(&[layer(h, k, mu)], true), stiffness / tanh(bh));
        // Dividing the ground outside the beam into two stretches with equal k and μ does not change its
        // stiffness.
        let cut = [layer(0.3, k, mu), layer(f64::INFINITY, k, mu)];
        near(spring(&cut, false), stiffness);
        let cut = [layer(0.3, k, mu), layer(0.6, k, mu)];
        near(spring(&cut, false), stiffness * tanh(bh));
        assert_eq!(spring(&[], false), 0.0);
        let free = GroundOutside { layers: cut.to_vec(), held: false };
        for x in [0.0, 0.2, 0.3, 0.7, 0.9] {
            let exact = 2.0 * cosh(bh * (1.0 - x / h)) / cosh(bh);
            near(beside(&free, 2.0, x), exact);
        }
        assert_eq!(beside(&free, 2.0, 0.91), 0.0);
    }

    #[test]
    fn a_two_port_satisfies_the_differential_equation() {
        let (k, mu, h) = (3.0, 0.7, 0.9);
        let link = TwoPort::uniform(k, mu, h);
        let b = f64::sqrt(k / mu);
        let slope = b * slope_between(0.4, -0.2, b * h, 0.0);
        assert!((link.force_left(0.4, -0.2) + mu * slope).abs() < 1e-15);
        let middle = between(0.4, -0.2, b * h, 0.5);
        let exact = 0.1 / cosh(0.5 * b * h);
        assert!((middle - exact).abs() < 1e-16);
    }
}
