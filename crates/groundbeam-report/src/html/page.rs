//! What a report is made of, before it is set in type.

use super::print::{cell, words};
use crate::text::sheet::{Entry, Sheet, Tone};
use serde::Serialize;

/// A whole report.
#[derive(Debug, Clone, Default, Serialize)]
pub(super) struct Report {
    /// What it is, in a few words.
    pub subject: &'static str,
    /// What came out, in one line each: what everybody reads first.
    pub verdicts: Vec<Verdict>,
    /// The numbers that everybody looks for.
    pub key: Vec<Key>,
    pub sections: Vec<Section>,
}

/// A statement that is good or bad.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Verdict {
    pub tone: &'static str,
    pub head: String,
    pub words: String,
}

/// A number with what it is.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Key {
    pub label: &'static str,
    pub value: String,
    pub note: String,
}

/// A numbered part.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Section {
    pub title: &'static str,
    pub blocks: Vec<Block>,
}

/// A part of a section.
#[derive(Debug, Clone, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub(super) enum Block {
    Text { words: String },
    List { items: Vec<String> },
    Facts { facts: Vec<Fact> },
    Table(Table),
    Figure { svg: String, caption: String },
    Equations { lines: Vec<Equation> },
    Code { lines: Vec<String> },
}

/// A labelled statement.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Fact {
    /// Empty where it continues the one above.
    pub label: String,
    pub inner: String,
    pub tone: &'static str,
    /// The first part, in its tone.
    pub head: String,
    pub words: String,
}

/// Rows under a head.
#[derive(Debug, Clone, Default, Serialize)]
pub(super) struct Table {
    pub caption: String,
    pub columns: Vec<Column>,
    pub rows: Vec<Vec<String>>,
    pub note: String,
}

/// The head of a column, and which way its cells are set.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Column {
    pub head: String,
    pub unit: String,
    pub number: bool,
}

/// A formula with its number and what it says.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Equation {
    pub mathml: String,
    pub words: String,
    pub number: &'static str,
}

impl Section {
    pub fn new(title: &'static str, blocks: Vec<Block>) -> Self {
        Section { title, blocks }
    }
}

impl Table {
    pub fn new(caption: impl Into<String>, columns: Vec<Column>) -> Self {
        Table { caption: caption.into(), columns, ..Table::default() }
    }

    pub fn push(&mut self, row: impl IntoIterator<Item = String>) {
        self.rows.push(row.into_iter().map(|words| cell(&words)).collect());
    }
}

/// A column of numbers in a unit, which may be none.
pub(super) fn numbers(head: &str, unit: &str) -> Column {
    Column { head: head.to_owned(), unit: unit.to_owned(), number: true }
}

/// A column of words.
pub(super) fn wording(head: &str) -> Column {
    Column { head: head.to_owned(), unit: String::new(), number: false }
}

/// What the report for a terminal says, as statements; none where it says nothing.
pub(super) fn facts(say: impl FnOnce(&mut Sheet)) -> Option<Block> {
    let mut sheet = Sheet::new(false);
    say(&mut sheet);
    let facts: Vec<Fact> = sheet.entries().iter().filter_map(fact).collect();
    (!facts.is_empty()).then_some(Block::Facts { facts })
}

fn fact(entry: &Entry) -> Option<Fact> {
    let plain = |label: &str, inner: &str, said: &str| Fact {
        label: label.to_owned(),
        inner: words(inner),
        tone: "plain",
        head: String::new(),
        words: words(said),
    };
    match entry {
        Entry::Row { label, words: said, tone } => {
            let (head, rest) = match said.split_once(':') {
                Some((head, rest)) if *tone != Tone::Plain => (head, rest.trim_start()),
                _ => ("", said.as_str()),
            };
            let tone = tone_name(*tone);
            Some(Fact { tone, head: words(head), ..plain(label, "", rest) })
        }
        Entry::Item { label, words } => Some(plain("", label, words)),
        Entry::Heading(words) | Entry::Line(words) => Some(plain("", "", words)),
        Entry::Blank => None,
    }
}

pub(super) fn tone_name(tone: Tone) -> &'static str {
    match tone {
        Tone::Plain | Tone::Heading => "plain",
        Tone::Good => "good",
        Tone::Doubtful => "doubtful",
        Tone::Bad => "bad",
    }
}
