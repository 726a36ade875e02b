//! Newton's iteration on the contact edges, from the deflection of a coarser problem.

use crate::contact::bonded::Bonded;
use crate::contact::bonded::GivenRotation;
use crate::contact::corner;
use crate::contact::descent::shorten;
use crate::contact::edges;
use crate::contact::intervals::{Interval, distance, positions, snapped};
use crate::contact::obstacle;
use crate::contact::state::edges_not_converged;
use crate::contact::state::{ContactState, Step, Unconverged};
use crate::contact::stopping::{
    EDGES_CLOSE, LAST_STEPS, LOCAL, MOST_STRAYS, NEAR, NEAR_STEPS, PATIENCE, ROUGH, ROUNDS,
    SQUARING, STILL, WALKING, WEAKEST,
};
use crate::contact::stopping::{ENOUGH, LAST, PROVEN};
use crate::mesh::mesh::Mesh;
use crate::numeric::polynomial::jet;
use std::rc::Rc;

/// What a Newton iteration must reach.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Goal {
    /// The answer, in so many steps at most.
    Answer(usize),
    /// An initial guess of the next, softer beam.
    Start,
}

/// A deflection, and its contact set.
pub(crate) struct InitialGuess {
    pub found: ContactState,
    pub intervals: Vec<Interval>,
    /// Whether the contact set is close to the contact on which the beam was bonded.
    pub near: bool,
}

impl InitialGuess {
    pub fn of_contact_set(found: ContactState) -> Self {
        let intervals = positions(&found.mesh, &found.zones, &[]);
        InitialGuess { found, intervals, near: false }
    }
}

/// Newton's iteration on the edges, from an initial guess.
pub(crate) fn refine(
    bonded: &mut Bonded,
    start: InitialGuess,
    goal: Goal,
    judge: &mut dyn FnMut(&ContactState) -> f64,
) -> Result<ContactState, Unconverged> {
    let (start_only, most_steps) = match goal {
        Goal::Answer(most_steps) => (false, most_steps),
        Goal::Start => (true, NEAR_STEPS),
    };
    let model = bonded.model;
    let places: Vec<f64> = Mesh::build(model, &[], |_| 1).nodes.iter().map(|n| n.x).collect();
    let l = model.beam.length;
    let placed = |intervals: Vec<Interval>| -> Vec<Interval> {
        intervals.into_iter().map(|ends| ends.map(|x| snapped(x, &places, l))).collect()
    };
    let InitialGuess { found: mut start, intervals, near } = start;
    let mut intervals = placed(intervals);
    let mut history = std::mem::take(&mut start.history);
    let mut moved = f64::INFINITY;
    // Steps in a row that did not halve the move; steps so far that did not; whether the last step was full.
    let mut no_progress = 0;
    let mut non_quadratic = 0;
    let mut full_step = true;
    // Whether edge Newton may be used.
    let mut edge_phase = true;
    // The deflection whose contact set the intervals are, and the last bonded solution.
    let mut now = Rc::new(start);
    let mut last: Option<Rc<ContactState>> = None;
    for step in 0..most_steps {
        let Ok(found) = bonded.solve_on(&intervals, None) else {
            // A beam balanced on one point may rotate about it until another point touches.
            let on_point = bonded.solve_on(&intervals, Some(GivenRotation::as_in(&now))).ok();
            let mut proven = |found: &ContactState| judge(found) <= LAST;
            let found = match on_point.filter(&mut proven) {
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
        let by_edges = if near && full_step && edge_phase && !start_only {
            edges::next_intervals(&found.deflection(), &found.zones)
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
        // Quadratic convergence ends at rounding error.
        let converged = moved <= 1e-15 || (moved <= 1e-12 && moved >= 0.25 * before);
        if start_only && moved <= ROUGH {
            return Ok(ContactState { history, zones, ..found });
        }
        let halved = moved <= 0.5 * before && moved.is_finite();
        no_progress = if halved { 0 } else { no_progress + 1 };
        let enough = match step {
            _ if step > LAST_STEPS => LAST,
            // The number of zones changed: not only the last digits of edges.
            _ if moved.is_infinite() => PROVEN,
            _ if no_progress > PATIENCE || step > ROUNDS * PATIENCE => ENOUGH,
            _ => PROVEN,
        };
        let squaring = before.is_finite() && moved <= SQUARING * before;
        // Do not accept a zone that the obstacle problem drops again; rounding can make it flicker.
        let loses_zones = next.len() < intervals.len() && step <= LAST_STEPS;
        if converged || moved <= EDGES_CLOSE || (step >= PATIENCE && !squaring && !loses_zones) {
            // Only the obstacle problem shows a zone that is too small for the energy.
            let has_these_zones = || {
                let zones = obstacle::contact(&found.deflection());
                distance(&intervals, &positions(&found.mesh, &zones, &places)) <= LOCAL * l
            };
            if by_scan || has_these_zones() {
                let gap = judge(&found);
                if (converged && by_scan) || gap <= enough {
                    return Ok(ContactState { history, ..found });
                }
            }
            // If edge Newton stalls, fall back to the scan.
            edge_phase &= by_scan;
        }
        let from_own_start = most_steps > NEAR_STEPS && step > 0;
        if from_own_start
            && step.is_multiple_of(WALKING)
            && let Some(found) = corner::on_a_corner(bonded, &found, &next)
            && judge(&found) <= LAST
        {
            return Ok(ContactState { history, ..found });
        }
        if from_own_start
            && no_progress > 0
            && no_progress.is_multiple_of(WALKING)
            && let Some(start) = without_the_weakest(bonded, &found, &next)
            && let Ok(found) =
                refine(bonded, InitialGuess::of_contact_set(start), Goal::Answer(NEAR_STEPS), judge)
        {
            return Ok(ContactState { history, ..found });
        }
        // Full steps while the move halves. After the first that does not, use the line search, except for quadratic
        // steps. The first step of a warm start is exempt.
        let first_of_near = step == 0 && most_steps == NEAR_STEPS;
        if !(first_of_near || halved && (before.is_finite() || step < 2)) {
            non_quadratic += 1;
        }
        full_step = non_quadratic == 0 || (non_quadratic <= MOST_STRAYS && squaring);
        let mut between = None;
        if !full_step && moved > LOCAL {
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
    match last.filter(|found| judge(found) <= ENOUGH) {
        Some(found) => Ok(ContactState { history, ..Rc::unwrap_or_clone(found) }),
        None => Err(edges_not_converged(most_steps, moved)),
    }
}

/// The beam bonded without its weakest zones, if its contact set is the remaining zones.
///
/// Each step moves an edge by at most one wave length. Beyond the last load of a long beam, spurious zones, each a
/// thousand times weaker than the one before, would disappear only one per step.
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
        let found = bonded.solve_on(&strong, None).ok()?;
        let zones = obstacle::contact(&found.deflection());
        let moved = distance(&strong, &positions(&found.mesh, &zones, &[]));
        (moved <= STILL * bonded.model.beam.length).then_some(ContactState { zones, ..found })
    })
}
