//! Constructs the fields of a claim for tests, from the texts of a model file and of a document.

#![cfg(test)]

use crate::answer::Answer;
use crate::balance::{Balanced, BalancedPiece};
use crate::fields::Fields;
use crate::given::frame;
use crate::read::read_model;
use crate::scalar::Scalar;
use crate::size::Size;
use crate::wide::Wide;
use serde_json::Value;

/// Constructs the fields of a claim and passes them to the function `of`.
pub(crate) fn with_fields<T>(
    model: &str,
    document: &Value,
    of: impl FnOnce(&mut Fields<Wide>) -> T,
) -> T {
    let model = read_model::<Wide>(model, None).expect("a model");
    let answer = Answer::from_json(&document.to_string()).expect("an answer");
    let frame = frame(&model, &answer, None, &[]).expect("a claim that can be read");
    of(&mut Fields::of(&frame).expect("fields"))
}

/// Returns corrections of zero for the contact pressures, forces and moments, as for a claimed solution in exact
/// equilibrium.
pub(crate) fn balanced(pieces: usize) -> Balanced<Wide> {
    let zero = Wide::zero();
    let piece = BalancedPiece {
        steepness: Size::ZERO,
        moments: [zero; 2],
        shears: [zero; 2],
        added: [Size::ZERO; 2],
        drawn: Size::ZERO,
    };
    Balanced {
        cuts: vec![0, pieces],
        carrier: 0.0,
        factors: vec![zero; pieces + 1],
        pieces: vec![piece; pieces],
    }
}
