//! Checks that solutions and proofs have the same bits in WebAssembly as on the test machine.
//!
//! Needs the Rust target `wasm32-unknown-unknown`, and Python with the package `wasmtime`. Without them this test
//! reports that it was skipped, or fails if `GROUNDBEAM_DEMAND` names `wasm`.
//!
//! Claims: `docs/proof.md`.

use groundbeam::{Outcome, solve};
use groundbeam_report::{Context, json};
use groundbeam_testing::{environment, repository, succeed, tools_or_skip};
use groundbeam_verification::cases::{self, Case};
use groundbeam_wasm::results;
use rayon::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const TARGET: &str = "wasm32-unknown-unknown";

/// An input of `results` for every solution of the case files, with the path of its file.
fn inputs() -> Vec<(String, String)> {
    let cases: Vec<Case> = cases::all().into_iter().map(|case| case.expect("a case")).collect();
    cases.par_iter().flat_map_iter(inputs_of).collect()
}

fn inputs_of(case: &Case) -> Vec<(String, String)> {
    let file = fs::read_to_string(cases::folder().join(&case.path)).expect("a model file");
    let context = Context { pieces: true, model: true, ..Context::of(&case.document) };
    let one = |combination: groundbeam_file::Combination| {
        let Ok(Outcome::Equilibrium(solution)) = solve(&combination.model) else { return None };
        let document = json::solved(&solution, &json::default_stations(&solution), &context);
        Some((case.path.clone(), format!("{file}\0{}\0{document}", combination.name)))
    };
    case.document.wanted().into_iter().filter_map(one).collect()
}

/// Python with a WebAssembly runtime, if Rust can compile for WebAssembly.
fn runtime(workplace: &Path) -> Result<PathBuf, String> {
    let libraries = ["--print", "target-libdir", "--target", TARGET];
    let found = Command::new("rustc").current_dir(repository()).args(libraries).output();
    let found = found.map_err(|error| format!("rustc: {error}"))?;
    if !Path::new(String::from_utf8_lossy(&found.stdout).trim()).is_dir() {
        return Err(format!("`rustup target add {TARGET}` installs what is missing"));
    }
    environment(workplace, &["wasmtime>=50,<51"])
}

/// The WebAssembly module, compiled as in a release.
fn module(workplace: &Path) -> PathBuf {
    let mut build = Command::new(env!("CARGO"));
    build.current_dir(repository()).args(["build", "--locked", "--release", "--quiet"]);
    build.args(["--package", "groundbeam-wasm", "--target", TARGET, "--target-dir"]);
    succeed(build.arg(workplace));
    workplace.join(TARGET).join("release/groundbeam_wasm.wasm")
}

#[test]
fn solutions_and_proofs_have_the_same_bits_in_webassembly() {
    let workplace = Path::new(env!("CARGO_TARGET_TMPDIR")).join("wasm");
    let (python, subject) = (runtime(&workplace), "solver and proof in WebAssembly");
    let Some(python) = tools_or_skip(python, "wasm", subject) else { return };
    let texts = workplace.join("texts");
    let _ = fs::remove_dir_all(&texts);
    fs::create_dir_all(&texts).expect("a folder");
    let (module, inputs) = rayon::join(|| module(&workplace), inputs);
    for (i, (_, input)) in inputs.iter().enumerate() {
        fs::write(texts.join(format!("{i}.in")), input).expect("written");
    }
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/wasm.py");
    let run = || succeed(Command::new(python).arg(script).arg(module).arg(&texts));
    let here = || inputs.par_iter().map(|(_, input)| results(input)).collect::<Vec<String>>();
    let ((), here) = rayon::join(run, here);
    let (mut solved, mut bounded) = (0, 0);
    for (i, ((path, _), here)) in inputs.iter().zip(&here).enumerate() {
        let there = fs::read_to_string(texts.join(format!("{i}.out"))).expect("results");
        for (line, (here, there)) in here.lines().zip(there.lines()).enumerate() {
            assert_eq!(here, there, "{path}, line {} of its results", line + 1);
        }
        assert_eq!(here.lines().count(), there.lines().count(), "{path}");
        solved += usize::from(here.starts_with("solution: Ok(\n    Equilibrium("));
        bounded += usize::from(here.contains("\nwide: Ok("));
    }
    println!("{} documents, {solved} solved, {bounded} have bounds", inputs.len());
    assert_eq!(solved, inputs.len(), "documents whose model is solved");
    assert!(bounded >= 117, "only {bounded} documents have bounds");
}
