//! Writes `docs/verification.md`: every expectation of every case, with the computed value.

use super::Case;
use super::answers::Answers;
use super::expectation::{Expectation, Of, Tolerance, Value};
use groundbeam_file::Document;
use std::fmt::Write;

/// The folders of cases in the order of the manual, each with a title and a description.
const CHAPTERS: [(&str, &str, &str); 7] = [
    ("kikuchi-1980/", "The paper's own examples", "Kikuchi's sections 4 and 5."),
    ("textbook/", "Textbooks, manuals and closed forms", "Published numbers and exact solutions."),
    ("footings/", "Structures with units", "Typical structures from engineering practice."),
    (
        "combinations/",
        "Combinations of load cases",
        "Separate solutions of all combinations, and their envelope.",
    ),
    (
        "ground/",
        "Ground with an initial gap or of finite extent",
        "Surveyed ground, settlement troughs, trenches and neighbouring loads.",
    ),
    ("limits/", "Limits", "Degenerate and extreme models."),
    ("", "Benchmark", "A model on which other solvers were timed."),
];

/// The manual's text.
pub fn manual(cases: &[Case]) -> String {
    let count: usize = cases.iter().map(|case| case.expectations.len()).sum();
    let mut text = format!(
        "# Every verification case\n\n\
         {} models and {count} numbers that are known without groundbeam, and the results of groundbeam.\n\
         `verification/tests/cases.rs` makes this page from the files in [`cases/`](../cases/README.md).\n\
         The test fails if a number is outside its tolerance.\n\n\
         | column | meaning |\n|---|---|\n\
         | gap | the certificate's relative energy gap, an estimate of the error |\n\
         | error | relative to the reference, of a list to its largest number; `< 1e-12` is rounding |\n",
        cases.len()
    );
    let mut left: Vec<&Case> = cases.iter().collect();
    for (folder, heading, about) in CHAPTERS {
        let (these, others): (Vec<&Case>, Vec<&Case>) =
            left.into_iter().partition(|case| case.path.starts_with(folder));
        left = others;
        if !these.is_empty() {
            _ = write!(text, "\n## {heading}\n\n{about}\n");
            chapter(&mut text, folder, &these);
        }
    }
    text
}

/// Writes two tables for a folder of cases. The first lists the cases with their sources, the second lists all
/// expected and computed values.
fn chapter(text: &mut String, folder: &str, cases: &[&Case]) {
    text.push_str("\n| case | model | source | gap |\n|---|---|---|---|\n");
    let mut numbers = "\n| case | quantity | reference | groundbeam | error | tolerance |\n\
                       |---|---|---|---|---|---|\n"
        .to_owned();
    for case in cases {
        let path = &case.path;
        let name = path.strip_prefix(folder).unwrap_or(path).trim_end_matches(".toml");
        let answers = Answers::of(&case.document);
        let gap = answers.as_ref().map_or_else(ToString::to_string, largest_gap);
        let [title, source] =
            [case.title(), case.source.as_str()].map(|cell| cell.replace('|', "\\|"));
        _ = writeln!(text, "| [`{name}`](../cases/{path}) | {title} | {source} | {gap} |");
        let Ok(answers) = answers else { continue };
        for (i, expectation) in case.expectations.iter().enumerate() {
            let name = if i == 0 { format!(" `{name}`") } else { String::new() };
            _ = write!(numbers, "|{name} ");
            row(&mut numbers, expectation, &case.document, &answers);
        }
    }
    text.push_str(&numbers);
}

/// Returns an upper bound of the largest relative energy gap of the solutions, as text.
fn largest_gap(answers: &Answers) -> String {
    let gaps = answers.solutions().into_iter().map(|found| found.certificate().relative_gap());
    match gaps.reduce(f64::max) {
        Some(gap) if gap < 1e-12 => "< 1e-12",
        Some(_) => "< 1e-9",
        None => "no equilibrium",
    }
    .to_owned()
}

fn row(text: &mut String, expectation: &Expectation, document: &Document, answers: &Answers) {
    let (found, error) = match answers.found(expectation, document) {
        Err(what) => (what, "–".to_owned()),
        Ok(found) => {
            let error = match expectation.distance(&found) {
                Ok(_) if matches!(found, Value::Word(_)) => "none".to_owned(),
                Ok((0.0, _)) => bound(0.0),
                Ok((absolute, relative)) if !relative.is_finite() => {
                    bound(absolute) + " (absolute)"
                }
                Ok((_, relative)) => bound(relative),
                Err(_) => "–".to_owned(),
            };
            (written(&found, expectation), error)
        }
    };
    let tolerance = match expectation.tolerance {
        Tolerance::Same => "the same".to_owned(),
        Tolerance::Absolute(size) if size >= 1e-3 => format!("{size} absolute"),
        Tolerance::Absolute(size) => format!("{size:e} absolute"),
        Tolerance::Relative(size) => format!("{size:e}"),
    };
    let why = match expectation.why.as_str() {
        "" => String::new(),
        why => format!(": {why}"),
    };
    let (name, value) = (&expectation.name, &expectation.value);
    let of = match &expectation.of {
        Of::File => String::new(),
        Of::Combination(name) => format!("{name}, "),
        Of::Envelope => "envelope, ".to_owned(),
    };
    _ = writeln!(text, "| {of}`{name}` | {value} | {found} | {error} | {tolerance}{why} |");
}

/// Formats an error. Errors near rounding level differ between processors, so only their order of magnitude is
/// printed.
fn bound(error: f64) -> String {
    match error {
        e if e < 1e-12 => "< 1e-12".to_owned(),
        e if e < 1e-9 => "< 1e-9".to_owned(),
        e => format!("{e:.1e}"),
    }
}

fn written(found: &Value, expectation: &Expectation) -> String {
    match found {
        Value::Word(word) => word.clone(),
        Value::Numbers(list) => {
            let smallest = match expectation.tolerance {
                Tolerance::Absolute(size) => size.min(1e-9),
                _ => 0.0,
            };
            let largest = list.iter().fold(0.0_f64, |size, number| number.abs().max(size));
            let number = |x: f64| digits(x, smallest.max(1e-10 * largest));
            match list.as_slice() {
                [] => "none".to_owned(),
                [x] => number(*x),
                list => {
                    let pair = |pair: &[f64]| format!("[{}, {}]", number(pair[0]), number(pair[1]));
                    list.chunks_exact(2).map(pair).collect::<Vec<_>>().join(", ")
                }
            }
        }
    }
}

/// Formats a number with eight significant digits, or as 0 if its magnitude is at most `smallest`.
fn digits(x: f64, smallest: f64) -> String {
    if x.abs() <= smallest {
        return "0".to_owned();
    }
    let rounded: f64 = format!("{x:.7e}").parse().unwrap_or(x);
    if (1e-4..1e8).contains(&x.abs()) { rounded.to_string() } else { format!("{rounded:e}") }
}
