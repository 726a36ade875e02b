//! Contact at a single corner of the gap: the beam held there with the slope that it has.

use crate::contact::bonded::{Bonded, GivenRotation};
use crate::contact::intervals::Interval;
use crate::contact::state::ContactState;

/// A zone shorter than this, as a part of the length, beside a corner of the gap may be the corner alone.
pub(crate) const NARROW: f64 = 1e-6;

/// The beam on the corner of the gap at which its only, narrow zone begins or ends, held at the slope it has.
pub(crate) fn on_a_corner(
    bonded: &mut Bonded,
    found: &ContactState,
    zones: &[Interval],
) -> Option<ContactState> {
    let [[from, to]] = *zones else { return None };
    let model = bonded.model;
    if to - from > NARROW * model.beam.length {
        return None;
    }
    let corner = model.gap.iter().map(|corner| corner.at).find(|at| *at == from || *at == to)?;
    bonded.solve_on(&[[corner, corner]], Some(GivenRotation::as_in(found))).ok()
}
