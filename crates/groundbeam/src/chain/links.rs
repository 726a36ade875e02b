//! Adds to the stiffness of a cell the stiffness of the ground under it, where beam and ground do not touch.

use crate::chain::node::{ChainNode, OpenGround, Tie};

/// Settlement at one end of a cell as a linear function of the six unknowns of the cell: their coefficients, and a
/// gap that is subtracted.
pub(super) type Surface = ([f64; 6], f64);

/// Returns the settlement of the ground surface at a node as a function of the unknowns of the cell. `row` has the
/// coefficients of the surface unknown, and `beam` those of the deflection.
pub(super) fn counted(row: [f64; 6], node: &ChainNode, beam: [f64; 4]) -> Surface {
    let mut row = row;
    if !node.from_beam {
        return (row, 0.0);
    }
    row[..4].copy_from_slice(&beam);
    (row, node.gap)
}

/// Adds the open ground under a cell to the stiffness matrix `k` and the load vector `q`. `turned` converts the
/// settlements `surfaces` and the deflections `beam` at both ends to functions of the unknowns of `k`.
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
