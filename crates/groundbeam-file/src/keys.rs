//! The tables that a file may have, and their keys. Reading, suggestions, the documents and the JSON Schema take all
//! of this from the one list that each section declares.

use crate::quantity::{Kind, RATIO};
use crate::suggest::nearest;

/// A table of a file.
pub(crate) struct Table {
    /// As a file writes it and messages name it: `[beam]`, `[[load]]`.
    pub name: &'static str,
    /// In the order in which messages list them.
    pub keys: &'static [Key],
}

/// A key of a table.
#[derive(Clone, Copy)]
pub(crate) struct Key {
    pub name: &'static str,
    pub value: Value,
    /// Its meaning, for the documents and for editors.
    pub meaning: &'static str,
    /// Whether every such table must have it.
    pub needed: bool,
    /// Other names for the same thing: the library's words, other programs' words, other letters.
    pub also: &'static [&'static str],
    /// Names of a similar quantity, in small letters, and how it becomes this one.
    pub unlike: Option<(&'static [&'static str], &'static str)>,
}

/// The values that may stand under a key.
#[derive(Clone, Copy)]
pub(crate) enum Value {
    Quantity(&'static Kind),
    /// A quantity whose kind follows from another key of the table.
    Depends,
    /// One quantity, or a list of two to so many along the beam.
    Along(&'static Kind, usize),
    /// A whole number between two others.
    Count([u64; 2]),
    /// `true` or `false`.
    Flag,
    /// Any text; one for an example.
    Text(&'static str),
    /// The name of an entry of a built-in list; one for an example, and all of them.
    Name(&'static str, fn() -> Vec<&'static str>),
    /// One of a few words.
    Word(&'static Words),
    /// One of a few words, or a list of them.
    OneOrMore(&'static Words),
    /// A list of so many values.
    List(&'static Value, [usize; 2]),
    /// A list of any names, each with a number: `{ G = 1.35, Q = 1.5 }`.
    Factors,
    Table(&'static Table),
    /// Any number of tables.
    Tables(&'static Table),
}

/// Words of which one may stand under a key.
pub(crate) struct Words {
    pub all: fn() -> Vec<&'static str>,
    /// Other words that people write for each of them.
    pub also: &'static [(&'static str, &'static [&'static str])],
    /// The message about another word, which stands for `{}`.
    pub message: &'static str,
    /// The advice where no word is near; all words stand for `{}`.
    pub hint: &'static str,
}

/// The hint of words that explain themselves.
pub(crate) const WHAT_CAN_STAND_HERE: &str = "what can stand here: {}";

/// Other names of the keys that many tables have.
pub(crate) const ALSO_AT: &[&str] = &["x", "position", "location", "station"];
pub(crate) const ALSO_FROM: &[&str] = &["start", "begin", "x1"];
pub(crate) const ALSO_TO: &[&str] = &["end", "x2"];
pub(crate) const ALSO_WIDTH: &[&str] = &["b", "breadth"];
pub(crate) const ALSO_E: &[&str] = &["elastic_modulus", "youngs_modulus", "young", "modulus"];
pub(crate) const ALSO_NU: &[&str] = &["poisson", "poissons_ratio", "ν"];

/// A key that may be left out, unless [`Key::needed`] follows.
pub(crate) const fn key(name: &'static str, value: Value, meaning: &'static str) -> Key {
    Key { name, value, meaning, needed: false, also: &[], unlike: None }
}

pub(crate) const fn quantity(
    name: &'static str,
    kind: &'static Kind,
    meaning: &'static str,
) -> Key {
    key(name, Value::Quantity(kind), meaning)
}

pub(crate) const fn along(
    name: &'static str,
    kind: &'static Kind,
    most: usize,
    meaning: &'static str,
) -> Key {
    key(name, Value::Along(kind, most), meaning)
}

pub(crate) const fn text(name: &'static str, example: &'static str, meaning: &'static str) -> Key {
    key(name, Value::Text(example), meaning)
}

pub(crate) const fn word(name: &'static str, words: &'static Words, meaning: &'static str) -> Key {
    key(name, Value::Word(words), meaning)
}

pub(crate) const fn words(name: &'static str, words: &'static Words, meaning: &'static str) -> Key {
    key(name, Value::OneOrMore(words), meaning)
}

pub(crate) const fn table(name: &'static str, keys: &'static Table, meaning: &'static str) -> Key {
    key(name, Value::Table(keys), meaning)
}

pub(crate) const fn tables(name: &'static str, keys: &'static Table, meaning: &'static str) -> Key {
    key(name, Value::Tables(keys), meaning)
}

/// For a name that no table lists.
static UNLISTED: Key = key("", Value::Depends, "");

impl Key {
    pub const fn needed(self) -> Key {
        Key { needed: true, ..self }
    }

    pub const fn also(self, also: &'static [&'static str]) -> Key {
        Key { also, ..self }
    }

    /// The same, with names of a similar quantity and how it becomes this one.
    pub const fn unlike(self, names: &'static [&'static str], how: &'static str) -> Key {
        Key { unlike: Some((names, how)), ..self }
    }

    /// The quantity that the key wants; a plain number where it wants none.
    pub fn kind(&self) -> &'static Kind {
        match self.value {
            Value::Quantity(kind) | Value::Along(kind, _) => kind,
            Value::List(Value::Quantity(kind), _) => kind,
            _ => &RATIO,
        }
    }

    /// A line of a file that gives the key a right value; `plain`: in a file without units.
    pub fn line(&self, plain: bool) -> String {
        let text = |text: &str| format!("{} = \"{text}\"", self.name);
        match self.value {
            Value::Text(example) | Value::Name(example, _) => text(example),
            Value::Word(words) | Value::OneOrMore(words) => text((words.all)()[0]),
            _ => self.kind().line(self.name, plain),
        }
    }
}

impl Table {
    /// The row of a key. The sections ask for keys of their own tables alone.
    pub fn key(&self, name: &str) -> &'static Key {
        let found = self.keys.iter().find(|key| key.name == name);
        debug_assert!(found.is_some(), "{} has no key `{name}`", self.name);
        found.unwrap_or(&UNLISTED)
    }

    /// The names of all keys.
    pub fn names(&self) -> Vec<&'static str> {
        self.keys.iter().map(|key| key.name).collect()
    }

    /// Whether a table of this name, in this table or in one below it, may be given several times.
    pub fn may_be_several(&self, name: &str) -> bool {
        self.keys.iter().any(|key| match key.value {
            Value::Tables(table) => key.name == name || table.may_be_several(name),
            Value::Table(table) => table.may_be_several(name),
            _ => false,
        })
    }
}

/// The key that wants a quantity like the one with this name, and how the one becomes the other.
pub(crate) fn becomes(written: &str, keys: &[&Key]) -> Option<(&'static str, &'static str)> {
    let lower = written.to_lowercase();
    let of_key = |key: &&Key| {
        let (names, how) = key.unlike?;
        names.contains(&lower.as_str()).then_some((key.name, how))
    };
    keys.iter().find_map(of_key)
}

/// The key that someone who writes `written` probably means.
pub(crate) fn meant(written: &str, keys: &[&Key]) -> Option<&'static str> {
    let lower = written.to_lowercase();
    let other = || keys.iter().find(|key| key.also.contains(&lower.as_str()));
    let near = nearest(written, keys.iter().map(|key| key.name));
    near.or_else(|| other().map(|key| key.name))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::MODEL;
    use crate::study::STUDY;

    fn check(table: &Table) {
        for (i, key) in table.keys.iter().enumerate() {
            let place = format!("`{}` of {}", key.name, table.name);
            assert!(table.keys[..i].iter().all(|other| other.name != key.name), "{place}");
            assert!(key.meaning.ends_with('.'), "{place} has a meaning");
            let is_name = |also: &&&str| table.keys.iter().any(|key| key.name == **also);
            assert_eq!(
                key.also.iter().find(is_name),
                None,
                "{place}: another name is a key itself"
            );
            match key.value {
                Value::Table(below) | Value::Tables(below) => check(below),
                Value::Name(example, all) => assert!(all().contains(&example), "{place}"),
                Value::Word(words) | Value::OneOrMore(words) => {
                    let known = (words.all)();
                    assert!(words.also.iter().all(|(word, _)| known.contains(word)), "{place}");
                    assert!(words.message.contains("{}"), "{place}");
                }
                _ => {}
            }
        }
    }

    #[test]
    fn every_row_is_consistent() {
        check(&MODEL);
        check(&STUDY);
    }

    #[test]
    fn slips_and_other_names_lead_to_the_key() {
        let [length, stiffness, load, shear] = [
            key("length", Value::Flag, ""),
            key("EI", Value::Flag, "").also(&["bending_stiffness"]),
            key("load", Value::Flag, ""),
            key("mu", Value::Flag, "").also(&["shear"]),
        ];
        let meant = |written| super::meant(written, &[&length, &stiffness, &load, &shear]);
        assert_eq!(meant("lenght"), Some("length"));
        assert_eq!(meant("ei"), Some("EI"));
        assert_eq!(meant("bending_stiffness"), Some("EI"));
        assert_eq!(meant("shear"), Some("mu"));
        assert_eq!(meant("loads"), Some("load"));
        assert_eq!(meant("colour"), None);
    }
}
