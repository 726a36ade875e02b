//! Adds the two-ports of open ground within a cell to the stiffness of the cell. Each end of a two-port is connected to
//! the surface of the ground at a node or to the beam.

use crate::chain::node::ChainNode;
use crate::chain::node::{Tie, TiedTwoPort};
use crate::numeric::real::Real;

/// u at both ends of a cell: the coefficients of the six unknowns of the cell, and the gap to subtract.
pub(super) struct Surfaces<R> {
    pub left: ([R; 6], R),
    pub right: ([R; 6], R),
}

/// u at a node, from the unknown that represents it there: u itself or r = u − ψ.
pub(super) fn counted<R: Real>(row: [f64; 6], node: &ChainNode<R>, beam: [R; 4]) -> ([R; 6], R) {
    let mut row = row.map(R::from);
    if !node.from_beam {
        return (row, R::ZERO);
    }
    row[..4].copy_from_slice(&beam);
    (row, node.gap)
}

/// Adds a two-port to the stiffness and the force of six unknowns. `turned` transforms coefficients of the cell's
/// unknowns to coefficients of these unknowns.
pub(super) fn add_link<R: Real>(
    tied: &TiedTwoPort<R>,
    surfaces: &Surfaces<R>,
    turned: impl Fn(&[R; 6]) -> [R; 6],
    k: &mut [[R; 6]; 6],
    q: &mut [R; 6],
) {
    let functional = |tie: Tie<R>| match tie {
        Tie::SurfaceLeft => surfaces.left,
        Tie::SurfaceRight => surfaces.right,
        Tie::Beam { row, gap } => ([row[0], row[1], row[2], row[3], R::ZERO, R::ZERO], gap),
    };
    let [(left, left_gap), (right, right_gap)] = [tied.left, tied.right].map(|tie| {
        let (row, gap) = functional(tie);
        (turned(&row), gap)
    });
    let difference: [R; 6] = std::array::from_fn(|i| left[i] - right[i]);
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
