//! `groundbeam verify --log` and `reference/replay.py`: the inequalities of proofs hold in ball arithmetic of another program.
//!
//! Skipped with a message where no python with python-flint is there. `PYTHON` names the python.

#[allow(dead_code)]
mod common;

use common::Folder;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn python() -> Option<Command> {
    let name = std::env::var("PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let found = Command::new(&name).args(["-c", "import flint"]).output();
    if found.is_ok_and(|done| done.status.success()) {
        return Some(Command::new(name));
    }
    println!("skipped: {name} has no python-flint");
    None
}

/// The log of a case, in its folder.
fn logged(case: &str) -> (Folder, String) {
    let model = std::fs::read_to_string(root().join(case)).expect("a case");
    let folder = Folder::with(&model);
    let solved = folder.run(&["solve", "model.toml", "--json", "--pieces"]);
    folder.write("result.json", solved.stdout.as_bytes());
    folder.run(&["verify", "result.json", "model.toml", "--log", "proof.log"]).is_clean(0);
    let log = folder.read("proof.log");
    (folder, log)
}

fn replay(mut python: Command, folder: &Folder, log: &str) -> (Option<i32>, String) {
    folder.write("changed.log", log.as_bytes());
    let script = root().join("reference/replay.py");
    let done: Output =
        python.arg(script).arg(folder.path("changed.log")).output().expect("python runs");
    let text = String::from_utf8_lossy(&[done.stdout, done.stderr].concat()).into_owned();
    (done.status.code(), text)
}

#[test]
fn every_line_of_a_log_is_an_object_with_a_name() {
    let (_, log) = logged("cases/kikuchi-1980/case-3.toml");
    let lines: Vec<Value> = log.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert!(lines.iter().all(|line| line["name"].is_string()));
    for name in ["problem", "node", "piece", "closing", "pull", "energy", "bounds", "unique"] {
        assert!(lines.iter().any(|line| line["name"] == name), "{name}");
    }
}

#[test]
fn logs_of_three_cases_replay() {
    for case in [
        "cases/kikuchi-1980/case-3.toml",
        "docs/strip-footing.toml",
        "cases/footings/grade-beam-between-piles.toml",
    ] {
        let (folder, log) = logged(case);
        let Some(python) = python() else { return };
        let (status, text) = replay(python, &folder, &log);
        assert_eq!(status, Some(0), "{case}: {text}");
        assert!(text.contains(" inequalities hold"), "{case}: {text}");
    }
}

/// Each number is changed by a tenth or less, in the direction in which the claim becomes stronger or the problem another.
#[test]
fn a_log_with_one_changed_number_fails() {
    let (folder, log) = logged("cases/kikuchi-1980/case-3.toml");
    let smaller = |value: &Value| json!(0.9 * value.as_f64().unwrap());
    type Change<'a> = (&'a str, &'a dyn Fn(&mut Value));
    let changes: [Change; 9] = [
        ("energy", &|line| line["E"] = smaller(&line["E"])),
        ("bounds", &|line| line["M"] = smaller(&line["M"])),
        ("bounds", &|line| line["u"] = smaller(&line["u"])),
        ("bounds", &|line| line["w"] = smaller(&line["w"])),
        ("bounds", &|line| line["slope"] = smaller(&line["slope"])),
        ("closing", &|line| line["bounds"][1] = smaller(&line["bounds"][1])),
        ("piece", &|line| line["w"][0][0] = json!(line["w"][0][0].as_f64().unwrap() + 1e-10)),
        ("piece", &|line| line["k"][0] = json!(line["k"][0].as_f64().unwrap() * 1.001)),
        ("node", &|line| line["F"][0] = json!(line["F"][0].as_f64().unwrap() + 1e-9)),
    ];
    for (i, (name, change)) in changes.iter().enumerate() {
        let mut left = true;
        let lines = log.lines().map(|text| {
            let mut line: Value = serde_json::from_str(text).unwrap();
            if line["name"] != *name || !left {
                return format!("{text}\n");
            }
            left = false;
            change(&mut line);
            format!("{line}\n")
        });
        let changed: String = lines.collect();
        let Some(python) = python() else { return };
        let (status, text) = replay(python, &folder, &changed);
        assert_eq!(status, Some(1), "change {i}: {text}");
    }
}
