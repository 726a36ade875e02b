//! Stretches of contact near the right ones, found without an iteration on edges.

use crate::cancel::Cancel;
use crate::element::operator::wave_number;
use crate::model::{FoundationSegment, Model};

/// How long a beam may be, in units of 1/wave number, that needs no mesh to start from.
const SHORT: f64 = 24.0;

/// All of a short beam, what the nodes of a mesh tell of a long one; none if they tell nothing. Beams on
/// supports may leave stretches with hardly a pressure: they go the long way.
pub(crate) fn edges(model: &Model, cancel: &Cancel) -> Option<Vec<[f64; 2]>> {
    if !model.supports.is_empty() {
        return None;
    }
    if is_short(model) {
        Some(vec![[0.0, model.beam.length]])
    } else {
        crate::nodal::edges::edges(model, cancel)
    }
}

/// Whether a beam is so short that no zone of contact lies far from another.
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
