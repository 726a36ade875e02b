//! Tests the parts of a result document that a proof needs: digest of the model, pieces of the solution,
//! combination.

use crate::common::{Folder, LIFTS, tips};
use groundbeam::proof::{Document, Wide, prove, read_model};
use serde_json::json;
use std::process::Command;

const SUPPORTED: &str = "\
[beam]
length = 4
EI = 3
[foundation]
k = 2
mu = 0.5
[[support]]
at = 1
type = 'pinned'
[[support]]
at = 3
spring = 7
[[load]]
distributed = 1.5
case = 'G'
[[load]]
point = 2
at = 2.5
case = 'Q'
[[combination]]
name = 'ULS'
factors = { G = 1.35, Q = 1.5 }
[[combination]]
name = 'SLS'
factors = { G = 1, Q = 1 }
";

#[test]
fn the_pieces_prove_the_answer() {
    let folder = Folder::with(LIFTS);
    let plain = folder.run(&["solve", "model.toml", "--json"]);
    assert!(plain.json().get("pieces").is_none() && plain.json().get("forces").is_none());
    let done = folder.run(&["solve", "model.toml", "--json", "--pieces"]);
    done.is_clean(0);
    let [document] = &Document::read(&done.stdout).unwrap()[..] else { panic!() };
    assert_eq!(document.answer.pieces.len(), 3);
    assert_eq!(document.answer.forces[1].force, document.end_forces.unwrap()[1]);
    let model = read_model::<Wide>(LIFTS, None).unwrap();
    let proof = prove(&model, &document.answer).unwrap();
    assert!(proof.energy < 1e-27 * proof.strain_energy && proof.contact.is_ok());
    // Every number reads back as the same double.
    let groundbeam::Outcome::Equilibrium(solution) =
        groundbeam::solve(&groundbeam_file::parse(LIFTS).unwrap().model).unwrap()
    else {
        panic!()
    };
    assert_eq!(document.answer, solution.claim::<f64>().1);
}

#[test]
fn pieces_identify_their_combination_and_support() {
    let folder = Folder::with(SUPPORTED);
    let done = folder.run(&["solve", "model.toml", "--json", "--pieces"]);
    done.is_clean(0);
    assert_eq!(done.json()["combinations"][0]["reactions"][1]["support"], 1);
    let documents = Document::read(&done.stdout).unwrap();
    for (document, name) in documents.iter().zip(["ULS", "SLS"]) {
        assert_eq!(document.combination.as_deref(), Some(name));
        assert!(document.model_digest.is_some());
        let model = read_model::<Wide>(SUPPORTED, Some(name)).unwrap();
        assert!(prove(&model, &document.answer).is_ok());
    }
    let one = ["solve", "model.toml", "--json", "--pieces", "--combination", "SLS"];
    let done = folder.run(&one);
    assert_eq!(done.json()["combination"], "SLS");
    assert_eq!(Document::read(&done.stdout).unwrap()[0].answer, documents[1].answer);
}

#[test]
fn the_digest_is_the_sha256_of_the_file() {
    let folder = Folder::with(LIFTS);
    let digest = folder.run(&["solve", "model.toml", "--json"]).json()["model_digest"].clone();
    if let Ok(output) = Command::new("sha256sum").arg(folder.path("model.toml")).output() {
        let told = String::from_utf8(output.stdout).unwrap();
        assert_eq!(digest, json!(format!("sha256:{}", told.split(' ').next().unwrap())));
    }
    folder.write("model.toml", tips().as_bytes());
    let other = folder.run(&["solve", "model.toml", "--json"]).json()["model_digest"].clone();
    assert!(other.is_string() && other != digest);
    // The digest includes a table that the model names.
    folder.write("survey.csv", b"x,gap\n0,0.001\n1,0\n");
    let survey = format!("{LIFTS}[gap_survey]\nfile = 'survey.csv'\n");
    folder.write("model.toml", survey.as_bytes());
    let solved = |folder: &Folder| folder.run(&["solve", "model.toml", "--json"]);
    let before = solved(&folder);
    assert!(before.json()["model_digest"].is_string(), "{}", before.stderr);
    folder.write("survey.csv", b"x,gap\n0,0.001\n1,0.000\n");
    assert_ne!(solved(&folder).json()["model_digest"], before.json()["model_digest"]);
}

#[test]
fn the_pieces_option_needs_json() {
    let folder = Folder::with(LIFTS);
    folder.run(&["solve", "model.toml", "--pieces"]).fails(2, "--json");
}
