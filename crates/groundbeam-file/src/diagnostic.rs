//! Diagnostics, which describe a fault in a file, its location and its remedy.

use crate::beside::OtherFile;
use crate::fault::Fault;
use crate::printable::printable;
use crate::source::Source;
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// Severity of a diagnostic.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Severity {
    /// The file cannot be used.
    Error,
    /// The file can be used, but is probably wrong.
    Warning,
}

/// Another location in the file that helps to explain a [`Diagnostic`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Related {
    /// Byte range of the location in the text.
    pub span: Range<usize>,
    /// Line of the location, counted from 1.
    pub line: usize,
    /// Column of the location in characters, counted from 1.
    pub column: usize,
    /// Short description of the location.
    pub label: String,
}

/// One fault of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Fixed code of the broken rule; [`CODES`](crate::CODES) lists all codes.
    pub code: &'static str,
    /// Severity of the diagnostic.
    pub severity: Severity,
    /// File with the fault, if the model file names this file; `None` if the fault is in the model file itself.
    pub file: Option<Arc<OtherFile>>,
    /// Description of the fault, in one sentence.
    pub message: String,
    /// Short text that is shown under the location; may be empty.
    pub label: String,
    /// Description of the remedy; may be empty.
    pub hint: String,
    /// Byte range of the fault in the text.
    pub span: Range<usize>,
    /// Line of the fault, counted from 1.
    pub line: usize,
    /// Column of the fault in characters, counted from 1.
    pub column: usize,
    /// Other locations that help to explain the fault.
    pub related: Vec<Related>,
}

impl Diagnostic {
    /// Creates an error at the byte range `fault.at` of the whole text.
    pub(crate) fn new(source: &Source, fault: Fault) -> Self {
        let span = source.whole_characters(fault.at);
        let (line, column) = source.position(span.start);
        Diagnostic {
            code: fault.code,
            severity: Severity::Error,
            file: None,
            message: shortened(fault.message),
            label: shortened(fault.label),
            hint: shortened(fault.hint),
            span,
            line,
            column,
            related: Vec::new(),
        }
    }

    pub(crate) fn with_related(mut self, source: &Source, span: Range<usize>, label: &str) -> Self {
        let span = source.whole_characters(span);
        let (line, column) = source.position(span.start);
        self.related.push(Related { span, line, column, label: label.to_owned() });
        self
    }
}

/// Maximum length of a text of a diagnostic, in characters. A text may quote a name that is as long as the file.
const LONGEST: usize = 1000;

/// Shortens a text to its first [`LONGEST`] characters.
fn shortened(mut text: String) -> String {
    if let Some((end, _)) = text.char_indices().nth(LONGEST) {
        text.truncate(end);
        text.push('…');
    }
    text
}

impl fmt::Display for Diagnostic {
    /// Writes the diagnostic in the form `14:6: [GB015] message (hint)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(file) = &self.file {
            write!(f, "{}:", printable(&file.name))?;
        }
        let message = printable(&self.message);
        write!(f, "{}:{}: [{}] {message}", self.line, self.column, self.code)?;
        if self.hint.is_empty() { Ok(()) } else { write!(f, " ({})", printable(&self.hint)) }
    }
}

/// All diagnostics of a file, in the order of the text. The list is never empty.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostics(Vec<Diagnostic>);

impl Diagnostics {
    /// Sorts the diagnostics by location, with those of other files at the end, and removes repeated diagnostics.
    pub(crate) fn new(mut found: Vec<Diagnostic>) -> Self {
        found.sort_by_key(|d| (d.file.is_some(), d.span.start));
        found.dedup();
        Diagnostics(found)
    }

    /// Returns an iterator over the diagnostics, in the order of the text.
    pub fn iter(&self) -> std::slice::Iter<'_, Diagnostic> {
        self.0.iter()
    }

    /// Returns the diagnostics as a slice.
    pub fn as_slice(&self) -> &[Diagnostic] {
        &self.0
    }
}

impl From<Vec<Diagnostic>> for Diagnostics {
    /// Sorts the diagnostics by location and removes repeated diagnostics.
    fn from(found: Vec<Diagnostic>) -> Self {
        Diagnostics::new(found)
    }
}

impl From<Diagnostic> for Diagnostics {
    fn from(diagnostic: Diagnostic) -> Self {
        Diagnostics(vec![diagnostic])
    }
}

impl<'d> IntoIterator for &'d Diagnostics {
    type Item = &'d Diagnostic;
    type IntoIter = std::slice::Iter<'d, Diagnostic>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl IntoIterator for Diagnostics {
    type Item = Diagnostic;
    type IntoIter = std::vec::IntoIter<Diagnostic>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl fmt::Display for Diagnostics {
    /// Writes one line for each diagnostic. [`Diagnostics::render`] also quotes the lines of the file.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, diagnostic) in self.iter().enumerate() {
            if i > 0 {
                writeln!(f)?;
            }
            write!(f, "{diagnostic}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Diagnostics {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_cut_between_characters() {
        assert_eq!(shortened("µ".repeat(LONGEST)), "µ".repeat(LONGEST));
        assert_eq!(shortened("µ".repeat(LONGEST + 1)), "µ".repeat(LONGEST) + "…");
    }
}
