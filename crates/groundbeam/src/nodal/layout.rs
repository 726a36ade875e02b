//! Divides the beam into rows of bonded elements and spans out of contact, for the elimination from both ends of the beam.

use super::form::Form;
use super::grid::Grid;
use super::hull::Zone;
use super::quadratic::NotSolved;
use super::span::Span;
use super::stand::{StabilisingSprings, Stand};
use super::stretch::{Side, Stretch};
use crate::element::element::{Basis, mirror_shape};
use crate::ground::link::TwoPort;

/// A span out of contact, with its index `stretch` in the elimination from the left end (`side` 0) or the right end
/// (1).
#[derive(Debug, Clone, Default)]
pub(crate) struct Placed {
    pub span: Span,
    pub side: usize,
    pub stretch: usize,
}

/// Division of the beam into stretches, for two eliminations from the ends of the beam to a meeting node.
#[derive(Debug, Clone, Default)]
pub(crate) struct Layout {
    pub sides: [Side; 2],
    /// Node where the elimination from the left end and the elimination from the right end meet.
    pub meeting: usize,
    /// Loads, supports, hinge and springs at the node where the eliminations from both ends of the beam meet.
    pub stand: Stand,
    /// Deflection of the node where the eliminations from both ends of the beam meet, and the rotations to the left and
    /// to the right of this node, from the last solve.
    pub middle: [f64; 3],
    /// Whether the beam touches the ground anywhere.
    touches: bool,
    /// The first `used` entries are the spans of this layout. The other entries keep their memory for the next
    /// solve.
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
        springs: Option<&StabilisingSprings>,
    ) -> Result<(), NotSolved> {
        let count: usize = zones.iter().map(|[from, to]| to - from).sum();
        self.sides.iter_mut().for_each(Side::clear);
        self.used = 0;
        self.touches = !zones.is_empty();
        if zones.is_empty() {
            self.meeting = grid.last();
            self.stand = Stand::at(grid, self.meeting, false, springs);
            return self.open(grid, LEFT, None, self.meeting, springs);
        }
        self.meeting = middle(zones, count / 2);
        self.stand = Stand::on_ground(grid, self.meeting, false, springs);
        self.set_left(grid, zones, springs)?;
        self.set_right(grid, zones, springs)
    }

    /// Calls `each` for every bonded element with its left node and (w, θ, d₁, d₂): deflection w and rotation θ of
    /// its left end, and its deformations d₁ and d₂.
    pub fn each_element(&self, grid: &Grid, mut each: impl FnMut(usize, [f64; 4])) {
        let [w, behind, ahead] = self.middle;
        let (mut left, mut right) = (self.meeting, self.meeting);
        self.sides[LEFT].each_element(w, behind, |stretch, v| {
            left = if stretch.is_span() { stretch.node } else { left - 1 };
            if !stretch.is_span() {
                each(left, v);
            }
        });
        self.sides[RIGHT].each_element(w, -ahead, |stretch, v| {
            if stretch.is_span() {
                right = stretch.node;
                return;
            }
            each(right, mirror_shape(&v, grid.runs[grid.run_at(right)].h, Basis::Deformation));
            right += 1;
        });
    }

    pub fn spans(&self) -> &[Placed] {
        &self.spans[..self.used]
    }

    fn set_left(
        &mut self,
        grid: &Grid,
        zones: &[Zone],
        springs: Option<&StabilisingSprings>,
    ) -> Result<(), NotSolved> {
        let (mut behind, meeting) = (None, self.meeting);
        for &[from, to] in zones.iter().take_while(|zone| zone[0] <= meeting) {
            self.open(grid, LEFT, behind, from, springs)?;
            for (run, a, b) in grid.parts(from, to.min(meeting)) {
                self.sides[LEFT].stretches.push(row(grid, run, [a, b], false, springs));
            }
            behind = Some(to);
        }
        Ok(())
    }

    fn set_right(
        &mut self,
        grid: &Grid,
        zones: &[Zone],
        springs: Option<&StabilisingSprings>,
    ) -> Result<(), NotSolved> {
        let (mut behind, meeting) = (None, self.meeting);
        for &[from, to] in zones.iter().rev().take_while(|zone| zone[1] >= meeting) {
            self.open(grid, RIGHT, behind, to, springs)?;
            let stretches = &mut self.sides[RIGHT].stretches;
            let first = stretches.len();
            for (run, a, b) in grid.parts(from.max(meeting), to) {
                stretches.push(row(grid, run, [a, b], true, springs));
            }
            stretches[first..].reverse();
            behind = Some(from);
        }
        Ok(())
    }

    /// Adds the span out of contact from the node `behind`, or from an end of the beam (`None`), to the node `to`.
    fn open(
        &mut self,
        grid: &Grid,
        side: usize,
        behind: Option<usize>,
        to: usize,
        springs: Option<&StabilisingSprings>,
    ) -> Result<(), NotSolved> {
        let mirrored = side == RIGHT;
        if let Some(node) = behind {
            let link = grid.link(node.min(to), node.max(to)).unwrap_or_default();
            let link = if mirrored { link.mirrored() } else { link };
            let form = Form::default().on(link, [grid.gap(node), grid.gap(to)]);
            let stand = Stand::on_ground(grid, node, mirrored, springs);
            return self.add_span(grid, side, [node, to], form, stand, springs);
        }
        // In an overhang the ground does not couple the nodes, so the overhang can be divided at supports, hinges
        // and stabilising springs.
        let mut node = if mirrored { grid.last() } else { 0 };
        let holds = |at: &usize| Stand::at(grid, *at, mirrored, springs).is_joint();
        let mut cuts: Vec<usize> = grid.firsts().filter(holds).collect();
        if mirrored {
            cuts.reverse();
        }
        cuts.retain(|at| node.min(to) < *at && *at < node.max(to));
        cuts.push(to);
        for next in cuts {
            if next == node {
                break;
            }
            let mut form = Form::default();
            if next == to && self.touches {
                // The end of the overhang is not in contact, so the ground under and beyond the overhang acts as one
                // spring at `to`.
                let ground = if mirrored { grid.right_of(to).mirrored() } else { grid.left_of(to) };
                let shunt_right = ground.shunt_right;
                let spring = TwoPort { shunt_right, ..TwoPort::default() };
                form = form.on(spring, [0.0, grid.gap(to)]);
            }
            let stand = Stand::at(grid, node, mirrored, springs);
            self.add_span(grid, side, [node, next], form, stand, springs)?;
            node = next;
        }
        Ok(())
    }

    /// Condenses the beam between two nodes and the ground under this part of the beam to one element. Adds this
    /// element to the elimination from one end of the beam.
    fn add_span(
        &mut self,
        grid: &Grid,
        side: usize,
        [node, to]: [usize; 2],
        ground: Form,
        stand: Stand,
        springs: Option<&StabilisingSprings>,
    ) -> Result<(), NotSolved> {
        if node == to {
            return Ok(());
        }
        let mirrored = side == RIGHT;
        if self.used == self.spans.len() {
            self.spans.push(Placed::default());
        }
        let placed = &mut self.spans[self.used];
        self.used += 1;
        (placed.side, placed.stretch) = (side, self.sides[side].stretches.len());
        let nodes = [node.min(to), node.max(to)];
        placed.span.set(grid, nodes, mirrored, |at| Stand::at(grid, at, mirrored, springs))?;
        let stretch = Stretch::span(&placed.span.whole, ground, node, stand);
        self.sides[side].stretches.push(stretch);
        Ok(())
    }
}

/// Returns the node that has `count` bonded elements on its left.
fn middle(zones: &[Zone], mut count: usize) -> usize {
    for &[from, to] in zones {
        if count <= to - from {
            return from + count;
        }
        count -= to - from;
    }
    0
}

/// Creates a stretch from consecutive elements of a row of equal elements. The ground is bonded to both ends of each
/// element.
fn row(
    grid: &Grid,
    run: usize,
    [from, to]: [usize; 2],
    mirrored: bool,
    springs: Option<&StabilisingSprings>,
) -> Stretch {
    let own = &grid.runs[run];
    let (before, node) = if mirrored { (own.end() - to, to) } else { (from - own.first, from) };
    let form = own.bonded[usize::from(mirrored)].after(before);
    Stretch::row(form, to - from, node, Stand::on_ground(grid, node, mirrored, springs))
}
