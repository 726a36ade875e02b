//! Elements of the beam, in element deformations.
//!
//! An element's four numbers are not the deflections and slopes of its two ends but those of the left
//! end and the *deformation* d = x_right − T x_left, with x = (w, θ) and T = \[\[1, h\], \[0, 1\]\]: what the
//! right end does beyond following the left one rigidly. Bending sees d alone, the ground sees mainly
//! the rigid part, and so the two never add up in one number: assembling EI/h³ beside kh loses all
//! digits as the mesh is refined, this does not. θ is the rotation of the sections: w' where the beam does not shear.

pub(crate) mod exact;
pub(crate) mod hermite;
mod series;
mod shear;

use crate::mesh::{Cell, GROUND};
use crate::model::Profile;
use crate::polynomial::value;
use crate::stability::MOST;
use shear::Shearing;

/// What an element's four numbers v are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Basis {
    /// (w_left, θ_left, d₁, d₂).
    #[default]
    Deformation,
    /// (w_left, θ_left, w_right, θ_right): for elements with boundary layers, whose ends turn easily while
    /// the whole, stretched, does not.
    Ends,
}

/// Energy ½ vᵀKv − qᵀv of an element.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Element {
    /// Length \[m\].
    pub length: f64,
    /// What v is.
    pub basis: Basis,
    /// K.
    pub stiffness: [[f64; 4]; 4],
    /// q.
    pub load: [f64; 4],
}

impl Element {
    /// What multiplies v in w at the element's left or right end.
    pub fn end_row(&self, right: bool) -> [f64; 4] {
        match (right, self.basis) {
            (false, _) => [1.0, 0.0, 0.0, 0.0],
            (true, Basis::Deformation) => [1.0, self.length, 1.0, 0.0],
            (true, Basis::Ends) => [0.0, 0.0, 1.0, 0.0],
        }
    }

    /// An element that an imposed curvature bends: q gets the work of EI κ₀, linear between its values
    /// `moments` at both ends, on w″. Rigid motions have no part in it.
    pub fn curl(&mut self, moments: [f64; 2]) {
        if moments == [0.0; 2] {
            return;
        }
        let [left, right] = moments;
        let rise = (right - left) / self.length;
        let work = match self.basis {
            Basis::Deformation => [0.0, 0.0, -rise, right],
            Basis::Ends => [rise, -left, -rise, right],
        };
        for (load, work) in self.load.iter_mut().zip(work) {
            *load += work;
        }
    }

    /// K v − q: what the element demands of its left end and of its deformation.
    pub fn forces(&self, v: &[f64; 4]) -> [f64; 4] {
        std::array::from_fn(|i| {
            self.stiffness[i].iter().zip(v).map(|(k, v)| k * v).sum::<f64>() - self.load[i]
        })
    }
}

/// Whether the beam rests on the ground along a whole cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Touch {
    /// u = w − g₀ all along.
    Contact,
    /// The ground is no part of the element.
    Open,
}

/// The coefficients of (EI w″)″ − (N w')' + κ w = F − G' on a cell, in contact or off it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Operator {
    /// EI.
    pub stiffness: f64,
    /// N: P, and μ in contact.
    pub tension: f64,
    /// κ: k in contact, else 0.
    pub spring: f64,
    /// F at both ends: f, and k g₀ in contact.
    pub load: [f64; 2],
    /// G at both ends: g, and μ g₀' in contact.
    pub moment_load: [f64; 2],
    /// EI κ₀ at both ends, of an imposed curvature κ₀.
    pub curling_moments: [f64; 2],
    /// Where any of them varies otherwise than this says: all of them by s, the above being their values at
    /// the middle and at the ends.
    pub courses: Option<Courses>,
    /// Where the beam shears: all of it by s.
    pub shearing: Option<Shearing>,
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
    fn of(cell: &Cell, axial_force: f64, touch: Touch) -> Option<Self> {
        let ground_varies = touch == Touch::Contact && cell.ground_varies();
        let varies = cell.beam_varies() || ground_varies;
        varies.then(|| Self::along(cell, axial_force, touch))
    }

    fn along(cell: &Cell, axial_force: f64, touch: Touch) -> Self {
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
    fn extremes(&self) -> [f64; 3] {
        let ends = |c: &[f64]| [-1.0, 0.0, 1.0].map(|s| value(c, s));
        let largest = |c: &[f64]| ends(c).into_iter().map(f64::abs).fold(0.0, f64::max);
        let least = ends(&self.stiffness).into_iter().fold(f64::INFINITY, f64::min);
        [least, largest(&self.tension), largest(&self.spring)]
    }
}

impl Operator {
    pub fn of(cell: &Cell, axial_force: f64, touch: Touch) -> Self {
        let off = Operator {
            stiffness: cell.stiffness,
            tension: axial_force,
            spring: 0.0,
            load: cell.load,
            moment_load: cell.moment_load,
            curling_moments: cell.curling_moments(),
            courses: Courses::of(cell, axial_force, touch),
            shearing: Shearing::of(cell, axial_force, touch),
        };
        if touch == Touch::Open {
            return off;
        }
        Operator {
            tension: axial_force + cell.shear,
            spring: cell.spring,
            load: [0, 1].map(|i| cell.load[i] + cell.spring * cell.gap[i] + cell.ground_load[i]),
            moment_load: cell.moment_load.map(|g| g + cell.shear * cell.gap_slope),
            ..off
        }
    }

    /// Whether a beam of some length keeps its shape in shear, S + N > 0, which compression may take from it; as good
    /// as lost is what leaves it waves too short to be looked at.
    pub fn bears_shear(&self, length: f64) -> bool {
        let shortest = MOST.sqrt();
        self.shearing.is_none_or(|s| s.is_stiff() && self.wave_number() * length <= shortest)
    }

    /// A bound of the largest |r| with EI r⁴ − N r² + κ = 0 \[1/m\]; where they vary, of the worst of it.
    /// A beam that shears has EI (1 + N/S) r⁴ − (N + EI κ/S) r² + κ = 0.
    pub fn wave_number(&self) -> f64 {
        if let Some(shearing) = &self.shearing {
            let [tension, spring] = shearing.like_bending();
            return wave_number(1.0, tension, spring);
        }
        let [stiffness, tension, spring] = match &self.courses {
            None => [self.stiffness, self.tension.abs(), self.spring],
            Some(courses) => courses.extremes(),
        };
        wave_number(stiffness, tension, spring)
    }
}

/// A bound of the largest |r| with EI r⁴ − N r² + κ = 0 \[1/m\], from EI, |N| and κ.
pub(crate) fn wave_number(stiffness: f64, tension: f64, spring: f64) -> f64 {
    let n = tension / stiffness;
    let k = spring / stiffness;
    (0.5 * (n + (n * n + 4.0 * k).sqrt())).sqrt()
}
