//! Writes the results of several methods for one model as a document.

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
    errors: Option<Errors>,
    #[serde(skip_serializing_if = "Option::is_none")]
    relative_gap: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    elements: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    iterations: Option<usize>,
    seconds: f64,
}

/// Returns the document that compares the results of several methods. The first result is that of the exact
/// method.
pub fn comparison(answers: &Answers, context: &Context) -> String {
    let exact = answers.list.first().and_then(Answer::solution);
    let row = |(i, answer): (usize, &Answer)| {
        let solution = answer.solution();
        let (status, iterations) = match &answer.found {
            Found::Equilibrium(solution) => ("solved", Some(solution.iterations())),
            Found::NotConverged(reached) => ("not-converged", Some(reached.iterations)),
            _ => ("not-for-this-model", None),
        };
        let others = solution.filter(|_| i > 0);
        Row {
            method: answer.label.method,
            status,
            errors: others.zip(exact).map(|(solution, exact)| Errors::of(solution, exact)),
            relative_gap: solution.map(|solution| solution.certificate().relative_gap()),
            elements: solution.map(Solution::elements),
            iterations,
            seconds: answer.seconds,
        }
    };
    let methods = answers.list.iter().enumerate().map(row).collect();
    super::text(&Document { title: context.clean_title(), units: context.units.name(), methods })
}
