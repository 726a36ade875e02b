//! Elements of the beam, in element deformations.
//!
//! An element's four numbers are not the deflections and slopes of its two ends but those of the left
//! end and the *deformation* d = x_right − T x_left, with x = (w, θ) and T = \[\[1, h\], \[0, 1\]\]: what the
//! right end does beyond following the left one rigidly. Bending sees d alone, the ground sees mainly
//! the rigid part, and so the two never add up in one number: assembling EI/h³ beside kh loses all
//! digits as the mesh is refined, this does not.

pub(crate) mod exact;
pub(crate) mod hermite;

use crate::mesh::Cell;

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

/// The coefficients of EI w⁗ − N w″ + κ w = F − G' on a cell, in contact or off it.
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
}

impl Operator {
    pub fn of(cell: &Cell, axial_force: f64, touch: Touch) -> Self {
        let off = Operator {
            stiffness: cell.stiffness,
            tension: axial_force,
            spring: 0.0,
            load: cell.load,
            moment_load: cell.moment_load,
        };
        if touch == Touch::Open {
            return off;
        }
        Operator {
            tension: axial_force + cell.shear,
            spring: cell.spring,
            load: [0, 1].map(|i| cell.load[i] + cell.spring * cell.gap[i]),
            moment_load: cell.moment_load.map(|g| g + cell.shear * cell.gap_slope),
            ..off
        }
    }

    /// A bound of the largest |r| with EI r⁴ − N r² + κ = 0 \[1/m\].
    pub fn wave_number(&self) -> f64 {
        let n = self.tension.abs() / self.stiffness;
        let k = self.spring / self.stiffness;
        (0.5 * (n + (n * n + 4.0 * k).sqrt())).sqrt()
    }
}
