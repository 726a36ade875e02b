//! Computes the next position of each contact edge by Newton's method from the concentrated force at the edge.
//!
//! An edge in the wrong position carries a concentrated force. A Newton step moves each edge so that its force
//! vanishes. Only the [scan](crate::contact::obstacle) finds zones that split, appear or vanish. See *Near the
//! solution* in `docs/methods.md`.

use super::surface::can_carry;
use crate::contact::intervals::Interval;
use crate::contact::short_span;
use crate::contact::stopping::NEAR_EDGE;
use crate::ground::link::TwoPort;
use crate::mesh::deflection::{BeamPoint, Deflection, MeshZone};
use crate::mesh::ground_runs::{GroundRun, ground_runs};
use crate::mesh::open_ground::open_link;

/// Open ground beside a contact zone, and the concentrated forces on the ground at the two ends of this open ground.
pub(super) struct OpenSpan {
    link: TwoPort,
    pub fluxes: [f64; 2],
    length: f64,
}

impl OpenSpan {
    pub fn of(w: &Deflection, run: &GroundRun, ends: [Option<BeamPoint>; 2]) -> Self {
        let link = open_link(w.mesh, run, ends[0], ends[1]).unwrap_or_default();
        let l = w.mesh.cells[w.mesh.cells.len() - 1].x[1];
        let [from, to] =
            [ends[0].map_or(0.0, |a| w.position(a)), ends[1].map_or(l, |b| w.position(b))];
        OpenSpan { link, fluxes: short_span::bonded_fluxes(w, ends, &link), length: to - from }
    }
}

/// Moves every contact edge by a Newton step. The ends of `zones` must be nodes. Returns `None` if this fails, for
/// example on Winkler ground, for a tensile concentrated force or a long step.
pub(crate) fn next_intervals(w: &Deflection, zones: &[MeshZone]) -> Option<Vec<Interval>> {
    let runs = ground_runs(w.mesh);
    let [run] = runs.as_slice() else { return None };
    if !run.pasternak || zones.is_empty() {
        return None;
    }
    let span = |i: usize| {
        let left = i.checked_sub(1).map(|before| zones[before].to);
        OpenSpan::of(w, run, [left, zones.get(i).map(|next| next.from)])
    };
    let mut after = span(0);
    let interval = |(i, zone): (usize, &MeshZone)| {
        let before = std::mem::replace(&mut after, span(i + 1));
        let interval = [zone.from, zone.to].map(|end| w.position(end));
        if zone.from == zone.to {
            return (before.fluxes[1] + after.fluxes[0] >= 0.0).then_some(interval);
        }
        let forces = [before.fluxes[1] - w.flux(zone.from), after.fluxes[0] + w.flux(zone.to)];
        let stiffness = before.link.shunt_right + before.link.series;
        let outward = outward(w, zone.from, forces[0], stiffness)?;
        let stiffness = after.link.shunt_left + after.link.series;
        let steps = [outward, self::outward(w, zone.to, forces[1], stiffness)?];
        let length = interval[1] - interval[0];
        let small = [&before, &after].map(|span| NEAR_EDGE * length.min(span.length));
        let near = (0..2).all(|i| steps[i] == 0.0 || steps[i].abs() <= small[i]);
        near.then_some([interval[0] - steps[0], interval[1] + steps[1]])
    };
    zones.iter().enumerate().map(interval).collect()
}

/// Returns the outward Newton step of an edge after which its concentrated `force` is zero. The step is 0 where the
/// ground can carry this force ([`can_carry`]). `stiffness` is that of the open ground beside the edge.
fn outward(w: &Deflection, edge: BeamPoint, force: f64, stiffness: f64) -> Option<f64> {
    if can_carry(w.mesh, edge) {
        return (force >= 0.0).then_some(0.0);
    }
    let [_, _, pressure] = w.obstacle_and_pressure(edge);
    let [_, shear] = w.mesh.cells[edge.cell].ground_at(edge.s);
    // `slope` is the decrease of the force per outward move, and `force / shear` the jump in the surface slope at the
    // edge.
    let slope = pressure - stiffness / shear * force;
    (slope > 0.0).then_some(force / slope)
}
