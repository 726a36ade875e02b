//! Nodes and elements of the discrete problem, from a model: runs of equal elements between its places.
//!
//! Runs, not elements, are what is stored. Where EI, k or μ varies, the beam shears, or loads act on the ground, each
//! element is a run of its own.

use super::beam::{Beam, REACH};
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

/// EI over h²(N + kh²) of a stiffened beam: no more than its own where its waves are longer than h.
const STIFF: f64 = 0.5;

/// Equal elements in a row.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Run {
    /// The whole run of beam and ground.
    pub cell: Cell,
    /// What is given along it.
    pub given: Given,
    /// g₀ + u₀ at its first and its last node; linear between them.
    pub gap: [f64; 2],
    /// The element of a run of one, off the ground, where the closed form of even beams does not serve.
    pub element: Option<Element>,
    /// Its first node, and how many elements follow.
    pub first: usize,
    pub count: usize,
    /// Their length.
    pub h: f64,
    /// The ground under one of them, bonded at both ends.
    pub link: TwoPort,
    /// What a sweep crosses there: the first element in its direction, from the left and from the right.
    pub glued: [Form; 2],
    /// The ground, and all of it open from the first node to the last.
    pub layer: Layer,
    whole: TwoPort,
    /// Open ground and the ground outside the beam, on the left of the first node and on the right of the last.
    beyond: [TwoPort; 2],
}

impl Run {
    /// Cuts a cell into so many elements, the first of which begins at a node.
    fn new(cell: &Cell, first: usize, count: usize, axial_force: f64, ground: Ground) -> Self {
        let h = cell.length() / count as f64;
        let layer = match ground {
            Ground::Nodal => Layer::new(cell.subgrade, cell.shear_layer),
            Ground::Spread => Layer::at_nodes(cell.subgrade, cell.shear_layer, h),
        };
        let element = (!is_even(cell)).then(|| {
            let operator = Operator::of(cell, axial_force, ZoneKind::Open);
            ExactElement::new(&operator, h).element
        });
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
            glued: Default::default(),
            layer,
            whole,
            beyond: Default::default(),
        };
        let form = run.first_glued(axial_force, false);
        let alike = run.is_alike() && run.given.moment_load[0] == 0.0 && element.is_none();
        run.glued = [form, if alike { form } else { run.first_glued(axial_force, true) }];
        run
    }

    /// The first element that a sweep crosses, bonded at both ends.
    fn first_glued(&self, axial_force: f64, mirrored: bool) -> Form {
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

    /// Whether the same is given along all its elements.
    fn is_alike(&self) -> bool {
        self.given.is_even() && self.gap[0] == self.gap[1]
    }

    pub fn length(&self) -> f64 {
        self.cell.length()
    }

    /// g₀ + u₀ at one of its nodes.
    pub fn gap_at(&self, node: usize) -> f64 {
        let [left, right] = self.gap;
        match node - self.first {
            0 => left,
            steps if steps == self.count => right,
            steps => left + (right - left) * (steps as f64 / self.count as f64),
        }
    }

    /// The node after the last element.
    pub fn end(&self) -> usize {
        self.first + self.count
    }

    /// What is given on the elements from one node to another, both of this run.
    pub fn part(&self, from: usize, to: usize) -> Given {
        if self.given.is_even() {
            return self.given;
        }
        self.given.part([from, to].map(|node| (node - self.first) as f64 / self.count as f64))
    }

    /// Open ground from one node to another, both of this run.
    pub fn open(&self, from: usize, to: usize) -> TwoPort {
        if to - from == self.count || self.cell.shear_layer == 0.0 {
            return self.whole;
        }
        self.layer.open(self.h * (to - from) as f64)
    }

    /// The position of a node, from the nearer end.
    pub fn x(&self, node: usize) -> f64 {
        let ([left, right], count) = (self.cell.x, self.count as f64);
        let (before, after) = ((node - self.first) as f64, (self.end() - node) as f64);
        if before <= after {
            left + self.length() * (before / count)
        } else {
            right - self.length() * (after / count)
        }
    }

    /// One of its elements as a cell.
    pub fn element_cell(&self, node: usize) -> Cell {
        if self.count == 1 {
            return self.cell;
        }
        let count = self.count as f64;
        let at = |node: usize| match node - self.first {
            0 => -1.0,
            steps if steps == self.count => 1.0,
            // From the nearer end.
            steps if 2 * steps <= self.count => 2.0 * steps as f64 / count - 1.0,
            steps => 1.0 - 2.0 * (self.count - steps) as f64 / count,
        };
        self.cell.part([at(node), at(node + 1)])
    }

    /// Into how many pieces an open part of it must be cut for one series to serve each.
    pub fn pieces(&self, axial_force: f64, length: f64) -> usize {
        pieces(&self.cell, axial_force, length)
    }
}

/// The elements of a cell with so many per length.
fn equal(cell: &Cell, per_length: f64) -> usize {
    (cell.length() * per_length).round() as usize
}

/// Whether equal elements can be cut from a cell.
fn is_even(cell: &Cell) -> bool {
    let varies = cell.beam_varies() || cell.ground_varies() || cell.beam_shear.is_some();
    !varies && !cell.has_free_field()
}

/// Into how many pieces a beam off the ground must be cut for one series to serve each.
fn pieces(cell: &Cell, axial_force: f64, length: f64) -> usize {
    let operator = Operator::of(cell, axial_force, ZoneKind::Open);
    if operator.polynomials.is_some() {
        return parts(&operator, length);
    }
    let wave = (axial_force / cell.stiffness).abs().sqrt();
    (wave * length / REACH).ceil().max(1.0) as usize
}

/// Separate springs, μ = 0: each end of an element holds its half.
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

/// Makes the beam's waves on the ground no shorter than an element.
fn stiffen(cell: &mut Cell, axial_force: f64, h: f64) {
    let tension = axial_force.max(0.0) + cell.shear_layer;
    let least = STIFF * h * h * (tension + cell.subgrade * h * h);
    if cell.stiffness < least {
        cell.stiffen(least / cell.stiffness);
    }
}

/// Where the ground presses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Ground {
    /// On the nodes alone, (5.5).
    Nodal,
    /// The same, with a shear layer that is straight between nodes and springs by the trapezoidal rule: where an element is
    /// longer than √(μ/k), a node still has the springs of half of it.
    Spread,
}

/// The runs from left to right, and what acts at the nodes between them.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    pub runs: Vec<Run>,
    /// At the first node of each run, and at the last node of all.
    pub nodes: Vec<Node>,
    pub axial_force: f64,
    /// √(kμ) beyond the left and the right end.
    pub outside: [f64; 2],
    /// Whether its contact may be off by a node: the next grid is hardly finer.
    pub rough: bool,
    /// Whether g₀ + u₀ is zero everywhere.
    pub flat: bool,
    /// Nodes on rigid supports, and where these have settled.
    pub pins: Vec<(usize, f64)>,
}

impl Grid {
    /// About `elements` equal elements, and a node at every place of the model.
    pub fn new(model: &Model, elements: usize, ground: Ground) -> Self {
        let per_length = elements as f64 / model.beam.length;
        Self::cut(model, ground, |cell| (equal(cell, per_length), 0.0))
    }

    /// The same; where its elements are too long for the beam's waves, the beam is made as stiff as they are long.
    pub fn stiffened(model: &Model, elements: usize, ground: Ground) -> Self {
        let per_length = elements as f64 / model.beam.length;
        Self::cut(model, ground, |cell| (equal(cell, per_length), 1.0 / per_length))
    }

    /// A mesh with the elements that `divide` wants of each cell, for a beam whose waves are no shorter than its lengths.
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

    /// The ground beyond each run, from both ends.
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

    /// The fewest elements of a model: those into which an open beam must be cut.
    pub fn fewest(model: &Model) -> usize {
        let axial_force = model.beam.axial_force;
        let mut fewest = 0_usize;
        Mesh::each_graded(model, |cell, settles| {
            let own = pieces(cell, axial_force, cell.length()).max(settles);
            fewest = fewest.saturating_add(own);
        });
        fewest
    }

    /// What lifting the whole ground by one takes.
    pub fn stiffness(&self) -> f64 {
        let springs = self.runs.iter().map(|run| run.cell.subgrade * run.length());
        springs.sum::<f64>() + self.outside[0] + self.outside[1]
    }

    /// The last node.
    pub fn last(&self) -> usize {
        self.runs.last().map_or(0, Run::end)
    }

    /// The first node of each run, and the last node of all.
    pub fn firsts(&self) -> impl Iterator<Item = usize> {
        self.runs.iter().map(|run| run.first).chain([self.last()])
    }

    /// The run of the element to the right of a node; of the last node the last run.
    pub fn run_at(&self, node: usize) -> usize {
        self.runs.partition_point(|run| run.end() <= node).min(self.runs.len() - 1)
    }

    pub fn x(&self, node: usize) -> f64 {
        self.runs[self.run_at(node)].x(node)
    }

    /// g₀ + u₀ at a node.
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

    /// Parts of runs from one node to another: the run and its nodes.
    pub fn parts(&self, from: usize, to: usize) -> impl Iterator<Item = (usize, usize, usize)> {
        let first = self.run_at(from);
        let ends = self.runs[first..].iter().take_while(move |run| run.first < to);
        let parts = ends
            .enumerate()
            .map(move |(i, run)| (first + i, run.first.max(from), run.end().min(to)));
        parts.filter(|(_, from, to)| from < to)
    }

    /// Open ground from one node to another.
    pub fn link(&self, from: usize, to: usize) -> Option<TwoPort> {
        let links = self.parts(from, to).map(|(run, from, to)| self.runs[run].open(from, to));
        links.reduce(TwoPort::then)
    }

    /// The ground from beyond the left end up to a node.
    pub fn left_of(&self, node: usize) -> TwoPort {
        let run = &self.runs[self.run_at(node)];
        let [before, _] = run.beyond;
        if node == run.first { before } else { before.then(run.open(run.first, node)) }
    }

    /// The ground from a node to beyond the right end.
    pub fn right_of(&self, node: usize) -> TwoPort {
        let run = &self.runs[self.run_at(node.max(1) - 1)];
        let [_, after] = run.beyond;
        if node == run.end() { after } else { run.open(node, run.end()).then(after) }
    }

    /// The place of the model at a node, if it has one.
    pub fn place(&self, node: usize) -> Option<&Node> {
        let run = self.run_at(node);
        if self.runs[run].first == node {
            self.nodes.get(run)
        } else {
            self.nodes.get(run + 1).filter(|_| node == self.last())
        }
    }
}
