//! A node and a cell of the chain: loads, springs, supports and open ground.

use crate::element::element::Element;
use crate::ground::link::TwoPort;

/// A cell: its element, and the open ground under it.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ChainCell {
    pub element: Element,
    pub open: Option<OpenGround>,
}

/// A node: its loads and supports, and the sides on which the settlement of the surface is an unknown.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ChainNode {
    pub force: f64,
    pub moment: f64,
    /// Whether w is prescribed, as the settlement of the support.
    pub pinned: bool,
    pub settlement: f64,
    pub clamped: bool,
    pub spring: f64,
    pub rotational_spring: f64,
    /// Rotational stiffness of a hinge, at which θ may jump. No other load or support then acts on θ at the node.
    pub hinge: Option<f64>,
    /// Stiffness of the ground outside if the beam is in contact at this node, and g₀ + u₀ there.
    pub ground_spring: f64,
    pub gap: f64,
    /// Stiffness of the ground outside if its surface is free at this node.
    pub surface_spring: f64,
    /// Whether u is an unknown of the cell to the left, and of the cell to the right.
    pub surface: [bool; 2],
    /// Whether the unknown of the surface is r = u − ψ instead of u.
    pub from_beam: bool,
}

/// The stiffness matrix is not positive definite: the elimination met a pivot ≤ 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct NotDefinite;

/// Indices into (w, θ, u), where the third entry is u or r.
pub(crate) const W: usize = 0;

pub(crate) const THETA: usize = 1;

pub(crate) const U: usize = 2;

/// ½ yᵀSy − rᵀy for y = (w, θ, u) of a node: the condensed energy of all cells on one side of it.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct CondensedStiffness {
    pub s: [[f64; 3]; 3],
    pub r: [f64; 3],
}

/// What one end of open ground is connected to, at the same end of the cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Tie {
    /// The free surface of the ground at the node.
    Surface,
    /// The beam: u = w − gap with g₀ + u₀.
    Beam { gap: f64 },
}

/// Open, unloaded ground under a cell, tied to the surface or to the beam at its left and right end.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OpenGround {
    pub two_port: TwoPort,
    pub ties: [Tie; 2],
}

impl ChainCell {
    /// The mirrored cell, so that the elimination from left to right also runs from right to left.
    pub fn mirrored(&self) -> Self {
        let open = self.open.map(|OpenGround { two_port, ties: [left, right] }| OpenGround {
            two_port: two_port.mirrored(),
            ties: [right, left],
        });
        ChainCell { element: self.element.mirrored(), open }
    }
}
