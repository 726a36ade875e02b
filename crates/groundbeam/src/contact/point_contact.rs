//! Equilibrium of a beam that stands on one point and may rotate about it.

use crate::cancel::Cancel;
use crate::contact::bonded::Bonded;
use crate::contact::bonded::GivenRotation;
use crate::contact::exact::solve;
use crate::contact::state::edges_not_converged;
use crate::contact::state::{ContactState, Unconverged};
use crate::model::{Load, Model};
use crate::numeric::polynomial::value;
use crate::numeric::tolerance::GAP;

/// How far from an end the resultant stands whose limit is taken, as a part of the length.
const ALMOST: f64 = 1e-6;

/// Solves a free beam whose resultant stands exactly over one of its ends. That end alone carries it, and
/// the beam may stand on it at any angle beyond the one at which it leaves the ground tangentially, which
/// is the limit of resultants that move towards the end. One such angle is taken.
pub(crate) fn solve_over_an_end(
    model: &Model,
    resultant: f64,
    over_left: bool,
    cancel: &Cancel,
    mut judge: impl FnMut(&ContactState) -> f64,
) -> Result<ContactState, Unconverged> {
    let l = model.beam.length;
    let inward = if over_left { ALMOST } else { -ALMOST };
    let nearly = model.clone().with_load(Load::point_moment(0.5 * l, inward * resultant * l));
    let limit = solve(&nearly, None, cancel, |_| 0.0)?;
    let last = limit.mesh.cells.len() - 1;
    let (cell, s) = if over_left { (0, -1.0) } else { (last, 1.0) };
    let w = value(limit.deflection().cell(cell), s);
    let tangent = value(&limit.rotation(cell), s);
    // Beyond the limit, clear of the ground: the limit's last interval of contact has a length of order
    // √ALMOST, and its slope an error of that order.
    let beyond = 10.0 * ALMOST.sqrt() * tangent.abs().max(w.abs() / l);
    let slope = if over_left { tangent - beyond } else { tangent + beyond };
    let end = if over_left { 0.0 } else { l };
    let history = limit.history;
    match Bonded::new(model, cancel)
        .solve_held(&[[end, end]], GivenRotation { left: over_left, slope })
    {
        Ok(found) if judge(&found) <= GAP => Ok(ContactState { history, ..found }),
        _ => Err(edges_not_converged(history.len(), f64::NAN)),
    }
}
