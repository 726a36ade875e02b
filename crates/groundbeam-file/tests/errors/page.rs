//! Generates `docs/diagnostics.md` from the table of codes and the files of `cases/errors/`, and compares it.

use super::cases::{ErrorCase, error_cases};
use groundbeam_file::{CODES, Code};
use groundbeam_testing::{expect_file, files, repository};
use std::fmt::Write;

#[test]
fn the_page_is_up_to_date() {
    let cases = error_cases();
    let mut page = String::from(
        "# Messages about files\n\n\
         Every message about a model file has one of these codes.\n\n\
         | codes | subject |\n|---|---|\n\
         | `GB001` to `GB099` | the text of the file |\n\
         | from `GB101` | the model |\n\
         | from `GB601` | the solve |\n\
         | from `GB701` | trains, studies, warnings |\n\n\
         This page is written by `UPDATE_EXPECTED=1 cargo test -p groundbeam-file`.\n\n\
         | code | fault, or rule that the file breaks |\n|---|---|\n",
    );
    for Code { code, meaning, .. } in CODES {
        writeln!(page, "| [{code}](#{}) | {meaning} |", code.to_lowercase()).unwrap();
    }
    for Code { code, meaning, remedy, page: section, example } in CODES {
        let (first, rest) = meaning.split_at(1);
        let first = first.to_uppercase();
        writeln!(page, "\n## {code}\n\n{first}{rest}.\n{remedy}").unwrap();
        writeln!(page, "See [{}]({}).", section.title, section.target).unwrap();
        let Some(example) = example else { continue };
        let Some(case) = cases.iter().find(|case| case.name == *example) else {
            panic!("{example}, the example of {code}, is not in cases/errors");
        };
        let message = first_of(case, code);
        writeln!(page, "\nFrom [{example}](../cases/errors/{example}):\n\n```text\n{message}```")
            .unwrap();
    }
    expect_file("docs/diagnostics.md", &page);
}

/// The first message with this code.
fn first_of(case: &ErrorCase, code: &str) -> String {
    let start = format!("error[{code}]");
    let messages = case.rendered.split("\n\n");
    match messages.into_iter().find(|message| message.starts_with(&start)) {
        Some(message) => format!("{}\n", message.trim_end()),
        None => panic!("{} does not show {code}", case.name),
    }
}

#[test]
fn error_codes_are_listed_in_ascending_order() {
    assert!(CODES.is_sorted_by(|a, b| a.code < b.code));
}

/// Every code of the core must have a row in the table.
#[test]
fn every_code_of_the_core_is_in_the_table() {
    let files = files(&repository().join("crates/groundbeam/src"), "rs");
    let source: String = files.iter().map(|path| std::fs::read_to_string(path).unwrap()).collect();
    assert!(source.contains("\"GB101\""));
    for piece in source.split("\"GB").skip(1) {
        let number = piece.split('"').next().unwrap();
        // `GB` alone is a unit of memory.
        if number.is_empty() {
            continue;
        }
        let code = format!("GB{number}");
        assert!(CODES.iter().any(|row| row.code == code), "{code} is not in the table");
    }
}
