//! Writes the proven statements about a result document as a document.

use super::text;
use crate::verified::{ModelOf, Named, Verified};
use groundbeam::proof::{Bound, PlacedExtreme, Verification};
use serde::Serialize;
use std::collections::BTreeMap;

/// The document of `groundbeam verify`.
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

/// Number of combinations of the file, and those that the document does not contain.
#[derive(Serialize)]
struct Missing<'a> {
    all: usize,
    names: &'a [String],
}

#[derive(Serialize)]
struct Of<'a> {
    combination: Option<&'a str>,
    proven: bool,
    /// `file` or `document`.
    model: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    energy: Option<f64>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    bounds: BTreeMap<&'static str, Pair>,
    /// Bounds of edges, forces and reactions one by one, in the order of the document.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    each: BTreeMap<&'static str, Vec<f64>>,
    /// For each listed extreme, in the order of the fields, the intervals that contain the exact positions.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    places: Vec<Place<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    checked: Option<Checked>,
    not_covered: Vec<&'a str>,
}

/// An error, `null` if it is infinite, and its scale.
#[derive(Serialize)]
struct Pair {
    error: f64,
    scale: f64,
}

/// The proven positions of an extreme; empty if there are none.
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
