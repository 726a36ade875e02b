//! Prints error messages on standard error and returns the exit status.

use crate::colour::standard_error_has_colour;
use crate::status::Status;
use groundbeam_file::{Diagnostics, printable};
use std::fmt::Display;
use std::path::Path;
use std::process::ExitCode;

/// Message and exit status of a failed run.
pub struct Failure {
    /// Message with a final newline.
    shown: String,
    status: Status,
}

impl Failure {
    /// Returns the failure for wrong arguments of the command line.
    pub fn usage(message: String) -> Self {
        Failure { shown: headline(&message), status: Status::Wrong }
    }

    /// Returns the failure for a file that cannot be read or written.
    pub fn file(path: &Path, error: &dyn Display) -> Self {
        Failure::usage(format!("{}: {error}", path.display()))
    }

    /// Returns a failure that lists the errors found in a text, each with its location.
    pub fn diagnostics(found: &Diagnostics, name: &str, text: &str) -> Self {
        let shown = found.render(name, text, standard_error_has_colour());
        Failure { shown, status: Status::Wrong }
    }

    /// Returns the failure of a command that ends without the requested result, for example because no equilibrium
    /// exists.
    pub fn reported(shown: String, status: Status) -> Self {
        Failure { shown, status }
    }

    /// Combines several failures of one file into one failure.
    pub fn together(all: &[Failure]) -> Self {
        let shown: Vec<&str> = all.iter().map(|failure| failure.shown.as_str()).collect();
        Failure { shown: shown.join("\n"), status: Status::Wrong }
    }

    /// Prints the message and returns the exit status.
    pub fn report(self) -> ExitCode {
        // A failure to write to standard error does not change the exit status.
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

/// Prints a message of the library clap: an error, the help or the version. Returns the exit status.
pub fn usage(error: &clap::Error) -> ExitCode {
    if error.exit_code() == 0 {
        let _ = error.print();
        return Status::Done.into();
    }
    let said = error.render();
    let said = if standard_error_has_colour() { said.ansi().to_string() } else { said.to_string() };
    Failure { shown: without_steering(&said), status: Status::Wrong }.report()
}

/// Escapes control characters in a message of clap. The character U+001B remains because clap uses it for colours;
/// clap removes it from the user's text.
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
