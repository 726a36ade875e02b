//! `groundbeam solve --proven`, and the documents that it writes.

#[allow(dead_code)]
mod common;

use common::{FOOTING, Folder, LIFTS, combined, tips};
use serde_json::json;

#[test]
fn a_report_with_its_proof() {
    for model in [LIFTS, FOOTING] {
        let done = Folder::with(model).run(&["solve", "model.toml", "--proven"]);
        done.is_clean(0);
        assert!(done.stdout.contains("\nProof\nProven "), "{}", done.stdout);
        assert!(done.stdout.contains("it is the only one"), "{}", done.stdout);
        // Each number of the results has its bound.
        for label in ["Deflection", "Slope", "Moment", "Shear force", "Pressure", "End forces"] {
            let row = done.stdout.lines().find(|line| line.starts_with(label)).unwrap_or_default();
            assert!(row.contains(" ± "), "{label}: {}", done.stdout);
        }
        assert!(done.stdout.lines().all(|line| line.chars().count() <= 80), "{}", done.stdout);
    }
    let plain = Folder::with(LIFTS).run(&["solve", "model.toml"]);
    assert!(!plain.stdout.to_lowercase().contains("proven"), "{}", plain.stdout);
}

#[test]
fn a_document_with_its_proof_is_verified() {
    let folder = Folder::with(LIFTS);
    let done = folder.run(&["solve", "model.toml", "--proven", "--json"]);
    done.is_clean(0);
    let mut document = done.json();
    let proof = &document["proof"];
    assert_eq!((&proof["statement"], &proof["scalar"]), (&json!("proven"), &json!("wide")));
    assert_eq!((&proof["exists"], &proof["unique"]), (&json!(true), &json!(true)));
    assert!(document["pieces"].is_array());
    folder.write("result.json", done.stdout.as_bytes());
    let verified = folder.run(&["verify", "result.json", "model.toml", "--json"]);
    verified.is_clean(0);
    // Seven fields and the gap, two edges, the forces under both ends twice.
    assert_eq!(verified.json()["results"][0]["checked"]["bounds"], 14);
    let each = &verified.json()["results"][0]["each"];
    assert_eq!(each["edges"], document["proof"]["bounds"]["edges"]);
    assert_eq!(each["end_forces"].as_array().unwrap().len(), 2);
    // A bound that is too small is not accepted.
    let bound = document["proof"]["bounds"]["moment"].as_f64().unwrap();
    document["proof"]["bounds"]["moment"] = json!(0.9 * bound);
    folder.write("result.json", document.to_string().as_bytes());
    let verified = folder.run(&["verify", "result.json", "model.toml"]);
    assert_eq!(verified.status, 1);
    assert!(verified.stdout.contains("the document claims"), "{}", verified.stdout);
    document["proof"]["bounds"]["moment"] = json!(bound);
    let edge = document["proof"]["bounds"]["edges"][1].as_f64().unwrap();
    document["proof"]["bounds"]["edges"][1] = json!(0.9 * edge);
    folder.write("result.json", document.to_string().as_bytes());
    let verified = folder.run(&["verify", "result.json", "model.toml"]);
    assert!(verified.stdout.contains("the bound of `edges`"), "{}", verified.stdout);
    document["proof"]["bounds"]["edges"] = json!([1.0]);
    folder.write("result.json", document.to_string().as_bytes());
    let verified = folder.run(&["verify", "result.json", "model.toml"]);
    assert!(verified.stdout.contains("claims 1 bounds of `edges`"), "{}", verified.stdout);
}

#[test]
fn a_mesh_is_not_proven_and_its_bounds_are_printed() {
    let folder = Folder::with(LIFTS);
    let mesh = ["--method", "active-set", "--elements", "20"];
    let done = folder.run(&[&["solve", "model.toml", "--proven"][..], &mesh].concat());
    done.is_clean(1);
    assert!(done.stdout.contains("\nProof\nNot proven "), "{}", done.stdout);
    assert!(done.stdout.contains("Shear force  ") && done.stdout.contains("(not proven) at"));
    assert!(done.stdout.contains("No bound     shear force, edges, forces"), "{}", done.stdout);
    let row = done.stdout.lines().find(|line| line.starts_with("Deflection ")).unwrap();
    assert!(row.contains(" ± "), "{row}");
    assert!(done.stdout.lines().all(|line| line.chars().count() <= 80), "{}", done.stdout);
    let done = folder.run(&[&["solve", "model.toml", "--proven", "--json"][..], &mesh].concat());
    done.is_clean(1);
    let proof = &done.json()["proof"];
    assert_ne!(proof["statement"], "proven");
    assert!(proof["bounds"]["deflection"].is_number() && proof["bounds"]["edges"].is_null());
    assert!(proof["not_proven"]["edges"].as_str().unwrap().contains("is too small"), "{proof}");
}

#[test]
fn each_combination_has_its_proof() {
    let model = combined();
    let folder = Folder::with(&model);
    let done = folder.run(&["solve", "model.toml", "--proven"]);
    done.is_clean(0);
    assert!(done.stdout.contains("Proof: one\n") && done.stdout.contains("Proof: two\n"));
    let done = folder.run(&["solve", "model.toml", "--proven", "--json"]);
    done.is_clean(0);
    for combination in done.json()["combinations"].as_array().unwrap() {
        assert_eq!(combination["proof"]["statement"], "proven");
    }
    folder.write("result.json", done.stdout.as_bytes());
    folder.run(&["verify", "result.json", "model.toml"]).is_clean(0);
}

#[test]
fn what_cannot_be_proven_is_told() {
    let folder = Folder::with(&tips());
    folder.run(&["solve", "model.toml", "--proven"]).fails(3, "tips about its right end");
    let train = format!("{FOOTING}[[train]]\naxles = [{{ at = '0 m', force = '90 kN' }}]\n");
    let folder = Folder::with(&train);
    folder.run(&["solve", "model.toml", "--proven"]).fails(2, "positions of trains are not proven");
}

/// The proof's reader knows no surveys: the document holds the model, and the proof is for that one.
#[test]
fn a_model_of_the_document_is_proven_with_a_status_of_its_own() {
    let model = format!("{LIFTS}[gap_survey]\nfile = 'survey.csv'\n");
    let folder = Folder::with(&model);
    folder.write("survey.csv", SURVEY);
    let done = folder.run(&["solve", "model.toml", "--proven", "--json"]);
    done.is_clean(0);
    folder.write("result.json", done.stdout.as_bytes());
    let verified = folder.run(&["verify", "result.json", "model.toml"]);
    assert_eq!((verified.status, verified.stderr.as_str()), (3, ""), "{}", verified.stdout);
    assert!(verified.stdout.contains("for the model as the solver read it alone"));
    assert!(verified.stdout.lines().all(|line| line.chars().count() <= 80));
    // Another table is another model.
    folder.write("survey.csv", &[SURVEY, b"\n"].concat());
    let verified = folder.run(&["verify", "result.json", "model.toml"]);
    assert_eq!(verified.status, 1, "{}", verified.stdout);
    assert!(verified.stdout.contains("belongs to another model file"));
}

/// A seabed, 1 mm deeper in the middle.
const SURVEY: &[u8] = b"x,z\n0,-1.0\n0.5,-1.001\n1,-1.0\n";
