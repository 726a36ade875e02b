//! The stretches of both sweeps: rows of elements that touch, and spans off the ground.

use super::form::Form;
use super::grid::Grid;
use super::hull::Zone;
use super::span::Span;
use super::sweep::{Loose, Side, Stand, Stretch};
use crate::ground::link::TwoPort;

/// Springs that hold the beam's two ends where they are: what the ground does not hold.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tether {
    pub spring: f64,
    /// w of the two ends.
    pub at: [f64; 2],
}

impl Tether {
    /// The springs' forces on the beam with other w of its ends, up positive.
    pub fn forces(&self, ends: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|i| self.spring * (ends[i] - self.at[i]))
    }
}

/// A span, the side that sweeps over it and the number of its stretch.
#[derive(Debug, Clone, Default)]
pub(crate) struct Placed {
    pub span: Span,
    pub side: usize,
    pub stretch: usize,
}

/// The beam cut up for two sweeps that meet.
#[derive(Debug, Clone, Default)]
pub(crate) struct Layout {
    pub sides: [Side; 2],
    /// The node where they meet, and what stands there.
    pub meeting: usize,
    pub stand: Stand,
    /// Those not used now keep their memory.
    spans: Vec<Placed>,
    used: usize,
}

const LEFT: usize = 0;
const RIGHT: usize = 1;

impl Layout {
    pub fn set(
        &mut self,
        grid: &Grid,
        zones: &[Zone],
        tether: Option<Tether>,
    ) -> Result<(), Loose> {
        let count: usize = zones.iter().map(|[from, to]| to - from).sum();
        // One node holds a beam that tension keeps from turning.
        let turns = count == 0 && zones.len() < 2 && grid.axial_force <= 0.0;
        if zones.is_empty() || (turns && tether.is_none()) {
            return Err(Loose);
        }
        self.sides.iter_mut().for_each(Side::clear);
        self.used = 0;
        self.meeting = middle(zones, count / 2);
        self.stand = stand(grid, self.meeting, false);
        self.set_left(grid, zones);
        self.set_right(grid, zones);
        if let Some(tether) = tether {
            self.hold(&tether);
        }
        Ok(())
    }

    pub fn spans(&self) -> &[Placed] {
        &self.spans[..self.used]
    }

    fn set_left(&mut self, grid: &Grid, zones: &[Zone]) {
        let (mut behind, meeting) = (None, self.meeting);
        for &[from, to] in zones.iter().take_while(|zone| zone[0] <= meeting) {
            self.open(grid, LEFT, behind, from);
            for (run, a, b) in grid.parts(from, to.min(meeting)) {
                self.sides[LEFT].stretches.push(row(grid, run, a, b, false));
            }
            behind = Some(to);
        }
    }

    fn set_right(&mut self, grid: &Grid, zones: &[Zone]) {
        let (mut behind, meeting) = (None, self.meeting);
        for &[from, to] in zones.iter().rev().take_while(|zone| zone[1] >= meeting) {
            self.open(grid, RIGHT, behind, to);
            let stretches = &mut self.sides[RIGHT].stretches;
            let first = stretches.len();
            for (run, a, b) in grid.parts(from.max(meeting), to) {
                stretches.push(row(grid, run, a, b, true));
            }
            stretches[first..].reverse();
            behind = Some(from);
        }
    }

    /// The span from a zone's end, or else from the end of the beam, to the first node of the next.
    fn open(&mut self, grid: &Grid, side: usize, behind: Option<usize>, to: usize) {
        let mirrored = side == RIGHT;
        let end = if mirrored { grid.last() } else { 0 };
        let node = behind.unwrap_or(end);
        if node == to {
            return;
        }
        if self.used == self.spans.len() {
            self.spans.push(Placed::default());
        }
        let placed = &mut self.spans[self.used];
        self.used += 1;
        (placed.side, placed.stretch) = (side, self.sides[side].stretches.len());
        placed.span.set(grid, node.min(to), node.max(to), mirrored);
        let (length, stiffness, load) = placed.span.scaled();
        let form = Form::beam(length, stiffness, load);
        let (link, stand) = if behind.is_some() {
            (grid.link(node.min(to), node.max(to)), stand(grid, node, mirrored))
        } else {
            // The ground beyond the end and under it is one spring; the end itself does not touch.
            let shunt_right =
                if mirrored { grid.right_of(to).shunt_left } else { grid.left_of(to).shunt_right };
            let spring = TwoPort { series: 0.0, shunt_left: 0.0, shunt_right };
            (Some(spring), Stand { spring: 0.0, push: 0.0, ..stand(grid, node, mirrored) })
        };
        let turned = |link: TwoPort| match mirrored && behind.is_some() {
            true => TwoPort { shunt_left: link.shunt_right, shunt_right: link.shunt_left, ..link },
            false => link,
        };
        let gap = [if behind.is_some() { grid.gap(node) } else { 0.0 }, grid.gap(to)];
        let form = link.map_or(form, |link| form.on(turned(link), gap));
        self.sides[side].stretches.push(Stretch { form, count: 1, node, stand });
    }

    /// Springs under the two ends, which are where the sweeps begin unless they meet there.
    fn hold(&mut self, tether: &Tether) {
        for (side, at) in self.sides.iter_mut().zip(tether.at) {
            let stand = match side.stretches.first_mut() {
                Some(stretch) => &mut stretch.stand,
                None => &mut self.stand,
            };
            stand.spring += tether.spring;
            stand.push += tether.spring * at;
        }
    }
}

/// The node that has so many glued elements to its left.
fn middle(zones: &[Zone], mut count: usize) -> usize {
    for &[from, to] in zones {
        if count <= to - from {
            return from + count;
        }
        count -= to - from;
    }
    0
}

/// What stands at a node that touches.
fn stand(grid: &Grid, node: usize, mirrored: bool) -> Stand {
    let [force, moment] = grid.load(node, mirrored);
    let beyond = |end: usize, side: usize| if node == end { grid.outside[side] } else { 0.0 };
    let spring = beyond(0, 0) + beyond(grid.last(), 1);
    Stand { force, moment, spring, push: spring * grid.gap(node) }
}

/// Elements of a run, each glued at both ends.
fn row(grid: &Grid, run: usize, from: usize, to: usize, mirrored: bool) -> Stretch {
    let own = &grid.runs[run];
    let (before, node) = if mirrored { (own.end() - to, to) } else { (from - own.first, from) };
    let form = own.glued[usize::from(mirrored)].after(before);
    Stretch { form, count: to - from, node, stand: stand(grid, node, mirrored) }
}
