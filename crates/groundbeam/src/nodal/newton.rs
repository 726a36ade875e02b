//! Newton's method on the nodes that touch, from coarse grids to the wanted one.

use super::back_sweep::Fields;
use super::grid::Grid;
use super::hull::{Hull, Zone};
use super::layout::Layout;
use super::open;
use super::quadratic::Loose;
use super::stand::Tether;
use super::sweep;
use crate::cancel::Cancel;
use crate::numeric::step::Step;

/// Steps on one grid that are taken whole; later ones are shortened where the energy asks for it.
const WHOLE_STEPS: usize = 8;
/// The tether's part of the ground's stiffness, by how much it grows until it holds, and how often.
const TETHER: f64 = 1e-6;
const STIFFER: f64 = 1e3;
const TETHERS: usize = 3;
/// The part of the ground's forces that a tether may take of an answer.
const SLACK: f64 = 1e-14;

/// What was done, in units that no clock disturbs.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    /// Glued solves, on all grids.
    pub solves: usize,
    /// Glued solves on the wanted grid.
    pub fine_solves: usize,
    /// Elements that were swept over, in all of them; a stretch off the ground is one.
    pub elements: usize,
    /// Grids.
    pub grids: usize,
}

/// What ends the steps on one grid.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Goal {
    /// Steps before it is given up.
    pub steps: usize,
    /// The finest grid on which steps are shortened, which takes dozens of scans each.
    pub searched: usize,
    /// How many nodes a zone may still want to gain or lose: none of an answer.
    pub moves: usize,
}

/// An answer: nothing moves.
pub(crate) const ANSWER: Goal = Goal { steps: 200, searched: usize::MAX, moves: 0 };
/// A start for another method.
pub(crate) const START: Goal = Goal { steps: 40, searched: 20_000, moves: 1 };

/// The part of 1/√(k/μ) that an element must not exceed for its pressure to be a straight line.
const FINE: f64 = 0.2;

/// Everything that a solve needs and the next one can use again.
#[derive(Debug, Clone, Default)]
pub(crate) struct Workspace {
    pub(crate) layout: Layout,
    pub(crate) arcs: Vec<Zone>,
    pub(crate) next: Vec<Zone>,
    pub zones: Vec<Zone>,
    pub deflection: Vec<f64>,
    pub slope: Vec<f64>,
    pub force: Vec<f64>,
    pub(crate) before: Line,
    pub work: Work,
    /// The steps, on all grids.
    pub history: Vec<Step>,
    /// Stops the steps.
    pub cancel: Cancel,
}

impl Workspace {
    /// The nodes that touch on the last grid, from coarser ones.
    pub fn contact(&mut self, grids: &[Grid], goal: Goal) -> Result<(), Loose> {
        self.approach(grids, goal)?;
        self.level(&grids[grids.len() - 1], goal)
    }

    /// A guess at the nodes that touch on the last grid, from coarser ones.
    pub fn approach(&mut self, grids: &[Grid], goal: Goal) -> Result<(), Loose> {
        self.work = Work::default();
        self.history.clear();
        self.bond(&grids[0]);
        for level in 1..grids.len() {
            self.level(&grids[level - 1], goal)?;
            self.refine(&grids[level - 1], &grids[level]);
        }
        Ok(())
    }

    /// The nodes that touch on one grid, from a guess.
    pub fn level(&mut self, grid: &Grid, mut goal: Goal) -> Result<(), Loose> {
        self.room(grid);
        if grid.rough {
            goal.moves = goal.moves.max(1);
        }
        let before = self.work.solves;
        self.work.grids += 1;
        if self.settle(grid, goal, WHOLE_STEPS).is_err() {
            self.bond(grid);
            self.settle(grid, goal, 1)?;
        }
        self.work.fine_solves = self.work.solves - before;
        Ok(())
    }

    /// Contact everywhere.
    pub fn bond(&mut self, grid: &Grid) {
        self.zones.clear();
        self.zones.push([0, grid.last()]);
    }

    pub fn room(&mut self, grid: &Grid) {
        for field in [&mut self.deflection, &mut self.slope, &mut self.force] {
            field.resize(grid.last() + 1, 0.0);
        }
    }

    /// The beam glued to the ground on `zones` and held by a tether to the deflection before, if any: w on all nodes, w'
    /// and forces where they touch. Nothing is written if it is loose.
    pub fn glue(&mut self, grid: &Grid, tether: Option<f64>) -> Result<(), Loose> {
        let Workspace { layout, zones, deflection, slope, force, before, .. } = self;
        let tether = tether.map(|spring| Tether { spring, at: &before.deflection });
        layout.set(grid, zones, tether.as_ref())?;
        self.work.solves += 1;
        let middle = sweep::inward(&mut layout.sides, layout.stand)?;
        if !middle.iter().all(|part| part.is_finite()) {
            return Err(Loose);
        }
        for &[from, to] in zones.iter() {
            force[from..=to].fill(0.0);
        }
        let mut fields = Fields { deflection, slope, force };
        layout.middle = middle;
        let Layout { sides, meeting, stand, .. } = layout;
        self.work.elements += sweep::outward(sides, *meeting, *stand, middle, &mut fields);
        Ok(())
    }

    /// The same where the ground does not hold the beam: springs that stretch by no more than it moves keep the step
    /// one on which the energy falls. Returns their stiffness.
    fn glue_loose(&mut self, grid: &Grid) -> Result<f64, Loose> {
        let mut spring = TETHER * grid.stiffness();
        for _ in 0..TETHERS {
            if self.glue(grid, Some(spring)).is_ok() {
                return Ok(spring);
            }
            spring *= STIFFER;
        }
        Err(Loose)
    }

    /// w between the zones, or w'.
    pub fn fill(&mut self, grid: &Grid, derivative: bool) {
        let Workspace { layout, deflection, slope, .. } = self;
        let into = if derivative { slope } else { deflection };
        for placed in layout.spans() {
            let shape = &layout.sides[placed.side].shapes[placed.stretch];
            open::beam(grid, &placed.span, shape, derivative, into);
        }
        if !derivative {
            for &(node, settlement) in &grid.pins {
                into[node] = settlement;
            }
        }
    }

    /// No forces between the zones.
    pub fn clear_open(&mut self, grid: &Grid) {
        clear(&mut self.force[..=grid.last()], &self.zones);
    }

    /// How many nodes touch now or in the next step, not both.
    fn moved(&self) -> usize {
        let count = |zones: &[Zone]| zones.iter().map(|[from, to]| to - from + 1).sum::<usize>();
        let (mut both, mut next) = (0, self.next.iter().peekable());
        for &[from, to] in &self.zones {
            while let Some(&&[start, end]) = next.peek() {
                if start <= to && from <= end {
                    both += end.min(to) - start.max(from) + 1;
                }
                if end > to {
                    break;
                }
                next.next();
            }
        }
        count(&self.zones) + count(&self.next) - 2 * both
    }

    /// Before a step that may be shortened; on the first one, what is left at open nodes of the solves before
    /// the last is no force.
    fn remember(&mut self, grid: &Grid, first: bool) {
        if first {
            clear(&mut self.force[..=grid.last()], &self.next);
        }
        std::mem::swap(&mut self.before.deflection, &mut self.deflection);
        std::mem::swap(&mut self.before.force, &mut self.force);
        self.room(grid);
        self.force.fill(0.0);
    }

    fn is_slack(&self, grid: &Grid, spring: f64) -> bool {
        let all: f64 = self.force.iter().map(|force| force.abs()).sum();
        let tether = Tether { spring, at: &self.before.deflection };
        tether.forces(grid, &self.deflection).all(|(_, force)| force.abs() <= SLACK * all)
    }

    /// Steps until the contact asked for is the contact assumed, the first few taken whole.
    fn settle(&mut self, grid: &Grid, goal: Goal, whole: usize) -> Result<(), Loose> {
        let mut whole = whole;
        for step in 0..goal.steps {
            if self.cancel.is_cancelled() {
                return Err(Loose);
            }
            if step >= whole {
                if grid.last() > goal.searched {
                    return Err(Loose);
                }
                self.remember(grid, step == whole);
            }
            let mut tether = None;
            if self.glue(grid, None).is_err() {
                if step < whole {
                    self.remember(grid, true);
                }
                if step == 0 {
                    self.before.deflection.clear();
                    self.before.deflection.resize(grid.last() + 1, 0.0);
                }
                tether = Some(self.glue_loose(grid)?);
                whole = whole.min(step.max(1));
            }
            self.fill(grid, false);
            let hull = Hull { grid, deflection: &self.deflection, near: &self.zones };
            hull.zones(&mut self.arcs, &mut self.next);
            let decrement = self.moved() as f64 / (grid.last() + 1) as f64;
            self.history.push(Step { zones: self.next.len(), step: 1.0, decrement });
            let settled = self.next == self.zones || self.moved() <= goal.moves * self.zones.len();
            if settled && tether.is_none_or(|spring| self.is_slack(grid, spring)) {
                return Ok(());
            }
            if step > 0 && step >= whole {
                let Some(part) = self.shorten(grid) else { return Ok(()) };
                if let Some(step) = self.history.last_mut() {
                    step.step = part;
                }
            }
            std::mem::swap(&mut self.zones, &mut self.next);
        }
        Err(Loose)
    }

    /// The zones of a coarser grid on this one.
    fn refine(&mut self, coarse: &Grid, grid: &Grid) {
        self.next.clear();
        for [from, to] in self.edges(coarse) {
            let start = grid.nearest(from);
            let end = grid.nearest(to).max(start);
            match self.next.last_mut() {
                Some(last) if start <= last[1] + 1 => last[1] = end.max(last[1]),
                _ => self.next.push([start, end]),
            }
        }
        std::mem::swap(&mut self.zones, &mut self.next);
    }

    /// Where the contact ends.
    pub fn edges(&self, grid: &Grid) -> Vec<[f64; 2]> {
        let ends = |&[from, to]: &Zone| [self.edge(grid, from, to), self.edge(grid, to, from)];
        self.zones.iter().map(ends).collect()
    }

    /// Where contact ends beside the last node of a zone that goes on towards another. There p = p₀ + p₁ξ,
    /// and open ground brings p e^(−bξ) of what lies ξ beyond the node to it: up to an edge at ξ = s,
    /// F = p₀(h/2 + s) − p₁h²/6 + (p₁ − b p₀)s²/2.
    fn edge(&self, grid: &Grid, node: usize, towards: usize) -> f64 {
        let x = grid.x(node);
        // A corner at a hinge takes a point force.
        let is_corner = grid.place(node).is_some_and(|place| place.hinge.is_some());
        if node == towards || node == 0 || node == grid.last() || is_corner {
            return x;
        }
        let inwards = |steps: usize| {
            if towards > node { node + steps } else { node - steps }
        };
        let run = &grid.runs[grid.run_at(node.min(inwards(1)))];
        let per_length = |steps: usize| self.force[inwards(steps)] / run.h;
        let (mut level, mut rise, mut decay) = (per_length(1), 0.0, 0.0);
        let inside = |node: usize| run.first < node && node < run.end();
        let straight = run.layer.rate * run.h < FINE;
        if straight && towards.abs_diff(node) > 2 && inside(inwards(1)) && inside(inwards(2)) {
            rise = (level - per_length(2)) / run.h;
            level += rise * run.h;
            decay = run.layer.rate * level;
        }
        let half = 0.5 * run.h;
        let beyond = |s: f64| {
            let curved = rise * run.h * run.h / 6.0 - 0.5 * (rise - decay) * s * s;
            ((self.force[node] + curved) / level - half).clamp(-3.0 * half, 3.0 * half)
        };
        let s = beyond(beyond(0.0));
        let outwards = if towards > node { -s } else { s };
        if s.is_nan() { x } else { x + outwards }
    }
}

/// No forces but on zones.
fn clear(force: &mut [f64], zones: &[Zone]) {
    let mut open = 0;
    for &[from, to] in zones {
        force[open..from].fill(0.0);
        open = to + 1;
    }
    force[open..].fill(0.0);
}

/// The deflections and forces before a step, and room for those on the way.
#[derive(Debug, Clone, Default)]
pub(crate) struct Line {
    pub deflection: Vec<f64>,
    pub force: Vec<f64>,
    pub(crate) trial: Vec<f64>,
    pub(crate) arcs: Vec<Zone>,
    pub(crate) zones: Vec<Zone>,
}
