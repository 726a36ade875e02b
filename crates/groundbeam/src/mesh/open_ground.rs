//! Computes the equivalent springs (two-ports) of ground without contact between two points of a mesh.

use crate::ground::link::TwoPort;
use crate::mesh::cell::Cell;
use crate::mesh::deflection::BeamPoint;
use crate::mesh::ground_runs::GroundRun;
use crate::mesh::mesh::Mesh;
use crate::mesh::varying::link;
use crate::numeric::real::Real;

/// Computes the ground displacement at the junctions of two-ports (the equivalent springs of ground out of contact) in
/// series, from its values at both ends. Also returns the two-port of the whole series.
///
/// Both passes, forward and backward, add only positive stiffnesses.
pub(crate) fn heights<R: Real>(
    links: &[TwoPort<R>],
    [start, end]: [R; 2],
) -> (Vec<R>, Option<TwoPort<R>>) {
    let mut so_far: Vec<TwoPort<R>> = Vec::with_capacity(links.len());
    for link in links {
        so_far.push(so_far.last().map_or(*link, |before| before.then(*link)));
    }
    let mut right = end;
    let mut values = vec![R::ZERO; links.len() + 1];
    values[0] = start;
    values[links.len()] = end;
    for i in (1..links.len()).rev() {
        let (before, next) = (so_far[i - 1], links[i]);
        let force = before.series * start + next.series * right;
        let stiffness = before.series + before.shunt_right + next.series + next.shunt_left;
        right = force / stiffness;
        values[i] = right;
    }
    (values, so_far.last().copied())
}

/// Returns the [`TwoPort`] of all [`open_links`] between two points in series. Returns `None` if the points coincide.
pub(crate) fn open_link<R: Real>(
    mesh: &Mesh<R>,
    run: &GroundRun<R>,
    from: Option<BeamPoint>,
    to: Option<BeamPoint>,
) -> Option<TwoPort<R>> {
    let links = open_links(mesh, run, from, to);
    links.into_iter().map(|(_, link)| link).reduce(TwoPort::then)
}

/// Returns the [`TwoPort`] of the ground out of contact in each cell between two points of `run`. If `from` or `to` is
/// `None`, all ground to the left or to the right is included, also outside `run`.
pub(crate) fn open_links<R: Real>(
    mesh: &Mesh<R>,
    run: &GroundRun<R>,
    from: Option<BeamPoint>,
    to: Option<BeamPoint>,
) -> Vec<(Option<(usize, [f64; 2])>, TwoPort<R>)> {
    let mut links = Vec::new();
    let first = from.unwrap_or(BeamPoint { cell: run.cells.start, s: -1.0 });
    let last = to.unwrap_or(BeamPoint { cell: run.cells.end - 1, s: 1.0 });
    if from.is_none() {
        let shunt_right = run.beyond[0];
        links.push((None, TwoPort { series: R::ZERO, shunt_left: R::ZERO, shunt_right }));
    }
    for cell in first.cell..=last.cell {
        let start = if cell == first.cell { first.s } else { -1.0 };
        let end = if cell == last.cell { last.s } else { 1.0 };
        if end > start {
            let link = cell_part(&mesh.cells[cell], start, end);
            links.push((Some((cell, [start, end])), link));
        }
    }
    if to.is_none() {
        let shunt_left = run.beyond[1];
        links.push((None, TwoPort { series: R::ZERO, shunt_left, shunt_right: R::ZERO }));
    }
    links
}

/// Two-port of the ground in a part of a cell that is out of contact.
pub(crate) fn cell_part<R: Real>(cell: &Cell<R>, from: f64, to: f64) -> TwoPort<R> {
    if cell.ground_varies() {
        return link(cell, [from, to]);
    }
    TwoPort::uniform(cell.subgrade, cell.shear_layer, 0.5 * (to - from) * cell.length())
}
