//! Computes the equilibrium of a beam that touches the ground at one point only and may rotate about this point.

use crate::cancel::Cancel;
use crate::contact::bonded::{Bonded, GivenRotation};
use crate::contact::exact::solve;
use crate::contact::intervals::Interval;
use crate::contact::state::{ContactState, Unconverged, edges_not_converged};
use crate::model::{Load, Model};
use crate::numeric::polynomial::value;
use crate::numeric::step::Step;
use crate::numeric::tolerance::GAP;

/// Distance of the load resultant from an end of the beam, relative to the length of the beam, in the problem that
/// approximates a resultant exactly over this end.
const ALMOST: f64 = 1e-6;

/// Trial amounts by which the rotation of the beam exceeds its limit value, relative to the larger of |φ| and |w|/l at
/// this limit, for the rotation φ and the deflection w of the touching end. The solver takes the first amount whose
/// solution has an energy gap of at most [`GAP`].
const BEYOND: [f64; 4] = [0.01, 0.1, 1.0, 10.0];

/// Solves a free beam whose load resultant is exactly over one of its ends. Only this end is in contact. If the
/// resultant approaches the end, the rotation approaches a limit, at which the beam leaves the ground tangentially.
/// The beam is in equilibrium at every larger rotation. The function chooses one of these larger rotations.
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
    // The trial rotations exceed the computed limit, which has an error. The computed limit belongs to a resultant at
    // the distance ALMOST from the end, where the length of the contact interval is of order √ALMOST.
    let turns = BEYOND.into_iter().map(|more| {
        let beyond = more * tangent.abs().max(w.abs() / l);
        vec![GivenRotation {
            at,
            slope: if over_left { tangent - beyond } else { tangent + beyond },
        }]
    });
    turned_clear(&mut Bonded::new(model, cancel), &[[at, at]], turns, limit.history, judge)
}

/// Solves the beam in contact with the ground on `contact`, for each of the given rotations. Returns the first
/// solution whose energy gap is at most [`GAP`].
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
