//! Checks that each file in `cases/errors/` gives the errors that its first lines announce, and the output in
//! the `.expected` file.
//!
//! `UPDATE_EXPECTED=1 cargo test -p groundbeam-file` rewrites the `.expected` files and
//! `docs/diagnostics.md`.

mod cases;
mod page;

use cases::{ERRORS, ErrorCase, error_cases};
use groundbeam_file::CODES;
use groundbeam_testing::expect_file;
use std::path::Path;

#[test]
fn every_error_is_found_at_its_location() {
    let cases = error_cases();
    assert!(cases.len() >= CODES.iter().filter(|row| row.example.is_some()).count());
    let mut wrong = Vec::new();
    for case in &cases {
        let found: Vec<String> = case
            .diagnostics
            .iter()
            .map(|d| {
                let file = d.file.as_ref().and_then(|file| Path::new(&file.name).file_name());
                let within = file.map_or(String::new(), |name| format!(" in {}", name.display()));
                format!("# error: {} at {}:{}{within}", d.code, d.line, d.column)
            })
            .collect();
        if case.announced != found {
            wrong.push(format!("{}\n{}\n", case.name, found.join("\n")));
        }
    }
    assert!(wrong.is_empty(), "found something else than announced:\n{}", wrong.join("\n"));
}

#[test]
fn every_message_has_the_expected_text() {
    for ErrorCase { name, rendered, .. } in error_cases() {
        expect_file(&format!("{ERRORS}/{}", name.replace(".toml", ".expected")), &rendered);
    }
}

#[test]
fn colour_adds_only_escape_codes() {
    for case in error_cases() {
        let folder = format!("{}/", case.path.parent().unwrap().display());
        let coloured = case.diagnostics.render(&case.name, &case.text, true).replace(&folder, "");
        assert!(coloured.contains("\u{1b}["));
        let mut plain = String::new();
        for (i, piece) in coloured.split('\u{1b}').enumerate() {
            plain.push_str(if i == 0 { piece } else { piece.split_once('m').unwrap().1 });
        }
        assert_eq!(plain, case.rendered);
    }
}
