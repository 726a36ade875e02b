//! Tests that every output lists the fields of the core's table, and the rotation only with shear
//! deformation.

use crate::common::{answers, context, solved};
use groundbeam::Field;
use groundbeam_file::{Document, parse};
use groundbeam_report::calculation::{Block, Source, report};
use groundbeam_report::{csv, json, text};
use serde_json::Value;

/// A test model without and with shear deformation. The calculation report of each is checked.
fn both(name: &str) -> [Document; 2] {
    let path = format!("{}/tests/models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let shears = text.replacen("[beam]\n", "[beam]\nshear_stiffness = \"200 MN\"\n", 1);
    let both = [text, shears].map(|text| {
        let document = parse(&text).unwrap();
        assert_calculation(&document, &text);
        document
    });
    assert_eq!([0, 1].map(|i| both[i].model.beam.shears()), [false, true]);
    both
}

/// The table of extremes in the calculation report lists the fields.
fn assert_calculation(document: &Document, text: &str) {
    let source = Source::of(document, "model.toml", text);
    let report = report(&answers(document), &context(document), &source);
    let blocks = report.sections.iter().flat_map(|section| &section.blocks);
    let mut tables = blocks.filter_map(|block| match block {
        Block::Table(table) if table.columns[0].head == "quantity" => Some(table),
        _ => None,
    });
    let rows = &tables.next().unwrap().rows;
    assert!(rows.iter().map(|row| &row[0]).eq(Field::of(&document.model.beam).map(Field::label)));
}

fn names(document: &Document) -> Vec<&'static str> {
    Field::of(&document.model.beam).map(Field::name).collect()
}

fn keys(of: &Value) -> Vec<&str> {
    let keys = of.as_object().unwrap().keys().map(String::as_str);
    keys.filter(|key| *key != "x").collect()
}

/// The names in alphabetical order, as in JSON objects.
fn sorted(mut names: Vec<&'static str>) -> Vec<&'static str> {
    names.sort_unstable();
    names
}

/// The labels at the start of the lines after the heading.
#[track_caller]
fn assert_labels(text: &str, document: &Document) {
    let labels = Field::ALL.into_iter().map(Field::label);
    let rows = text.lines().filter_map(|line| labels.clone().find(|l| line.trim().starts_with(l)));
    let listed: Vec<_> = Field::of(&document.model.beam).map(Field::label).collect();
    let rows: Vec<_> = rows.collect();
    assert!(rows.windows(listed.len()).any(|rows| rows == listed), "{rows:?}\n{text}");
    assert_eq!(text.contains("Rotation"), document.model.beam.shears());
}

#[track_caller]
fn assert_columns(table: &str, document: &Document) {
    let head: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let mut found: Vec<&str> = Vec::new();
    for column in head[1..].iter().filter(|column| **column != "limit_state") {
        let known = Field::ALL.into_iter().find(|field| column.starts_with(field.name()));
        let name = known.unwrap_or_else(|| panic!("{column}")).name();
        if found.last() != Some(&name) {
            found.push(name);
        }
    }
    assert_eq!(found, names(document));
    assert!(table.lines().all(|row| row.split(',').count() == head.len()));
}

#[test]
fn every_field_of_one_solution_is_written() {
    for document in both("footing") {
        let (solution, context) = (solved(&document), context(&document));
        let found = json::solved(&solution, &[1.0, 2.0], &context);
        let found: Value = serde_json::from_str(&found).unwrap();
        for part in ["stations", "extremes"] {
            assert_eq!(keys(&found[part]), sorted(names(&document)), "{part}");
        }
        assert_columns(&csv::table(&solution, &[0.0, 1.0], &context), &document);
        assert_labels(&text::solved(&solution, &context, false), &document);
        let summary: String =
            text::summary(&solution, &context).into_iter().map(|(label, _)| label + "\n").collect();
        assert_labels(&summary, &document);
    }
}

#[test]
fn every_field_of_combinations_is_written() {
    for document in both("combinations") {
        let (answers, context) = (answers(&document), context(&document));
        let found: Value =
            serde_json::from_str(&json::combinations(&answers, Some(&[1.0]), &context)).unwrap();
        for part in ["envelope", "extremes", "changes"] {
            assert_eq!(keys(&found[part]), sorted(names(&document)), "{part}");
        }
        assert_columns(&csv::envelope(&answers, &[0.0, 1.0], &context), &document);
        assert_labels(&text::combinations(&answers, &context, false), &document);
    }
}

#[test]
fn every_field_of_a_band_is_written() {
    for document in both("band") {
        let found = json::combinations(&answers(&document), Some(&[1.0]), &context(&document));
        let found: Value = serde_json::from_str(&found).unwrap();
        assert_eq!(keys(&found["band"]), sorted(names(&document)));
    }
}

#[test]
fn every_field_of_a_train_is_written() {
    for document in both("train") {
        let (answers, context) = (answers(&document), context(&document));
        let passages = answers.passages();
        let found: Value =
            serde_json::from_str(&json::trains(&passages, Some(&[1.0]), &context)).unwrap();
        let error = &found["train"]["error"]["reached_by_field"];
        for part in [&found["envelope"], &found["extremes"], error] {
            assert_eq!(keys(part), sorted(names(&document)));
        }
        assert_columns(&csv::trains(&passages, &[0.0, 1.0], context.units), &document);
        assert_labels(&text::trains(&passages, &context, false), &document);
    }
}
