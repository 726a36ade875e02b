//! Reads valid and invalid result documents.

#![cfg(test)]

use super::*;

const TEXT: &str = r#"{
        "status": "solved", "units": "SI", "title": "x", "combination": null,
        "model_digest": "sha256:00",
        "existence": {"verdict": "unique", "static_reactions": [1, 2]},
        "pieces": [
            {"x": [0, 1.5], "half": 0.75, "touches": true, "deflection": [1, 2], "pressure": [3]},
            {"x": [1.5, 2], "half": 0.25, "touches": false, "deflection": [1], "open": [0.5, 0.25]}
        ],
        "forces": [{"x": 0, "force": 4.5}],
        "reactions": [{"support": 1, "force": 2, "moment": -1, "at": 1.0, "state": "acting"}],
        "contact": [{"from": 0, "to": 1.5}],
        "end_forces": {"left": 4.5, "right": 0},
        "stations": {"x": [0, 1], "deflection": [1, 2]},
        "extremes": {"deflection": {"min": {"x": 0, "value": 1}, "max": {"x": 2, "value": 3}}},
        "certificate": {"gap": 1e-20},
        "left_of_jumps": {"x": [1], "moment": [3]},
        "proof": {"energy": 1e-30, "bounds": {"deflection": 1e-14, "edges": [1e-13, null]}, "log": [],
                  "places": {"moment": {"max": [[0, 1], [2, 2]]}}, "checks": [{"bound": 1}]}
    }"#;

#[test]
fn the_parts_of_a_document_are_read() {
    let documents = Document::read(TEXT).unwrap();
    let [document] = &documents[..] else { panic!() };
    assert_eq!(document.answer, Answer::from_json(TEXT).unwrap());
    assert_eq!(document.answer.pieces[0].deflection, [1.0, 2.0]);
    assert_eq!(document.answer.pieces[1].open, Some([0.5, 0.25]));
    assert_eq!(document.answer.forces, [Force { x: 0.0, force: 4.5 }]);
    let reaction = Reaction { support: 1, force: 2.0, moment: -1.0 };
    assert_eq!(document.answer.reactions, [reaction]);
    assert_eq!(
        (document.contact.as_deref(), document.end_forces),
        (Some(&[[0.0, 1.5]][..]), Some([4.5, 0.0]))
    );
    assert_eq!(document.stations.fields, [("deflection".to_owned(), vec![1.0, 2.0])]);
    let left = Stations { x: vec![1.0], fields: vec![("moment".to_owned(), vec![3.0])] };
    assert_eq!(document.left_of_jumps, left);
    let places = vec![[0.0, 1.0], [2.0, 2.0]];
    assert_eq!(document.places, [("moment".to_owned(), true, places)]);
    assert_eq!(document.extremes.len(), 2);
    assert_eq!(document.bounds[1], ("edges".to_owned(), vec![1e-13, f64::INFINITY]));
    let not_covered: Vec<&str> = document.not_covered.iter().map(String::as_str).collect();
    let named = ["certificate", "existence", "proof.checks", "proof.energy", "reactions.at"];
    assert_eq!(not_covered, named);
}

#[test]
fn each_combination_is_a_separate_document() {
    let text = format!(
        r#"{{"combinations": [{TEXT}, {{"name": "ULS"}}], "envelope": {{"x": [1]}},
               "proof": {{"envelope": [1]}}, "model_digest": "sha256:00"}}"#
    );
    let documents = Document::read(&text).unwrap();
    assert_eq!(documents.len(), 2);
    assert_eq!(documents[1].combination.as_deref(), Some("ULS"));
    for key in ["envelope", "proof.envelope"] {
        assert!(documents[1].not_covered.contains(key));
    }
    assert_eq!(documents[1].model_digest.as_deref(), Some("sha256:00"));
    assert!(Answer::from_json(&text).is_err());
    let two_digests = text.replace("\"sha256:00\"}", "\"sha256:01\"}");
    assert_ne!(two_digests, text);
    assert!(Document::read(&two_digests).is_err());
}

#[test]
fn documents_of_another_form_are_refused() {
    for (right, wrong) in [
        ("\"half\": 0.75", "\"half\": \"0.75\""),
        ("\"half\": 0.75,", ""),
        ("\"half\": 0.75", "\"half\": 0.75, \"shift\": 1"),
        ("[0, 1.5]", "[0, 1.5, 2]"),
        ("\"touches\": true", "\"touches\": 1"),
        ("\"deflection\": [1, 2], \"pressure\"", "\"deflection\": [], \"pressure\""),
        ("\"deflection\": [1, 2], \"pressure\"", "\"deflection\": [null], \"pressure\""),
        ("\"support\": 1", "\"support\": 0.5"),
        ("\"support\": 1", "\"support\": -1"),
        ("{\"x\": [0, 1], \"defl", "{\"x\": [0], \"defl"),
        ("\"x\": [1], \"moment\": [3]", "\"x\": [1], \"moment\": [3, 4]"),
        ("[[0, 1], [2, 2]]", "[[0, 1], [2]]"),
        ("\"contact\": [", "\"contact\": [1, "),
        ("\"status\": \"solved\"", "\"status\": 1"),
        ("\"forces\": [{\"x\": 0,", "\"forces\": [{"),
    ] {
        let text = TEXT.replacen(right, wrong, 1);
        assert_ne!(text, TEXT, "{right}");
        assert!(Document::read(&text).is_err(), "{wrong}");
    }
    // This loop checks the limits of 100,000 pieces and 26 coefficients.
    for (count, many) in [(100_000, false), (100_001, true), (100_002, true)] {
        let text = format!(r#"{{"pieces": [{}{{}}]}}"#, "{},".repeat(count - 1));
        let error = Document::read(&text).unwrap_err().to_string();
        assert_eq!(error.contains("more than 100000"), many, "{count}: {error}");
    }
    let longest = format!("\"deflection\": [{}1]", "1,".repeat(25));
    assert!(Document::read(&TEXT.replacen("\"deflection\": [1, 2]", &longest, 1)).is_ok());
    let long = format!("\"deflection\": [{}1]", "1,".repeat(26));
    assert!(Document::read(&TEXT.replacen("\"deflection\": [1, 2]", &long, 1)).is_err());
}
