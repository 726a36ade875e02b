//! Replies of the server: a document, a file, or an error message.

use groundbeam_file::{Diagnostic, Severity};
use serde::Serialize;
use serde_json::json;

/// A reply of the server.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reply {
    /// HTTP status.
    pub status: u16,
    /// Media type of the content.
    pub kind: &'static str,
    /// The content.
    pub bytes: Vec<u8>,
}

impl Reply {
    /// A JSON document.
    pub fn document(status: u16, text: String) -> Self {
        Reply { status, kind: "application/json", bytes: text.into_bytes() }
    }

    /// An error message.
    pub fn refusal(status: u16, message: &str) -> Self {
        let text = json!({ "status": "refused", "message": message }).to_string();
        Reply::document(status, text + "\n")
    }
}

/// A model that cannot be solved, with the error in one line and the diagnostics of the model file.
#[derive(Debug, Clone, Default)]
pub(crate) struct WrongModel {
    pub message: String,
    pub found: Vec<Diagnostic>,
}

impl From<Vec<Diagnostic>> for WrongModel {
    fn from(found: Vec<Diagnostic>) -> Self {
        let message = found.first().map_or_else(String::new, ToString::to_string);
        WrongModel { message, found }
    }
}

impl From<WrongModel> for Reply {
    fn from(wrong: WrongModel) -> Self {
        Reply::document(422, wrong.faults() + "\n")
    }
}

/// Maximum number of listed diagnostics. A file of 4 MiB may have a million diagnostics.
const MOST: usize = 1000;

impl WrongModel {
    /// Returns JSON such as `{"status": "wrong-model", "diagnostics": […], "count": 1}`.
    fn faults(&self) -> String {
        let WrongModel { message, found } = self;
        let diagnostics: Vec<Fault> = found.iter().take(MOST).map(Fault::of).collect();
        let answer = json!({
            "status": "wrong-model", "message": message, "diagnostics": diagnostics,
            "count": found.len()
        });
        answer.to_string()
    }
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
    /// Byte range in the text.
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
