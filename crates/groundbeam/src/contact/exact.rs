//! Solves the exact contact problem, whose unknowns are the positions of the contact edges.
//!
//! [Phase B](super::edges) finds the edges by Newton's method, from the first of these initial guesses that leads to a
//! solution:
//!
//! 1. the contact of a neighbouring model, if given;
//! 2. the whole length of a short beam, or a nodal solve of a long one ([`start`](super::start));
//! 3. the contact of a stiffer beam ([`continuation`](super::continuation)).

use crate::cancel::Cancel;
use crate::contact::bonded::Bonded;
use crate::contact::continuation;
use crate::contact::edges::{Judge, Start, edges};
use crate::contact::intervals::{Interval, longest_difference, positions};
use crate::contact::start;
use crate::contact::state::{ContactState, Unconverged, edges_not_converged};
use crate::contact::stopping::{BLIND, FEW_STEPS, LEVELS, MOST_STEPS};
use crate::contact::translation;
use crate::mesh::cell::gap_at;
use crate::mesh::mesh::Mesh;
use crate::model::{GapPoint, Model};
use crate::numeric::tolerance::GAP;
use std::borrow::Cow;

/// Solves the contact problem, from the contact set `likely` of a neighbouring model if given. `judge` computes the
/// relative energy gap; its last call is for the returned state.
pub(crate) fn solve(
    model: &Model,
    likely: Option<&[Interval]>,
    cancel: &Cancel,
    mut judge: impl FnMut(&ContactState) -> f64,
) -> Result<ContactState, Unconverged> {
    let mut gap = 0.0;
    let found = from_guesses(model, likely, cancel, &mut |found| {
        gap = judge(found);
        gap
    })?;
    if gap <= GAP {
        return Ok(found);
    }
    Ok(translation::from_solution(model, &found, cancel, &mut judge).unwrap_or_else(|| {
        judge(&found);
        found
    }))
}

/// Solves the contact problem from each initial guess in turn, until one leads to a solution.
fn from_guesses(
    model: &Model,
    likely: Option<&[Interval]>,
    cancel: &Cancel,
    judge: Judge,
) -> Result<ContactState, Unconverged> {
    let bonded = &mut Bonded::new(model, cancel);
    if let Some(likely) = likely {
        let contact = on_the_beam(likely, model.beam.length);
        let start = Start { contact, now: None, near: true };
        if let Ok(found) = edges(bonded, start, FEW_STEPS, judge) {
            return Ok(found);
        }
    }
    let nearly = with_free_field_as_gap(model);
    if let Some(contact) = start::edges(&nearly, cancel)
        && let Ok(found) = edges(bonded, Start::on(contact), FEW_STEPS, judge)
    {
        return Ok(found);
    }
    let mut last = Unconverged::SINGULAR;
    let mut iterations = 0;
    for level in 0..LEVELS {
        let start = continuation::follow(&nearly, level, cancel);
        match start.and_then(|start| edges(bonded, start, MOST_STEPS, judge)) {
            Ok(found) => return Ok(found),
            Err(stalled) => {
                iterations += stalled.iterations;
                last = stalled;
            }
        }
    }
    Err(Unconverged { iterations, ..last })
}

/// Returns the model for the initial guess. Its initial gap contains the free-field settlement, linear between nodes.
fn with_free_field_as_gap(model: &Model) -> Cow<'_, Model> {
    if !model.has_ground_loads() {
        return Cow::Borrowed(model);
    }
    let cells = Mesh::build(model, &[], |_| 1).cells;
    let mut nearly = model.clone();
    nearly.loads.retain(|load| !load.is_on_ground());
    nearly.gap.clear();
    for cell in &cells {
        nearly.gap.push(GapPoint { at: cell.x[0], value: gap_at(cell, -1.0) });
    }
    let last = &cells[cells.len() - 1];
    nearly.gap.push(GapPoint { at: last.x[1], value: gap_at(last, 1.0) });
    Cow::Owned(nearly)
}

/// Refines the contact of a stable equilibrium that is known except for its last digits. Fails if the iteration leads
/// to another equilibrium.
pub(crate) fn from_stable(
    model: &Model,
    contact: &[Interval],
    cancel: &Cancel,
    mut judge: impl FnMut(&ContactState) -> f64,
) -> Result<ContactState, Unconverged> {
    let l = model.beam.length;
    let bonded = &mut Bonded::new(model, cancel);
    let start = Start::on(contact.to_vec());
    let moved = match edges(bonded, start, FEW_STEPS, &mut judge) {
        Ok(found) => {
            let moved = longest_difference(contact, &positions(&found.mesh, &found.zones, &[]));
            if moved <= BLIND * l {
                return Ok(found);
            }
            moved
        }
        Err(stalled) => stalled.why.reached().unwrap_or(f64::NAN),
    };
    // Near a limit point a Newton step leads away from the equilibrium. Then the given contact is kept.
    match bonded.solve_on(contact) {
        Ok(found) if judge(&found) <= GAP => Ok(found),
        _ => Err(edges_not_converged(0, moved)),
    }
}

/// Contact zones clipped to a beam of length `l`.
fn on_the_beam(contact: &[Interval], l: f64) -> Vec<Interval> {
    let within = contact.iter().filter(|[from, _]| *from <= l);
    within.map(|&[from, to]| [from, to.min(l)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::obstacle;
    use crate::model::{Beam, Foundation, Load};

    /// Tests Kikuchi's case IV: compares the contact edge with its position from 60-digit arithmetic, and checks
    /// that the error of the edge decreases quadratically.
    #[test]
    fn edges_converge_quadratically() {
        let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
            .with_load(Load::point_force(0.5, 1.0))
            .with_load(Load::point_moment(0.5, 0.49));
        let mut intervals = vec![[0.8, 1.0]];
        let mut errors = Vec::new();
        for _ in 0..4 {
            let found =
                Bonded::new(&model, &Cancel::default()).solve_on(&intervals).expect("a solution");
            let zones = obstacle::contact(&found.deflection());
            intervals = positions(&found.mesh, &zones, &[]);
            errors.push((intervals[0][0] - 0.811_326_256_449_155).abs());
        }
        assert!(errors[3] < 2e-15, "{errors:?}");
        assert!(errors[1] < errors[0] * errors[0] * 10.0, "{errors:?}");
    }
}
