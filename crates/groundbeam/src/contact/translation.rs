//! Solves the contact problem relative to a rigid translation of the beam, so that small deformations keep their digits.
//!
//! The initial gap and the support settlements become smaller by the translation. See *A large translation* in
//! `docs/methods.md`.

use crate::cancel::Cancel;
use crate::contact::bonded::Bonded;
use crate::contact::edges::{Judge, Start, edges};
use crate::contact::intervals::positions;
use crate::contact::state::ContactState;
use crate::contact::stopping::FEW_STEPS;
use crate::mesh::mesh::Mesh;
use crate::model::{GapPoint, Model};
use crate::numeric::polynomial::TERMS;
use crate::numeric::tolerance::GAP;

/// Solves the contact problem again, relative to the deflection of the shortest cell, because short cells lose most
/// digits.
pub(crate) fn from_solution(
    model: &Model,
    found: &ContactState,
    cancel: &Cancel,
    judge: Judge,
) -> Option<ContactState> {
    let cells = found.mesh.cells.iter().enumerate();
    let shortest = cells.min_by(|(_, a), (_, b)| a.length().total_cmp(&b.length()))?.0;
    let delta = found.deflection().cell(shortest)[0];
    let start = Start::on(positions(&found.mesh, &found.zones, &[]));
    let back = |state: ContactState| translated(model, state, delta);
    let mut judge_back = |state: &ContactState| judge(&back(state.clone()));
    let lowered = lowered(model, delta);
    let solved = edges(&mut Bonded::new(&lowered, cancel), start, FEW_STEPS, &mut judge_back);
    let mut state = back(solved.ok()?);
    state.history.splice(0..0, found.history.iter().copied());
    (judge(&state) <= GAP).then_some(state)
}

/// Returns the model whose deflection is the deflection of `model` minus δ.
fn lowered(model: &Model, delta: f64) -> Model {
    let mut lowered = model.clone();
    if lowered.gap.is_empty() {
        lowered.gap.push(GapPoint { at: 0.0, value: 0.0 });
    }
    lowered.gap.iter_mut().for_each(|corner| corner.value -= delta);
    lowered.supports.iter_mut().for_each(|support| support.settlement -= delta);
    lowered
}

/// Adds δ to the deflection of a contact state. The result is a contact state of `model`.
fn translated(model: &Model, mut state: ContactState, delta: f64) -> ContactState {
    let x: Vec<f64> = state.mesh.nodes.iter().map(|node| node.x).collect();
    state.mesh = Mesh::on(model, &x);
    state.coefficients.iter_mut().step_by(TERMS).for_each(|constant| *constant += delta);
    state
}
