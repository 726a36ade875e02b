//! Tests that every example prints the text of the file beside it. `UPDATE_EXPECTED=1` writes this file.

use std::path::{Path, PathBuf};
use std::process::Command;

#[test]
fn examples_print_the_expected_output() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let entries = std::fs::read_dir(&folder).expect("the folder of examples");
    let mut sources: Vec<PathBuf> = entries.map(|entry| entry.expect("a file").path()).collect();
    sources.retain(|path| path.extension().is_some_and(|extension| extension == "rs"));
    assert!(!sources.is_empty());
    let name = |source: &PathBuf| -> String {
        source.file_stem().expect("a name").to_str().expect("text").to_owned()
    };
    let programs = programs(&sources.iter().map(name).collect::<Vec<_>>());
    for (source, program) in sources.iter().zip(programs) {
        let name = name(source);
        let done = Command::new(program).output().expect("the example runs");
        assert!(done.status.success(), "{name}: {}", String::from_utf8_lossy(&done.stderr));
        let printed = String::from_utf8(done.stdout).expect("text");
        let expected = source.with_extension("expected");
        if std::env::var_os("UPDATE_EXPECTED").is_some() {
            std::fs::write(&expected, &printed).expect("the file can be written");
        }
        let expected = std::fs::read_to_string(expected).expect("a file of what is expected");
        assert_eq!(printed, expected, "{name}");
    }
}

/// The examples' programs, as `cargo test` builds them.
fn programs(names: &[String]) -> Vec<PathBuf> {
    let mut build = Command::new(env!("CARGO"));
    build.args(["build", "--quiet", "--profile", "test"]);
    // The library has this feature if all packages are tested at once: another choice would compile it again.
    if cfg!(feature = "serde") {
        build.arg("--workspace");
    } else {
        build.args(["--package", "groundbeam"]);
    }
    build.args(names.iter().flat_map(|name| ["--example", name]));
    assert!(build.status().is_ok_and(|status| status.success()), "the examples can be built");
    let own = std::env::current_exe().expect("this test is a file");
    let folder = own.parent().and_then(Path::parent).expect("target/debug/deps").join("examples");
    let program = |name: &String| folder.join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
    names.iter().map(program).collect()
}
