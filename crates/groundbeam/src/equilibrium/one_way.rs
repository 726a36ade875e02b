//! The set of active one-way supports, by solves with fixed sets.
//!
//! A bearing that only pushes up asks for w ≤ 0 and a reaction R ≥ 0 with R w = 0; a hold-down for the
//! same with other signs; an elastic one for the same of the clearance between the beam and its spring. These are
//! constraints of a convex energy, and they are met as in the active-set method for quadratic programs (Nocedal
//! and Wright, *Numerical Optimization*, 2nd ed., section 16.5):
//!
//! 1. Solve the beam, ground and all, on the supports that act now, as if they acted in both directions.
//! 2. On the straight way from the deflection before to that one, stop where the beam first meets a support
//!    that does not act: from there on that one acts too. Go to 1.
//! 3. Else, if a support that acts would have to act the other way, it no longer does. Go to 1.
//! 4. Else this is the answer: all conditions hold, and they are sufficient.
//!
//! The energy never rises, for all the way it is convex and the deflection at its end is the least on the supports
//! that act. It falls strictly before step 3 is reached again with other supports: none comes twice, and there are
//! finitely many. Step 2 repeats at most as often as there are supports. Where the supports that act leave no
//! equilibrium the way is the motion that proves it; it ends at a hold-down, since all of them together leave none.

use crate::existence::verdict::{Existence, Verdict};
use crate::model::{Model, Support};
use crate::outcome::Outcome;
use crate::solution::candidate::Candidate;
use crate::solution::fields::Side;
use crate::solution::solution::Solution;

/// Solves that end the search, on supports that rounding makes act and not act in turn.
const MOST_SOLVES: usize = 1000;
/// After so many, the first of several supports goes and not the worst, which ends rows of steps of no length.
const PATIENCE: usize = 50;
/// A force the wrong way, relative to all reactions, and a clearance, relative to all deflections, that are rounding.
const ROUNDING: f64 = 1e-13;

/// Solves a model with such supports, by a method for one without. Returns the solution on the supports that act, which
/// supports these are, and the number of solves; no solution if the search does not end.
pub(crate) fn solve<E>(
    model: &Model,
    mut solve: impl FnMut(&Model) -> Result<Outcome, E>,
) -> Result<SupportSearch, E> {
    let supports = &model.supports;
    let mut acts = vec![true; supports.len()];
    // How far the beam is from each, 0 where it acts.
    let mut clear = vec![0.0; supports.len()];
    for step in 1..=MOST_SOLVES {
        let now = model.with_supports_that(|i, _| acts[i]);
        let outcome = solve(&now)?;
        let free = |i: &usize| supports[*i].is_one_way() && !acts[*i];
        // Where the way leads: the clearances at its end, or how they change on it without end.
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
            |i: &usize| supports[*i].is_one_way() && acts[*i] && pushes(i) < -ROUNDING * all;
        let mut wrong = (0..supports.len()).filter(wrong);
        let released = if step > PATIENCE {
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

/// How the search ended.
pub(crate) struct SupportSearch {
    /// The solution on the supports that act, and which supports these are; none if they still change.
    pub found: Option<(Box<Solution>, Vec<bool>)>,
    /// Solves of a model whose supports act in both directions.
    pub solves: usize,
}

/// How far the beam is from each support, 0 where that is rounding, and how large its deflections are.
pub(crate) fn clearances(model: &Model, candidate: &Candidate) -> (Vec<f64>, f64) {
    let range = candidate.range(crate::Field::Deflection);
    let size = range.min.value.abs().max(range.max.value.abs());
    let clearance = |support: &Support| {
        let w = candidate.at(support.at, Side::Right).deflection - support.settlement;
        let clearance = -support.acts.sign() * w;
        if clearance.abs() <= ROUNDING * size { 0.0 } else { clearance }
    };
    (model.supports.iter().map(clearance).collect(), size)
}

/// What each support that acts pushes with in the direction in which it alone may act, from the solution on those that
/// act, and the sum of all reactions.
pub(crate) fn forces(model: &Model, acts: &[bool], candidate: &Candidate) -> (Vec<f64>, f64) {
    let mut reactions = candidate.reactions.iter();
    let all: f64 = candidate.reactions.iter().map(|reaction| reaction.force.abs()).sum();
    let each = model.supports.iter().zip(acts).map(|(support, acts)| {
        let reaction = if *acts { reactions.next() } else { None };
        reaction.map_or(0.0, |reaction| support.acts.sign() * reaction.force)
    });
    (each.collect(), all)
}

/// Which supports push in a solution; those that act in both directions act in any case.
pub(crate) fn acting(model: &Model, candidate: &Candidate) -> Vec<bool> {
    let (forces, all) = forces(model, &vec![true; model.supports.len()], candidate);
    let pushes = forces.iter().map(|force| *force > ROUNDING * all);
    model.supports.iter().zip(pushes).map(|(s, pushes)| pushes || !s.is_one_way()).collect()
}

/// The supports that act by what the solution on those that are said to act shows: of these those that push, of the
/// others those beyond which the beam would lie. One that pushes with nothing holds nothing.
pub(crate) fn asked_for(model: &Model, acts: &[bool], candidate: &Candidate) -> Vec<bool> {
    let (forces, all) = forces(model, acts, candidate);
    let (clear, _) = clearances(model, candidate);
    let support = |(i, support): (usize, &Support)| {
        let asked = if acts[i] { forces[i] > ROUNDING * all } else { clear[i] < 0.0 };
        !support.is_one_way() || asked
    };
    model.supports.iter().enumerate().map(support).collect()
}
