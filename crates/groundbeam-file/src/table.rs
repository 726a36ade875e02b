//! One table of the file.

use crate::keys::{Key, Table};
use groundbeam::model::Part;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A table with its place and the keys that it may have.
#[derive(Clone)]
pub(crate) struct Section<'a> {
    pub table: &'a DeTable<'a>,
    /// The header, or the braces of an inline table.
    pub span: Range<usize>,
    pub keys: &'static Table,
    /// The part of the model that it describes: quantities that are read become fields of it, with their places.
    pub part: Option<Part>,
}

impl<'a> Section<'a> {
    /// The whole file.
    pub fn root(table: &'a DeTable<'a>, keys: &'static Table) -> Self {
        Section { table, span: 0..0, keys, part: None }
    }

    /// As a file writes it: `[beam]`, `[[load]]`.
    pub fn name(&self) -> &'static str {
        self.keys.name
    }

    pub fn key(&self, name: &str) -> &'static Key {
        self.keys.key(name)
    }

    /// Whether numbers stand bare in this table and those below, and none stands in quotes.
    pub fn has_bare_numbers_only(&self) -> bool {
        let mut bare = false;
        let mut waiting: Vec<&DeValue> =
            self.table.iter().map(|(_, value)| value.get_ref()).collect();
        while let Some(value) = waiting.pop() {
            match value {
                DeValue::Table(table) => waiting.extend(table.iter().map(|(_, v)| v.get_ref())),
                DeValue::Array(array) => waiting.extend(array.iter().map(|v| v.get_ref())),
                DeValue::Integer(_) | DeValue::Float(_) => bare = true,
                DeValue::String(text)
                    if text.trim_start().starts_with(|c: char| c.is_ascii_digit()) =>
                {
                    return false;
                }
                _ => {}
            }
        }
        bare
    }

    pub fn value(&self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.table.get(key)
    }
}
