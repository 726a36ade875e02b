//! Finds the set of active one-way supports by solving models with fixed sets of active supports.
//!
//! The active-set method for quadratic programs minimises the convex energy (Nocedal and Wright, *Numerical
//! Optimization*, 2nd ed., section 16.5). Its steps, and the reason why it ends, are under *One-way supports* in
//! `docs/methods.md`.

use crate::existence::verdict::{Existence, Verdict};
use crate::model::{Model, Support};
use crate::outcome::Outcome;
use crate::solution::candidate::Candidate;
use crate::solution::fields::Side;
use crate::solution::solution::Solution;

/// Maximum number of solves. The limit ends cycles that rounding error causes.
const MOST_SOLVES: usize = 1000;
/// After this number of solves, the first support with a force of the wrong sign becomes inactive instead of the worst
/// one. This is Bland's rule against cycles of steps of zero length.
const WORST_FIRST_SOLVES: usize = 50;
/// A force below this fraction of the sum of all reactions counts as zero. A clearance below this fraction of the
/// largest deflection counts as zero too.
const FORCE_ROUNDING: f64 = 1e-13;

/// Solves a model with one-way supports, by solves with fixed active supports. The result has no solution if the search
/// finds none.
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

/// Returns the force of each support in its permitted direction, and the sum of all absolute reactions \[N\].
/// `candidate` must be the solution on the active supports `acts`.
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

/// Returns the active supports of the next solve. Active supports with a positive force stay active. Inactive supports
/// that the beam penetrates become active.
pub(crate) fn asked_for(model: &Model, acts: &[bool], candidate: &Candidate) -> Vec<bool> {
    let (forces, all) = forces(model, acts, candidate);
    let (clear, _) = clearances(model, candidate);
    let support = |(i, support): (usize, &Support)| {
        let asked = if acts[i] { forces[i] > FORCE_ROUNDING * all } else { clear[i] < 0.0 };
        !support.is_one_way() || asked
    };
    model.supports.iter().enumerate().map(support).collect()
}
