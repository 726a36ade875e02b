//! The calculation report as one HTML file that needs nothing beside it and prints well on A4 and on Letter.
//!
//! The page is set by `templates/report.html`.

use crate::calculation::{Paper, Report};
use crate::font;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use minijinja::value::Serde;
use minijinja::{Environment, Value, context as values};
use std::fmt;

/// A report that could not be made.
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

/// The page on which everything is set.
const TEMPLATE: &str = include_str!("../templates/report.html");
/// How it looks on a screen and on paper.
const STYLE: &str = include_str!("../templates/report.css");

/// A report as one HTML file; without a paper it takes that of whoever prints it. Equal reports give equal bytes.
///
/// # Errors
///
/// If memory is lacking for it.
pub fn report(report: &Report, paper: Option<Paper>) -> Result<String, Error> {
    let mut environment = Environment::new();
    // The name's ending makes every value that is put in escaped as HTML asks for.
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

/// Words of the program, escaped, with their indices set low.
fn indexed(words: &str) -> Value {
    let mut escaped = words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    for letter in ["R", "p"] {
        let (written, set) = (format!("{letter}_l"), format!("{letter}<sub>l</sub>"));
        escaped = escaped.replace(&written, &set);
    }
    Value::from_safe_string(escaped)
}

/// Words between quotes of a style sheet: every sign but letters and digits by its number.
fn css(words: &str) -> Value {
    let sign = |c: char| match c.is_alphanumeric() {
        true => c.to_string(),
        false => format!("\\{:06x}", c as u32),
    };
    Value::from_safe_string(words.chars().map(sign).collect())
}
