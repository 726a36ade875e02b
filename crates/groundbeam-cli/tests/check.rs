//! Tests `groundbeam check`, and help and version of the command line.

use crate::common::{Folder, LIFTS, tips};

#[test]
fn check_reports_a_unique_equilibrium() {
    let folder = Folder::with(LIFTS);
    let done = folder.run(&["check", "model.toml"]);
    done.is_clean(0);
    assert!(done.stdout.contains("Equilibrium  exactly one: the resultant, 1 at x = 0.99,"));
    let done = folder.run(&["check", "model.toml", "--json"]);
    done.is_clean(0);
    assert_eq!(done.json()["status"], "equilibrium-exists");
    assert_eq!(done.json()["existence"]["verdict"], "unique");
}

#[test]
fn check_reports_a_missing_equilibrium() {
    let folder = Folder::with(&tips());
    let done = folder.run(&["check", "model.toml"]);
    done.is_clean(3);
    assert!(done.stdout.contains("Equilibrium  none: the resultant"));
    let done = folder.run(&["check", "model.toml", "--json"]);
    done.is_clean(3);
    assert_eq!(done.json()["status"], "no-equilibrium");
    assert!(done.json()["existence"]["failing_motion"].is_object());
}

#[test]
fn check_reports_an_equilibrium_that_is_not_unique() {
    let folder = Folder::with(&LIFTS.replace("0.49", "0.5"));
    let done = folder.run(&["check", "model.toml"]);
    done.is_clean(0);
    assert!(done.stdout.contains("Equilibrium  not unique"), "{}", done.stdout);
    let done = folder.run(&["check", "model.toml", "--json"]);
    assert_eq!(done.json()["existence"]["verdict"], "not-unique");
}

#[test]
fn check_refuses_an_invalid_model() {
    let folder = Folder::with("[beam]\nlength = 1\n");
    folder.run(&["check", "model.toml"]).fails(2, "model.toml");
    folder.run(&["check", "model.toml", "--json"]).fails(2, "error[GB004]");
}

#[test]
fn shell_completions_and_the_manual_are_printed() {
    let folder = Folder::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let done = folder.run(&["completions", shell]);
        done.is_clean(0);
        assert!(done.stdout.contains("most-sweeps"), "{shell}");
    }
    let done = folder.run(&["man"]);
    done.is_clean(0);
    for part in
        [".TH groundbeam 1", ".SH GROUNDBEAM SOLVE", "\\-\\-most\\-sweeps", "\n  3  the model"]
    {
        assert!(done.stdout.contains(part), "{part}");
    }
    for argument in ["--help", "--version"] {
        folder.run(&[argument]).is_clean(0);
    }
}

#[test]
fn schemas_of_model_and_study_files_are_printed() {
    let folder = Folder::new();
    for (arguments, key) in [(&["schema"][..], "support"), (&["schema", "--study"], "random")] {
        let done = folder.run(arguments);
        done.is_clean(0);
        let schema: serde_json::Value = serde_json::from_str(&done.stdout).unwrap();
        assert_eq!(schema["properties"][key]["type"], "array", "{arguments:?}");
    }
}
