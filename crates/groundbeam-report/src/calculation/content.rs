//! Content of a calculation report, independent of its layout.

use super::formulas::Formula;
use super::print::{cell, words};
use crate::text::sheet::{Entry, Sheet, Tone};
use groundbeam::Field;
use serde::Serialize;

/// A whole report.
#[derive(Debug, Clone, Default, Serialize)]
pub struct Report {
    /// Title of the model, or the name of the model file if the model has no title.
    pub title: String,
    /// Version of the program.
    pub version: &'static str,
    /// SHA-256 digest of the model file, in hexadecimal digits.
    pub digest: String,
    /// Kind of the report, in a few words.
    pub subject: &'static str,
    /// Main results of the report, with one line for each result.
    pub verdicts: Vec<Verdict>,
    /// Key figures of the report.
    pub key: Vec<Key>,
    /// Sections of the report, numbered from 1.
    pub sections: Vec<Section>,
}

/// A main result of the report, as a statement with an assessment.
#[derive(Debug, Clone, Serialize)]
pub struct Verdict {
    /// Assessment of the statement: `good`, `doubtful` or `bad`.
    pub tone: &'static str,
    /// Heading of the statement.
    pub head: String,
    /// The statement.
    pub words: String,
}

/// A key figure.
#[derive(Debug, Clone, Serialize)]
pub struct Key {
    /// Name of the quantity.
    pub label: String,
    /// Value with its unit.
    pub value: String,
    /// Position of the value along the beam, or a remark on the value.
    pub note: String,
}

impl Key {
    /// Fields whose largest values are key figures of the report.
    pub(crate) const FIELDS: [Field; 4] =
        [Field::Deflection, Field::Moment, Field::Pressure, Field::Gap];

    /// Creates the key figure for the largest value of a field.
    pub(crate) fn largest(field: Field, value: String, note: String) -> Self {
        Key { label: format!("Largest {}", field.label().to_lowercase()), value, note }
    }
}

/// A numbered section.
#[derive(Debug, Clone, Serialize)]
pub struct Section {
    /// Heading of the section.
    pub title: &'static str,
    /// Blocks of the section.
    pub blocks: Vec<Block>,
}

/// A part of a section.
#[derive(Debug, Clone, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Block {
    /// A paragraph.
    Text {
        /// The text.
        words: String,
    },
    /// A bulleted list.
    List {
        /// Items of the list.
        items: Vec<String>,
    },
    /// Labelled statements.
    Facts {
        /// The statements.
        facts: Vec<Fact>,
    },
    /// A table.
    Table(Table),
    /// A picture. The pictures of the whole report are numbered consecutively.
    Figure {
        /// The picture in SVG, as wide as the text of the page.
        svg: String,
        /// Caption.
        caption: String,
    },
    /// A list of formulas.
    Equations {
        /// One formula per line.
        lines: Vec<Equation>,
    },
    /// A file printed with line numbers.
    Code {
        /// The lines of the file, without line ends.
        lines: Vec<String>,
    },
}

/// A labelled statement.
#[derive(Debug, Clone, Serialize)]
pub struct Fact {
    /// Label of the statement; empty if the statement continues the previous statement.
    pub label: String,
    /// Label of an item in a list of statements; empty outside lists.
    pub inner: String,
    /// Assessment of the statement: `plain`, `good`, `doubtful` or `bad`.
    pub tone: &'static str,
    /// Emphasized first words of the statement; may be empty.
    pub head: String,
    /// The statement.
    pub words: String,
}

/// A table.
#[derive(Debug, Clone, Default, Serialize)]
pub struct Table {
    /// Caption.
    pub caption: String,
    /// Headings, units and alignments of the columns of the table.
    pub columns: Vec<Column>,
    /// Rows of the table, with one cell for each column.
    pub rows: Vec<Vec<String>>,
    /// Note below the table; may be empty.
    pub note: String,
}

/// Heading, unit and alignment of a column of a table.
#[derive(Debug, Clone, Serialize)]
pub struct Column {
    /// Heading of the column.
    pub head: String,
    /// Unit of the numbers in the column; empty for numbers without a unit.
    pub unit: String,
    /// Whether the column contains numbers, which are right-aligned.
    pub number: bool,
}

/// A formula with its explanation and number.
#[derive(Debug, Clone, Serialize)]
pub struct Equation {
    /// The formula.
    #[serde(flatten)]
    pub formula: Formula,
    /// The domain or the meaning of the formula; may be empty.
    pub words: &'static str,
    /// Number of the formula in Kikuchi's paper; empty if the paper does not number it.
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

/// Creates a column of numbers with a unit. The unit may be empty.
pub(super) fn numbers(head: &str, unit: &str) -> Column {
    Column { head: head.to_owned(), unit: unit.to_owned(), number: true }
}

/// Creates a column of text.
pub(super) fn wording(head: &str) -> Column {
    Column { head: head.to_owned(), unit: String::new(), number: false }
}

/// Converts the text that `say` writes to labelled statements; `None` if `say` writes no text.
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
