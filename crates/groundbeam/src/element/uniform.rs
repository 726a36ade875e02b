//! Computes the exact element with constant data, from solutions of EI w⁗ − N w″ + κ w = F − G', (2.11) of Kikuchi's paper.
//!
//! N, κ, F and G are those of [`Operator`]. *Exact elements* in `docs/methods.md` has the recurrence for the power
//! series of w. Even and odd powers are decoupled. If tension dominates bending,
//! [boundary layers](crate::element::layers) are added.

use crate::element::element::{Basis, Element};
use crate::element::layers::Layers;
use crate::element::operator::Operator;
use crate::numeric::elementary::{exp, power, tanh};
use crate::numeric::polynomial::TERMS;
use crate::numeric::real::{Real, sum};

/// The even and the odd solutions of the beam equation with constant coefficients, for one element.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Uniform<R = f64> {
    pub layers: Option<Layers<R>>,
    halves: [Half<R>; 2],
}

/// The even or the odd solutions of an element: two homogeneous solutions and one particular solution.
#[derive(Debug, Clone, Copy)]
struct Half<R> {
    /// Power series coefficients of the two homogeneous solutions and of the particular solution, for the even or the
    /// odd powers alone. Those of a boundary layer are zero.
    series: [[R; TERMS / 2]; 3],
    /// Two boundary values of each solution. Even: the mean deflection of the ends and half their relative rotation.
    /// Odd: half the difference δ of the end deflections, and a·θ − δ for the half length a and the mean rotation θ.
    boundary: [[R; 2]; 3],
    /// Two boundary forces of each of the two homogeneous solutions and of the particular solution. They are
    /// work-conjugate to the boundary values.
    force: [[R; 2]; 3],
}

impl<R: Real> Uniform<R> {
    pub fn new(operator: &Operator<R>, length: f64) -> (Element<R>, Self) {
        let a = 0.5 * length;
        let ei = operator.stiffness;
        let alpha = operator.tension * a * a / ei;
        let beta = operator.subgrade * power(a, 4) / ei;
        let mean = |v: [R; 2]| (v[0] + v[1]) * 0.5;
        let rise = |v: [R; 2]| (v[1] - v[0]) * 0.5;
        let [force_even, force_odd] = [mean(operator.load), rise(operator.load)];
        let [moment_even, moment_odd] = [mean(operator.moment_load), rise(operator.moment_load)];
        let unit = R::from(power(a, 4)) / ei;
        let layers = Layers::of(operator, length);

        // The boundary values of even solutions are the mean deflection of the ends and half their relative
        // rotation, (θ_right − θ_left)/2.
        let solve_even = |c0, c2, rho| series::<0, R>(c0, c2, alpha, beta, rho);
        let push_even = force_even - moment_odd / a;
        let even = match layers {
            None => [
                solve_even(1.0, 0.0, R::ZERO),
                solve_even(0.0, 0.5, R::ZERO),
                solve_even(0.0, 0.0, push_even * unit),
            ],
            Some(layers) => layers.slow::<0>(a, push_even / ei),
        };
        let even = Half::new(even, |c, loaded| {
            let [w, slope, bend, area] = sums(c, &EVEN_SUMS);
            let push = if loaded { force_even } else { R::ZERO };
            let sink = (operator.subgrade * area - push) * (2.0 * a);
            ([w, slope / a], [sink, ei * 2.0 * bend / (a * a)])
        });
        let even = match layers {
            None => even,
            Some(Layers { fast, .. }) => {
                // The boundary layer is cosh(rx)/cosh(ra) with the decay rate r = `fast` and half the length a.
                let tanh = tanh(fast * a);
                let sink = operator.subgrade * 2.0 * tanh / fast;
                even.with_layer([R::ONE, fast * tanh], [sink, ei * 2.0 * fast * fast])
            }
        };

        // The boundary values of odd solutions are defined at `Half::boundary`.
        let solve_odd = |c1, c3, rho| series::<1, R>(c1, c3, alpha, beta, rho);
        let odd = match layers {
            None => [
                solve_odd(1.0, 0.0, R::ZERO),
                solve_odd(0.0, 1.0 / 6.0, R::ZERO),
                solve_odd(0.0, 0.0, force_odd * unit),
            ],
            Some(layers) => layers.slow::<1>(a, force_odd / ei),
        };
        let odd = Half::new(odd, |c, loaded| {
            let [w, excess, bend, first] = sums(c, &ODD_SUMS);
            let [push, turn] = if loaded { [force_odd / 3.0, moment_even] } else { [R::ZERO; 2] };
            // `turning` is the virtual work of tension, ground and loads in a rigid rotation. Bending does no
            // work in it.
            let turning =
                (operator.tension * w / a + operator.subgrade * first * a - push * a - turn) * 2.0;
            ([w, excess], [turning, ei * 2.0 * bend / (a * a * a)])
        });
        let odd = match layers {
            None => odd,
            Some(Layers { fast, .. }) => {
                // The boundary layer is sinh(rx)/sinh(ra). Here r = `fast` is the decay rate, a is half the length of
                // the element, and x is measured from the middle of the element.
                let z = fast * a;
                let coth = R::ONE / tanh(z);
                let turning =
                    (operator.tension / a + operator.subgrade * a * (coth - R::ONE / z) / z) * 2.0;
                odd.with_layer([R::ONE, z * coth - 1.0], [turning, ei * 2.0 * fast * fast / a])
            }
        };
        let basis = if layers.is_some() { Basis::Ends } else { Basis::Deformation };
        let mut element = assemble(length, basis, &even.condensed(), &odd.condensed());
        bend(&mut element, operator.imposed_moments);
        (element, Uniform { layers, halves: [even, odd] })
    }

    /// Returns the power series coefficients of w(s) for the element's four unknowns `v`, and the amplitudes of the
    /// boundary layers at the left and the right end.
    pub fn unfold(&self, basis: Basis, length: f64, v: &[R; 4]) -> ([R; TERMS], [R; 2]) {
        let [even_half, odd_half] = &self.halves;
        let a = 0.5 * length;
        let [even, odd] = parities(a, basis).map(|map| map.map(|row| dot(&row, v)));
        let (even, cosh) = even_half.unfold(even);
        let (odd, sinh) = odd_half.unfold(odd);
        let series = std::array::from_fn(|j| if j % 2 == 0 { even[j / 2] } else { odd[j / 2] });
        let Some(layers) = self.layers else { return (series, [R::ZERO; 2]) };
        // cosh(rx)/cosh(ra) is the sum of the layers at both ends, divided by 1 + exp(−2ra). sinh(rx)/sinh(ra) is the
        // right layer minus the left one, divided by 1 − exp(−2ra). r is `fast`, a half the length.
        let decay = exp(-layers.fast * length);
        let (cosh, sinh) = (cosh / (decay + 1.0), sinh / (R::ONE - decay));
        // An amplitude of a boundary layer below `rounding` is rounding error and is set to zero.
        let [w_left, left, w_right, right] = v.map(|v| v.value().abs());
        let turned = left + right;
        let even = layers.slow_squared.value() * a * (w_left + w_right);
        let rounding = 4.0 * f64::EPSILON * (turned + even) / layers.fast.value();
        let height = |h: R| if h.value().abs() > rounding { h } else { R::ZERO };
        (series, [height(cosh - sinh), height(cosh + sinh)])
    }
}

/// Computes the power series coefficients of an even or an odd solution of the beam equation from its first two
/// coefficients, by recurrence.
fn series<const PARITY: usize, R: Real>(
    first: f64,
    second: f64,
    alpha: R,
    beta: R,
    rho: R,
) -> [R; TERMS / 2] {
    let mut c = [R::ZERO; TERMS / 2];
    (c[0], c[1]) = (R::from(first), R::from(second));
    let [by_two, by_four] = &const { falling::<PARITY>() };
    c[2] = alpha * by_two[0] * c[1] - (beta * first - rho) * by_four[0];
    for i in 1..TERMS / 2 - 2 {
        c[i + 2] = alpha * by_two[i] * c[i + 1] - beta * by_four[i] * c[i];
    }
    c
}

/// Returns the factors 1/((j+4)(j+3)) and 1/((j+4)(j+3)(j+2)(j+1)) in the recurrence for the coefficients c_j of
/// w, for all even j or all odd j.
const fn falling<const PARITY: usize>() -> [[f64; TERMS / 2]; 2] {
    let mut all = [[0.0; TERMS / 2]; 2];
    let mut i = 0;
    while i < TERMS / 2 {
        let j = (2 * i + PARITY) as f64;
        all[0][i] = 1.0 / ((j + 4.0) * (j + 3.0));
        all[1][i] = 1.0 / ((j + 4.0) * (j + 3.0) * (j + 2.0) * (j + 1.0));
        i += 1;
    }
    all
}

/// Weights of the even coefficients cⱼ of the deflection w = Σ cⱼ sʲ, −1 ≤ s ≤ 1, in four sums. The sums are w, dw/ds
/// and d²w/ds² at s = 1, and the integral of w over 0 ≤ s ≤ 1.
const EVEN_SUMS: [[f64; 4]; TERMS / 2] = {
    let mut all = [[0.0; 4]; TERMS / 2];
    let mut i = 0;
    while i < TERMS / 2 {
        let j = (2 * i) as f64;
        all[i] = [1.0, j, j * (j - 1.0), 1.0 / (j + 1.0)];
        i += 1;
    }
    all
};

/// Weights of the odd coefficients cⱼ of the deflection w = Σ cⱼ sʲ, −1 ≤ s ≤ 1, in four sums. The sums are w,
/// dw/ds − w and d²w/ds² at s = 1, and the integral of w s over 0 ≤ s ≤ 1.
const ODD_SUMS: [[f64; 4]; TERMS / 2] = {
    let mut all = [[0.0; 4]; TERMS / 2];
    let mut i = 0;
    while i < TERMS / 2 {
        let j = (2 * i + 1) as f64;
        all[i] = [1.0, j - 1.0, j * (j - 1.0), 1.0 / (j + 2.0)];
        i += 1;
    }
    all
};

/// Returns four weighted sums of the coefficients `c`. The small coefficients are added first.
fn sums<R: Real>(c: &[R; TERMS / 2], weights: &[[f64; 4]; TERMS / 2]) -> [R; 4] {
    let mut sums = [R::ZERO; 4];
    for (c, weights) in c.iter().zip(weights).rev() {
        for (sum, weight) in sums.iter_mut().zip(weights) {
            *sum += *c * *weight;
        }
    }
    sums
}

impl<R: Real> Half<R> {
    fn new(
        series: [[R; TERMS / 2]; 3],
        ends: impl Fn(&[R; TERMS / 2], bool) -> ([R; 2], [R; 2]),
    ) -> Self {
        let ends = [0, 1, 2].map(|i| ends(&series[i], i == 2));
        Half { series, boundary: ends.map(|e| e.0), force: ends.map(|e| e.1) }
    }

    /// Replaces the second homogeneous solution by a boundary layer with the given boundary values and boundary forces.
    fn with_layer(mut self, boundary: [R; 2], force: [R; 2]) -> Self {
        (self.boundary[1], self.force[1]) = (boundary, force);
        self
    }

    /// Returns the amplitudes of the two homogeneous solutions whose sum has the given boundary values.
    fn amplitudes(&self, value: [R; 2]) -> [R; 2] {
        let [p, q, _] = self.boundary;
        let determinant = p[0] * q[1] - q[0] * p[1];
        [
            (value[0] * q[1] - q[0] * value[1]) / determinant,
            (p[0] * value[1] - value[0] * p[1]) / determinant,
        ]
    }

    /// Returns the stiffness matrix and the load vector for the two boundary values of the even or the odd
    /// solutions.
    fn condensed(&self) -> ([[R; 2]; 2], [R; 2]) {
        let columns = [[R::ONE, R::ZERO], [R::ZERO, R::ONE]].map(|value| self.amplitudes(value));
        let loaded = self.amplitudes(self.boundary[2]);
        let force = |amplitude: [R; 2], i: usize| {
            amplitude[0] * self.force[0][i] + amplitude[1] * self.force[1][i]
        };
        let cross = (force(columns[0], 1) + force(columns[1], 0)) * 0.5;
        let stiffness = [[force(columns[0], 0), cross], [cross, force(columns[1], 1)]];
        (stiffness, [0, 1].map(|i| force(loaded, i) - self.force[2][i]))
    }

    /// For given boundary values, returns the power series coefficients of the solution and the amplitude of the second
    /// homogeneous solution, which may be a boundary layer.
    fn unfold(&self, value: [R; 2]) -> ([R; TERMS / 2], R) {
        let [x, y] = self.boundary[2];
        let [p, q] = self.amplitudes([value[0] - x, value[1] - y]);
        let sum = |i: usize| p * self.series[0][i] + q * self.series[1][i] + self.series[2][i];
        (std::array::from_fn(sum), q)
    }
}

/// Returns the two matrices that map the element's four unknowns to the boundary values: one matrix for the even
/// solutions, and one for the odd solutions.
fn parities(a: f64, basis: Basis) -> [[[f64; 4]; 2]; 2] {
    match basis {
        Basis::Deformation => [
            [[1.0, a, 0.5, 0.0], [0.0, 0.0, 0.0, 0.5]],
            [[0.0, a, 0.5, 0.0], [0.0, 0.0, -0.5, 0.5 * a]],
        ],
        Basis::Ends => [
            [[0.5, 0.0, 0.5, 0.0], [0.0, -0.5, 0.0, 0.5]],
            [[-0.5, 0.0, 0.5, 0.0], [0.5, 0.5 * a, -0.5, 0.5 * a]],
        ],
    }
}

/// Adds to the element's load the virtual work of the moment EI κ₀ of an imposed curvature κ₀. The moment is linear
/// between its end values `moments`.
pub(super) fn bend<R: Real>(element: &mut Element<R>, moments: [R; 2]) {
    if moments == [R::ZERO; 2] {
        return;
    }
    let [left, right] = moments;
    let rise = (right - left) / element.length;
    let work = match element.basis {
        Basis::Deformation => [R::ZERO, R::ZERO, -rise, right],
        Basis::Ends => [rise, -left, -rise, right],
    };
    for (load, work) in element.load.iter_mut().zip(work) {
        *load += work;
    }
}

fn dot<R: Real>(row: &[f64; 4], v: &[R; 4]) -> R {
    sum::<R, 4>(|i| v[i] * row[i])
}

/// Assembles the stiffness and the load of the element in its four unknowns.
fn assemble<R: Real>(
    length: f64,
    basis: Basis,
    even: &([[R; 2]; 2], [R; 2]),
    odd: &([[R; 2]; 2], [R; 2]),
) -> Element<R> {
    let maps = parities(0.5 * length, basis);
    let mut element = Element { length, basis, ..Element::default() };
    for (map, (stiffness, load)) in maps.iter().zip([even, odd]) {
        for i in 0..4 {
            let [a, b] = [map[0][i], map[1][i]];
            element.load[i] += load[0] * a + load[1] * b;
            let row = [0, 1].map(|n| stiffness[0][n] * a + stiffness[1][n] * b);
            for j in 0..4 {
                element.stiffness[i][j] += row[0] * map[0][j] + row[1] * map[1][j];
            }
        }
    }
    element
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::ExactElement;
    use crate::element::element::LONGEST_SERIES;
    use crate::numeric::polynomial::jet;

    fn operator(n: f64, k: f64) -> Operator {
        Operator {
            stiffness: 1.0,
            tension: n,
            subgrade: k,
            load: [0.0; 2],
            moment_load: [0.0; 2],
            imposed_moments: [0.0; 2],
            polynomials: None,
        }
    }

    /// Returns the stiffness matrix for the deflections and slopes of both ends, which are the usual unknowns in
    /// textbooks.
    fn by_ends(e: &Element) -> [[f64; 4]; 4] {
        let h = e.length;
        // The matrix maps the deflections and slopes of both ends to the four unknowns of the element.
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
        // Razaqpur and Shah, Int. J. Solids Structures 27(4), 435–454 (1991), print the exact stiffness to two
        // decimals for EI = 2000, k = 64, a second parameter of 800 and L = 5.
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
            let h = LONGEST_SERIES / op.wave_number().max(1.0);
            let e = ExactElement::new(&op, h);
            let v = [0.3, -0.2, 0.1, 0.4];
            let (c, _) = e.unfold(&v);
            let a = 0.5 * h;
            let left = jet(&c, -1.0);
            let right = jet(&c, 1.0);
            assert!((left[0] - 0.3).abs() < 1e-15 && (left[1] / a + 0.2).abs() < 1e-14);
            assert!((right[0] - (0.3 - 0.2 * h + 0.1)).abs() < 1e-15);
            assert!((right[1] / a - 0.2).abs() < 1e-14);
            for s in [-0.9, -0.3, 0.2, 0.8] {
                let third: Vec<f64> = (1..TERMS).map(|j| j as f64 * c[j]).collect();
                let fourth = jet(&third, s)[3] / power(a, 4);
                let load = -0.5 - 1.5 * s - (-0.2 / a);
                let rest = fourth - n * jet(&c, s)[2] / (a * a) + k * jet(&c, s)[0] - load;
                assert!(rest.abs() < 1e-12 * (1.0 + load.abs()), "{n} {k} {s}: {rest}");
            }
            // The element's forces are the transverse force T and the moment at its ends.
            let f = e.element.forces(&v);
            let total = |j: [f64; 4], g: f64| -j[3] / power(a, 3) + n * j[1] / a - g;
            let t = [total(left, 0.5), total(right, 0.1)];
            assert!((f[2] - t[1]).abs() < 1e-12 * (1.0 + t[1].abs()), "{} {}", f[2], t[1]);
            assert!((f[0] - (t[1] - t[0])).abs() < 1e-11 * (1.0 + t[0].abs()));
            assert!((f[3] - right[2] / (a * a)).abs() < 1e-12 * (1.0 + f[3].abs()));
        }
    }

    #[test]
    fn short_elements_keep_the_digits_of_bending_and_ground() {
        // For EI = k = 1 and a short length h, the stiffness is h for a translation, h²/2 for its coupling with
        // rotation, and 12/h³ for the relative displacement.
        for h in [1e-2, 1e-5, 1e-8] {
            let e = ExactElement::new(&operator(0.0, 1.0), h).element;
            // For the element length h, the exact stiffnesses differ from h, h²/2 and 12/h³ by a relative error of
            // order h⁴.
            let small = power(h, 4) + 1e-15;
            assert!((e.stiffness[0][0] / h - 1.0).abs() < small);
            assert!((e.stiffness[0][1] / (h * h / 2.0) - 1.0).abs() < small);
            assert!((e.stiffness[2][2] * power(h, 3) / 12.0 - 1.0).abs() < small);
        }
    }
}
