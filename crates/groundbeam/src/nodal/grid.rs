//! Equal elements between any two places of the model: runs, not elements, are what is stored.

use super::beam::{Beam, REACH};
use super::form::Form;
use super::layer::Layer;
use crate::element::operator::wave_number;
use crate::ground::link::TwoPort;
use crate::mesh::cell::Cell;
use crate::mesh::mesh::{Mesh, Node};
use crate::model::Model;
use crate::nodal::beam::Given;

/// EI over h²(N + kh²) of a stiffened beam: no more than its own where its waves are longer than h.
const STIFF: f64 = 0.5;

/// Equal elements between two places of the model.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Run {
    /// The two places.
    pub x: [f64; 2],
    /// EI, k and μ.
    pub stiffness: f64,
    spring: f64,
    shear: f64,
    pub given: Given,
    /// Its first node, and how many elements follow.
    pub first: usize,
    pub count: usize,
    /// Their length.
    pub h: f64,
    /// The ground under one of them, glued at both ends.
    pub link: TwoPort,
    /// What a sweep crosses there: the first element in its direction, from the left and from the right.
    pub glued: [Form; 2],
    /// The ground, and all of it open from the first node to the last.
    pub layer: Layer,
    whole: TwoPort,
    /// Open ground and what is beyond the beam, left of its first node and right of its last.
    beyond: [TwoPort; 2],
}

impl Run {
    fn new(cell: &Cell) -> Self {
        let layer = Layer::new(cell.subgrade, cell.shear_layer);
        Run {
            x: cell.x,
            stiffness: cell.stiffness,
            spring: cell.subgrade,
            shear: cell.shear_layer,
            given: Given::of(cell),
            first: 0,
            count: 0,
            h: 0.0,
            link: TwoPort::default(),
            glued: Default::default(),
            layer,
            whole: layer.open(cell.length()),
            beyond: Default::default(),
        }
    }

    /// Cuts it into so many elements.
    fn cut(&mut self, first: usize, count: usize, axial_force: f64, ground: Ground) {
        (self.first, self.count) = (first, count);
        self.h = self.length() / count as f64;
        self.link = match ground {
            Ground::Nodal => self.layer.open(self.h),
            Ground::Spread => {
                let shunt = 0.5 * self.spring * self.h;
                TwoPort { series: self.shear / self.h, shunt_left: shunt, shunt_right: shunt }
            }
        };
        let form = self.first_glued(axial_force, false);
        let alike = self.given.is_even() && self.given.moment_load[0] == 0.0;
        self.glued = [form, if alike { form } else { self.first_glued(axial_force, true) }];
    }

    /// The first element that a sweep crosses, glued at both ends.
    fn first_glued(&self, axial_force: f64, mirrored: bool) -> Form {
        let last = self.count - 1;
        let form = |element: usize| {
            let from = self.first + if mirrored { last - element } else { element };
            let part = self.part(from, from + 1);
            let given = if mirrored { part.mirrored() } else { part };
            let beam = Beam::new(self.stiffness, &given, axial_force, self.h);
            Form::beam(self.h, beam.stiffness(), beam.load()).on(self.link, given.gap)
        };
        let first = form(0);
        if self.given.is_even() { first } else { first.towards(&form(last), self.count) }
    }

    /// Makes the beam's waves on the ground no shorter than an element.
    fn stiffen(&mut self, axial_force: f64, h: f64) {
        let tension = axial_force.max(0.0) + self.shear;
        let least = STIFF * h * h * (tension + self.spring * h * h);
        self.stiffness = self.stiffness.max(least);
    }

    pub fn length(&self) -> f64 {
        self.x[1] - self.x[0]
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
        if to - from == self.count {
            return self.whole;
        }
        self.layer.open(self.h * (to - from) as f64)
    }

    /// The position of a node, from the nearer end.
    pub fn x(&self, node: usize) -> f64 {
        let ([left, right], count) = (self.x, self.count as f64);
        let (before, after) = ((node - self.first) as f64, (self.end() - node) as f64);
        if before <= after {
            left + self.length() * (before / count)
        } else {
            right - self.length() * (after / count)
        }
    }

    /// The largest wave number of the beam on its ground.
    fn wave_number(&self, axial_force: f64) -> f64 {
        wave_number(self.stiffness, (axial_force + self.shear).abs(), self.spring)
    }

    /// Into how many pieces an open beam of this kind must be cut for one series to serve each.
    pub fn pieces(&self, axial_force: f64, length: f64) -> usize {
        let wave = (axial_force / self.stiffness).abs().sqrt();
        (wave * length / REACH).ceil().max(1.0) as usize
    }
}

/// Where the ground presses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Ground {
    /// On the nodes alone, (5.5).
    Nodal,
    /// All along an element that is glued, to the accuracy of the trapezoidal rule.
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
    ground: Ground,
    /// Whether its contact may be off by a node: the next grid is hardly finer.
    pub rough: bool,
    /// Whether g₀ is zero everywhere.
    pub flat: bool,
}

impl Grid {
    /// About `elements` equal elements, and a node at every place of the model.
    pub fn new(model: &Model, elements: usize, ground: Ground) -> Self {
        let mut grid = Self::of(model, ground);
        grid.cut(elements as f64 / model.beam.length);
        grid
    }

    /// Without elements.
    pub fn of(model: &Model, ground: Ground) -> Self {
        let mesh = Mesh::build(model, &[], |_| 1);
        let mut grid = Grid {
            runs: mesh.cells.iter().map(Run::new).collect(),
            nodes: mesh.nodes,
            axial_force: mesh.axial_force,
            outside: mesh.outside,
            ground,
            rough: false,
            flat: model.gap.is_empty(),
        };
        grid.chain();
        grid
    }

    /// The same with fewer elements; where they are too long for the beam, it is made as stiff as they are long.
    pub fn coarser(&self, elements: usize) -> Self {
        let mut grid = self.clone();
        let per_length = elements as f64 / self.length();
        for run in &mut grid.runs {
            run.stiffen(self.axial_force, 1.0 / per_length);
        }
        grid.cut(per_length);
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

    fn cut(&mut self, per_length: f64) {
        let mut first = 0;
        for run in &mut self.runs {
            let length = run.length();
            let wanted = (length * per_length).round() as usize;
            let count = wanted.max(run.pieces(self.axial_force, length));
            run.cut(first, count, self.axial_force, self.ground);
            first += count;
        }
    }

    pub fn length(&self) -> f64 {
        self.runs.last().map_or(0.0, |run| run.x[1])
    }

    /// The largest wave number of the beam on its ground.
    pub fn wave_number(&self) -> f64 {
        self.runs.iter().map(|run| run.wave_number(self.axial_force)).fold(0.0, f64::max)
    }

    /// The fewest elements it may have: those into which an open beam must be cut.
    pub fn fewest(&self) -> usize {
        let pieces = self.runs.iter().map(|run| run.pieces(self.axial_force, run.length()));
        pieces.fold(0, usize::saturating_add)
    }

    /// What lifting the whole ground by one takes.
    pub fn stiffness(&self) -> f64 {
        let springs = self.runs.iter().map(|run| run.spring * run.length());
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
        run.given.gap[0] + (run.given.gap[1] - run.given.gap[0]) * t
    }

    /// The node nearest to a position.
    pub fn nearest(&self, x: f64) -> usize {
        let run = self.runs.partition_point(|run| run.x[1] < x).min(self.runs.len() - 1);
        let run = &self.runs[run];
        let steps = ((x - run.x[0]) / run.h).round().max(0.0) as usize;
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

    /// Open ground from one node, or from beyond the left end, up to another.
    pub fn left_then(&self, from: usize, held: bool, to: usize) -> TwoPort {
        if !held {
            return self.left_of(to);
        }
        let nothing = TwoPort { series: f64::MAX, shunt_left: 0.0, shunt_right: 0.0 };
        self.link(from, to).unwrap_or(nothing)
    }

    /// The ground from a node to beyond the right end.
    pub fn right_of(&self, node: usize) -> TwoPort {
        let run = &self.runs[self.run_at(node.max(1) - 1)];
        let [_, after] = run.beyond;
        if node == run.end() { after } else { run.open(node, run.end()).then(after) }
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
