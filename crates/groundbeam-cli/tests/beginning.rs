//! Tests `groundbeam new` and `groundbeam compare`.

use crate::common::{FOOTING, Folder, LIFTS, tips};
use crate::solve::PRESSED;

#[test]
fn every_starter_model_is_solved_without_changes() {
    for kind in ["footing", "rail", "slab", "pipeline"] {
        let folder = Folder::new();
        let done = folder.run(&["new", "own.toml", "--kind", kind]);
        done.is_clean(0);
        assert_eq!(done.stdout, "wrote own.toml; next: groundbeam solve own.toml\n");
        let solved = folder.run(&["solve", "own.toml"]);
        solved.is_clean(0);
        assert!(!solved.stdout.contains("allowed: fails"), "{kind}");
        // All starter models except the slab show lift-off.
        let lifts = !solved.stdout.contains("Lift-off     none");
        assert_eq!(lifts, kind != "slab", "{kind}: {}", solved.stdout);
    }
}

#[test]
fn the_new_command_does_not_replace_files() {
    let folder = Folder::with(LIFTS);
    folder.run(&["new", "model.toml"]).fails(2, "`model.toml` exists already");
    // The default file name is not replaced either.
    folder.run(&["new"]).fails(2, "`model.toml` exists already");
    let kept = folder.read("model.toml");
    assert_eq!(kept, LIFTS);
}

#[test]
fn compare_lists_the_results_of_all_methods() {
    let folder = Folder::with(LIFTS);
    let coarse = folder.run(&["compare", "model.toml", "--elements", "10", "--json"]);
    coarse.is_clean(0);
    let fine = folder.run(&["compare", "model.toml", "--elements", "40", "--json"]);
    let (coarse, fine) = (coarse.json(), fine.json());
    let names: Vec<&str> = coarse["methods"]
        .as_array()
        .unwrap()
        .iter()
        .map(|row| row["method"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["exact", "active-set", "psor", "uzawa"]);
    for i in 1..4 {
        let error = |document: &serde_json::Value| {
            document["methods"][i]["errors"]["deflection"].as_f64().unwrap()
        };
        // Finer meshes have smaller errors. Each bound holds: squared relative errors are below the relative
        // gap.
        assert!(error(&fine) < error(&coarse), "{}", names[i]);
        assert!(error(&coarse) < 0.05, "{}", names[i]);
    }
    let table = folder.run(&["compare", "model.toml"]);
    table.is_clean(0);
    assert!(table.stdout.lines().all(|line| line.chars().count() <= 80));
}

#[test]
fn compare_reports_methods_that_stop_or_do_not_apply() {
    let few = Folder::with(LIFTS).run(&["compare", "model.toml", "--most-sweeps", "3"]);
    few.is_clean(4);
    assert!(few.stdout.contains("Not solved   psor: the method `psor` stopped after 3"));
    // A model that a method does not support is not a failure of this method.
    let pressed = Folder::with(PRESSED).run(&["compare", "model.toml"]);
    pressed.is_clean(0);
    assert!(pressed.stdout.contains("psor: this compression exceeds"));
    Folder::with(&tips()).run(&["compare", "model.toml"]).fails(3, "none: ");
    let one = "case = \"G\"\n[[combination]]\nname = \"one\"\nfactors = { G = 1.35 }\n";
    let combined = FOOTING.to_owned() + one;
    let folder = Folder::with(&combined);
    folder
        .run(&["compare", "model.toml"])
        .fails(2, "this file has combinations, a train or a band");
    let banded = FOOTING.replace("[[load]]", "[foundation.band]\nk = [0.5, 2]\n[[load]]");
    Folder::with(&banded).run(&["compare", "model.toml"]).fails(2, "or a band of the ground");
}

#[test]
fn compare_prints_a_document_without_an_equilibrium() {
    let folder = Folder::with(&tips());
    let done = folder.run(&["compare", "model.toml", "--json"]);
    done.is_clean(3);
    assert_eq!(done.json()["status"], "no-equilibrium");
}

#[test]
fn the_new_command_prints_a_command_for_the_shell() {
    let folder = Folder::new();
    for (name, shown, argument) in [
        ("my file.toml", "my file.toml", "'my file.toml'"),
        ("it's.toml", "it's.toml", r"'it'\''s.toml'"),
        ("-", "-", "./-"),
    ] {
        let done = folder.run(&["new", name]);
        done.is_clean(0);
        assert_eq!(done.stdout, format!("wrote {shown}; next: groundbeam solve {argument}\n"));
        assert!(folder.path(name).is_file());
    }
}

/// A limit of the file size makes the write fail after 512 or 1024 bytes.
#[cfg(target_os = "linux")]
#[test]
fn the_new_command_leaves_no_incomplete_file() {
    let folder = Folder::new();
    let script =
        format!("trap '' XFSZ; ulimit -f 1; {} new own.toml", env!("CARGO_BIN_EXE_groundbeam"));
    let mut shell = std::process::Command::new("sh");
    let done = shell.args(["-c", &script]).current_dir(folder.root()).output().unwrap();
    assert_eq!(done.status.code(), Some(2), "{done:?}");
    assert_eq!(folder.names(), [""; 0]);
}
