//! Tests the JSON Schema of model files and study files with a validator for Python: it accepts every valid
//! file of the repository, and refuses the files of `cases/errors` with an unknown key or a value of a wrong
//! type.
//!
//! Needs Python from 3.10 on and packages from its index. Without them this test reports that it was skipped,
//! or fails if `GROUNDBEAM_DEMAND` names `python`.

use groundbeam_testing::{environment, files, repository, tools_or_skip};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const NEEDS: [&str; 2] = ["jsonschema>=4.20,<5", "tomli>=2; python_version < '3.11'"];

/// The validator's verdict on each file.
fn judge(python: &Path, workplace: &Path, files: &[PathBuf]) -> Vec<String> {
    let schemas = [
        ("model.json", groundbeam_file::model_schema()),
        ("study.json", groundbeam_file::study_schema()),
    ];
    for (name, schema) in &schemas {
        fs::write(workplace.join(name), schema).expect("written");
    }
    let line = |path: &PathBuf| {
        let text = String::from_utf8_lossy(&fs::read(path).expect("a file")).into_owned();
        let is_study = text.lines().any(|line| line.starts_with("model = "));
        let schema = workplace.join(if is_study { "study.json" } else { "model.json" });
        format!("{}\t{}\n", schema.display(), path.display())
    };
    let list: String = files.iter().map(line).collect();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/schema.py");
    let mut run = Command::new(python);
    let mut run = run.arg(script).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    run.stdin.take().expect("a pipe").write_all(list.as_bytes()).expect("written");
    let done = run.wait_with_output().expect("Python runs");
    assert!(done.status.success(), "the validator stopped");
    String::from_utf8(done.stdout).expect("text").lines().map(str::to_owned).collect()
}

#[test]
fn the_schema_accepts_valid_files_and_refuses_wrong_keys_and_types() {
    let workplace = Path::new(env!("CARGO_TARGET_TMPDIR")).join("schema");
    let python = environment(&workplace, &NEEDS);
    let Some(python) = tools_or_skip(python, "python", "the JSON Schema") else { return };
    let folders = ["cases", "docs", "bench", "crates/groundbeam-cli/starters"];
    let all: Vec<PathBuf> =
        folders.iter().flat_map(|folder| files(&repository().join(folder), "toml")).collect();
    let all: Vec<PathBuf> = all.into_iter().filter(|path| !path.ends_with("Cargo.toml")).collect();
    let judged = judge(&python, &workplace, &all);
    assert_eq!(judged.len(), all.len());
    let (mut accepted, mut refused) = (0, 0);
    for (path, judged) in all.iter().zip(&judged) {
        let name = path.display();
        if !path.starts_with(repository().join("cases/errors")) {
            assert_eq!(judged, "accepted", "{name}");
            accepted += 1;
            continue;
        }
        let text = String::from_utf8_lossy(&fs::read(path).expect("a file")).into_owned();
        if ["error: GB003", "error: GB005"].iter().any(|code| text.contains(code)) {
            // A validator cannot read a file with wrong TOML syntax.
            let expected = if text.contains("error: GB001") { "unreadable: " } else { "refused: " };
            assert!(judged.starts_with(expected), "{name}: {judged}");
            refused += 1;
        }
    }
    assert!(accepted > 100 && refused > 10, "{accepted} accepted, {refused} refused");
    println!("{accepted} files are accepted, {refused} are refused");
}
