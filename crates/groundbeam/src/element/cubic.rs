//! The cubic element of Kikuchi (5.1), (5.2), on ξ ∈ \[0, 1\] (the paper's x in (5.2)).
//!
//! In element deformations w = w_left + θ_left h ξ + d₁ N₂(ξ) + d₂ M₂(ξ), since a rigid motion is
//! reproduced by N₁ + N₂ = 1 and M₁ + M₂ + h N₂ = h ξ.

use crate::element::element::Element;
use crate::mesh::cell::Cell;
use crate::numeric::polynomial::value;

/// Coefficients of a cubic.
pub(crate) const TERMS: usize = 4;

/// Gauss points and weights on \[−1, 1\] that integrate products of cubics exactly.
pub(crate) const GAUSS: [(f64, f64); 4] = [
    (-0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
    (-0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
];

/// Gauss points and weights that integrate the product of two cubics and a square exactly.
const FINER_GAUSS: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_08),
];

/// N₁, M₁, N₂, M₂ of (5.2) at ξ, on an element of length h.
pub(crate) fn shape(xi: f64, h: f64) -> [f64; 4] {
    let rest = 1.0 - xi;
    [
        rest * rest * (1.0 + 2.0 * xi),
        h * xi * rest * rest,
        xi * xi * (3.0 - 2.0 * xi),
        -h * xi * xi * rest,
    ]
}

/// The coefficients of (w_left, θ_left, d₁, d₂) in w at ξ.
pub(crate) fn deflection(xi: f64, h: f64) -> [f64; 4] {
    let [_, _, n2, m2] = shape(xi, h);
    [1.0, h * xi, n2, m2]
}

/// The coefficients of (w_left, θ_left, d₁, d₂) in w' at ξ.
pub(crate) fn slope(xi: f64, h: f64) -> [f64; 4] {
    [0.0, 1.0, 6.0 * xi * (1.0 - xi) / h, xi * (3.0 * xi - 2.0)]
}

/// The coefficients of (w_left, θ_left, d₁, d₂) in w″ at ξ.
fn curvature(xi: f64, h: f64) -> [f64; 4] {
    [0.0, 0.0, 6.0 * (1.0 - 2.0 * xi) / (h * h), (6.0 * xi - 2.0) / h]
}

/// Bending, axial force and loads: K and F of (5.4). The ground is added by [`add_ground`].
pub(crate) fn element(cell: &Cell, axial_force: f64) -> Element {
    let h = cell.length();
    let e = cell.stiffness / h;
    let mut element = Element { length: h, ..Element::default() };
    if cell.beam_varies() {
        add_bending(&mut element, cell);
    } else {
        element.stiffness[2][2] = 12.0 * e / (h * h);
        element.stiffness[2][3] = -6.0 * e / h;
        element.stiffness[3][2] = -6.0 * e / h;
        element.stiffness[3][3] = 4.0 * e;
    }
    let all = Spread {
        spring: |_| 0.0,
        tension: |_| axial_force,
        load: |s| between(cell.load, s),
        moment_load: |s| between(cell.moment_load, s),
    };
    add(&mut element, &GAUSS, cell, [-1.0, 1.0], &all);
    add_curvature(&mut element, cell);
    element
}

/// ½∫EI w″² for varying EI: degree 5 times two linear curvatures, exact with four points.
fn add_bending(element: &mut Element, cell: &Cell) {
    let h = cell.length();
    let stiffness = cell.stiffness_along();
    for (s, weight) in GAUSS {
        let bend = curvature(0.5 * (1.0 + s), h);
        let weight = 0.5 * weight * h * value(&stiffness, s);
        for i in 2..4 {
            for j in 2..4 {
                element.stiffness[i][j] += weight * bend[i] * bend[j];
            }
        }
    }
}

/// ∫EI κ₀ w″: degree 5 + 1 + 1 at most, exact with four points.
fn add_curvature(element: &mut Element, cell: &Cell) {
    if !cell.has_imposed_curvature() {
        return;
    }
    let h = cell.length();
    let stiffness = cell.stiffness_along();
    for (s, weight) in GAUSS {
        let bend = curvature(0.5 * (1.0 + s), h);
        let moment = 0.5 * weight * h * value(&stiffness, s) * between(cell.curvature, s);
        for i in 2..4 {
            element.load[i] += moment * bend[i];
        }
    }
}

/// Linear between the values at both ends.
fn between(ends: [f64; 2], s: f64) -> f64 {
    ends[0] + (ends[1] - ends[0]) * (0.5 * (1.0 + s))
}

/// The energy of the ground where beam and ground are in contact, from s = `from` to `to` (in \[−1, 1\]):
/// ½∫(k ψ² + μ ψ'²) with ψ = w − g₀.
pub(crate) fn add_ground(element: &mut Element, cell: &Cell, [from, to]: [f64; 2]) {
    if cell.ground_varies() {
        let [spring, shear] = [cell.subgrade_along(), cell.shear_layer_along()];
        let all = Spread {
            spring: |s| value(&spring, s),
            tension: |s| value(&shear, s),
            load: |s| value(&spring, s) * between(cell.gap, s),
            moment_load: |s| value(&shear, s) * cell.gap_slope,
        };
        return add(element, &FINER_GAUSS, cell, [from, to], &all);
    }
    let load = cell.gap.map(|g| cell.subgrade * g);
    let all = Spread {
        spring: |_| cell.subgrade,
        tension: |_| cell.shear_layer,
        load: |s| between(load, s),
        moment_load: |_| cell.shear_layer * cell.gap_slope,
    };
    add(element, &GAUSS, cell, [from, to], &all);
}

/// κ, N, F and G as functions of s.
struct Spread<K, N, F, G> {
    spring: K,
    tension: N,
    load: F,
    moment_load: G,
}

/// ½∫(κ w² + N w'²) − ∫(F w + G w') over a part of the element.
fn add<K, N, F, G>(
    element: &mut Element,
    gauss: &[(f64, f64)],
    cell: &Cell,
    [from, to]: [f64; 2],
    all: &Spread<K, N, F, G>,
) where
    K: Fn(f64) -> f64,
    N: Fn(f64) -> f64,
    F: Fn(f64) -> f64,
    G: Fn(f64) -> f64,
{
    let h = cell.length();
    for &(point, weight) in gauss {
        let s = 0.5 * ((to - from) * point + (to + from));
        let xi = 0.5 * (1.0 + s);
        let weight = 0.25 * weight * (to - from) * h;
        let [z, dz] = [deflection(xi, h), slope(xi, h)];
        let (spring, tension) = ((all.spring)(s), (all.tension)(s));
        let (f, g) = ((all.load)(s), (all.moment_load)(s));
        for i in 0..4 {
            element.load[i] += weight * (f * z[i] + g * dz[i]);
            for j in 0..4 {
                element.stiffness[i][j] +=
                    weight * (spring * z[i] * z[j] + tension * dz[i] * dz[j]);
            }
        }
    }
}

/// Adds ∫ p z over a part of the element, for each of its four functions z. p(s) is a cubic, or of degree 5
/// where the ground varies.
pub(crate) fn add_work(work: &mut [f64; 4], h: f64, [from, to]: [f64; 2], pressure: &[f64]) {
    let gauss: &[(f64, f64)] = if pressure.len() > TERMS { &FINER_GAUSS } else { &GAUSS };
    for &(point, weight) in gauss {
        let s = 0.5 * ((to - from) * point + (to + from));
        let p = 0.25 * weight * (to - from) * h * value(pressure, s);
        for (work, z) in work.iter_mut().zip(deflection(0.5 * (1.0 + s), h)) {
            *work += p * z;
        }
    }
}

/// The coefficients of w(s), s ∈ \[−1, 1\], for v = (w_left, θ_left, d₁, d₂).
pub(crate) fn unfold(v: &[f64; 4], h: f64) -> [f64; TERMS] {
    let [w, theta, d1, d2] = *v;
    // N₂ = (2 + 3s − s³)/4, M₂ = h (s³ + s² − s − 1)/8.
    let bend = 0.125 * h * d2;
    [
        w + 0.5 * h * theta + 0.5 * d1 - bend,
        0.5 * h * theta + 0.75 * d1 - bend,
        bend,
        bend - 0.25 * d1,
    ]
}

/// (w_left, θ_left, d₁, d₂) of a cubic with coefficients `c`: the inverse of [`unfold`].
pub(crate) fn fold(c: &[f64], h: f64) -> [f64; 4] {
    let [w, slope, ..] = crate::numeric::polynomial::jet(c, -1.0);
    [w, 2.0 * slope / h, 4.0 * (c[2] - c[3]), 8.0 * c[2] / h]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::cell::Varies;

    #[test]
    fn shape_functions_reproduce_rigid_motions() {
        let h = 0.7;
        for xi in [0.0, 0.2, 0.5, 1.0] {
            let [n1, m1, n2, m2] = shape(xi, h);
            assert!((n1 + n2 - 1.0).abs() < 1e-15);
            assert!((m1 + m2 + h * n2 - h * xi).abs() < 1e-15);
        }
    }

    #[test]
    fn unfolding_is_interpolation() {
        let (h, v) = (0.7, [0.3, -1.2, 0.4, 0.9]);
        let c = unfold(&v, h);
        for xi in [0.0, 0.3, 1.0] {
            let z = deflection(xi, h);
            let w: f64 = z.iter().zip(v).map(|(z, v)| z * v).sum();
            assert!((value(&c, 2.0 * xi - 1.0) - w).abs() < 1e-15);
        }
        for (folded, given) in fold(&c, h).iter().zip(v) {
            assert!((folded - given).abs() < 1e-14);
        }
    }

    #[test]
    fn an_even_load_becomes_the_printed_nodal_forces() {
        // Textbook values: f h/2 and ± f h²/12 at the ends.
        let cell = Cell {
            beam_shear: None,
            x: [0.0, 2.0],
            stiffness: 3.0,
            subgrade: 1.0,
            shear_layer: 0.0,
            varies: Varies::default(),
            load: [6.0; 2],
            moment_load: [0.0; 2],
            curvature: [0.0; 2],
            gap: [0.0; 2],
            gap_slope: 0.0,
            ground_load: [0.0; 2],
            homogeneous_field: [0.0; 2],
            ground_force: 0.0,
        };
        let q = element(&cell, 0.0).load;
        // d₁, d₂ carry the force and moment of the right end; the left end carries the difference.
        assert!((q[2] - 6.0).abs() < 1e-14 && (q[3] + 2.0).abs() < 1e-14);
        assert!((q[0] - 12.0).abs() < 1e-14 && (q[1] - 12.0).abs() < 1e-14);
    }
}
