//! Reads tables and values of a TOML document and remembers where everything stands.
//!
//! Nothing stops at the first fault. A value that cannot be read is NaN from then on, which no
//! value in a file can be; whatever depends on it is then NaN too and is not reported again.

use crate::beside::{Beside, OtherFile};
use crate::code;
use crate::diagnostic::Diagnostic;
use crate::document::Places;
use crate::fault::Fault;
use crate::lists::List;
use crate::quantity::{self, Kind, Written};
use crate::source::Source;
use crate::table::{Section, suggestion};
use crate::unit::Dimension;
use crate::units::Seen;
use std::ops::Range;
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeInteger, DeValue};

/// A value and its place.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Field {
    /// NaN if it could not be read, which has been reported then.
    pub value: f64,
    pub span: Range<usize>,
}

impl Field {
    pub fn new(value: f64, span: Range<usize>) -> Self {
        Field { value, span }
    }

    /// Stands for a value that is missing or cannot be read.
    pub fn unreadable(span: Range<usize>) -> Self {
        Field { value: f64::NAN, span }
    }
}

pub(crate) struct Reader<'s> {
    pub source: &'s Source,
    /// Where files that the model names stand; none if it can name none.
    pub beside: Option<Beside<'s>>,
    /// Those that were read.
    pub others: Vec<Arc<OtherFile>>,
    pub found: Vec<Diagnostic>,
    pub quantities: Vec<Seen>,
    pub places: Places,
    /// Whether numbers without a unit are in SI units and may stand beside others.
    pub bare_is_si: bool,
    /// Whether the file seems to give no units, so that advice fits it.
    plain: bool,
    /// Keys that unknown ones are probably meant to be, each with the start of its table.
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

    pub fn report(&mut self, fault: Fault) {
        self.found.push(Diagnostic::new(self.source, fault));
    }

    /// Reports what is wrong in another file.
    pub fn report_in(&mut self, source: &Source, file: &Arc<OtherFile>, fault: Fault) {
        let file = Some(Arc::clone(file));
        self.found.push(Diagnostic { file, ..Diagnostic::new(source, fault) });
    }

    /// Whether the file seems to give no units.
    pub fn is_plain(&self) -> bool {
        self.plain
    }

    pub fn report_with(&mut self, fault: Fault, related: Range<usize>, label: &str) {
        let diagnostic = Diagnostic::new(self.source, fault);
        self.found.push(diagnostic.with_related(self.source, related, label));
    }

    /// Reports that none of `keys` is given in `section`, unless one of them is misspelt there.
    /// `example` would be right.
    pub fn missing(&mut self, section: &Section, keys: &[&str], what: &str, example: &str) {
        let is_misspelt = |key: &&str| {
            self.meant.iter().any(|(table, meant)| *table == section.span.start && meant == key)
        };
        if keys.iter().any(is_misspelt) {
            return;
        }
        let message = format!("{} has no {what}", section.name);
        let hint = format!("add {example}");
        self.report(Fault::new(code::MISSING, section.span.clone(), message, "", hint));
    }

    /// Reports two keys that must not stand together, at the one that comes later.
    pub fn exclusive(&mut self, a: (&str, &Range<usize>), b: (&str, &Range<usize>), hint: &str) {
        let (first, later) = if a.1.start <= b.1.start { (a, b) } else { (b, a) };
        let message = format!("`{}` and `{}` exclude each other", first.0, later.0);
        let fault = Fault::new(code::EXCLUSIVE, later.1.clone(), message, "", hint);
        self.report_with(fault, first.1.clone(), "given here");
    }

    /// Reports every key of `section` that is not among `keys`.
    pub fn refuse_unknown(&mut self, section: &Section, keys: &[&str]) {
        for (key, _) in section.table.iter().filter(|(key, _)| !keys.contains(&&**key.get_ref())) {
            let written = key.get_ref();
            let message = format!("`{written}` means nothing in {}", section.name);
            let hint = match suggestion(written, keys) {
                Some(meant) => {
                    self.meant.push((section.span.start, meant.to_owned()));
                    format!("did you mean `{meant}`?")
                }
                None => format!("what can stand here: {}", keys.join(", ")),
            };
            self.report(Fault::new(code::UNKNOWN_KEY, key.span(), message, "", hint));
        }
    }

    /// The table `[key]`, if given.
    pub fn table<'a>(
        &mut self,
        parent: &Section<'a>,
        key: &str,
        name: &'static str,
    ) -> Option<Section<'a>> {
        let value = parent.value(key)?;
        match value.get_ref() {
            DeValue::Table(table) => Some(Section { table, span: value.span(), name }),
            DeValue::Array(_) => {
                let message = format!("there is only one {name} in a file");
                self.wrong_type(value, message, format!("write {name} with single brackets"));
                None
            }
            _ => {
                let message = format!("`{key}` is a table, not a value");
                self.wrong_type(value, message, format!("write {name} and its keys below it"));
                None
            }
        }
    }

    /// The tables of a list, none if there are none.
    pub fn tables<'a>(&mut self, parent: &Section<'a>, list: &List) -> Vec<Section<'a>> {
        let List { key, name } = *list;
        let Some(value) = parent.value(key) else { return vec![] };
        let DeValue::Array(array) = value.get_ref() else {
            let message = format!("there can be several {name}, so it is written as a list");
            self.wrong_type(value, message, format!("write {name} with double brackets"));
            return vec![];
        };
        let mut sections = Vec::new();
        for element in array.iter() {
            match element.get_ref() {
                DeValue::Table(table) => {
                    sections.push(Section { table, span: element.span(), name });
                }
                _ => {
                    let message = format!("each of `{key}` is a table, not a value");
                    self.wrong_type(
                        element,
                        message,
                        format!("write {name} and its keys below it"),
                    );
                }
            }
        }
        sections
    }

    /// The words in `section` under `key`, if given.
    pub fn words<'a>(
        &mut self,
        section: &Section<'a>,
        key: &str,
        example: &str,
    ) -> Option<(&'a str, Range<usize>)> {
        let value = section.value(key)?;
        match value.get_ref() {
            DeValue::String(words) => Some((words, value.span())),
            _ => {
                let hint = format!("write it in quotes, as in {key} = \"{example}\"");
                self.wrong_type(value, format!("`{key}` must be text"), hint);
                None
            }
        }
    }

    /// The quantity in `section` under `key`, if given.
    pub fn quantity(&mut self, section: &Section, key: &str, kind: &'static Kind) -> Option<Field> {
        section.value(key).map(|value| self.field(key, value, kind))
    }

    /// The quantity in `section` under `key`, which must be given.
    pub fn required(&mut self, section: &Section, key: &str, kind: &'static Kind) -> Field {
        self.quantity(section, key, kind).unwrap_or_else(|| {
            let example = self.line(key, kind);
            self.missing(section, &[key], &format!("`{key}`"), &example);
            Field::unreadable(section.span.clone())
        })
    }

    /// A line that would be right in this file.
    pub fn line(&self, key: &str, kind: &Kind) -> String {
        kind.line(key, self.plain)
    }

    /// A list of two values that would be right in this file.
    pub fn pair(&self, kind: &Kind) -> String {
        kind.pair(self.plain)
    }

    /// One quantity, wherever it stands.
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
            Ok(Written { value, has_unit }) => {
                // A plain number has no unit in either kind of file.
                if kind.dimension != Dimension::NONE {
                    let key = key.to_owned();
                    let is_bare_zero = value == 0.0 && !has_unit;
                    let span = span.clone();
                    self.quantities.push(Seen { key, kind, has_unit, is_bare_zero, span });
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

    /// A fault within the text of a TOML string, at its place in the file. Where the string is
    /// written with escapes, characters have moved, and the whole string is marked.
    fn inside_string(&self, text: &str, span: &Range<usize>, fault: Fault) -> Fault {
        let raw = &self.source.text[span.clone()];
        match raw.find(text) {
            Some(offset) if !text.trim().is_empty() => fault.moved(span.start + offset),
            _ => over(span, fault),
        }
    }
}

/// A fault that marks a whole value.
fn over(span: &Range<usize>, fault: Fault) -> Fault {
    Fault { at: span.clone(), ..fault }
}

fn bare_integer(integer: &DeInteger, kind: &Kind) -> Result<Written, Fault> {
    if integer.radix() == 10 {
        return kind.read("", integer.as_str(), true);
    }
    match i128::from_str_radix(integer.as_str(), integer.radix()) {
        Ok(value) => Ok(Written { value: value as f64, has_unit: false }),
        Err(_) => Err(quantity::out_of_reach(f64::INFINITY, 0..0)),
    }
}

/// What a TOML value is, with an article.
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
