//! Computes boundary layers of elements whose tension dominates bending, from the larger root of the characteristic equation.
//!
//! The deflection is a slow part, which is a power series, plus the layers cosh(r₂x) and sinh(r₂x) of the larger root
//! r₂. So an element can be as long as the slow wave. See *Boundary layers* in `docs/methods.md`.

use crate::element::element::LONGEST_SERIES;
use crate::element::operator::Operator;
use crate::numeric::elementary::exp;
use crate::numeric::polynomial::TERMS;
use crate::numeric::real::Real;

/// Two real roots r₁ and r₂ of the characteristic equation of an element. They are so far apart that the larger root r₂
/// gives boundary layers: r₂² ≥ `APART` r₁².
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Layers<R = f64> {
    /// Square r₁² of the smaller root r₁ of the characteristic equation \[1/m²\].
    pub slow_squared: R,
    /// Larger root r₂ of the characteristic equation \[1/m\].
    pub fast: R,
}

const APART: f64 = 100.0;

/// Depth of a boundary layer in units of 1/r₂, where r₂ is the larger root of the characteristic equation. At this
/// depth, the layer has decayed to e⁻⁴⁰, which is below rounding error.
const LAYER: f64 = 40.0;

impl<R: Real> Layers<R> {
    /// Returns the characteristic roots of an element with separate boundary layers, otherwise `None`. Variable
    /// coefficients and shear deformation exclude such layers.
    pub fn of(operator: &Operator<R>, length: f64) -> Option<Self> {
        let n = operator.tension / operator.stiffness;
        let k = operator.subgrade / operator.stiffness;
        if operator.polynomials.is_some() || n.value() <= 0.0 || (n * n).value() < 4.0 * k.value() {
            return None;
        }
        let fast_squared = (n + (n * n - k * 4.0).sqrt()) * 0.5;
        let layers = Layers { slow_squared: k / fast_squared, fast: fast_squared.sqrt() };
        let wanted = layers.fast.value() * length > LONGEST_SERIES
            && fast_squared.value() >= APART * layers.slow_squared.value();
        wanted.then_some(layers)
    }

    /// Computes the slow parts of three even (`PARITY` 0) or odd (1) solutions: a homogeneous solution, a boundary
    /// layer (zero), and the solution for the load EI · `push`, times s if odd.
    pub(super) fn slow<const PARITY: usize>(self, a: f64, push: R) -> [[R; TERMS / 2]; 3] {
        let ratio = self.slow_squared * a * a;
        let series = |first: R, load: R| {
            let mut c = [R::ZERO; TERMS / 2];
            c[0] = first;
            for i in 0..TERMS / 2 - 1 {
                let j = (2 * i + PARITY) as f64;
                let load = if i == 0 { load } else { R::ZERO };
                c[i + 1] = (ratio * c[i] + load) / ((j + 2.0) * (j + 1.0));
            }
            c
        };
        let load = -push * a * a / (self.fast * self.fast);
        [series(R::ONE, R::ZERO), [R::ZERO; TERMS / 2], series(R::ZERO, load)]
    }

    /// Returns the positions at which an element with the ends `x` is cut, so that a short power series represents the
    /// boundary layers on each piece.
    pub fn cuts(&self, x: [f64; 2], heights: [R; 2]) -> Vec<f64> {
        let (length, fast) = (x[1] - x[0], self.fast.value());
        let mut from_end = Vec::new();
        let mut depth = 0.0;
        while depth < LAYER {
            // The amplitude of a boundary layer decreases with the depth, so deeper pieces can be longer.
            depth += LONGEST_SERIES * exp(depth / 24.0);
            from_end.push(depth / fast);
        }
        let mut cuts = Vec::new();
        if heights[0] != 0.0 {
            cuts.extend(from_end.iter().filter(|d| **d < length).map(|d| x[0] + d));
        }
        if heights[1] != 0.0 {
            cuts.extend(from_end.iter().filter(|d| **d < length).map(|d| x[1] - d));
        }
        cuts.sort_by(f64::total_cmp);
        let near = 0.125 * LONGEST_SERIES / fast;
        cuts.dedup_by(|b, a| *b - *a < near);
        cuts
    }

    /// Adds the boundary layers of an element with the ends `x` to the coefficients `c` of w on its part `piece`.
    /// `heights` contains the amplitudes of the layers.
    pub fn add(&self, x: [f64; 2], heights: [R; 2], piece: [f64; 2], c: &mut [R]) {
        let half = 0.5 * (piece[1] - piece[0]);
        let ends = [piece[0] - x[0], x[1] - piece[1]];
        for (height, distance, sign) in [(heights[0], ends[0], -1.0), (heights[1], ends[1], 1.0)] {
            // Beyond the distance `LAYER`/`fast` from its end, a boundary layer is below rounding error.
            if height == 0.0 || self.fast.value() * distance > LAYER {
                continue;
            }
            let mut term = height * exp(-self.fast * (distance + half));
            for (j, c) in c.iter_mut().enumerate() {
                *c += term;
                term *= self.fast * sign * half / (j + 1) as f64;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::ExactElement;
    use crate::numeric::elementary::power;
    use crate::numeric::polynomial::{jet, rescale};

    #[test]
    fn an_element_with_boundary_layers_equals_many_short_elements() {
        // The characteristic roots are about 0.03 and 30. The test checks the continuity between the pieces, the
        // differential equation and the end forces.
        let op = Operator {
            stiffness: 1.0,
            tension: 900.0,
            subgrade: 1.0,
            load: [1.0, -2.0],
            moment_load: [0.5, 0.1],
            imposed_moments: [0.0; 2],
            polynomials: None,
        };
        let whole = ExactElement::new(&op, 2.0);
        assert!(whole.layers().is_some());
        let v = [0.3, -0.2, 0.0, 0.2];
        let (series, heights) = whole.unfold(&v);
        let at = |x: [f64; 2]| {
            let (middle, half) = (0.5 * (x[0] + x[1]) - 1.0, 0.5 * (x[1] - x[0]));
            let mut c = rescale(&series, middle, half);
            whole.layers().expect("layers").add([0.0, 2.0], heights, x, &mut c);
            c
        };
        let mut x = vec![0.0];
        x.extend(whole.layers().expect("layers").cuts([0.0, 2.0], heights));
        x.push(2.0);
        assert!(x.len() < 30);
        let mut before: Option<[f64; 4]> = None;
        for pair in x.windows(2) {
            let half = 0.5 * (pair[1] - pair[0]);
            let c = at([pair[0], pair[1]]);
            let unit =
                |j: [f64; 4]| [j[0], j[1] / half, j[2] / power(half, 2), j[3] / power(half, 3)];
            let [left, right] = [unit(jet(&c, -1.0)), unit(jet(&c, 1.0))];
            if let Some(before) = before {
                for (i, (a, b)) in before.iter().zip(&left).enumerate() {
                    assert!((a - b).abs() < 1e-13 * power(30.0, i), "{i}: {a} {b}");
                }
            }
            before = Some(right);
            // Checks the differential equation in the middle of a piece of the element.
            let middle = 0.5 * (pair[0] + pair[1]);
            let load = 1.0 - 1.5 * middle - (-0.2);
            let fourth = 24.0 * c[4] / power(half, 4);
            let rest = fourth - 900.0 * 2.0 * c[2] / power(half, 2) + c[0] - load;
            assert!(rest.abs() < 1e-9 * (fourth.abs() + 900.0), "{pair:?} {rest} {fourth}");
        }
        let ends = [at([x[0], x[1]]), at([x[x.len() - 2], 2.0])];
        let halves = [0.5 * (x[1] - x[0]), 0.5 * (2.0 - x[x.len() - 2])];
        let [left, right] = [jet(&ends[0], -1.0), jet(&ends[1], 1.0)];
        assert!((left[0] - 0.3).abs() < 1e-15 && (left[1] / halves[0] + 0.2).abs() < 1e-13);
        assert!((right[0] - 0.0).abs() < 1e-15 && (right[1] / halves[1] - 0.2).abs() < 1e-13);
        // Checks the vertical force −EI w‴ + N w' − G and the moment EI w″ at the ends of the element, where N is the
        // tension and G the distributed moment load.
        let f = whole.element.forces(&v);
        let total = |j: [f64; 4], h: f64, g: f64| -j[3] / power(h, 3) + 900.0 * j[1] / h - g;
        let t = [total(left, halves[0], 0.5), total(right, halves[1], 0.1)];
        assert!((f[2] - t[1]).abs() < 1e-13 * t[1].abs(), "{} {}", f[2], t[1]);
        assert!((f[0] + t[0]).abs() < 1e-13 * t[0].abs(), "{} {t:?}", f[0]);
        assert!((f[3] - right[2] / power(halves[1], 2)).abs() < 1e-13 * f[3].abs());
        assert!((f[1] + left[2] / power(halves[0], 2)).abs() < 1e-13 * f[1].abs());
    }
}
