//! The model file, or standard input.

use crate::failure::Failure;
use groundbeam::model::Problem;
use groundbeam::{Error, Existence, Model};
use groundbeam_file::{Diagnostics, Document, UnitSystem, read_bounded, read_file};
use groundbeam_report::{Context, Units, calculation, text};
use std::path::Path;

/// A model with the name of where it came from.
pub struct Input {
    pub document: Document,
    name: String,
    /// As it was read.
    text: String,
}

impl Input {
    /// Reads and parses a file; `-` is standard input, beside which stands what is in the current folder.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let (name, bytes) = if path.as_os_str() == "-" {
            ("<stdin>".to_owned(), read_bounded(std::io::stdin().lock()))
        } else {
            (path.display().to_string(), read_file(path))
        };
        let bytes = bytes.map_err(|error| Failure::file(Path::new(&name), &error))?;
        Input::of(&bytes, name, Some(path.parent().unwrap_or(Path::new(""))))
    }

    /// Parses the bytes of a file; without a folder it cannot name other files.
    pub fn of(bytes: &[u8], name: String, folder: Option<&Path>) -> Result<Self, Failure> {
        let wrong = |found: Diagnostics| {
            Failure::diagnostics(&found, &name, &String::from_utf8_lossy(bytes))
        };
        let text = groundbeam_file::text_of(bytes).map_err(wrong)?;
        let document = match folder {
            Some(folder) => groundbeam_file::parse_beside(text, folder),
            None => groundbeam_file::parse(text),
        };
        let document = document.map_err(wrong)?;
        Ok(Input { document, name, text: text.to_owned() })
    }

    /// The model as it is written, and the file it stands in.
    pub fn source(&self) -> calculation::Source<'_> {
        let Document { model, cases, .. } = &self.document;
        let name = Path::new(&self.name).file_name().and_then(|name| name.to_str());
        calculation::Source { name: name.unwrap_or(&self.name), text: &self.text, model, cases }
    }

    /// Title and units, as reports want them.
    pub fn context(&self) -> Context<'_> {
        let context = Context::new(units(self.document.units)).with_limits(&self.document.limits);
        let Document { title, chords, .. } = &self.document;
        Context { title: title.as_deref(), chords: *chords, ..context }
    }

    /// Problems found while solving, at their places in the file.
    pub fn wrong(&self, problems: &[Problem]) -> Failure {
        Failure::together(problems.iter().map(|problem| self.located(problem)).collect())
    }

    /// Whether a model made of the file has an equilibrium.
    pub fn existence(&self, model: &Model) -> Result<Existence, Failure> {
        groundbeam::exists(model).map_err(|error| self.refused(&error))
    }

    /// Why a model is not solved, at its place in the file.
    pub fn refused(&self, error: &Error) -> Failure {
        match error {
            Error::Invalid(problems) => self.wrong(problems),
            Error::Unsupported(problem) => self.wrong(std::slice::from_ref(problem)),
            Error::TooLarge(refused) => self.wrong(std::slice::from_ref(&refused.problem)),
            Error::NotConverged(reached) => {
                let shown =
                    text::not_converged(reached, crate::output::standard_error_has_colour());
                Failure::reported(shown, crate::Status::NotConverged)
            }
            other => Failure::usage(other.to_string()),
        }
    }

    fn located(&self, problem: &Problem) -> Failure {
        let found = Diagnostics::from(self.document.diagnostic_for(problem));
        Failure::diagnostics(&found, &self.name, self.document.text())
    }
}

/// How results of a file are written: as its quantities are.
pub fn units(of: UnitSystem) -> Units {
    match of {
        UnitSystem::Si => Units::Si,
        UnitSystem::Plain => Units::Plain,
    }
}
