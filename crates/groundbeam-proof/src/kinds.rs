//! Finds the features of a model that the theorem of the proof does not cover.

use crate::model::{Acts, Extent, Model, SupportKind};
use crate::refusal::NotProven;
use crate::scalar::Scalar;

/// Returns the first feature of the model that the theorem in section 1 of docs/proof.md does not cover; `None` if
/// the theorem covers every feature.
pub(crate) fn not_covered<S: Scalar>(model: &Model<S>) -> Option<NotProven> {
    let axial = model.beam.axial_force;
    let point_curvature = model.loads.iter().any(|load| {
        load.action == crate::model::Action::Curvature
            && matches!(load.extent, Extent::Point { .. })
    });
    let turned_in_one_direction = model.supports.iter().any(|support| {
        support.acts != Acts::Both
            && match support.kind {
                SupportKind::Pinned => false,
                SupportKind::Fixed => true,
                SupportKind::Spring { rotational_spring, .. } => rotational_spring != S::zero(),
            }
    });
    let kinds = [
        (!(axial.low() >= 0.0 || axial.high() < 0.0), "an axial force of unknown sign"),
        (turned_in_one_direction, "a one-way support that restrains the slope"),
        (point_curvature, "an imposed curvature at a point"),
    ];
    let (_, kind) = kinds.into_iter().find(|(present, _)| *present)?;
    Some(NotProven::new(format!("not covered: {kind}")))
}
