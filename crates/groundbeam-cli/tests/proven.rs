//! Tests `groundbeam solve --proven` and its documents.

use crate::common::{FOOTING, Folder, LIFTS, combined, tips};
use serde_json::json;

#[test]
fn the_text_report_contains_the_proof() {
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
    // Seven fields and the gap, two contact edges, the forces under both ends twice, and thirteen positions
    // of extremes. The smallest gap and the pressure have no position bound.
    assert_eq!(verified.json()["results"][0]["checked"]["bounds"], 27);
    let each = &verified.json()["results"][0]["each"];
    assert_eq!(each["edges"], document["proof"]["bounds"]["edges"]);
    assert_eq!(each["end_forces"].as_array().unwrap().len(), 2);
    // A bound that is too small is refused.
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
    assert!(verified.stdout.contains("lists 1 error bounds of `edges`"), "{}", verified.stdout);
}

#[test]
fn a_mesh_is_not_proven_and_its_bounds_are_printed() {
    let folder = Folder::with(LIFTS);
    let mesh = ["--method", "active-set", "--elements", "20"];
    let done = folder.run(&[&["solve", "model.toml", "--proven"][..], &mesh].concat());
    done.is_clean(1);
    assert!(done.stdout.contains("\nProof\nNot proven "), "{}", done.stdout);
    assert!(done.stdout.contains("Shear force  ") && done.stdout.contains("(not proven) at"));
    assert!(
        done.stdout.contains("No bound     shear force, pressure, edges, forces"),
        "{}",
        done.stdout
    );
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
fn models_that_cannot_be_proven_are_reported() {
    let folder = Folder::with(&tips());
    folder.run(&["solve", "model.toml", "--proven"]).fails(3, "tips about its right end");
    let train = format!("{FOOTING}[[train]]\naxles = [{{ at = '0 m', force = '90 kN' }}]\n");
    let folder = Folder::with(&train);
    folder.run(&["solve", "model.toml", "--proven"]).fails(2, "train positions cannot be proven");
}

/// The second reader does not know surveys. The document contains the model, and the proof applies to that
/// model.
#[test]
fn a_proof_of_the_model_in_the_document_has_its_own_status() {
    let model = format!("{LIFTS}[gap_survey]\nfile = 'survey.csv'\n");
    let folder = Folder::with(&model);
    folder.write("survey.csv", SURVEY);
    let done = folder.run(&["solve", "model.toml", "--proven", "--json"]);
    done.is_clean(0);
    folder.write("result.json", done.stdout.as_bytes());
    let verified = folder.run(&["verify", "result.json", "model.toml"]);
    assert_eq!((verified.status, verified.stderr.as_str()), (3, ""), "{}", verified.stdout);
    assert!(verified.stdout.contains("only for the model as the solver read it"));
    assert!(verified.stdout.lines().all(|line| line.chars().count() <= 80));
    // Another table gives another model.
    folder.write("survey.csv", &[SURVEY, b"\n"].concat());
    let verified = folder.run(&["verify", "result.json", "model.toml"]);
    assert_eq!(verified.status, 1, "{}", verified.stdout);
    assert!(verified.stdout.contains("belongs to another model file"));
}

/// The second reader knows soil data, bands, rolled sections and sets of combinations: the proof applies to the file, and the
/// document contains no model.
#[test]
fn soil_bands_sections_and_sets_are_proven_for_the_file() {
    let model = "[beam]\nlength = '9 m'\nmaterial = 'S355'\nsection = { name = 'HEB 300' }\nnu = 0.3\n\
                 [foundation]\nwidth = '0.3 m'\n[foundation.soil]\nmethod = 'vesic'\nE = '20 MPa'\nnu = 0.3\n\
                 [foundation.band]\nk = [0.5, 2]\n\
                 [[load]]\ndistributed = '30 kN/m'\ncase = 'D'\n[[load]]\npoint = '200 kN'\nat = '3 m'\ncase = 'S'\n\
                 [[case]]\nname = 'D'\naction = 'dead'\n[[case]]\nname = 'S'\naction = 'snow'\n\
                 [[combination]]\nset = 'ASCE 7-22 LRFD'\n";
    let folder = Folder::with(model);
    let done = folder.run(&["solve", "model.toml", "--proven", "--json"]);
    done.is_clean(0);
    let document = done.json();
    let combinations = document["combinations"].as_array().unwrap();
    assert!(combinations.len() > 12, "{}", combinations.len());
    assert!(combinations.iter().all(|one| one.get("model").is_none()));
    folder.write("result.json", done.stdout.as_bytes());
    folder.run(&["verify", "result.json", "model.toml"]).is_clean(0);
}

/// A seabed that is 1 mm deeper in the middle.
const SURVEY: &[u8] = b"x,z\n0,-1.0\n0.5,-1.001\n1,-1.0\n";

/// [`LIFTS`] with limits on the deflection and on the lifted share.
fn checked(settlement: &str, lifted_share: &str) -> String {
    format!("{LIFTS}[checks]\nsettlement = {settlement}\nlifted_share = {lifted_share}\n")
}

#[test]
fn a_check_is_proven_if_its_limit_lies_outside_the_bound() {
    let solve = ["solve", "model.toml", "--proven"];
    let folder = Folder::with(&checked("0.6", "0.5"));
    let done = folder.run(&solve);
    done.is_clean(0);
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let said = words(&done.stdout);
    assert!(said.contains("0.6 allowed: proven to pass"), "{said}");
    assert!(said.contains("50 % allowed: proven to fail"), "{said}");
    let document = folder.run(&[&solve[..], &["--json"]].concat()).json();
    let checks = &document["proof"]["checks"];
    assert_eq!(checks[0]["judgement"], "proven-to-pass");
    assert_eq!(checks[1]["judgement"], "proven-to-fail");
    // A limit within the bound: the computed value itself.
    let found = document["checks"][0]["value"].as_f64().unwrap();
    let folder = Folder::with(&checked(&format!("{found:?}"), "0.5"));
    let done = folder.run(&solve);
    done.is_clean(1);
    assert!(
        words(&done.stdout)
            .contains("allowed: undecided, because the limit is within the error bound"),
        "{}",
        done.stdout
    );
    // The eccentricity depends only on the loads and has no bound.
    let folder = Folder::with(&format!("{LIFTS}[checks]\neccentricity = 0.5\n"));
    let done = folder.run(&solve);
    done.is_clean(0);
    assert!(done.stdout.contains("eccentricity 0.49 l (not proven)"), "{}", done.stdout);
    assert!(words(&done.stdout).contains("allowed: passes"), "{}", done.stdout);
}

#[test]
fn load_factors_and_positions_of_extreme_pressures_are_not_proven() {
    let folder = Folder::with(LIFTS);
    let done = folder.run(&["solve", "model.toml", "--proven", "--factors"]);
    done.is_clean(0);
    let words = done.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(words.matches("(not proven)").count(), 4, "{}", done.stdout);
    let plain = folder.run(&["solve", "model.toml", "--factors"]);
    assert!(!plain.stdout.contains("not proven"), "{}", plain.stdout);
}

#[test]
fn tables_have_a_bound_beside_each_field() {
    let folder = Folder::with(LIFTS);
    folder
        .run(&["solve", "model.toml", "--proven", "--csv", "t.csv", "--at", "0,0.5,1"])
        .is_clean(0);
    let table = folder.read("t.csv");
    let mut lines = table.lines();
    let head = lines.next().unwrap();
    assert!(head.starts_with("x,deflection,deflection_bound,slope,slope_bound,"), "{head}");
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        for bound in cells[1..].iter().skip(1).step_by(2) {
            let bound: f64 = bound.parse().unwrap();
            assert!((0.0..1e-10).contains(&bound), "{line}");
        }
    }
    // At a contact edge the pressure jumps within the bound of the edge's position.
    folder.run(&["solve", "model.toml", "--proven", "--csv", "t.csv"]).is_clean(0);
    assert!(folder.read("t.csv").lines().any(|line| line.ends_with(",(not proven)")));
    folder.run(&["solve", "model.toml", "--csv", "t.csv"]).is_clean(0);
    assert!(!folder.read("t.csv").contains("bound"));
}

#[test]
fn tables_of_combinations_have_bounds() {
    let model = combined() + "[checks]\nsettlement = 0.6\n";
    let folder = Folder::with(&model);
    let done = folder.run(&["solve", "model.toml", "--proven", "--csv", "t.csv"]);
    done.is_clean(0);
    let envelope = done.stdout.split("Envelope: smallest").nth(1).unwrap();
    let row = envelope.lines().find(|line| line.starts_with("Deflection")).unwrap();
    assert!(row.contains(" ± ") && row.contains(", #"), "{row}");
    assert!(done.stdout.contains("proven to pass; one"), "{}", done.stdout);
    assert!(done.stdout.lines().all(|line| line.chars().count() <= 80), "{}", done.stdout);
    assert!(
        folder.read("t.csv").starts_with(
            "x,deflection_min,deflection_max,deflection_min_bound,deflection_max_bound,"
        )
    );
    let document = folder.run(&["solve", "model.toml", "--proven", "--json"]).json();
    let (proof, count) = (&document["proof"], document["envelope"]["x"].as_array().unwrap().len());
    assert_eq!(proof["envelope"]["moment"]["max"].as_array().unwrap().len(), count);
    let of_each =
        |name: usize| document["combinations"][name]["proof"]["bounds"]["moment"].as_f64();
    let bound = proof["extremes"]["moment"]["max"].as_f64().unwrap();
    assert!(bound == of_each(0).unwrap() || bound == of_each(1).unwrap(), "{proof}");
    assert_eq!(proof["checks"][0]["combination"], "one");
}

#[test]
fn the_html_report_contains_the_bounds() {
    let folder = Folder::with(LIFTS);
    folder.run(&["solve", "model.toml", "--proven", "--report", "r.html"]).is_clean(0);
    let report = folder.read("r.html");
    assert!(
        report.contains("Results with their bounds")
            && report.contains("the error of every result")
    );
    assert!(report.matches(" ± ").count() > 20, "{}", report.matches(" ± ").count());
    folder.run(&["solve", "model.toml", "--report", "r.html"]).is_clean(0);
    let report = folder.read("r.html");
    // A solve without proof has an estimate.
    assert!(!report.contains(" ± ") && !report.contains("proven error"));
    let folder = Folder::with(&combined());
    folder.run(&["solve", "model.toml", "--proven", "--report", "r.html"]).is_clean(0);
    assert!(folder.read("r.html").contains("each of 2 combinations"));
}

/// Position intervals in a document are compared with the proven ones.
#[test]
fn claimed_positions_of_extremes_are_verified() {
    let folder = Folder::with(LIFTS);
    let mut document = folder.run(&["solve", "model.toml", "--proven", "--json"]).json();
    let place = document["proof"]["places"]["moment"]["max"][0].clone();
    let low = place[0].as_f64().unwrap();
    document["proof"]["places"]["moment"]["max"][0] = json!([low - 0.1, low - 0.05]);
    folder.write("result.json", document.to_string().as_bytes());
    let verified = folder.run(&["verify", "result.json", "model.toml"]);
    assert_eq!(verified.status, 1);
    let words = "claims positions of the largest moment";
    assert!(verified.stdout.contains(words), "{}", verified.stdout);
    // The same holds for the values on the left of a jump.
    let mut document = folder.run(&["solve", "model.toml", "--proven", "--json"]).json();
    let moment = document["left_of_jumps"]["moment"][0].as_f64().unwrap();
    document["left_of_jumps"]["moment"][0] = json!(moment + 1e-4);
    folder.write("result.json", document.to_string().as_bytes());
    assert_eq!(folder.run(&["verify", "result.json", "model.toml"]).status, 1);
}
