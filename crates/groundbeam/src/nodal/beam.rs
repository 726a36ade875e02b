//! Stiffness, load vector and deflection of a uniform beam element off the ground, in closed form.
//!
//! The deflection satisfies EI w⁗ − P w″ = f − g' with the distributed force f, the distributed moment g and the axial
//! force P. For an element of length h, with x = h s and t = P h²/EI, the solutions are
//!
//! w = w₀ + hθ₀ s + A s²c₂ + B s³c₃ + F₀ s⁴c₄ + F₁ s⁵c₅, cₙ = Σ (t s²)ⁱ/(2i + n)!.
//!
//! w₀ and θ₀ are the deflection and the rotation at the left end. A and B are constants of integration. F₀ is
//! (f − g')h⁴/EI at the left end, and F₁ is the change of this term over the element.

use crate::element::element::Element;
use crate::mesh::cell::Cell;

/// Maximum length of an element relative to √(EI/P), with the magnitude P of the axial force.
pub(crate) const LONGEST_ELEMENT: f64 = 1.0;

/// Number of coefficients of the power series of the deflection in s ∈ \[0, 1\] along an element. The first omitted
/// term is less than 1/18! times the sum of the series.
pub(crate) const NODAL_TERMS: usize = 18;

/// A coefficient of the power series of the deflection w(s) is omitted if it is below this fraction of the larger of
/// the coefficients of s² and s³.
const NEGLIGIBLE_TERM: f64 = 1e-17;

/// A uniform beam element and the loads on it.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Beam {
    /// Length h.
    pub length: f64,
    /// EI/h³.
    stiffness: f64,
    /// Dimensionless axial force t = P h²/EI, with the axial force P and the element length h.
    t: f64,
    /// Axial force divided by the element length, P/h.
    tension: f64,
    /// The functions c₀ … c₅ in the [formula of the deflection](self), evaluated at the right end of the element.
    c: [f64; 6],
    /// Determinant c₂² − c₁c₃ of the equations A c₂ + B c₃ = x and A c₁ + B c₂ = y for the constants of integration A
    /// and B.
    determinant: f64,
    /// Load terms F₀ and F₁ in the [formula of the deflection](self).
    load: [f64; 2],
    /// Resultant ∫f dx of the distributed force f on the element.
    force: f64,
    /// Moment ∫(f x + g) dx of the distributed force f and the distributed moment g about the left end of the element,
    /// divided by the element length.
    turn: f64,
    /// Distributed moment g at the right end of the element.
    moment_right: f64,
    /// Contribution of the imposed curvature κ₀ to the last two entries of the load vector.
    curling: [f64; 2],
}

impl Beam {
    /// Creates an element from its bending stiffness EI, its distributed loads and imposed curvature, the axial force
    /// P and its length h.
    pub fn new(bending: f64, given: &Given, axial_force: f64, h: f64) -> Self {
        let stiffness = bending / (h * h * h);
        let tension = axial_force / h;
        let t = tension / stiffness;
        let (mut c4, mut c5) = (1.0_f64 / 24.0, 1.0_f64 / 120.0);
        let (mut even, mut odd) = (c4, c5);
        let mut n = 4.0;
        while even.abs() > 1e-20 * c4 && t != 0.0 {
            even *= t / ((n + 1.0) * (n + 2.0));
            odd *= t / ((n + 2.0) * (n + 3.0));
            (c4, c5, n) = (c4 + even, c5 + odd, n + 2.0);
        }
        let (c2, c3) = (0.5 + t * c4, 1.0 / 6.0 + t * c5);
        let (c0, c1) = (1.0 + t * c2, 1.0 + t * c3);
        let ([f, f_right], [g, g_right]) = (given.load, given.moment_load);
        let [left, right] = given.curvature;
        Beam {
            length: h,
            stiffness,
            t,
            tension,
            c: [c0, c1, c2, c3, c4, c5],
            determinant: c2 * c2 - c1 * c3,
            load: [(f - (g_right - g) / h) * h / stiffness, (f_right - f) * h / stiffness],
            force: 0.5 * h * (f + f_right),
            turn: h * (f / 6.0 + f_right / 3.0) + 0.5 * (g + g_right),
            moment_right: g_right,
            curling: [left - right, right].map(|curvature| bending * curvature / h),
        }
    }

    /// Stiffness matrix for (hθ, d₁, h d₂), given by its entries θθ, θ1, θ2, 11, 12 and 22. h is the element length. θ,
    /// d₁ and d₂ are the unknowns of [`Element`] without w.
    pub fn stiffness(&self) -> [f64; 6] {
        let e = self.stiffness / self.determinant;
        let [_, c1, c2, c3, ..] = self.c;
        [self.tension, self.tension, 0.0, e * c1, -e * c2, e * (c2 - c3)]
    }

    /// Load vector q for v = (w, hθ, d₁, h d₂), with the unknowns (w, θ, d₁, d₂) of [`Element`] and the element length
    /// h. The energy is ½vᵀKv − qᵀv with the stiffness matrix K.
    pub fn load(&self) -> [f64; 4] {
        let [c0, c1, c2, c3, c4, c5] = self.c;
        let [f0, f1] = self.load;
        let [a, b] = self.bends(-(f0 * c4 + f1 * c5), -(f0 * c3 + f1 * c4));
        let bend = a * c0 + b * c1 + f0 * c2 + f1 * c3;
        let third = self.t * a * c1 + b * c0 + f0 * c1 + f1 * c2;
        let e = self.stiffness;
        let [first, second] = self.curling;
        let shear = e * third + self.moment_right + first;
        [self.force, self.turn, shear, -e * bend + second]
    }

    /// Returns the element with its stiffness matrix and load vector for the variables (w, θ, d₁, d₂) of [`Element`].
    pub fn element(&self) -> Element {
        let h = self.length;
        let [tt, t1, t2, k11, k12, k22] = self.stiffness();
        let [qw, qt, q1, q2] = self.load();
        Element {
            length: h,
            stiffness: [
                [0.0; 4],
                [0.0, tt * h * h, t1 * h, t2 * h * h],
                [0.0, t1 * h, k11, k12 * h],
                [0.0, t2 * h * h, k12 * h, k22 * h * h],
            ],
            load: [qw, qt * h, q1, q2 * h],
            ..Element::default()
        }
    }

    /// Computes the constants of integration A and B from A c₂ + B c₃ = x and A c₁ + B c₂ = y, with the series values
    /// c₁, c₂ and c₃ of the [deflection](self).
    fn bends(&self, x: f64, y: f64) -> [f64; 2] {
        let [_, c1, c2, c3, ..] = self.c;
        [(x * c2 - y * c3) / self.determinant, (y * c2 - x * c1) / self.determinant]
    }

    /// Computes the coefficients of the deflection in powers of s ∈ \[0, 1\], from the unknowns (w, θ, d₁, d₂) of
    /// [`Element`]. Also returns the number of significant coefficients.
    pub fn unfold(&self, [w, theta, d1, d2]: [f64; 4]) -> ([f64; NODAL_TERMS], usize) {
        let [_, _, _, c3, c4, c5] = self.c;
        let ([f0, f1], h) = (self.load, self.length);
        let [a, b] = self.bends(d1 - (f0 * c4 + f1 * c5), h * d2 - (f0 * c3 + f1 * c4));
        let mut c = [0.0; NODAL_TERMS];
        (c[0], c[1], c[2], c[3]) = (w, h * theta, 0.5 * a, b / 6.0);
        (c[4], c[5]) = ((self.t * a + f0) / 24.0, (self.t * b + f1) / 120.0);
        let mut known = if c[4] == 0.0 && c[5] == 0.0 { 4 } else { 6 };
        if self.t != 0.0 {
            let least = NEGLIGIBLE_TERM * c[2].abs().max(c[3].abs());
            known = 6;
            while known < NODAL_TERMS && c[known - 2].abs().max(c[known - 1].abs()) > least {
                for j in [known, known + 1] {
                    c[j] = c[j - 2] * self.t / (j * (j - 1)) as f64;
                }
                known += 2;
            }
        }
        (c, known)
    }
}

/// Distributed loads and imposed curvature along a stretch, linear between its two ends.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Given {
    /// Distributed force f, distributed moment g and imposed curvature κ₀, each at both ends.
    pub load: [f64; 2],
    pub moment_load: [f64; 2],
    pub curvature: [f64; 2],
}

impl Given {
    pub fn of(cell: &Cell) -> Self {
        Given { load: cell.load, moment_load: cell.moment_load, curvature: cell.curvature }
    }

    pub fn is_even(&self) -> bool {
        let all = [self.load, self.moment_load, self.curvature];
        all.iter().all(|v| v[0] == v[1])
    }

    /// Returns the loads and the imposed curvature on the part of the stretch from the fraction `a` to the fraction
    /// `b` of its length.
    pub fn part(&self, [a, b]: [f64; 2]) -> Self {
        let linear = |v: [f64; 2]| [a, b].map(|t| v[0] + (v[1] - v[0]) * t);
        Given {
            load: linear(self.load),
            moment_load: linear(self.moment_load),
            curvature: linear(self.curvature),
        }
    }

    /// Mirror image of the stretch, in which the two ends are exchanged and the distributed moment g changes sign.
    pub fn mirrored(&self) -> Self {
        let turned = |[a, b]: [f64; 2]| [b, a];
        Given {
            load: turned(self.load),
            moment_load: turned(self.moment_load).map(|g| -g),
            curvature: turned(self.curvature),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::ExactElement;
    use crate::element::operator::{Operator, ZoneKind};
    use crate::mesh::cell::Cell;
    use crate::mesh::cell::Varies;
    use crate::numeric::polynomial::value;

    /// The closed form of an element agrees with the element that is computed by power series.
    #[test]
    fn the_closed_form_agrees_with_the_power_series() {
        let h = 0.7;
        let cell = Cell {
            beam_shear: None,
            x: [0.0, h],
            stiffness: 2.0,
            subgrade: 1.0,
            shear_layer: 1.0,
            varies: Varies::default(),
            load: [0.3, -0.8],
            moment_load: [0.5, 0.1],
            curvature: [0.2, -0.3],
            gap: [0.0; 2],
            gap_slope: 0.0,
            ground_load: [0.0; 2],
            homogeneous_field: [0.0; 2],
            ground_force: 0.0,
        };
        let Cell { load, moment_load, curvature, .. } = cell;
        let given = Given { load, moment_load, curvature };
        for tension in [0.0, 1e-3, 3.9] {
            let beam = Beam::new(2.0, &given, tension, h);
            let exact = ExactElement::new(&Operator::of(&cell, tension, ZoneKind::Open), h);
            let (k, q) = (beam.stiffness(), beam.load());
            let scale = [1.0, h, 1.0, h];
            let at = |i: usize, j: usize| exact.element.stiffness[i][j] / (scale[i] * scale[j]);
            let expected = [at(1, 1), at(1, 2), at(1, 3), at(2, 2), at(2, 3), at(3, 3)];
            for (k, expected) in k.iter().zip(expected) {
                assert!((k - expected).abs() < 1e-12 * at(2, 2), "{k} {expected}");
            }
            for i in 0..4 {
                let expected = exact.element.load[i] / scale[i];
                assert!((q[i] - expected).abs() < 1e-14, "{i}: {} {expected}", q[i]);
            }
            let v = [0.3, -0.2, 0.05, 0.4];
            let ((ours, _), (theirs, _)) = (beam.unfold(v), exact.unfold(&v));
            for s in [0.0, 0.3, 1.0] {
                let expected = value(&theirs, 2.0 * s - 1.0);
                assert!((value(&ours, s) - expected).abs() < 1e-15, "{s}");
            }
        }
    }
}
