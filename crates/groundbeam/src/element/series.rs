//! The element whose functions solve (EI w″)″ − (N w')' + κ w = F − G' where EI, N or κ vary, (2.11) with (4.1).
//!
//! About the middle of the element, x = x_middle + a s, with EI, N, κ, F and G polynomials in s, the
//! coefficients of w = Σ cⱼ sʲ follow one another through those of m = EI w″,
//!
//! (j+2)(j+1) m_{j+2} = a² (j+1) \[N w'\]_{j+1} − a⁴ \[κ w\]_j + a⁴ \[F − G'\]_j,
//! EI₀ (j+4)(j+3) c_{j+4} = m_{j+2} − Σ_{i≥1} EIᵢ (j+4−i)(j+3−i) c_{j+4−i}.
//!
//! The series converges up to the nearest zero of EI in the complex plane, which lies ten half lengths away
//! or farther ([`Cell::is_smooth`](crate::mesh::cell::Cell::is_smooth)). As in the [uniform
//! element](crate::element::uniform) rigid motions and deformations are kept apart, and so no stiffness is a
//! difference of large numbers.

use crate::element::courses::Courses;
use crate::element::element::TERMS;
use crate::element::element::{Basis, Element};

/// w for each of the element's four numbers being 1 alone, and for none of them under the load.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Series {
    solutions: [[f64; TERMS]; 5],
}

impl Series {
    /// By the functions themselves: those of the element's four numbers, and the loaded one.
    pub fn of(solutions: [[f64; TERMS]; 5]) -> Self {
        Series { solutions }
    }

    pub fn new(courses: &Courses, length: f64) -> (Element, Self) {
        let a = 0.5 * length;
        let solution = |first: usize, scale: f64| {
            let mut c = [0.0; TERMS];
            if let Some(c) = c.get_mut(first) {
                *c = scale;
            }
            go_on(&mut c, courses, a, first >= 4);
            c
        };
        let free = [solution(0, 1.0), solution(1, 1.0), solution(2, 0.5), solution(3, 1.0 / 6.0)];
        let loaded = solution(4, 0.0);
        let ends = free.map(|c| boundary(&c, a));
        let held = boundary(&loaded, a);
        let combined = |amplitudes: [f64; 4]| -> [f64; TERMS] {
            std::array::from_fn(|j| free.iter().zip(amplitudes).map(|(c, by)| by * c[j]).sum())
        };
        let mut solutions = [[0.0; TERMS]; 5];
        for (i, solution) in solutions.iter_mut().take(4).enumerate() {
            let mut wanted = [0.0; 4];
            wanted[i] = 1.0;
            *solution = combined(amplitudes(&ends, wanted));
        }
        let without = combined(amplitudes(&ends, held));
        solutions[4] = std::array::from_fn(|j| loaded[j] - without[j]);

        let mut element = Element { length, basis: Basis::Deformation, ..Element::default() };
        let forces = [0, 1, 2, 3].map(|i| forces(&solutions[i], courses, a, false));
        let under_load = crate::element::series::forces(&solutions[4], courses, a, true);
        for i in 0..4 {
            element.load[i] = -under_load[i];
            for j in 0..4 {
                element.stiffness[i][j] = 0.5 * (forces[j][i] + forces[i][j]);
            }
        }
        (element, Series { solutions })
    }

    /// The coefficients of w(s) for the element's four numbers.
    pub fn unfold(&self, v: &[f64; 4]) -> [f64; TERMS] {
        let [free @ .., loaded] = &self.solutions;
        std::array::from_fn(|j| loaded[j] + free.iter().zip(v).map(|(c, v)| c[j] * v).sum::<f64>())
    }
}

/// The coefficients of a solution from its first four.
fn go_on(c: &mut [f64; TERMS], courses: &Courses, a: f64, loaded: bool) {
    let Courses { stiffness, tension, spring, load, moment_load } = courses;
    let squared = a * a;
    for j in 0..TERMS - 4 {
        let mut push = 0.0;
        if loaded {
            push += load.get(j).copied().unwrap_or(0.0);
            push -= moment_load.get(j + 1).map_or(0.0, |g| (j + 1) as f64 * g / a);
        }
        for (i, k) in spring.iter().enumerate().take_while(|(i, _)| *i <= j) {
            push -= k * c[j - i];
        }
        let mut pull = 0.0;
        for (i, n) in tension.iter().enumerate().take_while(|(i, _)| *i <= j + 1) {
            pull += n * (j + 2 - i) as f64 * c[j + 2 - i];
        }
        let below = ((j + 2) * (j + 1)) as f64;
        let mut moment = squared * (pull / (j + 2) as f64 + squared * push / below);
        for (i, e) in stiffness.iter().enumerate().skip(1).take_while(|(i, _)| *i <= j + 2) {
            moment -= e * ((j + 4 - i) * (j + 3 - i)) as f64 * c[j + 4 - i];
        }
        c[j + 4] = moment / (stiffness[0] * ((j + 4) * (j + 3)) as f64);
    }
}

/// w and w' at the left end, and the deformation.
fn boundary(c: &[f64; TERMS], a: f64) -> [f64; 4] {
    let (mut w, mut slope, mut d1, mut d2) = (0.0, 0.0, 0.0, 0.0);
    for (j, c) in c.iter().enumerate().rev() {
        let j_float = j as f64;
        if j % 2 == 0 {
            w += c;
            slope -= j_float * c;
            d1 += 2.0 * j_float * c;
            d2 += 2.0 * j_float * c;
        } else {
            w -= c;
            slope += j_float * c;
            d1 += 2.0 * (1.0 - j_float) * c;
        }
    }
    [w, slope / a, d1, d2 / a]
}

/// How much of each free solution gives wanted boundary values. The deformations belong to the third and
/// the fourth, but for what ground and tension make of the first two.
pub(crate) fn amplitudes(ends: &[[f64; 4]; 4], wanted: [f64; 4]) -> [f64; 4] {
    let solve = |m: [[f64; 2]; 2], r: [f64; 2]| {
        let determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
        [
            (r[0] * m[1][1] - m[0][1] * r[1]) / determinant,
            (m[0][0] * r[1] - r[0] * m[1][0]) / determinant,
        ]
    };
    let block = |row: usize, column: usize| {
        [0, 1].map(|i| [0, 1].map(|j| ends[2 * column + j][2 * row + i]))
    };
    let bend = |r: [f64; 2]| solve(block(1, 1), r);
    let across = |m: [[f64; 2]; 2], x: [f64; 2]| m.map(|row| row[0] * x[0] + row[1] * x[1]);
    let from_rigid = [0, 1].map(|j| bend(block(1, 0).map(|row| row[j])));
    let bent = bend([wanted[2], wanted[3]]);
    let felt = across(block(0, 1), bent);
    let rigid = block(0, 0);
    let upper = block(0, 1);
    let left = [0, 1].map(|i| {
        [0, 1].map(|j| {
            rigid[i][j] - (upper[i][0] * from_rigid[j][0] + upper[i][1] * from_rigid[j][1])
        })
    });
    let [p, q] = solve(left, [wanted[0] - felt[0], wanted[1] - felt[1]]);
    let bending = |i: usize| bent[i] - p * from_rigid[0][i] - q * from_rigid[1][i];
    [p, q, bending(0), bending(1)]
}

/// What a solution demands: the virtual work of rising and of turning about the left end, in which the large
/// bending terms have no part, and shear T and moment at the right end.
fn forces(c: &[f64; TERMS], courses: &Courses, a: f64, loaded: bool) -> [f64; 4] {
    let Courses { stiffness, tension, spring, load, moment_load } = courses;
    let slope: [f64; TERMS - 1] = std::array::from_fn(|j| (j + 1) as f64 * c[j + 1] / a);
    let [mut pressed, pressed_first] = [0, 1].map(|power| work(spring, c, power));
    let mut first = pressed_first;
    let mut turning = work(tension, &slope, 0);
    let mut end_moment = 0.0;
    if loaded {
        pressed -= work(load, &[1.0], 0);
        first -= work(load, &[1.0], 1);
        turning -= work(moment_load, &[1.0], 0);
        end_moment = moment_load.iter().sum();
    }
    // EI w″ and its derivative at s = 1, the tension's part of T beside it.
    let (mut bend, mut rise) = (0.0, 0.0);
    for (i, e) in stiffness.iter().enumerate() {
        for (j, c) in c.iter().enumerate().skip(2) {
            let term = e * (j * (j - 1)) as f64 * c;
            bend += term;
            rise += (i + j - 2) as f64 * term;
        }
    }
    let pull = tension.iter().sum::<f64>() * slope.iter().sum::<f64>();
    [
        a * pressed,
        a * (turning + a * (pressed + first)),
        pull - rise / (a * a * a) - end_moment,
        bend / (a * a),
    ]
}

/// ∫ f g s^power ds over \[−1, 1\].
pub(crate) fn work(f: &[f64], g: &[f64], power: usize) -> f64 {
    let mut sum = 0.0;
    for (i, f) in f.iter().enumerate().filter(|(_, f)| **f != 0.0) {
        for (j, g) in g.iter().enumerate().filter(|(j, _)| (i + j + power).is_multiple_of(2)) {
            sum += 2.0 * f * g / (i + j + power + 1) as f64;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::operator::Operator;
    use crate::element::uniform::ExactElement;
    use crate::numeric::polynomial::{jet, value};

    #[test]
    fn with_nothing_varying_it_is_the_uniform_element() {
        for (n, k) in [(0.0, 0.0), (2.0, 1.0), (-0.5, 0.3), (0.1, 2.0)] {
            let operator = Operator {
                stiffness: 1.5,
                tension: n,
                spring: k,
                load: [1.0, -2.0],
                moment_load: [0.5, 0.1],
                curling_moments: [0.0; 2],
                courses: None,
                shearing: None,
            };
            let uniform = ExactElement::new(&operator, 1.3);
            let courses = Courses {
                stiffness: [1.5, 0.0, 0.0, 0.0, 0.0, 0.0],
                tension: [n, 0.0, 0.0],
                spring: [k, 0.0, 0.0],
                load: [-0.5, -1.5, 0.0, 0.0],
                moment_load: [0.3, -0.2, 0.0, 0.0, 0.0, 0.0],
            };
            let (element, series) = Series::new(&courses, 1.3);
            for i in 0..4 {
                let scale = uniform.element.stiffness[i][i];
                assert!((element.load[i] - uniform.element.load[i]).abs() < 1e-14);
                for j in 0..4 {
                    let difference = element.stiffness[i][j] - uniform.element.stiffness[i][j];
                    assert!(difference.abs() <= 4e-15 * (scale + 1.0), "{n} {k} {i}{j}");
                }
            }
            let v = [0.3, -0.2, 0.1, 0.4];
            for (a, b) in series.unfold(&v).iter().zip(uniform.unfold(&v).0) {
                assert!((a - b).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn the_series_solves_the_equation_and_takes_its_end_values() {
        let courses = Courses {
            stiffness: [1.0, 0.08, 0.005, 0.0002, 0.0, 0.0],
            tension: [0.7, 0.3, 0.1],
            spring: [0.9, -0.4, 0.05],
            load: [1.0, -2.0, 0.3, 0.1],
            moment_load: [0.5, 0.1, 0.2, 0.0, 0.0, 0.0],
        };
        let (h, a) = (1.4, 0.7);
        let (element, series) = Series::new(&courses, h);
        let v = [0.3, -0.2, 0.1, 0.4];
        let c = series.unfold(&v);
        let [left, right] = [-1.0, 1.0].map(|s| jet(&c, s));
        assert!((left[0] - 0.3).abs() < 1e-15 && (left[1] / a + 0.2).abs() < 1e-15);
        assert!((right[0] - (0.3 - 0.2 * h + 0.1)).abs() < 1e-15);
        assert!((right[1] / a - 0.2).abs() < 1e-14);
        let bend: Vec<f64> = (2..TERMS).map(|j| (j * (j - 1)) as f64 * c[j] / (a * a)).collect();
        let moment = crate::numeric::polynomial::product(&courses.stiffness, &bend);
        for s in [-0.9, -0.3, 0.2, 0.8] {
            let [_, _, fourth, _] = jet(&moment, s);
            let [n, dn, ..] = jet(&courses.tension, s);
            let [w, dw, ddw, _] = jet(&c, s);
            let tension = (n * ddw + dn * dw) / (a * a);
            let load = value(&courses.load, s) - jet(&courses.moment_load, s)[1] / a;
            let rest = fourth / (a * a) - tension + value(&courses.spring, s) * w - load;
            assert!(rest.abs() < 1e-11, "{s}: {rest:e}");
        }
        let forces = element.forces(&v);
        let total = |s: f64| {
            let [_, dm, ..] = jet(&moment, s);
            let [_, dw, ..] = jet(&c, s);
            (value(&courses.tension, s) * dw - dm) / a - value(&courses.moment_load, s)
        };
        assert!((forces[2] - total(1.0)).abs() < 1e-12);
        assert!((forces[0] - (total(1.0) - total(-1.0))).abs() < 1e-11);
        assert!((forces[3] - value(&moment, 1.0)).abs() < 1e-13);
        let turned = forces[1] - h * total(1.0) - value(&moment, 1.0) + value(&moment, -1.0);
        assert!(turned.abs() < 1e-11, "{turned:e}");
    }
}
