//! Solves the contact problem of a substitute model if rounding errors spoil the solution of the given model.
//!
//! Two substitutes are tried:
//!
//! * The beam translated by −δ, so that its initial gap and its support settlements are smaller by δ. The stiffness
//!   matrix of some elements multiplies differences of end deflections. These differences lose digits if the translation
//!   δ of the beam is large compared with them.
//! * The beam without shear deformation. If the shear stiffness S is extremely large, the shear strain w' − φ is below
//!   the rounding error of the slope w', and the shear force S(w' − φ) has no digits.

use crate::cancel::Cancel;
use crate::contact::bonded::Bonded;
use crate::contact::edges::{Start, edges};
use crate::contact::intervals::positions;
use crate::contact::state::{ContactState, turned};
use crate::contact::stopping::FEW_STEPS;
use crate::mesh::mesh::Mesh;
use crate::model::{GapPoint, Model};
use crate::numeric::polynomial::{TERMS, value};
use crate::numeric::tolerance::GAP;

/// Solves the substitute models, starting from the contact set of `found`. Returns the first solution whose relative
/// energy gap as a solution of the given model is small enough. `judge` computes this gap.
pub(crate) fn solve(
    model: &Model,
    found: &ContactState,
    cancel: &Cancel,
    judge: &mut dyn FnMut(&ContactState) -> f64,
) -> Option<ContactState> {
    let contact = positions(&found.mesh, &found.zones, &[]);
    let translation = mean_of_ends(found);
    let translated = (translated(model, translation), translation);
    let rigid_in_shear = model.beam.shears().then(|| (without_shear(model), 0.0));
    for (substitute, translation) in [Some(translated), rigid_in_shear].into_iter().flatten() {
        let back = |state: ContactState| restored(model, state, translation);
        let mut judge_back = |state: &ContactState| judge(&back(state.clone()));
        let bonded = &mut Bonded::new(&substitute, cancel);
        let solved = edges(bonded, Start::on(contact.clone()), FEW_STEPS, &mut judge_back);
        if let Ok(state) = solved.map(back)
            && judge(&state) <= GAP
        {
            return Some(state);
        }
    }
    None
}

/// Mean deflection of the two ends of the beam.
fn mean_of_ends(found: &ContactState) -> f64 {
    let w = found.deflection();
    let last = found.mesh.cells.len() - 1;
    0.5 * (value(w.cell(0), -1.0) + value(w.cell(last), 1.0))
}

/// Returns the model whose deflection is the deflection of `model` minus `translation`.
fn translated(model: &Model, translation: f64) -> Model {
    let mut translated = model.clone();
    if translated.gap.is_empty() {
        translated.gap.push(GapPoint { at: 0.0, value: 0.0 });
    }
    translated.gap.iter_mut().for_each(|corner| corner.value -= translation);
    translated.supports.iter_mut().for_each(|support| support.settlement -= translation);
    translated
}

fn without_shear(model: &Model) -> Model {
    let mut rigid = model.clone();
    rigid.beam.shear_stiffness = None;
    rigid.beam.segments.iter_mut().for_each(|segment| segment.shear_stiffness = None);
    rigid
}

/// Converts a contact state of a substitute model to a contact state of `model`.
fn restored(model: &Model, mut state: ContactState, translation: f64) -> ContactState {
    let x: Vec<f64> = state.mesh.nodes.iter().map(|node| node.x).collect();
    state.mesh = Mesh::build(model, &x, |_| 1);
    state.coefficients.iter_mut().step_by(TERMS).for_each(|constant| *constant += translation);
    if model.beam.shears() && state.rotation.is_empty() {
        let cells = state.mesh.cells.iter().zip(state.coefficients.chunks(TERMS));
        let rotation = cells.flat_map(|(cell, w)| turned(cell, w).at_least(TERMS).to_vec());
        state.rotation = rotation.collect();
    }
    state
}
