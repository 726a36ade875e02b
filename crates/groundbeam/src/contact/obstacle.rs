//! The ground under a given beam: where it touches. (2.10) for a fixed w.
//!
//! Under a fixed ψ = w − g₀ the ground's surface is the least u ≥ ψ with −(μu')' + ku ≥ 0: the least
//! majorant of ψ among the solutions of −(μu')' + ku = 0, exactly as a convex hull is the least
//! majorant among straight lines. It is found as convex hulls are, by one scan from left to right.
//!
//! * Only where π = kψ − (μψ')' ≥ 0 can beam and ground touch along a stretch. These *arcs* are found
//!   by isolating the sign changes of the polynomial π; nothing is sampled.
//! * The scan keeps the arcs of the part already seen that its majorant touches, and the part of each
//!   that it touches. A new arc is joined to the last one by the unloaded ground tangent to both. A
//!   joint trims both arcs; an arc that is left with a pull is dropped and the joint made anew.
//! * At the joint's ends a and b the concentrated forces A = μψ'(a) − μu'(a) and B = μu'(b) − μψ'(b)
//!   vanish. There dA/da = −π(a) and dB/db = π(b), and neither depends on the other end to first order:
//!   Newton's method on each in turn converges quadratically on both.
//!
//! Every arc is trimmed from its ends only and every cell passed over once: the scan is O(n).

use crate::contact::short_span;
use crate::ground::link::TwoPort;
use crate::mesh::deflection::{BeamPoint, Deflection, MeshZone};
use crate::mesh::ground_runs::{GroundRun, ground_runs};
use crate::mesh::mesh::Mesh;
use crate::mesh::open_ground::cell_part;
use crate::numeric::polynomial::value;
use crate::numeric::roots::sign_changes;

/// The stretches of contact, from left to right.
pub(crate) fn contact(w: &Deflection) -> Vec<MeshZone> {
    let mut zones = Vec::new();
    for piece in ground_runs(w.mesh) {
        if piece.pasternak {
            zones.extend(Scan::new(w, &piece).run().into_iter().filter(|zone| !w.is_held(zone)));
        } else {
            zones.extend(winkler_contact(w, &piece));
        }
    }
    zones
}

/// The nodes that touch if only nodes can: the paper's pressures (5.5). They need a shear layer.
pub(crate) fn nodal_contact(w: &Deflection) -> Vec<MeshZone> {
    let mut zones = Vec::new();
    for piece in ground_runs(w.mesh) {
        if piece.pasternak {
            zones.extend(Scan::new(w, &piece).hull(nodes_of(&piece)));
        }
    }
    zones
}

/// Contact everywhere: along the whole beam, or at each node.
pub(crate) fn everywhere(mesh: &Mesh, nodal: bool) -> Vec<MeshZone> {
    let pieces = ground_runs(mesh);
    if nodal {
        return pieces.iter().flat_map(nodes_of).collect();
    }
    let whole = |piece: &GroundRun| MeshZone {
        from: BeamPoint { cell: piece.cells.start, s: -1.0 },
        to: BeamPoint { cell: piece.cells.end - 1, s: 1.0 },
    };
    pieces.iter().map(whole).collect()
}

/// Every node of a piece as a point of its own.
fn nodes_of(piece: &GroundRun) -> impl Iterator<Item = MeshZone> + use<> {
    let last = point(BeamPoint { cell: piece.cells.end - 1, s: 1.0 });
    piece.cells.clone().map(|cell| point(BeamPoint { cell, s: -1.0 })).chain([last])
}

/// Without a shear layer, contact is where ψ ≥ 0.
fn winkler_contact(w: &Deflection, piece: &GroundRun) -> Vec<MeshZone> {
    let mut zones: Vec<MeshZone> = Vec::new();
    let mut knots = Vec::new();
    for cell in piece.cells.clone() {
        let obstacle = w.obstacle(cell);
        for part in positive_parts(&obstacle, &mut knots) {
            join(&mut zones, cell, part, true);
        }
    }
    zones
}

/// The intervals of \[−1, 1\] on which a polynomial is not negative; `knots` is room for their ends.
fn positive_parts<'a>(
    c: &'a [f64],
    knots: &'a mut Vec<f64>,
) -> impl Iterator<Item = [f64; 2]> + 'a {
    knots.clear();
    knots.push(-1.0);
    sign_changes(c, knots);
    knots.push(1.0);
    let parts = knots.windows(2).map(|k| [k[0], k[1]]);
    parts.filter(|[a, b]| b > a && value(c, 0.5 * (a + b)) >= 0.0)
}

/// Appends a part of a cell to the last zone if the two meet and may be one.
fn join(zones: &mut Vec<MeshZone>, cell: usize, [from, to]: [f64; 2], may_join: bool) {
    if let Some(last) = zones.last_mut() {
        let meets = last.to.cell + 1 == cell && last.to.s == 1.0 && from == -1.0;
        if meets && may_join {
            last.to = BeamPoint { cell, s: to };
            return;
        }
    }
    zones.push(MeshZone { from: BeamPoint { cell, s: from }, to: BeamPoint { cell, s: to } });
}

/// Open ground between two spots; a missing one is the ground beyond the piece.
#[derive(Debug, Clone, Copy)]
struct OpenSpan {
    left: Option<BeamPoint>,
    right: Option<BeamPoint>,
    /// The whole cells strictly between, and the ground beyond where a spot is missing.
    middle: Option<TwoPort>,
}

/// A zone with the joint to its left.
#[derive(Debug, Clone, Copy)]
struct KeptZone {
    zone: MeshZone,
    joint: OpenSpan,
}

struct Scan<'a> {
    w: &'a Deflection<'a>,
    piece: &'a GroundRun,
}

impl<'a> Scan<'a> {
    fn new(w: &'a Deflection<'a>, piece: &'a GroundRun) -> Self {
        Scan { w, piece }
    }

    fn run(&self) -> Vec<MeshZone> {
        self.hull(self.arcs().into_iter())
    }

    fn hull(&self, arcs: impl Iterator<Item = MeshZone>) -> Vec<MeshZone> {
        let mut stack: Vec<KeptZone> = Vec::new();
        for arc in arcs {
            let mut new = arc;
            let start = arc.from.cell;
            let mut joint = match stack.last() {
                Some(last) => OpenSpan {
                    left: Some(last.zone.to),
                    right: Some(new.from),
                    middle: self.whole_cells(last.zone.to.cell + 1, start, None),
                },
                None => self.beyond_to(new.from),
            };
            loop {
                let Some(last) = stack.last() else {
                    self.trim_right(&mut joint, new.to);
                    break;
                };
                self.tighten(&mut joint, last.zone.from, new.to);
                if !self.drops_last(&mut stack, &mut joint) {
                    break;
                }
            }
            if let Some(from) = joint.right {
                new.from = from;
            }
            stack.push(KeptZone { zone: new, joint });
        }
        self.close(&mut stack);
        stack.into_iter().map(|held| held.zone).collect()
    }

    /// Ends the last zone where the joint begins; if a pull is all that is left of it, drops it and lets the
    /// joint run on to the one before.
    fn drops_last(&self, stack: &mut Vec<KeptZone>, joint: &mut OpenSpan) -> bool {
        let (Some(last), Some(touch)) = (stack.last_mut(), joint.left) else { return false };
        last.zone.to = touch;
        let dropped = touch == last.zone.from && self.pull(&last.joint, joint) <= 0.0;
        if dropped {
            *joint = self.merged(&last.joint, &last.zone, joint);
            stack.pop();
        }
        dropped
    }

    /// The ground beyond the right end trims the last zones.
    fn close(&self, stack: &mut Vec<KeptZone>) {
        let end = self.piece.cells.end;
        let Some(last) = stack.last() else { return };
        let beyond = TwoPort { coupling: 0.0, leak_left: self.piece.beyond[1], leak_right: 0.0 };
        let mut joint = OpenSpan {
            left: Some(last.zone.to),
            right: None,
            middle: Some(match self.whole_cells(last.zone.to.cell + 1, end, None) {
                Some(cells) => cells.then(beyond),
                None => beyond,
            }),
        };
        while let Some(last) = stack.last() {
            self.trim_left(&mut joint, last.zone.from);
            if !self.drops_last(stack, &mut joint) {
                break;
            }
        }
    }

    /// Where π ≥ 0, joined over cells unless a corner of ψ opens the ground; and single points that may
    /// carry a force: the ends of the shear layer and corners that press into the ground.
    fn arcs(&self) -> Vec<MeshZone> {
        let cells = self.piece.cells.clone();
        let mut arcs: Vec<MeshZone> = Vec::new();
        let mut knots = Vec::new();
        for i in cells.clone() {
            let corner = if i == cells.start { 1.0 } else { self.w.corner(i) };
            let pressure = self.w.pressure(i);
            let mut parts = positive_parts(&pressure, &mut knots).peekable();
            let starts_here = parts.peek().is_some_and(|part| part[0] == -1.0);
            let ended_here =
                arcs.last().is_some_and(|a| a.to == BeamPoint { cell: i.wrapping_sub(1), s: 1.0 });
            if corner > 0.0 && !starts_here && !ended_here {
                arcs.push(point(BeamPoint { cell: i, s: -1.0 }));
            }
            for part in parts {
                join(&mut arcs, i, part, corner >= 0.0);
            }
        }
        let end = BeamPoint { cell: cells.end - 1, s: 1.0 };
        if arcs.last().is_none_or(|arc| arc.to != end) {
            arcs.push(point(end));
        }
        arcs
    }

    fn whole_cells(&self, from: usize, to: usize, before: Option<TwoPort>) -> Option<TwoPort> {
        whole_cells(self.w.mesh, from, to, before)
    }

    fn beyond_to(&self, to: BeamPoint) -> OpenSpan {
        let beyond = TwoPort { coupling: 0.0, leak_left: 0.0, leak_right: self.piece.beyond[0] };
        let middle = self.whole_cells(self.piece.cells.start, to.cell, Some(beyond));
        OpenSpan { left: None, right: Some(to), middle }
    }

    fn link(&self, joint: &OpenSpan) -> TwoPort {
        let part = |i: usize, from: f64, to: f64| cell_part(&self.w.mesh.cells[i], from, to);
        if let (Some(a), Some(b)) = (joint.left, joint.right)
            && a.cell == b.cell
        {
            return part(a.cell, a.s, b.s);
        }
        let head = joint.left.filter(|a| a.s < 1.0).map(|a| part(a.cell, a.s, 1.0));
        let tail = joint.right.filter(|b| b.s > -1.0).map(|b| part(b.cell, -1.0, b.s));
        let parts = [head, joint.middle, tail];
        let whole = parts.into_iter().flatten().reduce(TwoPort::then);
        // Spots that meet at a node: a joint of no length never arises between two arcs that can be
        // held apart; a stiff one stands for it.
        whole.unwrap_or(TwoPort { coupling: f64::MAX, leak_left: 0.0, leak_right: 0.0 })
    }

    /// What a single point between two joints presses; not positive where the ground would have to pull.
    fn pull(&self, before: &OpenSpan, after: &OpenSpan) -> f64 {
        let fluxes = |joint: &OpenSpan| {
            short_span::fluxes(self.w, [joint.left, joint.right], &self.link(joint))
        };
        fluxes(before)[1] + fluxes(after)[0]
    }

    /// One joint over a dropped zone.
    fn merged(&self, before: &OpenSpan, zone: &MeshZone, after: &OpenSpan) -> OpenSpan {
        let first = before.left.map_or(self.piece.cells.start, |a| a.cell + 1);
        let last = after.right.map_or(self.piece.cells.end, |b| b.cell);
        let from = zone.from.cell.max(first);
        let to = (zone.to.cell + 1).min(last);
        let inner = self.whole_cells(from, to, before.middle);
        OpenSpan { left: before.left, right: after.right, middle: chained(inner, after.middle) }
    }

    /// Trims both ends in turn until neither moves.
    fn tighten(&self, joint: &mut OpenSpan, left_limit: BeamPoint, right_limit: BeamPoint) {
        let opened =
            joint.left.zip(joint.right).and_then(|(a, b)| short_span::opened(self.w, [a, b]));
        if let Some([a, b]) = opened
            && left_limit < a
            && b < right_limit
        {
            (joint.left, joint.right) = (Some(a), Some(b));
        }
        for _ in 0..60 {
            let before = (joint.left, joint.right);
            self.trim_left(joint, left_limit);
            self.trim_right(joint, right_limit);
            if before == (joint.left, joint.right) {
                break;
            }
        }
    }

    /// The concentrated force at the joint's left end, which ends a stretch of contact, and its slope
    /// dA/da = −π + (S/μ) A, where S is the stiffness of the open ground seen from there.
    fn force_at_left(&self, joint: &OpenSpan, spot: BeamPoint) -> [f64; 2] {
        let trial = OpenSpan { left: Some(spot), ..*joint };
        let [psi, slope, pressure] = self.w.pressing(spot);
        let other = joint.right.map_or(0.0, |b| self.w.obstacle_at(b));
        let [_, shear] = self.w.mesh.cells[spot.cell].ground_at(spot.s);
        let link = self.link(&trial);
        let force = match self.narrow(&trial) {
            Some([force, _]) => force,
            None => shear * slope + link.force_left(psi, other),
        };
        [force, (link.leak_left + link.coupling) / shear * force - pressure]
    }

    /// The same at its right end, dB/db = π − (S/μ) B.
    fn force_at_right(&self, joint: &OpenSpan, spot: BeamPoint) -> [f64; 2] {
        let trial = OpenSpan { right: Some(spot), ..*joint };
        let [psi, slope, pressure] = self.w.pressing(spot);
        let other = joint.left.map_or(0.0, |a| self.w.obstacle_at(a));
        let [_, shear] = self.w.mesh.cells[spot.cell].ground_at(spot.s);
        let link = self.link(&trial);
        let force = match self.narrow(&trial) {
            Some([_, force]) => force,
            None => link.force_right(other, psi) - shear * slope,
        };
        [force, pressure - (link.leak_right + link.coupling) / shear * force]
    }

    /// The forces at both ends of a narrow joint.
    fn narrow(&self, joint: &OpenSpan) -> Option<[f64; 2]> {
        short_span::end_forces(self.w, [joint.left, joint.right])
    }

    /// Moves the joint's left end to the left until nothing pulls there.
    fn trim_left(&self, joint: &mut OpenSpan, limit: BeamPoint) {
        let Some(mut spot) = joint.left else { return };
        if spot == limit || self.force_at_left(joint, spot)[0] >= 0.0 {
            return;
        }
        loop {
            let start = if spot.cell == limit.cell { limit.s } else { -1.0 };
            let low = BeamPoint { cell: spot.cell, s: start };
            if self.force_at_left(joint, low)[0] >= 0.0 {
                let force = |s: f64| self.force_at_left(joint, BeamPoint { cell: spot.cell, s });
                spot.s = self.tangent(spot.cell, [start, spot.s], force, -1.0);
                break;
            }
            if spot.cell == limit.cell {
                spot = limit;
                break;
            }
            // The whole cell opens; it lies between the spots unless the right one is in it.
            if joint.right.is_none_or(|b| b.cell != spot.cell) {
                let opened = self.whole_cells(spot.cell, spot.cell + 1, None);
                joint.middle = chained(opened, joint.middle);
            }
            spot = BeamPoint { cell: spot.cell - 1, s: 1.0 };
            joint.left = Some(spot);
        }
        joint.left = Some(spot);
    }

    /// Moves the joint's right end to the right until nothing pulls there.
    fn trim_right(&self, joint: &mut OpenSpan, limit: BeamPoint) {
        let Some(mut spot) = joint.right else { return };
        if spot == limit || self.force_at_right(joint, spot)[0] >= 0.0 {
            return;
        }
        loop {
            let end = if spot.cell == limit.cell { limit.s } else { 1.0 };
            let high = BeamPoint { cell: spot.cell, s: end };
            if self.force_at_right(joint, high)[0] >= 0.0 {
                let force = |s: f64| self.force_at_right(joint, BeamPoint { cell: spot.cell, s });
                spot.s = self.tangent(spot.cell, [spot.s, end], force, 1.0);
                break;
            }
            if spot.cell == limit.cell {
                spot = limit;
                break;
            }
            if joint.left.is_none_or(|a| a.cell != spot.cell) {
                joint.middle = self.whole_cells(spot.cell, spot.cell + 1, joint.middle);
            }
            spot = BeamPoint { cell: spot.cell + 1, s: -1.0 };
            joint.right = Some(spot);
        }
        joint.right = Some(spot);
    }

    /// The root of a concentrated force between two spots of one cell, where it changes sign in the given
    /// `sense`: Newton's method, halving where it leaves the bracket or does not halve the force.
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
        // Twice the halvings that a double has.
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
            let good = f.abs() < 0.5 * before && newton > low && newton < high;
            let next = if good { newton } else { 0.5 * (low + high) };
            before = f.abs();
            // At a corner the force jumps: to its side without a pull.
            if high - low <= 2.0 * f64::EPSILON {
                return if sense > 0.0 { high } else { low };
            }
            if (next - s).abs() <= 2.0 * f64::EPSILON {
                return next;
            }
            s = next;
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

fn point(spot: BeamPoint) -> MeshZone {
    MeshZone { from: spot, to: spot }
}

/// `before`, then the whole cells of a range. Runs of equal ground are one link.
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
        let run = if cell.ground_varies() { cell_part(cell, -1.0, 1.0) } else { uniform() };
        link = Some(link.map_or(run, |link| link.then(run)));
        i = end;
    }
    link
}
