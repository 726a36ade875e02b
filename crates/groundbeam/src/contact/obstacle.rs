//! Solves the obstacle problem (2.10) of Kikuchi's paper: computes the contact set of the ground for a given deflection w.
//!
//! The obstacle is the deflection minus the initial gap and the free-field settlement. As for a convex hull, one scan
//! joins the *arcs*, on which full contact gives no tension, by tangent spans of unloaded ground. It costs O(n)
//! operations. See section 2 of `docs/methods.md`.

use crate::contact::short_span::{self, ShortSpan};
use crate::contact::springs::{is_rounding_error, join, positive_parts, winkler_contact};
use crate::ground::link::TwoPort;
use crate::mesh::deflection::{BeamPoint, Deflection, MeshZone};
use crate::mesh::ground_runs::{GroundRun, ground_runs};
use crate::mesh::mesh::Mesh;
use crate::mesh::open_ground::cell_part;
use crate::numeric::polynomial::Coefficients;

/// Returns the contact zones for a given deflection w, from left to right.
pub(crate) fn contact(w: &Deflection) -> Vec<MeshZone> {
    let mut zones = Vec::new();
    for run in ground_runs(w.mesh) {
        if run.pasternak {
            let scan = Scan::new(w, &run);
            zones.extend(scan.run().into_iter().filter(|zone| !w.is_held(zone)));
        } else {
            zones.extend(winkler_contact(w, &run));
        }
    }
    zones
}

/// Open ground between two points of the beam. If a point is `None`, the span includes the ground beyond this end of
/// the [`GroundRun`].
#[derive(Debug, Clone, Copy)]
struct OpenSpan {
    left: Option<BeamPoint>,
    right: Option<BeamPoint>,
    /// Two-port of the whole cells between `left` and `right`, and of the ground beyond the [`GroundRun`] if one is
    /// `None`.
    middle: Option<TwoPort>,
}

/// A contact zone, and the open span on its left.
#[derive(Debug, Clone, Copy)]
struct KeptZone {
    zone: MeshZone,
    span: OpenSpan,
}

/// Newton's method for an edge has converged if its step is rounding error and the last step reduced the force below
/// this fraction. Beside very short open spans, small steps alone do not show convergence.
const CONVERGED: f64 = 0.01;

struct Scan<'a> {
    w: &'a Deflection<'a>,
    run: &'a GroundRun,
    /// Coefficients of the pressure of full contact in each cell of the run.
    pressures: Vec<Coefficients>,
}

impl<'a> Scan<'a> {
    fn new(w: &'a Deflection<'a>, run: &'a GroundRun) -> Self {
        Scan { w, run, pressures: run.cells.clone().map(|i| w.pressure(i)).collect() }
    }

    fn pressure(&self, i: usize) -> &Coefficients {
        &self.pressures[i - self.run.cells.start]
    }

    fn run(&self) -> Vec<MeshZone> {
        self.contact_set(self.arcs().into_iter())
    }

    fn contact_set(&self, arcs: impl Iterator<Item = MeshZone>) -> Vec<MeshZone> {
        let mut stack: Vec<KeptZone> = Vec::new();
        for arc in arcs {
            let mut new = arc;
            let start = arc.from.cell;
            let mut span = match stack.last() {
                Some(last) => OpenSpan {
                    left: Some(last.zone.to),
                    right: Some(new.from),
                    middle: self.whole_cells(last.zone.to.cell + 1, start, None),
                },
                None => self.beyond_to(new.from),
            };
            loop {
                let Some(last) = stack.last() else {
                    self.trim_right(&mut span, new.to);
                    break;
                };
                self.tighten(&mut span, last.zone.from, new.to);
                if !self.drops_last(&mut stack, &mut span) {
                    break;
                }
            }
            if let Some(from) = span.right {
                new.from = from;
            }
            stack.push(KeptZone { zone: new, span });
        }
        self.close(&mut stack);
        stack.into_iter().map(|kept| kept.zone).collect()
    }

    /// Ends the last zone at the left end of `span`. If only a point without compression is left, adds the zone to
    /// `span` and returns true.
    fn drops_last(&self, stack: &mut Vec<KeptZone>, span: &mut OpenSpan) -> bool {
        let (Some(last), Some(touch)) = (stack.last_mut(), span.left) else { return false };
        last.zone.to = touch;
        let dropped = touch == last.zone.from && self.contact_force(&last.span, span) <= 0.0;
        if dropped {
            *span = self.merged(&last.span, &last.zone, span);
            stack.pop();
        }
        dropped
    }

    /// Ends the last zone where the open ground at the right end of the [`GroundRun`] begins. Removes zones without
    /// compression.
    fn close(&self, stack: &mut Vec<KeptZone>) {
        let end = self.run.cells.end;
        let Some(last) = stack.last() else { return };
        let beyond = TwoPort { series: 0.0, shunt_left: self.run.beyond[1], shunt_right: 0.0 };
        let mut span = OpenSpan {
            left: Some(last.zone.to),
            right: None,
            middle: Some(match self.whole_cells(last.zone.to.cell + 1, end, None) {
                Some(cells) => cells.then(beyond),
                None => beyond,
            }),
        };
        while let Some(last) = stack.last() {
            self.trim_left(&mut span, last.zone.from);
            if !self.drops_last(stack, &mut span) {
                break;
            }
        }
    }

    /// Returns the arcs: intervals on which full contact gives no tension, and single points that may carry a force
    /// (ends of the shear layer and corners pressed into the ground).
    fn arcs(&self) -> Vec<MeshZone> {
        let cells = self.run.cells.clone();
        let mut arcs: Vec<MeshZone> = Vec::new();
        let mut knots = Vec::new();
        let presses = |i: &usize| !is_rounding_error(self.w, *i);
        for i in cells.clone().filter(presses) {
            let corner = if i == cells.start { 1.0 } else { self.w.corner(i) };
            let mut parts = positive_parts(self.pressure(i), &mut knots).peekable();
            let starts_here = parts.peek().is_some_and(|part| part[0] == -1.0);
            let ended_here =
                arcs.last().is_some_and(|a| a.to == BeamPoint { cell: i.wrapping_sub(1), s: 1.0 });
            if corner > 0.0 && !starts_here && !ended_here {
                arcs.push(point_zone(BeamPoint { cell: i, s: -1.0 }));
            }
            // A corner with a tensile force separates two arcs.
            for part in parts {
                join(&mut arcs, i, part, corner >= 0.0);
            }
        }
        let end = BeamPoint { cell: cells.end - 1, s: 1.0 };
        if presses(&end.cell) && arcs.last().is_none_or(|arc| arc.to != end) {
            arcs.push(point_zone(end));
        }
        arcs
    }

    fn whole_cells(&self, from: usize, to: usize, before: Option<TwoPort>) -> Option<TwoPort> {
        whole_cells(self.w.mesh, from, to, before)
    }

    fn beyond_to(&self, to: BeamPoint) -> OpenSpan {
        let beyond = TwoPort { series: 0.0, shunt_left: 0.0, shunt_right: self.run.beyond[0] };
        let middle = self.whole_cells(self.run.cells.start, to.cell, Some(beyond));
        OpenSpan { left: None, right: Some(to), middle }
    }

    fn link(&self, span: &OpenSpan) -> TwoPort {
        let part = |i: usize, from: f64, to: f64| cell_part(&self.w.mesh.cells[i], from, to);
        if let (Some(a), Some(b)) = (span.left, span.right)
            && a.cell == b.cell
        {
            return part(a.cell, a.s, b.s);
        }
        let head = span.left.filter(|a| a.s < 1.0).map(|a| part(a.cell, a.s, 1.0));
        let tail = span.right.filter(|b| b.s > -1.0).map(|b| part(b.cell, -1.0, b.s));
        let parts = [head, span.middle, tail];
        let whole = parts.into_iter().flatten().reduce(TwoPort::then);
        // If both ends of the span lie at one node, the span has length zero.
        whole.unwrap_or_else(TwoPort::rigid)
    }

    /// The contact force at a single point between two spans; negative in tension.
    fn contact_force(&self, before: &OpenSpan, after: &OpenSpan) -> f64 {
        let fluxes =
            |span: &OpenSpan| short_span::fluxes(self.w, [span.left, span.right], &self.link(span));
        fluxes(before)[1] + fluxes(after)[0]
    }

    /// Returns the open span that replaces two adjacent open spans and the contact zone between them, which is removed.
    fn merged(&self, before: &OpenSpan, zone: &MeshZone, after: &OpenSpan) -> OpenSpan {
        let first = before.left.map_or(self.run.cells.start, |a| a.cell + 1);
        let last = after.right.map_or(self.run.cells.end, |b| b.cell);
        let from = zone.from.cell.max(first);
        let to = (zone.to.cell + 1).min(last);
        let inner = self.whole_cells(from, to, before.middle);
        OpenSpan { left: before.left, right: after.right, middle: chained(inner, after.middle) }
    }

    /// Trims the two ends of the span in turn until neither end moves.
    fn tighten(&self, span: &mut OpenSpan, left_limit: BeamPoint, right_limit: BeamPoint) {
        let opened =
            span.left.zip(span.right).and_then(|(a, b)| short_span::opened(self.w, [a, b]));
        if let Some([a, b]) = opened
            && left_limit < a
            && b < right_limit
        {
            (span.left, span.right) = (Some(a), Some(b));
        }
        for _ in 0..60 {
            let before = (span.left, span.right);
            self.trim_left(span, left_limit);
            self.trim_right(span, right_limit);
            if before == (span.left, span.right) {
                break;
            }
        }
    }

    /// Returns the concentrated force at the left end of an open span, and its derivative with respect to the position.
    fn force_at_left(&self, span: &OpenSpan, point: BeamPoint) -> [f64; 2] {
        let trial = OpenSpan { left: Some(point), ..*span };
        let [psi, slope, pressure] = self.w.obstacle_and_pressure(point);
        let other = span.right.map_or(0.0, |b| self.w.obstacle_at(b));
        let [_, shear] = self.w.mesh.cells[point.cell].ground_at(point.s);
        let (force, link) = match self.short(&trial) {
            Some(short) => (short.forces[0], short.link()),
            None => {
                let link = self.link(&trial);
                (shear * slope + link.force_left(psi, other), link)
            }
        };
        [force, (link.shunt_left + link.series) / shear * force - pressure]
    }

    /// Returns the concentrated force at the right end of an open span, and its derivative with respect to the
    /// position.
    fn force_at_right(&self, span: &OpenSpan, point: BeamPoint) -> [f64; 2] {
        let trial = OpenSpan { right: Some(point), ..*span };
        let [psi, slope, pressure] = self.w.obstacle_and_pressure(point);
        let other = span.left.map_or(0.0, |a| self.w.obstacle_at(a));
        let [_, shear] = self.w.mesh.cells[point.cell].ground_at(point.s);
        let (force, link) = match self.short(&trial) {
            Some(short) => (short.forces[1], short.link()),
            None => {
                let link = self.link(&trial);
                (link.force_right(other, psi) - shear * slope, link)
            }
        };
        [force, pressure - (link.shunt_right + link.series) / shear * force]
    }

    /// Returns a short open span with its end forces, or `None` if differences of slopes are more accurate.
    fn short(&self, span: &OpenSpan) -> Option<ShortSpan> {
        ShortSpan::of(self.w, [span.left, span.right], |i| *self.pressure(i))
    }

    /// Moves the left end of the span to the left until the force at this end is not tensile.
    fn trim_left(&self, span: &mut OpenSpan, limit: BeamPoint) {
        let Some(mut point) = span.left else { return };
        if point == limit {
            return;
        }
        let force_here = self.force_at_left(span, point);
        if force_here[0] >= 0.0 {
            return;
        }
        let mut first = Some(force_here);
        loop {
            let start = if point.cell == limit.cell { limit.s } else { -1.0 };
            let low = BeamPoint { cell: point.cell, s: start };
            if self.force_at_left(span, low)[0] >= 0.0 {
                let force = |s: f64| self.force_at_left(span, BeamPoint { cell: point.cell, s });
                point.s = self.tangent(point.cell, [start, point.s], first, force, -1.0);
                break;
            }
            if point.cell == limit.cell {
                point = limit;
                break;
            }
            // The span now reaches the left end of the cell of `point`. If the right end of the span lies in
            // another cell, the cell of `point` is now one of the whole cells of the span.
            if span.right.is_none_or(|b| b.cell != point.cell) {
                let opened = self.whole_cells(point.cell, point.cell + 1, None);
                span.middle = chained(opened, span.middle);
            }
            point = BeamPoint { cell: point.cell - 1, s: 1.0 };
            first = None;
            span.left = Some(point);
        }
        span.left = Some(point);
    }

    /// Moves the right end of the span to the right until the force at this end is not tensile.
    fn trim_right(&self, span: &mut OpenSpan, limit: BeamPoint) {
        let Some(mut point) = span.right else { return };
        if point == limit {
            return;
        }
        let force_here = self.force_at_right(span, point);
        if force_here[0] >= 0.0 {
            return;
        }
        let mut first = Some(force_here);
        loop {
            let end = if point.cell == limit.cell { limit.s } else { 1.0 };
            let high = BeamPoint { cell: point.cell, s: end };
            if self.force_at_right(span, high)[0] >= 0.0 {
                let force = |s: f64| self.force_at_right(span, BeamPoint { cell: point.cell, s });
                point.s = self.tangent(point.cell, [point.s, end], first, force, 1.0);
                break;
            }
            if point.cell == limit.cell {
                point = limit;
                break;
            }
            if span.left.is_none_or(|a| a.cell != point.cell) {
                span.middle = self.whole_cells(point.cell, point.cell + 1, span.middle);
            }
            point = BeamPoint { cell: point.cell + 1, s: -1.0 };
            first = None;
            span.right = Some(point);
        }
        span.right = Some(point);
    }

    /// Finds the position in a cell at which the function `force` changes its sign. `sense` is the sign of the force at
    /// the right end of the cell, and `first` the value of `force` at the start, if known. Bisection replaces a Newton step that
    /// leaves the bracket or does not halve the force.
    fn tangent(
        &self,
        cell: usize,
        [mut low, mut high]: [f64; 2],
        mut first: Option<[f64; 2]>,
        force: impl Fn(f64) -> [f64; 2],
        sense: f64,
    ) -> f64 {
        let half = 0.5 * self.w.mesh.cells[cell].length();
        let mut s = if sense > 0.0 { low } else { high };
        let mut before = f64::INFINITY;
        // After Newton's method has converged, steps of increasing length cross the root and close the bracket.
        let mut closing_step = None;
        // 128 is twice the number of bisections that double precision allows.
        for _ in 0..128 {
            let [f, slope] = first.take().unwrap_or_else(|| force(s));
            if f == 0.0 {
                return s;
            }
            if (f > 0.0) == (sense > 0.0) {
                high = s;
            } else {
                low = s;
            }
            let newton = s - f / (slope * half);
            let is_rounding = (newton - s).abs() <= 2.0 * f64::EPSILON;
            let good = f.abs() < 0.5 * before && newton > low && newton < high;
            if good && is_rounding {
                return newton;
            }
            // At a corner of the obstacle the force jumps. The result is then the end of the interval at which the
            // force is not tensile.
            if high - low <= 2.0 * f64::EPSILON {
                return if sense > 0.0 { high } else { low };
            }
            if is_rounding && before.is_finite() && f.abs() < CONVERGED * before {
                closing_step.get_or_insert(f64::EPSILON);
            }
            let middle = 0.5 * (low + high);
            before = f.abs();
            s = match &mut closing_step {
                Some(step) => {
                    *step *= 4.0;
                    if s == high { (s - *step).max(middle) } else { (s + *step).min(middle) }
                }
                None if good => newton,
                None => middle,
            };
        }
        s
    }
}

fn chained(first: Option<TwoPort>, second: Option<TwoPort>) -> Option<TwoPort> {
    match (first, second) {
        (Some(a), Some(b)) => Some(a.then(b)),
        (a, b) => a.or(b),
    }
}

fn point_zone(point: BeamPoint) -> MeshZone {
    MeshZone { from: point, to: point }
}

/// Returns the two-port of `before` and of the cells `from..to` in series. Consecutive cells of equal uniform
/// ground are treated as one cell.
fn whole_cells(mesh: &Mesh, from: usize, to: usize, before: Option<TwoPort>) -> Option<TwoPort> {
    let mut link = before;
    let mut i = from;
    while i < to {
        let cell = &mesh.cells[i];
        let mut end = i + 1;
        while end < to && cell.shares_even_ground(&mesh.cells[end]) {
            end += 1;
        }
        let length = mesh.cells[end - 1].x[1] - cell.x[0];
        let uniform = || TwoPort::uniform(cell.subgrade, cell.shear_layer, length);
        let own = if cell.ground_varies() { cell_part(cell, -1.0, 1.0) } else { uniform() };
        link = Some(link.map_or(own, |link| link.then(own)));
        i = end;
    }
    link
}
