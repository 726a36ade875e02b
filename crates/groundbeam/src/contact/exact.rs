//! The contact problem without a mesh: the edges of contact as unknowns.
//!
//! Between loads, supports, joints and edges of contact the deflection solves (2.11) in closed form, so
//! the only unknowns are which stretches touch and where they end. A coarse [mesh](super::active_set)
//! tells the first; then each step
//!
//! 1. puts a node at every edge and solves the glued chain with [exact elements](crate::element);
//! 2. lays the ground under the beam found, anew and exactly ([majorant](crate::contact::obstacle)): its edges
//!    are where the unloaded ground leaves the beam tangentially, u' = w' − g₀' (w = g₀ for μ = 0). Zones
//!    split, merge, appear and vanish here of themselves.
//!
//! This is Newton's method on Φ in the space of all deflections: the error of the edges is squared in
//! every step. Near the answer [each edge](super::edges) is moved by itself instead, which squares the
//! error as well. If the steps do not settle, the mesh that began them is refined.

use super::edges;
use crate::cancel::Cancel;
use crate::chain::node::NotDefinite;
use crate::contact::bonded::Bonded;
use crate::contact::continuation;
use crate::contact::intervals::{Interval, distance, joined, positions};
use crate::contact::obstacle;
use crate::contact::refine::{Goal, InitialGuess, refine};
use crate::contact::start;
use crate::contact::state::edges_not_converged;
use crate::contact::state::{ContactState, Step, Unconverged};
use crate::contact::stopping::{LAST, Proof};
use crate::contact::stopping::{LOCAL, MOST_STEPS, NEAR, NEAR_STEPS, REFINEMENTS};
use crate::mesh::cell::gap_at;
use crate::mesh::mesh::Mesh;
use crate::model::{GapPoint, Model};
use std::borrow::Cow;

/// Solves a model. `judge` tells what the certificate shows of a deflection with its contact: where an
/// edge cannot be told from its neighbours (a zone without pressure, a beam balanced on one point), that
/// and not the edge's last digit ends the iteration. What is returned is what was judged last.
/// The steps begin at the contact that is `likely`, that of a neighbouring model, or else at one of their own.
pub(crate) fn solve(
    model: &Model,
    likely: Option<&[Interval]>,
    cancel: &Cancel,
    mut judge: impl FnMut(&ContactState) -> Proof,
) -> Result<ContactState, Unconverged> {
    let judge: &mut dyn FnMut(&ContactState) -> Proof = &mut judge;
    let glue = &mut Bonded::new(model, cancel);
    if let Some(likely) = likely
        && let Ok(found) = from_likely(glue, &on_the_beam(likely, model.beam.length), judge)
    {
        return Ok(found);
    }
    let nearly = sunk(model);
    if let Some(stretches) = start::edges(&nearly, cancel)
        && let Ok(found) = from_edges(glue, &stretches, judge)
    {
        return Ok(found);
    }
    let mut last = Unconverged::SINGULAR;
    let mut iterations = 0;
    for level in 0..=REFINEMENTS {
        let start = continuation::start(&nearly, level, cancel);
        let found = start.and_then(|start| {
            refine(glue, InitialGuess::asked_by(start), Goal::Answer(MOST_STEPS), judge)
        });
        match found {
            Ok(found) => return Ok(found),
            Err(stalled) => {
                iterations += stalled.iterations;
                last = stalled;
            }
        }
        if level == 0
            && model.beam.shears()
            && let Ok(start) = continuation::from_bending(&nearly, cancel, |model| {
                solve(model, None, cancel, unjudged)
            })
            && let Ok(found) =
                refine(glue, InitialGuess::asked_by(start), Goal::Answer(MOST_STEPS), judge)
        {
            return Ok(found);
        }
    }
    Err(Unconverged { iterations, ..last })
}

/// Stands in for the certificate where a solution is only an initial guess.
fn unjudged(_: &ContactState) -> Proof {
    Proof::NONE
}

/// A model to start from: what the ground settles by itself as an initial gap, linear between nodes.
fn sunk(model: &Model) -> Cow<'_, Model> {
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

/// From the contact of a stable equilibrium, known but for its last digits. An equilibrium elsewhere is none.
pub(crate) fn from_stable(
    model: &Model,
    contact: &[Interval],
    cancel: &Cancel,
    mut judge: impl FnMut(&ContactState) -> Proof,
) -> Result<ContactState, Unconverged> {
    let l = model.beam.length;
    let glue = &mut Bonded::new(model, cancel);
    let moved = |found: &ContactState| {
        distance(contact, &joined(positions(&found.mesh, &found.zones, &[]), l))
    };
    let moved = match from_edges(glue, contact, &mut judge) {
        Ok(found) if moved(&found) <= LOCAL * l => return Ok(found),
        Ok(found) => moved(&found),
        Err(stalled) => stalled.why.reached().unwrap_or(f64::NAN),
    };
    // Next to a limit point a step for the last digits leads away.
    let found = glue.on(contact, None).map_err(|NotDefinite| edges_not_converged(0, moved))?;
    if judge(&found).is_within(LAST) { Ok(found) } else { Err(edges_not_converged(0, moved)) }
}

/// Contact zones clipped to a beam of length `l`.
fn on_the_beam(contact: &[Interval], l: f64) -> Vec<Interval> {
    let within = contact.iter().filter(|[from, _]| *from <= l);
    within.map(|&[from, to]| [from, to.min(l)]).collect()
}

/// From the beam glued to the ground on given stretches. Where it asks for just these, it is the answer.
fn from_edges(
    glue: &mut Bonded,
    stretches: &[Interval],
    judge: &mut dyn FnMut(&ContactState) -> Proof,
) -> Result<ContactState, Unconverged> {
    let found = glue.on(stretches, None).map_err(|NotDefinite| edges_not_converged(0, f64::NAN))?;
    let zones = obstacle::contact(&found.deflection());
    if positions(&found.mesh, &zones, &[]) == stretches {
        judge(&found);
        let history = vec![Step { zones: stretches.len(), step: 1.0, decrement: 0.0 }];
        return Ok(ContactState { history, ..found });
    }
    let start = InitialGuess::asked_by(ContactState { zones, ..found });
    refine(glue, start, Goal::Answer(NEAR_STEPS), judge)
}

/// The same from stretches so likely that their edges are moved by themselves from the first step on.
fn from_likely(
    glue: &mut Bonded,
    stretches: &[Interval],
    judge: &mut dyn FnMut(&ContactState) -> Proof,
) -> Result<ContactState, Unconverged> {
    let found = glue.on(stretches, None).map_err(|NotDefinite| edges_not_converged(0, f64::NAN))?;
    let near = |next: &Vec<Interval>| {
        next != stretches && distance(stretches, next) <= NEAR * glue.model.beam.length
    };
    match edges::moved(&found.deflection(), &found.zones).filter(near) {
        Some(next) => {
            let start = InitialGuess { found, stretches: next, near: true };
            refine(glue, start, Goal::Answer(NEAR_STEPS), judge)
        }
        // Where all of the beam touches, or zones come and go, no edge tells.
        None => from_edges(glue, stretches, judge),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Beam, Foundation, Load};

    /// Kikuchi's case IV: the edge from 60-digit arithmetic, and how fast it is reached.
    #[test]
    fn edges_converge_quadratically() {
        let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
            .with_load(Load::point_force(0.5, 1.0))
            .with_load(Load::point_moment(0.5, 0.49));
        let mut stretches = vec![[0.8, 1.0]];
        let mut errors = Vec::new();
        for _ in 0..4 {
            let found =
                Bonded::new(&model, &Cancel::default()).on(&stretches, None).expect("a solution");
            let zones = obstacle::contact(&found.deflection());
            stretches = positions(&found.mesh, &zones, &[]);
            errors.push((stretches[0][0] - 0.811_326_256_449_155).abs());
        }
        assert!(errors[3] < 2e-15, "{errors:?}");
        assert!(errors[1] < errors[0] * errors[0] * 10.0, "{errors:?}");
    }
}
