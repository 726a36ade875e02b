//! Computes the contact zones on ground without a shear layer, and the intervals on which a polynomial is not negative.

use crate::contact::stopping::ULPS;
use crate::contact::surface::SurfacePart;
use crate::mesh::deflection::{BeamPoint, Deflection, MeshZone};
use crate::mesh::ground_runs::GroundRun;
use crate::numeric::polynomial::{Coefficients, divided, value};
use crate::numeric::roots::sign_changes;

/// Computes the contact zones on ground without a shear layer: the intervals with w − g₀ − u₀ ≥ 0, where w is the
/// deflection, g₀ the initial gap and u₀ the free-field settlement.
pub(super) fn winkler_contact(w: &Deflection, run: &GroundRun) -> Vec<MeshZone> {
    let mut zones: Vec<MeshZone> = Vec::new();
    let mut knots = Vec::new();
    for cell in run.cells.clone() {
        for part in positive_parts(&signed(w, cell), &mut knots) {
            join(&mut zones, cell, part, true);
        }
    }
    zones
}

/// Divides a cell on Winkler ground into its parts in contact and out of contact.
pub(super) fn cover(w: &Deflection, cell: usize, parts: &mut Vec<SurfacePart>) {
    let mut knots = Vec::new();
    let mut from = -1.0;
    for [a, b] in positive_parts(&signed(w, cell), &mut knots) {
        if from < a {
            parts.push(SurfacePart { cell, s: [from, a], open: Some([0.0; 2]) });
        }
        parts.push(SurfacePart { cell, s: [a, b], open: None });
        from = b;
    }
    if from < 1.0 {
        parts.push(SurfacePart { cell, s: [from, 1.0], open: Some([0.0; 2]) });
    }
}

/// Returns a polynomial with the sign of the obstacle in a cell, or 0 if the obstacle is rounding error. Zeros at rigid
/// supports are divided out, because rounding error could move them into the cell.
fn signed(w: &Deflection, cell: usize) -> Coefficients {
    if is_rounding_error(w, cell) {
        return Coefficients::zeros(1);
    }
    let mut obstacle = w.obstacle(cell);
    for (s, count) in [-1.0, 1.0].into_iter().zip(w.held_zeros(cell)) {
        for _ in 0..count {
            obstacle = divided(&obstacle, s);
            if s > 0.0 {
                obstacle.iter_mut().for_each(|c| *c = -*c);
            }
        }
    }
    obstacle
}

/// Whether the obstacle is rounding error, but not zero, on a whole cell. Sign changes of rounding error would be false
/// contact edges. See *Contact without pressure* in `docs/methods.md`.
pub(super) fn is_rounding_error(w: &Deflection, cell: usize) -> bool {
    let size = |c: &[f64]| c.iter().map(|c| c.abs()).sum::<f64>();
    let obstacle = size(&w.obstacle(cell));
    0.0 < obstacle && obstacle <= ULPS * f64::EPSILON * size(w.cell(cell))
}

/// Whether a zone lies in one cell, and ψ is only rounding error at its ends and in its middle. Its contact force is then
/// below the rounding error of the contact forces.
pub(super) fn zone_is_rounding_error(w: &Deflection, zone: &MeshZone) -> bool {
    let cell = zone.from.cell;
    if cell != zone.to.cell {
        return false;
    }
    let size: f64 = w.cell(cell).iter().map(|c| c.abs()).sum();
    let points = [zone.from.s, 0.5 * (zone.from.s + zone.to.s), zone.to.s];
    let distances = points.map(|s| w.obstacle_at(BeamPoint { cell, s }).abs());
    distances != [0.0; 3] && distances.iter().all(|d| *d <= ULPS * f64::EPSILON * size)
}

/// The intervals of \[−1, 1\] on which a polynomial is not negative. `knots` is a buffer for their ends.
pub(super) fn positive_parts<'a>(
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

/// Appends a part of a cell to the last zone if the part adjoins this zone and `may_join` is set. Otherwise starts a
/// new zone.
pub(super) fn join(zones: &mut Vec<MeshZone>, cell: usize, [from, to]: [f64; 2], may_join: bool) {
    if let Some(last) = zones.last_mut() {
        let meets = last.to.cell + 1 == cell && last.to.s == 1.0 && from == -1.0;
        if meets && may_join {
            last.to = BeamPoint { cell, s: to };
            return;
        }
    }
    zones.push(MeshZone { from: BeamPoint { cell, s: from }, to: BeamPoint { cell, s: to } });
}
