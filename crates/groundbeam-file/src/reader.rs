//! Reads tables and values of a TOML document and records their locations.
//!
//! Reading continues after a fault. An unreadable value becomes NaN, and values that depend on it are not reported
//! again.

use crate::beside::{Beside, OtherFile};
use crate::code;
use crate::diagnostic::Diagnostic;
use crate::document::Places;
use crate::fault::Fault;
use crate::keys::{self, Key, Table, Value};
use crate::quantity::{self, Kind, Written};
use crate::source::Source;
use crate::suggest;
use crate::table::Section;
use crate::unit::{Dimension, Marks};
use crate::units::Seen;
use groundbeam::model::Part;
use std::ops::Range;
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeInteger, DeValue};

/// A value and its place in the file.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Field {
    /// Value in SI units, or as written if the file has no units; NaN if the value is missing or unreadable, which
    /// has been reported.
    pub value: f64,
    pub span: Range<usize>,
}

impl Field {
    pub fn new(value: f64, span: Range<usize>) -> Self {
        Field { value, span }
    }

    /// Placeholder for a value that is missing or cannot be read.
    pub fn unreadable(span: Range<usize>) -> Self {
        Field { value: f64::NAN, span }
    }
}

pub(crate) struct Reader<'s> {
    pub source: &'s Source,
    /// Source of the files to which the model file refers; `None` if it must not refer to other files.
    pub beside: Option<Beside<'s>>,
    /// Files to which the model file refers and that have been read.
    pub others: Vec<Arc<OtherFile>>,
    pub found: Vec<Diagnostic>,
    pub quantities: Vec<Seen>,
    pub places: Places,
    /// Whether numbers without a unit are in SI units and may be mixed with numbers with units.
    pub bare_is_si: bool,
    /// Whether the file seems to have no units. The hints in error messages depend on this flag.
    plain: bool,
    /// Known keys that the file probably misspells, each with the byte position of its table.
    meant: Vec<(usize, String)>,
}

impl<'s> Reader<'s> {
    pub fn new(
        source: &'s Source,
        root: &Section,
        beside: Option<Beside<'s>>,
        bare_is_si: bool,
    ) -> Self {
        Reader {
            source,
            beside,
            others: vec![],
            found: vec![],
            quantities: vec![],
            places: Places::default(),
            bare_is_si,
            plain: !bare_is_si && root.has_bare_numbers_only(),
            meant: vec![],
        }
    }

    /// Reports a fault, unless a syntax fault at the same location has been reported already.
    pub fn report(&mut self, fault: Fault) {
        let same = |known: &Diagnostic| known.code == code::SYNTAX && known.span == fault.at;
        if self.found.iter().any(same) {
            return;
        }
        self.found.push(Diagnostic::new(self.source, fault));
    }

    /// Reports a fault in another file.
    pub fn report_in(&mut self, source: &Source, file: &Arc<OtherFile>, fault: Fault) {
        let file = Some(Arc::clone(file));
        self.found.push(Diagnostic { file, ..Diagnostic::new(source, fault) });
    }

    /// Whether the file seems to have no units.
    pub fn is_plain(&self) -> bool {
        self.plain
    }

    pub fn report_with(&mut self, fault: Fault, related: Range<usize>, label: &str) {
        let diagnostic = Diagnostic::new(self.source, fault);
        self.found.push(diagnostic.with_related(self.source, related, label));
    }

    /// Reports an unknown word, which replaces `{}` in `message`. `known` and `otherwise` give the hint
    /// (`suggest::advice`).
    pub fn unknown_word(
        &mut self,
        (written, span): (&str, Range<usize>),
        message: &str,
        known: &[&str],
        otherwise: &str,
    ) {
        let message = message.replace("{}", written);
        let hint = suggest::advice(written, known, otherwise);
        self.report(Fault::new(code::UNKNOWN_WORD, span, message, "", hint));
    }

    /// Reports that `section` lacks all of `keys`. Reports nothing if `section` has a misspelt form of one of them.
    /// `example` is a valid line.
    pub fn missing(&mut self, section: &Section, keys: &[&str], what: &str, example: &str) {
        let is_misspelt = |key: &&str| {
            self.meant.iter().any(|(table, meant)| *table == section.span.start && meant == key)
        };
        if keys.iter().any(is_misspelt) {
            return;
        }
        let message = format!("{} has no {what}", section.name());
        let hint = format!("add {example}");
        self.report(Fault::new(code::MISSING, section.span.clone(), message, "", hint));
    }

    /// Reports two keys that are mutually exclusive, at the location of the later key.
    pub fn exclusive(&mut self, a: (&str, &Range<usize>), b: (&str, &Range<usize>), hint: &str) {
        let (first, later) = if a.1.start <= b.1.start { (a, b) } else { (b, a) };
        let message = format!("`{}` and `{}` are mutually exclusive", first.0, later.0);
        let fault = Fault::new(code::EXCLUSIVE, later.1.clone(), message, "", hint);
        self.report_with(fault, first.1.clone(), "given here");
    }

    /// Reports every key of `section` that is not listed in `names`.
    pub fn refuse_all_but(&mut self, section: &Section, names: &[&str]) {
        for (key, _) in section.table.iter().filter(|(key, _)| !names.contains(&&**key.get_ref())) {
            let written = key.get_ref();
            let message = format!("`{written}` is not a key of {}", section.name());
            let keys: Vec<&Key> = names.iter().map(|name| section.key(name)).collect();
            let hint = match (keys::becomes(written, &keys), keys::meant(written, &keys)) {
                (Some((meant, how)), _) => {
                    self.meant.push((section.span.start, meant.to_owned()));
                    how.to_owned()
                }
                (None, Some(meant)) => {
                    self.meant.push((section.span.start, meant.to_owned()));
                    format!("did you mean `{meant}`?")
                }
                (None, None) => format!("allowed here: {}", names.join(", ")),
            };
            self.report(Fault::new(code::UNKNOWN_KEY, key.span(), message, "", hint));
        }
    }

    /// Reports every key of `section` that is not allowed in this table.
    pub fn refuse_unknown(&mut self, section: &Section) {
        self.refuse_all_but(section, &section.keys.names());
    }

    /// Reads the table `[key]`, if given, and reports its unknown keys.
    pub fn table<'a>(&mut self, parent: &Section<'a>, key: &str) -> Option<Section<'a>> {
        let section = self.open(parent, key)?;
        self.refuse_unknown(&section);
        Some(section)
    }

    /// Reads the table `[key]`, if given, which describes the part `part` of the model.
    pub fn part<'a>(&mut self, parent: &Section<'a>, key: &str, part: Part) -> Option<Section<'a>> {
        let section = Section { part: Some(part), ..self.table(parent, key)? };
        self.places.part(part, &section.span);
        Some(section)
    }

    /// Reads the table `[key]`, if given, without reporting unknown keys, because the allowed keys depend
    /// on a value in the table.
    pub fn open<'a>(&mut self, parent: &Section<'a>, key: &str) -> Option<Section<'a>> {
        let Value::Table(keys) = parent.key(key).value else { return None };
        let name = keys.name;
        let value = parent.value(key)?;
        match value.get_ref() {
            DeValue::Table(table) => Some(Section { table, span: value.span(), keys, part: None }),
            DeValue::Array(_) => {
                let message = format!("a file has only one {name}");
                self.wrong_type(value, message, format!("write {name} with single brackets"));
                None
            }
            _ => {
                let message = format!("`{key}` is a table, not a value");
                self.wrong_type(value, message, format!("write {name}, with its keys below it"));
                None
            }
        }
    }

    /// Reads the tables of the list `key`, and reports their unknown keys. Returns no table if the list is
    /// not given.
    pub fn tables<'a>(&mut self, parent: &Section<'a>, key: &str) -> Vec<Section<'a>> {
        let Value::Tables(keys) = parent.key(key).value else { return vec![] };
        let name = keys.name;
        let Some(value) = parent.value(key) else { return vec![] };
        let DeValue::Array(array) = value.get_ref() else {
            let (message, hint) = match keys.inline(key, self.plain) {
                Some(hint) => (format!("`{key}` is a list of tables"), hint),
                None => (
                    format!("`{key}` must be a list, because a file can have several {name}"),
                    format!("write {name} with double brackets"),
                ),
            };
            self.wrong_type(value, message, hint);
            return vec![];
        };
        let mut sections = Vec::new();
        for element in array.iter() {
            match element.get_ref() {
                DeValue::Table(table) => {
                    let section = Section { table, span: element.span(), keys, part: None };
                    self.refuse_unknown(&section);
                    sections.push(section);
                }
                _ => {
                    let message = format!("each element of `{key}` must be a table, not a value");
                    let hint = keys.inline(key, self.plain);
                    let hint =
                        hint.unwrap_or_else(|| format!("write {name}, with its keys below it"));
                    self.wrong_type(element, message, hint);
                }
            }
        }
        sections
    }

    /// Reads the tables of the list `key`. The table with the index `i` describes the part `part(i)` of the
    /// model.
    pub fn parts<'a>(
        &mut self,
        parent: &Section<'a>,
        key: &str,
        part: impl Fn(usize) -> Part,
    ) -> Vec<Section<'a>> {
        let mut sections = self.tables(parent, key);
        for (i, section) in sections.iter_mut().enumerate() {
            section.part = Some(part(i));
            self.places.part(part(i), &section.span);
        }
        sections
    }

    /// Reads the text under `key` in `section`, if given.
    pub fn text<'a>(
        &mut self,
        section: &Section<'a>,
        key: &str,
    ) -> Option<(&'a str, Range<usize>)> {
        let value = self.value(section, key)?;
        match value.get_ref() {
            DeValue::String(text) => Some((text, value.span())),
            _ => {
                let hint =
                    format!("write the text in quotes, as in {}", self.line(section.keys, key));
                self.wrong_type(value, format!("`{key}` must be text"), hint);
                None
            }
        }
    }

    /// Reads the integer under `key` in `section`, if given.
    pub fn count(&mut self, section: &Section, key: &str) -> Option<u64> {
        let Value::Count([least, most]) = section.key(key).value else { return None };
        let value = section.value(key)?;
        let DeValue::Integer(integer) = value.get_ref() else {
            let hint = format!("write the number without quotes, as in {key} = 1000");
            self.wrong_type(value, format!("`{key}` must be a whole number"), hint);
            return None;
        };
        let digits = integer.as_str().replace('_', "");
        let number = u64::from_str_radix(digits.trim_start_matches('+'), integer.radix()).ok();
        let fits = number.filter(|number| (least..=most).contains(number));
        if fits.is_none() {
            let message = format!("`{key}` must be from {least} to {most}");
            let hint = format!("for example {key} = {}", least.max(1000).min(most));
            self.report(Fault::new(code::RANGE, value.span(), message, "", hint));
        }
        fits
    }

    /// Reads the quantity under `key` in `section`, if given.
    pub fn quantity(&mut self, section: &Section, key: &str) -> Option<Field> {
        self.quantity_of(section, key, section.key(key).kind())
    }

    /// Reads an optional quantity whose kind depends on another key.
    pub fn quantity_of(
        &mut self,
        section: &Section,
        key: &str,
        kind: &'static Kind,
    ) -> Option<Field> {
        let read = self.value(section, key).map(|value| self.field(key, value, kind));
        if let Some(field) = &read {
            self.place(section, section.key(key).name, field);
        }
        read
    }

    /// Reads the required quantity under `key` in `section`.
    pub fn required(&mut self, section: &Section, key: &str) -> Field {
        self.required_of(section, key, section.key(key).kind())
    }

    /// Reads a required quantity whose kind depends on another key.
    pub fn required_of(&mut self, section: &Section, key: &str, kind: &'static Kind) -> Field {
        self.quantity_of(section, key, kind).unwrap_or_else(|| {
            let row = section.key(key);
            if !row.needed {
                self.missing(section, &[key], &format!("`{key}`"), &kind.line(key, self.plain));
            }
            let unreadable = Field::unreadable(section.span.clone());
            self.place(section, row.name, &unreadable);
            unreadable
        })
    }

    /// Records the location of a field. The field belongs to the part of the model that `section`
    /// describes.
    pub fn place(&mut self, section: &Section, name: &'static str, field: &Field) {
        if let Some(part) = section.part {
            self.places.field(part, name, field);
        }
    }

    /// Returns the value under `key`, if given, and reports a required key that is missing.
    pub fn value<'a>(
        &mut self,
        section: &Section<'a>,
        key: &str,
    ) -> Option<&'a Spanned<DeValue<'a>>> {
        let value = section.value(key);
        if value.is_none() && section.key(key).needed {
            let example = self.line(section.keys, key);
            self.missing(section, &[key], &format!("`{key}`"), &example);
        }
        value
    }

    /// Returns an example of a valid line for `key`, with units if this file has units.
    pub fn line(&self, table: &Table, key: &str) -> String {
        table.key(key).line(self.plain)
    }

    /// Returns an example of a list of two valid values, with units if this file has units.
    pub fn pair(&self, kind: &Kind) -> String {
        kind.pair(self.plain)
    }

    /// Reads one quantity from a TOML value of any type.
    pub fn field(&mut self, key: &str, value: &Spanned<DeValue>, kind: &'static Kind) -> Field {
        let span = value.span();
        let written = match value.get_ref() {
            DeValue::String(text) => kind
                .read(key, text, self.plain)
                .map_err(|fault| self.inside_string(text, &span, fault)),
            DeValue::Integer(integer) => bare_integer(integer, kind).map_err(|f| over(&span, f)),
            DeValue::Float(float) => {
                kind.read(key, float.as_str(), true).map_err(|fault| over(&span, fault))
            }
            other => Err(Fault::new(
                code::WRONG_TYPE,
                span.clone(),
                format!("`{key}` is {}, but this is {}", kind.what, type_name(other)),
                "",
                kind.advice(key, self.plain),
            )),
        };
        match written {
            Ok(Written { value, has_unit, marks }) => {
                // A dimensionless number has no unit, whether or not the file has units.
                if kind.dimension != Dimension::NONE {
                    let key = key.to_owned();
                    let is_bare_zero = value == 0.0 && !has_unit;
                    let span = span.clone();
                    self.quantities.push(Seen {
                        key,
                        kind,
                        has_unit,
                        is_bare_zero,
                        value,
                        marks,
                        span,
                    });
                }
                Field::new(value, span)
            }
            Err(fault) => {
                self.report(fault);
                Field::unreadable(span)
            }
        }
    }

    pub fn wrong_type(&mut self, value: &Spanned<DeValue>, message: String, hint: String) {
        let label = format!("this is {}", type_name(value.get_ref()));
        self.report(Fault::new(code::WRONG_TYPE, value.span(), message, label, hint));
    }

    /// Moves a fault within a TOML string to its location in the file. If the string has escapes, the fault
    /// marks the whole string.
    fn inside_string(&self, text: &str, span: &Range<usize>, fault: Fault) -> Fault {
        let raw = &self.source.text[span.clone()];
        match raw.find(text) {
            Some(offset) if !text.trim().is_empty() => fault.moved(span.start + offset),
            _ => over(span, fault),
        }
    }
}

/// Extends the range that a fault marks to the whole value at `span`.
fn over(span: &Range<usize>, fault: Fault) -> Fault {
    Fault { at: span.clone(), ..fault }
}

fn bare_integer(integer: &DeInteger, kind: &Kind) -> Result<Written, Fault> {
    if integer.radix() == 10 {
        return kind.read("", integer.as_str(), true);
    }
    match i128::from_str_radix(integer.as_str(), integer.radix()) {
        Ok(value) => Ok(Written { value: value as f64, has_unit: false, marks: Marks::NONE }),
        Err(_) => Err(quantity::out_of_reach(f64::INFINITY, 0..0)),
    }
}

/// Returns the name of the type of a TOML value, such as "a number".
fn type_name(value: &DeValue) -> &'static str {
    match value {
        DeValue::String(_) => "text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date or time",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}
