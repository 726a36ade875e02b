//! What was wrong with a question, as JSON.

use crate::failure::Failure;
use axum::http::StatusCode;
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};
use groundbeam_file::{Diagnostic, Severity};
use serde::Serialize;
use serde_json::json;

/// An answer in JSON.
pub fn document(status: StatusCode, text: String) -> Response {
    (status, [(CONTENT_TYPE, "application/json")], text).into_response()
}

/// A question that is not answered.
pub fn refusal(status: StatusCode, message: &str) -> Response {
    let text = json!({ "status": "refused", "message": message }).to_string();
    document(status, text + "\n")
}

/// A model file with faults.
pub fn wrong_model(failure: &Failure) -> Response {
    document(StatusCode::UNPROCESSABLE_ENTITY, faults(failure) + "\n")
}

/// The most faults of a file that are listed: a file of 4 MiB may have a million.
const MOST: usize = 1000;

/// `{"status": "wrong-model", "diagnostics": […], "count": 1}`
fn faults(failure: &Failure) -> String {
    let found = failure.found();
    let diagnostics: Vec<Fault> = found.iter().take(MOST).map(Fault::of).collect();
    let (message, count) = (failure.message(), found.len());
    let answer = json!({
        "status": "wrong-model", "message": message, "diagnostics": diagnostics, "count": count
    });
    answer.to_string()
}

#[derive(Serialize)]
struct Fault<'a> {
    code: &'a str,
    severity: &'static str,
    message: &'a str,
    label: &'a str,
    hint: &'a str,
    line: usize,
    column: usize,
    /// Bytes of the text.
    span: [usize; 2],
    related: Vec<Related<'a>>,
}

#[derive(Serialize)]
struct Related<'a> {
    label: &'a str,
    line: usize,
    column: usize,
    span: [usize; 2],
}

impl<'a> Fault<'a> {
    fn of(found: &'a Diagnostic) -> Self {
        let related = found.related.iter().map(|related| Related {
            label: &related.label,
            line: related.line,
            column: related.column,
            span: [related.span.start, related.span.end],
        });
        Fault {
            code: found.code,
            severity: match found.severity {
                Severity::Error => "error",
                Severity::Warning => "warning",
            },
            message: &found.message,
            label: &found.label,
            hint: &found.hint,
            line: found.line,
            column: found.column,
            span: [found.span.start, found.span.end],
            related: related.collect(),
        }
    }
}
