//! Solves the model of a file that was read, finds its load combinations by name, and reads positions in the file's units.

use crate::failure::Failure;
use crate::threads::Threads;
use groundbeam::Error;
use groundbeam_file::{Combination, Document};
use groundbeam_report::Units;
use groundbeam_run::{Answers, Failed, Host, Run};
use pyo3::prelude::*;

/// A model file: its name, and the document read from its text.
pub struct Read {
    pub document: Document,
    pub name: String,
}

impl Read {
    pub fn units(&self) -> Units {
        self.document.printed
    }

    /// Name of the unit system of the results.
    pub fn system(&self) -> &'static str {
        self.units().name()
    }

    pub fn refused(&self, error: Error) -> Failure {
        Failure::refused(error, &self.document, &self.name)
    }

    /// Solves a run of the document. Returns the results and the duration \[s\].
    pub fn solve(&self, run: &Run, threads: Option<usize>) -> PyResult<(Answers, f64)> {
        let host = Threads::new(threads);
        match run.solve(&host) {
            Ok(answers) => Ok((answers, host.seconds())),
            Err(Failed::Refused(error)) => Err(self.refused(error).into()),
            Err(Failed::Stopped(stop)) => Err(stop),
        }
    }

    /// Reads a position from text, in the units of the file.
    pub fn position(&self, text: &str) -> Result<f64, Failure> {
        let found = groundbeam_file::parse_positions(text, self.document.units);
        let found = found.map_err(|found| Failure::wrong(found, "position", text))?;
        match found[..] {
            [position] => Ok(position),
            _ => Err(Failure::Asked(format!(
                "`{text}` contains {} positions: give a list of strings, such as [\"1 m\", \"2 m\"]",
                found.len()
            ))),
        }
    }

    /// Returns the combination with this name, or the loads as written if no name is given.
    pub fn combination(&self, name: Option<&str>) -> Result<Combination, Failure> {
        let document = &self.document;
        let Some(name) = name else { return Ok(document.as_written()) };
        let wrong = |found| Failure::wrong(found, "combination", name);
        document.combination(name).map_err(wrong)
    }
}
