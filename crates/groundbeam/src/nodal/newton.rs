//! Finds the nodes in contact by Newton's method, first on coarse grids and then on the required grid.

use super::back_sweep::Fields;
use super::grid::Grid;
use super::hull::{Hull, Zone};
use super::layout::Layout;
use super::open;
use super::quadratic::NotSolved;
use super::stand::StabilisingSprings;
use super::sweep;
use crate::cancel::Cancel;
use crate::numeric::step::Step;

/// Maximum number of full Newton steps on one grid. Later steps use a line search on the energy.
const WHOLE_STEPS: usize = 8;
/// Initial stiffness of the stabilising springs, relative to the stiffness of the ground.
const SOFTEST_SPRING: f64 = 1e-6;
/// Factor by which the stiffness of the stabilising springs increases from one trial solve to the next, until the
/// system is positive definite.
const STIFFER: f64 = 1e3;
/// Maximum number of trial solves in one step, each with stiffer stabilising springs.
const SPRING_TRIALS: usize = 3;
/// Maximum force in a stabilising spring at convergence, relative to the sum of the ground forces.
const SPRING_FORCE: f64 = 1e-14;

/// Counts of operations that measure the work of a solve. They do not depend on the speed of the computer.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    /// Number of solves of the linear problem with given contact zones, on all grids.
    pub solves: usize,
    /// Number of solves of the linear problem with given contact zones, on the required (finest) grid.
    pub fine_solves: usize,
    /// Total number of elements that all solves have eliminated. A stretch out of contact counts as one element.
    pub elements: usize,
    /// Number of grids.
    pub grids: usize,
}

/// Stopping rule of the iteration on one grid.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Goal {
    /// Maximum number of steps.
    pub steps: usize,
    /// Maximum number of elements of a grid on which line searches are used. Each line search scans all nodes
    /// dozens of times.
    pub searched: usize,
    /// Convergence tolerance: number of nodes per contact zone whose contact may still change in the next step.
    /// It is 0 for a final result.
    pub moves: usize,
}

/// Stopping rule for a final result: the contact set no longer changes. Some models need many steps shortened by the
/// line search. The model "Hard 333" needs 650 steps on 333 elements.
pub(crate) const ANSWER: Goal = Goal { steps: 2000, searched: usize::MAX, moves: 0 };
/// Stopping rule for a solve that only computes an initial guess for another method.
pub(crate) const START: Goal = Goal { steps: 40, searched: 20_000, moves: 1 };

/// Maximum element length, relative to √(μ/k), for which the pressure next to a contact edge is assumed to be
/// linear.
const FINE: f64 = 0.2;

/// Memory of a solve. The next solve reuses it.
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
    /// Newton steps on all grids.
    pub history: Vec<Step>,
    /// Cancels the iteration.
    pub cancel: Cancel,
}

impl Workspace {
    /// Finds the contact zones on the last grid. The solutions on the coarser grids give the initial guess.
    pub fn contact(&mut self, grids: &[Grid], goal: Goal) -> Result<(), NotSolved> {
        self.approach(grids, goal)?;
        self.level(&grids[grids.len() - 1], goal)
    }

    /// Finds an initial guess of the contact zones on the last grid from the solutions on the coarser grids.
    pub fn approach(&mut self, grids: &[Grid], goal: Goal) -> Result<(), NotSolved> {
        self.work = Work::default();
        self.history.clear();
        self.bond(&grids[0]);
        for level in 1..grids.len() {
            self.level(&grids[level - 1], goal)?;
            self.refine(&grids[level - 1], &grids[level]);
        }
        Ok(())
    }

    /// Finds the contact zones on one grid, from the initial guess in `zones`.
    pub fn level(&mut self, grid: &Grid, mut goal: Goal) -> Result<(), NotSolved> {
        self.resize(grid);
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

    /// Sets contact at all nodes.
    pub fn bond(&mut self, grid: &Grid) {
        self.zones.clear();
        self.zones.push([0, grid.last()]);
    }

    /// Resizes the deflection, the slope and the ground force to one value per node.
    pub fn resize(&mut self, grid: &Grid) {
        for field in [&mut self.deflection, &mut self.slope, &mut self.force] {
            field.resize(grid.last() + 1, 0.0);
        }
    }

    /// Solves the bonded problem with contact in `zones`, and writes the fields at the nodes in contact.
    /// `stabilisation` is the stiffness of the stabilising springs. After an error, the fields are unchanged.
    pub fn solve_bonded(
        &mut self,
        grid: &Grid,
        stabilisation: Option<f64>,
    ) -> Result<(), NotSolved> {
        let Workspace { layout, zones, deflection, slope, force, before, .. } = self;
        let rest = &before.deflection;
        let springs = stabilisation.map(|stiffness| StabilisingSprings { stiffness, rest });
        layout.set(grid, zones, springs.as_ref())?;
        self.work.solves += 1;
        let middle = sweep::inward(&mut layout.sides, layout.stand)?;
        if !middle.iter().all(|part| part.is_finite()) {
            return Err(NotSolved);
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

    /// Solves the bonded problem with stabilising springs at rest at the previous deflection. Returns their stiffness.
    fn solve_stabilised(&mut self, grid: &Grid) -> Result<f64, NotSolved> {
        let mut spring = SOFTEST_SPRING * grid.stiffness();
        for _ in 0..SPRING_TRIALS {
            if self.solve_bonded(grid, Some(spring)).is_ok() {
                return Ok(spring);
            }
            spring *= STIFFER;
        }
        Err(NotSolved)
    }

    /// Writes the deflection w between the contact zones, or the slope w' if `derivative` is true.
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

    /// Sets the ground forces at the nodes between the contact zones to zero.
    pub fn clear_open(&mut self, grid: &Grid) {
        clear(&mut self.force[..=grid.last()], &self.zones);
    }

    /// Number of nodes whose contact changes in this step.
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

    /// Stores the deflection and the ground forces before a step. If `first` is true, the old forces at nodes out of
    /// contact are set to zero.
    fn remember(&mut self, grid: &Grid, first: bool) {
        if first {
            clear(&mut self.force[..=grid.last()], &self.next);
        }
        std::mem::swap(&mut self.before.deflection, &mut self.deflection);
        std::mem::swap(&mut self.before.force, &mut self.force);
        self.resize(grid);
        self.force.fill(0.0);
    }

    fn springs_are_unloaded(&self, grid: &Grid, spring: f64) -> bool {
        let all: f64 = self.force.iter().map(|force| force.abs()).sum();
        let springs = StabilisingSprings { stiffness: spring, rest: &self.before.deflection };
        springs.forces(grid, &self.deflection).all(|(_, force)| force.abs() <= SPRING_FORCE * all)
    }

    /// Iterates until the contact zones change by at most the tolerance of `goal`. The first `whole` steps are full
    /// steps.
    fn settle(&mut self, grid: &Grid, goal: Goal, whole: usize) -> Result<(), NotSolved> {
        let mut whole = whole;
        for step in 0..goal.steps {
            if self.cancel.is_cancelled() {
                return Err(NotSolved);
            }
            if step >= whole {
                if grid.last() > goal.searched {
                    return Err(NotSolved);
                }
                self.remember(grid, step == whole);
            }
            let mut spring = None;
            if self.solve_bonded(grid, None).is_err() {
                if step < whole {
                    self.remember(grid, true);
                }
                if step == 0 {
                    self.before.deflection.clear();
                    self.before.deflection.resize(grid.last() + 1, 0.0);
                }
                spring = Some(self.solve_stabilised(grid)?);
                whole = whole.min(step.max(1));
            }
            self.fill(grid, false);
            let hull = Hull { grid, deflection: &self.deflection, near: &self.zones };
            hull.zones(&mut self.arcs, &mut self.next);
            let decrement = self.moved() as f64 / (grid.last() + 1) as f64;
            self.history.push(Step { zones: self.next.len(), step: 1.0, decrement });
            let settled = self.next == self.zones || self.moved() <= goal.moves * self.zones.len();
            if settled && spring.is_none_or(|spring| self.springs_are_unloaded(grid, spring)) {
                return Ok(());
            }
            if step >= whole {
                let Some(part) = self.shorten(grid) else { return Ok(()) };
                if let Some(step) = self.history.last_mut() {
                    step.step = part;
                }
            }
            std::mem::swap(&mut self.zones, &mut self.next);
        }
        Err(NotSolved)
    }

    /// Transfers the contact zones from the grid `coarse` to the finer grid `grid`.
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

    /// Positions of the contact edges of all zones \[m\], interpolated between nodes.
    pub fn edges(&self, grid: &Grid) -> Vec<[f64; 2]> {
        let ends = |&[from, to]: &Zone| [self.edge(grid, from, to), self.edge(grid, to, from)];
        self.zones.iter().map(ends).collect()
    }

    /// Position \[m\] of the contact edge near `node`, an end of the contact zone from `node` to `towards`. The
    /// pressure is assumed to be linear up to the edge. See *Meshes* in section 10 of docs/methods.md.
    fn edge(&self, grid: &Grid, node: usize, towards: usize) -> f64 {
        let x = grid.x(node);
        // At a hinge the slope is discontinuous, so the ground force includes a concentrated force.
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

/// Sets the ground forces at the nodes outside the contact zones to zero.
fn clear(force: &mut [f64], zones: &[Zone]) {
    let mut open = 0;
    for &[from, to] in zones {
        force[open..from].fill(0.0);
        open = to + 1;
    }
    force[open..].fill(0.0);
}

/// Deflection and ground forces before a step, and memory for the trials of the line search.
#[derive(Debug, Clone, Default)]
pub(crate) struct Line {
    pub deflection: Vec<f64>,
    pub force: Vec<f64>,
    pub(crate) trial: Vec<f64>,
    pub(crate) arcs: Vec<Zone>,
    pub(crate) zones: Vec<Zone>,
}
