//! The element of a beam that shears as well as bends (Timoshenko's), as power series, whatever of it varies.
//!
//! About the middle of the element, x = x_middle + a s, the deflection w, the rotation φ of the sections, the
//! shear strain γ, the moment m = EI (φ' − κ₀) and the whole vertical force τ = Sγ + N w' − G follow one another:
//!
//! > w' = φ + γ,  EI (φ' − κ₀) = m,  (S + N) γ = τ + G − N φ,  m' = −(Sγ + g),  τ' = κ w − F,
//!
//! where g turns the sections and G, the ground's initial slope, does work on w'. Nodes carry w and φ. As in the
//! [element that only bends](crate::element::uniform) rigid motions and deformations are kept apart: the shear strain is
//! found by itself, not as w' − φ, and with it the deformation.

use crate::element::courses::{Courses, Touch};
use crate::element::element::TERMS;
use crate::element::element::{Basis, Element};
use crate::element::series::{Series, amplitudes, work};
use crate::mesh::cell::Cell;
use crate::model::Profile;
use crate::numeric::polynomial::value;

/// What a cell of a beam that shears is made of, by s.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Shearing {
    /// EI, N, κ, F and G.
    courses: Courses,
    /// S.
    shear: [f64; Profile::MOST],
    /// g and κ₀.
    turning: [f64; 2],
    curvature: [f64; 2],
}

impl Shearing {
    pub fn of(cell: &Cell, axial_force: f64, touch: Touch) -> Option<Self> {
        let shear = cell.beam_shear?;
        let linear = |v: [f64; 2]| [0.5 * (v[0] + v[1]), 0.5 * (v[1] - v[0])];
        // What acts on the rotation is kept apart from what acts on w'.
        let straight = Cell { moment_load: [0.0; 2], curvature: [0.0; 2], ..*cell };
        Some(Shearing {
            courses: Courses::along(&straight, axial_force, touch),
            shear,
            turning: linear(cell.moment_load),
            curvature: linear(cell.curvature),
        })
    }

    /// Whether the beam resists shear under its axial force: S + N > 0.
    pub fn is_stiff(&self) -> bool {
        ENDS_AND_MIDDLE.iter().all(|&s| self.at(s)[3] + self.at(s)[1] > 0.0)
    }

    /// N/EI and κ/EI of an element that only bends and has the same wave numbers, the largest of each.
    pub fn like_bending(&self) -> [f64; 2] {
        let mut most = [0.0_f64; 2];
        for s in ENDS_AND_MIDDLE {
            let [stiffness, tension, spring, shear] = self.at(s);
            let part = 1.0 + tension / shear;
            let like = [(tension / stiffness + spring / shear) / part, spring / stiffness / part];
            most = [0, 1].map(|i| most[i].max(like[i].abs()));
        }
        most
    }

    /// EI, N, κ and S at s.
    fn at(&self, s: f64) -> [f64; 4] {
        let Courses { stiffness, tension, spring, .. } = &self.courses;
        [value(stiffness, s), value(tension, s), value(spring, s), value(&self.shear, s)]
    }
}

const ENDS_AND_MIDDLE: [f64; 3] = [-1.0, 0.0, 1.0];

impl Shearing {
    /// The element, and its functions: w and φ for each of its four numbers being 1 alone, and for none of them
    /// under the load.
    pub fn element(&self, length: f64) -> (Element, [Series; 2]) {
        let a = 0.5 * length;
        let [tension, stiffness] = [self.courses.tension[0], self.courses.stiffness[0]];
        let shear_force = -stiffness / (a * a * a);
        let begin = [
            Start { deflection: 1.0, ..Start::default() },
            Start { rotation: 1.0 / a, force: tension / a, ..Start::default() },
            Start { moment: stiffness / (a * a), ..Start::default() },
            // w' = 0 in the middle.
            Start {
                rotation: -shear_force / self.shear[0],
                force: shear_force,
                ..Start::default()
            },
        ];
        let free = begin.map(|start| Solution::from(start, self, a, false));
        let loaded = Solution::from(Start::default(), self, a, true);
        let ends = free.each_ref().map(|solution| solution.boundary(a));
        let combined = |by: [f64; 4]| Solution::combined(&free, by);
        let unit = |i: usize| std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 });
        let own = [0, 1, 2, 3].map(|i| combined(amplitudes(&ends, unit(i))));
        let without = combined(amplitudes(&ends, loaded.boundary(a)));
        let held = loaded.less(&without);

        let mut element = Element { length, basis: Basis::Deformation, ..Element::default() };
        let forces = own.each_ref().map(|solution| solution.forces(self, a, false));
        let under_load = held.forces(self, a, true);
        for i in 0..4 {
            element.load[i] = -under_load[i];
            for j in 0..4 {
                element.stiffness[i][j] = 0.5 * (forces[j][i] + forces[i][j]);
            }
        }
        let [p, q, r, s] = own;
        let all = [p, q, r, s, held];
        let deflection = Series::of(all.map(|solution| solution.deflection));
        (element, [deflection, Series::of(all.map(|solution| solution.rotation))])
    }
}

/// w, φ, m and τ in the middle.
#[derive(Debug, Clone, Copy, Default)]
struct Start {
    deflection: f64,
    rotation: f64,
    moment: f64,
    force: f64,
}

/// Coefficients of everything.
#[derive(Debug, Clone, Copy, Default)]
struct Solution {
    deflection: [f64; TERMS],
    rotation: [f64; TERMS],
    strain: [f64; TERMS],
    moment: [f64; TERMS],
    force: [f64; TERMS],
}

impl Solution {
    /// All coefficients from what is in the middle.
    fn from(start: Start, beam: &Shearing, a: f64, loaded: bool) -> Self {
        let Courses { stiffness, tension, spring, load, moment_load } = &beam.courses;
        let both: [f64; Profile::MOST] =
            std::array::from_fn(|i| beam.shear[i] + tension.get(i).copied().unwrap_or_default());
        let given = |c: &[f64], j: usize| c.get(j).filter(|_| loaded).copied().unwrap_or_default();
        let mut all = Solution::default();
        (all.deflection[0], all.rotation[0]) = (start.deflection, start.rotation);
        (all.moment[0], all.force[0]) = (start.moment, start.force);
        let mut bend = [0.0; TERMS];
        for j in 0..TERMS - 1 {
            let pulled = coefficient(tension, &all.rotation, j, 0);
            let push = all.force[j] + given(moment_load, j) - pulled;
            all.strain[j] = (push - coefficient(&both, &all.strain, j, 1)) / both[0];
            bend[j] = (all.moment[j] - coefficient(stiffness, &bend, j, 1)) / stiffness[0];
            let sheared = coefficient(&beam.shear, &all.strain, j, 0);
            let pressed = coefficient(spring, &all.deflection, j, 0);
            let next = a / (j + 1) as f64;
            all.deflection[j + 1] = next * (all.rotation[j] + all.strain[j]);
            all.rotation[j + 1] = next * (bend[j] + given(&beam.curvature, j));
            all.moment[j + 1] = -next * (sheared + given(&beam.turning, j));
            all.force[j + 1] = next * (pressed - given(load, j));
        }
        all
    }

    fn combined(free: &[Solution; 4], by: [f64; 4]) -> Self {
        let sum = |of: fn(&Solution) -> &[f64; TERMS]| -> [f64; TERMS] {
            std::array::from_fn(|j| free.iter().zip(by).map(|(one, by)| by * of(one)[j]).sum())
        };
        Solution {
            deflection: sum(|one| &one.deflection),
            rotation: sum(|one| &one.rotation),
            strain: sum(|one| &one.strain),
            moment: sum(|one| &one.moment),
            force: sum(|one| &one.force),
        }
    }

    fn less(&self, other: &Solution) -> Self {
        let less = |a: &[f64; TERMS], b: &[f64; TERMS]| std::array::from_fn(|j| a[j] - b[j]);
        Solution {
            deflection: less(&self.deflection, &other.deflection),
            rotation: less(&self.rotation, &other.rotation),
            strain: less(&self.strain, &other.strain),
            moment: less(&self.moment, &other.moment),
            force: less(&self.force, &other.force),
        }
    }

    /// w and φ at the left end, and the deformation: ∫γ + ∫(φ − φ_left) and φ_right − φ_left.
    fn boundary(&self, a: f64) -> [f64; 4] {
        let (mut w, mut rotation, mut d1, mut d2) = (0.0, 0.0, 0.0, 0.0);
        for j in (0..TERMS).rev() {
            let [c, turned] = [self.deflection[j], self.rotation[j]];
            if j % 2 == 0 {
                let mean = 1.0 / (j + 1) as f64;
                w += c;
                rotation += turned;
                d1 += 2.0 * a * (self.strain[j] * mean - turned * (j as f64 * mean));
            } else {
                w -= c;
                rotation -= turned;
                d1 += 2.0 * a * turned;
                d2 += 2.0 * turned;
            }
        }
        [w, rotation, d1, d2]
    }

    /// What it demands: the virtual work of rising and of turning about the left end, in which neither bending nor
    /// shearing has a part, τ and m at the right end.
    fn forces(&self, beam: &Shearing, a: f64, loaded: bool) -> [f64; 4] {
        let Courses { tension, spring, load, moment_load, .. } = &beam.courses;
        let slope: [f64; TERMS] = std::array::from_fn(|j| self.rotation[j] + self.strain[j]);
        let [mut pressed, mut first] = [0, 1].map(|power| work(spring, &self.deflection, power));
        let mut turning = work(tension, &slope, 0);
        if loaded {
            pressed -= work(load, &[1.0], 0);
            first -= work(load, &[1.0], 1);
            turning -= work(moment_load, &[1.0], 0) + work(&beam.turning, &[1.0], 0);
        }
        let right = |c: &[f64; TERMS]| c.iter().rev().sum::<f64>();
        [
            a * pressed,
            a * (turning + a * (pressed + first)),
            right(&self.force),
            right(&self.moment),
        ]
    }
}

/// The coefficient of s^j in f g, without the first `skipped` powers of f.
fn coefficient(f: &[f64], g: &[f64; TERMS], j: usize, skipped: usize) -> f64 {
    let terms = f.iter().enumerate().skip(skipped).take_while(|(i, _)| *i <= j);
    terms.map(|(i, f)| f * g[j - i]).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::operator::Operator;
    use crate::element::uniform::ExactElement;
    use crate::mesh::cell::GROUND;
    use crate::numeric::polynomial::{jet, product};

    /// A cell of which everything varies, on ground of which everything varies.
    fn varying() -> Shearing {
        Shearing {
            courses: Courses {
                stiffness: [1.0, 0.08, 0.005, 0.0002, 0.0, 0.0],
                tension: [0.7, 0.3, 0.1],
                spring: [0.9, -0.4, 0.05],
                load: [1.0, -2.0, 0.3, 0.1],
                moment_load: [0.5, 0.1, 0.2, 0.0, 0.0, 0.0],
            },
            shear: [3.0, 0.2, 0.01, 0.0, 0.0, 0.0],
            turning: [0.3, -0.2],
            curvature: [0.4, 0.7],
        }
    }

    #[test]
    fn the_series_solve_the_equations_and_take_their_end_values() {
        let beam = varying();
        let (h, a) = (1.4, 0.7);
        let (element, shapes) = beam.element(h);
        let v = [0.3, -0.2, 0.1, 0.4];
        let [w, rotation] = shapes.map(|series| series.unfold(&v));
        assert!((value(&w, -1.0) - 0.3).abs() < 1e-15);
        assert!((value(&rotation, -1.0) + 0.2).abs() < 1e-15);
        assert!((value(&w, 1.0) - (0.3 - 0.2 * h + 0.1)).abs() < 1e-15);
        assert!((value(&rotation, 1.0) - 0.2).abs() < 1e-14);
        // Q = S (w' − φ), m = EI (φ' − κ₀) and τ = Q + N w' − G as polynomials.
        let Courses { stiffness, tension, spring, load, moment_load } = &beam.courses;
        let slope: Vec<f64> = (1..TERMS).map(|j| j as f64 * w[j] / a).collect();
        let strain: Vec<f64> = slope.iter().zip(&rotation).map(|(d, turned)| d - turned).collect();
        let shear_force = product(&beam.shear, &strain);
        let mut bend: Vec<f64> = (1..TERMS).map(|j| j as f64 * rotation[j] / a).collect();
        bend[0] -= beam.curvature[0];
        bend[1] -= beam.curvature[1];
        let moment = product(stiffness, &bend);
        let pull = product(tension, &slope);
        let total = |s: f64| value(&shear_force, s) + value(&pull, s) - value(moment_load, s);
        for s in [-0.9, -0.3, 0.2, 0.8] {
            let rising = |c: &[f64]| jet(c, s)[1] / a;
            let turns = rising(&moment) + value(&shear_force, s) + value(&beam.turning, s);
            assert!(turns.abs() < 1e-12, "{s}: {turns:e}");
            let carried = rising(&shear_force) + rising(&pull) - rising(moment_load);
            let sinks = carried - value(spring, s) * value(&w, s) + value(load, s);
            assert!(sinks.abs() < 1e-11, "{s}: {sinks:e}");
        }
        let forces = element.forces(&v);
        assert!((forces[2] - total(1.0)).abs() < 1e-12, "{forces:?} {}", total(1.0));
        assert!((forces[0] - (total(1.0) - total(-1.0))).abs() < 1e-11);
        assert!((forces[3] - value(&moment, 1.0)).abs() < 1e-12);
        let turned = forces[1] - h * total(1.0) - value(&moment, 1.0) + value(&moment, -1.0);
        assert!(turned.abs() < 1e-11, "{turned:e}");
    }

    /// Without ground and tension, Przemieniecki (1968), Theory of Matrix Structural Analysis, eq. (5.116): with
    /// Φ = 12 EI/(S h²) and in (w_left, θ_left, w_right, θ_right), K = EI/((1 + Φ) h³) (12, 6h, …; (4 + Φ) h², …).
    #[test]
    fn without_ground_it_is_the_books_element() {
        for shear in [1e-6, 0.5, 40.0, 1e9] {
            let courses = Courses {
                stiffness: [3.0, 0.0, 0.0, 0.0, 0.0, 0.0],
                tension: [0.0; GROUND],
                spring: [0.0; GROUND],
                load: [0.0; GROUND + 1],
                moment_load: [0.0; Profile::MOST],
            };
            let shear = [shear, 0.0, 0.0, 0.0, 0.0, 0.0];
            let beam = Shearing { courses, shear, turning: [0.0; 2], curvature: [0.0; 2] };
            let h = 1.7;
            let k = beam.element(h).0.stiffness;
            let phi = 12.0 * 3.0 / (shear[0] * h * h);
            let unit = 3.0 / ((1.0 + phi) * h * h * h);
            let book = [[12.0, -6.0 * h], [-6.0 * h, (4.0 + phi) * h * h]];
            for i in 0..2 {
                for j in 0..2 {
                    let [own, book] = [k[2 + i][2 + j], unit * book[i][j]];
                    assert!((own / book - 1.0).abs() < 1e-13, "{shear:?} {own} {book}");
                    assert_eq!(k[i][j], 0.0);
                }
            }
        }
    }

    /// A beam that hardly shears is one that only bends.
    #[test]
    fn without_shear_it_is_the_element_that_only_bends() {
        let Shearing { courses, turning, .. } = varying();
        let mut bending = courses;
        for (both, turning) in bending.moment_load.iter_mut().zip(turning) {
            *both += turning;
        }
        let shear = [1e18, 0.0, 0.0, 0.0, 0.0, 0.0];
        let beam = Shearing { courses, shear, turning, curvature: [0.0; 2] };
        let operator = Operator {
            stiffness: 1.0,
            tension: 0.7,
            spring: 0.9,
            load: [0.0; 2],
            moment_load: [0.0; 2],
            curling_moments: [0.0; 2],
            courses: Some(bending),
            shearing: None,
        };
        let only_bends = ExactElement::new(&operator, 1.3);
        let (element, [deflection, _]) = beam.element(1.3);
        for i in 0..4 {
            let [own, other] = [element.load[i], only_bends.element.load[i]];
            assert!(
                (own - other).abs() < 1e-12,
                "{i}: {own} {other} {:?} {:?}",
                element.load,
                only_bends.element.load
            );
            for j in 0..4 {
                let difference = element.stiffness[i][j] - only_bends.element.stiffness[i][j];
                assert!(difference.abs() < 1e-13 * element.stiffness[i][i], "{i}{j}");
            }
        }
        let v = [0.3, -0.2, 0.1, 0.4];
        for (a, b) in deflection.unfold(&v).iter().zip(only_bends.unfold(&v).0) {
            assert!((a - b).abs() < 1e-14, "{a} {b}");
        }
    }
}
