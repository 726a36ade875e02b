//! Interpolation of a deflection from one mesh to another.

use crate::contact::state::ContactState;
use crate::element::cubic as hermite;
use crate::mesh::cell::Cell;
use crate::mesh::mesh::Mesh;
use crate::numeric::polynomial::{jet, rescale};

/// The deflection of another mesh in the elements of this one: the same function where this one is finer,
/// else one with the same values and slopes at the nodes.
pub(crate) fn interpolated(mesh: &Mesh, found: &ContactState) -> Vec<[f64; 4]> {
    let w = found.deflection();
    let end = |x: f64, parent: usize| {
        let cell = &found.mesh.cells[parent];
        let [w, slope, ..] = jet(w.cell(parent), cell.local(x));
        [w, slope * 2.0 / cell.length()]
    };
    let within = |cell: &Cell| {
        let parent = found.mesh.cell_at(0.5 * (cell.x[0] + cell.x[1]));
        let from = &found.mesh.cells[parent];
        if from.x[0] <= cell.x[0] && cell.x[1] <= from.x[1] {
            let [a, b] = cell.x.map(|x| from.local(x));
            let c = rescale(w.cell(parent), 0.5 * (a + b), 0.5 * (b - a));
            return hermite::fold(&c, cell.length());
        }
        // At a hinge each side has a slope of its own.
        let before = found.mesh.cells.partition_point(|parent| parent.x[1] < cell.x[1]);
        let [w, slope] = end(cell.x[0], found.mesh.cell_at(cell.x[0]));
        let [next, next_slope] = end(cell.x[1], before.min(found.mesh.cells.len() - 1));
        [w, slope, next - w - slope * cell.length(), next_slope - slope]
    };
    mesh.cells.iter().map(within).collect()
}
