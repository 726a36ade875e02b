//! Loads the files of `cases/errors/`.

use groundbeam_file::{Diagnostics, parse_beside, text_of};
use std::fs;
use std::path::{Path, PathBuf};

/// A faulty file.
pub struct ErrorCase {
    pub path: PathBuf,
    /// The file's name.
    pub name: String,
    /// The file's text. U+FFFD replaces bytes that are not UTF-8.
    pub text: String,
    /// Its lines `# error: CODE at LINE:COLUMN`.
    pub announced: Vec<String>,
    pub diagnostics: Diagnostics,
    pub rendered: String,
}

/// The root of the repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Every file in `cases/errors/`, by name.
pub fn error_cases() -> Vec<ErrorCase> {
    let folder = root().join("cases/errors");
    let mut paths: Vec<PathBuf> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    paths.sort();
    paths.into_iter().map(read).collect()
}

fn read(path: PathBuf) -> ErrorCase {
    let folder = path.parent().unwrap();
    let name = path.file_name().unwrap().to_str().unwrap().to_owned();
    let bytes = fs::read(&path).unwrap();
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let announced = text
        .trim_start_matches('\u{feff}')
        .lines()
        .take_while(|line| line.starts_with("# error: "))
        .map(str::to_owned)
        .collect();
    let diagnostics = match text_of(&bytes).and_then(|text| parse_beside(text, folder)) {
        Ok(_) => panic!("{name} is not wrong"),
        Err(diagnostics) => diagnostics,
    };
    let rendered = diagnostics.render(&name, &text, false);
    let rendered = rendered.replace(&format!("{}/", folder.display()), "");
    ErrorCase { path, name, text, announced, diagnostics, rendered }
}

/// Compares with the content of a file, or writes it if `UPDATE_EXPECTED` is set.
#[track_caller]
pub fn same_as_file(actual: &str, path: &Path) {
    if std::env::var_os("UPDATE_EXPECTED").is_some() {
        fs::write(path, actual).unwrap();
    }
    let expected = fs::read_to_string(path).unwrap_or_default();
    assert!(actual == expected, "{} differs from\n{actual}", path.display());
}
