//! Compares generated texts with files of the repository, and writes the files if `UPDATE_EXPECTED` is set.

use crate::files::{read, repository};
use std::ops::Range;

/// Whether `UPDATE_EXPECTED` is set in the environment. If it is set, tests write generated texts instead of
/// comparing them.
pub fn updating() -> bool {
    std::env::var_os("UPDATE_EXPECTED").is_some()
}

/// Returns the text between `<!-- begin NAME -->` and `<!-- end NAME -->` and the range of this text.
fn part<'a>(text: &'a str, name: &str) -> Option<(Range<usize>, &'a str)> {
    let (begin, end) = (format!("<!-- begin {name} -->\n"), format!("<!-- end {name} -->"));
    let from = text.find(&begin)? + begin.len();
    let to = from + text[from..].find(&end)?;
    Some((from..to, &text[from..to]))
}

/// Asserts that a part of a document equals the generated text. If [`updating`], writes the generated text instead.
#[track_caller]
pub fn expect(path: &str, name: &str, made: &str) {
    expect_by(path, name, made, |a, b| a == b);
}

/// Does the same as [`expect`], but the texts may differ in the ways that `alike` permits.
#[track_caller]
pub fn expect_by(path: &str, name: &str, made: &str, alike: impl Fn(&str, &str) -> bool) {
    let text = read(path);
    let (range, written) =
        part(&text, name).unwrap_or_else(|| panic!("{path} has no part `{name}`"));
    if !alike(written, made) {
        let mut whole = text.clone();
        whole.replace_range(range, made);
        update(path, &whole, &format!("`{name}` in {path}"), made);
    }
}

/// Asserts that a file equals the generated text. If [`updating`], writes the file instead.
#[track_caller]
pub fn expect_file(path: &str, made: &str) {
    expect_file_by(path, made, |recorded, made| recorded == made);
}

/// Does the same as [`expect_file`], but the texts may differ in the ways that `alike` permits.
#[track_caller]
pub fn expect_file_by(path: &str, made: &str, alike: impl Fn(&str, &str) -> bool) {
    let written = std::fs::read_to_string(repository().join(path)).unwrap_or_default();
    if !alike(&written, made) {
        update(path, made, path, made);
    }
}

/// Replaces a file that differs from the generated text. Panics if not [`updating`].
#[track_caller]
fn update(path: &str, whole: &str, name: &str, made: &str) {
    let how = "UPDATE_EXPECTED=1 cargo test --workspace";
    assert!(updating(), "{name} differs from the generated text; update it with `{how}`:\n{made}");
    // The file is replaced in one atomic step, because other tests may be reading it.
    let (file, new) = (repository().join(path), repository().join(format!("{path}.new")));
    std::fs::write(&new, whole).expect("the file can be written");
    std::fs::rename(new, file).expect("the file can be replaced");
}
