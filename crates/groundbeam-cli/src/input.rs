//! Reads a model file, or a model from standard input.

use crate::colour::standard_error_has_colour;
use crate::command::Printed;
use crate::failure::Failure;
use crate::status::Status;
use groundbeam::Error;
use groundbeam::proof::{Reason, Wide, read_model};
use groundbeam_file::{Diagnostics, Document, read_bounded, read_file};
use groundbeam_report::calculation::Source;
use groundbeam_report::{Context, Units, text};
use std::path::Path;

/// Returns the name and the bytes of a file, or of standard input for the path `-`.
pub fn bytes_of(path: &Path) -> Result<(String, Vec<u8>), Failure> {
    let (name, bytes) = if path.as_os_str() == "-" {
        ("<stdin>".to_owned(), read_bounded(std::io::stdin().lock()))
    } else {
        (path.display().to_string(), read_file(path))
    };
    let bytes = bytes.map_err(|error| Failure::file(Path::new(&name), &error))?;
    Ok((name, bytes))
}

/// Model file that has been read, with its name, text, digest and units.
pub struct Input {
    pub document: Document,
    name: String,
    /// Text of the file.
    text: String,
    digest: String,
    /// Units and digits of printed results.
    units: Units,
}

impl Input {
    /// Reads and parses a model file. The path `-` means standard input; files that the model names are then relative
    /// to the working directory.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let (name, bytes) = bytes_of(path)?;
        Input::of(name, &bytes, path.parent().unwrap_or(Path::new("")))
    }

    /// Parses the bytes of a model file in this folder.
    pub fn of(name: String, bytes: &[u8], folder: &Path) -> Result<Self, Failure> {
        let wrong = |found: Diagnostics| {
            Failure::diagnostics(&found, &name, &String::from_utf8_lossy(bytes))
        };
        let text = groundbeam_file::text_of(bytes).map_err(wrong)?;
        let document = groundbeam_file::parse_beside(text, folder).map_err(wrong)?;
        let digest = groundbeam_report::model_digest(&document);
        let units = document.printed;
        Ok(Input { document, name, text: text.to_owned(), digest, units })
    }

    /// Returns this input with the requested units and digits.
    pub fn printed(self, printed: Printed) -> Result<Self, Failure> {
        let units = printed.units(self.units)?;
        Ok(Input { units, ..self })
    }

    /// Prints the warnings about the file on standard error, for commands whose output contains no warnings.
    pub fn show_warnings(&self) {
        if !self.document.warnings.is_empty() {
            let warnings = Diagnostics::from(self.document.warnings.clone());
            let shown = warnings.render(&self.name, &self.text, standard_error_has_colour());
            // A failure to print the warnings does not affect the result.
            let _ = std::io::Write::write_all(&mut std::io::stderr(), shown.as_bytes());
        }
    }

    /// Units and digits of printed results.
    pub fn units(&self) -> Units {
        self.units
    }

    /// Returns the model file as the source of a calculation report.
    pub fn source(&self) -> Source<'_> {
        let name = Path::new(&self.name).file_name().and_then(|name| name.to_str());
        Source::of(&self.document, name.unwrap_or(&self.name), &self.text)
    }

    /// Digest of the model file and of the files that it names.
    pub fn digest(&self) -> &str {
        &self.digest
    }

    /// Text of the file.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Name of the file.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether the file has a key that the proof crate cannot read.
    pub fn is_not_proven_as_written(&self) -> bool {
        let read = read_model::<Wide>(&self.text, None);
        read.is_err_and(|error| matches!(error.reason, Reason::NotRead(_)))
    }

    /// Context of reports: title, units, limits and digest of the model file.
    pub fn context(&self) -> Context<'_> {
        let of_file = Context::of(&self.document);
        Context { digest: Some(&self.digest), units: self.units, ..of_file }
    }

    /// Returns the failure for an error of the solver, with its location if the error concerns the model file.
    pub fn refused(&self, error: &Error) -> Failure {
        if let Error::NotConverged(reached) = error {
            let shown = text::not_converged(reached, standard_error_has_colour());
            return Failure::reported(shown, Status::NotConverged);
        }
        let found = self.document.diagnostics_for(error);
        if found.is_empty() {
            return Failure::usage(error.to_string());
        }
        let located = |found| {
            Failure::diagnostics(&Diagnostics::from(found), &self.name, self.document.text())
        };
        Failure::together(&found.into_iter().map(located).collect::<Vec<_>>())
    }
}
