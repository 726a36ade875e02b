//! The element whose functions solve EI w⁗ − N w″ + κ w = F − G' themselves, (2.11).
//!
//! About the middle of the element, with half length a and x = x_middle + a s, the equation turns into
//! the recurrence
//!
//! (j+4)(j+3)(j+2)(j+1) c_{j+4} = α (j+2)(j+1) c_{j+2} − β c_j + ρ_j,
//! α = N a²/EI, β = κ a⁴/EI, ρ = (F − G') a⁴/EI,
//!
//! for the coefficients of w = Σ cⱼ sʲ: a power series that converges like 1/j!, whatever the roots of
//! EI r⁴ − N r² + κ are, real, double or complex. Even and odd j do not mix, so the element falls into
//! two problems of two unknowns. No stiffness is found as a difference of large numbers.

use super::{Element, Operator};

/// Coefficients kept. With |r|·length ≤ 2 the first one left out is below 1/20! of the sum.
pub(crate) const TERMS: usize = 20;

/// The longest element, as a multiple of 1/|r|.
pub(crate) const REACH: f64 = 2.0;

/// How many elements a stretch of `length` must be cut into.
pub(crate) fn parts(operator: &Operator, length: f64) -> usize {
    (operator.wave_number() * length / REACH).ceil().max(1.0) as usize
}

/// The element and what is needed to unfold its end values into w(s).
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExactElement {
    pub element: Element,
    even: Half,
    odd: Half,
}

/// One parity: two solutions without load, the one with it, and the map from their amplitudes to the
/// two boundary values of this parity.
#[derive(Debug, Clone, Copy)]
struct Half {
    /// Coefficients c₀, c₂, … or c₁, c₃, … of the two free solutions and the loaded one.
    series: [[f64; TERMS / 2]; 3],
    /// Boundary values of the three.
    boundary: [[f64; 2]; 3],
    /// Boundary forces of the three.
    force: [[f64; 2]; 3],
}

impl ExactElement {
    pub fn new(operator: &Operator, length: f64) -> Self {
        let a = 0.5 * length;
        let ei = operator.stiffness;
        let alpha = operator.tension * a * a / ei;
        let beta = operator.spring * a.powi(4) / ei;
        let mean = |v: [f64; 2]| 0.5 * (v[0] + v[1]);
        let rise = |v: [f64; 2]| 0.5 * (v[1] - v[0]);
        let [force_even, force_odd] = [mean(operator.load), rise(operator.load)];
        let [moment_even, moment_odd] = [mean(operator.moment_load), rise(operator.moment_load)];
        let unit = a.powi(4) / ei;

        // Even: rigid sinking w̄ and bending φ = (θ_right − θ_left)/2.
        let solve_even = |c0, c2, rho| series::<0>(c0, c2, alpha, beta, rho);
        let even = [
            solve_even(1.0, 0.0, 0.0),
            solve_even(0.0, 0.5, 0.0),
            solve_even(0.0, 0.0, (force_even - moment_odd / a) * unit),
        ];
        let even = Half::new(even, |c, loaded| {
            let (mut w, mut slope, mut bend, mut area) = (0.0, 0.0, 0.0, 0.0);
            for (i, &c) in c.iter().enumerate().rev() {
                let j = (2 * i) as f64;
                w += c;
                slope += j * c;
                bend += j * (j - 1.0) * c;
                area += c / (j + 1.0);
            }
            let push = if loaded { force_even } else { 0.0 };
            let sink = 2.0 * a * (operator.spring * area - push);
            ([w, slope / a], [sink, 2.0 * ei * bend / (a * a)])
        });

        // Odd: rigid turning δ = (w_right − w_left)/2 and e = a θ̄ − δ.
        let solve_odd = |c1, c3, rho| series::<1>(c1, c3, alpha, beta, rho);
        let odd = [
            solve_odd(1.0, 0.0, 0.0),
            solve_odd(0.0, 1.0 / 6.0, 0.0),
            solve_odd(0.0, 0.0, force_odd * unit),
        ];
        let odd = Half::new(odd, |c, loaded| {
            let (mut w, mut excess, mut bend, mut first) = (0.0, 0.0, 0.0, 0.0);
            for (i, &c) in c.iter().enumerate().rev() {
                let j = (2 * i + 1) as f64;
                w += c;
                excess += (j - 1.0) * c;
                bend += j * (j - 1.0) * c;
                first += c / (j + 2.0);
            }
            let (push, turn) = if loaded { (force_odd / 3.0, moment_even) } else { (0.0, 0.0) };
            // Virtual work of a rigid turn, so that the large bending terms never enter.
            let turning =
                2.0 * (operator.tension * w / a + operator.spring * first * a - push * a - turn);
            ([w, excess], [turning, 2.0 * ei * bend / (a * a * a)])
        });
        let element = assemble(length, &even.condensed(), &odd.condensed());
        ExactElement { element, even, odd }
    }

    /// The coefficients of w(s) for end values v = (w_left, θ_left, d₁, d₂).
    pub fn unfold(&self, v: &[f64; 4]) -> [f64; TERMS] {
        let a = 0.5 * self.element.length;
        let [w, theta, d1, d2] = *v;
        let even = self.even.unfold([w + (a * theta + 0.5 * d1), 0.5 * d2]);
        let odd = self.odd.unfold([a * theta + 0.5 * d1, 0.5 * (a * d2 - d1)]);
        std::array::from_fn(|j| if j % 2 == 0 { even[j / 2] } else { odd[j / 2] })
    }
}

/// The recurrence for one parity, from its first two coefficients.
fn series<const PARITY: usize>(
    first: f64,
    second: f64,
    alpha: f64,
    beta: f64,
    rho: f64,
) -> [f64; TERMS / 2] {
    let mut c = [0.0; TERMS / 2];
    (c[0], c[1]) = (first, second);
    for i in 0..TERMS / 2 - 2 {
        let j = (2 * i + PARITY) as f64;
        let load = if i == 0 { rho } else { 0.0 };
        let below = (j + 2.0) * (j + 1.0);
        c[i + 2] =
            (alpha * below * c[i + 1] - beta * c[i] + load) / ((j + 4.0) * (j + 3.0) * below);
    }
    c
}

impl Half {
    fn new(
        series: [[f64; TERMS / 2]; 3],
        ends: impl Fn(&[f64; TERMS / 2], bool) -> ([f64; 2], [f64; 2]),
    ) -> Self {
        let ends = [0, 1, 2].map(|i| ends(&series[i], i == 2));
        Half { series, boundary: ends.map(|e| e.0), force: ends.map(|e| e.1) }
    }

    /// Amplitudes of the two free solutions for given boundary values.
    fn amplitudes(&self, value: [f64; 2]) -> [f64; 2] {
        let [p, q, _] = self.boundary;
        let determinant = p[0] * q[1] - q[0] * p[1];
        [
            (value[0] * q[1] - q[0] * value[1]) / determinant,
            (p[0] * value[1] - value[0] * p[1]) / determinant,
        ]
    }

    /// Stiffness and load of this parity in its boundary values.
    fn condensed(&self) -> ([[f64; 2]; 2], [f64; 2]) {
        let columns = [self.amplitudes([1.0, 0.0]), self.amplitudes([0.0, 1.0])];
        let loaded = self.amplitudes(self.boundary[2]);
        let force = |amplitude: [f64; 2], i: usize| {
            amplitude[0] * self.force[0][i] + amplitude[1] * self.force[1][i]
        };
        let cross = 0.5 * (force(columns[0], 1) + force(columns[1], 0));
        let stiffness = [[force(columns[0], 0), cross], [cross, force(columns[1], 1)]];
        (stiffness, [0, 1].map(|i| force(loaded, i) - self.force[2][i]))
    }

    fn unfold(&self, value: [f64; 2]) -> [f64; TERMS / 2] {
        let [x, y] = self.boundary[2];
        let [p, q] = self.amplitudes([value[0] - x, value[1] - y]);
        std::array::from_fn(|i| p * self.series[0][i] + q * self.series[1][i] + self.series[2][i])
    }
}

/// From (w̄, φ) and (δ, e) to (w_left, θ_left, d₁, d₂).
fn assemble(
    length: f64,
    even: &([[f64; 2]; 2], [f64; 2]),
    odd: &([[f64; 2]; 2], [f64; 2]),
) -> Element {
    let a = 0.5 * length;
    let maps = [
        [[1.0, a, 0.5, 0.0], [0.0, 0.0, 0.0, 0.5]],
        [[0.0, a, 0.5, 0.0], [0.0, 0.0, -0.5, 0.5 * a]],
    ];
    let mut element = Element { length, ..Element::default() };
    for (map, (stiffness, load)) in maps.iter().zip([even, odd]) {
        for i in 0..4 {
            for m in 0..2 {
                element.load[i] += map[m][i] * load[m];
            }
            for j in 0..4 {
                for m in 0..2 {
                    for n in 0..2 {
                        element.stiffness[i][j] += map[m][i] * stiffness[m][n] * map[n][j];
                    }
                }
            }
        }
    }
    element
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::polynomial::jet;

    fn operator(n: f64, k: f64) -> Operator {
        Operator { stiffness: 1.0, tension: n, spring: k, load: [0.0; 2], moment_load: [0.0; 2] }
    }

    /// K in the deflections and slopes of both ends, as books print it.
    fn by_ends(e: &Element) -> [[f64; 4]; 4] {
        let h = e.length;
        // v = C (w_l, θ_l, w_r, θ_r): d₁ = w_r − w_l − h θ_l, d₂ = θ_r − θ_l.
        let c = [
            [1.0, 0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0, 0.0],
            [-1.0, -h, 1.0, 0.0],
            [0.0, -1.0, 0.0, 1.0],
        ];
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let mut sum = 0.0;
                for m in 0..4 {
                    for n in 0..4 {
                        sum += c[m][i] * e.stiffness[m][n] * c[n][j];
                    }
                }
                sum
            })
        })
    }

    #[test]
    fn without_ground_and_tension_it_is_the_hermite_element() {
        let e = ExactElement::new(&operator(0.0, 0.0), 2.0).element;
        let k = by_ends(&e);
        let printed = [[1.5, 1.5, -1.5, 1.5], [1.5, 2.0, -1.5, 1.0]];
        for i in 0..2 {
            for j in 0..4 {
                assert!((k[i][j] - printed[i][j]).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn razaqpur_and_shah_stiffness() {
        // Razaqpur and Shah, Int. J. Solids Structures 27(4), 435–454 (1991): EI = 2000, k = 64,
        // second parameter 800, L = 5, exact stiffness printed to two decimals.
        let op = Operator { stiffness: 2000.0, ..operator(800.0, 64.0) };
        let k = by_ends(&ExactElement::new(&op, 5.0).element);
        let printed = [
            [498.05, 626.62, -341.54, 514.45],
            [626.62, 2131.05, -514.45, 659.46],
            [-341.54, -514.45, 498.05, -626.62],
            [514.45, 659.46, -626.62, 2131.05],
        ];
        for i in 0..4 {
            for j in 0..4 {
                assert!((k[i][j] - printed[i][j]).abs() < 0.0051, "{i}{j}: {}", k[i][j]);
            }
        }
    }

    #[test]
    fn the_series_solves_the_equation_and_takes_its_end_values() {
        for (n, k) in [(0.0, 0.0), (0.3, 0.0), (2.0, 1.0), (-0.5, 0.3), (0.1, 2.0), (4.0, 0.01)] {
            let op = Operator { load: [1.0, -2.0], moment_load: [0.5, 0.1], ..operator(n, k) };
            let h = REACH / op.wave_number().max(1.0);
            let e = ExactElement::new(&op, h);
            let v = [0.3, -0.2, 0.1, 0.4];
            let c = e.unfold(&v);
            let a = 0.5 * h;
            let left = jet(&c, -1.0);
            let right = jet(&c, 1.0);
            assert!((left[0] - 0.3).abs() < 1e-15 && (left[1] / a + 0.2).abs() < 1e-14);
            assert!((right[0] - (0.3 - 0.2 * h + 0.1)).abs() < 1e-15);
            assert!((right[1] / a - 0.2).abs() < 1e-14);
            for s in [-0.9, -0.3, 0.2, 0.8] {
                let third: Vec<f64> = (1..TERMS).map(|j| j as f64 * c[j]).collect();
                let fourth = jet(&third, s)[3] / a.powi(4);
                let load = -0.5 - 1.5 * s - (-0.2 / a);
                let rest = fourth - n * jet(&c, s)[2] / (a * a) + k * jet(&c, s)[0] - load;
                assert!(rest.abs() < 1e-12 * (1.0 + load.abs()), "{n} {k} {s}: {rest}");
            }
            // The element's forces are the shear T and the moment at its ends.
            let f = e.element.forces(&v);
            let total = |j: [f64; 4], g: f64| -j[3] / a.powi(3) + n * j[1] / a - g;
            let t = [total(left, 0.5), total(right, 0.1)];
            assert!((f[2] - t[1]).abs() < 1e-12 * (1.0 + t[1].abs()), "{} {}", f[2], t[1]);
            assert!((f[0] - (t[1] - t[0])).abs() < 1e-11 * (1.0 + t[0].abs()));
            assert!((f[3] - right[2] / (a * a)).abs() < 1e-12 * (1.0 + f[3].abs()));
        }
    }

    #[test]
    fn short_elements_keep_the_digits_of_bending_and_ground() {
        // Rigid terms are k h and k h²/2, bending 12/h³, each to the last digits, at any h.
        for h in [1e-2, 1e-5, 1e-8] {
            let e = ExactElement::new(&operator(0.0, 1.0), h).element;
            // The next terms of the series are of relative size h⁴.
            let small = h.powi(4) + 1e-15;
            assert!((e.stiffness[0][0] / h - 1.0).abs() < small);
            assert!((e.stiffness[0][1] / (h * h / 2.0) - 1.0).abs() < small);
            assert!((e.stiffness[2][2] * h.powi(3) / 12.0 - 1.0).abs() < small);
        }
    }
}
