//! Tests `groundbeam verify`: every exit status with a real document, and the comparison of every listed
//! number.

use crate::common::{Done, FOOTING, Folder, LIFTS, combined};
use serde_json::{Value, json};

/// A pin, and a spring support with a settlement.
const SUPPORTED: &str = "\
[beam]
length = 4
EI = 3
[foundation]
k = 2
mu = 0.5
[[support]]
at = 0
type = 'pinned'
[[support]]
at = 3
spring = 7
rotational_spring = 2
settlement = 0.01
[[load]]
distributed = 1.5
[[load]]
point = -2
at = 2.5
";

/// The position of the extreme pressure is the floating-point number next to the position of the force, where
/// the shear force jumps.
const CENTRAL: &str = "\
[beam]
length = 2
EI = 1
[foundation]
k = 4
[[load]]
point = 1
at = 1
";

fn solved(model: &str, options: &[&str]) -> (Folder, Value) {
    let folder = Folder::with(model);
    let done = folder.run(&[&["solve", "model.toml", "--json", "--pieces"], options].concat());
    done.is_clean(0);
    folder.write("result.json", done.stdout.as_bytes());
    (folder, done.json())
}

fn verify(folder: &Folder, options: &[&str]) -> Done {
    folder.run(&[&["verify", "result.json", "model.toml"], options].concat())
}

fn with(folder: &Folder, document: &Value) -> Done {
    folder.write("result.json", document.to_string().as_bytes());
    verify(folder, &[])
}

#[test]
fn correct_documents_are_proven() {
    for model in [LIFTS, FOOTING, SUPPORTED, CENTRAL] {
        let (folder, _) = solved(model, &[]);
        let done = verify(&folder, &[]);
        println!("{}", done.stdout);
        done.is_clean(0);
        assert!(done.stdout.contains("Proven "), "{}", done.stdout);
        assert!(done.stdout.lines().all(|line| line.chars().count() <= 80), "{}", done.stdout);
        let done = verify(&folder, &["--json"]);
        done.is_clean(0);
        let found = done.json();
        assert_eq!(found["status"], "proven");
        let bound = &found["results"][0]["bounds"]["moment"];
        let (error, scale) = (bound["error"].as_f64().unwrap(), bound["scale"].as_f64().unwrap());
        assert!(error < 1e-10 * scale, "{bound}");
    }
}

#[test]
fn keys_that_are_not_covered_are_named_and_strict_refuses_them() {
    let (folder, mut document) = solved(LIFTS, &[]);
    let done = verify(&folder, &["--strict"]);
    assert_eq!(done.status, 1);
    assert!(done.stdout.contains("Not covered") && done.stdout.contains("certificate"));
    let covered = [
        "status",
        "units",
        "pieces",
        "forces",
        "reactions",
        "contact",
        "end_forces",
        "stations",
        "extremes",
        "model_digest",
    ];
    document.as_object_mut().unwrap().retain(|key, _| covered.contains(&key.as_str()));
    folder.write("result.json", document.to_string().as_bytes());
    verify(&folder, &["--strict"]).is_clean(0);
}

#[test]
fn a_document_of_another_model_is_reported() {
    let (folder, mut document) = solved(LIFTS, &[]);
    folder.write("model.toml", LIFTS.replace("0.49", "0.4901").as_bytes());
    let done = verify(&folder, &[]);
    assert_eq!(done.status, 1);
    assert!(done.stdout.contains("belongs to another model file"), "{}", done.stdout);
    // The units are those of the model file.
    let (other, mut in_others) = solved(FOOTING, &[]);
    in_others["units"] = json!("none");
    let done = with(&other, &in_others);
    assert_eq!(done.status, 1);
    assert!(done.stdout.contains("the units of the document are `none`"), "{}", done.stdout);
    // Without the digest, the numbers show the difference.
    document.as_object_mut().unwrap().remove("model_digest");
    let done = with(&folder, &document);
    assert_eq!(done.status, 1);
    assert!(done.stdout.starts_with("Not proven"), "{}", done.stdout);
}

#[test]
fn unreadable_documents_are_reported() {
    let (folder, document) = solved(LIFTS, &[]);
    let text = document.to_string();
    let wrong = [
        text.replacen("\"half\":", "\"half\":1,\"half\":", 1),
        text.replacen("\"half\":0.", "\"half\":NaN,\"a\":0.", 1),
        text.replacen("\"half\":0.", "\"half\":1e999,\"a\":0.", 1),
        format!("{text} x"),
        text[..text.len() - 1].to_owned(),
        "{}".to_owned() + "{}",
        "{\"combinations\": []}".to_owned(),
    ];
    for wrong in wrong {
        assert_ne!(wrong, text);
        folder.write("result.json", wrong.as_bytes());
        verify(&folder, &[]).fails(2, "result.json: ");
    }
    folder.write("result.json", b"");
    verify(&folder, &[]).fails(2, "the file is empty; `groundbeam solve MODEL --json --pieces`");
    folder.run(&["verify", "-", "-"]).fails(2, "cannot both be `-`");
    folder.write("result.json", b"\xff");
    verify(&folder, &[]).fails(2, "result.json: ");
    folder.run(&["verify", "missing.json", "model.toml"]).fails(2, "missing.json: ");
    folder.write("result.json", text.as_bytes());
    folder.write("model.toml", LIFTS.replace("EI = 1", "EI = -1").as_bytes());
    verify(&folder, &[]).fails(2, "error[GB102]");
    folder.write("model.toml", LIFTS.as_bytes());
    folder.write("result.json", b"{\"status\": \"solved\"}");
    let done = verify(&folder, &[]);
    assert_eq!(done.status, 1);
    assert!(done.stdout.contains("has no `pieces`"), "{}", done.stdout);
}

#[test]
fn each_combination_is_proven() {
    let model = combined();
    let (folder, mut document) = solved(&model, &[]);
    let done = verify(&folder, &[]);
    done.is_clean(0);
    assert_eq!(done.stdout.matches("Proven ").count(), 2);
    // Each combination under its own loads.
    let right = document.clone();
    document["combinations"][0]["name"] = json!("two");
    document["combinations"][1]["name"] = json!("one");
    assert_eq!(with(&folder, &document).status, 1);
    // Repeated data must agree, and no combination may occur twice.
    for (pointer, value) in [
        ("/combinations/1/name", json!("one")),
        ("/combinations/0/combination", json!("two")),
        ("/units", json!("kip, inch")),
        ("/model_digest", json!("sha256:00")),
    ] {
        let mut changed = right.clone();
        let (parent, key) = pointer.rsplit_once('/').expect("a key");
        changed.pointer_mut(parent).expect("an object")[key] = value;
        changed["combinations"][0]["units"] = json!("none");
        changed["combinations"][0]["model_digest"] = right["model_digest"].clone();
        assert_eq!(with(&folder, &changed).status, 2, "{pointer}");
    }
    document = right;
    document["combinations"][1]["name"] = json!("three");
    let done = with(&folder, &document);
    assert_eq!(done.status, 1);
    assert!(done.stdout.contains("no combination `three`"), "{}", done.stdout);
    let (folder, _) = solved(&model, &["--combination", "two"]);
    verify(&folder, &[]).is_clean(0);
}

/// Every number of a document, as a path of keys.
fn numbers(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Number(_) => found.push(path.to_owned()),
        Value::Array(items) => {
            for (i, item) in items.iter().enumerate() {
                numbers(item, &format!("{path}/{i}"), found);
            }
        }
        Value::Object(entries) => {
            for (key, entry) in entries {
                numbers(entry, &format!("{path}/{key}"), found);
            }
        }
        _ => {}
    }
}

#[test]
fn every_listed_number_is_compared() {
    for model in [LIFTS, SUPPORTED] {
        let (folder, document) = solved(model, &["--at", "0,0.3,0.6,0.9,1"]);
        let mut paths = Vec::new();
        let listed =
            ["pieces", "forces", "reactions", "contact", "end_forces", "stations", "extremes"];
        for key in listed {
            numbers(&document[key], &format!("/{key}"), &mut paths);
        }
        let mut tried = 0;
        for path in paths {
            let value = document.pointer(&path).unwrap().as_f64().unwrap();
            // The position of a reaction is not covered. A constant field has the same value at a shifted
            // position.
            let skipped = (path.starts_with("/reactions") && path.ends_with("/at"))
                || path.ends_with("/support")
                || path.starts_with("/stations/x")
                || (path.starts_with("/extremes") && path.ends_with("/x"));
            if value.abs() < 1e-6 || skipped {
                continue;
            }
            let mut changed = document.clone();
            *changed.pointer_mut(&path).unwrap() = json!(value * 1.001);
            let done = with(&folder, &changed);
            // The highest coefficients of a piece change the solution by less than a millionth.
            let negligible = path.starts_with("/pieces") && done.status == 0;
            assert!(done.status == 1 || negligible, "{path}: {}", done.stdout);
            tried += 1;
        }
        assert!(tried > 60, "{tried}");
    }
}

#[test]
fn the_listed_attacks_end_with_their_expected_status() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/attacks.json");
    let all: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    for attack in all.as_array().unwrap() {
        let folder = Folder::with(attack["model"].as_str().unwrap());
        let claimed = match &attack["claimed_text"] {
            Value::String(text) => text.clone(),
            _ => attack["claimed"].to_string(),
        };
        folder.write("result.json", claimed.as_bytes());
        let done = verify(&folder, &[]);
        let name = &attack["name"];
        match attack["exit"].as_i64() {
            Some(exit) => assert_eq!(i64::from(done.status), exit, "{name}: {done:?}"),
            None => assert!([0, 1].contains(&done.status), "{name}: {done:?}"),
        }
        assert!(attack["expected"] != "refused" || done.status != 0, "{name}");
    }
}

/// A document of one combination belongs to the file. The missing combinations are named.
#[test]
fn combinations_that_the_document_leaves_out_are_named() {
    let folder = Folder::with(&combined());
    let one = ["solve", "model.toml", "--json", "--pieces", "--combination", "two"];
    folder.write("result.json", folder.run(&one).stdout.as_bytes());
    let done = verify(&folder, &[]);
    done.is_clean(0);
    let words = "Document     1 of 2 combinations of the file; left out: one";
    assert!(done.stdout.contains(words), "{}", done.stdout);
    let left_out = &verify(&folder, &["--json"]).json()["left_out"];
    assert_eq!(*left_out, json!({"all": 2, "names": ["one"]}));
    let all = folder.run(&["solve", "model.toml", "--json", "--pieces"]);
    folder.write("result.json", all.stdout.as_bytes());
    assert!(!verify(&folder, &[]).stdout.contains("left out"));
}

/// The shear force in documents is M′, also under a distributed moment.
#[test]
fn the_shear_force_under_a_distributed_moment_is_the_derivative_of_the_moment() {
    let model = format!("{FOOTING}[[load]]\ndistributed_moment = '5 kN m/m'\n");
    let (folder, document) = solved(&model, &[]);
    verify(&folder, &[]).is_clean(0);
    let mut wrong = document.clone();
    let value = document["extremes"]["shear_force"]["max"]["value"].as_f64().unwrap();
    wrong["extremes"]["shear_force"]["max"]["value"] = json!(value - 5e3);
    assert_eq!(with(&folder, &wrong).status, 1);
}

/// Near an extreme the values are almost constant, so its position is compared separately.
#[test]
fn positions_of_extremes_are_compared() {
    let (folder, document) = solved(include_str!("../../../docs/strip-footing.toml"), &[]);
    let places = verify(&folder, &["--json"]).json()["results"][0]["places"].clone();
    let of = |field: &str, extreme: &str| {
        let all = places.as_array().unwrap().iter();
        let mut found = all.filter(|p| p["field"] == field && p["extreme"] == extreme);
        found.next().unwrap()["places"].clone()
    };
    // The largest moment is under the load. The slope is smallest where the moment vanishes.
    assert_eq!(of("moment", "max"), json!([[1.5, 1.5]]));
    let listed = document["extremes"]["slope"]["min"]["x"].as_f64().unwrap();
    let place = of("slope", "min");
    let [low, high] = [0, 1].map(|end| place[0][end].as_f64().unwrap());
    assert!(low <= listed + 1e-12 && listed <= high + 1e-12 && high - low < 1e-6, "{place}");
    let mut wrong = document.clone();
    wrong["extremes"]["slope"]["min"]["x"] = json!(listed + 1e-4);
    let done = with(&folder, &wrong);
    assert_eq!(done.status, 1);
    assert!(
        done.stdout.contains("the listed position of the smallest slope is wrong"),
        "{}",
        done.stdout
    );
}

#[test]
fn the_log_does_not_replace_an_input() {
    let (folder, _) = solved(LIFTS, &[]);
    for input in ["model.toml", "result.json"] {
        let kept = folder.read(input);
        verify(&folder, &["--log", input]).fails(2, "this is the same file as the input");
        assert_eq!(folder.read(input), kept);
    }
}

#[test]
fn the_second_reader_also_reads_a_fillet_of_zero() {
    let section =
        "shape = 'I', width = 0.3, height = [0.6, 0.5], flange = 0.1, web = 0.1, fillet = 0";
    let model = LIFTS.replace("EI = 1", &format!("E = 1000\nsection = {{ {section} }}"));
    let (folder, _) = solved(&model, &[]);
    verify(&folder, &[]).is_clean(0);
}
