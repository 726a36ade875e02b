//! Formats diagnostics as text with the file name, the position, the marked line and a hint.

use crate::diagnostic::{Diagnostic, Diagnostics, Severity};
use crate::printable::{is_unprintable, printable};
use crate::source::BYTE_ORDER_MARK;
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use std::ops::Range;

/// Maximum number of diagnostics that are printed; [`Diagnostics::iter`] returns all diagnostics.
const MOST_SHOWN: usize = 100;

impl Diagnostics {
    /// Formats the first hundred diagnostics, each with its lines of `text`, and the number of the others.
    ///
    /// `text` is the parsed text. `colour` adds escape codes for a terminal. The result ends with a newline.
    ///
    /// # Example
    ///
    /// ```
    /// let text = "[beam]\nlength = \"12 m\"\nEI = \"5 kN m\"\n\n[foundation]\nk = \"40 MN/m^2\"\n";
    /// let diagnostics = groundbeam_file::parse(text).unwrap_err();
    /// assert_eq!(
    ///     diagnostics.render("footing.toml", text, false),
    ///     r#"error[GB015]: `kN m` is a moment, but a bending stiffness is needed here
    ///  --> footing.toml:3:9
    ///   |
    /// 3 | EI = "5 kN m"
    ///   |         ^^^^ a moment
    ///   |
    ///   = help: give a unit as in EI = "1.2e6 kN m^2"
    /// "#
    /// );
    /// ```
    pub fn render(&self, file_name: &str, text: &str, colour: bool) -> String {
        let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
        let mut rendered = String::new();
        for (i, diagnostic) in self.iter().take(MOST_SHOWN).enumerate() {
            if i > 0 {
                rendered.push('\n');
            }
            let (name, text) = match &diagnostic.file {
                Some(file) => (file.name.as_str(), file.text.as_str()),
                None => (file_name, text),
            };
            rendered.push_str(&renderer.render(&[group(diagnostic, name, text)]));
            rendered.push('\n');
        }
        if let Some(more) = self.as_slice().len().checked_sub(MOST_SHOWN).filter(|&more| more > 0) {
            rendered.push_str(&format!("\n... and {more} more in {}\n", printable(file_name)));
        }
        rendered
    }
}

/// Converts a diagnostic to the form that the renderer needs. Names and text from the file are escaped
/// here, because the renderer prints paths, labels and hints unchanged.
fn group<'t>(diagnostic: &'t Diagnostic, file_name: &'t str, text: &str) -> Group<'t> {
    // Column numbers do not include the byte order mark, so it is removed from the text.
    let shown = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
    let mark = text.len() - shown.len();
    let inside = |span: &Range<usize>| {
        let start = boundary(shown, span.start.saturating_sub(mark));
        start..boundary(shown, span.end.saturating_sub(mark)).max(start)
    };
    // The run time of the renderer grows with the length of its text, so it receives only the lines of the diagnostic.
    let spans =
        || std::iter::once(&diagnostic.span).chain(diagnostic.related.iter().map(|r| &r.span));
    let first = spans().map(|span| inside(span).start).min().unwrap_or(0);
    let last = spans().map(|span| inside(span).end).max().unwrap_or(0);
    let start = shown[..first].rfind('\n').map_or(0, |newline| newline + 1);
    let end = shown[last..].find('\n').map_or(shown.len(), |newline| last + newline + 1);
    let first_line = diagnostic.related.iter().map(|r| r.line).fold(diagnostic.line, usize::min);
    let place = |span: &Range<usize>| {
        let span = inside(span);
        let place = |offset: usize| visible(&shown[start..offset]).len();
        place(span.start)..place(span.end)
    };

    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
    };
    let label = |text: &'t str| (!text.is_empty()).then(|| printable(text));
    let primary = AnnotationKind::Primary.span(place(&diagnostic.span));
    let snippet = Snippet::source(visible(&shown[start..end]))
        .line_start(first_line)
        .path(printable(file_name))
        .annotation(primary.label(label(&diagnostic.label)))
        .annotations(diagnostic.related.iter().map(|related| {
            AnnotationKind::Context.span(place(&related.span)).label(label(&related.label))
        }));
    let title = level.primary_title(printable(&diagnostic.message)).id(diagnostic.code);
    let group = title.element(snippet);
    if diagnostic.hint.is_empty() {
        group
    } else {
        group.element(Level::HELP.message(printable(&diagnostic.hint)))
    }
}

/// Replaces each unprintable character outside ASCII by one printable character, so that columns remain the
/// same. The renderer itself handles ASCII control characters and line ends.
fn visible(lines: &str) -> String {
    let sign = |c: char| if is_unprintable(c) && !c.is_ascii() { '\u{fffd}' } else { c };
    lines.chars().map(sign).collect()
}

/// Returns the last character boundary at or before `offset`. The caller's text may differ from the parsed
/// text, so `offset` may lie inside a character or beyond the end of the text.
fn boundary(text: &str, offset: usize) -> usize {
    (0..=offset.min(text.len())).rev().find(|&i| text.is_char_boundary(i)).unwrap_or(0)
}
