//! Why there is no answer, on standard error.

use crate::Status;
use crate::output::standard_error_has_colour;
use groundbeam_file::{Diagnostic, Diagnostics, printable};
use std::fmt::Display;
use std::path::Path;
use std::process::ExitCode;

/// Why there is no answer: what a person is shown, and the exit status.
pub struct Failure {
    /// Ends in a newline.
    shown: String,
    status: Status,
    /// The same in one line, without colour.
    message: String,
    /// The faults of the model file, where it is the file that is wrong.
    found: Vec<Diagnostic>,
}

impl Failure {
    /// The command line is wrong.
    pub fn usage(message: String) -> Self {
        Failure { shown: headline(&message), status: Status::Wrong, message, found: Vec::new() }
    }

    /// A file that cannot be read or written.
    pub fn file(path: &Path, error: &dyn Display) -> Self {
        Failure::usage(format!("{}: {error}", path.display()))
    }

    /// A text with faults at their places.
    pub fn diagnostics(found: &Diagnostics, name: &str, text: &str) -> Self {
        let shown = found.render(name, text, standard_error_has_colour());
        let message = found.iter().next().map_or_else(String::new, ToString::to_string);
        Failure { shown, status: Status::Wrong, message, found: found.as_slice().to_vec() }
    }

    /// A report that is no solution.
    pub fn reported(shown: String, status: Status) -> Self {
        Failure { shown, status, message: String::new(), found: Vec::new() }
    }

    /// Several of one file as one.
    pub fn together(all: Vec<Failure>) -> Self {
        let shown: Vec<&str> = all.iter().map(|failure| failure.shown.as_str()).collect();
        let shown = shown.join("\n");
        let message = all.first().map_or_else(String::new, |failure| failure.message.clone());
        let found = all.into_iter().flat_map(|failure| failure.found).collect();
        Failure { shown, status: Status::Wrong, message, found }
    }

    /// What is wrong, in one line.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// The faults of the model file, where it is the file that is wrong.
    pub fn found(&self) -> &[Diagnostic] {
        &self.found
    }

    /// Shows it and gives the exit status.
    pub fn report(self) -> ExitCode {
        // Where standard error cannot be written, the status says enough.
        let _ = std::io::Write::write_all(&mut std::io::stderr(), self.shown.as_bytes());
        self.status.into()
    }
}

fn headline(message: &str) -> String {
    let message = printable(message);
    if standard_error_has_colour() {
        format!("\u{1b}[1;31merror\u{1b}[0m: {message}\n")
    } else {
        format!("error: {message}\n")
    }
}

/// What clap has to say: help and versions too.
pub fn usage(error: &clap::Error) -> ExitCode {
    let _ = error.print();
    match error.exit_code() {
        0 => Status::Done.into(),
        _ => Status::Wrong.into(),
    }
}
