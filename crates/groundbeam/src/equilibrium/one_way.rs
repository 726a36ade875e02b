//! The set of active one-way supports, by solves with fixed sets.
//!
//! A rigid support that only pushes up requires w ≤ 0 and a reaction R ≥ 0 with R w = 0. A hold-down requires
//! the same with opposite signs. For an elastic support, the clearance between the beam and its spring takes
//! the place of w. These are constraints of a convex energy. They are satisfied by the active-set method for
//! quadratic programs (Nocedal and Wright, *Numerical Optimization*, 2nd ed., section 16.5):
//!
//! 1. Solve beam and ground with the active supports, as if these were two-way.
//! 2. On the straight path from the previous deflection to the new one, stop where the beam first meets an
//!    inactive support. This support becomes active. Go to 1.
//! 3. Otherwise, if an active support has a force of the wrong sign, it becomes inactive. Go to 1.
//! 4. Otherwise this is the solution: all conditions hold, and they are sufficient.
//!
//! The energy never increases: it is convex along the path, and the end of the path is its minimum for the
//! active supports. It has strictly decreased when step 3 occurs again with other supports. So no set occurs
//! twice, and the number of sets is finite. Step 2 repeats at most as often as there are supports. If no
//! equilibrium exists on the active supports, the path is the rigid motion that proves this. The path ends at
//! a hold-down, unless no equilibrium exists on all supports together.

use crate::existence::verdict::{Existence, Verdict};
use crate::model::{Model, Support};
use crate::outcome::Outcome;
use crate::solution::candidate::Candidate;
use crate::solution::fields::Side;
use crate::solution::solution::Solution;

/// Maximum number of solves; it ends cycles that rounding error causes.
const MOST_SOLVES: usize = 1000;
/// Number of solves after which the worst support that violates its condition changes. Later the first one changes,
/// which ends cycles of steps of zero length.
const WORST_FIRST_SOLVES: usize = 50;
/// Rounding error of a force, relative to the sum of all reactions, and of a clearance, relative to the
/// largest deflection.
const FORCE_ROUNDING: f64 = 1e-13;

/// Solves a model with one-way supports by a method for models without them. Returns the solution, the set of
/// active supports, and the number of solves; no solution if the search does not end.
pub(crate) fn solve<E>(
    model: &Model,
    mut solve: impl FnMut(&Model) -> Result<Outcome, E>,
) -> Result<SupportSearch, E> {
    let supports = &model.supports;
    let mut acts = vec![true; supports.len()];
    // The clearance of each support, 0 where it is active.
    let mut clear = vec![0.0; supports.len()];
    for step in 1..=MOST_SOLVES {
        let now = model.with_supports_that(|i, _| acts[i]);
        let outcome = solve(&now)?;
        let free = |i: &usize| supports[*i].is_one_way() && !acts[*i];
        // The clearances at the end of the path, or their rates if the path is a free motion without end.
        let (towards, solution) = match outcome {
            Outcome::Equilibrium(solution) => {
                (clearances(model, solution.candidate()).0, Some(solution))
            }
            Outcome::NoEquilibrium(Existence { verdict: Verdict::None(motion), .. }) => {
                let rate = |i: usize| -supports[i].acts.sign() * motion.at(&now, supports[i].at);
                ((0..supports.len()).map(rate).collect::<Vec<f64>>(), None)
            }
            Outcome::NoEquilibrium(_) => return Ok(SupportSearch { found: None, solves: step }),
        };
        let endless = solution.is_none();
        let part = |i: usize| {
            let fall = if endless { -towards[i] } else { clear[i] - towards[i] };
            clear[i] / fall
        };
        let meets = (0..supports.len()).filter(free).filter(|i| towards[*i] < 0.0);
        if let Some(first) = meets.min_by(|a, b| part(*a).total_cmp(&part(*b))) {
            let t = part(first);
            for i in (0..supports.len()).filter(free) {
                clear[i] += t * if endless { towards[i] } else { towards[i] - clear[i] };
            }
            (acts[first], clear[first]) = (true, 0.0);
            continue;
        }
        let Some(solution) = solution else {
            return Ok(SupportSearch { found: None, solves: step });
        };
        for i in (0..supports.len()).filter(free) {
            clear[i] = towards[i];
        }
        let (forces, all) = forces(model, &acts, solution.candidate());
        let pushes = |i: &usize| forces[*i];
        let wrong =
            |i: &usize| supports[*i].is_one_way() && acts[*i] && pushes(i) < -FORCE_ROUNDING * all;
        let mut wrong = (0..supports.len()).filter(wrong);
        let released = if step > WORST_FIRST_SOLVES {
            wrong.next()
        } else {
            wrong.min_by(|a, b| pushes(a).total_cmp(&pushes(b)))
        };
        match released {
            Some(i) => acts[i] = false,
            None => return Ok(SupportSearch { found: Some((solution, acts)), solves: step }),
        }
    }
    Ok(SupportSearch { found: None, solves: MOST_SOLVES })
}

/// The result of the search.
pub(crate) struct SupportSearch {
    /// The solution and its active supports; `None` if the set of active supports still changes.
    pub found: Option<(Box<Solution>, Vec<bool>)>,
    /// Number of solves with fixed supports.
    pub solves: usize,
}

/// The clearance of each support, 0 where it is rounding error, and the largest deflection.
pub(crate) fn clearances(model: &Model, candidate: &Candidate) -> (Vec<f64>, f64) {
    let range = candidate.range(crate::Field::Deflection);
    let size = range.min.value.abs().max(range.max.value.abs());
    let clearance = |support: &Support| {
        let w = candidate.at(support.at, Side::Right).deflection - support.settlement;
        let clearance = -support.acts.sign() * w;
        if clearance.abs() <= FORCE_ROUNDING * size { 0.0 } else { clearance }
    };
    (model.supports.iter().map(clearance).collect(), size)
}

/// The force of each active support in its permitted direction, from the solution with these supports, and
/// the sum of all reactions.
pub(crate) fn forces(model: &Model, acts: &[bool], candidate: &Candidate) -> (Vec<f64>, f64) {
    let mut reactions = candidate.reactions.iter();
    let all: f64 = candidate.reactions.iter().map(|reaction| reaction.force.abs()).sum();
    let each = model.supports.iter().zip(acts).map(|(support, acts)| {
        let reaction = if *acts { reactions.next() } else { None };
        reaction.map_or(0.0, |reaction| support.acts.sign() * reaction.force)
    });
    (each.collect(), all)
}

/// The supports that carry force in a solution; two-way supports always count.
pub(crate) fn acting(model: &Model, candidate: &Candidate) -> Vec<bool> {
    let (forces, all) = forces(model, &vec![true; model.supports.len()], candidate);
    let pushes = forces.iter().map(|force| *force > FORCE_ROUNDING * all);
    model.supports.iter().zip(pushes).map(|(s, pushes)| pushes || !s.is_one_way()).collect()
}

/// The active supports that follow from the solution with a given active set: the active supports with a
/// positive force, and the inactive ones that the beam penetrates. A support without force is inactive.
pub(crate) fn asked_for(model: &Model, acts: &[bool], candidate: &Candidate) -> Vec<bool> {
    let (forces, all) = forces(model, acts, candidate);
    let (clear, _) = clearances(model, candidate);
    let support = |(i, support): (usize, &Support)| {
        let asked = if acts[i] { forces[i] > FORCE_ROUNDING * all } else { clear[i] < 0.0 };
        !support.is_one_way() || asked
    };
    model.supports.iter().enumerate().map(support).collect()
}
