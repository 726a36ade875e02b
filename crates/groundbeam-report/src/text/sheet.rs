//! Formats labelled rows as text of at most 80 columns. Names from the file are escaped here.

pub(crate) use crate::tone::Tone;
use groundbeam_file::printable;
use unicode_width::UnicodeWidthStr;

/// Maximum width of a line, unless a word is longer.
const WIDTH: usize = 80;
/// Column at which the text of a row begins.
pub(super) const COLUMN: usize = 13;

/// An element of a page.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Entry {
    Blank,
    /// A heading, which begins at the left edge of the page.
    Heading(String),
    /// A line of a table. The line is printed without wrapping.
    Line(String),
    /// A row with a label and a text. A row with an empty label continues the previous row. The text is printed
    /// in the colour of `tone` up to its first colon.
    Row {
        label: String,
        words: String,
        tone: Tone,
    },
    /// An indented row that belongs to the row above.
    Item {
        label: String,
        words: String,
    },
}

/// The content of a page, independent of its layout.
pub(crate) struct Sheet {
    entries: Vec<Entry>,
    colour: bool,
}

impl Sheet {
    pub fn new(colour: bool) -> Self {
        Sheet { entries: Vec::new(), colour }
    }

    /// The elements of the page.
    pub fn entries(self) -> Vec<Entry> {
        self.entries
    }

    /// The page as text.
    pub fn finish(self) -> String {
        let mut text = String::new();
        self.entries.iter().for_each(|entry| self.print(entry, &mut text));
        text
    }

    /// Labels and texts of all rows, for pages with their own layout.
    pub fn into_rows(self) -> Vec<(String, String)> {
        let row = |entry: Entry| match entry {
            Entry::Row { label, words, .. } => Some((label, words)),
            _ => None,
        };
        self.entries.into_iter().filter_map(row).collect()
    }

    pub fn blank(&mut self) {
        self.entries.push(Entry::Blank);
    }

    /// Adds a heading, which begins at the left edge of the page.
    pub fn heading(&mut self, words: &str) {
        self.entries.push(Entry::Heading(printable(words).into_owned()));
    }

    /// Adds a line of a table. The line is printed without wrapping.
    pub fn line(&mut self, words: &str) {
        self.entries.push(Entry::Line(printable(words).into_owned()));
    }

    /// Adds a row `label        words`. Wrapped lines are aligned with `words`. An empty label continues the
    /// previous row.
    pub fn row(&mut self, label: &str, words: &str) {
        self.toned_row(label, words, Tone::Plain);
    }

    /// Adds a row. The text before the first colon is printed in the colour of `tone`.
    pub fn toned_row(&mut self, label: &str, words: &str, tone: Tone) {
        let [label, words] = [label, words].map(|text| printable(text).into_owned());
        self.entries.push(Entry::Row { label, words, tone });
    }

    /// Adds an indented row that belongs to the row above, `             label       words`.
    pub fn item(&mut self, label: &str, words: &str) {
        let [label, words] = [label, words].map(|text| printable(text).into_owned());
        self.entries.push(Entry::Item { label, words });
    }

    fn print(&self, entry: &Entry, text: &mut String) {
        match entry {
            Entry::Blank => text.push('\n'),
            Entry::Heading(words) => {
                for line in wrapped(words, WIDTH) {
                    *text += &self.painted(&line, Tone::Heading);
                    text.push('\n');
                }
            }
            Entry::Line(words) => {
                *text += words.trim_end();
                text.push('\n');
            }
            Entry::Row { label, words, tone } => self.print_row(label, words, *tone, text),
            Entry::Item { label, words } => {
                const INNER: usize = 12;
                for (i, line) in wrapped(words, WIDTH - COLUMN - INNER).iter().enumerate() {
                    let label = if i == 0 { label } else { "" };
                    *text += &format!("{:COLUMN$}{label:<INNER$}{line}\n", "");
                }
            }
        }
    }

    fn print_row(&self, label: &str, words: &str, tone: Tone, text: &mut String) {
        let gap = " ".repeat(COLUMN.saturating_sub(columns(label)).max(1));
        let head = self.painted(label, Tone::Heading) + &gap;
        for (i, line) in wrapped(words, WIDTH - COLUMN).iter().enumerate() {
            let lead = if i == 0 { head.clone() } else { " ".repeat(COLUMN) };
            let line = match line.find(':') {
                Some(colon) if i == 0 && tone != Tone::Plain => {
                    self.painted(&line[..colon], tone) + &line[colon..]
                }
                None if i == 0 => self.painted(line, tone),
                _ => line.clone(),
            };
            *text += format!("{lead}{line}").trim_end();
            text.push('\n');
        }
    }

    fn painted(&self, words: &str, tone: Tone) -> String {
        if self.colour && tone != Tone::Plain && !words.is_empty() {
            format!("{}{words}\u{1b}[0m", tone.code())
        } else {
            words.to_owned()
        }
    }
}

/// Number of terminal columns that a text occupies: two for a Chinese character, none for a combining accent.
pub(super) fn columns(text: &str) -> usize {
    UnicodeWidthStr::width(text)
}

/// Breaks a text at spaces into lines of at most `width` columns. A longer word is not broken. Returns at least
/// one line.
fn wrapped(words: &str, width: usize) -> Vec<String> {
    // A text that fits into one line keeps its spaces, because several spaces can separate the columns of a
    // table.
    if columns(words) <= width {
        return vec![words.to_owned()];
    }
    let mut lines = vec![String::new()];
    for word in unbroken(words) {
        let fits =
            |line: &&mut String| line.is_empty() || columns(line) + 1 + columns(&word) <= width;
        let line = lines.last_mut().filter(fits);
        match line {
            Some(line) => {
                if !line.is_empty() {
                    line.push(' ');
                }
                line.push_str(&word);
            }
            None => lines.push(word),
        }
    }
    lines
}

/// Splits a text into parts between which a line may break: words, and texts in brackets such as `[0, 5]`.
fn unbroken(words: &str) -> Vec<String> {
    let mut parts: Vec<String> = Vec::new();
    for word in words.split_whitespace() {
        match parts.last_mut() {
            Some(last) if last.contains('[') && !last.contains(']') => {
                last.push(' ');
                last.push_str(word);
            }
            _ => parts.push(word.to_owned()),
        }
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrapped_lines_are_indented_to_their_column() {
        let mut sheet = Sheet::new(false);
        sheet.row("Contact", &"word ".repeat(20));
        let text = sheet.finish();
        assert!(text.lines().all(|line| line.len() <= WIDTH && !line.ends_with(' ')));
        assert!(text.lines().nth(1).is_some_and(|line| line.starts_with("             word")));
    }

    #[test]
    fn wide_characters_take_two_columns_and_combining_accents_none() {
        let mut sheet = Sheet::new(false);
        sheet.row("Fe\u{301}", &"基礎梁 ".repeat(20));
        let text = sheet.finish();
        assert!(text.starts_with("Fe\u{301}           基礎梁"), "{text}");
        assert!(text.lines().all(|line| columns(line) <= WIDTH), "{text}");
        assert!(text.lines().count() == 3, "{text}");
    }

    #[test]
    fn text_is_coloured_only_on_request() {
        let row = |colour| {
            let mut sheet = Sheet::new(colour);
            sheet.toned_row("Verdict", "none: the beam tips", Tone::Bad);
            sheet.finish()
        };
        assert_eq!(row(false), "Verdict      none: the beam tips\n");
        assert_eq!(
            row(true),
            "\u{1b}[1mVerdict\u{1b}[0m      \u{1b}[1;31mnone\u{1b}[0m: the beam tips\n"
        );
    }
}
