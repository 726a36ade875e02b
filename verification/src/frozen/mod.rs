//! Reads frozen random models and the answers of a pinned program version, for comparison with the present program.
//!
//! The random families draw their models with the code under test, so a change in a last digit can change the models.
//! `verification/frozen` contains the models and answers of one commit.

pub mod answer;
pub mod bits;
pub mod bounds;
pub mod model;
pub mod record;

use groundbeam::{Model, Outcome, solve};
use record::Record;
use std::io;
use std::path::{Path, PathBuf};

/// A frozen model with its answer and its certificate.
#[derive(Debug, Clone)]
pub struct Frozen {
    /// The model.
    pub model: Record,
    /// The answer.
    pub answer: Record,
    /// The certificate, a record without lines if there is no solution.
    pub certificate: Record,
}

/// Returns the folder of the frozen files.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("frozen")
}

/// Returns the names of the families of frozen models in a folder, in alphabetical order.
///
/// # Errors
///
/// The folder cannot be read.
pub fn families(folder: &Path) -> io::Result<Vec<String>> {
    let mut names = Vec::new();
    for entry in std::fs::read_dir(folder.join("models"))? {
        let path = entry?.path();
        names.extend(path.file_stem().map(|stem| stem.to_string_lossy().into_owned()));
    }
    names.sort();
    Ok(names)
}

/// Returns the path of a file of a family; `kind` is `models`, `answers` or `certificates`.
pub fn file(folder: &Path, kind: &str, family: &str) -> PathBuf {
    folder.join(kind).join(family).with_extension("txt")
}

/// Reads all frozen models of a family.
///
/// # Errors
///
/// A file cannot be read, or the files belong to different models.
pub fn family(folder: &Path, family: &str) -> io::Result<Vec<Frozen>> {
    let read = |kind: &str| Record::of_file(&file(folder, kind, family));
    let [models, answers, certificates] =
        [read("models")?, read("answers")?, read("certificates")?];
    if models.len() != answers.len() || models.len() != certificates.len() {
        return Err(io::Error::other(format!(
            "{family}: the files have different numbers of models"
        )));
    }
    let parts = models.into_iter().zip(answers).zip(certificates);
    let one = |((model, answer), certificate): ((Record, Record), Record)| {
        if model.title != answer.title || model.title != certificate.title {
            return Err(io::Error::other(format!("{}: no answer or certificate", model.title)));
        }
        Ok(Frozen { model, answer, certificate })
    };
    parts.map(one).collect()
}

impl Frozen {
    /// Returns the family and the number of the model, such as `Hard 7371`.
    pub fn title(&self) -> &str {
        &self.model.title
    }

    /// Returns the number of the model within its family.
    pub fn number(&self) -> u64 {
        self.title().split_once(' ').and_then(|(_, number)| number.parse().ok()).unwrap_or(0)
    }

    /// The model.
    ///
    /// # Errors
    ///
    /// Returns the first line that does not belong to a model.
    pub fn model(&self) -> Result<Model, String> {
        model::read(&self.model)
    }

    /// Whether the stored answer contains the values of the fields at all evaluated positions, not only at five.
    pub fn is_in_full(&self) -> bool {
        self.answer.numbers("fields_deflection").len() > answer::STEPS
    }

    /// Solves the model with the present program, and returns the model with the new answer.
    ///
    /// # Errors
    ///
    /// Returns the first line that does not belong to a model.
    pub fn solved_again(&self) -> Result<Frozen, String> {
        let outcome = solve(&self.model()?);
        let certificate = match &outcome {
            Ok(Outcome::Equilibrium(solution)) => answer::certificate(solution),
            _ => String::new(),
        };
        Ok(Frozen {
            model: self.model.clone(),
            answer: Record::new(self.title(), &answer::text(&outcome, self.is_in_full())),
            certificate: Record::new(self.title(), &certificate),
        })
    }
}
