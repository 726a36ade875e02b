//! Solves Kikuchi's discrete problem (5.5), (5.10), (5.11), in which the ground acts at nodes, with exact beam elements.
//!
//! The exact elements replace the cubic elements (5.2). Newton's method determines the nodes in contact, on meshes from
//! coarse to fine ([`newton`](crate::nodal::newton)).

use crate::cancel::Cancel;
use crate::contact::edge_error::EdgeError;
use crate::contact::springs;
use crate::contact::state::{ContactState, Unconverged, turned};
use crate::contact::surface::{PointForce, Surface, SurfacePart};
use crate::element::ExactElement;
use crate::element::operator::ZoneKind;
use crate::error::NotConverged;
use crate::mesh::cell::Cell;
use crate::mesh::deflection::{BeamPoint, Deflection, MeshZone};
use crate::mesh::mesh::{Mesh, Node};
use crate::model::Model;
use crate::nodal::grid::{Grid, Ground};
use crate::nodal::hull::Zone;
use crate::nodal::newton::Workspace;
use crate::nodal::quadratic::NotSolved;
use crate::nodal::{levels, newton, open};
use crate::numeric::polynomial::{TERMS, rescale};

/// The nodes in contact on a grid, and the deflection of the beam for this contact.
pub(crate) struct Solved {
    grid: Grid,
    workspace: Workspace,
    /// Nodes that divide the beam into cells with one closed-form solution each.
    ends: Vec<usize>,
}

impl Solved {
    pub fn new(grid: Grid, mut workspace: Workspace) -> Self {
        workspace.clear_open(&grid);
        let ends = ends(&grid, &workspace);
        Solved { grid, workspace, ends }
    }

    /// Number of cells into which the beam is divided: one for each element between nodes in contact, and a few for
    /// each part out of contact.
    pub fn cells(&self) -> usize {
        self.ends.len() - 1
    }

    /// Returns the deflection, the ground surface and the ground forces.
    pub fn state(self) -> ContactState {
        let Solved { grid, workspace, ends } = self;
        let mesh = mesh(&grid, &ends);
        let mut settlement = Vec::new();
        open::settlement(&grid, &workspace.deflection, &workspace.zones, &mut settlement);
        let mut zones = Vec::new();
        let mut point_forces = Vec::new();
        let last = mesh.cells.len();
        for &[from, to] in &workspace.zones {
            let first = index(&ends, from);
            let at = |node: usize| point(first + node - from, last);
            zones.push(MeshZone { from: at(from), to: at(to) });
            let force = |node: usize| PointForce { point: at(node), force: workspace.force[node] };
            point_forces.extend((from..=to).map(force));
        }
        let (coefficients, rotation) = deflections(&grid, &mesh, &ends, &workspace);
        let open = |cell: usize| [cell, cell + 1].map(|i| settlement[ends[i]]);
        let parts = surface_parts(&mesh, &coefficients, open);
        ContactState {
            rotation,
            zones,
            history: workspace.history,
            nodal_elements: Some(grid.last()),
            surface: Some(Surface { parts, point_forces }),
            edge_error: EdgeError::default(),
            coefficients,
            mesh,
        }
    }
}

/// Returns the parts of the ground surface. On a shear layer, the ground has no pressure between the nodes. `open` returns
/// its settlement at both ends of a cell, without the free-field settlement.
pub(crate) fn surface_parts(
    mesh: &Mesh,
    coefficients: &[f64],
    open: impl Fn(usize) -> [f64; 2],
) -> Vec<SurfacePart> {
    let w = Deflection { mesh, coefficients };
    let mut parts = Vec::with_capacity(mesh.cells.len());
    for (cell, own) in mesh.cells.iter().enumerate() {
        if own.shear_layer == 0.0 {
            // The certificate uses the distributed pressure. Without μ > 0, which (4.9) of Kikuchi's paper requires,
            // the complementary energy of nodal forces is infinite.
            springs::cover(&w, cell, &mut parts);
        } else {
            parts.push(SurfacePart { cell, s: [-1.0, 1.0], open: Some(open(cell)) });
        }
    }
    parts
}

/// Solves the discrete problem on about `elements` equal elements.
pub(crate) fn solve(
    model: &Model,
    elements: usize,
    cancel: &Cancel,
) -> Result<Solved, Unconverged> {
    let mut grids = Vec::new();
    levels::grids(model, elements, Ground::Nodal, &mut grids);
    let mut workspace = Workspace { cancel: cancel.clone(), ..Workspace::default() };
    let found = workspace.contact(&grids, newton::ANSWER);
    let iterations = workspace.history.len();
    match (found, grids.pop()) {
        (Ok(()), Some(grid)) => Ok(Solved::new(grid, workspace)),
        (Err(NotSolved), _) | (_, None) => {
            Err(Unconverged { iterations, why: NotConverged::Nodes })
        }
    }
}

/// Returns the mesh whose cells lie between consecutive nodes of the list `ends`. The list must contain the first
/// and the last node of every run of equal elements in the grid.
pub(crate) fn mesh(grid: &Grid, ends: &[usize]) -> Mesh {
    let cells = ends.windows(2).map(|ends| {
        let run = &grid.runs[grid.run_at(ends[0])];
        run.between([ends[0], ends[1]])
    });
    let cells: Vec<Cell> = cells.collect();
    let place = |(node, cell): (&usize, &Cell)| {
        let place = grid.place(*node).copied().unwrap_or_default();
        Node { x: cell.x[0], ..place }
    };
    let mut nodes: Vec<Node> = ends.iter().zip(&cells).map(place).collect();
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

/// Returns the ends of cells with one closed-form solution each. A short cell beside a contact zone keeps the error
/// estimate sharp.
fn ends(grid: &Grid, workspace: &Workspace) -> Vec<usize> {
    let last = grid.last();
    let near = |&[from, to]: &Zone| from.saturating_sub(1)..=(to + 1).min(last);
    let mut ends: Vec<usize> = workspace.zones.iter().flat_map(near).collect();
    for placed in workspace.layout.spans() {
        ends.extend(placed.span.ends());
    }
    ends.sort_unstable();
    ends.dedup();
    ends
}

/// The index of a node in a sorted list that contains it.
fn index(ends: &[usize], node: usize) -> usize {
    ends.partition_point(|end| *end < node)
}

/// Coefficients of w in each cell, and of the rotation of the cross-sections if the beam has shear
/// deformation.
fn deflections(
    grid: &Grid,
    mesh: &Mesh,
    ends: &[usize],
    workspace: &Workspace,
) -> (Vec<f64>, Vec<f64>) {
    let mut w = vec![0.0; mesh.cells.len() * TERMS];
    let mut turns = vec![0.0; if mesh.shears() { w.len() } else { 0 }];
    let element = |i: usize| ExactElement::of(&mesh.cells[i], grid.axial_force, ZoneKind::Open);
    let mut write = |i: usize, w: &mut [f64], element: &ExactElement, v: &[f64; 4]| {
        let own = &mut w[i * TERMS..(i + 1) * TERMS];
        own.copy_from_slice(&element.unfold(v).0);
        if let Some(rotation) = element.rotation(v) {
            turns[i * TERMS..(i + 1) * TERMS].copy_from_slice(&rotation);
        }
    };
    // A run consists of equal elements. If its loads are uniform, all its elements have the same shape
    // functions.
    let mut shared: Option<(usize, ExactElement)> = None;
    workspace.layout.each_element(grid, |node, v| {
        let (i, run) = (index(ends, node), grid.run_at(node));
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
            let [first, end] = piece.nodes.map(|node| index(ends, node));
            let Some((series, terms)) = piece.series(own) else {
                let own = if is_mirrored { piece.mirrored(own) } else { own };
                return write(first, &mut w, &element(first), &own);
            };
            // The middle and the half length of each cell are fractions of the length of `piece`, measured in the
            // direction of the sweep.
            let [from, to] = piece.nodes;
            let share = |nodes: usize| 0.5 * nodes as f64 / (to - from) as f64;
            for i in first..end {
                let (middle, half) =
                    (share(ends[i] + ends[i + 1] - 2 * from), share(ends[i + 1] - ends[i]));
                let [middle, half] =
                    if is_mirrored { [1.0 - middle, -half] } else { [middle, half] };
                let own = rescale(&series[..terms], middle, half);
                w[i * TERMS..][..terms].copy_from_slice(&own);
            }
        });
    }
    // This loop computes the rotation in the cells without shear deformation.
    let unset = turns.chunks_exact_mut(TERMS).zip(w.chunks_exact(TERMS)).zip(&mesh.cells);
    for ((turns, w), cell) in unset.filter(|(_, cell)| cell.beam_shear.is_none()) {
        let rotation = turned(cell, w);
        turns[..rotation.len()].copy_from_slice(&rotation);
    }
    (w, turns)
}
