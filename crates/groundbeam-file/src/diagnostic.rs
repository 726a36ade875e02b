//! Diagnostics: the fault in a file, its location, and the remedy.

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

/// Another location in the file that relates to a [`Diagnostic`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Related {
    /// Byte range in the text.
    pub span: Range<usize>,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Short description of this location.
    pub label: String,
}

/// One fault of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// A fixed code, one for each rule; [`CODES`](crate::CODES) lists them.
    pub code: &'static str,
    /// Its severity.
    pub severity: Severity,
    /// The other file that contains the fault; `None` for the model file itself.
    pub file: Option<Arc<OtherFile>>,
    /// The fault, in one sentence.
    pub message: String,
    /// A few words shown under the location. May be empty.
    pub label: String,
    /// The remedy. May be empty.
    pub hint: String,
    /// Location: byte range in the text.
    pub span: Range<usize>,
    /// Line of the location, from 1.
    pub line: usize,
    /// Column of the location in characters, from 1.
    pub column: usize,
    /// Other locations that explain this one.
    pub related: Vec<Related>,
}

impl Diagnostic {
    /// An error at `fault.at` of the whole text.
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

/// Maximum length of a text in characters. A quoted name may be as long as the file.
const LONGEST: usize = 1000;

/// The first [`LONGEST`] characters of the text.
fn shortened(mut text: String) -> String {
    if let Some((end, _)) = text.char_indices().nth(LONGEST) {
        text.truncate(end);
        text.push('…');
    }
    text
}

impl fmt::Display for Diagnostic {
    /// `14:6: [GB015] message (hint)`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(file) = &self.file {
            write!(f, "{}:", printable(&file.name))?;
        }
        let message = printable(&self.message);
        write!(f, "{}:{}: [{}] {message}", self.line, self.column, self.code)?;
        if self.hint.is_empty() { Ok(()) } else { write!(f, " ({})", printable(&self.hint)) }
    }
}

/// All faults of a file, in the order of the text; never empty.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostics(Vec<Diagnostic>);

impl Diagnostics {
    /// Sorts by location, other files last, and removes repeated messages about one location.
    pub(crate) fn new(mut found: Vec<Diagnostic>) -> Self {
        found.sort_by_key(|d| (d.file.is_some(), d.span.start));
        found.dedup();
        Diagnostics(found)
    }

    /// The diagnostics in the order of the text.
    pub fn iter(&self) -> std::slice::Iter<'_, Diagnostic> {
        self.0.iter()
    }

    /// The diagnostics as a slice.
    pub fn as_slice(&self) -> &[Diagnostic] {
        &self.0
    }
}

impl From<Vec<Diagnostic>> for Diagnostics {
    /// Keeps the order of the text.
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
    /// One line for each diagnostic. [`Diagnostics::render`] also shows the locations.
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
