//! Solves the obstacle problem (2.10) of Kikuchi's paper: computes the contact set of the ground for a given deflection w.
//!
//! The obstacle is ψ = w − g₀ − u₀, with the initial gap g₀ and the free-field settlement u₀. The ground surface is
//! the least u ≥ ψ with −(μu')' + ku ≥ 0, where k is the subgrade modulus and μ the stiffness of the shear layer.
//! One scan from left to right computes u. It works like the construction of a convex hull, with solutions of
//! −(μu')' + ku = 0 in place of straight lines.
//!
//! * Beam and ground can touch along an interval only where the contact pressure π = kψ − (μψ')' is not negative.
//!   These candidate intervals, the *arcs*, follow from the sign changes of the polynomial π.
//! * The stack contains the contact intervals of the arcs read so far. A span of unloaded ground, tangent to the last
//!   arc and to a new arc, joins these two arcs and trims them. An arc on which the ground would be in tension is
//!   dropped, and the span is extended to the previous arc.
//! * At the ends a and b of the span the concentrated forces A = μψ'(a) − μu'(a) and B = μu'(b) − μψ'(b) are zero.
//!   There dA/da = −π(a) and dB/db = π(b), and neither force depends on the opposite end to first order. So Newton's
//!   method on each end in turn converges quadratically.
//!
//! The scan trims each arc only from its ends and passes each cell once, so its cost is O(n).

use crate::contact::short_span;
use crate::contact::springs::{is_rounding_error, join, positive_parts, winkler_contact};
use crate::ground::link::TwoPort;
use crate::mesh::deflection::{BeamPoint, Deflection, MeshZone};
use crate::mesh::ground_runs::{GroundRun, ground_runs};
use crate::mesh::mesh::Mesh;
use crate::mesh::open_ground::cell_part;

/// Returns the contact zones for a given deflection w, from left to right.
pub(crate) fn contact(w: &Deflection) -> Vec<MeshZone> {
    let mut zones = Vec::new();
    for run in ground_runs(w.mesh) {
        if run.pasternak {
            zones.extend(Scan { w, run: &run }.run().into_iter().filter(|zone| !w.is_held(zone)));
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
    /// Force–displacement relation of the whole cells between the cell that contains `left` and the cell that
    /// contains `right`. If `left` or `right` is `None`, the relation also covers the ground beyond the
    /// corresponding end of the [`GroundRun`].
    middle: Option<TwoPort>,
}

/// A contact zone, and the open span on its left.
#[derive(Debug, Clone, Copy)]
struct KeptZone {
    zone: MeshZone,
    span: OpenSpan,
}

/// Newton's method for the position of a contact edge has converged if its step is only rounding error and the
/// concentrated force at the edge is below this fraction of the force before the step. A small step alone is not
/// sufficient. If the span out of contact beside the edge is very short, a large force also causes only a small
/// step.
const CONVERGED: f64 = 0.01;

struct Scan<'a> {
    w: &'a Deflection<'a>,
    run: &'a GroundRun,
}

impl Scan<'_> {
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

    /// Ends the last contact zone of `stack` at the left end of `span`. If the zone is then a single point without a
    /// compressive force, removes the zone and extends `span` to the previous zone. Returns whether the zone was
    /// removed.
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

    /// Computes the span out of contact at the right end of the [`GroundRun`], and ends the last contact zone of
    /// `stack` at the left end of this span. If this zone is then a single point without a compressive force, removes
    /// the zone, extends the span and treats the previous zone in the same way.
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

    /// Returns the candidate intervals (arcs), on which the pressure of the ground in full contact is not negative.
    /// Arcs are joined over cells unless a corner of the obstacle separates them. Also returns single points that
    /// may carry a force: ends of the shear layer, and corners that press into the ground. A cell on which the obstacle
    /// is only rounding error has no arcs.
    fn arcs(&self) -> Vec<MeshZone> {
        let cells = self.run.cells.clone();
        let mut arcs: Vec<MeshZone> = Vec::new();
        let mut knots = Vec::new();
        let presses = |i: &usize| !is_rounding_error(self.w, *i);
        for i in cells.clone().filter(presses) {
            let corner = if i == cells.start { 1.0 } else { self.w.corner(i) };
            let pressure = self.w.pressure(i);
            let mut parts = positive_parts(&pressure, &mut knots).peekable();
            let starts_here = parts.peek().is_some_and(|part| part[0] == -1.0);
            let ended_here =
                arcs.last().is_some_and(|a| a.to == BeamPoint { cell: i.wrapping_sub(1), s: 1.0 });
            if corner > 0.0 && !starts_here && !ended_here {
                arcs.push(point_zone(BeamPoint { cell: i, s: -1.0 }));
            }
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
        // If both ends of the span lie at one node, the span has length zero. Its series stiffness is then practically
        // infinite, so both ends have the same settlement.
        whole.unwrap_or(TwoPort { series: f64::MAX, shunt_left: 0.0, shunt_right: 0.0 })
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

    /// Computes the concentrated contact force A at the left end a of a span of ground out of contact, and its
    /// derivative dA/da = −π + (S/μ) A. π is the pressure that the ground at a would have in contact. S is the
    /// force at a per unit settlement of the ground at a, and μ is the stiffness of the shear layer.
    fn force_at_left(&self, span: &OpenSpan, point: BeamPoint) -> [f64; 2] {
        let trial = OpenSpan { left: Some(point), ..*span };
        let [psi, slope, pressure] = self.w.obstacle_and_pressure(point);
        let other = span.right.map_or(0.0, |b| self.w.obstacle_at(b));
        let [_, shear] = self.w.mesh.cells[point.cell].ground_at(point.s);
        let link = self.link(&trial);
        let force = match self.short(&trial) {
            Some([force, _]) => force,
            None => shear * slope + link.force_left(psi, other),
        };
        [force, (link.shunt_left + link.series) / shear * force - pressure]
    }

    /// Computes the concentrated contact force B at the right end b of a span of ground out of contact, and its
    /// derivative dB/db = π − (S/μ) B. π is the pressure that the ground at b would have in contact. S is the force
    /// at b per unit settlement of the ground at b, and μ is the stiffness of the shear layer.
    fn force_at_right(&self, span: &OpenSpan, point: BeamPoint) -> [f64; 2] {
        let trial = OpenSpan { right: Some(point), ..*span };
        let [psi, slope, pressure] = self.w.obstacle_and_pressure(point);
        let other = span.left.map_or(0.0, |a| self.w.obstacle_at(a));
        let [_, shear] = self.w.mesh.cells[point.cell].ground_at(point.s);
        let link = self.link(&trial);
        let force = match self.short(&trial) {
            Some([_, force]) => force,
            None => link.force_right(other, psi) - shear * slope,
        };
        [force, pressure - (link.shunt_right + link.series) / shear * force]
    }

    /// Returns the concentrated contact forces at the left and the right end of a short span of ground out of
    /// contact. Returns `None` if the span is not short, or if differences of the slopes of beam and ground surface
    /// give more accurate forces.
    fn short(&self, span: &OpenSpan) -> Option<[f64; 2]> {
        short_span::end_forces(self.w, [span.left, span.right])
    }

    /// Moves the left end of the span to the left until the force at this end is not tensile.
    fn trim_left(&self, span: &mut OpenSpan, limit: BeamPoint) {
        let Some(mut point) = span.left else { return };
        if point == limit || self.force_at_left(span, point)[0] >= 0.0 {
            return;
        }
        loop {
            let start = if point.cell == limit.cell { limit.s } else { -1.0 };
            let low = BeamPoint { cell: point.cell, s: start };
            if self.force_at_left(span, low)[0] >= 0.0 {
                let force = |s: f64| self.force_at_left(span, BeamPoint { cell: point.cell, s });
                point.s = self.tangent(point.cell, [start, point.s], force, -1.0);
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
            span.left = Some(point);
        }
        span.left = Some(point);
    }

    /// Moves the right end of the span to the right until the force at this end is not tensile.
    fn trim_right(&self, span: &mut OpenSpan, limit: BeamPoint) {
        let Some(mut point) = span.right else { return };
        if point == limit || self.force_at_right(span, point)[0] >= 0.0 {
            return;
        }
        loop {
            let end = if point.cell == limit.cell { limit.s } else { 1.0 };
            let high = BeamPoint { cell: point.cell, s: end };
            if self.force_at_right(span, high)[0] >= 0.0 {
                let force = |s: f64| self.force_at_right(span, BeamPoint { cell: point.cell, s });
                point.s = self.tangent(point.cell, [point.s, end], force, 1.0);
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
            span.right = Some(point);
        }
        span.right = Some(point);
    }

    /// Finds the position at which a concentrated force changes sign in the given `sense`, between two points of one
    /// cell. Newton's method is used. It is replaced by bisection if a step leaves the bracket or does not halve the
    /// force.
    fn tangent(
        &self,
        cell: usize,
        [mut low, mut high]: [f64; 2],
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
            let [f, slope] = force(s);
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
