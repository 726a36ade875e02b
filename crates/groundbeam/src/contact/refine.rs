//! Newton's iteration on the contact edges, from the deflection of a coarser problem.

use crate::contact::bonded::Bonded;
use crate::contact::bonded::GivenRotation;
use crate::contact::corner;
use crate::contact::descent::shorten;
use crate::contact::edges;
use crate::contact::intervals::{Interval, at_place, distance, positions};
use crate::contact::obstacle;
use crate::contact::state::edges_not_converged;
use crate::contact::state::{ContactState, Step, Unconverged};
use crate::contact::stopping::{
    EDGES_CLOSE, LAST_STEPS, LOCAL, MOST_STRAYS, NEAR, NEAR_STEPS, PATIENCE, ROUGH, ROUNDS,
    SQUARING, STILL, WALKING, WEAKEST,
};
use crate::contact::stopping::{ENOUGH, LAST, PROVEN, Proof};
use crate::mesh::mesh::Mesh;
use crate::numeric::polynomial::jet;
use std::rc::Rc;

/// What a row of Newton steps is for.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Goal {
    /// The answer, in so many steps at most.
    Answer(usize),
    /// A start for the next, softer beam.
    Start,
}

/// A deflection, and the contact that it asks for.
pub(crate) struct InitialGuess {
    pub found: ContactState,
    pub intervals: Vec<Interval>,
    /// Whether that is near the contact on which it was bonded.
    pub near: bool,
}

impl InitialGuess {
    pub fn asked_by(found: ContactState) -> Self {
        let intervals = positions(&found.mesh, &found.zones, &[]);
        InitialGuess { found, intervals, near: false }
    }
}

/// Newton's steps on the edges, from the deflection of a coarser problem.
pub(crate) fn refine(
    bonded: &mut Bonded,
    start: InitialGuess,
    goal: Goal,
    judge: &mut dyn FnMut(&ContactState) -> Proof,
) -> Result<ContactState, Unconverged> {
    let (rough, most_steps) = match goal {
        Goal::Answer(most_steps) => (false, most_steps),
        Goal::Start => (true, NEAR_STEPS),
    };
    let model = bonded.model;
    let places: Vec<f64> = Mesh::build(model, &[], |_| 1).nodes.iter().map(|n| n.x).collect();
    let l = model.beam.length;
    let placed = |intervals: Vec<Interval>| -> Vec<Interval> {
        intervals.into_iter().map(|ends| ends.map(|x| at_place(x, &places, l))).collect()
    };
    let InitialGuess { found: mut start, intervals, near } = start;
    let mut intervals = placed(intervals);
    let mut history = std::mem::take(&mut start.history);
    let mut moved = f64::INFINITY;
    // Steps in a row that did not halve the move, how many have not so far, and whether the last step was
    // taken whole.
    let mut idle = 0;
    let mut strays = 0;
    let mut whole = true;
    // Whether edges may be moved by themselves.
    let mut alone = true;
    // The deflection that asked for the intervals, and the last that equilibrium made.
    let mut now = Rc::new(start);
    let mut last: Option<Rc<ContactState>> = None;
    for step in 0..most_steps {
        let Ok(found) = bonded.on(&intervals, None) else {
            // A beam balanced on one point may turn about it, as far as no other point touches.
            let held = bonded.on(&intervals, Some(GivenRotation::as_in(&now))).ok();
            let mut proven = |found: &ContactState| judge(found).is_within(LAST);
            let found = match held.filter(&mut proven) {
                Some(found) => Some(found),
                None => last.map(Rc::unwrap_or_clone).filter(proven),
            };
            return match found {
                Some(found) => Ok(ContactState { history, ..found }),
                None => Err(edges_not_converged(step, moved)),
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
                zones = obstacle::contact(&found.deflection());
                positions(&found.mesh, &zones, &places)
            }
        };
        moved = distance(&intervals, &next) / l;
        history.push(Step { zones: next.len(), step: 1.0, decrement: moved });
        // Quadratic convergence ends at rounding: no further step would make it smaller.
        let settled = moved <= 1e-15 || (moved <= 1e-12 && moved >= 0.25 * before);
        if rough && moved <= ROUGH {
            return Ok(ContactState { history, zones, ..found });
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
        let sheds = next.len() < intervals.len() && step <= LAST_STEPS;
        if settled || moved <= EDGES_CLOSE || (step >= PATIENCE && !squaring && !sheds) {
            // A zone too small for the energy is seen by the scan alone.
            let asks_for_these = || {
                let zones = obstacle::contact(&found.deflection());
                distance(&intervals, &positions(&found.mesh, &zones, &places)) <= LOCAL * l
            };
            if by_scan || asks_for_these() {
                let shown = judge(&found);
                if (settled && by_scan) || shown.is_within(proof) {
                    return Ok(ContactState { history, ..found });
                }
            }
            // Where edges by themselves come to rest at no answer, the scan goes on.
            alone &= by_scan;
        }
        let patient = most_steps > NEAR_STEPS && step > 0;
        if patient
            && step.is_multiple_of(WALKING)
            && let Some(found) = corner::on_a_corner(bonded, &found, &next)
            && judge(&found).is_within(LAST)
        {
            return Ok(ContactState { history, ..found });
        }
        if patient
            && idle > 0
            && idle.is_multiple_of(WALKING)
            && let Some(start) = without_the_weakest(bonded, &found, &next)
            && let Ok(found) =
                refine(bonded, InitialGuess::asked_by(start), Goal::Answer(NEAR_STEPS), judge)
        {
            return Ok(ContactState { history, ..found });
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
        (now, intervals) = match between {
            Some(between) => {
                moved = f64::INFINITY;
                let intervals = positions(&between.mesh, &between.zones, &places);
                (Rc::new(between), intervals)
            }
            None => (Rc::clone(&found), next),
        };
        last = Some(found);
    }
    match last.filter(|found| judge(found).is_within(ENOUGH)) {
        Some(found) => Ok(ContactState { history, ..Rc::unwrap_or_clone(found) }),
        None => Err(edges_not_converged(most_steps, moved)),
    }
}

/// The beam bonded to the ground where it presses most, if it asks for just that.
///
/// A step moves an end of contact by a wave length at most. Beyond the last load of a beam hundreds of waves
/// long, zones each a thousand times weaker than the one before walk to the end of the beam that way, where
/// in truth all of it lifts.
pub(crate) fn without_the_weakest(
    bonded: &mut Bonded,
    found: &ContactState,
    intervals: &[Interval],
) -> Option<ContactState> {
    let weight = |[a, b]: &Interval| {
        let x = 0.5 * (a + b);
        let cell = found.mesh.cell_at(x);
        let [w, ..] = jet(found.deflection().cell(cell), found.mesh.cells[cell].local(x));
        w.abs() * (b - a)
    };
    let weights: Vec<f64> = intervals.iter().map(weight).collect();
    let mut ranked = weights.clone();
    ranked.sort_by(|a, b| b.total_cmp(a));
    let worth_keeping = |w: &&f64| **w > WEAKEST * ranked[0];
    let most = ranked.iter().take_while(worth_keeping).count().min(intervals.len() - 1);
    (1..=most).rev().find_map(|count| {
        let strong = intervals.iter().zip(&weights).filter(|(_, w)| **w >= ranked[count - 1]);
        let strong: Vec<Interval> = strong.map(|(interval, _)| *interval).collect();
        let found = bonded.on(&strong, None).ok()?;
        let zones = obstacle::contact(&found.deflection());
        let moved = distance(&strong, &positions(&found.mesh, &zones, &[]));
        (moved <= STILL * bonded.model.beam.length).then_some(ContactState { zones, ..found })
    })
}
