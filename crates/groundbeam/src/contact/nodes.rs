//! Solves the discrete problem (5.5), (5.10), (5.11): forces at nodes, and the exact beam between them in place of
//! (5.2).
//!
//! Newton's method finds the nodes in contact on meshes from coarse to fine ([`newton`](crate::nodal::newton)).

use crate::cancel::Cancel;
use crate::contact::edge_error::EdgeError;
use crate::contact::springs;
use crate::contact::state::{ContactState, Unconverged, turned};
use crate::contact::surface::{PointForce, Surface, SurfacePart};
use crate::element::ExactElement;
use crate::element::element::TERMS;
use crate::element::operator::{Operator, ZoneKind};
use crate::error::NotConverged;
use crate::mesh::deflection::{BeamPoint, Deflection, MeshZone};
use crate::mesh::mesh::{Mesh, Node};
use crate::model::Model;
use crate::nodal::grid::{Grid, Ground};
use crate::nodal::newton::Workspace;
use crate::nodal::quadratic::Loose;
use crate::nodal::{levels, newton, open};
use crate::numeric::polynomial::rescale;

/// Solves on about `elements` equal elements.
pub(crate) fn solve(
    model: &Model,
    elements: usize,
    cancel: &Cancel,
) -> Result<ContactState, Unconverged> {
    let mut grids = Vec::new();
    levels::grids(model, elements, Ground::Nodal, &mut grids);
    let mut workspace = Workspace { cancel: cancel.clone(), ..Workspace::default() };
    let found = workspace.contact(&grids, newton::ANSWER);
    let iterations = workspace.history.len();
    match (found, grids.last()) {
        (Ok(()), Some(grid)) => Ok(state(grid, workspace)),
        (Err(Loose), _) | (_, None) => Err(Unconverged { iterations, why: NotConverged::Nodes }),
    }
}

/// The mesh of a grid, with one cell per element.
pub(crate) fn mesh(grid: &Grid) -> Mesh {
    let mut cells = Vec::with_capacity(grid.last());
    let mut nodes = Vec::with_capacity(grid.last() + 1);
    for (run, place) in grid.runs.iter().zip(&grid.nodes) {
        for node in run.first..run.end() {
            let cell = run.element_cell(node);
            let place = if node == run.first { *place } else { Node::default() };
            nodes.push(Node { x: cell.x[0], ..place });
            cells.push(cell);
        }
    }
    nodes.extend(grid.nodes.last());
    Mesh { nodes, cells, axial_force: grid.axial_force, outside: grid.outside }
}

/// The point of the beam at a node of a mesh with `cells` cells.
pub(crate) fn point(node: usize, cells: usize) -> BeamPoint {
    if node == cells {
        BeamPoint { cell: node - 1, s: 1.0 }
    } else {
        BeamPoint { cell: node, s: -1.0 }
    }
}

/// Deflection, ground surface and ground forces on a solved grid.
pub(crate) fn state(grid: &Grid, mut workspace: Workspace) -> ContactState {
    workspace.clear_open(grid);
    let mesh = mesh(grid);
    let mut settlement = Vec::new();
    open::settlement(grid, &workspace.deflection, &workspace.zones, &mut settlement);
    let mut zones = Vec::new();
    let mut point_forces = Vec::new();
    let last = mesh.cells.len();
    for node in workspace.zones.iter().flat_map(|&[from, to]| from..=to) {
        let (point, force) = (point(node, last), workspace.force[node]);
        zones.push(MeshZone { from: point, to: point });
        point_forces.push(PointForce { point, force });
    }
    let (coefficients, rotation) = deflections(grid, &mesh, &workspace);
    let w = Deflection { mesh: &mesh, terms: TERMS, coefficients: &coefficients };
    let mut parts = Vec::with_capacity(last);
    for (cell, own) in mesh.cells.iter().enumerate() {
        if own.shear_layer == 0.0 {
            // The certificate uses the pressure of the springs under the deflection: a point force on Winkler ground
            // has infinite energy.
            springs::cover(&w, cell, &mut parts);
        } else {
            let open = Some([settlement[cell], settlement[cell + 1]]);
            parts.push(SurfacePart { cell, s: [-1.0, 1.0], open });
        }
    }
    ContactState {
        terms: TERMS,
        rotation,
        zones,
        history: workspace.history,
        at_nodes: true,
        surface: Some(Surface { parts, point_forces }),
        edge_error: EdgeError::default(),
        coefficients,
        mesh,
    }
}

/// Coefficients of w in each cell, and of the rotation of the cross-sections if the beam has shear flexibility.
fn deflections(grid: &Grid, mesh: &Mesh, workspace: &Workspace) -> (Vec<f64>, Vec<f64>) {
    let shears = mesh.cells.iter().any(|cell| cell.beam_shear.is_some());
    let mut w = vec![0.0; mesh.cells.len() * TERMS];
    let mut turns = vec![0.0; if shears { w.len() } else { 0 }];
    let element = |i: usize| {
        let operator = Operator::of(&mesh.cells[i], grid.axial_force, ZoneKind::Open);
        ExactElement::new(&operator, grid.runs[grid.run_at(i)].h)
    };
    let mut write = |i: usize, w: &mut [f64], element: &ExactElement, v: &[f64; 4]| {
        let own = &mut w[i * TERMS..(i + 1) * TERMS];
        own.copy_from_slice(&element.unfold(v).0);
        if let Some(rotation) = element.rotation(v) {
            turns[i * TERMS..(i + 1) * TERMS].copy_from_slice(&rotation);
        }
    };
    // Elements of a run with uniform loads have the same shape functions.
    let mut shared: Option<(usize, ExactElement)> = None;
    workspace.layout.each_element(grid, |i, v| {
        let run = grid.run_at(i);
        if !grid.runs[run].given.is_even() {
            return write(i, &mut w, &element(i), &v);
        }
        if shared.as_ref().is_none_or(|(of, _)| *of != run) {
            shared = Some((run, element(i)));
        }
        if let Some((_, element)) = &shared {
            write(i, &mut w, element, &v);
        }
    });
    for placed in workspace.layout.spans() {
        let shape = &workspace.layout.sides[placed.side].shapes[placed.stretch];
        let is_mirrored = placed.span.mirrored;
        placed.span.unfold(shape, |piece, own| {
            let [from, to] = piece.nodes;
            let Some((series, terms)) = piece.series(own) else {
                let own = if is_mirrored { piece.mirrored(own) } else { own };
                return write(from, &mut w, &element(from), &own);
            };
            let half = 0.5 / (to - from) as f64;
            for i in from..to {
                let middle = (2 * (i - from) + 1) as f64 * half;
                let [middle, half] =
                    if is_mirrored { [1.0 - middle, -half] } else { [middle, half] };
                let own = rescale(&series[..terms], middle, half);
                w[i * TERMS..][..terms].copy_from_slice(&own);
            }
        });
    }
    // Rotation in the cells without shear flexibility.
    let unset = turns.chunks_exact_mut(TERMS).zip(w.chunks_exact(TERMS)).zip(&mesh.cells);
    for ((turns, w), cell) in unset.filter(|(_, cell)| cell.beam_shear.is_none()) {
        let rotation = turned(cell, w);
        turns[..rotation.len()].copy_from_slice(&rotation);
    }
    (w, turns)
}
