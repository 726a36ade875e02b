//! Equilibrium of a beam that is balanced on one point and may rotate about it.

use crate::cancel::Cancel;
use crate::contact::bonded::{Bonded, GivenRotation};
use crate::contact::exact::solve;
use crate::contact::intervals::Interval;
use crate::contact::state::{ContactState, Unconverged, edges_not_converged};
use crate::model::{Load, Model};
use crate::numeric::polynomial::value;
use crate::numeric::step::Step;
use crate::numeric::tolerance::GAP;

/// Distance of the resultant from the end in the limit process, relative to the length.
const ALMOST: f64 = 1e-6;

/// Trial rotations beyond the limit, relative to the slope in the limit. The first one for which the beam is clear of
/// the ground is taken.
const BEYOND: [f64; 4] = [0.01, 0.1, 1.0, 10.0];

/// Solves a free beam whose resultant is exactly over one of its ends. Only that end is in contact. As the
/// resultant tends to the end, the rotation tends to a limit at which the beam leaves the ground
/// tangentially. The beam is in equilibrium at every larger rotation. One such rotation is taken.
pub(crate) fn solve_over_an_end(
    model: &Model,
    resultant: f64,
    over_left: bool,
    cancel: &Cancel,
    judge: impl FnMut(&ContactState) -> f64,
) -> Result<ContactState, Unconverged> {
    let l = model.beam.length;
    let inward = if over_left { ALMOST } else { -ALMOST };
    let nearly = model.clone().with_load(Load::point_moment(0.5 * l, inward * resultant * l));
    let limit = solve(&nearly, None, cancel, |_| 0.0)?;
    let last = limit.mesh.cells.len() - 1;
    let (cell, s) = if over_left { (0, -1.0) } else { (last, 1.0) };
    let w = value(limit.deflection().cell(cell), s);
    let tangent = value(&limit.rotation(cell), s);
    let at = if over_left { 0.0 } else { l };
    // The rotation exceeds the limit, so that the beam is clear of the ground. In the limit process the last contact
    // interval has a length of order √ALMOST, and the slope has an error of that order, times the decay of the surface
    // over the length.
    let turns = BEYOND.into_iter().map(|more| {
        let beyond = more * tangent.abs().max(w.abs() / l);
        vec![GivenRotation {
            at,
            slope: if over_left { tangent - beyond } else { tangent + beyond },
        }]
    });
    turned_clear(&mut Bonded::new(model, cancel), &[[at, at]], turns, limit.history, judge)
}

/// The beam bonded on a contact, with the first of the given rotations that the certificate confirms.
pub(crate) fn turned_clear(
    bonded: &mut Bonded,
    contact: &[Interval],
    turns: impl Iterator<Item = Vec<GivenRotation>>,
    history: Vec<Step>,
    mut judge: impl FnMut(&ContactState) -> f64,
) -> Result<ContactState, Unconverged> {
    for held in turns {
        if let Ok(found) = bonded.solve_held(contact, &held)
            && judge(&found) <= GAP
        {
            return Ok(ContactState { history, ..found });
        }
    }
    Err(edges_not_converged(history.len(), f64::NAN))
}
