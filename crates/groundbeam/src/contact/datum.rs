//! Solves the contact problem relative to a rigid translation of the beam, so that small deformations keep their digits.
//!
//! The stiffness matrix of some elements multiplies differences of end deflections. If the translation of the beam is
//! large compared with these differences, they lose digits. The contact problem for the deflection w − δ is the contact
//! problem of a model whose initial gap and support settlements are smaller by δ. Its deflections have no large
//! translation if δ is close to the deflection of the beam.

use crate::cancel::Cancel;
use crate::contact::bonded::Bonded;
use crate::contact::edges::{Start, edges};
use crate::contact::intervals::positions;
use crate::contact::state::{ContactState, Unconverged};
use crate::contact::stopping::FEW_STEPS;
use crate::mesh::mesh::Mesh;
use crate::model::{GapPoint, Model};
use crate::numeric::polynomial::{TERMS, value};

/// Solves the contact problem relative to the mean deflection of the beam ends in `found`, from the contact set of
/// `found`. `judge` computes the relative energy gap of a deflection of the given model.
pub(crate) fn solve(
    model: &Model,
    found: &ContactState,
    cancel: &Cancel,
    judge: &mut dyn FnMut(&ContactState) -> f64,
) -> Result<ContactState, Unconverged> {
    let w = found.deflection();
    let last = found.mesh.cells.len() - 1;
    let datum = 0.5 * (value(w.cell(0), -1.0) + value(w.cell(last), 1.0));
    let raised = raised(model, datum);
    let back = |state: ContactState| lowered(model, state, datum);
    let start = Start::on(positions(&found.mesh, &found.zones, &[]));
    let mut judge_back = |state: &ContactState| judge(&back(state.clone()));
    edges(&mut Bonded::new(&raised, cancel), start, FEW_STEPS, &mut judge_back).map(back)
}

/// Returns the model whose deflection is the deflection of `model` minus `datum`.
fn raised(model: &Model, datum: f64) -> Model {
    let mut raised = model.clone();
    if raised.gap.is_empty() {
        raised.gap.push(GapPoint { at: 0.0, value: 0.0 });
    }
    raised.gap.iter_mut().for_each(|corner| corner.value -= datum);
    raised.supports.iter_mut().for_each(|support| support.settlement -= datum);
    raised
}

/// Converts a contact state of the raised model to the contact state of `model`.
fn lowered(model: &Model, mut state: ContactState, datum: f64) -> ContactState {
    let x: Vec<f64> = state.mesh.nodes.iter().map(|node| node.x).collect();
    state.mesh = Mesh::build(model, &x, |_| 1);
    state.coefficients.iter_mut().step_by(TERMS).for_each(|constant| *constant += datum);
    state
}
