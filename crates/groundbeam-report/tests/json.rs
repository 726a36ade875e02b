//! Tests the result documents.

use crate::common::{SOLVABLE, context, document, solved};
use groundbeam::{Field, Method, NotConverged, Stopped};
use groundbeam_report::json;
use serde_json::Value;

fn parsed(text: &str) -> Value {
    assert!(text.ends_with("}\n"));
    serde_json::from_str(text).unwrap()
}

/// Rounds every number to nine digits, so that rounding errors do not matter, and removes the certificate.
fn steady(value: &mut Value) {
    match value {
        Value::Number(number) => {
            let rounded: f64 = format!("{:.8e}", number.as_f64().unwrap()).parse().unwrap();
            *value = if rounded.abs() < 1e-9 { 0.into() } else { rounded.into() };
        }
        Value::Array(items) => items.iter_mut().for_each(steady),
        Value::Object(entries) => {
            for (key, entry) in entries {
                if key == "certificate" {
                    entry.as_object_mut().unwrap().values_mut().for_each(|v| *v = 0.into());
                }
                steady(entry);
            }
        }
        Value::Null | Value::Bool(_) | Value::String(_) => {}
    }
}

fn snapshot(name: &str, text: &str) {
    let mut value = parsed(text);
    steady(&mut value);
    if let Some(steps) = value.get_mut("iterations") {
        *steps = 0.into();
    }
    insta::assert_snapshot!(name, serde_json::to_string_pretty(&value).unwrap());
}

#[test]
fn documents_are_the_recorded_ones() {
    let kikuchi = document("kikuchi-4");
    let stations = [0.0, 0.25, 0.5, 1.0];
    snapshot("json-kikuchi-4", &json::solved(&solved(&kikuchi), &stations, &context(&kikuchi)));

    let supports = document("supports");
    snapshot("json-supports", &json::solved(&solved(&supports), &[0.0], &context(&supports)));

    let tips = document("tips");
    let existence = groundbeam::exists(&tips.model).unwrap();
    let context_of_tips = context(&tips);
    let failing = json::existence(&tips.model, &existence, &context_of_tips);
    snapshot("json-tips", &failing);

    let reached =
        Stopped { method: Method::Uzawa, iterations: 10, why: NotConverged::Sweeps(f64::NAN) };
    snapshot("json-not-converged", &json::not_converged(&reached, &context_of_tips));
}

#[test]
fn numbers_keep_every_bit_and_stations_are_the_requested_ones() {
    for name in SOLVABLE {
        let document = document(name);
        let solution = solved(&document);
        let stations = json::default_stations(&solution);
        let found = parsed(&json::solved(&solution, &stations, &context(&document)));
        let x = found["stations"]["x"].as_array().unwrap();
        assert_eq!(x.len(), stations.len());
        for field in Field::of(&document.model.beam) {
            let values = found["stations"][field.name()].as_array().unwrap();
            for ((x, value), &station) in x.iter().zip(values).zip(&stations) {
                let (x, value) = (x.as_f64().unwrap(), value.as_f64().unwrap());
                assert_eq!(x.to_bits(), station.to_bits());
                assert_eq!(value.to_bits(), solution.value(field, station).to_bits(), "{name} {x}");
            }
        }
    }
}
