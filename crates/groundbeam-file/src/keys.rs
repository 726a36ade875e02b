//! Describes the tables of a file and their keys, for the reader, the suggestions, the documentation and the JSON Schema.

use crate::quantity::{Kind, RATIO};
use crate::suggest::nearest;

/// A table of a file.
pub(crate) struct Table {
    /// Name of the table in files and messages, such as `[beam]` or `[[load]]`.
    pub name: &'static str,
    /// Keys of the table, in the order in which messages list the keys.
    pub keys: &'static [Key],
}

/// A key of a table.
#[derive(Clone, Copy)]
pub(crate) struct Key {
    pub name: &'static str,
    pub value: Value,
    /// Meaning of the key, for the documentation and for editors.
    pub meaning: &'static str,
    /// Whether the key is required.
    pub needed: bool,
    /// Alternative names of the key: its names in the library or in other programs, and other spellings.
    pub also: &'static [&'static str],
    /// Lower-case names of another quantity from which the value of this key can be computed, and a text that explains
    /// this computation.
    pub unlike: Option<(&'static [&'static str], &'static str)>,
}

/// Kinds of value that a key may have.
#[derive(Clone, Copy)]
pub(crate) enum Value {
    Quantity(&'static Kind),
    /// A quantity whose kind depends on another key of the table.
    Depends,
    /// One quantity, or a list of at least two quantities along the beam. The number is the maximum length of the
    /// list.
    Along(&'static Kind, usize),
    /// Integer in this range.
    Count([u64; 2]),
    /// `true` or `false`.
    Flag,
    /// Any text. The string is an example of the text.
    Text(&'static str),
    /// Name of an entry of a built-in list. The string is an example of a name, and the function returns all names.
    Name(&'static str, fn() -> Vec<&'static str>),
    /// One of several words.
    Word(&'static Words),
    /// One of several words, or a list of such words.
    OneOrMore(&'static Words),
    /// List of values. The two numbers are the minimum and the maximum length of the list.
    List(&'static Value, [usize; 2]),
    /// Table that assigns a number to each of several names, such as `{ G = 1.35, Q = 1.5 }`.
    Factors,
    Table(&'static Table),
    /// Any number of tables.
    Tables(&'static Table),
}

/// Words that a key allows as its value.
pub(crate) struct Words {
    pub all: fn() -> Vec<&'static str>,
    /// Alternative spellings of the allowed words.
    pub also: &'static [(&'static str, &'static [&'static str])],
    /// Message for an unknown word. The unknown word replaces `{}`.
    pub message: &'static str,
    /// Hint for an unknown word that resembles no allowed word. The list of all allowed words replaces `{}`.
    pub hint: &'static str,
}

/// General hint that lists the allowed words.
pub(crate) const WHAT_CAN_STAND_HERE: &str = "allowed here: {}";

/// Alternative names of a key for a position.
pub(crate) const ALSO_AT: &[&str] = &["x", "position", "location", "station"];
pub(crate) const ALSO_FROM: &[&str] = &["start", "begin", "x1"];
pub(crate) const ALSO_TO: &[&str] = &["end", "x2"];
pub(crate) const ALSO_WIDTH: &[&str] = &["b", "breadth"];
pub(crate) const ALSO_E: &[&str] = &["elastic_modulus", "youngs_modulus", "young", "modulus"];
pub(crate) const ALSO_NU: &[&str] = &["poisson", "poissons_ratio", "ν"];

/// Returns an optional key. The function [`Key::needed`] makes a key required.
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

/// Placeholder for a key that no table lists.
static UNLISTED: Key = key("", Value::Depends, "");

impl Key {
    pub const fn needed(self) -> Key {
        Key { needed: true, ..self }
    }

    pub const fn also(self, also: &'static [&'static str]) -> Key {
        Key { also, ..self }
    }

    /// Returns this key with `names` of another quantity that users may give by mistake. `how` is a hint that tells users
    /// how to convert this other quantity to the quantity of the key.
    pub const fn unlike(self, names: &'static [&'static str], how: &'static str) -> Key {
        Key { unlike: Some((names, how)), ..self }
    }

    /// Returns the kind of quantity that the key expects. For a key without a quantity, returns the kind of a plain
    /// number.
    pub fn kind(&self) -> &'static Kind {
        match self.value {
            Value::Quantity(kind) | Value::Along(kind, _) => kind,
            Value::List(Value::Quantity(kind), _) => kind,
            _ => &RATIO,
        }
    }

    /// Returns a valid line of a model file with this key. `plain` means a file without units.
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
    /// Returns a hint for a list of tables that have no heading of their own, such as the axles of a train.
    pub fn inline(&self, key: &str, plain: bool) -> Option<String> {
        let needed = self.keys.iter().filter(|key| key.needed);
        let lines: Vec<String> = needed.map(|key| key.line(plain)).collect();
        let is_inline = !self.name.starts_with('[');
        is_inline.then(|| format!("write the value as in {key} = [{{ {} }}]", lines.join(", ")))
    }

    /// Returns the definition of a key of this table.
    pub fn key(&self, name: &str) -> &'static Key {
        let found = self.keys.iter().find(|key| key.name == name);
        debug_assert!(found.is_some(), "{} has no key `{name}`", self.name);
        found.unwrap_or(&UNLISTED)
    }

    /// Returns the names of all keys of the table.
    pub fn names(&self) -> Vec<&'static str> {
        self.keys.iter().map(|key| key.name).collect()
    }

    /// Whether a table with this name, directly in this table or at a deeper level, may be given several times.
    pub fn may_be_several(&self, name: &str) -> bool {
        self.keys.iter().any(|key| match key.value {
            Value::Tables(table) => key.name == name || table.may_be_several(name),
            Value::Table(table) => table.may_be_several(name),
            _ => false,
        })
    }
}

/// If `written` names a quantity from which the value of one of `keys` can be computed, returns the name of this key
/// and a text that explains the computation.
pub(crate) fn becomes(written: &str, keys: &[&Key]) -> Option<(&'static str, &'static str)> {
    let lower = written.to_lowercase();
    let of_key = |key: &&Key| {
        let (names, how) = key.unlike?;
        names.contains(&lower.as_str()).then_some((key.name, how))
    };
    keys.iter().find_map(of_key)
}

/// Returns the name of the known key that is probably meant by the unknown key `written`: a key with a similar name, or
/// else a key with the alternative name `written`.
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
                "{place}: an alternative name is also the name of a key"
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
    fn misspelled_and_alternative_names_give_the_key() {
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
