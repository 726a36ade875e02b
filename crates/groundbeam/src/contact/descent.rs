//! Shortens a Newton step of the contact edges by a line search so that the energy does not increase.
//!
//! The step ends where the slope of the convex energy along the step is nearly zero. The slope is computed exactly from
//! polynomials. See section 4 of `docs/methods.md`.

use crate::contact::obstacle;
use crate::contact::state::ContactState;
use crate::contact::stopping::{LEAST_FALL, LEAST_PART};
use crate::mesh::deflection::{BeamPoint, Deflection, MeshZone};
use crate::mesh::energy::{Motion, beam_form, ground_work};
use crate::mesh::mesh::Mesh;
use crate::model::Model;
use crate::numeric::line_search::settle;
use crate::numeric::polynomial::{Coefficients, TERMS, rescale};

/// Result of the line search. The full step leads from the present deflection to the deflection of the beam
/// that is bonded to the ground on the trial contact set.
#[derive(Debug, Clone)]
pub(crate) struct Shortened {
    /// Fraction of the full step.
    pub part: f64,
    /// The contact state after a step that is neither full nor negligible; otherwise `None`.
    pub between: Option<ContactState>,
}

/// Shortens the step from `now` to the deflection `bonded`. `spring_work` is twice the energy of the stabilising
/// springs at `bonded`.
pub(crate) fn shorten(
    model: &Model,
    now: &ContactState,
    bonded: &ContactState,
    spring_work: f64,
) -> Shortened {
    let x: Vec<f64> = [now, bonded].iter().flat_map(|f| f.mesh.nodes.iter().map(|n| n.x)).collect();
    let mesh = Mesh::build(model, &x, |_| 1);
    let [from, to] =
        [now, bonded].map(|found| on(&mesh, found, |i| found.deflection().cell(i).into()));
    let shears = !bonded.rotation.is_empty();
    let turned = |found: &ContactState| {
        if shears { on(&mesh, found, |i| found.rotation(i)) } else { Vec::new() }
    };
    let [turned_from, turned_to] = [now, bonded].map(turned);
    let zones = moved(&mesh, bonded);
    let difference =
        |a: &[f64], b: &[f64]| -> Vec<f64> { a.iter().zip(b).map(|(a, b)| b - a).collect() };
    let delta = difference(&from, &to);
    let turn = difference(&turned_from, &turned_to);
    let form = |deflection: &[f64], rotation: &[f64]| {
        let motion = Motion { deflection, rotation };
        beam_form(&mesh, motion, motion)
    };
    let beam = form(&delta, &turn);
    let fall = beam + ground_work(&mesh, &zones, &delta, &delta) + spring_work;
    let psi = obstacle(&mesh, &to);
    let energy = form(&to, &turned_to) + ground_work(&mesh, &zones, &psi, &psi);
    // `decrement` is Newton's estimate of the remaining decrease of the energy, relative to the strain energy.
    let decrement = if fall == 0.0 { 0.0 } else { fall / energy.abs() };
    let whole = Shortened { part: 1.0, between: None };
    // If the predicted decrease of the energy is only rounding error, the slope of the energy cannot determine
    // the step length. Then the step is not shortened.
    if decrement.is_nan() || decrement <= LEAST_FALL {
        return whole;
    }
    let bonded_work = ground_work(&mesh, &zones, &psi, &delta);
    let along = |from: &[f64], delta: &[f64], t: f64| -> Vec<f64> {
        from.iter().zip(delta).map(|(a, d)| a + t * d).collect()
    };
    let at = |t: f64| along(&from, &delta, t);
    let slope = |t: f64| {
        let w = at(t);
        let zones = obstacle::contact(&Deflection { mesh: &mesh, coefficients: &w });
        let ground = ground_work(&mesh, &zones, &obstacle(&mesh, &w), &delta);
        (ground - bonded_work) - (1.0 - t) * beam - spring_work
    };
    let t = settle(fall, slope);
    if t == 1.0 || t < LEAST_PART {
        return Shortened { part: t, between: None };
    }
    let coefficients = at(t);
    let w = Deflection { mesh: &mesh, coefficients: &coefficients };
    let zones = obstacle::contact(&w);
    let rotation = along(&turned_from, &turn, t);
    Shortened { part: t, between: Some(ContactState::exact(mesh, coefficients, rotation, zones)) }
}

/// Returns the coefficients of a field of `found` on a finer mesh. `own` returns the coefficients of the field in a
/// cell of the mesh of `found`.
fn on(mesh: &Mesh, found: &ContactState, own: impl Fn(usize) -> Coefficients) -> Vec<f64> {
    let mut coefficients = Vec::with_capacity(mesh.cells.len() * TERMS);
    for cell in &mesh.cells {
        let parent = found.mesh.cell_at(0.5 * (cell.x[0] + cell.x[1]));
        let from = &found.mesh.cells[parent];
        let c = if cell.x == from.x {
            own(parent)
        } else {
            let [a, b] = cell.x.map(|x| from.local(x));
            rescale(&own(parent), 0.5 * (a + b), cell.length() / from.length())
        };
        coefficients.extend_from_slice(&c.at_least(TERMS));
    }
    coefficients
}

/// Transfers the contact zones of `found` to the finer mesh `mesh`. The ends of the zones are nodes of both
/// meshes.
fn moved(mesh: &Mesh, found: &ContactState) -> Vec<MeshZone> {
    let last = mesh.cells.len() - 1;
    let point = |point: BeamPoint| {
        let cell = &found.mesh.cells[point.cell];
        // A zone end at the left end of a coarse cell becomes the left end of the fine cell just to the right of it.
        if point.s < 0.0 {
            let inside = cell.x[0] + f64::EPSILON * cell.x[1];
            BeamPoint { cell: mesh.cell_at(inside.min(cell.x[1])), s: -1.0 }
        } else {
            let after = mesh.cells.partition_point(|c| c.x[1] < cell.x[1]).min(last);
            BeamPoint { cell: after, s: 1.0 }
        }
    };
    found.zones.iter().map(|zone| MeshZone { from: point(zone.from), to: point(zone.to) }).collect()
}

/// Returns the polynomial coefficients of the obstacle w − g₀ − u₀ in all cells, with the deflection w, the
/// initial gap g₀ and the free-field settlement u₀.
fn obstacle(mesh: &Mesh, coefficients: &[f64]) -> Vec<f64> {
    let w = Deflection { mesh, coefficients };
    (0..mesh.cells.len()).flat_map(|i| w.obstacle(i).to_vec()).collect()
}
