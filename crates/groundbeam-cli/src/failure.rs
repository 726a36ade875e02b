//! Error messages on standard error, and the exit status.

use crate::colour::standard_error_has_colour;
use crate::status::Status;
use groundbeam_file::{Diagnostics, printable};
use std::fmt::Display;
use std::path::Path;
use std::process::ExitCode;

/// A failed run: its message and exit status.
pub struct Failure {
    /// The message; it ends in a newline.
    shown: String,
    status: Status,
}

impl Failure {
    /// A fault of the command line.
    pub fn usage(message: String) -> Self {
        Failure { shown: headline(&message), status: Status::Wrong }
    }

    /// A file that cannot be read or written.
    pub fn file(path: &Path, error: &dyn Display) -> Self {
        Failure::usage(format!("{}: {error}", path.display()))
    }

    /// Faults of a text with their locations.
    pub fn diagnostics(found: &Diagnostics, name: &str, text: &str) -> Self {
        let shown = found.render(name, text, standard_error_has_colour());
        Failure { shown, status: Status::Wrong }
    }

    /// The failure of a command that reports a result without a solution: for example that no equilibrium exists.
    pub fn reported(shown: String, status: Status) -> Self {
        Failure { shown, status }
    }

    /// Combines several failures of one file.
    pub fn together(all: &[Failure]) -> Self {
        let shown: Vec<&str> = all.iter().map(|failure| failure.shown.as_str()).collect();
        Failure { shown: shown.join("\n"), status: Status::Wrong }
    }

    /// Prints the message and returns the exit status.
    pub fn report(self) -> ExitCode {
        // If standard error cannot be written, the exit status remains.
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

/// Prints a message of clap, which may also be the help or the version.
pub fn usage(error: &clap::Error) -> ExitCode {
    if error.exit_code() == 0 {
        let _ = error.print();
        return Status::Done.into();
    }
    let said = error.render();
    let said = if standard_error_has_colour() { said.ansi().to_string() } else { said.to_string() };
    Failure { shown: without_steering(&said), status: Status::Wrong }.report()
}

/// Escapes control characters in a message of clap. The escape character itself stays because clap uses it
/// for colours; clap removes it from the user's text.
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
    fn control_characters_in_messages_are_escaped() {
        let said = "\u{1b}[1merror\u{1b}[0m: a\rb\u{200f}\n\nUsage\n";
        let shown = "\u{1b}[1merror\u{1b}[0m: a\\rb\\u{200f}\n\nUsage\n";
        assert_eq!(without_steering(said), shown);
        assert_eq!(without_steering(""), "");
    }
}
