//! Nodes and cells of the chain, with their loads, springs, supports and open ground.

use crate::element::element::Element;
use crate::ground::link::TwoPort;

/// A cell: its element, and the open ground under it.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ChainCell {
    pub element: Element,
    pub open: Option<OpenGround>,
}

/// A node with its loads and supports, and the kind of its surface unknown.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ChainNode {
    pub force: f64,
    pub moment: f64,
    /// Whether the deflection is prescribed: it then equals the settlement of the support.
    pub pinned: bool,
    pub settlement: f64,
    pub clamped: bool,
    pub spring: f64,
    pub rotational_spring: f64,
    /// Rotational stiffness of a hinge. At a node with a hinge, no other load or support acts on the rotation.
    pub hinge: Option<f64>,
    /// Stiffness of the ground outside the beam, if the beam is in contact at this node. `gap` is the initial gap
    /// plus the free-field settlement at the node.
    pub ground_spring: f64,
    pub gap: f64,
    /// Stiffness of the ground outside the beam, if the surface is free at this node.
    pub surface_spring: f64,
    /// Whether the settlement of the surface is an unknown, to the left and to the right of the node.
    pub surface: [bool; 2],
    /// Whether the surface unknown of the node is the settlement relative to the beam (u − w + gap) instead of the
    /// settlement u.
    pub from_beam: bool,
}

/// Error for a stiffness matrix that is not positive definite: the elimination found a pivot ≤ 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct NotDefinite;

/// Index of the deflection among the three unknowns of a node: deflection, rotation and surface unknown.
pub(crate) const W: usize = 0;

pub(crate) const THETA: usize = 1;

pub(crate) const U: usize = 2;

/// Condensed energy ½ yᵀSy − rᵀy of all cells on one side of a node. The vector y contains the three unknowns of
/// the node.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct CondensedStiffness {
    pub s: [[f64; 3]; 3],
    pub r: [f64; 3],
}

/// The object to which one end of open ground is tied.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Tie {
    /// The free surface at the node.
    Surface,
    /// The beam. The settlement of the ground is then the deflection minus `gap`, which is the initial gap plus the
    /// free-field settlement.
    Beam { gap: f64 },
}

/// Open, unloaded ground under a cell. Each of its ends is tied to the surface or to the beam.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OpenGround {
    pub two_port: TwoPort,
    pub ties: [Tie; 2],
}

impl ChainCell {
    /// Returns the mirrored cell. With mirrored cells, a sweep from the right uses the elimination for sweeps from
    /// the left.
    pub fn mirrored(&self) -> Self {
        let open = self.open.map(|OpenGround { two_port, ties: [left, right] }| OpenGround {
            two_port: two_port.mirrored(),
            ties: [right, left],
        });
        ChainCell { element: self.element.mirrored(), open }
    }
}
