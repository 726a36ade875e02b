//! Finds the line and the column of a byte in the text of a file.

use std::ops::Range;

/// Byte order mark U+FEFF, which some editors put at the start of a file. The mark does not count as a column.
pub(crate) const BYTE_ORDER_MARK: char = '\u{feff}';

/// A text with the byte positions at which its lines start.
#[derive(Debug, Clone)]
pub(crate) struct Source {
    pub text: String,
    line_starts: Vec<usize>,
}

impl Source {
    pub fn new(text: &str) -> Self {
        let after_newlines = text.match_indices('\n').map(|(i, _)| i + 1);
        Source {
            text: text.to_owned(),
            line_starts: std::iter::once(0).chain(after_newlines).collect(),
        }
    }

    /// Returns the line and the column of the byte at `offset`. Both numbers start from 1, and columns count
    /// characters.
    pub fn position(&self, offset: usize) -> (usize, usize) {
        let offset = self.character_start(offset);
        let line = self.line_starts.partition_point(|&start| start <= offset);
        let before = &self.text[self.line_starts[line - 1]..offset];
        let before =
            if line == 1 { before.strip_prefix(BYTE_ORDER_MARK).unwrap_or(before) } else { before };
        (line, before.chars().count() + 1)
    }

    /// Widens the byte range `span` to whole characters of the text.
    pub fn whole_characters(&self, span: Range<usize>) -> Range<usize> {
        let start = self.character_start(span.start);
        if start == self.text.len() {
            // A fault at the end of the file is shown at the end of the last line.
            let line = self.text.strip_suffix('\n').unwrap_or(&self.text);
            let end = line.strip_suffix('\r').unwrap_or(line).len();
            return end..end;
        }
        let mut end = span.end.clamp(start, self.text.len());
        while !self.text.is_char_boundary(end) {
            end += 1;
        }
        start..end
    }

    fn character_start(&self, offset: usize) -> usize {
        let mut start = offset.min(self.text.len());
        while !self.text.is_char_boundary(start) {
            start -= 1;
        }
        start
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_characters_from_one() {
        let source = Source::new("\u{feff}a = 1\r\nµ = \"½\"\n\n");
        assert_eq!(source.position(0), (1, 1));
        assert_eq!(source.position(3), (1, 1), "the byte order mark must not count as a column");
        let second_line = source.text.find('µ').unwrap();
        assert_eq!(source.position(second_line), (2, 1));
        assert_eq!(source.position(second_line + 1), (2, 1), "inside a character: its start");
        assert_eq!(source.position(second_line + 2), (2, 2));
        assert_eq!(source.position(usize::MAX), (4, 1));
    }

    #[test]
    fn spans_are_widened_to_whole_characters() {
        let source = Source::new("aµb");
        assert_eq!(source.whole_characters(2..2), 1..2 + 1);
        assert_eq!(source.whole_characters(1..2), 1..3);
        assert_eq!(source.whole_characters(9..99), 4..4);
        assert_eq!(Source::new("a\r\n").whole_characters(3..3), 1..1);
    }
}
