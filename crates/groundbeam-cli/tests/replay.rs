//! Tests `groundbeam verify --log` and `reference/replay`: a second program with ball arithmetic confirms the
//! inequalities of proofs.
//!
//! Needs Python from 3.10 on and python-flint from its index. Without them the tests report that they were
//! skipped, or fail if `GROUNDBEAM_DEMAND` names `python`.
//!
//! Claims: `docs/proof.md`.

use crate::common::Folder;
use groundbeam_testing::{environment, files, repository, tools_or_skip};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

/// Python with the arithmetic of the replay.
fn python() -> Option<Command> {
    static MADE: LazyLock<Result<PathBuf, String>> = LazyLock::new(|| {
        let workplace = Path::new(env!("CARGO_TARGET_TMPDIR")).join("replay");
        environment(&workplace, &["python-flint==0.9.0"])
    });
    tools_or_skip(MADE.clone(), "python", "the replay of proofs").map(Command::new)
}

/// A folder with the document of a case and the log of its proof; `None` if the case has no solution.
fn logged(case: &Path) -> Option<Folder> {
    let (folder, case) = (Folder::new(), repository().join(case));
    let case = case.to_str().expect("a path");
    let solved = folder.run(&["solve", case, "--json", "--pieces"]);
    folder.write("result.json", solved.stdout.as_bytes());
    folder.run(&["verify", "result.json", case, "--log", "proof.log"]);
    folder.path("proof.log").exists().then_some(folder)
}

/// Replays a log and compares it with the document in the folder.
fn replay(mut python: Command, folder: &Folder, log: &str) -> (Option<i32>, String) {
    folder.write("changed.log", log.as_bytes());
    let done: Output = python
        .arg(repository().join("reference/replay"))
        .args([folder.path("changed.log"), folder.path("result.json")])
        .output()
        .expect("python runs");
    let text = String::from_utf8_lossy(&[done.stdout, done.stderr].concat()).into_owned();
    (done.status.code(), text)
}

#[test]
fn every_line_of_a_log_is_an_object_with_a_name() {
    let folder = logged(Path::new("cases/kikuchi-1980/case-3.toml")).expect("a log");
    let log = folder.read("proof.log");
    let lines: Vec<Value> = log.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert!(lines.iter().all(|line| line["name"].is_string()));
    for name in ["problem", "node", "piece", "closing", "pull", "energy", "bounds", "unique"] {
        assert!(lines.iter().any(|line| line["name"] == name), "{name}");
    }
}

/// All kinds of proof lines are replayed. A result without proof, such as a combination that tips, is
/// reported as such.
#[test]
fn the_logs_of_all_cases_replay() {
    let mut replayed = 0;
    let all = ["cases", "crates/groundbeam-cli/tests/replayed"]
        .map(|name| files(&repository().join(name), "toml"));
    let faulty = repository().join("cases/errors");
    for case in all.concat().into_iter().filter(|case| !case.starts_with(&faulty)) {
        let Some(python) = python() else { return };
        let Some(folder) = logged(&case) else { continue };
        let (status, text) = replay(python, &folder, &folder.read("proof.log"));
        assert_ne!(status, Some(1), "{}: {text}", case.display());
        for line in text.lines().filter(|line| !line.contains(" contributes at most ")) {
            let known = line.ends_with(" inequalities hold")
                || line.ends_with("not replayed: the log has no proof of this result");
            assert!(known, "{}: {line}", case.display());
        }
        replayed += usize::from(status == Some(0));
    }
    assert!(replayed >= 90, "{replayed}");
}

type Change<'a> = (&'a str, &'a dyn Fn(&mut Value));

/// Replays the log of a case after each change. The change applies to the first suitable line, and the replay
/// must refuse it.
fn refused(case: &str, changes: &[Change]) {
    let folder = logged(Path::new(case)).expect("a log");
    let log = folder.read("proof.log");
    for (i, (name, change)) in changes.iter().enumerate() {
        let mut left = true;
        let lines = log.lines().map(|text| {
            let before: Value = serde_json::from_str(text).unwrap();
            let mut line = before.clone();
            if left && line["name"] == *name {
                change(&mut line);
                left = line == before;
            }
            format!("{line}\n")
        });
        let changed: String = lines.collect();
        assert!(!left, "{case}: change {i} changes nothing");
        let Some(python) = python() else { return };
        let (status, text) = replay(python, &folder, &changed);
        assert_eq!(status, Some(1), "{case}: change {i}: {text}");
    }
}

/// Multiplies the number at a place of a line, if there is one.
fn times(line: &mut Value, place: &str, factor: f64) {
    if let Some(number) = line.pointer_mut(place)
        && let Some(x) = number.as_f64()
    {
        *number = json!(factor * x);
    }
}

/// Each number changes by at most a tenth, in the direction that strengthens the claim or changes the
/// problem.
#[test]
fn a_log_with_one_changed_number_fails() {
    refused(
        "cases/kikuchi-1980/case-3.toml",
        &[
            ("energy", &|line| times(line, "/E", 0.9)),
            ("bounds", &|line| times(line, "/M", 0.9)),
            ("bounds", &|line| times(line, "/u", 0.9)),
            ("bounds", &|line| times(line, "/w", 0.9)),
            ("bounds", &|line| times(line, "/slope", 0.9)),
            ("bounds", &|line| times(line, "/V", 0.9)),
            ("closing", &|line| times(line, "/bounds/1", 0.9)),
            ("piece", &|line| {
                line["w"][0][0] = json!(line["w"][0][0].as_f64().unwrap() + 1e-10);
            }),
            ("piece", &|line| times(line, "/k/0", 1.001)),
            ("node", &|line| line["F"][0] = json!(line["F"][0].as_f64().unwrap() + 1e-9)),
            ("edge", &|line| times(line, "/edge/3", 0.5)),
            ("ground beside the beam", &|line| times(line, "/stretches/0/1/0/0", 1.001)),
        ],
    );
}

#[test]
fn logs_of_other_kinds_of_models_with_one_changed_number_fail() {
    refused(
        "cases/footings/deep-footing-that-shears.toml",
        &[
            ("bounds", &|line| times(line, "/rotation", 0.9)),
            ("bounds", &|line| times(line, "/V", 0.9)),
            ("piece", &|line| times(line, "/S/0", 1.001)),
            ("round", &|line| times(line, "/edges/0/3", 0.5)),
            ("clearance", &|line| times(line, "/lifted", 0.9)),
        ],
    );
    refused(
        "cases/footings/anchored-slab-on-bearings.toml",
        &[
            ("support", &|line| times(line, "/errors/0", 0.9)),
            ("support", &|line| times(line, "/claimed/0/0", 1.0 + 1e-9)),
            ("node", &|line| {
                line["acts"] = json!(-line["acts"].as_i64().unwrap());
            }),
        ],
    );
    refused(
        "cases/ground/neighbour-beside-and-below.toml",
        &[
            ("piece", &|line| times(line, "/q/0/0", 1.001)),
            ("problem", &|line| times(line, "/pushed/0/0", 1.001)),
        ],
    );
    refused(
        "cases/footings/haunched-footing-on-ground-that-softens.toml",
        &[("piece", &|line| times(line, "/k/1/0", 1.001))],
    );
    refused(
        "cases/limits/compression-below-buckling-on-springs.toml",
        &[
            ("problem", &|line| line["sigma"] = json!(0.5 + 0.5 * line["sigma"].as_f64().unwrap())),
            ("bounds", &|line| times(line, "/m", 0.9)),
        ],
    );
    refused(
        "cases/footings/rail-that-lifts-off-ahead-of-the-wheel.toml",
        &[("zone", &|line| times(line, "/length", 0.4))],
    );
}

/// A log with a missing line is refused by name, or an inequality fails without that line's data.
#[test]
fn a_log_with_a_missing_line_is_refused() {
    let folder = logged(Path::new("cases/kikuchi-1980/case-3.toml")).expect("a log");
    let log = folder.read("proof.log");
    for name in ["piece", "closing", "pull", "bounds", "edge", "unique", "contact set"] {
        let Some(python) = python() else { return };
        let wanted = format!("{{\"name\":\"{name}\"");
        let left = log.lines().position(|line| line.starts_with(&wanted)).expect("such a line");
        let kept = log.lines().enumerate().filter(|(i, _)| *i != left);
        let changed: String = kept.map(|(_, line)| format!("{line}\n")).collect();
        let (status, text) = replay(python, &folder, &changed);
        let refused = status == Some(1) || text.contains("not replayed: ");
        assert!(refused && status != Some(0), "{name}: {text}");
    }
}

/// The log of the correct document does not confirm a document with another piece, edge, reaction or a
/// smaller bound.
#[test]
fn a_changed_document_is_refused() {
    let case = repository().join("cases/footings/anchored-slab-on-bearings.toml");
    let folder = logged(&case).expect("a log");
    let proven = folder.run(&["solve", case.to_str().expect("a path"), "--json", "--proven"]);
    let document: Value = serde_json::from_str(&proven.stdout).unwrap();
    let moved = |value: &mut Value| {
        let x = value["pieces"][0]["x"][1].as_f64().unwrap() * (1.0 + 1e-12);
        value["pieces"][0]["x"][1] = json!(x);
        value["pieces"][1]["x"][0] = json!(x);
    };
    let changes: [(&dyn Fn(&mut Value), i32); 5] = [
        (&|_| {}, 0),
        (&|value| times(value, "/pieces/1/deflection/2", 1.0 + 1e-15), 1),
        (&moved, 1),
        (&|value| times(value, "/reactions/0/force", 1.0 + 1e-12), 1),
        (&|value| times(value, "/proof/bounds/moment", 0.9), 1),
    ];
    for (i, (change, wanted)) in changes.iter().enumerate() {
        let mut changed = document.clone();
        change(&mut changed);
        folder.write("result.json", changed.to_string().as_bytes());
        let Some(python) = python() else { return };
        let (status, text) = replay(python, &folder, &folder.read("proof.log"));
        assert_eq!(status, Some(*wanted), "change {i}: {text}");
    }
}
