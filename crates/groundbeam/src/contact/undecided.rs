//! Whether two contact sets of one deflection differ only by rounding error.
//!
//! Newton's method moves the edges down to rounding error. Where two trial contacts of one deflection then differ, the
//! distance between beam and ground is of the size of the rounding error of the deflection. The deflection does not
//! determine whether they touch.

use crate::contact::intervals::{Interval, covers, differences, positions};
use crate::contact::state::ContactState;
use crate::contact::stopping::ULPS;
use crate::contact::surface::Surface;
use crate::ground::link::{between, settled};
use crate::mesh::cell::Cell;
use crate::mesh::deflection::{BeamPoint, MeshZone};
use crate::numeric::polynomial::value;

/// Number of intervals between the points of an open part at which the distance of beam and ground is computed.
const INTERVALS: usize = 8;

/// Whether the contact of a bonded beam and the contact set `asked` of its deflection differ only by rounding error:
/// where the beam is in contact in only one of them, the distance between beam and ground is rounding error.
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

/// The surface of open ground at the fraction t of an open part of a cell, from its values at both ends.
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
