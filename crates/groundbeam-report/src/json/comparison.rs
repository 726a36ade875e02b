//! The answers of several methods to one model, as a document.

use crate::context::Context;
use groundbeam::Solution;
use groundbeam_run::{Answer, Answers, Errors, Found};
use serde::Serialize;

#[derive(Serialize)]
struct Document {
    #[serde(skip_serializing_if = "Option::is_none")]
    title: Option<String>,
    units: &'static str,
    methods: Vec<Row>,
}

#[derive(Serialize)]
struct Row {
    method: &'static str,
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

/// The document of the answers of several methods, of which the first is the exact one.
pub fn comparison(answers: &Answers, context: &Context) -> String {
    let exact = answers.list.first().and_then(Answer::solution);
    let row = |(i, answer): (usize, &Answer)| {
        let (method, seconds) = (answer.label.method, answer.seconds);
        match answer.solution() {
            Some(solution) => {
                let errors = exact.filter(|_| i > 0).map(|exact| Errors::of(solution, exact));
                solved(method, solution, errors, seconds)
            }
            None => refused(method, &answer.found, seconds),
        }
    };
    let methods = answers.list.iter().enumerate().map(row).collect();
    super::text(&Document { title: context.clean_title(), units: context.units.name(), methods })
}

fn refused(method: &'static str, found: &Found, seconds: f64) -> Row {
    let (status, iterations) = match found {
        Found::NotConverged(reached) => ("not-converged", Some(reached.iterations)),
        _ => ("not-for-this-model", None),
    };
    Row { method, status, errors: None, relative_gap: None, elements: None, iterations, seconds }
}

fn solved(method: &'static str, solution: &Solution, errors: Option<Errors>, seconds: f64) -> Row {
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
