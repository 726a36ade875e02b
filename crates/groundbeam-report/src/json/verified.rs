//! Writes the proven statements about a result document as a JSON document.

use super::text;
use crate::verified::{ModelOf, Named, Verified};
use groundbeam::proof::{Bound, PlacedExtreme, Verification};
use serde::Serialize;
use std::collections::BTreeMap;

/// Returns the document that `groundbeam verify` prints.
pub fn verified(verified: &Verified) -> String {
    text(&Document {
        status: match (verified.is_proven(), verified.is_of_document()) {
            (false, _) => "not-proven",
            (true, false) => "proven",
            (true, true) => "proven-for-the-model-in-the-document",
        },
        units: verified.units.name(),
        other_model: verified.other_model.as_deref(),
        left_out: verified
            .left_out
            .as_ref()
            .map(|left_out| Missing { all: left_out.all, names: &left_out.names }),
        results: verified.results.iter().map(Of::new).collect(),
    })
}

#[derive(Serialize)]
struct Document<'a> {
    status: &'static str,
    units: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    other_model: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    left_out: Option<Missing<'a>>,
    results: Vec<Of<'a>>,
}

/// Number of combinations in the model file, and names of the combinations that the document omits.
#[derive(Serialize)]
struct Missing<'a> {
    all: usize,
    names: &'a [String],
}

#[derive(Serialize)]
struct Of<'a> {
    combination: Option<&'a str>,
    proven: bool,
    /// Origin of the model that the proof uses: `file` or `document`.
    model: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    energy: Option<f64>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    bounds: BTreeMap<&'static str, Pair>,
    /// Error bounds of contact edges, forces and reactions, with one bound for each number in the order of
    /// the document.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    each: BTreeMap<&'static str, Vec<f64>>,
    /// For each listed extreme, the intervals that contain its exact positions.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    places: Vec<Place<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    checked: Option<Checked>,
    not_covered: Vec<&'a str>,
}

/// Error bound of a quantity, and the reference value with which the error bound is compared. An infinite error
/// bound is written as `null`.
#[derive(Serialize)]
struct Pair {
    error: f64,
    scale: f64,
}

/// Intervals that are proven to contain the positions of an extreme; empty if no interval is proven.
#[derive(Serialize)]
struct Place<'a> {
    field: &'a str,
    extreme: &'static str,
    listed: f64,
    places: &'a [[f64; 2]],
}

#[derive(Serialize)]
struct Checked {
    stations: usize,
    values: usize,
    at_edges: usize,
    extremes: usize,
    regions: usize,
    forces: usize,
    reactions: usize,
    bounds: usize,
}

impl<'a> Of<'a> {
    fn new(named: &'a Named) -> Self {
        let (why, found) = (named.shortfall(), named.found.as_ref().ok());
        let pair = |(name, Bound { error, scale })| (name, Pair { error, scale });
        let bounds = found.map(Verification::named).unwrap_or_default();
        Of {
            combination: named.combination.as_deref(),
            proven: named.is_proven(),
            model: match named.model {
                ModelOf::File => "file",
                ModelOf::Document => "document",
            },
            reason: why.map(crate::text::proof::reason),
            energy: found.map(|found| found.proof.energy),
            bounds: bounds.into_iter().map(pair).collect(),
            each: found
                .map(Verification::errors_of_numbers)
                .unwrap_or_default()
                .into_iter()
                .collect(),
            places: found.map_or_else(Vec::new, |found| {
                let place = |extreme: &'a PlacedExtreme| Place {
                    field: &extreme.field,
                    extreme: if extreme.is_max { "max" } else { "min" },
                    listed: extreme.listed,
                    places: &extreme.places,
                };
                found.extremes.iter().map(place).collect()
            }),
            checked: found.map(|found| Checked {
                stations: found.checked.stations,
                values: found.checked.values,
                at_edges: found.checked.at_edges,
                extremes: found.checked.extremes,
                regions: found.checked.regions,
                forces: found.checked.forces,
                reactions: found.proof.reactions.len(),
                bounds: found.checked.bounds,
            }),
            not_covered: found
                .map(|found| found.not_covered.iter().map(String::as_str).collect())
                .unwrap_or_default(),
        }
    }
}
