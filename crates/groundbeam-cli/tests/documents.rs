//! Tests that console blocks and pictures in the documentation agree with the program.
//!
//! In `README.md` and `docs/`, a block that begins with `$ groundbeam …` contains that command and its
//! output. A line `<!-- drawn: groundbeam … --plot FILE.svg -->` names the command that draws a picture. The
//! commands run in the repository's root. `UPDATE_EXPECTED=1` rewrites the outputs.

use groundbeam_testing::{files, repository, updating};
use std::path::{Path, PathBuf};
use std::process::Command;

const BLOCK: &str = "```console\n$ groundbeam ";

#[test]
fn command_output_in_the_documents_is_up_to_date() {
    let mut count = 0;
    for path in documents() {
        let text = std::fs::read_to_string(&path).expect("a readable document");
        let mut made = String::new();
        let mut rest = text.as_str();
        while let Some(at) = rest.find(BLOCK) {
            let (before, block) = rest.split_at(at + BLOCK.len());
            let (command, block) = block.split_once('\n').expect("a command and its output");
            let end = block.find("```").expect("a block has an end");
            let printed = run(command);
            count += 1;
            assert!(
                updating() || alike(&block[..end], &printed),
                "{}: `groundbeam {command}` prints\n{printed}",
                path.display()
            );
            made.push_str(before);
            made.push_str(&format!("{command}\n{printed}"));
            rest = &block[end..];
        }
        made.push_str(rest);
        write_if_updating(&path, &text, &made);
    }
    assert!(count >= 3, "README.md shows what the program prints");
}

#[test]
fn pictures_are_drawn_by_the_program() {
    let mut count = 0;
    for path in documents() {
        let text = std::fs::read_to_string(&path).expect("a readable document");
        for line in text.lines() {
            let Some(command) = line.strip_prefix("<!-- drawn: groundbeam ") else { continue };
            let command = command.trim_end_matches(" -->");
            let (command, picture) = command.split_once(" --plot ").expect("--plot FILE.svg");
            let folder = tempfile::tempdir().expect("a folder");
            let drawn = folder.path().join("drawn.svg");
            // A study needs a file for its samples, which this test discards.
            let results = folder.path().join("results.parquet").display().to_string();
            let command = command.replace("results.parquet", &results);
            run(&format!("{command} --plot {}", drawn.display()));
            let drawn = std::fs::read_to_string(drawn).expect("a picture");
            let picture = repository().join(picture);
            if updating() {
                std::fs::write(&picture, &drawn).expect("the picture can be written");
            }
            let kept = std::fs::read_to_string(&picture).expect("the picture");
            assert!(kept == drawn, "{} is not what `{command}` draws", picture.display());
            count += 1;
        }
    }
    assert!(count >= 1, "README.md has a picture");
}

fn documents() -> Vec<PathBuf> {
    let pages = files(&repository().join("docs"), "md");
    std::iter::once(repository().join("README.md")).chain(pages).collect()
}

/// Both streams of a command, one after the other.
fn run(command: &str) -> String {
    let done = Command::new(env!("CARGO_BIN_EXE_groundbeam"))
        .args(command.split_whitespace())
        .current_dir(repository())
        .output()
        .expect("the program runs");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
    text(done.stdout) + &text(done.stderr)
}

fn write_if_updating(path: &Path, before: &str, after: &str) {
    // Differences in time or rounding alone do not change the document.
    if updating() && before != after && !alike(before, after) {
        std::fs::write(path, after).expect("the document can be written");
    }
}

/// Whether two texts are equal except for times and rounding.
fn alike(a: &str, b: &str) -> bool {
    a.lines().count() == b.lines().count()
        && a.lines().zip(b.lines()).all(|(a, b)| a == b || steady(a) == steady(b))
}

/// A line without numbers that depend on the machine.
fn steady(line: &str) -> String {
    let rounding = [
        "energy gap",
        "balance ",
        "the beam enters",
        "right to ±",
        "Method ",
        // Lines of `groundbeam compare`: only the method names are compared.
        "exact   ",
        "active-set",
        "psor   ",
        "uzawa   ",
    ];
    if !rounding.iter().any(|word| line.contains(word)) {
        return line.to_owned();
    }
    let words = line.split_whitespace().map(|word| word.trim_end_matches(','));
    let kept =
        words.filter(|word| word.parse::<f64>().is_err() && !["µs", "ms", "s"].contains(word));
    kept.collect::<Vec<_>>().join(" ")
}
