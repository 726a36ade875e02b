//! Where along its way a train leaves the beam without an equilibrium.

use super::Train;
use super::sweep::{Answer, Position};
use crate::model::Model;
use crate::solve::exists;

/// Halvings of an interval: as many as a number has digits.
const HALVINGS: usize = 52;

/// Ranges of the first axle's position at which there is no equilibrium, from left to right.
pub(super) fn without_equilibrium(
    model: &Model,
    train: &Train,
    found: &[Position],
) -> Vec<[f64; 2]> {
    let mut ranges: Vec<[f64; 2]> = Vec::new();
    let mut before: Option<&Position> = None;
    for position in found {
        let is_none = matches!(position.answer, Answer::NoEquilibrium(_));
        let was_none = before.is_some_and(|p| matches!(p.answer, Answer::NoEquilibrium(_)));
        let at = position.first_axle;
        let edge = |stands: f64, falls: f64| edge(model, train, stands, falls);
        match (was_none, is_none, before) {
            (false, true, None) => ranges.push([at, at]),
            (false, true, Some(before)) => ranges.push([edge(before.first_axle, at), at]),
            (true, false, Some(before)) => {
                if let Some(last) = ranges.last_mut() {
                    last[1] = edge(at, before.first_axle);
                }
            }
            (true, true, _) => {
                if let Some(last) = ranges.last_mut() {
                    last[1] = at;
                }
            }
            _ => {}
        }
        before = Some(position);
    }
    ranges
}

/// The edge between a position with and one without an equilibrium.
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
