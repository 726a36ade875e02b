//! One model solved: on the ground that is given, or on the ground that its soil makes.

use crate::answer::{Answer, Found, Ground, Label};
use crate::host::Host;
use groundbeam::soil::Bed;
use groundbeam::{Error, Existence, Method, Model, Options, Outcome, Solution, Solver, solve_near};

/// Solves the model of a label, on the soil of its combination where it has one. `width` is that on which the beam
/// bears; `near` is a solution to begin from.
pub(crate) fn answered(
    label: Label,
    width: Option<f64>,
    options: &Options,
    near: Option<&Solution>,
    host: &impl Host,
) -> Result<Answer, Error> {
    let started = host.seconds();
    let model = label.model();
    let (outcome, ground) = match &label.combination.bed {
        None => {
            let ground = width.and_then(|width| Ground::of_area(&model.foundation, width));
            (solve_near(&model, options, near), ground)
        }
        Some(bed) => match bed.solve(&model, options) {
            Ok(found) => {
                let ground = Ground::of(bed, &found);
                (Ok(found.outcome), Some(ground))
            }
            Err(error) => (Err(error), None),
        },
    };
    let found = Found::of(outcome)?;
    let ground = ground.filter(|_| !matches!(found, Found::NotConverged(_)));
    drop(model);
    Ok(Answer { label, found, ground, factors: None, seconds: host.seconds() - started })
}

/// What was found for one of many models.
#[derive(Debug)]
pub enum Repeated<'s> {
    /// An equilibrium, in the memory of the solver.
    InMemory(&'s Solution),
    /// An equilibrium in memory of its own.
    Equilibrium(Box<Solution>),
    /// No equilibrium exists.
    NoEquilibrium(Existence),
}

/// Solves one of many models, in the memory of the solver where the method allows it. The bits do not depend on the
/// model before.
///
/// # Errors
///
/// As [`groundbeam::solve_with`].
pub fn repeated<'s>(
    bed: Option<&Bed>,
    model: &Model,
    options: &Options,
    solver: &'s mut Solver,
) -> Result<Repeated<'s>, Error> {
    let outcome = match bed {
        Some(bed) => bed.solve(model, options)?.outcome,
        None if options.method == Method::Exact => {
            return Ok(match solver.solve(model)? {
                groundbeam::Answer::Equilibrium(solution) => Repeated::InMemory(solution),
                groundbeam::Answer::NoEquilibrium(existence) => Repeated::NoEquilibrium(existence),
            });
        }
        None => solve_near(model, options, None)?,
    };
    Ok(match outcome {
        Outcome::Equilibrium(solution) => Repeated::Equilibrium(solution),
        Outcome::NoEquilibrium(existence) => Repeated::NoEquilibrium(existence),
    })
}
