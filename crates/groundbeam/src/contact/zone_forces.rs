//! Computes the contact force of each contact interval of a bonded beam from the pressure and the concentrated contact forces.

use crate::contact::edge_step::OpenSpan;
use crate::contact::intervals::Interval;
use crate::mesh::deflection::{Deflection, MeshZone};
use crate::mesh::ground_runs::{GroundRun, ground_runs};

/// Computes the contact force of each interval of `contact` \[N\], positive in compression. All ends of `zones` must
/// be nodes.
pub(crate) fn zone_forces(w: &Deflection, contact: &[Interval], zones: &[MeshZone]) -> Vec<f64> {
    let mut forces = vec![0.0; contact.len()];
    for run in ground_runs(w.mesh) {
        let inside = zones.iter().filter(|zone| run.cells.contains(&zone.from.cell));
        let zones: Vec<MeshZone> = inside.copied().collect();
        for (i, zone) in zones.iter().enumerate() {
            let mut force = spread_force(w, zone);
            if run.pasternak {
                force += force_at_ends(w, &run, &zones, i);
            }
            let middle = 0.5 * (w.position(zone.from) + w.position(zone.to));
            let interval = contact.partition_point(|interval| interval[1] < middle);
            if let Some(sum) = forces.get_mut(interval) {
                *sum += force;
            }
        }
    }
    forces
}

/// Integrates the contact pressure over a zone, and adds the concentrated forces inside it, for example at gap corners.
fn spread_force(w: &Deflection, zone: &MeshZone) -> f64 {
    if zone.from == zone.to {
        return 0.0;
    }
    let cell = |i: usize| {
        let even = w
            .pressure(i)
            .iter()
            .enumerate()
            .step_by(2)
            .map(|(j, c)| c / (j + 1) as f64)
            .sum::<f64>();
        let corner = if i > zone.from.cell { w.corner(i) } else { 0.0 };
        corner + even * w.mesh.cells[i].length()
    };
    (zone.from.cell..=zone.to.cell).map(cell).sum()
}

/// Computes the sum of the concentrated forces at both ends of a zone on a shear layer.
fn force_at_ends(w: &Deflection, run: &GroundRun, zones: &[MeshZone], i: usize) -> f64 {
    let zone = &zones[i];
    let left = i.checked_sub(1).map(|before| zones[before].to);
    let right = zones.get(i + 1).map(|next| next.from);
    let before = OpenSpan::of(w, run, [left, Some(zone.from)]);
    let after = OpenSpan::of(w, run, [Some(zone.to), right]);
    let flux = if zone.from == zone.to { 0.0 } else { w.flux(zone.to) - w.flux(zone.from) };
    before.fluxes[1] + after.fluxes[0] + flux
}
