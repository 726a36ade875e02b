//! Writes the solution as piecewise polynomials, which are the input of the proof.

use super::bounds::JudgedCheck;
use super::{Along, ByName};
use crate::checked::judged;
use crate::context::Context;
use crate::quantity::Units;
use crate::text::proof::reason;
use crate::verified::Named;
use groundbeam::proof::{Answer, Force, Piece, PlacedExtreme, Verification};
use groundbeam::{
    Field, Solution,
    solution::{Fields, Side},
};
use groundbeam_file::{UnitSystem, write_toml};
use serde::Serialize;
use std::collections::BTreeMap;

/// Piecewise polynomials and point contact forces of a solution, with its proven statements.
#[derive(Serialize)]
pub(super) struct Claimed {
    #[serde(skip_serializing_if = "Option::is_none")]
    model: Option<String>,
    pieces: Vec<Stretch>,
    forces: Vec<Concentrated>,
    #[serde(skip_serializing_if = "Along::is_empty")]
    left_of_jumps: Along<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    proof: Option<Proof>,
}

/// Polynomials of the fields between two positions. The variable is the distance from the middle, divided by half the
/// distance between the positions.
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
    /// Returns the pieces of the solution, and the fields just left of those positions in `positions` where a
    /// field jumps.
    pub fn of(solution: &Solution, positions: &[f64], context: &Context) -> Self {
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
            left_of_jumps: left_of_jumps(solution, positions),
            proof: context.proofs.first().map(|named| Proof::of(named, solution, context)),
        }
    }
}

/// Returns the positions at which a field jumps, and the values of all fields just to the left of each of these
/// positions.
fn left_of_jumps(solution: &Solution, positions: &[f64]) -> Along<Vec<f64>> {
    let both = positions.iter().map(|&x| (x, [Side::Left, Side::Right].map(|s| solution.at(x, s))));
    let inside = |x: f64| x > 0.0 && x < solution.model().beam.length;
    let differ = |[left, right]: &[Fields; 2]| {
        Field::ALL.iter().any(|&field| left.get(field) != right.get(field))
    };
    let jumps = both.filter(|(x, fields)| inside(*x) && differ(fields));
    let (x, fields) = jumps.map(|(x, [left, _])| (x, left)).unzip();
    Along::fields_at(solution, x, fields)
}

/// Writes the solved model as a model file. The ground is written as constants k and μ, and the loads include
/// all their factors.
fn model_file(solution: &Solution, units: Units) -> String {
    let mut model = solution.model().clone();
    model.foundation.soil = None;
    let units = if units.is_plain() { UnitSystem::Plain } else { UnitSystem::Si };
    write_toml(&model, None, units)
}

/// The proven statements about the solution.
#[derive(Serialize)]
pub(super) struct Proof {
    /// `proven`, or the first reason why the solution is not proven.
    statement: String,
    scalar: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    energy: Option<f64>,
    /// Error bounds by quantity. A field has one bound. Any other quantity has one bound for each of its
    /// numbers, in the order of the document. A missing bound is written as `null`.
    bounds: BTreeMap<&'static str, Errors>,
    /// Intervals that contain all exact positions of the extremes of each field. A field without such
    /// intervals is omitted.
    #[serde(skip_serializing_if = "ByName::is_empty")]
    places: ByName<Places>,
    /// Design checks, each with the error bound of its value and the resulting judgement. A missing bound is
    /// written as `null`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    checks: Vec<JudgedCheck>,
    /// Reason why a quantity has no error bound, by name of the quantity.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    not_proven: BTreeMap<&'static str, String>,
    exists: bool,
    unique: bool,
}

/// One error bound of a field, or one error bound for each number of a quantity that is not a field.
#[derive(Serialize)]
#[serde(untagged)]
enum Errors {
    Field(f64),
    Numbers(Vec<f64>),
}

/// Intervals that contain the positions of the smallest and of the largest value.
#[derive(Serialize)]
struct Places {
    #[serde(skip_serializing_if = "Vec::is_empty")]
    min: Vec<[f64; 2]>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    max: Vec<[f64; 2]>,
}

impl Places {
    fn of(named: &Named) -> ByName<Self> {
        let found = named.found.as_ref().map_or(&[][..], |found| &found.extremes);
        let of = |field: Field, is_max: bool| {
            let same = |e: &&PlacedExtreme| e.field == field.name() && e.is_max == is_max;
            found.iter().find(same).map_or_else(Vec::new, |extreme| extreme.places.clone())
        };
        let shown = Field::ALL
            .into_iter()
            .filter(|&field| found.iter().any(|e| e.field == field.name() && !e.places.is_empty()));
        ByName::of(shown, |field| Places { min: of(field, false), max: of(field, true) })
    }
}

impl Proof {
    pub fn of(named: &Named, solution: &Solution, context: &Context) -> Self {
        let (why, found) = (named.shortfall(), named.found.as_ref().ok());
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
            places: Places::of(named),
            checks: judged(context.limits, solution, Some(named))
                .iter()
                .map(|judged| JudgedCheck::of(judged, None))
                .collect(),
            not_proven: infinite.into_iter().map(|(name, _)| (name, without.clone())).collect(),
        }
    }
}
