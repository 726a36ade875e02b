//! Nodes and elements of the discrete problem, from a model.
//!
//! The grid stores rows of equal elements. A row has only one element where EI, k or μ varies, where the beam has shear
//! deformation, and where loads act on the ground.

use super::beam::{Beam, LONGEST_ELEMENT};
use super::form::Form;
use super::layer::Layer;
use crate::element::element::Element;
use crate::element::operator::{Operator, ZoneKind};
use crate::element::{ExactElement, parts};
use crate::ground::link::TwoPort;
use crate::mesh::cell::{Cell, gap_at};
use crate::mesh::mesh::{Mesh, Node};
use crate::mesh::open_ground::cell_part;
use crate::model::Model;
use crate::nodal::beam::Given;
use crate::numeric::polynomial::integral;

/// Minimum EI on a coarse grid, relative to h²(P + μ + kh²) with the element length h and the tension P. A smaller EI
/// is raised to this value.
const STIFF: f64 = 0.5;

/// A run of equal elements.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Run {
    /// Data of beam and ground along this row of equal elements.
    pub cell: Cell,
    /// Distributed loads and imposed curvature along this row of equal elements.
    pub given: Given,
    /// Sum of the initial gap and the free-field settlement at the first and the last node of this row. The sum is
    /// linear between these nodes.
    pub gap: [f64; 2],
    /// Beam element without ground of a row that is not uniform (see [`is_even`]) and so has only one element. `None`
    /// for a row of equal elements.
    pub element: Option<Element>,
    /// First node of this row of equal elements.
    pub first: usize,
    /// Number of elements of this row.
    pub count: usize,
    /// Length of an element.
    pub h: f64,
    /// Two-port of the ground under one element.
    pub link: TwoPort,
    /// Energy of the elements of this row, with ground bonded to both ends of each element, for the elimination from
    /// the left and from the right end of the beam.
    pub bonded: [Form; 2],
    /// Uniform ground under this row of equal elements.
    pub layer: Layer,
    /// Equivalent springs of the ground out of contact between the two ends of this row of elements.
    whole: TwoPort,
    /// Two-ports of the ground out of contact to the left of the first node and to the right of the last node. They
    /// include the ground outside the beam.
    beyond: [TwoPort; 2],
}

impl Run {
    /// Divides a cell into `count` elements, the first of which begins at the node `first`.
    fn new(cell: &Cell, first: usize, count: usize, axial_force: f64, ground: Ground) -> Self {
        let h = cell.length() / count as f64;
        let layer = match ground {
            Ground::Nodal => Layer::new(cell.subgrade, cell.shear_layer),
            Ground::Spread => Layer::at_nodes(cell.subgrade, cell.shear_layer, h),
        };
        let element =
            (!is_even(cell)).then(|| ExactElement::of(cell, axial_force, ZoneKind::Open).element);
        let [whole, link] = if cell.shear_layer == 0.0 {
            [springs(cell, h); 2]
        } else if element.is_none() {
            [layer.open(cell.length()), layer.open(h)]
        } else if ground == Ground::Nodal {
            [cell_part(cell, -1.0, 1.0); 2]
        } else {
            [layer.open(h); 2]
        };
        let mut run = Run {
            cell: *cell,
            given: Given::of(cell),
            gap: [-1.0, 1.0].map(|s| gap_at(cell, s)),
            element,
            first,
            count,
            h,
            link,
            bonded: Default::default(),
            layer,
            whole,
            beyond: Default::default(),
        };
        let form = run.first_bonded(axial_force, false);
        let alike = run.is_alike() && run.given.moment_load[0] == 0.0 && element.is_none();
        run.bonded = [form, if alike { form } else { run.first_bonded(axial_force, true) }];
        run
    }

    /// Computes the energy of the elements of this row with bonded ground, for the elimination from the left end of the
    /// beam, or from its right end if `mirrored` is true.
    fn first_bonded(&self, axial_force: f64, mirrored: bool) -> Form {
        let turned = |pair: [f64; 2]| if mirrored { [pair[1], pair[0]] } else { pair };
        let link = if mirrored { self.link.mirrored() } else { self.link };
        if let Some(element) = &self.element {
            let element = if mirrored { element.mirrored() } else { *element };
            return Form::of(&element).on(link, turned(self.gap));
        }
        let last = self.count - 1;
        let form = |element: usize| {
            let from = self.first + if mirrored { last - element } else { element };
            let part = self.part(from, from + 1);
            let given = if mirrored { part.mirrored() } else { part };
            let beam = Beam::new(self.cell.stiffness, &given, axial_force, self.h);
            let gap = turned([from, from + 1].map(|node| self.gap_at(node)));
            Form::beam(self.h, beam.stiffness(), beam.load()).on(link, gap)
        };
        let first = form(0);
        if self.is_alike() { first } else { first.towards(&form(last), self.count) }
    }

    /// Whether distributed loads, imposed curvature and gap are constant along this row of elements.
    fn is_alike(&self) -> bool {
        self.given.is_even() && self.gap[0] == self.gap[1]
    }

    pub fn length(&self) -> f64 {
        self.cell.length()
    }

    /// Sum of the initial gap and the free-field settlement at a node of this row of equal elements.
    pub fn gap_at(&self, node: usize) -> f64 {
        let [left, right] = self.gap;
        match node - self.first {
            0 => left,
            steps if steps == self.count => right,
            steps => left + (right - left) * (steps as f64 / self.count as f64),
        }
    }

    /// Last node of this row of equal elements, which is the right end of its last element.
    pub fn end(&self) -> usize {
        self.first + self.count
    }

    /// Distributed loads and imposed curvature between two nodes of this row of equal elements.
    pub fn part(&self, from: usize, to: usize) -> Given {
        if self.given.is_even() {
            return self.given;
        }
        self.given.part([from, to].map(|node| (node - self.first) as f64 / self.count as f64))
    }

    /// Equivalent springs of the ground out of contact between two nodes of this row of equal elements.
    pub fn open(&self, from: usize, to: usize) -> TwoPort {
        if to - from == self.count || self.cell.shear_layer == 0.0 {
            return self.whole;
        }
        self.layer.open(self.h * (to - from) as f64)
    }

    /// Position of a node \[m\], computed from the nearer end of this row of equal elements.
    pub fn x(&self, node: usize) -> f64 {
        let ([left, right], count) = (self.cell.x, self.count as f64);
        let (before, after) = ((node - self.first) as f64, (self.end() - node) as f64);
        if before <= after {
            left + self.length() * (before / count)
        } else {
            right - self.length() * (after / count)
        }
    }

    /// Data of beam and ground between two nodes of this row of equal elements.
    pub fn between(&self, [from, to]: [usize; 2]) -> Cell {
        if to - from == self.count {
            return self.cell;
        }
        let count = self.count as f64;
        let at = |node: usize| match node - self.first {
            0 => -1.0,
            steps if steps == self.count => 1.0,
            // The coordinate of the node is computed from the nearer end of the row of equal elements.
            steps if 2 * steps <= self.count => 2.0 * steps as f64 / count - 1.0,
            steps => 1.0 - 2.0 * (self.count - steps) as f64 / count,
        };
        self.cell.part([at(from), at(to)])
    }

    /// Number of stretches into which a part of the beam off the ground is divided, so that one series represents the
    /// deflection of each stretch.
    pub fn pieces(&self, axial_force: f64, length: f64) -> usize {
        pieces(&self.cell, axial_force, length)
    }
}

/// Number of elements of a cell, for `per_length` elements per unit length.
fn equal(cell: &Cell, per_length: f64) -> usize {
    (cell.length() * per_length).round() as usize
}

/// Whether a cell is uniform and so can be divided into equal elements.
pub(crate) fn is_even(cell: &Cell) -> bool {
    let varies = cell.beam_varies() || cell.ground_varies() || cell.beam_shear.is_some();
    !varies && !cell.has_free_field()
}

/// Minimum number of elements of a cell. The free-field settlement needs at least `settles` elements.
pub(crate) fn fewest_in(cell: &Cell, axial_force: f64, settles: usize) -> usize {
    pieces(cell, axial_force, cell.length()).max(settles)
}

/// Number of stretches into which a beam out of contact is divided, so that one power series represents the deflection
/// of each stretch.
fn pieces(cell: &Cell, axial_force: f64, length: f64) -> usize {
    let operator = Operator::of(cell, axial_force, ZoneKind::Open);
    if operator.polynomials.is_some() {
        return parts(&operator, length);
    }
    let wave = (axial_force / cell.stiffness).abs().sqrt();
    (wave * length / LONGEST_ELEMENT).ceil().max(1.0) as usize
}

/// Two-port of the Winkler springs (μ = 0) under an element. The springs of each half of the element act at the
/// nearer end of the element.
fn springs(cell: &Cell, h: f64) -> TwoPort {
    let mean = 0.5 * h * cell.subgrade;
    let [left, right] = if cell.ground_varies() {
        let sum = integral(&cell.subgrade_along(), 0.5 * h, 0.0);
        let at = |s: f64| crate::numeric::polynomial::value(&sum, s);
        [at(0.0) - at(-1.0), at(1.0) - at(0.0)]
    } else {
        [mean; 2]
    };
    TwoPort { series: 0.0, shunt_left: left, shunt_right: right }
}

/// Raises EI until the waves of the deflection are no shorter than the length `h`.
fn stiffen(cell: &mut Cell, axial_force: f64, h: f64) {
    let tension = axial_force.max(0.0) + cell.shear_layer;
    let least = STIFF * h * h * (tension + cell.subgrade * h * h);
    if cell.stiffness < least {
        cell.stiffen(least / cell.stiffness);
    }
}

/// Discretisation of the ground, whose forces act at the nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Ground {
    /// Ground reactions as point forces at the nodes, (5.5) of the paper. Between the nodes, the displacement of the
    /// ground is the exact solution for unloaded ground.
    Nodal,
    /// Ground reactions as point forces at the nodes. Between the nodes the shear layer is linear. The springs are
    /// lumped at the nodes by the trapezoidal rule, for elements of any length.
    Spread,
}

/// Grid of the beam: rows of equal elements from left to right, with the loads, supports and hinges at the nodes
/// between the rows.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    pub runs: Vec<Run>,
    /// Loads, supports and hinges at the first node of each row of equal elements, and at the last node of the grid.
    pub nodes: Vec<Node>,
    pub axial_force: f64,
    /// Stiffness of the ground outside the left and the right end of the beam; √(kμ) if this ground is uniform and
    /// infinite.
    pub outside: [f64; 2],
    /// Whether the iteration may stop while one node per contact zone still changes between contact and no contact.
    /// This is sufficient if the next grid is only a few times finer.
    pub rough: bool,
    /// Whether the sum of the initial gap and the free-field settlement is zero everywhere.
    pub flat: bool,
    /// Nodes on rigid supports, and the settlement of the support at each node.
    pub pins: Vec<(usize, f64)>,
}

impl Grid {
    /// Creates a grid of about `elements` equal elements, with a node at every position where the model requires a
    /// node.
    pub fn new(model: &Model, elements: usize, ground: Ground) -> Self {
        let per_length = elements as f64 / model.beam.length;
        Self::cut(model, ground, |cell| (equal(cell, per_length), 0.0))
    }

    /// Creates a grid as [`Grid::new`] does, but raises EI until the waves of the deflection are no shorter than an
    /// element.
    pub fn stiffened(model: &Model, elements: usize, ground: Ground) -> Self {
        let per_length = elements as f64 / model.beam.length;
        Self::cut(model, ground, |cell| (equal(cell, per_length), 1.0 / per_length))
    }

    /// Creates a grid. `divide` returns the minimum number of elements of a cell, and a length. EI is raised until the
    /// waves of the deflection are no shorter than this length.
    pub fn cut(model: &Model, ground: Ground, divide: impl Fn(&Cell) -> (usize, f64)) -> Self {
        let axial_force = model.beam.axial_force;
        let count = |cell: &Cell| {
            let (wanted, h) = divide(cell);
            let mut cell = *cell;
            stiffen(&mut cell, axial_force, h);
            wanted.max(pieces(&cell, axial_force, cell.length())).max(1)
        };
        let one_each = |cell: &Cell| if is_even(cell) { 1 } else { count(cell) };
        let mut mesh = Mesh::graded(model, &[], |cell, x| x.extend(cell.cuts(one_each(cell))));
        let mut first = 0;
        let runs = mesh.cells.iter_mut().map(|cell| {
            let count = if is_even(cell) { count(cell) } else { 1 };
            let (_, h) = divide(cell);
            stiffen(cell, axial_force, h);
            let run = Run::new(cell, first, count, axial_force, ground);
            first += count;
            run
        });
        let runs: Vec<Run> = runs.collect();
        let mut grid = Grid {
            flat: runs.iter().all(|run| run.gap == [0.0; 2]),
            runs,
            nodes: mesh.nodes,
            axial_force,
            outside: mesh.outside,
            rough: false,
            pins: Vec::new(),
        };
        let pins = grid.firsts().zip(&grid.nodes).filter(|(_, node)| node.pinned);
        grid.pins = pins.map(|(i, node)| (i, node.settlement)).collect();
        grid.chain();
        grid
    }

    /// Computes the equivalent springs of the ground to the left and to the right of each row of equal elements.
    fn chain(&mut self) {
        let spring = TwoPort::default();
        let mut link = TwoPort { shunt_right: self.outside[0], ..spring };
        for run in &mut self.runs {
            run.beyond[0] = link;
            link = link.then(run.whole);
        }
        link = TwoPort { shunt_left: self.outside[1], ..spring };
        for run in self.runs.iter_mut().rev() {
            run.beyond[1] = link;
            link = run.whole.then(link);
        }
    }

    /// The largest wave number of the beam on its ground.
    pub fn wave_number(&self) -> f64 {
        let of =
            |run: &Run| Operator::of(&run.cell, self.axial_force, ZoneKind::Contact).wave_number();
        self.runs.iter().map(of).fold(0.0, f64::max)
    }

    /// Minimum number of elements of a model. Where the beam is out of contact, each element must be so short that one
    /// power series represents the deflection.
    pub fn fewest(model: &Model) -> usize {
        let axial_force = model.beam.axial_force;
        let mut fewest = 0_usize;
        Mesh::each_graded(model, |cell, settles| {
            fewest = fewest.saturating_add(fewest_in(cell, axial_force, settles));
        });
        fewest
    }

    /// Force needed to raise the whole ground by one unit.
    pub fn stiffness(&self) -> f64 {
        let springs = self.runs.iter().map(|run| run.cell.subgrade * run.length());
        springs.sum::<f64>() + self.outside[0] + self.outside[1]
    }

    /// The last node.
    pub fn last(&self) -> usize {
        self.runs.last().map_or(0, Run::end)
    }

    /// First node of each row of equal elements, and the last node of the grid.
    pub fn firsts(&self) -> impl Iterator<Item = usize> {
        self.runs.iter().map(|run| run.first).chain([self.last()])
    }

    /// Index of the row of equal elements that contains the element to the right of a node; for the last node, the
    /// index of the last row.
    pub fn run_at(&self, node: usize) -> usize {
        self.runs.partition_point(|run| run.end() <= node).min(self.runs.len() - 1)
    }

    pub fn x(&self, node: usize) -> f64 {
        self.runs[self.run_at(node)].x(node)
    }

    /// Sum of the initial gap and the free-field settlement at a node.
    pub fn gap(&self, node: usize) -> f64 {
        if self.flat {
            return 0.0;
        }
        self.runs[self.run_at(node)].gap_at(node)
    }

    /// The node nearest to a position.
    pub fn nearest(&self, x: f64) -> usize {
        let run = self.runs.partition_point(|run| run.cell.x[1] < x).min(self.runs.len() - 1);
        let run = &self.runs[run];
        let steps = ((x - run.cell.x[0]) / run.h).round().max(0.0) as usize;
        run.first + steps.min(run.count)
    }

    /// Splits the elements between two nodes into parts, each within one row of equal elements. A part is given by
    /// the index of its row, its first node and its last node.
    pub fn parts(&self, from: usize, to: usize) -> impl Iterator<Item = (usize, usize, usize)> {
        let first = self.run_at(from);
        let ends = self.runs[first..].iter().take_while(move |run| run.first < to);
        let parts = ends
            .enumerate()
            .map(move |(i, run)| (first + i, run.first.max(from), run.end().min(to)));
        parts.filter(|(_, from, to)| from < to)
    }

    /// Equivalent springs of the ground out of contact between two nodes; `None` if the nodes coincide.
    pub fn link(&self, from: usize, to: usize) -> Option<TwoPort> {
        let links = self.parts(from, to).map(|(run, from, to)| self.runs[run].open(from, to));
        links.reduce(TwoPort::then)
    }

    /// Two-port of all ground to the left of a node, including the ground outside the beam. This ground is out of
    /// contact.
    pub fn left_of(&self, node: usize) -> TwoPort {
        let run = &self.runs[self.run_at(node)];
        let [before, _] = run.beyond;
        if node == run.first { before } else { before.then(run.open(run.first, node)) }
    }

    /// Two-port of all ground to the right of a node, including the ground outside the beam. This ground is out of
    /// contact.
    pub fn right_of(&self, node: usize) -> TwoPort {
        let run = &self.runs[self.run_at(node.max(1) - 1)];
        let [_, after] = run.beyond;
        if node == run.end() { after } else { run.open(node, run.end()).then(after) }
    }

    /// Loads, supports and hinge at a node; `None` if the node lies inside a row of equal elements.
    pub fn place(&self, node: usize) -> Option<&Node> {
        let run = self.run_at(node);
        if self.runs[run].first == node {
            self.nodes.get(run)
        } else {
            self.nodes.get(run + 1).filter(|_| node == self.last())
        }
    }
}
