//! Messages on standard error for runs without an answer.

use crate::colour::standard_error_has_colour;
use crate::status::Status;
use groundbeam_file::{Diagnostics, printable};
use std::fmt::Display;
use std::path::Path;
use std::process::ExitCode;

/// Why there is no answer: what a person is shown, and the exit status.
pub struct Failure {
    /// Ends in a newline.
    shown: String,
    status: Status,
}

impl Failure {
    /// The command line is wrong.
    pub fn usage(message: String) -> Self {
        Failure { shown: headline(&message), status: Status::Wrong }
    }

    /// A file that cannot be read or written.
    pub fn file(path: &Path, error: &dyn Display) -> Self {
        Failure::usage(format!("{}: {error}", path.display()))
    }

    /// A text with faults at their places.
    pub fn diagnostics(found: &Diagnostics, name: &str, text: &str) -> Self {
        let shown = found.render(name, text, standard_error_has_colour());
        Failure { shown, status: Status::Wrong }
    }

    /// A report that is no solution.
    pub fn reported(shown: String, status: Status) -> Self {
        Failure { shown, status }
    }

    /// Several of one file as one.
    pub fn together(all: &[Failure]) -> Self {
        let shown: Vec<&str> = all.iter().map(|failure| failure.shown.as_str()).collect();
        Failure { shown: shown.join("\n"), status: Status::Wrong }
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
    if error.exit_code() == 0 {
        let _ = error.print();
        return Status::Done.into();
    }
    let said = error.render();
    let said = if standard_error_has_colour() { said.ansi().to_string() } else { said.to_string() };
    Failure { shown: without_steering(&said), status: Status::Wrong }.report()
}

/// The words of clap with every other character that steers a terminal written as an escape. Clap itself takes the escape
/// character out of what was typed, and colours its words by it.
fn without_steering(words: &str) -> String {
    words.split_inclusive(['\n', '\u{1b}']).fold(String::new(), |mut shown, part| {
        let end = part.len() - usize::from(part.ends_with(['\n', '\u{1b}']));
        shown.push_str(&printable(&part[..end]));
        shown.push_str(&part[end..]);
        shown
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_typed_cannot_steer_a_terminal() {
        let said = "\u{1b}[1merror\u{1b}[0m: a\rb\u{200f}\n\nUsage\n";
        let shown = "\u{1b}[1merror\u{1b}[0m: a\\rb\\u{200f}\n\nUsage\n";
        assert_eq!(without_steering(said), shown);
        assert_eq!(without_steering(""), "");
    }
}
