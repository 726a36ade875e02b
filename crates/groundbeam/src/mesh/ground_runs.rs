//! Runs of consecutive cells that all have a shear layer, or all have none.

use crate::mesh::mesh::Mesh;
use crate::numeric::real::Real;
use std::ops::Range;

/// Run of consecutive cells that either all have a shear layer or all have none.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct GroundRun<R = f64> {
    pub cells: Range<usize>,
    /// Whether μ > 0.
    pub pasternak: bool,
    /// Stiffness of the ground beyond the left and the right end of the run \[N/m\]. It is 0 between two runs, because
    /// ground with and without a shear layer is not coupled.
    pub beyond: [R; 2],
}

/// Divides the cells of a mesh into runs of consecutive cells that all have a shear layer or all have none. Returns
/// the runs from left to right.
pub(crate) fn ground_runs<R: Real>(mesh: &Mesh<R>) -> Vec<GroundRun<R>> {
    let kind = |i: usize| mesh.cells[i].shear_layer.value() > 0.0;
    let n = mesh.cells.len();
    let mut found = Vec::new();
    let mut start = 0;
    for end in 1..=n {
        if end == n || kind(end) != kind(start) {
            let beyond = [
                if start == 0 { mesh.outside[0] } else { R::ZERO },
                if end == n { mesh.outside[1] } else { R::ZERO },
            ];
            found.push(GroundRun { cells: start..end, pasternak: kind(start), beyond });
            start = end;
        }
    }
    found
}
