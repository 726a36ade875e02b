//! Computes the initial guess of the contact zones: the whole length of a short beam, or the active nodes of a nodal solve.

use crate::cancel::Cancel;
use crate::contact::stopping::SHORT;
use crate::element::operator::wave_number;
use crate::model::{FoundationSegment, Model};

/// Returns the initial guess: the whole length of a short beam, or the contact intervals of a nodal solve if it
/// succeeds.
pub(crate) fn edges(model: &Model, cancel: &Cancel) -> Option<Vec<[f64; 2]>> {
    if is_short(model) {
        Some(vec![[0.0, model.beam.length]])
    } else {
        crate::nodal::edges::edges(model, cancel)
    }
}

/// Whether a beam is so short that its contact zones influence each other.
fn is_short(model: &Model) -> bool {
    let largest = |s: &FoundationSegment| (s.subgrade.largest(), s.shear_layer.largest());
    let segments = model.foundation.segments.iter().map(largest);
    let ground = segments.chain([(model.foundation.subgrade, model.foundation.shear_layer)]);
    let beam = model.beam.segments.iter().map(|s| s.bending_stiffness.smallest());
    let softest = beam.fold(model.beam.bending_stiffness, f64::min);
    let waves = |(k, mu): (f64, f64)| {
        wave_number(softest, (model.beam.axial_force + mu).abs(), k) * model.beam.length
    };
    ground.map(waves).all(|waves| waves <= SHORT)
}
