//! The coefficients of the beam equation on a cell, in contact or off it: (EI w″)″ − (N w′)′ + κ w = F − G′.

use crate::element::courses::{Courses, Touch};
use crate::element::element::MOST;
use crate::element::shear::Shearing;
use crate::mesh::cell::Cell;

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
