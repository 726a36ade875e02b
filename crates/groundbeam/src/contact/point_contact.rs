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

/// Shift of a load resultant from an end into the beam, relative to the beam length. The shifted resultant gives the
/// smallest rotation in equilibrium.
const ALMOST: f64 = 1e-6;

/// Trial increases of the rotation above the smallest rotation φ₀ in equilibrium, relative to max(|φ₀|, |w₀|/l). w₀ is
/// the deflection of the end in contact, and l the beam length.
const BEYOND: [f64; 4] = [0.01, 0.1, 1.0, 10.0];

/// Solves a free beam whose load resultant acts exactly over one end, the only contact. Every rotation above a smallest
/// rotation is in equilibrium. The function chooses one of them.
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
    // The smallest rotation in equilibrium is only approximate, because it was computed with a shifted load
    // resultant. The trial rotations are therefore larger than this rotation.
    let turns = BEYOND.into_iter().map(|more| {
        let beyond = more * tangent.abs().max(w.abs() / l);
        vec![GivenRotation {
            at,
            slope: if over_left { tangent - beyond } else { tangent + beyond },
        }]
    });
    turned_clear(&mut Bonded::new(model, cancel), &[[at, at]], turns, limit.history, judge)
}

/// Solves the bonded beam for each set of rotations in `turns`. Returns the first solution with an energy gap of at
/// most [`GAP`].
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
