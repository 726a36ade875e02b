//! Solves models that must have an equilibrium.

use groundbeam::{Model, Options, Outcome, Solution, solve_with};

/// Solves a model by the exact method. Panics if it has no equilibrium or is not solved.
#[track_caller]
pub fn solved(model: &Model) -> Solution {
    solved_by(model, &Options::default())
}

/// Solves a model by the method of the options. Panics if it has no equilibrium or is not solved.
#[track_caller]
pub fn solved_by(model: &Model, options: &Options) -> Solution {
    match solve_with(model, options) {
        Ok(Outcome::Equilibrium(solution)) => *solution,
        other => panic!("{other:?}: {model:?}"),
    }
}
