//! The state of a contact iteration: a deflection on its mesh, its contact zones, and the steps so far.

use crate::contact::edge_error::EdgeError;
use crate::contact::surface::Surface;
use crate::error::NotConverged;
use crate::mesh::cell::Cell;
use crate::mesh::deflection::{Deflection, MeshZone};
use crate::mesh::energy::Motion;
use crate::mesh::mesh::Mesh;
use crate::numeric::polynomial::{Coefficients, TERMS, derivative};
use crate::numeric::step::Step;

/// The deflection of a beam on a mesh, and its contact zones.
#[derive(Debug, Clone)]
pub(crate) struct ContactState {
    pub mesh: Mesh,
    /// [`TERMS`] polynomial coefficients of the deflection w for each cell, in the local coordinate s of the
    /// cell (−1 ≤ s ≤ 1).
    pub coefficients: Vec<f64>,
    /// [`TERMS`] coefficients per cell of the rotation φ of the cross-sections, in the local coordinate s; empty
    /// without shear deformation.
    pub rotation: Vec<f64>,
    /// Contact zones on the mesh. If the ground acts at nodes, every node of a zone is in contact.
    pub zones: Vec<MeshZone>,
    pub history: Vec<Step>,
    /// Number of elements of the discrete problem (5.5) of Kikuchi's paper, in which the ground acts only at nodes;
    /// `None` if the ground pressure is distributed.
    pub nodal_elements: Option<usize>,
    /// Ground surface and point forces if the ground acts at nodes; otherwise `None`, because the deflection and
    /// `zones` determine them.
    pub surface: Option<Surface>,
    pub edge_error: EdgeError,
}

impl ContactState {
    /// Creates the contact state of a deflection that was computed with exact elements on ground with distributed
    /// pressure.
    pub fn exact(
        mesh: Mesh,
        coefficients: Vec<f64>,
        rotation: Vec<f64>,
        zones: Vec<MeshZone>,
    ) -> Self {
        ContactState {
            mesh,
            coefficients,
            rotation,
            zones,
            history: Vec::new(),
            nodal_elements: None,
            surface: None,
            edge_error: EdgeError::default(),
        }
    }

    pub fn deflection(&self) -> Deflection<'_> {
        Deflection { mesh: &self.mesh, coefficients: &self.coefficients }
    }

    /// The deflection and the rotation of the beam.
    pub fn motion(&self) -> Motion<'_> {
        Motion { deflection: &self.coefficients, rotation: &self.rotation }
    }

    /// Returns the polynomial coefficients of the rotation φ of the cross-sections in cell i. Without shear
    /// deformation, φ equals w'.
    pub fn rotation(&self, i: usize) -> Coefficients {
        match self.rotation.get(i * TERMS..(i + 1) * TERMS) {
            Some(rotation) => rotation.into(),
            None => turned(&self.mesh.cells[i], self.deflection().cell(i)),
        }
    }
}

/// Computes the polynomial coefficients of the slope w' in a cell from those of the deflection w.
pub(crate) fn turned(cell: &Cell, deflection: &[f64]) -> Coefficients {
    let per_half = 2.0 / cell.length();
    let mut slope = derivative(deflection);
    slope.iter_mut().for_each(|c| *c *= per_half);
    slope
}

/// Returns the [`TERMS`] polynomial coefficients of the rotation in a cell with the deflection coefficients `w`. `own` has
/// those of an element with shear deformation. Without shear deformation, the rotation is the slope.
pub(crate) fn rotation_terms(own: Option<[f64; TERMS]>, cell: &Cell, w: &[f64]) -> Coefficients {
    own.map_or_else(|| turned(cell, w), |own| own[..].into()).at_least(TERMS)
}

/// An iteration that stopped without convergence.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Unconverged {
    pub iterations: usize,
    pub why: NotConverged,
}

impl Unconverged {
    /// Error of an iteration that stops because the beam, bonded to the ground in trial contact zones, is a mechanism.
    pub const SINGULAR: Unconverged = Unconverged { iterations: 0, why: NotConverged::Singular };
}

/// Returns the error value for an iteration whose contact edges have not converged. `moved` is the largest move of
/// an edge in the last step, relative to the length of the beam.
pub(crate) fn edges_not_converged(iterations: usize, moved: f64) -> Unconverged {
    Unconverged { iterations, why: NotConverged::Edges(moved) }
}
