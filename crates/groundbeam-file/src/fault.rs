//! Fault in one value of a file, before its location in the file is known.

use std::ops::Range;

/// Fault in a value of a file. The byte range `at` counts from the start of the value.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Fault {
    pub code: &'static str,
    pub at: Range<usize>,
    pub message: String,
    pub label: String,
    pub hint: String,
}

impl Fault {
    pub fn new(
        code: &'static str,
        at: Range<usize>,
        message: impl Into<String>,
        label: impl Into<String>,
        hint: impl Into<String>,
    ) -> Self {
        Fault { code, at, message: message.into(), label: label.into(), hint: hint.into() }
    }

    /// Returns this fault with `offset` added to its byte range.
    pub fn moved(mut self, offset: usize) -> Self {
        self.at = self.at.start + offset..self.at.end + offset;
        self
    }
}
