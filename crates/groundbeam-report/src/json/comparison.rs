//! The answers of several methods to one model, as a document.

use crate::comparison::{Compared, Comparison, Errors};
use crate::context::Context;
use groundbeam::{Error, Solution};
use serde::Serialize;

#[derive(Serialize)]
struct Document<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    title: Option<String>,
    units: &'static str,
    methods: Vec<Row<'a>>,
}

#[derive(Serialize)]
struct Row<'a> {
    method: &'a str,
    status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    errors: Option<Relative>,
    #[serde(skip_serializing_if = "Option::is_none")]
    relative_gap: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    elements: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    iterations: Option<usize>,
    seconds: f64,
}

#[derive(Serialize)]
struct Relative {
    deflection: f64,
    moment: f64,
    settlement: f64,
    end_forces: f64,
}

/// The document of a comparison.
pub fn comparison(comparison: &Comparison, context: &Context) -> String {
    let exact = comparison.exact;
    let mut methods = vec![solved("exact", exact, None, comparison.seconds)];
    methods.extend(comparison.others.iter().map(
        |&Compared { name, answer, seconds }| match answer {
            Ok(solution) => solved(name, solution, Some(Errors::of(solution, exact)), seconds),
            Err(error) => refused(name, error, seconds),
        },
    ));
    super::text(&Document { title: context.clean_title(), units: context.units.name(), methods })
}

fn refused<'a>(method: &'a str, error: &Error, seconds: f64) -> Row<'a> {
    let (status, iterations) = match error {
        Error::NotConverged(reached) => ("not-converged", Some(reached.iterations)),
        _ => ("not-for-this-model", None),
    };
    Row { method, status, errors: None, relative_gap: None, elements: None, iterations, seconds }
}

fn solved<'a>(
    method: &'a str,
    solution: &Solution,
    errors: Option<Errors>,
    seconds: f64,
) -> Row<'a> {
    let errors = errors.map(|Errors { deflection, moment, settlement, end_forces }| Relative {
        deflection,
        moment,
        settlement,
        end_forces,
    });
    Row {
        method,
        status: "solved",
        errors,
        relative_gap: Some(solution.certificate().relative_gap()),
        elements: Some(solution.elements()),
        iterations: Some(solution.iterations()),
        seconds,
    }
}
