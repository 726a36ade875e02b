//! Loads the files of `cases/errors/`.

use groundbeam_file::{Diagnostics, parse_beside, text_of};
use groundbeam_testing::{files, repository};
use std::fs;
use std::path::PathBuf;

/// The folder of faulty files in the repository.
pub const ERRORS: &str = "cases/errors";

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

/// Every file in `cases/errors/`, by name.
pub fn error_cases() -> Vec<ErrorCase> {
    files(&repository().join(ERRORS), "toml").into_iter().map(read).collect()
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
