//! One table of a file, with its location and its allowed keys.

use crate::keys::{Key, Table};
use groundbeam::model::Part;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A table with its location and its allowed keys.
#[derive(Clone)]
pub(crate) struct Section<'a> {
    pub table: &'a DeTable<'a>,
    /// Location of the header, or of the braces of an inline table.
    pub span: Range<usize>,
    pub keys: &'static Table,
    /// Part of the model that the table describes. The location of each quantity in the table is stored under this
    /// part, for messages about the model.
    pub part: Option<Part>,
}

impl<'a> Section<'a> {
    /// Returns the table that represents the whole file.
    pub fn root(table: &'a DeTable<'a>, keys: &'static Table) -> Self {
        Section { table, span: 0..0, keys, part: None }
    }

    /// Name of the table in files, such as `[beam]` or `[[load]]`.
    pub fn name(&self) -> &'static str {
        self.keys.name
    }

    pub fn key(&self, name: &str) -> &'static Key {
        self.keys.key(name)
    }

    /// Whether this table and the tables inside it contain numbers, and no number is in quotes.
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

    /// Returns the value of a key if the value is a list without elements.
    pub fn empty_list(&self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.value(key)
            .filter(|value| value.get_ref().as_array().is_some_and(|list| list.is_empty()))
    }
}
