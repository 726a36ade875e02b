//! The calculation report: one HTML file that needs nothing beside it and prints well on A4 and on Letter.
//!
//! It says what was given, what is assumed, why there is an equilibrium, what came out, and how anyone can check it. The
//! words are those of [`text`](crate::text), the figures those of [`svg`](crate::svg); the page is set by
//! `templates/report.html`.

mod equations;
mod given;
mod page;
mod passages;
mod print;
mod proof;
mod several;
mod single;

use crate::combinations::Combinations;
use crate::context::{Context, clean};
use crate::font;
use crate::trains::Passages;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use groundbeam::{Existence, Model, NotConverged, Solution};
use minijinja::value::Serde;
use minijinja::{Environment, Value, context as values};
use page::Report;
use std::fmt;

/// What a report is about.
#[derive(Debug, Clone, Copy)]
pub enum Contents<'a> {
    /// An equilibrium.
    Solved(&'a Solution),
    /// There is none.
    NoEquilibrium(&'a Model, &'a Existence),
    /// The method did not reach its tolerance.
    NotConverged(&'a Model, &'a NotConverged),
    /// The combinations of load cases.
    Combinations(&'a Combinations<'a>),
    /// Trains that pass.
    Trains(&'a Passages<'a>),
}

/// Where a report's model comes from.
#[derive(Debug, Clone, Copy)]
pub struct Source<'a> {
    /// What the file is called.
    pub name: &'a str,
    /// All of the file: the report holds it and its digest.
    pub text: &'a str,
    /// The model under all of its loads as they are written.
    pub model: &'a Model,
    /// The load case of each of its loads, in their order; none for a load to which the file gives none.
    pub cases: &'a [Option<String>],
}

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
const TEMPLATE: &str = include_str!("../../templates/report.html");
/// How it looks on a screen and on paper.
const STYLE: &str = include_str!("../../templates/report.css");

/// The report as one HTML file. Equal results give equal bytes, but for the time a context brings along.
///
/// # Errors
///
/// If memory is lacking for it.
pub fn report(contents: Contents, context: &Context, source: &Source) -> Result<String, Error> {
    let report = match contents {
        Contents::Solved(solution) => single::solved(solution, context, source),
        Contents::NoEquilibrium(model, existence) => {
            single::no_equilibrium(model, existence, context, source)
        }
        Contents::NotConverged(model, reached) => {
            single::not_converged(model, reached, context, source)
        }
        Contents::Combinations(all) => several::combinations(all, context, source),
        Contents::Trains(passages) => passages::trains(passages, context, source),
    };
    set(&report, context, source)
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

fn set(report: &Report, context: &Context, source: &Source) -> Result<String, Error> {
    let mut environment = Environment::new();
    // The name's ending makes every value that is put in escaped as HTML asks for.
    environment.add_template("report.html", TEMPLATE)?;
    environment.add_filter("indexed", indexed);
    let title = context.clean_title().unwrap_or_else(|| clean(source.name));
    let page = values! {
        title,
        report => Serde(report),
        style => STYLE,
        regular => STANDARD.encode(font::REGULAR),
        semi_bold => STANDARD.encode(font::SEMI_BOLD),
        version => env!("CARGO_PKG_VERSION"),
        digest => proof::digest(source.text),
    };
    Ok(environment.get_template("report.html")?.render(page)? + "\n")
}
