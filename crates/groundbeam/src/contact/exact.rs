//! The contact problem without a mesh: the edges of contact as unknowns.
//!
//! Between loads, supports, joints and edges of contact the deflection solves (2.11) in closed form, so
//! the only unknowns are which stretches touch and where they end. A coarse [mesh](super::active_set)
//! tells the first; then each step
//!
//! 1. puts a node at every edge and solves the glued chain with [exact elements](crate::elements::exact);
//! 2. lays the ground under the beam found, anew and exactly ([majorant](super::majorant)): its edges
//!    are where the unloaded ground leaves the beam tangentially, u' = w' − g₀' (w = g₀ for μ = 0). Zones
//!    split, merge, appear and vanish here of themselves.
//!
//! This is Newton's method on Φ in the space of all deflections: the error of the edges is squared in
//! every step. Near the answer [each edge](super::edges) is moved by itself instead, which squares the
//! error as well. If the steps do not settle, the mesh that began them is refined.

use super::active_set::{Found, Stalled, Step};
use super::balanced::{self, Held};
use super::descent::shorten;
use super::edges;
use super::glue::Glue;
use super::layout::gap_at;
use super::majorant;
use super::near;
use super::softened;
use super::stretches::{Stretch, at_place, distance, joined, positions};
use crate::chain::Loose;
use crate::mesh::Mesh;
use crate::model::{GapPoint, Model};
use crate::polynomial::jet;
use crate::solution::ContactRegion;
use std::borrow::Cow;
use std::rc::Rc;

/// How often the coarse mesh is refined threefold before the model is given up.
const REFINEMENTS: u32 = 5;
/// Newton steps from one start.
const MOST_STEPS: usize = 200;
/// The same from edges that are known to be near: if it takes more, they are not.
const NEAR_STEPS: usize = 24;
/// The last move of an edge, relative to the beam's length, of a beam that only gives the next its start.
const ROUGH: f64 = 1e-6;
/// A move of the edges, relative to the beam's length, after which no step is shortened.
const LOCAL: f64 = 1e-8;
/// The same, after which the next step moves each edge by itself,
const NEAR: f64 = 0.1;
/// and after which the edges are so good that the certificate is asked.
const CLOSE: f64 = 1e-13;
/// A step that leaves no more than this part of the move before is one that squares the error.
const SQUARING: f64 = 0.1;
/// How many steps may stray from that before squaring the error is no excuse.
const MOST_STRAYS: usize = 4;

/// Steps after which the certificate is asked whether the edges' last digits matter.
const PATIENCE: usize = 4;
/// How often that, whatever the steps do, before the certificate's answer is good enough.
const ROUNDS: usize = 12;

/// Steps in a row that did not halve the move, after which the beam is tried without its weakest zones; and steps
/// after which it is tried on a corner alone.
const WALKING: usize = 8;
/// The weakest zone that is kept in that, relative to the strongest, and the most that the others may move,
/// relative to the beam's length.
const WEAKEST: f64 = 1e-10;
const STILL: f64 = 1e-3;

/// What the certificate shows, or must show.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Proof {
    /// The relative gap.
    pub gap: f64,
    /// The largest violation of balance, signs and complementarity. An edge that is off by δ leaves pδ
    /// unbalanced.
    pub violation: f64,
}

impl Proof {
    /// What is known where nothing is asked.
    pub(super) const NONE: Proof = Proof { gap: f64::INFINITY, violation: f64::INFINITY };

    pub(super) fn is_within(self, wanted: Proof) -> bool {
        self.gap <= wanted.gap && self.violation <= wanted.violation
    }
}

/// What a row of Newton steps is for.
#[derive(Debug, Clone, Copy)]
pub(super) enum Goal {
    /// The answer, in so many steps at most.
    Answer(usize),
    /// A start for the next, softer beam.
    Start,
}

/// What ends the iteration early, and what is accepted in the end.
const PROVEN: Proof = Proof { gap: 1e-22, violation: 1e-13 };
pub(super) const ENOUGH: Proof = Proof { gap: 1e-11, violation: 3e-8 };
/// What is accepted where rounding moves the edges for ever, after so many steps.
const LAST: Proof = Proof { gap: 9e-10, violation: 5e-8 };
const LAST_STEPS: usize = 100;

/// Solves a model. `judge` tells what the certificate shows of a deflection with its contact: where an
/// edge cannot be told from its neighbours (a zone without pressure, a beam balanced on one point), that
/// and not the edge's last digit ends the iteration. What is returned is what was judged last.
/// The steps begin at the contact that is `likely`, that of a neighbouring model, or else at one of their own.
pub(crate) fn solve(
    model: &Model,
    likely: Option<&[ContactRegion]>,
    mut judge: impl FnMut(&Found) -> Proof,
) -> Result<Found, Stalled> {
    let judge: &mut dyn FnMut(&Found) -> Proof = &mut judge;
    let glue = &mut Glue::new(model);
    if let Some(likely) = likely
        && let Ok(found) = from_likely(glue, &on_the_beam(likely, model.beam.length), judge)
    {
        return Ok(found);
    }
    let nearly = sunk(model);
    if let Some(stretches) = near::edges(&nearly)
        && let Ok(found) = from_edges(glue, &stretches, judge)
    {
        return Ok(found);
    }
    let mut last = Stalled::default();
    let mut iterations = 0;
    for level in 0..=REFINEMENTS {
        let start = softened::start(&nearly, level);
        let found = start.and_then(|start| {
            refine(glue, Start::asked_by(start), Goal::Answer(MOST_STEPS), judge)
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
            && let Ok(start) = softened::from_bending(&nearly)
            && let Ok(found) = refine(glue, Start::asked_by(start), Goal::Answer(MOST_STEPS), judge)
        {
            return Ok(found);
        }
    }
    Err(Stalled { iterations, ..last })
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
    contact: &[Stretch],
    mut judge: impl FnMut(&Found) -> Proof,
) -> Result<Found, Stalled> {
    let l = model.beam.length;
    let glue = &mut Glue::new(model);
    let moved =
        |found: &Found| distance(contact, &joined(positions(&found.mesh, &found.zones, &[]), l));
    let moved = match from_edges(glue, contact, &mut judge) {
        Ok(found) if moved(&found) <= LOCAL * l => return Ok(found),
        Ok(found) => moved(&found),
        Err(stalled) => stalled.reached,
    };
    // Next to a limit point a step for the last digits leads away.
    let found = glue.on(contact, None).map_err(|Loose| unsettled(0, moved))?;
    if judge(&found).is_within(LAST) { Ok(found) } else { Err(unsettled(0, moved)) }
}

/// The contact of another beam, as far as this one reaches.
fn on_the_beam(contact: &[ContactRegion], l: f64) -> Vec<Stretch> {
    let within = contact.iter().filter(|region| region.from <= l);
    within.map(|region| [region.from, region.to.min(l)]).collect()
}

/// From the beam glued to the ground on given stretches. Where it asks for just these, it is the answer.
fn from_edges(
    glue: &mut Glue,
    stretches: &[Stretch],
    judge: &mut dyn FnMut(&Found) -> Proof,
) -> Result<Found, Stalled> {
    let found = glue.on(stretches, None).map_err(|Loose| unsettled(0, f64::NAN))?;
    let zones = majorant::contact(&found.deflection());
    if positions(&found.mesh, &zones, &[]) == stretches {
        judge(&found);
        let history = vec![Step { zones: stretches.len(), step: 1.0, decrement: 0.0 }];
        return Ok(Found { history, ..found });
    }
    let start = Start::asked_by(Found { zones, ..found });
    refine(glue, start, Goal::Answer(NEAR_STEPS), judge)
}

/// The same from stretches so likely that their edges are moved by themselves from the first step on.
fn from_likely(
    glue: &mut Glue,
    stretches: &[Stretch],
    judge: &mut dyn FnMut(&Found) -> Proof,
) -> Result<Found, Stalled> {
    let found = glue.on(stretches, None).map_err(|Loose| unsettled(0, f64::NAN))?;
    let near = |next: &Vec<Stretch>| {
        next != stretches && distance(stretches, next) <= NEAR * glue.model.beam.length
    };
    match edges::moved(&found.deflection(), &found.zones).filter(near) {
        Some(next) => {
            let start = Start { found, stretches: next, near: true };
            refine(glue, start, Goal::Answer(NEAR_STEPS), judge)
        }
        // Where all of the beam touches, or zones come and go, no edge tells.
        None => from_edges(glue, stretches, judge),
    }
}

/// A deflection, and the contact that it asks for.
pub(super) struct Start {
    pub found: Found,
    pub stretches: Vec<Stretch>,
    /// Whether that is near the contact on which it was glued.
    pub near: bool,
}

impl Start {
    pub fn asked_by(found: Found) -> Self {
        let stretches = positions(&found.mesh, &found.zones, &[]);
        Start { found, stretches, near: false }
    }
}

/// Newton's steps on the edges, from the deflection of a coarser problem.
pub(super) fn refine(
    glue: &mut Glue,
    start: Start,
    goal: Goal,
    judge: &mut dyn FnMut(&Found) -> Proof,
) -> Result<Found, Stalled> {
    let (rough, most_steps) = match goal {
        Goal::Answer(most_steps) => (false, most_steps),
        Goal::Start => (true, NEAR_STEPS),
    };
    let model = glue.model;
    let places: Vec<f64> = Mesh::build(model, &[], |_| 1).nodes.iter().map(|n| n.x).collect();
    let l = model.beam.length;
    let placed = |stretches: Vec<Stretch>| -> Vec<Stretch> {
        stretches.into_iter().map(|ends| ends.map(|x| at_place(x, &places, l))).collect()
    };
    let Start { found: mut start, stretches, near } = start;
    let mut stretches = placed(stretches);
    let mut history = std::mem::take(&mut start.history);
    let mut moved = f64::INFINITY;
    // Steps in a row that did not halve the move, how many have not so far, and whether the last step was
    // taken whole.
    let mut idle = 0;
    let mut strays = 0;
    let mut whole = true;
    // Whether edges may be moved by themselves.
    let mut alone = true;
    // The deflection that asked for the stretches, and the last that equilibrium made.
    let mut now = Rc::new(start);
    let mut last: Option<Rc<Found>> = None;
    for step in 0..most_steps {
        let Ok(found) = glue.on(&stretches, None) else {
            // A beam balanced on one point may turn about it, as far as no other point touches.
            let held = glue.on(&stretches, Some(Held::as_in(&now))).ok();
            let mut proven = |found: &Found| judge(found).is_within(LAST);
            let found = match held.filter(&mut proven) {
                Some(found) => Some(found),
                None => last.map(Rc::unwrap_or_clone).filter(proven),
            };
            return match found {
                Some(found) => Ok(Found { history, ..found }),
                None => Err(unsettled(step, moved)),
            };
        };
        let before = moved;
        let near = before <= NEAR || (step == 0 && near);
        let by_edges = if near && whole && alone && !rough {
            edges::moved(&found.deflection(), &found.zones)
        } else {
            None
        };
        let by_scan = by_edges.is_none();
        let mut zones = Vec::new();
        let next = match by_edges {
            Some(next) => placed(next),
            None => {
                zones = majorant::contact(&found.deflection());
                positions(&found.mesh, &zones, &places)
            }
        };
        moved = distance(&stretches, &next) / l;
        history.push(Step { zones: next.len(), step: 1.0, decrement: moved });
        // Quadratic convergence ends at rounding: no further step would make it smaller.
        let settled = moved <= 1e-15 || (moved <= 1e-12 && moved >= 0.25 * before);
        if rough && moved <= ROUGH {
            return Ok(Found { history, zones, ..found });
        }
        let halved = moved <= 0.5 * before && moved.is_finite();
        idle = if halved { 0 } else { idle + 1 };
        let proof = match step {
            _ if step > LAST_STEPS => LAST,
            // Zones that come and go are more than the last digits of edges.
            _ if moved.is_infinite() => PROVEN,
            _ if idle > PATIENCE || step > ROUNDS * PATIENCE => ENOUGH,
            _ => PROVEN,
        };
        let squaring = before.is_finite() && moved <= SQUARING * before;
        // A zone that its own deflection does not ask for is none: rounding may take it away and bring it back.
        let sheds = next.len() < stretches.len() && step <= LAST_STEPS;
        if settled || moved <= CLOSE || (step >= PATIENCE && !squaring && !sheds) {
            // A zone too small for the energy is seen by the scan alone.
            let asks_for_these = || {
                let zones = majorant::contact(&found.deflection());
                distance(&stretches, &positions(&found.mesh, &zones, &places)) <= LOCAL * l
            };
            if by_scan || asks_for_these() {
                let shown = judge(&found);
                if (settled && by_scan) || shown.is_within(proof) {
                    return Ok(Found { history, ..found });
                }
            }
            // Where edges by themselves come to rest at no answer, the scan goes on.
            alone &= by_scan;
        }
        let patient = most_steps > NEAR_STEPS && step > 0;
        if patient
            && step.is_multiple_of(WALKING)
            && let Some(found) = balanced::on_a_corner(glue, &found, &next)
            && judge(&found).is_within(LAST)
        {
            return Ok(Found { history, ..found });
        }
        if patient
            && idle > 0
            && idle.is_multiple_of(WALKING)
            && let Some(start) = without_the_weakest(glue, &found, &next)
            && let Ok(found) = refine(glue, Start::asked_by(start), Goal::Answer(NEAR_STEPS), judge)
        {
            return Ok(Found { history, ..found });
        }
        // Steps that shrink end by themselves. Once one has not, the energy decides how far each goes, but
        // for those that square the error.
        // A zone or two that nodes alone had told do not make the first step a stray.
        let first_of_near = step == 0 && most_steps == NEAR_STEPS;
        if !(first_of_near || halved && (before.is_finite() || step < 2)) {
            strays += 1;
        }
        whole = strays == 0 || (strays <= MOST_STRAYS && squaring);
        let mut between = None;
        if !whole && moved > LOCAL {
            let shortened = shorten(model, &now, &found);
            if let Some(step) = history.last_mut() {
                step.step = shortened.part;
            }
            between = shortened.between;
        }
        let found = Rc::new(found);
        (now, stretches) = match between {
            Some(between) => {
                moved = f64::INFINITY;
                let stretches = positions(&between.mesh, &between.zones, &places);
                (Rc::new(between), stretches)
            }
            None => (Rc::clone(&found), next),
        };
        last = Some(found);
    }
    match last.filter(|found| judge(found).is_within(ENOUGH)) {
        Some(found) => Ok(Found { history, ..Rc::unwrap_or_clone(found) }),
        None => Err(unsettled(most_steps, moved)),
    }
}

/// The beam glued to the ground where it presses most, if it asks for just that.
///
/// A step moves an end of contact by a wave length at most. Beyond the last load of a beam hundreds of waves
/// long, zones each a thousand times weaker than the one before walk to the end of the beam that way, where
/// in truth all of it lifts.
fn without_the_weakest(glue: &mut Glue, found: &Found, stretches: &[Stretch]) -> Option<Found> {
    let weight = |[a, b]: &Stretch| {
        let x = 0.5 * (a + b);
        let cell = found.mesh.cell_at(x);
        let [w, ..] = jet(found.deflection().cell(cell), found.mesh.cells[cell].local(x));
        w.abs() * (b - a)
    };
    let weights: Vec<f64> = stretches.iter().map(weight).collect();
    let mut ranked = weights.clone();
    ranked.sort_by(|a, b| b.total_cmp(a));
    let worth_keeping = |w: &&f64| **w > WEAKEST * ranked[0];
    let most = ranked.iter().take_while(worth_keeping).count().min(stretches.len() - 1);
    (1..=most).rev().find_map(|count| {
        let strong = stretches.iter().zip(&weights).filter(|(_, w)| **w >= ranked[count - 1]);
        let strong: Vec<Stretch> = strong.map(|(stretch, _)| *stretch).collect();
        let found = glue.on(&strong, None).ok()?;
        let zones = majorant::contact(&found.deflection());
        let moved = distance(&strong, &positions(&found.mesh, &zones, &[]));
        (moved <= STILL * glue.model.beam.length).then_some(Found { zones, ..found })
    })
}

pub(super) fn unsettled(iterations: usize, reached: f64) -> Stalled {
    let what = "the last move of an edge of contact, relative to the beam's length,";
    Stalled { iterations, what, tolerance: 1e-12, reached }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Beam, Foundation, Load};

    /// Kikuchi's case IV: the edge from 60-digit arithmetic, and how fast it is reached.
    #[test]
    fn edges_converge_quadratically() {
        let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
            .with_load(Load::point(1.0, 0.5))
            .with_load(Load::moment(0.49, 0.5));
        let mut stretches = vec![[0.8, 1.0]];
        let mut errors = Vec::new();
        for _ in 0..4 {
            let found = Glue::new(&model).on(&stretches, None).expect("a solution");
            let zones = majorant::contact(&found.deflection());
            stretches = positions(&found.mesh, &zones, &[]);
            errors.push((stretches[0][0] - 0.811_326_256_449_155).abs());
        }
        assert!(errors[3] < 2e-15, "{errors:?}");
        assert!(errors[1] < errors[0] * errors[0] * 10.0, "{errors:?}");
    }
}
