//! Equal elements between any two places of the model: runs, not elements, are what is stored.

use super::beam::{Beam, REACH};
use super::form::Form;
use super::layer::Layer;
use crate::elements::{Operator, Touch};
use crate::ground::Link;
use crate::mesh::{Cell, Mesh, Node};
use crate::model::Model;

/// Equal elements between two places of the model.
#[derive(Debug, Clone, Copy)]
pub(super) struct Run {
    /// What is given between the two places.
    pub cell: Cell,
    /// Its first node, and how many elements follow.
    pub first: usize,
    pub count: usize,
    /// Their length.
    pub h: f64,
    /// The ground under one of them, glued at both ends.
    pub link: Link,
    /// What a sweep crosses there: the first element in its direction, from the left and from the right.
    pub glued: [Form; 2],
    /// The ground, and all of it open from the first node to the last.
    pub layer: Layer,
    pub whole: Link,
}

impl Run {
    fn new(cell: Cell, axial_force: f64, first: usize, count: usize, ground: Ground) -> Self {
        let h = cell.length() / count as f64;
        let layer = Layer::of(&cell);
        let link = match ground {
            Ground::Nodal => layer.open(h),
            Ground::Spread => spread(&cell, h),
        };
        let whole = layer.open(cell.length());
        let mut run = Run { cell, first, count, h, link, glued: Default::default(), layer, whole };
        run.glued = [run.first_glued(axial_force, false), run.first_glued(axial_force, true)];
        run
    }

    /// The first element that a sweep crosses, glued at both ends.
    fn first_glued(&self, axial_force: f64, from_right: bool) -> Form {
        let last = self.count - 1;
        let form = |element: usize| {
            let from = self.first + if from_right { last - element } else { element };
            let part = self.part(from, from + 1);
            let cell = if from_right { mirrored(&part) } else { part };
            let beam = Beam::new(&cell, axial_force, self.h);
            Form::beam(self.h, beam.stiffness(), beam.load()).on(self.link, cell.gap)
        };
        let first = form(0);
        if self.is_even() { first } else { first.towards(&form(last), self.count) }
    }

    /// The node after the last element.
    pub fn end(&self) -> usize {
        self.first + self.count
    }

    /// Whether nothing varies along it.
    pub fn is_even(&self) -> bool {
        let Cell { load, moment_load, gap, .. } = &self.cell;
        [load, moment_load, gap].iter().all(|v| v[0] == v[1])
    }

    /// What is given on the elements from one node to another, both of this run.
    pub fn part(&self, from: usize, to: usize) -> Cell {
        let at = |node: usize| (node - self.first) as f64 / self.count as f64;
        let (a, b) = (at(from), at(to));
        let linear = |v: [f64; 2]| [a, b].map(|t| v[0] + (v[1] - v[0]) * t);
        let cell = &self.cell;
        Cell {
            x: [self.x(from), self.x(to)],
            load: linear(cell.load),
            moment_load: linear(cell.moment_load),
            gap: linear(cell.gap),
            ..*cell
        }
    }

    /// Open ground from one node to another, both of this run.
    pub fn open(&self, from: usize, to: usize) -> Link {
        if to - from == self.count {
            return self.whole;
        }
        self.layer.open(self.h * (to - from) as f64)
    }

    /// The position of a node.
    pub fn x(&self, node: usize) -> f64 {
        self.cell.global(2.0 * (node - self.first) as f64 / self.count as f64 - 1.0)
    }
}

/// Where the ground presses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ground {
    /// On the nodes alone, (5.5).
    Nodal,
    /// All along an element that is glued, to the accuracy of the trapezoidal rule.
    Spread,
}

fn spread(cell: &Cell, h: f64) -> Link {
    let leak = 0.5 * cell.spring * h;
    Link { coupling: cell.shear / h, leak_left: leak, leak_right: leak }
}

/// The runs from left to right, and what acts at the nodes between them.
#[derive(Debug, Clone)]
pub(super) struct Grid {
    pub runs: Vec<Run>,
    /// At the first node of each run, and at the last node of all.
    pub nodes: Vec<Node>,
    pub axial_force: f64,
    /// √(kμ) beyond the left and the right end.
    pub outside: [f64; 2],
    /// Whether g₀ is zero everywhere.
    pub flat: bool,
}

impl Grid {
    /// About `elements` equal elements, and a node at every place of the model.
    pub fn new(model: &Model, elements: usize, ground: Ground) -> Self {
        let mesh = Mesh::build(model, &[], |_| 1);
        let per_length = elements as f64 / model.beam.length;
        let axial_force = mesh.axial_force;
        let mut first = 0;
        let runs = mesh.cells.iter().map(|cell| {
            let wanted = (cell.length() * per_length).round() as usize;
            let count = wanted.max(pieces(cell, axial_force, cell.length()));
            let run = Run::new(*cell, axial_force, first, count, ground);
            first += count;
            run
        });
        Grid {
            runs: runs.collect(),
            nodes: mesh.nodes,
            axial_force,
            outside: mesh.outside,
            flat: model.gap.is_empty(),
        }
    }

    /// The largest wave number of the beam on its ground.
    pub fn wave_number(&self) -> f64 {
        let wave =
            |run: &Run| Operator::of(&run.cell, self.axial_force, Touch::Contact).wave_number();
        self.runs.iter().map(wave).fold(0.0, f64::max)
    }

    /// What lifting the whole ground by one takes.
    pub fn stiffness(&self) -> f64 {
        let springs = self.runs.iter().map(|run| run.cell.spring * run.cell.length());
        springs.sum::<f64>() + self.outside[0] + self.outside[1]
    }

    /// The last node.
    pub fn last(&self) -> usize {
        self.runs.last().map_or(0, Run::end)
    }

    /// The run of the element to the right of a node; of the last node the last run.
    pub fn run_at(&self, node: usize) -> usize {
        self.runs.partition_point(|run| run.end() <= node).min(self.runs.len() - 1)
    }

    pub fn x(&self, node: usize) -> f64 {
        self.runs[self.run_at(node)].x(node)
    }

    /// g₀ at a node.
    pub fn gap(&self, node: usize) -> f64 {
        if self.flat {
            return 0.0;
        }
        let run = &self.runs[self.run_at(node)];
        let t = (node - run.first) as f64 / run.count as f64;
        run.cell.gap[0] + (run.cell.gap[1] - run.cell.gap[0]) * t
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
    pub fn link(&self, from: usize, to: usize) -> Option<Link> {
        let links = self.parts(from, to).map(|(run, from, to)| self.runs[run].open(from, to));
        links.reduce(Link::then)
    }

    /// The ground from beyond the left end up to a node.
    pub fn left_of(&self, node: usize) -> Link {
        let beyond = Link { coupling: 0.0, leak_left: 0.0, leak_right: self.outside[0] };
        self.link(0, node).map_or(beyond, |link| beyond.then(link))
    }

    /// Open ground from one node, or from beyond the left end, up to another.
    pub fn left_then(&self, from: usize, held: bool, to: usize) -> Link {
        if !held {
            return self.left_of(to);
        }
        let nothing = Link { coupling: f64::MAX, leak_left: 0.0, leak_right: 0.0 };
        self.link(from, to).unwrap_or(nothing)
    }

    /// The ground from a node to beyond the right end.
    pub fn right_of(&self, node: usize) -> Link {
        let beyond = Link { coupling: 0.0, leak_left: self.outside[1], leak_right: 0.0 };
        self.link(node, self.last()).map_or(beyond, |link| link.then(beyond))
    }

    /// Into how many pieces an open beam of a cell's kind must be cut for one series to serve each.
    pub fn pieces(&self, cell: &Cell, length: f64) -> usize {
        pieces(cell, self.axial_force, length)
    }

    /// What the model has at a node: force and moment, in a mirror or not.
    pub fn load(&self, node: usize, mirrored: bool) -> [f64; 2] {
        match self.place(node) {
            None => [0.0; 2],
            Some(Node { force, moment, .. }) => [*force, if mirrored { -moment } else { *moment }],
        }
    }

    /// The place of the model at a node, if it has one.
    fn place(&self, node: usize) -> Option<&Node> {
        let run = self.run_at(node);
        if self.runs[run].first == node {
            self.nodes.get(run)
        } else {
            self.nodes.get(run + 1).filter(|_| node == self.last())
        }
    }
}

fn pieces(cell: &Cell, axial_force: f64, length: f64) -> usize {
    let wave = (axial_force / cell.stiffness).abs().sqrt();
    (wave * length / REACH).ceil().max(1.0) as usize
}

/// A cell seen in a mirror.
pub(super) fn mirrored(cell: &Cell) -> Cell {
    let turned = |[a, b]: [f64; 2]| [b, a];
    Cell {
        load: turned(cell.load),
        moment_load: turned(cell.moment_load).map(|g| -g),
        gap: turned(cell.gap),
        gap_slope: -cell.gap_slope,
        ..*cell
    }
}
