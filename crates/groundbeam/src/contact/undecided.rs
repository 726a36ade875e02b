//! Tests whether two contact sets that belong to the same deflection differ only by rounding error.
//!
//! On short intervals, the distance between beam and ground can be as small as the rounding error of the deflection.
//! The deflection then does not determine whether beam and ground touch.

use crate::contact::intervals::{Interval, covers, differences, positions};
use crate::contact::state::ContactState;
use crate::contact::stopping::ULPS;
use crate::contact::surface::Surface;
use crate::ground::link::{between, settled};
use crate::mesh::cell::Cell;
use crate::mesh::deflection::{BeamPoint, MeshZone};
use crate::numeric::polynomial::value;

/// Number of equal intervals into which a part of the ground out of contact is divided. The distance between beam
/// and ground is computed at the ends of these intervals.
const INTERVALS: usize = 8;

/// Returns whether two contact sets differ only where the distance between beam and ground is rounding error: the
/// bonded set `contact`, and the set `asked` of its deflection `found`.
pub(crate) fn differ_by_rounding(
    found: &ContactState,
    contact: &[Interval],
    asked: &[MeshZone],
    places: &[f64],
) -> bool {
    let w = found.deflection();
    let differing = differences(&[contact, &positions(&found.mesh, asked, places)]);
    let is_rounding = |zones: &[MeshZone]| {
        let parts = Surface::of(&w, zones).short_parts(&found.mesh);
        let mut open = parts.iter().filter_map(|part| Some((part, part.open?)));
        open.all(|(part, ends)| {
            let cell = &found.mesh.cells[part.cell];
            let [from, to] = part.s;
            let half = 0.25 * (to - from) * cell.length();
            let size: f64 = w.cell(part.cell).iter().map(|c| c.abs()).sum();
            (0..=INTERVALS).all(|i| {
                let t = i as f64 / INTERVALS as f64;
                let s = from + t * (to - from);
                if !covers(&differing, cell.global(s)) {
                    return true;
                }
                let distance = surface_at(cell, half, ends, t)
                    - w.obstacle_at(BeamPoint { cell: part.cell, s });
                distance.abs() <= ULPS * f64::EPSILON * size
            })
        })
    };
    is_rounding(&found.zones) && is_rounding(asked)
}

/// Computes the ground settlement minus the free-field settlement at the relative position `t` in a part of a cell out
/// of contact, with the half length `half` and the values `ends` at its ends.
fn surface_at(cell: &Cell, half: f64, ends: [f64; 2], t: f64) -> f64 {
    if cell.shear_layer == 0.0 {
        return 0.0;
    }
    if cell.ground_varies() {
        let shape = settled(&cell.subgrade_along(), &cell.shear_layer_along(), half, ends);
        return value(&shape, 2.0 * t - 1.0);
    }
    let decay = (cell.subgrade / cell.shear_layer).sqrt();
    between(ends[0], ends[1], 2.0 * half * decay, t)
}
