//! The coefficients of the beam equation as polynomials along one cell.

use crate::mesh::cell::{Cell, GROUND};
use crate::model::Profile;
use crate::numeric::polynomial::value;

/// Whether the beam rests on the ground along a whole cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Touch {
    /// u = w − g₀ all along.
    Contact,
    /// The ground is no part of the element.
    Open,
}

/// Coefficients of EI, N, κ, F and G as polynomials of s ∈ \[−1, 1\].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Courses {
    pub stiffness: [f64; Profile::MOST],
    pub tension: [f64; GROUND],
    pub spring: [f64; GROUND],
    pub load: [f64; GROUND + 1],
    /// With what of EI κ₀ is not linear between the ends.
    pub moment_load: [f64; Profile::MOST],
}

impl Courses {
    pub fn of(cell: &Cell, axial_force: f64, touch: Touch) -> Option<Self> {
        let ground_varies = touch == Touch::Contact && cell.ground_varies();
        let varies = cell.beam_varies() || ground_varies;
        varies.then(|| Self::along(cell, axial_force, touch))
    }

    pub fn along(cell: &Cell, axial_force: f64, touch: Touch) -> Self {
        let linear = |v: [f64; 2]| [0.5 * (v[0] + v[1]), 0.5 * (v[1] - v[0])];
        let mut courses = Courses {
            stiffness: cell.stiffness_course(),
            tension: [0.0; GROUND],
            spring: [0.0; GROUND],
            load: [0.0; GROUND + 1],
            moment_load: cell.curling_moment_load(),
        };
        courses.tension[0] = axial_force;
        courses.load[..2].copy_from_slice(&linear(cell.load));
        for (i, g) in linear(cell.moment_load).into_iter().enumerate() {
            courses.moment_load[i] += g;
        }
        if touch == Touch::Contact {
            courses.spring = cell.spring_course();
            let gap = linear(cell.gap);
            for (load, q) in courses.load.iter_mut().zip(linear(cell.ground_load)) {
                *load += q;
            }
            for (i, mu) in cell.shear_course().into_iter().enumerate() {
                courses.tension[i] += mu;
                courses.moment_load[i] += mu * cell.gap_slope;
            }
            for (i, k) in courses.spring.iter().enumerate() {
                courses.load[i] += k * gap[0];
                courses.load[i + 1] += k * gap[1];
            }
        }
        courses
    }

    /// The least EI, the largest |N| and the largest κ at the ends and the middle.
    pub fn extremes(&self) -> [f64; 3] {
        let ends = |c: &[f64]| [-1.0, 0.0, 1.0].map(|s| value(c, s));
        let largest = |c: &[f64]| ends(c).into_iter().map(f64::abs).fold(0.0, f64::max);
        let least = ends(&self.stiffness).into_iter().fold(f64::INFINITY, f64::min);
        [least, largest(&self.tension), largest(&self.spring)]
    }
}
