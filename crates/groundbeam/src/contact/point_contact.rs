//! Equilibrium of a beam that stands on one point and may rotate about it.

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

/// How far beyond the limit the beam is turned, relative to the limit's slope: the first that is clear of the ground is taken.
const BEYOND: [f64; 4] = [0.01, 0.1, 1.0, 10.0];

/// Solves a free beam whose resultant stands exactly over one of its ends. That end alone carries it, and
/// the beam may stand on it at any angle beyond the one at which it leaves the ground tangentially, which
/// is the limit of resultants that move towards the end. One such angle is taken.
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
    // Beyond the limit, clear of the ground: the limit's last interval of contact has a length of order
    // √ALMOST, and its slope an error of that order, times the decay of the ground's surface over the length.
    let turns = BEYOND.into_iter().map(|more| {
        let beyond = more * tangent.abs().max(w.abs() / l);
        vec![GivenRotation {
            at,
            slope: if over_left { tangent - beyond } else { tangent + beyond },
        }]
    });
    turned_clear(&mut Bonded::new(model, cancel), &[[at, at]], turns, limit.history, judge)
}

/// The beam bonded on a contact, with the first of the given rotations at which the certificate holds.
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
