//! Tests reports of all combinations of a file: report, document, table and picture.

use crate::common::{context, document};
use groundbeam::{Field, NotConverged, Stopped};
use groundbeam_file::Document;
use groundbeam_report::{Results, calculation, csv, html, json, svg, text};
use groundbeam_run::{Answers, Found, OneThread, Run};
use serde_json::{Value, json};

/// A solved file.
struct Solved {
    document: Document,
    answers: Answers,
}

fn solved(name: &str) -> Solved {
    let document = document(name);
    let answers = Run::of(&document).solve(&OneThread).unwrap();
    Solved { document, answers }
}

impl Solved {
    fn json(&self, stations: Option<&[f64]>) -> Value {
        let text = json::combinations(&self.answers, stations, &context(&self.document));
        serde_json::from_str(&text).unwrap()
    }
}

/// The report without the certificate, which contains rounding errors.
fn steady(report: &str) -> String {
    let lines = report.lines().filter(|line| !line.contains("energy") && !line.contains("Method"));
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn the_text_report_of_combinations_is_the_recorded_one() {
    let found = solved("combinations");
    let report = text::combinations(&found.answers, &context(&found.document), false);
    insta::assert_snapshot!("text-combinations", steady(&report));
    for line in report.lines() {
        assert!(line.chars().count() <= 80 && line == line.trim_end(), "{line}");
    }
    let coloured = text::combinations(&found.answers, &context(&found.document), true);
    assert!(coloured.contains("\u{1b}[1;31mnone\u{1b}[0m"));
}

#[test]
fn combinations_that_did_not_converge_are_reported() {
    let found = solved("combinations");
    let mut all = found.answers;
    let reached = Stopped {
        method: groundbeam::Method::Uzawa,
        iterations: 7,
        why: NotConverged::Sweeps(1e-3),
    };
    all.list[0].found = Found::NotConverged(reached);
    let report = text::combinations(&all, &context(&found.document), false);
    assert!(report.contains("   1         not solved: the method `uzawa` stopped after 7"));
    let document: Value =
        serde_json::from_str(&json::combinations(&all, None, &context(&found.document))).unwrap();
    // A missing equilibrium takes precedence.
    assert_eq!(document["status"], "no-equilibrium");
    assert_eq!(document["combinations"][0]["status"], "not-converged");
    all.list.pop();
    let document: Value =
        serde_json::from_str(&json::combinations(&all, None, &context(&found.document))).unwrap();
    assert_eq!(document["status"], "not-converged");
}

#[test]
fn the_document_contains_every_combination() {
    let found = solved("combinations");
    let document = found.json(None);
    assert_eq!(document["status"], "no-equilibrium");
    let combined = document["combinations"].as_array().unwrap();
    assert_eq!(combined.len(), 17);
    assert_eq!(combined[0]["name"], "6.10: 1.35 G + 1.5 Q + 0.9 W right");
    assert_eq!(combined[0]["factors"], json!({ "G": 1.35, "Q": 1.5, "W right": 0.9 }));
    assert_eq!(combined[16]["status"], "no-equilibrium");
    assert_eq!(combined[16]["existence"]["verdict"], "none");
    assert_eq!(document["cases"][0]["stands_alone"], true);
    assert_eq!(document["cases"][2]["state"], "not a physical state");
    let x = document["envelope"]["x"].as_array().unwrap();
    for field in found.answers.envelope().fields() {
        let lines = &document["envelope"][field.name()];
        let extremes = &document["extremes"][field.name()];
        for (bound, governs) in [("min", "governs_min"), ("max", "governs_max")] {
            let values = lines[bound].as_array().unwrap();
            assert_eq!(
                (values.len(), lines[governs].as_array().unwrap().len()),
                (x.len(), x.len())
            );
            // The extreme is the value at one of the stations, and no station exceeds it.
            let extreme = extremes[bound]["value"].as_f64().unwrap();
            let values: Vec<f64> = values.iter().map(|value| value.as_f64().unwrap()).collect();
            let reached = if bound == "min" {
                values.iter().copied().fold(f64::INFINITY, f64::min)
            } else {
                values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
            };
            assert!((reached - extreme).abs() <= 1e-9 * extreme.abs(), "{field:?} {bound}");
        }
        for change in document["changes"][field.name()].as_array().unwrap() {
            assert!(x.contains(&change["x"]), "{field:?}: {change}");
        }
    }
    let some = found.json(Some(&[0.0, 6.0, 12.0]));
    assert_eq!(some["envelope"]["x"], json!([0.0, 6.0, 12.0]));
    assert_eq!(some["combinations"][3]["stations"]["x"], json!([0.0, 6.0, 12.0]));
}

#[test]
fn the_table_and_the_picture_show_the_envelope() {
    let found = solved("combinations");
    let context = context(&found.document);
    let table = csv::envelope(&found.answers, &[0.0, 6.0], &context);
    assert!(table.starts_with("x_m,deflection_min_m,deflection_max_m,deflection_governs_min,"));
    // Two positions, for all combinations and for the ultimate limit state.
    assert_eq!(table.lines().count(), 5);
    let picture = svg::combinations(&found.answers, &context).to_string();
    assert_eq!(picture, svg::combinations(&found.answers, &context).to_string());
    assert!(
        !picture.contains("NaN") && picture.contains("envelope of 16 of 17 combinations; 1 not")
    );
    let bytes = Results::new(&found.answers, context).picture().unwrap().png().unwrap();
    assert_eq!(bytes[..8], *b"\x89PNG\r\n\x1a\n");
    let mut nothing = found.answers.clone();
    nothing.list.retain(|answer| answer.solution().is_none());
    let picture = svg::combinations(&nothing, &context).to_string();
    assert!(picture.contains("0 of 1 combinations"));
    assert!(!json::combinations(&nothing, None, &context).contains("\"envelope\""));
}

#[test]
fn a_band_of_ground_stiffnesses_has_its_closed_form() {
    let solved = solved("band");
    let bands = solved.answers.bands().unwrap();
    let [_, moment] = bands[Field::Moment.index()];
    // P/(4β) with β = (k/4EI)^(1/4), on half and on twice the ground stiffness.
    let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
    close(moment.best, 25e3);
    close(moment.high, 25e3 * 2_f64.powf(0.25));
    close(moment.low, 25e3 * 0.5_f64.powf(0.25));
    let document = solved.json(None);
    assert_eq!(document["band"]["moment"]["max"]["best"], json!(moment.best));
    assert_eq!(document["combinations"][1]["ground_factors"], json!({"k": 0.5, "mu": 1.0}));
}

#[test]
fn the_calculation_report_contains_every_combination() {
    for name in ["combinations", "band"] {
        let solved = solved(name);
        let Document { model, cases, .. } = &solved.document;
        let source = calculation::Source {
            name: "model.toml",
            text: solved.document.text(),
            model,
            cases,
            files: &[],
        };
        let report = calculation::report(&solved.answers, &context(&solved.document), &source);
        let page = html::report(&report, None).unwrap();
        for answer in &solved.answers.list {
            let named = answer.name().replace('&', "&amp;").replace('/', "&#x2f;");
            assert!(page.contains(&named), "{name}: {}", answer.name());
        }
        // The model, the governing combination, and four envelopes.
        assert_eq!(page.matches("<figure>").count(), 6, "{name}");
        let body = page.split_once("</style>").unwrap().1;
        assert!(!body.contains("NaN") && !body.contains("inf "), "{name}");
    }
}
