//! Which kinds of model are covered.

use crate::model::{Acts, Course, Extent, Model, SupportKind};
use crate::refusal::NotProven;
use crate::scalar::Scalar;

/// The first feature of a model for which the theorem has not been built in.
pub(crate) fn not_covered<S: Scalar>(model: &Model<S>) -> Option<NotProven> {
    let beam = &model.beam;
    let axial = beam.axial_force;
    let varies = |course: &Course<S>| matches!(course, Course::Varying(_));
    let varying_beam = beam.segments.iter().any(|segment| {
        varies(&segment.bending_stiffness) || segment.shear_stiffness.as_ref().is_some_and(varies)
    });
    let ground = &model.ground.segments;
    let varying_ground = ground.iter().any(|s| varies(&s.spring) || varies(&s.shear));
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
        (varying_beam, "a stiffness that varies within a segment"),
        (varying_ground, "ground that varies within a segment"),
        (turned_in_one_direction, "a support that holds the slope in one direction"),
        (point_curvature, "an imposed curvature at a point"),
    ];
    let (_, kind) = kinds.into_iter().find(|(present, _)| *present)?;
    Some(NotProven::new(format!("not covered: {kind}")))
}
