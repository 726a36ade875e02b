//! Writes the calculation report as one self-contained HTML file that can be printed on A4 and Letter.
//!
//! `templates/report.html` defines the page.

use crate::calculation::{Paper, Report};
use crate::font;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use minijinja::value::Serde;
use minijinja::{Environment, Value, context as values};
use std::fmt;

/// Reason why a report cannot be made.
#[derive(Debug)]
pub struct Error(String);

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the report could not be made: {}", self.0)
    }
}

impl std::error::Error for Error {}

impl From<minijinja::Error> for Error {
    fn from(error: minijinja::Error) -> Self {
        Error(error.to_string())
    }
}

/// HTML template of the page.
const TEMPLATE: &str = include_str!("../templates/report.html");
/// Style sheet for screen and paper.
const STYLE: &str = include_str!("../templates/report.css");

/// Returns a report as one HTML file. Without `paper`, the browser chooses the paper size.
///
/// # Errors
///
/// Returns an error if there is not enough memory.
pub fn report(report: &Report, paper: Option<Paper>) -> Result<String, Error> {
    let mut environment = Environment::new();
    // The file extension makes the template engine escape all values for HTML.
    environment.add_template("report.html", TEMPLATE)?;
    environment.add_filter("indexed", indexed);
    environment.add_filter("css", css);
    let page = values! {
        report => Serde(report),
        style => STYLE,
        paper => paper.map(|paper| match paper { Paper::A4 => "A4", Paper::Letter => "letter" }),
        regular => STANDARD.encode(font::REGULAR),
        semi_bold => STANDARD.encode(font::SEMI_BOLD),
    };
    Ok(environment.get_template("report.html")?.render(page)? + "\n")
}

/// Escapes text for HTML and writes the indices of `R_l` and `p_l` as subscripts.
fn indexed(words: &str) -> Value {
    let mut escaped = words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    for letter in ["R", "p"] {
        let (written, set) = (format!("{letter}_l"), format!("{letter}<sub>l</sub>"));
        escaped = escaped.replace(&written, &set);
    }
    Value::from_safe_string(escaped)
}

/// Escapes text for a quoted string in a style sheet. All characters except letters and digits are written as
/// their code points.
fn css(words: &str) -> Value {
    let sign = |c: char| match c.is_alphanumeric() {
        true => c.to_string(),
        false => format!("\\{:06x}", c as u32),
    };
    Value::from_safe_string(words.chars().map(sign).collect())
}
