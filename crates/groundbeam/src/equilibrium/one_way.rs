//! Finds the set of active one-way supports by solving models with fixed sets of active supports.
//!
//! A rigid support that only pushes up requires w ≤ 0 and a reaction R ≥ 0 with R w = 0. A hold-down requires
//! the same conditions with opposite signs. For an elastic support, the clearance between the beam and its
//! spring replaces w. All of these are the conditions for a minimum of a convex energy under inequality
//! constraints. The active-set method for quadratic programs finds this minimum (Nocedal and Wright,
//! *Numerical Optimization*, 2nd ed., section 16.5):
//!
//! 1. Solve beam and ground with the active supports, as if these were two-way.
//! 2. On the straight path from the previous deflection to the new one, stop where the beam first meets an
//!    inactive support. This support becomes active. Go to 1.
//! 3. Otherwise, if an active support has a force of the wrong sign, it becomes inactive. Go to 1.
//! 4. Otherwise this is the solution: all conditions hold, and they are sufficient.
//!
//! The energy never increases, because it is convex along the path and the end of the path is its minimum for
//! the active supports. Whenever step 3 occurs again with other supports, the energy has strictly decreased. So
//! no set occurs twice, and the number of sets is finite. Step 2 repeats at most as often as there are
//! supports.
//!
//! If no equilibrium exists on the active supports, the path is the rigid motion that proves this. The path
//! ends at a hold-down, unless no equilibrium exists on all supports together.

use crate::existence::verdict::{Existence, Verdict};
use crate::model::{Model, Support};
use crate::outcome::Outcome;
use crate::solution::candidate::Candidate;
use crate::solution::fields::Side;
use crate::solution::solution::Solution;

/// Maximum number of solves. The limit ends cycles that rounding error causes.
const MOST_SOLVES: usize = 1000;
/// Up to this number of solves, the support with the largest force of the wrong sign becomes inactive. In later
/// solves, the first support with a force of the wrong sign becomes inactive, which ends cycles of steps of
/// zero length.
const WORST_FIRST_SOLVES: usize = 50;
/// A force below this fraction of the sum of all reactions counts as zero. A clearance below this fraction of the
/// largest deflection counts as zero too.
const FORCE_ROUNDING: f64 = 1e-13;

/// Solves a model with one-way supports by a method for models without one-way supports. Returns the solution
/// with its active supports, and the number of solves. The solution is missing if the search does not end.
pub(crate) fn solve<E>(
    model: &Model,
    mut solve: impl FnMut(&Model) -> Result<Outcome, E>,
) -> Result<SupportSearch, E> {
    let supports = &model.supports;
    let mut acts = vec![true; supports.len()];
    // Clearance of each support. It is 0 for an active support.
    let mut clear = vec![0.0; supports.len()];
    for step in 1..=MOST_SOLVES {
        let now = model.with_supports_that(|i, _| acts[i]);
        let outcome = solve(&now)?;
        let free = |i: &usize| supports[*i].is_one_way() && !acts[*i];
        // `towards` contains the clearances of the new deflection. If no equilibrium exists, it contains the
        // rates of the clearances in a rigid motion.
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

/// The result of the search for the active supports.
pub(crate) struct SupportSearch {
    /// The solution and its active supports; `None` if the search found no solution.
    pub found: Option<(Box<Solution>, Vec<bool>)>,
    /// Number of solves, each with a given set of active supports.
    pub solves: usize,
}

/// Returns the clearance of each support, and the largest deflection \[m\]. A clearance within rounding error
/// is 0.
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

/// Returns the force of each support in its permitted direction, and the sum of the absolute values of all
/// reactions \[N\]. The force of an inactive support is 0. `candidate` is the solution on the active supports.
pub(crate) fn forces(model: &Model, acts: &[bool], candidate: &Candidate) -> (Vec<f64>, f64) {
    let mut reactions = candidate.reactions.iter();
    let all: f64 = candidate.reactions.iter().map(|reaction| reaction.force.abs()).sum();
    let each = model.supports.iter().zip(acts).map(|(support, acts)| {
        let reaction = if *acts { reactions.next() } else { None };
        reaction.map_or(0.0, |reaction| support.acts.sign() * reaction.force)
    });
    (each.collect(), all)
}

/// Returns whether each support is active in a solution. A support is active if it carries a force or is a
/// two-way support.
pub(crate) fn acting(model: &Model, candidate: &Candidate) -> Vec<bool> {
    let (forces, all) = forces(model, &vec![true; model.supports.len()], candidate);
    let pushes = forces.iter().map(|force| *force > FORCE_ROUNDING * all);
    model.supports.iter().zip(pushes).map(|(s, pushes)| pushes || !s.is_one_way()).collect()
}

/// Returns whether each support is active in the next solve, from the solution with the active set `acts`.
/// Active supports with a positive force stay active, and inactive supports that the beam penetrates become
/// active. Two-way supports are always active.
pub(crate) fn asked_for(model: &Model, acts: &[bool], candidate: &Candidate) -> Vec<bool> {
    let (forces, all) = forces(model, acts, candidate);
    let (clear, _) = clearances(model, candidate);
    let support = |(i, support): (usize, &Support)| {
        let asked = if acts[i] { forces[i] > FORCE_ROUNDING * all } else { clear[i] < 0.0 };
        !support.is_one_way() || asked
    };
    model.supports.iter().enumerate().map(support).collect()
}
