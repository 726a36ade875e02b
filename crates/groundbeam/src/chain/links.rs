//! Adds the two-ports of open ground within a cell to the stiffness of the cell. Each end of a two-port is connected to
//! the surface of the ground at a node or to the beam.

use crate::chain::node::ChainNode;
use crate::chain::node::{Tie, TiedTwoPort};

/// u at both ends of a cell: the coefficients of the six unknowns of the cell, and the gap to subtract.
pub(super) struct Surfaces {
    pub left: ([f64; 6], f64),
    pub right: ([f64; 6], f64),
}

/// u at a node, from the unknown that represents it there: u itself or r = u − ψ.
pub(super) fn counted(row: [f64; 6], node: &ChainNode, beam: [f64; 4]) -> ([f64; 6], f64) {
    let mut row = row;
    if !node.from_beam {
        return (row, 0.0);
    }
    row[..4].copy_from_slice(&beam);
    (row, node.gap)
}

/// Adds a two-port to the stiffness and the force of six unknowns. `turned` transforms coefficients of the cell's
/// unknowns to coefficients of these unknowns.
pub(super) fn add_link(
    tied: &TiedTwoPort,
    surfaces: &Surfaces,
    turned: impl Fn(&[f64; 6]) -> [f64; 6],
    k: &mut [[f64; 6]; 6],
    q: &mut [f64; 6],
) {
    let functional = |tie: Tie| match tie {
        Tie::SurfaceLeft => surfaces.left,
        Tie::SurfaceRight => surfaces.right,
        Tie::Beam { row, gap } => ([row[0], row[1], row[2], row[3], 0.0, 0.0], gap),
    };
    let [(left, left_gap), (right, right_gap)] = [tied.left, tied.right].map(|tie| {
        let (row, gap) = functional(tie);
        (turned(&row), gap)
    });
    let difference: [f64; 6] = std::array::from_fn(|i| left[i] - right[i]);
    for (spring, row, gap) in [
        (tied.two_port.shunt_left, left, left_gap),
        (tied.two_port.shunt_right, right, right_gap),
        (tied.two_port.series, difference, left_gap - right_gap),
    ] {
        for i in 0..6 {
            q[i] += spring * row[i] * gap;
            for j in 0..6 {
                k[i][j] += spring * row[i] * row[j];
            }
        }
    }
}
