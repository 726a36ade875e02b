//! Tests the terminal reports.

#[allow(dead_code)]
mod common;

use common::{SOLVABLE, context, document, solved};
use groundbeam::{Method, NotConverged, Stopped};
use groundbeam_report::text;

/// The report without the certificate's numbers, which are rounding errors, and without the iteration count.
fn steady(report: &str) -> &str {
    report.split("\nCertificate").next().unwrap()
}

#[test]
fn reports() {
    for name in SOLVABLE {
        let document = document(name);
        let report = text::solved(&solved(&document), &context(&document), false);
        insta::assert_snapshot!(format!("text-{name}"), steady(&report));
    }
}

#[test]
fn no_line_is_wider_than_a_terminal() {
    for name in SOLVABLE {
        let document = document(name);
        let report = text::solved(&solved(&document), &context(&document), false);
        for line in report.lines() {
            assert!(line.chars().count() <= 80 && line == line.trim_end(), "{name}: {line}");
        }
    }
}

#[test]
fn no_equilibrium() {
    let document = document("tips");
    let existence = groundbeam::exists(&document.model).unwrap();
    let report = text::existence(&document.model, &existence, &context(&document), false);
    insta::assert_snapshot!("text-tips", report);
}

#[test]
fn not_converged() {
    let reached =
        Stopped { method: Method::Uzawa, iterations: 1_000_000, why: NotConverged::Sweeps(3.2e-4) };
    insta::assert_snapshot!("text-not-converged", text::not_converged(&reached, false));
}

#[test]
fn colour_adds_escape_codes_and_nothing_else() {
    let document = document("kikuchi-4");
    let solution = solved(&document);
    let report = |colour| text::solved(&solution, &context(&document), colour);
    let (plain, coloured) = (report(false), report(true));
    assert!(!plain.contains('\u{1b}') && coloured.contains("\u{1b}[1;32mexactly one\u{1b}[0m"));
    let mut stripped = String::new();
    for (i, piece) in coloured.split('\u{1b}').enumerate() {
        stripped.push_str(if i == 0 { piece } else { piece.split_once('m').unwrap().1 });
    }
    assert_eq!(stripped, plain);
}

#[test]
fn drawings_for_a_terminal() {
    for name in SOLVABLE {
        let document = document(name);
        let solution = solved(&document);
        let drawn = text::drawing(&solution, context(&document).units, false);
        assert!(drawn.lines().all(|line| line.chars().count() <= 80), "{drawn}");
        insta::assert_snapshot!(format!("drawing-{name}"), drawn);
        let painted = text::drawing(&solution, context(&document).units, true);
        let codes = ["\u{1b}[0m", "\u{1b}[2m", "\u{1b}[33m", "\u{1b}[34m"];
        let plain = codes.iter().fold(painted, |text, code| text.replace(code, ""));
        assert_eq!(plain, drawn, "colour adds colour alone");
    }
}
