//! A sequence of meshes: the contact set of each is the initial guess of the next finer one.
//!
//! Newton's method finds the contact in a few steps where every wave of the beam on its ground is a few
//! elements long or longer than the beam. On a fine mesh under a long soft beam it would start from a
//! bonded beam with hundreds of waves, each of which lifts off and is lost again; on a mesh too coarse
//! for the waves its elements are no beam at all. So the coarse meshes carry a beam just stiff enough for
//! them, and every mesh starts from the deflection on the one before.

use crate::cancel::Cancel;
use crate::contact::active_set;
use crate::contact::state::{ContactState, Unconverged};
use crate::contact::stopping::COARSE_CLOSE;
use crate::element::operator::{Operator, ZoneKind};
use crate::mesh::cell::Cell;
use crate::mesh::mesh::Mesh;
use crate::model::Model;
use crate::numeric::elementary::log2;
use crate::numeric::tolerance::ENERGY;
use crate::options::Pressure;

/// The most cells between two nodes of the model, for one cell per wave length.
const MOST_COARSE: f64 = 64.0;
/// How much stiffness (as a power of two) is taken back from one stage to the next.
const DOUBLINGS_PER_STAGE: f64 = 4.0;

/// Meshes from two cells between nodes of the model, doubled until each interval has `per_wave` of them to
/// a wave length.
pub(crate) fn coarse_meshes(model: &Model, per_wave: f64) -> impl Iterator<Item = Mesh> + '_ {
    let axial = model.beam.axial_force;
    let wanted = move |cell: &Cell| {
        let wave = Operator::of(cell, axial, ZoneKind::Contact).wave_number();
        let cells = (wave * cell.length() * per_wave).ceil();
        (cells.clamp(2.0, MOST_COARSE * per_wave) as usize).next_power_of_two()
    };
    let most = Mesh::build(model, &[], |_| 1).cells.iter().map(wanted).max().unwrap_or(2);
    (1..=most.trailing_zeros()).map(move |i| {
        let mut mesh = Mesh::build(model, &[], |cell| wanted(cell).min(1 << i));
        mesh.stiffen();
        mesh
    })
}

/// Solves on a given mesh, starting from coarser ones. If the mesh is too coarse for the beam's waves, it starts from a
/// stiffer beam.
pub(crate) fn solve_on(
    model: &Model,
    mesh: Mesh,
    pressure: Pressure,
    cancel: &Cancel,
) -> Result<ContactState, Unconverged> {
    let stages = (log2(mesh.stiffening()) / DOUBLINGS_PER_STAGE).ceil() as u32;
    let part = |i: u32| f64::from(i) / f64::from(stages);
    let count = mesh.cells.len();
    let coarser = coarse_meshes(model, 1.0).take_while(|coarse| coarse.cells.len() < count);
    let stiffened = (0..stages).map(|i| mesh.stiffened(part(i)));
    solve(coarser.chain(stiffened).chain([mesh.clone()]), pressure, cancel)
}

/// Solves on the last of some meshes, each of which gives the next one its start.
pub(crate) fn solve(
    meshes: impl Iterator<Item = Mesh>,
    pressure: Pressure,
    cancel: &Cancel,
) -> Result<ContactState, Unconverged> {
    let mut meshes = meshes.peekable();
    let mut found: Option<ContactState> = None;
    let mut history = Vec::new();
    while let Some(mesh) = meshes.next() {
        let close = if meshes.peek().is_some() { COARSE_CLOSE } else { ENERGY };
        match active_set::solve(mesh, pressure, found.as_ref(), close, cancel) {
            Ok(mut next) => {
                history.append(&mut next.history);
                found = Some(next);
            }
            // The finer mesh begins on its own.
            Err(stalled) if meshes.peek().is_none() || cancel.is_cancelled() => {
                return Err(stalled);
            }
            Err(_) => found = None,
        }
    }
    found.map(|found| ContactState { history, ..found }).ok_or(Unconverged::SINGULAR)
}
