//! Reads the model files in `cases/`, which serve as examples, documentation and tests.
//!
//! Lines that begin with `#:` contain the expected results; see `cases/README.md`.

pub mod answers;
pub mod expectation;
mod growth;
pub mod manual;
mod quantity;
mod scale;

use expectation::Expectation;
use groundbeam::Model;
use groundbeam_file::Document;
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};

/// A model file with its expected results.
#[derive(Debug)]
pub struct Case {
    /// Path of the file below `cases/`, with `/` between folders.
    pub path: String,
    /// The model.
    pub document: Document,
    /// The source of the expected numbers.
    pub source: String,
    /// The expected results.
    pub expectations: Vec<Expectation>,
}

/// The reason why a case file cannot be read, such as an error in a line of expected results.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Misread {
    /// Number of the line in the file, counted from 1; 0 if the fault concerns the whole file.
    pub line: usize,
    /// The fault as text.
    pub what: String,
}

impl fmt::Display for Misread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            0 => f.write_str(&self.what),
            line => write!(f, "line {line}: {}", self.what),
        }
    }
}

impl Case {
    /// Returns the models to be solved, either the model of the file or the models of its combinations.
    pub fn models(&self) -> Vec<Model> {
        self.document.wanted().into_iter().map(|combination| combination.model).collect()
    }

    /// The title of the file.
    pub fn title(&self) -> &str {
        self.document.title.as_deref().unwrap_or_default()
    }

    /// Reads a case from the text of its file.
    ///
    /// # Errors
    ///
    /// The model is invalid, a line beginning with `#:` is unknown, or the file has no title, source or expectation.
    pub fn read(path: &str, text: &str) -> Result<Case, Misread> {
        let whole = |what: String| Misread { line: 0, what };
        let document = groundbeam_file::parse_beside(text, &folder().join(path).with_file_name(""))
            .map_err(|faults| whole(faults.render(path, text, false)))?;
        let mut source = None;
        let mut expectations = Vec::new();
        for (i, line) in text.lines().enumerate() {
            let Some(said) = line.strip_prefix("#:") else { continue };
            let at = |what: String| Misread { line: i + 1, what };
            if let Some(words) = said.trim().strip_prefix("source =") {
                source = Some(words.trim().to_owned());
                continue;
            }
            let expectation = Expectation::read(said, i + 1, document.units).map_err(at)?;
            expectations.push(expectation);
        }
        if expectations.is_empty() {
            return Err(whole(
                "the file has no expectation like `#: moment(2) = 10 rel 1e-12`".into(),
            ));
        }
        let source = source.ok_or_else(|| whole("the file has no line `#: source = …`".into()))?;
        if document.title.is_none() {
            return Err(whole("the file has no title".into()));
        }
        Ok(Case { path: path.to_owned(), document, source, expectations })
    }
}

/// The folder `cases/`.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../cases")
}

/// Reads every model file below `cases/` except the files of `cases/errors`, sorted by name.
///
/// # Panics
///
/// Panics if a folder or a file cannot be read.
pub fn all() -> Vec<Result<Case, (String, Misread)>> {
    let mut files = Vec::new();
    collect(&folder(), "", &mut files);
    files.sort();
    let read = |path: String| {
        let text = fs::read_to_string(folder().join(&path)).expect("a readable model file");
        Case::read(&path, &text).map_err(|misread| (path, misread))
    };
    files.into_iter().map(read).collect()
}

fn collect(folder: &Path, below: &str, files: &mut Vec<String>) {
    for entry in fs::read_dir(folder).expect("a readable folder") {
        let entry = entry.expect("a readable entry");
        let path = format!("{below}{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            if path != "errors" {
                collect(&entry.path(), &format!("{path}/"), files);
            }
        } else if path.ends_with(".toml") {
            files.push(path);
        }
    }
}
