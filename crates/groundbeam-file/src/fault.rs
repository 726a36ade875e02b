//! A fault in one value, before its location in the file is known.

use std::ops::Range;

/// A fault in a value. `at` counts bytes from the start of the value.
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

    /// The same fault relative to a text that begins `offset` bytes earlier.
    pub fn moved(mut self, offset: usize) -> Self {
        self.at = self.at.start + offset..self.at.end + offset;
        self
    }
}
