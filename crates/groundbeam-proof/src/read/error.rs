//! Reasons why a model file cannot be read, with their position in the file.

use std::fmt;

/// Reason why a model file cannot be read. Reading ends at the first fault.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReadError {
    /// Number of the line in the file, counted from 1.
    pub line: usize,
    /// Number of the character in the line, counted from 1.
    pub column: usize,
    /// The reason why the file cannot be read.
    pub reason: Reason,
}

/// A fault of a model file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Reason {
    /// The file is longer, or more deeply nested, than this reader accepts.
    TooLarge,
    /// The text is not TOML, or it uses a part of TOML that model files do not need.
    Syntax(&'static str),
    /// A key or a table occurs twice.
    Twice(String),
    /// A key that its table does not allow.
    Unknown(String),
    /// A required key that is missing.
    Missing(&'static str),
    /// Two keys that cannot be given together.
    Together(&'static str, &'static str),
    /// A value that the key does not allow.
    Value(String),
    /// A number of the model that is too small or too large for the computation.
    OutOfRange(String),
    /// A key or a method that this reader does not support: modified Vlasov soil, a trough or a survey of the gap, or a
    /// train.
    NotRead(&'static str),
    /// The file has no combination with the requested name.
    NoCombination(String),
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}, column {}: ", self.line, self.column)?;
        match &self.reason {
            Reason::TooLarge => f.write_str("the file is too large, or too deeply nested"),
            Reason::Syntax(what) => f.write_str(what),
            Reason::Twice(key) => write!(f, "`{key}` is given twice"),
            Reason::Unknown(key) => write!(f, "`{key}` is not a key of this table"),
            Reason::Missing(key) => write!(f, "`{key}` is missing"),
            Reason::Together(a, b) => write!(f, "`{a}` and `{b}` cannot be given together"),
            Reason::Value(what) | Reason::OutOfRange(what) => f.write_str(what),
            Reason::NotRead(key) => {
                write!(f, "the independent second reader of model files does not support `{key}`")
            }
            Reason::NoCombination(name) => {
                write!(f, "the file has no combination `{name}`")
            }
        }
    }
}

impl std::error::Error for ReadError {}

/// A reason why a file cannot be read, and the byte of the file where the fault is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Fault {
    pub at: usize,
    pub reason: Reason,
}

/// What a function of this reader returns: a result or a fault.
pub(crate) type Read<T> = Result<T, Fault>;

/// A fault.
pub(crate) fn fault<T>(at: usize, reason: Reason) -> Read<T> {
    Err(Fault { at, reason })
}

/// Returns the error for a value that its key does not allow.
pub(crate) fn wrong<T>(at: usize, what: impl Into<String>) -> Read<T> {
    fault(at, Reason::Value(what.into()))
}

/// Returns the error for a number that is too small or too large for the computation.
pub(crate) fn out_of_range<T>(at: usize, what: impl Into<String>) -> Read<T> {
    fault(at, Reason::OutOfRange(what.into()))
}

impl Fault {
    /// Converts the position of the fault to its line and column in `text`.
    pub fn placed(self, text: &str) -> ReadError {
        let mut at = self.at.min(text.len());
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        let before = &text[..at];
        let line = before.bytes().filter(|byte| *byte == b'\n').count() + 1;
        let start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let column = before[start..].trim_start_matches('\u{feff}').chars().count() + 1;
        ReadError { line, column, reason: self.reason }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn locations_count_lines_and_characters_from_one() {
        let at = |at| {
            let fault = Fault { at, reason: Reason::TooLarge };
            let ReadError { line, column, .. } = fault.placed("\u{feff}aµ\nb");
            (line, column)
        };
        assert_eq!([at(0), at(3), at(5), at(7), at(99)], [(1, 1), (1, 1), (1, 2), (2, 1), (2, 2)]);
    }

    #[test]
    fn every_reason_is_written_with_its_location() {
        for (reason, text) in [
            (Reason::TooLarge, "the file is too large, or too deeply nested"),
            (Reason::Syntax("write key = value"), "write key = value"),
            (Reason::Twice("a".into()), "`a` is given twice"),
            (Reason::Unknown("a".into()), "`a` is not a key of this table"),
            (Reason::Missing("a"), "`a` is missing"),
            (Reason::Together("a", "b"), "`a` and `b` cannot be given together"),
            (Reason::Value("a is wrong".into()), "a is wrong"),
            (Reason::OutOfRange("a is large".into()), "a is large"),
            (
                Reason::NotRead("a"),
                "the independent second reader of model files does not support `a`",
            ),
            (Reason::NoCombination("a".into()), "the file has no combination `a`"),
        ] {
            let error = ReadError { line: 3, column: 7, reason };
            assert_eq!(error.to_string(), format!("line 3, column 7: {text}"));
        }
    }
}
