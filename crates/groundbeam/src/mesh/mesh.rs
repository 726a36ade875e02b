//! Mesh of a model, with cells in which all data are polynomials, most of them constant or linear.
//!
//! Nodes are required at point loads, supports, hinges and corners of the gap, and at the ends of segments and
//! distributed loads. Each solution method adds nodes.

use crate::ground::link;
use crate::mesh::cell::Cell;
use crate::mesh::cell::Varies;
use crate::mesh::free_field::{self, Line};
use crate::model::{Action, CellPolynomial, Extent, Load, Model, SupportKind};
use crate::numeric::polynomial::value;
use crate::numeric::real::Real;
use crate::numeric::tolerance::same_place;

/// Node of a mesh, with the loads, supports and hinge of the beam at this point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Node<R = f64> {
    /// Position \[m\].
    pub x: f64,
    /// Point force, down \[N\].
    pub force: R,
    /// Point moment \[N·m\].
    pub moment: R,
    /// Whether a rigid support prescribes w. The prescribed value is the settlement of the support.
    pub pinned: bool,
    /// Settlement of the support \[m\].
    pub settlement: R,
    /// Whether a clamp prescribes zero rotation of the cross-sections.
    pub clamped: bool,
    /// Stiffness of a translational spring \[N/m\]. The spring force is proportional to w minus the settlement.
    pub spring: R,
    /// Stiffness of a rotational spring \[N·m/rad\].
    pub rotational_spring: R,
    /// Rotational stiffness of a hinge \[N·m/rad\]; `None` without a hinge. The rotation of the cross-sections may
    /// jump at a hinge.
    pub hinge: Option<R>,
    /// Whether w' may jump at the node even without a hinge. On a beam with shear deformation, w' jumps at a force, a
    /// support or a corner of the initial gap, and where S or μ jumps.
    pub kinked: bool,
}

/// Mesh of a beam: the nodes from left to right and the cells between them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Mesh<R = f64> {
    pub nodes: Vec<Node<R>>,
    pub cells: Vec<Cell<R>>,
    /// Axial force P \[N\], positive in tension.
    pub axial_force: R,
    /// Stiffness of the ground outside the left and the right end of the beam \[N/m\]. It is √(kμ) if this ground is
    /// uniform and infinite.
    pub outside: [R; 2],
}

impl<R: Real> Mesh<R> {
    /// Index of the cell that contains x. At a node, it is the index of the cell on the right.
    pub fn cell_at(&self, x: f64) -> usize {
        self.cells.partition_point(|cell| cell.x[1] <= x).min(self.cells.len() - 1)
    }

    /// Whether the beam has shear deformation anywhere.
    pub fn shears(&self) -> bool {
        self.cells.iter().any(|cell| cell.beam_shear.is_some())
    }

    /// The node nearest to x.
    pub fn node_at(&self, x: f64) -> usize {
        let right = self.nodes.partition_point(|node| node.x < x).min(self.nodes.len() - 1);
        let left = right.saturating_sub(1);
        if x - self.nodes[left].x < self.nodes[right].x - x { left } else { right }
    }
}

impl Mesh {
    /// Builds a mesh with the required nodes and with nodes at the positions `more`. Every interval between these
    /// nodes is divided into `parts` equal cells.
    pub fn build(model: &Model, more: &[f64], parts: impl Fn(&Cell) -> usize) -> Self {
        Self::cut(model, more, |cell, x| x.extend(cell.cuts(parts(cell))))
    }

    /// Builds a mesh whose intervals between the required nodes and `more` are halved until short power series
    /// represent the data of each cell. `cut` appends the positions at which each cell is divided further.
    pub fn graded(model: &Model, more: &[f64], cut: impl Fn(&Cell, &mut Vec<f64>)) -> Self {
        let axial = model.beam.axial_force;
        Self::cut(model, more, |cell, x| graded(cell, axial, &cut, x))
    }

    /// Halves the intervals between the required nodes as [`Self::graded`] does, and calls `each` for every cell and
    /// the number of parts of its interval that the free-field settlement needs. Returns the number of intervals.
    pub fn each_graded(model: &Model, mut each: impl FnMut(&Cell, usize)) -> usize {
        let coarse = cells_between(model, &required_positions(model, &[]));
        let axial = model.beam.axial_force;
        for cell in &coarse {
            let settles = pieces_of_settled(cell);
            each_smooth(cell, axial, MOST_HALVINGS, &mut |cell| each(cell, settles));
        }
        coarse.len()
    }

    /// Builds a mesh. The required nodes and the positions `more` divide the beam into intervals, and `cut` appends the
    /// positions at which each interval is divided further.
    fn cut(model: &Model, more: &[f64], cut: impl Fn(&Cell, &mut Vec<f64>)) -> Self {
        let coarse = cells_between(model, &required_positions(model, more));
        let mut x = Vec::with_capacity(2 * coarse.len());
        x.push(0.0);
        for cell in &coarse {
            let runs = pieces_of_settled(cell);
            for i in 0..runs {
                let s = [i, i + 1].map(|i| 2.0 * i as f64 / runs as f64 - 1.0);
                let part = if runs == 1 { *cell } else { cell.part(s) };
                cut(&part, &mut x);
                x.push(part.x[1]);
            }
        }
        let cells = if x.len() == coarse.len() + 1 { coarse } else { cells_between(model, &x) };
        Self::of(model, cells)
    }

    /// Builds the mesh with the nodes `x`, which include all required nodes.
    pub fn on(model: &Model, x: &[f64]) -> Self {
        Self::of(model, cells_between(model, x))
    }

    fn of(model: &Model, cells: Vec<Cell>) -> Self {
        let first = cells[0];
        let last = cells[cells.len() - 1];
        let ground = &model.foundation;
        let l = model.beam.length;
        let outside = [
            ground.beyond(false, l, first.ground_at(-1.0)),
            ground.beyond(true, l, last.ground_at(1.0)),
        ];
        let outside = outside.map(|beyond| link::outside(&beyond));
        let mut mesh =
            Mesh { nodes: nodes_of(&cells), cells, axial_force: model.beam.axial_force, outside };
        mesh.place_loads_and_supports(model);
        mesh.find_kinks();
        mesh
    }

    /// Marks the nodes at which w' may jump because the shear force S·(w' − φ) or the shear stiffness S jumps. φ is the
    /// rotation of the cross-section.
    fn find_kinks(&mut self) {
        for i in 1..self.cells.len() {
            let [left, right] = [&self.cells[i - 1], &self.cells[i]];
            let at = |cell: &Cell, s: f64| cell.beam_shear.map_or(0.0, |shear| value(&shear, s));
            if left.beam_shear.is_none() && right.beam_shear.is_none() {
                continue;
            }
            let node = &self.nodes[i];
            let pushed = node.force != 0.0 || node.pinned || node.spring != 0.0;
            let jump = at(left, 1.0) - at(right, -1.0);
            let stiffness_jumps = jump.abs() > ROUNDING_JUMP * at(left, 1.0);
            let ground_jumps = left.shear_layer_ends()[1] != right.shear_layer_ends()[0]
                || left.gap_slope != right.gap_slope
                || right.ground_force != 0.0;
            self.nodes[i].kinked = pushed || stiffness_jumps || ground_jumps;
        }
    }

    pub(super) fn place_loads_and_supports(&mut self, model: &Model) {
        for load in model.beam_loads() {
            let Extent::Point { at, size } = load.extent else { continue };
            let i = self.node_at(at);
            match load.action {
                Action::Force => self.nodes[i].force += size,
                Action::Moment => self.nodes[i].moment += size,
                // A curvature always acts along a stretch, not at a node.
                Action::Curvature => {}
            }
        }
        for hinge in &model.hinges {
            let i = self.node_at(hinge.at);
            self.nodes[i].hinge = Some(hinge.rotational_spring);
        }
        for support in &model.supports {
            let i = self.node_at(support.at);
            let node = &mut self.nodes[i];
            node.settlement = support.settlement;
            match support.kind {
                SupportKind::Pinned => node.pinned = true,
                SupportKind::Fixed => (node.pinned, node.clamped) = (true, true),
                SupportKind::Spring { spring, rotational_spring } => {
                    node.spring += spring;
                    node.rotational_spring += rotational_spring;
                }
            }
        }
    }
}

/// Largest relative jump of a stiffness that counts as a rounding error.
const ROUNDING_JUMP: f64 = 1e-13;

/// Maximum number of halvings of a cell.
const MOST_HALVINGS: u32 = 40;

fn graded(cell: &Cell, axial_force: f64, cut: &impl Fn(&Cell, &mut Vec<f64>), x: &mut Vec<f64>) {
    let mut first = true;
    each_smooth(cell, axial_force, MOST_HALVINGS, &mut |part| {
        if !std::mem::take(&mut first) {
            x.push(part.x[0]);
        }
        cut(part, x);
    });
}

/// Calls `each` for the smooth parts of a cell, from left to right. The cell is halved until the data of each part
/// are smooth.
fn each_smooth(cell: &Cell, axial_force: f64, halvings: u32, each: &mut impl FnMut(&Cell)) {
    if halvings == 0 || cell.is_smooth() && cell.shear_is_smooth(axial_force) {
        return each(cell);
    }
    each_smooth(&cell.part([-1.0, 0.0]), axial_force, halvings - 1, each);
    each_smooth(&cell.part([0.0, 1.0]), axial_force, halvings - 1, each);
}

/// Number of equal parts of a cell such that a short power series represents the free-field settlement in each part.
fn pieces_of_settled(cell: &Cell) -> usize {
    if !cell.has_free_field() || cell.shear_layer == 0.0 {
        return 1;
    }
    let fades = (cell.subgrade / cell.shear_layer).sqrt() * cell.length();
    fades.ceil().max(1.0) as usize
}

/// Returns the sorted positions of all required nodes and of `more`, without duplicates.
pub(crate) fn required_positions(model: &Model, more: &[f64]) -> Vec<f64> {
    let l = model.beam.length;
    let most = 2 * (1 + model.beam.segments.len() + model.foundation.segments.len())
        + 2 * model.loads.len()
        + model.supports.len()
        + model.hinges.len()
        + model.gap.len()
        + more.len();
    // The flag is true for positions of the model and false for positions from `more`.
    let mut places: Vec<(f64, bool)> = Vec::with_capacity(most);
    let mut own = |x: f64| places.push((x, true));
    [0.0, l].into_iter().for_each(&mut own);
    model.beam.segments.iter().flat_map(|s| [s.from, s.to]).for_each(&mut own);
    model.foundation.segments.iter().flat_map(|s| [s.from, s.to]).for_each(&mut own);
    for load in &model.loads {
        let [from, to] = load.extent.ends();
        own(from);
        if to != from {
            own(to);
        }
    }
    model.supports.iter().map(|s| s.at).for_each(&mut own);
    model.hinges.iter().map(|h| h.at).for_each(&mut own);
    model.gap.iter().map(|g| g.at).for_each(&mut own);
    places.extend(more.iter().map(|&x| (x, false)));
    places.retain(|&(x, _)| x >= 0.0 && x <= l);
    places.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let near = same_place(l);
    places.dedup_by(|next, last| {
        let same = next.0 - last.0 <= near;
        // If a position that the model requires and a position from `more` are nearly equal, the required position is
        // kept.
        if same && next.1 && !last.1 {
            *last = *next;
        }
        same
    });
    while places.len() > 1 && l - places[places.len() - 1].0 <= near {
        places.pop();
    }
    places[0].0 = 0.0;
    places.into_iter().map(|(x, _)| x).chain([l]).collect()
}

fn nodes_of(cells: &[Cell]) -> Vec<Node> {
    let first = cells.iter().take(1).map(|cell| cell.x[0]);
    let x = first.chain(cells.iter().map(|cell| cell.x[1]));
    x.map(|x| Node { x, ..Node::default() }).collect()
}

fn cells_between(model: &Model, x: &[f64]) -> Vec<Cell> {
    let mut cells = cells_of(model, x);
    if model.has_ground_loads() {
        let ground = &model.foundation;
        let (first, last) = (cells[0].ground_at(-1.0), cells[cells.len() - 1].ground_at(1.0));
        let length = model.beam.length;
        let [left, right] =
            [ground.beyond(false, length, first), ground.beyond(true, length, last)];
        let loads = free_field::ground_loads(model);
        free_field::settle(&Line { length, beyond: [&left, &right], loads: &loads }, &mut cells);
    }
    cells
}

/// Computes all data of the cells except the free-field settlement. The computed data depend linearly on the data of
/// the model.
pub(super) fn cells_of(model: &Model, x: &[f64]) -> Vec<Cell> {
    let even = |stiffness: f64| CellPolynomial::constant(stiffness).coefficients;
    let mut cells: Vec<Cell> = x
        .windows(2)
        .map(|x| Cell {
            x: [x[0], x[1]],
            stiffness: model.beam.bending_stiffness,
            subgrade: model.foundation.subgrade,
            shear_layer: model.foundation.shear_layer,
            beam_shear: model.beam.shear_stiffness.map(even),
            varies: Varies::default(),
            load: [0.0; 2],
            moment_load: [0.0; 2],
            curvature: [0.0; 2],
            gap: [0.0; 2],
            gap_slope: 0.0,
            ground_load: [0.0; 2],
            homogeneous_field: [0.0; 2],
            ground_force: 0.0,
        })
        .collect();
    for segment in &model.beam.segments {
        for cell in within(&mut cells, segment.from, segment.to) {
            let own = segment.shear_stiffness.map(|s| s.on([segment.from, segment.to], cell.x));
            let shear = own.or(model.beam.shear_stiffness.map(CellPolynomial::constant));
            cell.set_beam(&segment.course(cell.x), shear.as_ref());
        }
    }
    for segment in &model.foundation.segments {
        for cell in within(&mut cells, segment.from, segment.to) {
            cell.set_courses(&segment.courses(cell.x));
        }
    }
    for load in model.beam_loads().filter(|load| load.extent.is_distributed()) {
        let [from, to] = load.extent.ends();
        within(&mut cells, from, to).iter_mut().for_each(|cell| add_distributed(cell, load));
    }
    load_ground(model, &mut cells);
    if !model.gap.is_empty() {
        for cell in &mut cells {
            cell.gap = cell.x.map(|x| initial_gap(model, x));
            cell.gap_slope = gap_slope(model, 0.5 * (cell.x[0] + cell.x[1]));
        }
    }
    cells
}

/// Adds the loads on the ground to the data of the cells.
fn load_ground(model: &Model, cells: &mut [Cell]) {
    let middle = |cell: &Cell| 0.5 * (cell.x[0] + cell.x[1]);
    for load in model.ground_loads() {
        match load.extent {
            Extent::Distributed { from, to, .. } => {
                let first = cells.partition_point(|cell| middle(cell) <= from);
                let end = cells.partition_point(|cell| middle(cell) < to).max(first);
                for cell in &mut cells[first..end] {
                    load.extent.add_to(&mut cell.ground_load, cell.x);
                }
            }
            Extent::Point { at, size: force } => {
                // The force acts at the nearest node inside the beam. If two nodes are equally near, it acts at the
                // left node.
                let right = cells.partition_point(|cell| cell.x[0] < at).max(1);
                let distance =
                    |i: usize| cells.get(i).map_or(f64::INFINITY, |c| (c.x[0] - at).abs());
                let left = (right - 1).max(1);
                let nearest = if distance(left) <= distance(right) { left } else { right };
                if distance(nearest) <= same_place(model.beam.length) {
                    cells[nearest].ground_force += force;
                }
            }
        }
    }
}

/// Returns the cells between two positions.
fn within(cells: &mut [Cell], from: f64, to: f64) -> &mut [Cell] {
    let middle = |cell: &Cell| 0.5 * (cell.x[0] + cell.x[1]);
    let first = cells.partition_point(|cell| middle(cell) < from);
    let end = cells.partition_point(|cell| middle(cell) < to).max(first);
    &mut cells[first..end]
}

fn add_distributed(cell: &mut Cell, load: &Load) {
    let into = match load.action {
        Action::Force => &mut cell.load,
        Action::Moment => &mut cell.moment_load,
        Action::Curvature => &mut cell.curvature,
    };
    load.extent.add_to(into, cell.x);
}

/// Initial gap g₀(x). It is linear between its corners, and constant before the first and after the last corner.
fn initial_gap(model: &Model, x: f64) -> f64 {
    let corners = &model.gap;
    let right = corners.partition_point(|corner| corner.at < x);
    match (right.checked_sub(1).map(|i| corners[i]), corners.get(right)) {
        (Some(a), Some(b)) => (a.value * (b.at - x) + b.value * (x - a.at)) / (b.at - a.at),
        (Some(only), None) => only.value,
        (None, Some(only)) => only.value,
        (None, None) => 0.0,
    }
}

/// Slope g₀'(x) of the initial gap. The slope is 0 before the first and after the last corner of the gap.
fn gap_slope(model: &Model, x: f64) -> f64 {
    let right = model.gap.partition_point(|corner| corner.at < x);
    match (right.checked_sub(1).map(|i| model.gap[i]), model.gap.get(right)) {
        (Some(a), Some(b)) => (b.value - a.value) / (b.at - a.at),
        _ => 0.0,
    }
}

mod tests;
