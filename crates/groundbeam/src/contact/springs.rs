//! Computes the contact zones on ground without a shear layer, and the intervals on which a polynomial is not negative.

use crate::contact::intervals::Interval;
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
        for part in contact_parts(w, cell, &signed(w, cell), &mut knots) {
            join(&mut zones, cell, part, true);
        }
    }
    zones
}

/// Divides a cell on Winkler ground into its parts in contact and out of contact.
pub(super) fn cover(w: &Deflection, cell: usize, parts: &mut Vec<SurfacePart>) {
    let mut knots = Vec::new();
    let mut from = -1.0;
    for [a, b] in contact_parts(w, cell, &signed(w, cell), &mut knots) {
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

/// Returns a polynomial with the sign of the obstacle in a cell. Zeros at rigid supports are divided out, because
/// rounding error could move them into the cell.
fn signed(w: &Deflection, cell: usize) -> Coefficients {
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

/// Returns the parts of a cell on Winkler ground in contact. `signed` has the sign of the obstacle. A part on which the
/// obstacle is rounding error is in contact. See *Contact without pressure* in `docs/methods.md`.
fn contact_parts<'a>(
    w: &'a Deflection,
    cell: usize,
    signed: &'a [f64],
    knots: &'a mut Vec<f64>,
) -> impl Iterator<Item = [f64; 2]> + 'a {
    parts(signed, knots)
        .filter(move |[a, b]| is_positive(signed, [*a, *b]) || is_small(w, cell, [*a, *b]))
}

/// Whether the obstacle is rounding error, but not zero, on a whole cell.
pub(super) fn is_rounding_error(w: &Deflection, cell: usize) -> bool {
    let obstacle = size(&w.obstacle(cell));
    0.0 < obstacle && obstacle <= ULPS * f64::EPSILON * size(w.cell(cell))
}

/// Whether a contact zone lies in one cell, and the obstacle is at most rounding error at its ends and in its middle.
pub(super) fn zone_is_rounding_error(w: &Deflection, [from, to]: Interval) -> bool {
    let i = w.mesh.cell_at(0.5 * (from + to));
    let cell = &w.mesh.cells[i];
    cell.x[0] <= from && to <= cell.x[1] && is_small(w, i, [from, to].map(|x| cell.local(x)))
}

/// Whether the obstacle is at most rounding error at the ends and in the middle of a part of a cell.
fn is_small(w: &Deflection, cell: usize, [from, to]: [f64; 2]) -> bool {
    let error = ULPS * f64::EPSILON * size(w.cell(cell));
    let obstacle = |s: f64| w.obstacle_at(BeamPoint { cell, s });
    [from, 0.5 * (from + to), to].into_iter().all(|s| obstacle(s).abs() <= error)
}

/// Sum of the magnitudes of the coefficients of a polynomial, a bound of its values on \[−1, 1\].
fn size(c: &[f64]) -> f64 {
    c.iter().map(|c| c.abs()).sum()
}

/// The intervals of \[−1, 1\] on which a polynomial is not negative. `knots` is a buffer for their ends.
pub(super) fn positive_parts<'a>(
    c: &'a [f64],
    knots: &'a mut Vec<f64>,
) -> impl Iterator<Item = [f64; 2]> + 'a {
    parts(c, knots).filter(|part| is_positive(c, *part))
}

/// The intervals of \[−1, 1\] between the sign changes of a polynomial. `knots` is a buffer for their ends.
fn parts<'a>(c: &'a [f64], knots: &'a mut Vec<f64>) -> impl Iterator<Item = [f64; 2]> + 'a {
    knots.clear();
    knots.push(-1.0);
    sign_changes(c, knots);
    knots.push(1.0);
    knots.windows(2).map(|k| [k[0], k[1]]).filter(|[a, b]| b > a)
}

/// Whether a polynomial is not negative in the middle of an interval.
fn is_positive(c: &[f64], [from, to]: [f64; 2]) -> bool {
    value(c, 0.5 * (from + to)) >= 0.0
}

/// Appends a part of a cell to the last zone if the part adjoins this zone, in another cell only if `may_join` is set.
/// Otherwise starts a new zone.
pub(super) fn join(zones: &mut Vec<MeshZone>, cell: usize, [from, to]: [f64; 2], may_join: bool) {
    if let Some(last) = zones.last_mut() {
        let crosses = last.to.cell + 1 == cell && last.to.s == 1.0 && from == -1.0;
        let continues = last.to == BeamPoint { cell, s: from };
        if crosses && may_join || continues {
            last.to = BeamPoint { cell, s: to };
            return;
        }
    }
    zones.push(MeshZone { from: BeamPoint { cell, s: from }, to: BeamPoint { cell, s: to } });
}
