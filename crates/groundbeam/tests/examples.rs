//! Tests that every example prints the text of the file beside it. `UPDATE_EXPECTED=1` writes this file.

use std::path::{Path, PathBuf};
use std::process::Command;

#[test]
fn examples_print_what_is_expected() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut count = 0;
    for entry in std::fs::read_dir(&folder).expect("the folder of examples") {
        let source = entry.expect("a file").path();
        if source.extension().is_none_or(|extension| extension != "rs") {
            continue;
        }
        count += 1;
        let name = source.file_stem().expect("a name").to_str().expect("text");
        let done = Command::new(program(name)).output().expect("the example runs");
        assert!(done.status.success(), "{name}: {}", String::from_utf8_lossy(&done.stderr));
        let printed = String::from_utf8(done.stdout).expect("text");
        let expected = source.with_extension("expected");
        if std::env::var_os("UPDATE_EXPECTED").is_some() {
            std::fs::write(&expected, &printed).expect("the file can be written");
        }
        let expected = std::fs::read_to_string(expected).expect("a file of what is expected");
        assert_eq!(printed, expected, "{name}");
    }
    assert!(count > 0);
}

/// The example's program, as `cargo test` builds it.
fn program(name: &str) -> PathBuf {
    let built = Command::new(env!("CARGO"))
        .args([
            "build",
            "--quiet",
            "--profile",
            "test",
            "--package",
            "groundbeam",
            "--example",
            name,
        ])
        .status();
    assert!(built.is_ok_and(|status| status.success()), "{name} can be built");
    let own = std::env::current_exe().expect("this test is a file");
    let folder = own.parent().and_then(Path::parent).expect("target/debug/deps");
    folder.join("examples").join(format!("{name}{}", std::env::consts::EXE_SUFFIX))
}
