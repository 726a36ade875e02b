//! Computes the element with varying coefficients, with or without shear deformation, as power series of w, φ, m and τ.
//!
//! The deflection w, the rotation φ, the moment m and the vertical force τ solve (2.11) with (4.1) of Kikuchi's paper
//! as a system of first order. Section 7 of `docs/methods.md` lists the equations. The series converge if
//! [`Cell::is_smooth`](crate::mesh::cell::Cell::is_smooth) and
//! [`Cell::shear_is_smooth`](crate::mesh::cell::Cell::shear_is_smooth) hold.

use crate::element::element::{Basis, Element};
use crate::element::operator::Polynomials;
use crate::numeric::polynomial::{TERMS, trimmed};
use crate::numeric::real::{Real, sum};

/// One number for each of the five solutions of an element: four homogeneous solutions and one particular solution.
type Five<R> = [R; 5];

/// Index of the particular solution in [`Five`].
const LOADED: usize = 4;

/// The deflection and the rotation of an element as power series, for any values of its four unknowns.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Series<R = f64> {
    /// Power series coefficients of the deflection w in the four homogeneous solutions and the particular solution.
    deflection: [Five<R>; TERMS],
    /// Power series coefficients of the rotation φ in the four homogeneous solutions and the particular solution, if
    /// the beam has shear deformation.
    rotation: Option<[Five<R>; TERMS]>,
    /// Row i contains the amplitudes of the four homogeneous solutions whose sum has the value 1 for unknown i of the
    /// element and the value 0 for the other three unknowns.
    unit: [[R; 4]; 4],
    /// Amplitudes of the four homogeneous solutions whose sum has the deflections and rotations of the particular
    /// solution at both ends of the element.
    held: [R; 4],
}

impl<R: Real> Series<R> {
    pub fn new(of: &Polynomials<R>, length: f64) -> (Element<R>, Self) {
        let a = 0.5 * length;
        let solutions = Solutions::new(of, a);
        let (ends, forces) = (solutions.ends(a), solutions.forces(a));
        let ([free @ .., loaded], [free_forces @ .., loaded_forces]) = (&ends, &forces);
        let unit = [0, 1, 2, 3].map(|i| {
            let mut wanted = [R::ZERO; 4];
            wanted[i] = R::ONE;
            amplitudes(free, wanted)
        });
        let held = amplitudes(free, *loaded);
        let demanded = unit.map(|unit| combined(free_forces, &unit));
        let restraining = combined(free_forces, &held);
        let mut element = Element { length, basis: Basis::Deformation, ..Element::default() };
        for i in 0..4 {
            element.load[i] = restraining[i] - loaded_forces[i];
            for j in 0..4 {
                // The computed stiffness is symmetric except for rounding error. The mean of the entries ij and ji is
                // exactly symmetric.
                element.stiffness[i][j] = (demanded[j][i] + demanded[i][j]) * 0.5;
            }
        }
        let rotation = of.shear.is_some().then_some(solutions.rotation);
        (element, Series { deflection: solutions.deflection, rotation, unit, held })
    }

    /// Computes the coefficients of w(s) from the four unknowns of the element.
    pub fn deflection(&self, v: &[R; 4]) -> [R; TERMS] {
        self.unfold(v, &self.deflection)
    }

    /// Computes the coefficients of the rotation φ(s). Returns `None` if the beam has no shear deformation.
    pub fn rotation(&self, v: &[R; 4]) -> Option<[R; TERMS]> {
        self.rotation.as_ref().map(|rotation| self.unfold(v, rotation))
    }

    fn unfold(&self, v: &[R; 4], coefficients: &[Five<R>; TERMS]) -> [R; TERMS] {
        let by: [R; 4] =
            std::array::from_fn(|j| sum::<R, 4>(|i| self.unit[i][j] * v[i]) - self.held[j]);
        coefficients
            .map(|[p, q, r, s, loaded]| loaded + (by[0] * p + by[1] * q + by[2] * r + by[3] * s))
    }
}

/// The four homogeneous solutions and the particular solution of an element, as power series.
struct Solutions<R> {
    deflection: [Five<R>; TERMS],
    rotation: [Five<R>; TERMS],
    /// Shear strain γ.
    strain: [Five<R>; TERMS],
    moment: [Five<R>; TERMS],
    /// Vertical force τ.
    force: [Five<R>; TERMS],
    /// Upward force per length κ w − F on the beam: the ground reaction minus the load.
    pressure: [Five<R>; TERMS],
    /// Distributed moment N w′ − G − g on the beam, from the tension N, the shear layer under a sloped gap (G) and the
    /// moment load g.
    turning: [Five<R>; TERMS],
}

impl<R: Real> Solutions<R> {
    /// Computes the power series of the four homogeneous solutions and the particular solution, from the coefficients
    /// `of` of the beam equation and half the length `a` of the element.
    fn new(of: &Polynomials<R>, a: f64) -> Self {
        let zero = [[R::ZERO; 5]; TERMS];
        let mut all = Solutions {
            deflection: zero,
            rotation: zero,
            strain: zero,
            moment: zero,
            force: zero,
            pressure: zero,
            turning: zero,
        };
        all.start(of, a);
        let [stiffness, tension] = [trimmed(&of.stiffness), trimmed(&of.tension)];
        let spring = trimmed(&of.spring);
        let shear = of.shear.as_ref().map(|shear| {
            let mut both = *shear;
            both.iter_mut().zip(of.tension).for_each(|(both, n)| *both += n);
            (trimmed(shear), both)
        });
        let given = |c: &[R], j: usize| c.get(j).copied().unwrap_or_default();
        let mut bend = zero;
        for j in 0..TERMS - 1 {
            let mut from_axial = product(tension, &all.rotation, j, 0);
            from_axial[LOADED] -= given(&of.slope_load, j);
            let mut shear_force = minus(&all.force[j], &from_axial);
            if let Some((shear, both)) = &shear {
                let rest = minus(&shear_force, &product(both, &all.strain, j, 1));
                all.strain[j] = rest.map(|rest| rest / both[0]);
                shear_force = product(shear, &all.strain, j, 0);
                let more = product(tension, &all.strain, j, 0);
                from_axial.iter_mut().zip(more).for_each(|(from_axial, more)| *from_axial += more);
            }
            let bent = minus(&all.moment[j], &product(stiffness, &bend, j, 1));
            bend[j] = bent.map(|moment| moment / stiffness[0]);
            all.pressure[j] = product(spring, &all.deflection, j, 0);
            all.pressure[j][LOADED] -= given(&of.load, j);
            let mut curvature = bend[j];
            curvature[LOADED] += given(&of.curvature, j);
            shear_force[LOADED] += given(&of.moment_load, j);
            from_axial[LOADED] -= given(&of.moment_load, j);
            all.turning[j] = from_axial;

            let next = a / (j + 1) as f64;
            for i in 0..5 {
                all.deflection[j + 1][i] = (all.rotation[j][i] + all.strain[j][i]) * next;
                all.rotation[j + 1][i] = curvature[i] * next;
                all.moment[j + 1][i] = shear_force[i] * -next;
                all.force[j + 1][i] = all.pressure[j][i] * next;
            }
        }
        all
    }

    /// Sets the values of the five solutions in the middle of the element. The particular solution has φ′ = φ″ = 0, so
    /// constant imposed curvatures and moment loads do not bend the beam.
    fn start(&mut self, of: &Polynomials<R>, a: f64) {
        let [stiffness, tension] = [of.stiffness[0], of.tension[0]];
        let shear_force = -stiffness / (a * a * a);
        let turned = of.shear.map_or(R::ZERO, |shear| -shear_force / shear[0]);
        let [kappa, rise] = of.curvature;
        let bent = -stiffness * kappa;
        let balance = (stiffness * rise + of.stiffness[1] * kappa) / a - of.moment_load[0];
        let zero = R::ZERO;
        // The homogeneous solutions start with a deflection, a rotation, a moment, and a shear force with w′ = 0.
        self.deflection[0] = [R::ONE, zero, zero, zero, zero];
        self.rotation[0] = [zero, R::from(1.0 / a), zero, turned, zero];
        self.moment[0] = [zero, zero, stiffness / (a * a), zero, bent];
        self.force[0] = [zero, tension / a, zero, shear_force, balance - of.slope_load[0]];
    }

    /// Computes the element's four unknowns in each of the five solutions. The relative displacement of the right end
    /// is the integral of the shear strain and of the rotation relative to the left end.
    fn ends(&self, a: f64) -> [[R; 4]; 5] {
        let mut ends = [[R::ZERO; 4]; 5];
        for j in (0..TERMS).rev() {
            let mean = 1.0 / (j + 1) as f64;
            let sign = if j % 2 == 0 { 1.0 } else { -1.0 };
            for (i, [w, rotation, d1, d2]) in ends.iter_mut().enumerate() {
                let turned = self.rotation[j][i];
                *w += self.deflection[j][i] * sign;
                *rotation += turned * sign;
                if j % 2 == 0 {
                    *d1 += (self.strain[j][i] * mean - turned * (j as f64 * mean)) * (2.0 * a);
                } else {
                    *d1 += turned * (2.0 * a);
                    *d2 += turned * 2.0;
                }
            }
        }
        ends
    }

    /// Returns the forces that are work-conjugate to the four unknowns, in each of the five solutions: the virtual work
    /// in two rigid motions, then the vertical force and the moment at the right end.
    fn forces(&self, a: f64) -> [[R; 4]; 5] {
        let mut forces = [[R::ZERO; 4]; 5];
        for j in (0..TERMS).rev() {
            let [mean, first] = [1, 2].map(|power| 2.0 * a / (j + power) as f64);
            for (i, [rise, turn, force, moment]) in forces.iter_mut().enumerate() {
                let pressure = self.pressure[j][i];
                if j % 2 == 0 {
                    *rise += pressure * mean;
                    *turn += (self.turning[j][i] + pressure * a) * mean;
                } else {
                    *turn += pressure * (first * a);
                }
                *force += self.force[j][i];
                *moment += self.moment[j][i];
            }
        }
        forces
    }
}

/// Computes the amplitudes of the four homogeneous solutions for the values `wanted` of the unknowns. The last two
/// amplitudes are eliminated first, because the deformation depends almost only on them.
fn amplitudes<R: Real>(ends: &[[R; 4]; 4], wanted: [R; 4]) -> [R; 4] {
    let solve = |m: [[R; 2]; 2], r: [R; 2]| {
        let determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
        [
            (r[0] * m[1][1] - m[0][1] * r[1]) / determinant,
            (m[0][0] * r[1] - r[0] * m[1][0]) / determinant,
        ]
    };
    let block = |row: usize, column: usize| {
        [0, 1].map(|i| [0, 1].map(|j| ends[2 * column + j][2 * row + i]))
    };
    let bend = |r: [R; 2]| solve(block(1, 1), r);
    let across = |m: [[R; 2]; 2], x: [R; 2]| m.map(|row| row[0] * x[0] + row[1] * x[1]);
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

/// Superposes the forces on the element in the four homogeneous solutions, each multiplied by its amplitude in `by`.
fn combined<R: Real>(forces: &[[R; 4]; 4], by: &[R; 4]) -> [R; 4] {
    std::array::from_fn(|i| sum::<R, 4>(|j| by[j] * forces[j][i]))
}

/// Computes the coefficient of s^j of the product f g for each solution g. The first `skipped` coefficients of f are
/// omitted.
fn product<R: Real>(f: &[R], g: &[Five<R>; TERMS], j: usize, skipped: usize) -> Five<R> {
    let mut sum = [R::ZERO; 5];
    for (i, f) in f.iter().enumerate().take(j + 1).skip(skipped) {
        for (sum, g) in sum.iter_mut().zip(&g[j - i]) {
            *sum += *f * *g;
        }
    }
    sum
}

fn minus<R: Real>(a: &Five<R>, b: &Five<R>) -> Five<R> {
    std::array::from_fn(|i| a[i] - b[i])
}

mod tests;
