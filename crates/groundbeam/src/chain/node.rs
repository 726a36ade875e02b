//! Nodes and cells of the chain of elements, with their loads, springs and supports, and with the ground out of contact.

use crate::element::element::Element;
use crate::ground::link::TwoPort;
use crate::mesh::mesh::Node;

/// A cell of the mesh: its beam element, and the ground under the element if this ground is not in contact
/// (open ground).
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ChainCell {
    pub element: Element,
    pub open: Option<OpenGround>,
}

/// A node with its loads, springs and supports, and with the type of its surface unknown: settlement of the
/// ground surface, or settlement relative to the beam.
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
    /// Rotational stiffness of the hinge at this node; `None` without a hinge. A node with a hinge has neither
    /// an applied moment nor a rotational support.
    pub hinge: Option<f64>,
    /// Stiffness of the ground outside the beam at an end in contact; otherwise 0. It acts on the deflection minus
    /// `gap`.
    pub ground_spring: f64,
    /// Initial gap plus free-field settlement at the node.
    pub gap: f64,
    /// Stiffness of the ground outside the beam at an end out of contact; otherwise 0. It acts on the settlement of the
    /// surface.
    pub surface_spring: f64,
    /// Whether the settlement of the surface is an unknown, to the left and to the right of the node.
    pub surface: [bool; 2],
    /// Whether the surface unknown of the node is the settlement relative to the beam (u − w + gap) instead of the
    /// settlement u.
    pub from_beam: bool,
}

impl ChainNode {
    /// Returns a node with the loads, the supports and the hinge of a node of a mesh, without ground.
    pub fn of(node: &Node) -> Self {
        ChainNode {
            force: node.force,
            moment: node.moment,
            pinned: node.pinned,
            settlement: node.settlement,
            clamped: node.clamped,
            spring: node.spring,
            rotational_spring: node.rotational_spring,
            hinge: node.hinge,
            ..ChainNode::default()
        }
    }
}

/// Error for a stiffness matrix that is not positive definite: the elimination found a pivot ≤ 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct NotDefinite;

/// Index of the deflection among the three unknowns of a node: the deflection, the rotation and the unknown of the
/// ground surface.
pub(crate) const W: usize = 0;

pub(crate) const THETA: usize = 1;

pub(crate) const U: usize = 2;

/// Condensed stiffness and force of all cells on one side of a node. Their energy is ½ yᵀSy − rᵀy for the unknowns y of
/// the node.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct CondensedStiffness {
    pub s: [[f64; 3]; 3],
    pub r: [f64; 3],
}

/// Connection of one end of a stretch of ground that is out of contact: to the surface of the neighbouring
/// ground, or to the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Tie {
    /// This end of the ground is connected to the surface of the neighbouring ground, which is also out of
    /// contact.
    Surface,
    /// This end of the ground is connected to the beam. Its settlement is the deflection minus `gap`, which is
    /// the initial gap plus the free-field settlement.
    Beam { gap: f64 },
}

/// The unloaded ground under a cell, which is out of contact with the beam, and the connections of its two
/// ends.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OpenGround {
    pub two_port: TwoPort,
    pub ties: [Tie; 2],
}

impl ChainCell {
    /// Returns the mirrored cell. A sweep from the right mirrors the cells, and then uses the elimination of a
    /// sweep from the left.
    pub fn mirrored(&self) -> Self {
        let open = self.open.map(|OpenGround { two_port, ties: [left, right] }| OpenGround {
            two_port: two_port.mirrored(),
            ties: [right, left],
        });
        ChainCell { element: self.element.mirrored(), open }
    }
}
