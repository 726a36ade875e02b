//! Explains TOML syntax errors to readers who do not know TOML.

use crate::code;
use crate::diagnostic::Diagnostic;
use crate::fault::Fault;
use crate::keys::Table;
use crate::source::Source;
use std::ops::Range;
use toml::de::{DeTable, DeValue, Error};

/// Syntax faults of a file.
pub(crate) struct SyntaxFaults {
    pub found: Vec<Diagnostic>,
    /// Whether the rest of the file can be read in spite of the faults. Missing quotes and repeated keys do not
    /// prevent this.
    pub readable: bool,
}

/// Explains TOML syntax errors, at most one per line, because further errors on a line usually follow from the
/// first one. `keys` lists the allowed keys of the file.
pub(crate) fn explain(
    source: &Source,
    table: &DeTable,
    errors: &[Error],
    keys: &Table,
) -> SyntaxFaults {
    let mut found: Vec<Diagnostic> = Vec::new();
    let mut readable = true;
    let mut errors: Vec<_> = errors.iter().map(|e| (e.span().unwrap_or(0..0), e)).collect();
    errors.sort_by_key(|(span, _)| span.start);
    for (span, error) in errors {
        let (fault, harmless) = fault(source, span.clone(), error.message(), keys);
        readable &= harmless;
        let mut diagnostic = Diagnostic::new(source, fault);
        if diagnostic.code == code::DUPLICATE
            && let Some(first) = first_of(table, &source.text[diagnostic.span.clone()], span.start)
        {
            diagnostic = diagnostic.with_related(source, first, "given first here");
        }
        if found.last().is_none_or(|last| last.line != diagnostic.line) {
            found.push(diagnostic);
        }
    }
    SyntaxFaults { found, readable }
}

/// Returns the fault that explains a syntax error, and whether the rest of the file can still be read.
fn fault(source: &Source, span: Range<usize>, said: &str, keys: &Table) -> (Fault, bool) {
    let written = source.text.get(span.clone()).unwrap_or("");
    let start_of_line =
        source.text[..span.start.min(source.text.len())].rfind('\n').map_or(0, |i| i + 1);
    let line_so_far = source.text.get(start_of_line..span.start).unwrap_or("");
    let new = |message: &str, label: &str, hint: String| {
        Fault::new(code::SYNTAX, span.clone(), message, label, hint)
    };
    if said.starts_with("duplicate key") {
        let is_list = keys.may_be_several(written);
        let in_header = line_so_far.trim_start().starts_with('[');
        let hint = if is_list && in_header {
            "several tables of this kind are allowed; write each heading with double brackets, as in [[load]]"
        } else if in_header {
            "put the keys of both tables under one heading"
        } else {
            "keep one of the two"
        };
        let message = format!("`{written}` is given twice");
        let fault = Fault::new(code::DUPLICATE, span, message, "given again here", hint);
        return (fault, !is_list);
    }
    if said.starts_with("string values must be quoted") {
        return if written.trim().is_empty() {
            let hint = "write key = value, as in length = \"12 m\"".to_owned();
            (new("a value is missing here", "", hint), false)
        } else if let Some(inner) = between_typographic_quotes(written) {
            let message = "typographic quotes cannot enclose text";
            let hint = format!("write straight quotes: \"{inner}\"");
            (new(message, "quotes of a word processor", hint), true)
        } else {
            let hint = format!("write \"{written}\"");
            let message = "write text, and numbers with a unit, in quotes";
            (new(message, "no quotes", hint), true)
        };
    }
    if said.contains("expected `inf`") || said.contains("expected `nan`") {
        // The parser expects a number if a word without quotes begins like `inf` or `nan`.
        let hint = "write the value in quotes, as in \"pinned\" or \"1.5 kN\"".to_owned();
        return (new("write text, and numbers with a unit, in quotes", "no quotes", hint), false);
    }
    let advice = if said.starts_with("invalid float") || said.starts_with("invalid integer") {
        "write a number with its unit in quotes, as in \"1.5 kN\""
    } else if said.starts_with("unexpected key or value") {
        "write one key = value on each line; a number must not contain a comma: write 1200 or 3.5"
    } else if said.starts_with("invalid mantissa") || said.starts_with("invalid fraction") {
        "a number has digits on both sides of its point, as in 0.5 or 5.0"
    } else if said.starts_with("unexpected leading zero") {
        "a number must not begin with a zero, unless a point follows"
    } else if said.starts_with("unclosed array table") {
        "a heading of this kind is written [[load]]"
    } else if said.starts_with("unclosed table") {
        "a heading is written [beam]"
    } else if said.starts_with("key with no value") {
        "write key = value, as in length = \"12 m\""
    } else if said.starts_with("invalid basic string") || said.starts_with("invalid literal string")
    {
        "text must end with the same quote it begins with, on the same line"
    } else if said.starts_with("cannot recurse") || said.starts_with("recursion limit") {
        "the values are nested too deeply"
    } else {
        ""
    };
    (new(&format!("this is not valid TOML: {said}"), "", advice.to_owned()), false)
}

/// Returns the text between typographic quotes.
fn between_typographic_quotes(written: &str) -> Option<&str> {
    const QUOTES: [char; 8] = ['“', '”', '„', '‘', '’', '‚', '«', '»'];
    written.trim().strip_prefix(QUOTES)?.strip_suffix(QUOTES).map(str::trim)
}

/// Returns the location of the nearest key `name` before the byte position `offset`. It is the first of two equal keys.
fn first_of(table: &DeTable, name: &str, offset: usize) -> Option<Range<usize>> {
    let mut nearest: Option<Range<usize>> = None;
    let mut waiting = vec![table];
    while let Some(table) = waiting.pop() {
        for (key, value) in table.iter() {
            let span = key.span();
            let is_nearer = nearest.as_ref().is_none_or(|n| n.start < span.start);
            if key.get_ref() == name && span.start < offset && is_nearer {
                nearest = Some(span);
            }
            match value.get_ref() {
                DeValue::Table(inner) => waiting.push(inner),
                DeValue::Array(array) => {
                    waiting.extend(array.iter().filter_map(|v| v.as_ref().as_table()))
                }
                _ => {}
            }
        }
    }
    nearest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keys::Value;
    use crate::section::MODEL;
    use crate::study::STUDY;

    /// Returns the names of the tables that may occur several times, in this table and in the tables inside it.
    fn several(table: &Table) -> Vec<&'static str> {
        let of = |value| match value {
            Value::Table(table) => several(table),
            Value::Tables(table) => several(table),
            _ => Vec::new(),
        };
        let own = table.keys.iter().filter(|key| matches!(key.value, Value::Tables(_)));
        let below = table.keys.iter().flat_map(|key| of(key.value));
        own.map(|key| key.name).chain(below).collect()
    }

    /// Each repeated table gets the hint to use double brackets.
    #[test]
    fn a_repeated_table_gets_the_hint_for_double_brackets() {
        for (keys, count) in [(&MODEL, 14), (&STUDY, 3)] {
            let all = several(keys);
            assert_eq!(all.len(), count, "{all:?}");
            for name in all {
                for heading in [format!("[{name}]"), format!("[beam.{name}]")] {
                    let text = format!("{heading}\nat = \"1 m\"\n{heading}\nat = \"2 m\"\n");
                    let source = Source::new(&text);
                    let (table, errors) = DeTable::parse_recoverable(&text);
                    let found = explain(&source, table.get_ref(), &errors, keys).found;
                    let twice = found.iter().find(|fault| fault.code == code::DUPLICATE).unwrap();
                    assert!(twice.hint.contains("double brackets"), "{heading}: {}", twice.hint);
                }
            }
        }
        assert!(!MODEL.may_be_several("beam"));
    }
}
