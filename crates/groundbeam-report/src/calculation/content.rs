//! The content of a report before it is set in type.

use super::formulas::Formula;
use super::print::{cell, words};
use crate::text::sheet::{Entry, Sheet, Tone};
use groundbeam::Field;
use serde::Serialize;

/// A whole report.
#[derive(Debug, Clone, Default, Serialize)]
pub struct Report {
    /// What the model is called, or its file where it has no title.
    pub title: String,
    /// The version of the program that made it.
    pub version: &'static str,
    /// The SHA-256 digest of the input file, in hexadecimal digits.
    pub digest: String,
    /// What it is, in a few words.
    pub subject: &'static str,
    /// What came out, in one line each: what everybody reads first.
    pub verdicts: Vec<Verdict>,
    /// The numbers that everybody looks for.
    pub key: Vec<Key>,
    /// Its parts, numbered in this order from 1.
    pub sections: Vec<Section>,
}

/// A statement that is good or bad.
#[derive(Debug, Clone, Serialize)]
pub struct Verdict {
    /// `good`, `doubtful` or `bad`.
    pub tone: &'static str,
    /// Its first words.
    pub head: String,
    /// What it says.
    pub words: String,
}

/// A number with what it is.
#[derive(Debug, Clone, Serialize)]
pub struct Key {
    /// What it is.
    pub label: String,
    /// The number with its unit.
    pub value: String,
    /// Where it is, or of what.
    pub note: String,
}

impl Key {
    /// The fields of which the largest value is named first.
    pub(crate) const FIELDS: [Field; 4] =
        [Field::Deflection, Field::Moment, Field::Pressure, Field::Gap];

    /// The largest value of a field.
    pub(crate) fn largest(field: Field, value: String, note: String) -> Self {
        Key { label: format!("Largest {}", field.label().to_lowercase()), value, note }
    }
}

/// A numbered part.
#[derive(Debug, Clone, Serialize)]
pub struct Section {
    /// What it is about.
    pub title: &'static str,
    /// What it is made of.
    pub blocks: Vec<Block>,
}

/// A part of a section.
#[derive(Debug, Clone, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Block {
    /// A paragraph.
    Text {
        /// What it says.
        words: String,
    },
    /// Statements, each with a dot before it.
    List {
        /// The statements.
        items: Vec<String>,
    },
    /// Labelled statements.
    Facts {
        /// The statements.
        facts: Vec<Fact>,
    },
    /// A table.
    Table(Table),
    /// A picture; figures are numbered through the whole report.
    Figure {
        /// The picture, as wide as the page's text.
        svg: String,
        /// What it shows.
        caption: String,
    },
    /// Formulas below one another.
    Equations {
        /// A formula a line.
        lines: Vec<Equation>,
    },
    /// A file, line by line, the lines numbered from 1.
    Code {
        /// The lines, without their ends.
        lines: Vec<String>,
    },
}

/// A labelled statement.
#[derive(Debug, Clone, Serialize)]
pub struct Fact {
    /// What it is about; empty where it continues the one above.
    pub label: String,
    /// A label within the statement; empty where it has none.
    pub inner: String,
    /// `plain`, `good`, `doubtful` or `bad`.
    pub tone: &'static str,
    /// The first part, in its tone; empty where nothing is set off.
    pub head: String,
    /// What it says.
    pub words: String,
}

/// Rows under a head.
#[derive(Debug, Clone, Default, Serialize)]
pub struct Table {
    /// What it shows.
    pub caption: String,
    /// The heads of its columns.
    pub columns: Vec<Column>,
    /// Its rows, a cell for every column.
    pub rows: Vec<Vec<String>>,
    /// What is said below it; may be empty.
    pub note: String,
}

/// The head of a column, and which way its cells are set.
#[derive(Debug, Clone, Serialize)]
pub struct Column {
    /// What stands in it.
    pub head: String,
    /// The unit of its numbers; empty where they have none.
    pub unit: String,
    /// Whether it holds numbers, which are set to the right.
    pub number: bool,
}

/// A formula with its number and what it says.
#[derive(Debug, Clone, Serialize)]
pub struct Equation {
    /// The formula.
    #[serde(flatten)]
    pub formula: Formula,
    /// Where it holds, or what it is; may be empty.
    pub words: &'static str,
    /// Its number in the source; empty where it has none.
    pub number: &'static str,
}

impl Section {
    pub(super) fn new(title: &'static str, blocks: Vec<Block>) -> Self {
        Section { title, blocks }
    }
}

impl Table {
    pub(super) fn new(caption: impl Into<String>, columns: Vec<Column>) -> Self {
        Table { caption: caption.into(), columns, ..Table::default() }
    }

    pub(super) fn push(&mut self, row: impl IntoIterator<Item = String>) {
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
            let tone = tone.name();
            Some(Fact { tone, head: words(head), ..plain(label, "", rest) })
        }
        Entry::Item { label, words } => Some(plain("", label, words)),
        Entry::Heading(words) | Entry::Line(words) => Some(plain("", "", words)),
        Entry::Blank => None,
    }
}
