//! Adds the open ground under a cell to the stiffness of the cell. Each end is tied to the surface of the ground at a node
//! or to the beam.

use crate::chain::node::{ChainNode, OpenGround, Tie};

/// u at one end of a cell: the coefficients of the six unknowns of the cell, and the gap to subtract.
pub(super) type Surface = ([f64; 6], f64);

/// u at a node, from the unknown that represents it there: u itself or r = u − ψ. `beam` gives w at the node.
pub(super) fn counted(row: [f64; 6], node: &ChainNode, beam: [f64; 4]) -> Surface {
    let mut row = row;
    if !node.from_beam {
        return (row, 0.0);
    }
    row[..4].copy_from_slice(&beam);
    (row, node.gap)
}

/// Adds open ground to the stiffness and the force of six unknowns. `surfaces` and `beam` give u of the surface and w of
/// the beam at both ends of the cell. `turned` transforms coefficients of the cell's unknowns to coefficients of these
/// unknowns.
pub(super) fn add_open_ground(
    open: &OpenGround,
    surfaces: [Surface; 2],
    beam: [[f64; 4]; 2],
    turned: impl Fn(&[f64; 6]) -> [f64; 6],
    k: &mut [[f64; 6]; 6],
    q: &mut [f64; 6],
) {
    let [(left, left_gap), (right, right_gap)] = [0, 1].map(|end| {
        let (row, gap) = match open.ties[end] {
            Tie::Surface => surfaces[end],
            Tie::Beam { gap } => {
                let [a, b, c, d] = beam[end];
                ([a, b, c, d, 0.0, 0.0], gap)
            }
        };
        (turned(&row), gap)
    });
    let difference: [f64; 6] = std::array::from_fn(|i| left[i] - right[i]);
    for (spring, row, gap) in [
        (open.two_port.shunt_left, left, left_gap),
        (open.two_port.shunt_right, right, right_gap),
        (open.two_port.series, difference, left_gap - right_gap),
    ] {
        for i in 0..6 {
            q[i] += spring * row[i] * gap;
            for j in 0..6 {
                k[i][j] += spring * row[i] * row[j];
            }
        }
    }
}
