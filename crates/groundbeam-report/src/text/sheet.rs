//! A page of labelled rows, at most 80 columns wide. Whatever a file calls its parts is escaped here.

pub(crate) use crate::tone::Tone;
use groundbeam_file::printable;

/// The width no line exceeds, as far as words allow.
const WIDTH: usize = 80;
/// Where the text of a row begins.
const COLUMN: usize = 13;

/// What a page is made of.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Entry {
    Blank,
    /// A paragraph that begins at the left edge.
    Heading(String),
    /// A line of a table, as it is.
    Line(String),
    /// A labelled row; an empty label continues the row above. The tone is that of its first part, up to a colon.
    Row {
        label: String,
        words: String,
        tone: Tone,
    },
    /// A row within a row.
    Item {
        label: String,
        words: String,
    },
}

/// The page so far: what it says, for whoever sets it in type.
pub(crate) struct Sheet {
    entries: Vec<Entry>,
    colour: bool,
}

impl Sheet {
    pub fn new(colour: bool) -> Self {
        Sheet { entries: Vec::new(), colour }
    }

    /// What it says.
    pub fn entries(self) -> Vec<Entry> {
        self.entries
    }

    /// As text.
    pub fn finish(self) -> String {
        let mut text = String::new();
        self.entries.iter().for_each(|entry| self.print(entry, &mut text));
        text
    }

    /// The rows alone, for a page that has a layout of its own.
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

    /// A paragraph that begins at the left edge.
    pub fn heading(&mut self, words: &str) {
        self.entries.push(Entry::Heading(printable(words).into_owned()));
    }

    /// A line of a table, as it is.
    pub fn line(&mut self, words: &str) {
        self.entries.push(Entry::Line(printable(words).into_owned()));
    }

    /// `label        words`, wrapped under themselves. An empty label continues the row above.
    pub fn row(&mut self, label: &str, words: &str) {
        self.toned_row(label, words, Tone::Plain);
    }

    /// The same with the first part of the words, up to a colon, in a tone.
    pub fn toned_row(&mut self, label: &str, words: &str, tone: Tone) {
        let [label, words] = [label, words].map(|text| printable(text).into_owned());
        self.entries.push(Entry::Row { label, words, tone });
    }

    /// `             label       words`: a row within a row.
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
        let gap = " ".repeat(COLUMN.saturating_sub(label.chars().count()).max(1));
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

/// Lines of at most `width` characters, broken at spaces; a longer word stays whole. Never empty.
fn wrapped(words: &str, width: usize) -> Vec<String> {
    // Several spaces in a row are the columns of a table and stay.
    if words.chars().count() <= width {
        return vec![words.to_owned()];
    }
    let mut lines = vec![String::new()];
    for word in unbroken(words) {
        let line = lines.last_mut().filter(|line| {
            line.is_empty() || line.chars().count() + 1 + word.chars().count() <= width
        });
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

/// Words as they may be parted; what stands in brackets stays together: `[0, 5]`.
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
    fn words_wrap_under_themselves() {
        let mut sheet = Sheet::new(false);
        sheet.row("Contact", &"word ".repeat(20));
        let text = sheet.finish();
        assert!(text.lines().all(|line| line.len() <= WIDTH && !line.ends_with(' ')));
        assert!(text.lines().nth(1).is_some_and(|line| line.starts_with("             word")));
    }

    #[test]
    fn colour_only_when_asked() {
        let row = |colour| {
            let mut sheet = Sheet::new(colour);
            sheet.toned_row("Verdict", "none: it tips", Tone::Bad);
            sheet.finish()
        };
        assert_eq!(row(false), "Verdict      none: it tips\n");
        assert_eq!(
            row(true),
            "\u{1b}[1mVerdict\u{1b}[0m      \u{1b}[1;31mnone\u{1b}[0m: it tips\n"
        );
    }
}
