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

/// If the load resultant acts exactly at an end of the beam, the solver first shifts it into the beam by this fraction
/// of the beam's length. It then computes the smallest rotation at which the beam is in equilibrium.
const ALMOST: f64 = 1e-6;

/// Trial values of the rotation of the beam minus its smallest rotation in equilibrium, divided by the larger of |φ|
/// and |w|/l. Here φ is the rotation and w the deflection of the end in contact, both at the smallest rotation, and l
/// is the length of the beam. The solver takes the first value whose solution has a relative energy gap of at most
/// [`GAP`].
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
    // The trial rotations exceed the computed smallest rotation, because this rotation is only approximate. It belongs
    // to a load resultant at the distance ALMOST from the end, where the length of the contact interval is of order
    // √ALMOST.
    let turns = BEYOND.into_iter().map(|more| {
        let beyond = more * tangent.abs().max(w.abs() / l);
        vec![GivenRotation {
            at,
            slope: if over_left { tangent - beyond } else { tangent + beyond },
        }]
    });
    turned_clear(&mut Bonded::new(model, cancel), &[[at, at]], turns, limit.history, judge)
}

/// Solves the beam bonded to the ground on `contact` with prescribed rotations, once for each set of rotations in
/// `turns`. Returns the first solution whose relative energy gap, computed by `judge`, is at most [`GAP`].
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
