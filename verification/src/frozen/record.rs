//! Reads and writes the records of the frozen files, each with a title and one line for each quantity.

use std::path::Path;

/// A title and its lines.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Record {
    /// The family and the number of a model, such as `Hard 7371`.
    pub title: String,
    /// The lines, in the order of the file.
    pub lines: Vec<Line>,
}

/// A line with a key and the words after the key; most words are numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// The first word.
    pub key: String,
    /// All other words.
    pub words: Vec<String>,
}

impl Line {
    /// Returns the words as numbers, with NaN for a word that is not a number.
    pub fn numbers(&self) -> Vec<f64> {
        self.words.iter().map(|word| word.parse().unwrap_or(f64::NAN)).collect()
    }
}

impl Record {
    /// Makes a record from a title and the text of its lines.
    pub fn new(title: &str, lines: &str) -> Record {
        let line = |line: &str| {
            let mut words = line.split_whitespace().map(str::to_owned);
            Some(Line { key: words.next()?, words: words.collect() })
        };
        Record { title: title.to_owned(), lines: lines.lines().filter_map(line).collect() }
    }

    /// Reads all records of a text, in which empty lines separate the records.
    pub fn all(text: &str) -> Vec<Record> {
        let parts = text.split("\n\n").map(|part| part.trim_start_matches('\n'));
        let record = |part: &str| {
            let (title, lines) = part.split_once('\n').unwrap_or((part, ""));
            Record::new(title, lines)
        };
        parts.filter(|part| !part.is_empty()).map(record).collect()
    }

    /// All records of a file.
    pub fn of_file(path: &Path) -> std::io::Result<Vec<Record>> {
        Ok(Record::all(&std::fs::read_to_string(path)?))
    }

    /// Returns the text of the record with the empty line at its end.
    pub fn text(&self) -> String {
        let mut text = self.title.clone() + "\n";
        for line in &self.lines {
            text += &line.key;
            for word in &line.words {
                text += " ";
                text += word;
            }
            text += "\n";
        }
        text + "\n"
    }

    /// The line of a key.
    pub fn line(&self, key: &str) -> Option<&Line> {
        self.lines.iter().find(|line| line.key == key)
    }

    /// Returns the numbers in the line with a key; empty if the record has no line with this key.
    pub fn numbers(&self, key: &str) -> Vec<f64> {
        self.line(key).map(Line::numbers).unwrap_or_default()
    }

    /// The first word of a key.
    pub fn word(&self, key: &str) -> &str {
        self.line(key).and_then(|line| line.words.first()).map_or("", String::as_str)
    }
}
