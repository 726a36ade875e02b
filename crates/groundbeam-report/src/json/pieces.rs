//! The answer piece by piece, as the proof reads it.

use crate::context::Context;
use crate::quantity::Units;
use crate::text::proof::reason;
use crate::verified::Named;
use groundbeam::proof::{Answer, Force, Piece, Verification};
use groundbeam::{Field, Solution};
use groundbeam_file::{UnitSystem, write_toml};
use serde::Serialize;
use std::collections::BTreeMap;

/// Pieces and concentrated forces of a solution.
#[derive(Serialize)]
pub(super) struct Claimed {
    #[serde(skip_serializing_if = "Option::is_none")]
    model: Option<String>,
    pieces: Vec<Stretch>,
    forces: Vec<Concentrated>,
    #[serde(skip_serializing_if = "Option::is_none")]
    proof: Option<Proof>,
}

/// A piece; of t = (x − (x₀ + x₁)/2)/half.
#[derive(Serialize)]
struct Stretch {
    x: [f64; 2],
    half: f64,
    touches: bool,
    deflection: Vec<f64>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    rotation: Vec<f64>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pressure: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    open: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    settlement: Vec<f64>,
}

#[derive(Serialize)]
struct Concentrated {
    x: f64,
    force: f64,
}

impl Claimed {
    pub fn of(solution: &Solution, context: &Context) -> Self {
        let (_, Answer { pieces, forces, .. }) = solution.claim::<f64>();
        let stretch = |piece: Piece| Stretch {
            x: piece.x,
            half: piece.half,
            touches: piece.touches,
            deflection: piece.deflection,
            rotation: piece.rotation,
            pressure: piece.pressure,
            open: piece.open,
            settlement: piece.settlement,
        };
        let concentrated = |Force { x, force }| Concentrated { x, force };
        Claimed {
            pieces: pieces.into_iter().map(stretch).collect(),
            forces: forces.into_iter().map(concentrated).collect(),
            model: context.model.then(|| model_file(solution, context.units)),
            proof: context.proofs.first().map(Proof::of),
        }
    }
}

/// The text of a model file with the model that was solved: its ground by constants, all its loads with their factors.
fn model_file(solution: &Solution, units: Units) -> String {
    let mut model = solution.model().clone();
    model.foundation.soil = None;
    let units = match units {
        Units::Si => UnitSystem::Si,
        Units::Plain => UnitSystem::Plain,
    };
    write_toml(&model, None, units)
}

/// What is proven of the answer.
#[derive(Serialize)]
pub(super) struct Proof {
    /// `proven`, or the first reason why it is not.
    statement: String,
    scalar: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    energy: Option<f64>,
    /// Of each quantity: of a field one, else one for each number in the order of the document, `null` where there is none.
    bounds: BTreeMap<&'static str, Errors>,
    /// Why a quantity has no bound at all.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    not_proven: BTreeMap<&'static str, String>,
    exists: bool,
    unique: bool,
}

/// The bounds of one field, or of several numbers.
#[derive(Serialize)]
#[serde(untagged)]
enum Errors {
    Field(f64),
    Numbers(Vec<f64>),
}

impl Proof {
    pub fn of(named: &Named) -> Self {
        let found = named.found.as_ref();
        let why = found.map_or_else(Some, |found| found.shortfall.as_ref());
        let found = found.ok();
        let errors = found.map(Verification::errors).unwrap_or_default();
        let (finite, infinite): (Vec<_>, Vec<_>) = errors
            .into_iter()
            .partition(|(_, errors)| errors.is_empty() || errors.iter().any(|e| e.is_finite()));
        let without = found.and_then(Verification::without_bound).map(reason).unwrap_or_default();
        let is_field = |name: &str| Field::named(name).is_some();
        let of = |(name, errors): (&'static str, Vec<f64>)| match errors[..] {
            [error] if is_field(name) => (name, Errors::Field(error)),
            _ => (name, Errors::Numbers(errors)),
        };
        Proof {
            statement: why.map_or_else(|| "proven".to_owned(), reason),
            scalar: "wide",
            energy: found.map(|found| found.proof.energy),
            exists: finite.iter().any(|(name, _)| *name == "deflection"),
            unique: found.is_some_and(|found| found.proof.unique.is_ok()),
            bounds: finite.into_iter().map(of).collect(),
            not_proven: infinite.into_iter().map(|(name, _)| (name, without.clone())).collect(),
        }
    }
}
