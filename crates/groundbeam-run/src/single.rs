//! Solves one model, such as a combination with a train at one position, and returns the answer with its label.

use crate::answer::{Answer, Found, Ground, Label};
use crate::host::Host;
use groundbeam::{Error, Options, Solution, solve_near};

/// Solves the model of `label` with the bearing width `width`. The iteration starts from the solution `near` if given.
pub(crate) fn answered(
    label: Label,
    width: Option<f64>,
    options: &Options,
    near: Option<&Solution>,
    host: &impl Host,
) -> Result<Answer, Error> {
    let started = host.seconds();
    let model = label.model();
    let found = Found::of(solve_near(&model, options, near))?;
    let ground = Ground::solved(&model, width, &found);
    drop(model);
    Ok(Answer { label, found, ground, factors: None, seconds: host.seconds() - started })
}
