//! Random changes to a model file that keep most of it: other numbers, units, words, keys, lists, lines and
//! tables.

use proptest::prelude::*;
use proptest::sample::Index;
use std::ops::Range;

const NUMBERS: &[&str] = &[
    "0",
    "-0.0",
    "1",
    "-1",
    "0.1",
    "1e-60",
    "1e60",
    "1e-61",
    "-1e60",
    "1e308",
    "-1e308",
    "5e-324",
    "2.2250738585072014e-308",
    "1.7976931348623157e308",
    "1e-200",
    "1e200",
    "1e16",
    "1e-16",
    "1e30",
    "1e-30",
    "9007199254740993",
    "0.1000000000000000055511151231257827",
    "1e999",
    "1e-999",
    "nan",
    "-inf",
    "0x1F",
    "1_000",
    "0.3333333333333333",
    "3",
    "4.9e-324",
    "1e154",
    "1e-154",
    "1e100",
];
const UNITS: &[&str] = &[
    "m", "mm", "km", "in", "ft", "N", "kN", "GN", "kip", "N/m", "kN/m", "N/mm", "kN/m^2", "GPa",
    "psi", "kN/m^3", "MN/m³", "kN m^2", "N m", "kN m/rad", "1/m", "K", "degF", "1/K", "rad", "deg",
    "mrad/m", "", "m^4", "cm4", "%", "t", "tf",
];
/// Texts with their quotes.
const STRINGS: &[&str] = &[
    "\"\"",
    "\" \"",
    "\"G\"",
    "\"Q\"",
    "'a\"b'",
    "\"a\\\"b\"",
    "\"\\u001b[31m\"",
    "\"\\n\"",
    "\"\\u0000\"",
    "\"\\u0085\"",
    "\"\\u202e\"",
    "\"梁\"",
    "\"e\u{301}\"",
    "\"a\\\\\"",
    "'\\'",
    "\"\u{feff}\"",
    "\"pinned\"",
    "\"fixed\"",
    "\"free\"",
    "\"held\"",
    "\"up\"",
    "\"down\"",
    "\"\"\"a\nb\"\"\"",
    "\"C30/37\"",
    "\"material\"",
    "\"{0}\"",
    "\"{}\"",
    "\"\\U0001F600\"",
    "\"\\uFFFF\"",
    "\"\u{2028}\"",
];
const KEYS: &[&str] = &[
    "k",
    "mu",
    "EI",
    "E",
    "I",
    "G",
    "length",
    "at",
    "from",
    "to",
    "point",
    "moment",
    "distributed",
    "distributed_moment",
    "curvature",
    "temperature_difference",
    "shrinkage_difference",
    "expansion",
    "depth",
    "camber",
    "unit_weight",
    "section",
    "width",
    "height",
    "shear_stiffness",
    "shear_area",
    "nu",
    "axial_force",
    "subgrade_modulus",
    "C1",
    "C2",
    "left",
    "right",
    "ends",
    "as",
    "spring",
    "rotational_spring",
    "settlement",
    "acts",
    "type",
    "value",
    "case",
    "factor",
    "factors",
    "name",
    "band",
    "soil",
    "segment",
    "layer",
    "title",
    "weight_case",
    "set",
    "group",
    "action",
    "0",
    "\"\"",
    "\"a b\"",
];

/// A change and its position.
#[derive(Debug, Clone)]
pub enum Edit {
    /// Replaces a number and keeps its unit.
    Number(Index, usize),
    /// Replaces the unit of a number.
    Unit(Index, usize),
    /// Replaces a text.
    Text(Index, usize),
    /// Replaces a key or heading.
    Key(Index, usize),
    /// Replaces a value by a list of the value and repeated numbers.
    List(Index, usize, usize),
    /// Removes a token.
    Remove(Index),
    /// Replaces a token by another.
    Copy(Index, Index),
    /// Swaps two tokens.
    Swap(Index, Index),
    /// Repeats a line before another one.
    Line(Index, Index),
    /// Repeats a table at the end.
    Table(Index),
    /// Replaces characters.
    Characters(Index, usize, String),
}

pub fn edit() -> impl Strategy<Value = Edit> {
    let place = any::<Index>;
    prop_oneof![
        8 => (place(), 0..NUMBERS.len()).prop_map(|(i, n)| Edit::Number(i, n)),
        2 => (place(), 0..UNITS.len()).prop_map(|(i, n)| Edit::Unit(i, n)),
        2 => (place(), 0..STRINGS.len()).prop_map(|(i, n)| Edit::Text(i, n)),
        2 => (place(), 0..KEYS.len()).prop_map(|(i, n)| Edit::Key(i, n)),
        3 => (place(), 0..NUMBERS.len(), 0..9_usize).prop_map(|(i, n, m)| Edit::List(i, n, m)),
        1 => place().prop_map(Edit::Remove),
        2 => (place(), place()).prop_map(|(i, j)| Edit::Copy(i, j)),
        2 => (place(), place()).prop_map(|(i, j)| Edit::Swap(i, j)),
        2 => (place(), place()).prop_map(|(i, j)| Edit::Line(i, j)),
        2 => place().prop_map(Edit::Table),
        1 => (place(), 0..6_usize, any::<String>()).prop_map(|(i, n, s)| Edit::Characters(i, n, s)),
    ]
}

impl Edit {
    pub fn apply(&self, text: &str) -> String {
        let tokens = tokens(text);
        let of = |kind: Kind, i: &Index| {
            let all: Vec<&Token> = tokens.iter().filter(|token| token.kind == kind).collect();
            (!all.is_empty()).then(|| all[i.index(all.len())].span.clone())
        };
        let changed = match self {
            Edit::Number(i, n) => of(Kind::Number, i).map(|at| {
                let (start, end) = number(&text[at.clone()]);
                replaced(text, at.start + start..at.start + end, NUMBERS[*n])
            }),
            Edit::Unit(i, n) => of(Kind::Number, i).map(|at| {
                let (start, end) = number(&text[at.clone()]);
                let number = &text[at.start + start..at.start + end];
                replaced(text, at, &format!("\"{number} {}\"", UNITS[*n]))
            }),
            Edit::Text(i, n) => of(Kind::Text, i).map(|at| replaced(text, at, STRINGS[*n])),
            Edit::Key(i, n) => of(Kind::Word, i).map(|at| replaced(text, at, KEYS[*n])),
            Edit::List(i, n, most) => of(Kind::Number, i).map(|at| {
                let own = &text[at.clone()];
                let (start, end) = number(own);
                let other = format!("{}{}{}", &own[..start], NUMBERS[*n], &own[end..]);
                let list = format!("{own}, {}", format!("{other}, ").repeat(*most));
                replaced(text, at, &format!("[{list}]"))
            }),
            Edit::Remove(i) => any_of(&tokens, i).map(|at| replaced(text, at, "")),
            Edit::Copy(i, j) => any_of(&tokens, i)
                .zip(any_of(&tokens, j))
                .map(|(at, other)| replaced(text, at, &text[other])),
            Edit::Swap(i, j) => any_of(&tokens, i).zip(any_of(&tokens, j)).map(|(a, b)| {
                let (first, second) = if a.start <= b.start { (a, b) } else { (b, a) };
                let later = replaced(text, second.clone(), &text[first.clone()]);
                replaced(&later, first, &text[second])
            }),
            Edit::Line(i, j) => {
                let lines: Vec<&str> = text.split_inclusive('\n').collect();
                (!lines.is_empty()).then(|| {
                    let (line, before) = (lines[i.index(lines.len())], j.index(lines.len()));
                    let (head, tail) = lines.split_at(before);
                    [&head.concat(), line, &tail.concat()].concat()
                })
            }
            Edit::Table(i) => {
                let tables: Vec<&str> = text.split("\n[").skip(1).collect();
                (!tables.is_empty())
                    .then(|| format!("{text}\n[{}\n", tables[i.index(tables.len())]))
            }
            Edit::Characters(i, length, other) => {
                let starts: Vec<usize> = text.char_indices().map(|(i, _)| i).collect();
                (!starts.is_empty()).then(|| {
                    let start = i.index(starts.len());
                    let end = starts.get(start + length).copied().unwrap_or(text.len());
                    replaced(text, starts[start]..end, other)
                })
            }
        };
        changed.unwrap_or_else(|| text.to_owned())
    }
}

fn replaced(text: &str, at: Range<usize>, by: &str) -> String {
    [&text[..at.start], by, &text[at.end..]].concat()
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// A number, bare or in quotes with its unit.
    Number,
    /// Any other text in quotes.
    Text,
    /// A key, a part of a heading, true or false.
    Word,
    Sign,
}

struct Token {
    kind: Kind,
    span: Range<usize>,
}

/// Tokens of a text, without spaces and comments.
fn tokens(text: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let start = text.len() - rest.len();
        let is_part = |c: char| c.is_alphanumeric() || "_-+.".contains(c);
        let length = match c {
            '#' => rest.find('\n').unwrap_or(rest.len()),
            '"' | '\'' => rest[1..].find([c, '\n']).map_or(rest.len(), |end| end + 2),
            c if is_part(c) => rest.find(|c| !is_part(c)).unwrap_or(rest.len()),
            c => c.len_utf8(),
        };
        let written = &rest[..length];
        let is_number = |text: &str| {
            text.trim_start_matches(['-', '+']).starts_with(|c: char| c.is_ascii_digit())
        };
        let kind = match c {
            '#' => None,
            '"' | '\'' if is_number(&written[1..]) => Some(Kind::Number),
            '"' | '\'' => Some(Kind::Text),
            c if is_part(c) && is_number(written) => Some(Kind::Number),
            c if is_part(c) => Some(Kind::Word),
            c if c.is_whitespace() => None,
            _ => Some(Kind::Sign),
        };
        tokens.extend(kind.map(|kind| Token { kind, span: start..start + length }));
        rest = &rest[length..];
    }
    tokens
}

fn any_of(tokens: &[Token], i: &Index) -> Option<Range<usize>> {
    (!tokens.is_empty()).then(|| tokens[i.index(tokens.len())].span.clone())
}

/// Byte range of the number in a token of kind number.
fn number(token: &str) -> (usize, usize) {
    let start = token.len() - token.trim_start_matches(['"', '\'']).len();
    let is_part = |c: char| c.is_ascii_digit() || "+-.eE_".contains(c);
    let end = token[start..].find(|c| !is_part(c)).map_or(token.len(), |end| start + end);
    (start, end)
}
