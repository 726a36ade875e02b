//! Computes the positions of a train at which the equilibrium is lost.

use super::position::first_positions;
use groundbeam::model::Train;
use groundbeam::{Error, Model, exists};

/// Number of bisection steps, one for each bit of the mantissa of a double.
const HALVINGS: usize = 52;

/// Returns the ranges of first-axle positions without equilibrium. `found` lists positions from left to right, each
/// with the existence of an equilibrium.
pub(super) fn without_equilibrium(
    model: &Model,
    train: &Train,
    found: impl Iterator<Item = (f64, bool)>,
) -> Vec<[f64; 2]> {
    let mut ranges: Vec<[f64; 2]> = Vec::new();
    let mut before: Option<(f64, bool)> = None;
    for (at, stands) in found {
        let stood = before.is_none_or(|(_, stood)| stood);
        let edge = |stands: f64, falls: f64| edge(model, train, stands, falls);
        match (stood, stands, before, ranges.last_mut()) {
            (true, false, None, _) => ranges.push([at, at]),
            (true, false, Some((before, _)), _) => ranges.push([edge(before, at), at]),
            (false, true, Some((before, _)), Some(last)) => last[1] = edge(at, before),
            (false, false, _, Some(last)) => last[1] = at,
            _ => {}
        }
        before = Some((at, stands));
    }
    ranges
}

/// Number of equal steps between two neighbouring [`first_positions`] for the existence checks.
const PARTS: usize = 8;

/// Returns the ranges of first-axle positions without equilibrium. Checks the [`first_positions`] and equidistant
/// positions between them.
///
/// # Errors
///
/// Returns the errors of [`exists`].
pub(crate) fn checked(
    model: &Model,
    train: &Train,
    range: [f64; 2],
) -> Result<Vec<[f64; 2]>, Error> {
    let first = first_positions(model, train, range);
    let parts = first.windows(2).flat_map(|ends| {
        let step = (ends[1] - ends[0]) / PARTS as f64;
        (0..PARTS).map(move |i| ends[0] + step * i as f64)
    });
    let mut found = Vec::new();
    for at in parts.chain(first.last().copied()) {
        let existence = exists(&train.on(model, at))?;
        found.push((at, existence.verdict.stands()));
    }
    Ok(without_equilibrium(model, train, found.into_iter()))
}

/// Position of the boundary between the positions with an equilibrium and the positions without an equilibrium.
fn edge(model: &Model, train: &Train, mut stands: f64, mut falls: f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (stands + falls);
        let found = exists(&train.on(model, middle));
        match found {
            Ok(existence) if !existence.verdict.stands() => falls = middle,
            _ => stands = middle,
        }
    }
    falls
}
