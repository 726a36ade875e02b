//! Newton's method on the nodes that touch, from coarse grids to the wanted one.

use super::beam::Beam;
use super::form::Form;
use super::grid::{Grid, Ground, mirrored};
use super::hull::{Hull, Zone};
use super::open;
use super::span::Span;
use super::sweep::{self, Fields, Loose, Side, Stand, Stretch};
use crate::contact::line;
use crate::ground::Link;
use crate::model::Model;

/// Steps on one grid that are taken whole; later ones are shortened where the energy asks for it.
const WHOLE_STEPS: usize = 8;
/// The fall of the energy, relative to the work of the forces, that rounding leaves.
const LEAST: f64 = 1e-28;

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
pub(super) struct Goal {
    /// Steps before it is given up.
    pub steps: usize,
    /// The finest grid on which steps are shortened, which takes dozens of scans each.
    pub searched: usize,
    /// How many nodes a zone may still want to gain or lose: none of an answer.
    pub moves: usize,
}

/// An answer: nothing moves.
pub(super) const ANSWER: Goal = Goal { steps: 200, searched: usize::MAX, moves: 0 };
/// A start for another method.
pub(super) const START: Goal = Goal { steps: 40, searched: 20_000, moves: 1 };

/// Everything that a solve needs and the next one can use again.
#[derive(Debug, Clone, Default)]
pub(super) struct Workspace {
    sides: [Side; 2],
    spans: Vec<(Span, usize, usize)>,
    arcs: Vec<Zone>,
    next: Vec<Zone>,
    pub zones: Vec<Zone>,
    pub deflection: Vec<f64>,
    pub slope: Vec<f64>,
    pub force: Vec<f64>,
    before: [Vec<f64>; 2],
    pub work: Work,
}

impl Workspace {
    /// The nodes that touch on the wanted grid, from coarser ones.
    pub fn contact(&mut self, grids: &[Grid], goal: Goal) -> Result<(), Loose> {
        self.work = Work { grids: grids.len(), ..Work::default() };
        for (i, grid) in grids.iter().enumerate() {
            match i.checked_sub(1) {
                Some(coarser) => self.refine(&grids[coarser], grid),
                None => self.bond(grid),
            }
            self.room(grid);
            let before = self.work.solves;
            if self.settle(grid, goal, WHOLE_STEPS).is_err() {
                self.bond(grid);
                self.settle(grid, goal, 1)?;
            }
            self.work.fine_solves = self.work.solves - before;
        }
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

    /// The beam glued to the ground on `zones`: w on all nodes, w' and forces where they touch.
    pub fn glue(&mut self, grid: &Grid) -> Result<(), Loose> {
        let meeting = self.lay_out(grid)?;
        let stand = stand(grid, meeting, false);
        let Workspace { sides, zones, deflection, slope, force, .. } = self;
        for &[from, to] in zones.iter() {
            force[from..=to].fill(0.0);
        }
        let mut fields = Fields { deflection, slope, force };
        let elements = sweep::solve(sides, meeting, stand, &mut fields)?;
        self.work.solves += 1;
        self.work.elements += elements;
        Ok(())
    }

    /// w between the zones, or w'.
    pub fn fill(&mut self, grid: &Grid, derivative: bool) {
        let Workspace { sides, spans, deflection, slope, .. } = self;
        let into = if derivative { slope } else { deflection };
        for (span, side, stretch) in spans.iter() {
            open::beam(grid, span, &sides[*side].shapes[*stretch], derivative, into);
        }
    }

    /// No forces between the zones.
    pub fn clear_open(&mut self, grid: &Grid) {
        let mut open = 0;
        for &[from, to] in &self.zones {
            self.force[open..from].fill(0.0);
            open = to + 1;
        }
        self.force[open..=grid.last()].fill(0.0);
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

    /// A beam that would turn about the nodes that touch is held by their neighbours too.
    fn widen(&mut self, grid: &Grid) -> Result<(), Loose> {
        let ends = self.zones.first().zip(self.zones.last());
        let (from, to) = ends.map(|(first, last)| (first[0], last[1])).ok_or(Loose)?;
        let reach = (to - from).max(1);
        let zone = [from.saturating_sub(reach), (to + reach).min(grid.last())];
        if zone == [from, to] {
            return Err(Loose);
        }
        self.zones.clear();
        self.zones.push(zone);
        Ok(())
    }

    /// Steps until the contact asked for is the contact assumed, the first few taken whole.
    fn settle(&mut self, grid: &Grid, goal: Goal, whole: usize) -> Result<(), Loose> {
        for step in 0..goal.steps {
            if step >= whole {
                if grid.last() > goal.searched {
                    return Err(Loose);
                }
                self.before[0].clone_from(&self.deflection);
                self.before[1].clone_from(&self.force);
            }
            while self.glue(grid).is_err() {
                self.widen(grid)?;
            }
            if step + 1 >= whole {
                self.clear_open(grid);
            }
            self.fill(grid, false);
            let hull = Hull { grid, deflection: &self.deflection };
            hull.zones(&mut self.arcs, &mut self.next);
            if self.next == self.zones || self.moved() <= goal.moves * self.zones.len() {
                return Ok(());
            }
            if step >= whole && self.shorten(grid) {
                return Ok(());
            }
            std::mem::swap(&mut self.zones, &mut self.next);
        }
        Err(Loose)
    }

    /// Goes back on the way from the deflection before as far as the energy asks for. With K w = F − f for
    /// the forces f that a glued solve finds, and for mixtures of such w, the energy's slope along δ is
    /// Σ (p − f) δ with the ground's own answer p. True if nothing is left to fall.
    fn shorten(&mut self, grid: &Grid) -> bool {
        let [w0, f0] = &self.before;
        let (w1, f1) = (&self.deflection, &self.force);
        let count = grid.last() + 1;
        let mut w = vec![0.0; count];
        let (mut arcs, mut zones) = (Vec::new(), Vec::new());
        let mut slope = |t: f64| {
            for i in 0..count {
                w[i] = w0[i] + t * (w1[i] - w0[i]);
            }
            let hull = Hull { grid, deflection: &w };
            hull.zones(&mut arcs, &mut zones);
            let mut sum = 0.0;
            for i in 0..count {
                sum -= (f0[i] + t * (f1[i] - f0[i])) * (w1[i] - w0[i]);
            }
            hull.forces(&zones, |i, p| sum += p * (w1[i] - w0[i]));
            sum
        };
        let fall = -slope(0.0);
        let work: f64 = f1.iter().zip(w1).map(|(f, w)| (f * w).abs()).sum();
        if fall.is_nan() || fall <= LEAST * work {
            return true;
        }
        let slope = std::cell::RefCell::new(slope);
        let t = line::settle(fall, |t| (slope.borrow_mut())(t));
        if t < 1.0 {
            let [w0, f0] = &self.before;
            for i in 0..count {
                self.deflection[i] = w0[i] + t * (self.deflection[i] - w0[i]);
                self.force[i] = f0[i] + t * (self.force[i] - f0[i]);
            }
            let hull = Hull { grid, deflection: &self.deflection };
            hull.zones(&mut self.arcs, &mut self.next);
        }
        false
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

    /// Where the contact ends. The force at the last node that touches tells how much of the ground around
    /// it presses.
    pub fn edges(&self, grid: &Grid) -> Vec<[f64; 2]> {
        let edge = |node: usize, inner: usize| {
            let (x, next) = (grid.x(node), grid.x(inner));
            if node == inner || node == 0 || node == grid.last() {
                return x;
            }
            let part = self.force[node] / self.force[inner];
            if part.is_nan() { x } else { x + (next - x) * (0.5 - part.clamp(0.0, 1.0)) }
        };
        let ends = |&[from, to]: &Zone| {
            let inner = (from + 1).min(to);
            [edge(from, inner), edge(to, if from < to { to - 1 } else { to })]
        };
        self.zones.iter().map(ends).collect()
    }

    /// The stretches that both sides sweep over, and the node where they meet.
    fn lay_out(&mut self, grid: &Grid) -> Result<usize, Loose> {
        let Workspace { sides, spans, zones, .. } = self;
        sides.iter_mut().for_each(Side::clear);
        let mut used = 0;
        let mut span = |grid: &Grid, from: usize, to: usize, side: usize, stretch: usize| {
            if used == spans.len() {
                spans.push(Default::default());
            }
            let place = &mut spans[used];
            used += 1;
            place.0.set(grid, from, to, side == 1);
            (place.1, place.2) = (side, stretch);
            {
                let (length, stiffness, load) = place.0.scaled();
                Form::beam(length, stiffness, load)
            }
        };
        let (Some(&[first, _]), Some(&[_, last])) = (zones.first(), zones.last()) else {
            return Err(Loose);
        };
        let count: usize = zones.iter().map(|[from, to]| to - from).sum();
        // One node holds a beam that tension keeps from turning.
        if count == 0 && zones.len() < 2 && grid.axial_force <= 0.0 {
            return Err(Loose);
        }
        // Half of the elements that touch on each side.
        let mut before = 0;
        let mut meeting = first;
        for &[from, to] in zones.iter() {
            let missing = count / 2 - before;
            meeting = from + missing.min(to - from);
            if missing <= to - from {
                break;
            }
            before += to - from;
        }
        let [left, right] = sides;
        // From the left.
        if first > 0 {
            let form =
                span(grid, 0, first, 0, 0).on(overhang(grid.left_of(first)), gaps(grid, first));
            left.stretches.push(Stretch { form, count: 1, node: 0, stand: off(grid, 0, false) });
        }
        for (i, &[from, to]) in zones.iter().enumerate() {
            if let Some(end) = i.checked_sub(1).map(|i| zones[i][1]) {
                if from > meeting {
                    break;
                }
                let form = span(grid, end, from, 0, left.stretches.len());
                let form = between(grid, form, end, from, false);
                left.stretches.push(Stretch {
                    form,
                    count: 1,
                    node: end,
                    stand: stand(grid, end, false),
                });
            }
            for (run, a, b) in grid.parts(from, to.min(meeting)).filter(|part| part.1 < part.2) {
                left.stretches.push(row(grid, run, a, b, false));
            }
        }
        // From the right.
        if last < grid.last() {
            let link = grid.right_of(last);
            let turned = Link { leak_right: link.leak_left, ..link };
            let form = span(grid, last, grid.last(), 1, 0).on(overhang(turned), gaps(grid, last));
            let node = grid.last();
            right.stretches.push(Stretch { form, count: 1, node, stand: off(grid, node, true) });
        }
        for (i, &[from, to]) in zones.iter().enumerate().rev() {
            if let Some(&[start, _]) = zones.get(i + 1) {
                if to < meeting {
                    break;
                }
                let form = span(grid, to, start, 1, right.stretches.len());
                let form = between(grid, form, to, start, true);
                right.stretches.push(Stretch {
                    form,
                    count: 1,
                    node: start,
                    stand: stand(grid, start, true),
                });
            }
            let first = right.stretches.len();
            let from = from.max(meeting);
            if from < to {
                for (run, a, b) in grid.parts(from, to) {
                    right.stretches.push(row(grid, run, a, b, true));
                }
                right.stretches[first..].reverse();
            }
        }
        spans.truncate(used);
        Ok(meeting)
    }
}

/// What the ground beyond a free end does under the first node that touches.
fn overhang(link: Link) -> Link {
    Link { coupling: 0.0, leak_left: 0.0, leak_right: link.leak_right }
}

fn gaps(grid: &Grid, node: usize) -> [f64; 2] {
    [0.0, grid.gap(node)]
}

/// What stands at a node that touches.
fn stand(grid: &Grid, node: usize, mirrored: bool) -> Stand {
    let [force, moment] = grid.load(node, mirrored);
    let beyond = |end: usize, side: usize| if node == end { grid.outside[side] } else { 0.0 };
    let spring = beyond(0, 0) + beyond(grid.last(), 1);
    Stand { force, moment, spring, push: spring * grid.gap(node) }
}

/// What acts at a free end that does not touch.
fn off(grid: &Grid, node: usize, mirrored: bool) -> Stand {
    Stand { spring: 0.0, push: 0.0, ..stand(grid, node, mirrored) }
}

/// The beam and the open ground between two zones.
fn between(grid: &Grid, form: Form, from: usize, to: usize, turned: bool) -> Form {
    let Some(link) = grid.link(from, to) else { return form };
    let gap = [grid.gap(from), grid.gap(to)];
    if turned {
        let link = Link { leak_left: link.leak_right, leak_right: link.leak_left, ..link };
        form.on(link, [gap[1], gap[0]])
    } else {
        form.on(link, gap)
    }
}

/// Elements of a run, each glued at both ends.
fn row(grid: &Grid, run: usize, from: usize, to: usize, turned: bool) -> Stretch {
    let own = &grid.runs[run];
    let element = |a: usize| {
        let mut cell = own.part(a, a + 1);
        if turned {
            cell = mirrored(&cell);
        }
        let beam = Beam::new(&cell, grid.axial_force, own.h);
        Form::beam(own.h, beam.stiffness(), beam.load()).on(own.link, cell.gap)
    };
    let (first, last, node) = if turned { (to - 1, from, to) } else { (from, to - 1, from) };
    let mut form = element(first);
    if !own.is_even() {
        form = form.towards(&element(last), to - from);
    }
    Stretch { form, count: to - from, node, stand: stand(grid, node, turned) }
}

/// Grids from one on which every wave of the beam is a few elements long to the wanted one; each finer
/// one is as much finer as Newton's method, which squares errors, can make good in a step or two.
pub(super) fn grids(model: &Model, elements: usize, ground: Ground, grids: &mut Vec<Grid>) {
    grids.clear();
    let fine = Grid::new(model, elements, ground);
    let l = model.beam.length;
    let wave = fine.wave_number();
    let coarsest = (l * wave * COARSEST).ceil().max(8.0);
    let mut wanted = elements as f64;
    grids.push(fine);
    loop {
        // h → √(h/wave).
        let next = (wanted * l * wave).sqrt() * FINER;
        if next >= 0.7 * wanted || next < coarsest {
            if wanted > 2.0 * coarsest {
                grids.push(Grid::new(model, coarsest as usize, ground));
            }
            break;
        }
        wanted = next;
        grids.push(Grid::new(model, wanted as usize, ground));
    }
    grids.reverse();
}

/// Elements per 1/wave number on the coarsest grid.
const COARSEST: f64 = 1.5;
/// How much finer than √(h/wave) each grid is.
const FINER: f64 = 1.0;
