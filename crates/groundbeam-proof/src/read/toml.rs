//! Reads the TOML of model files into a tree of values with their positions. Numbers remain decimal text.
//!
//! The reader refuses dates, infinities and NaN, because no model needs them. It also refuses duplicate keys.

use super::error::{Fault, Read, Reason, fault};
use super::text::Scanner;
use std::collections::BTreeMap;

/// Maximum length of a file, in bytes.
const LONGEST: usize = 64 << 20;
/// Maximum number of values in a file.
const MOST: usize = 4_000_000;
/// Maximum number of names in a heading or a dotted key, and maximum depth of nested lists and tables.
const DEEPEST: usize = 16;

/// A value and the byte at which it begins.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Node {
    pub at: usize,
    pub value: Value,
}

/// A value.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Value {
    Text(String),
    /// A number as text: digits with an optional sign, point and exponent.
    Number(String),
    Boolean(bool),
    List(Vec<Node>),
    Table(Table),
    /// A list whose elements are written as `[[name]]`.
    Tables(Vec<Node>),
}

/// A table: its keys with their positions and values.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Table {
    entries: BTreeMap<String, (usize, Node)>,
    origin: Origin,
}

/// How a table was created. It determines which keys may still be added.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum Origin {
    /// The table has no heading of its own, but a subtable has one, such as `[name.subtable]`.
    #[default]
    Implied,
    /// The table has its own heading, such as `[name]`.
    Heading,
    /// The table is created by a dotted key, such as `name.key = 1`.
    Dotted,
    /// The table is written in braces, such as `name = { key = 1 }`. No key may be added to it.
    Inline,
}

impl Table {
    /// The value of a key.
    pub fn get(&self, key: &str) -> Option<&Node> {
        self.entries.get(key).map(|(_, node)| node)
    }

    /// Every key with its position and its value.
    pub fn entries(&self) -> impl Iterator<Item = (&str, usize, &Node)> {
        self.entries.iter().map(|(key, (at, node))| (key.as_str(), *at, node))
    }

    /// The position of a key.
    pub fn place(&self, key: &str) -> Option<usize> {
        self.entries.get(key).map(|(at, _)| *at)
    }

    fn of(origin: Origin) -> Self {
        Table { entries: BTreeMap::new(), origin }
    }

    fn add(&mut self, (key, at): (String, usize), node: Node) -> Read<()> {
        if self.entries.contains_key(&key) {
            return fault(at, Reason::Twice(key));
        }
        self.entries.insert(key, (at, node));
        Ok(())
    }

    /// Returns the value of a key. If the key is missing, adds an empty table with the given origin.
    fn inner(&mut self, (key, at): &(String, usize), origin: Origin) -> &mut Node {
        let new = || (*at, Node { at: *at, value: Value::Table(Table::of(origin)) });
        &mut self.entries.entry(key.clone()).or_insert_with(new).1
    }
}

type Name = (String, usize);

/// Reads a whole file.
pub(crate) fn read(text: &str) -> Read<Table> {
    read_within([LONGEST, MOST], text)
}

/// Reads a whole file with at most the given numbers of bytes and values.
fn read_within([longest, most]: [usize; 2], text: &str) -> Read<Table> {
    if text.len() > longest {
        return fault(0, Reason::TooLarge);
    }
    let mut reader = Reader { scanner: Scanner::new(text), values: 0, most };
    let mut root = Table::of(Origin::Heading);
    let mut path: Vec<Name> = Vec::new();
    loop {
        reader.scanner.skip_lines()?;
        let at = reader.scanner.at;
        match reader.scanner.peek() {
            None => return Ok(root),
            Some(b'[') => {
                let is_list = reader.scanner.take("[[");
                if !is_list {
                    reader.scanner.take("[");
                }
                path = reader.names()?;
                reader.scanner.skip_spaces();
                if !reader.scanner.take(if is_list { "]]" } else { "]" }) {
                    return reader.scanner.syntax("a heading is written [name] or [[name]]");
                }
                reader.count(at)?;
                if is_list { begin_element(&mut root, &path)? } else { begin(&mut root, &path)? }
            }
            Some(_) => {
                let (names, node) = reader.pair(0)?;
                add(current(&mut root, &path)?, names, node)?;
            }
        }
        reader.scanner.end_of_line()?;
    }
}

/// Adds a value under a dotted key.
fn add(table: &mut Table, mut names: Vec<Name>, node: Node) -> Read<()> {
    let Some(last) = names.pop() else { return fault(node.at, Reason::Syntax("a key is missing")) };
    let mut table = table;
    for name in &names {
        table = match &mut table.inner(name, Origin::Dotted).value {
            Value::Table(inner) if inner.origin == Origin::Dotted => inner,
            _ => return fault(name.1, Reason::Twice(name.0.clone())),
        };
    }
    table.add(last, node)
}

/// Returns the table at a path of names. Adds the tables that are missing.
fn descend<'t>(root: &'t mut Table, path: &[Name]) -> Read<&'t mut Table> {
    let mut table = root;
    for name in path {
        let node = table.inner(name, Origin::Implied);
        let inner = match &mut node.value {
            Value::Table(inner) if inner.origin != Origin::Inline => Some(inner),
            Value::Tables(list) => match list.last_mut().map(|last| &mut last.value) {
                Some(Value::Table(last)) => Some(last),
                _ => None,
            },
            _ => None,
        };
        match inner {
            Some(inner) => table = inner,
            None => return fault(name.1, Reason::Twice(name.0.clone())),
        }
    }
    Ok(table)
}

/// The table of the last heading.
fn current<'t>(root: &'t mut Table, path: &[Name]) -> Read<&'t mut Table> {
    descend(root, path)
}

/// `[path]`
fn begin(root: &mut Table, path: &[Name]) -> Read<()> {
    let Some((last, path)) = path.split_last() else { return Ok(()) };
    let parent = descend(root, path)?;
    match &mut parent.inner(last, Origin::Implied).value {
        Value::Table(table) if table.origin == Origin::Implied => {
            table.origin = Origin::Heading;
            Ok(())
        }
        _ => fault(last.1, Reason::Twice(last.0.clone())),
    }
}

/// `[[path]]`
fn begin_element(root: &mut Table, path: &[Name]) -> Read<()> {
    let Some((last, path)) = path.split_last() else { return Ok(()) };
    let parent = descend(root, path)?;
    let at = last.1;
    let element = Node { at, value: Value::Table(Table::of(Origin::Heading)) };
    match parent.entries.get_mut(&last.0).map(|(_, node)| &mut node.value) {
        None => parent.add(last.clone(), Node { at, value: Value::Tables(vec![element]) }),
        Some(Value::Tables(list)) => {
            list.push(element);
            Ok(())
        }
        Some(_) => fault(at, Reason::Twice(last.0.clone())),
    }
}

struct Reader<'t> {
    scanner: Scanner<'t>,
    values: usize,
    /// Maximum number of values.
    most: usize,
}

impl Reader<'_> {
    /// Counts one more value.
    fn count(&mut self, at: usize) -> Read<()> {
        self.values += 1;
        if self.values > self.most { fault(at, Reason::TooLarge) } else { Ok(()) }
    }

    /// Reads the names of a heading or of a dotted key. The names are separated by dots.
    fn names(&mut self) -> Read<Vec<Name>> {
        let mut names = Vec::new();
        loop {
            self.scanner.skip_spaces();
            let at = self.scanner.at;
            if names.len() == DEEPEST {
                return fault(at, Reason::TooLarge);
            }
            names.push((self.scanner.name()?, at));
            self.scanner.skip_spaces();
            if !self.scanner.take(".") {
                return Ok(names);
            }
        }
    }

    /// Reads `key = value` at this depth of nested lists and tables.
    fn pair(&mut self, depth: usize) -> Read<(Vec<Name>, Node)> {
        let names = self.names()?;
        if !self.scanner.take("=") {
            return self.scanner.syntax("write key = value");
        }
        self.scanner.skip_spaces();
        Ok((names, self.value(depth)?))
    }

    fn value(&mut self, depth: usize) -> Read<Node> {
        let at = self.scanner.at;
        self.count(at)?;
        let value = match self.scanner.peek() {
            Some(b'"' | b'\'') => Value::Text(self.scanner.string()?),
            Some(b'[' | b'{') if depth == DEEPEST => return fault(at, Reason::TooLarge),
            Some(b'[') => self.list(depth + 1)?,
            Some(b'{') => self.inline(depth + 1)?,
            _ => match self.scanner.word() {
                "true" => Value::Boolean(true),
                "false" => Value::Boolean(false),
                word => match super::number::of_toml(word) {
                    Ok(number) => Value::Number(number),
                    Err(what) => return Err(Fault { at, reason: Reason::Syntax(what) }),
                },
            },
        };
        Ok(Node { at, value })
    }

    fn list(&mut self, depth: usize) -> Read<Value> {
        self.scanner.take("[");
        let mut elements = Vec::new();
        loop {
            self.scanner.skip_lines()?;
            if self.scanner.take("]") {
                return Ok(Value::List(elements));
            }
            elements.push(self.value(depth)?);
            self.scanner.skip_lines()?;
            if !self.scanner.take(",") && self.scanner.peek() != Some(b']') {
                return self.scanner.syntax("elements of a list must be separated by commas");
            }
        }
    }

    fn inline(&mut self, depth: usize) -> Read<Value> {
        self.scanner.take("{");
        let mut table = Table::of(Origin::Inline);
        self.scanner.skip_spaces();
        if self.scanner.take("}") {
            return Ok(Value::Table(table));
        }
        loop {
            let (names, node) = self.pair(depth)?;
            add(&mut table, names, node)?;
            self.scanner.skip_spaces();
            if self.scanner.take("}") {
                return Ok(Value::Table(table));
            }
            if !self.scanner.take(",") {
                return self.scanner.syntax("keys in braces must be separated by commas");
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(table: &Table, key: &str) -> String {
        match &table.get(key).unwrap().value {
            Value::Number(number) => number.clone(),
            other => panic!("{other:?}"),
        }
    }

    fn inner<'t>(table: &'t Table, key: &str) -> &'t Table {
        match &table.get(key).unwrap().value {
            Value::Table(inner) => inner,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn tables_of_every_form() {
        let text = "a.b = 1 # comment\n'c d' = 2\n[e]\nf = { g = 3, h.i = [4, [5], # c\n 6,\n] }\n\
                    [[l]]\nm = 7\n[l.n]\no = 8\n[[l]]\n[e.p.q]\nr = true\n[e.p]\n";
        let root = read(text).unwrap();
        assert_eq!(number(inner(&root, "a"), "b"), "1");
        assert_eq!(number(&root, "c d"), "2");
        let f = inner(inner(&root, "e"), "f");
        assert_eq!(number(f, "g"), "3");
        let Value::List(list) = &inner(f, "h").get("i").unwrap().value else { panic!() };
        assert_eq!(list.len(), 3);
        let Value::Tables(list) = &root.get("l").unwrap().value else { panic!() };
        let Value::Table(first) = &list[0].value else { panic!() };
        assert_eq!((list.len(), number(inner(first, "n"), "o")), (2, "8".into()));
        let q = inner(inner(inner(&root, "e"), "p"), "q");
        assert_eq!(q.get("r").unwrap().value, Value::Boolean(true));
    }

    #[test]
    fn duplicate_keys_and_tables_are_refused() {
        for text in [
            "a = 1\na = 2",
            "a = 1\n\"a\" = 2",
            "[a]\n[a]",
            "[a]\nb = 1\n[a.b]",
            "a = {b = 1}\n[a.c]",
            "a = {b = 1}\na.c = 2",
            "[[a]]\n[a]",
            "[a]\n[[a]]",
            "a = []\n[[a]]",
            "[a]\nb.c = 1\n[a.b]",
            "[a.b]\n[a]\nb.c = 1",
            "a = { b = 1, b = 2 }",
            "a.b = 1\na = 2",
        ] {
            let reason = read(text).unwrap_err().reason;
            assert!(matches!(reason, Reason::Twice(_)), "{text:?}: {reason:?}");
        }
    }

    #[test]
    fn invalid_toml_is_refused() {
        for text in [
            "a",
            "a =",
            "a = 1 b = 2",
            "= 1",
            "[a",
            "[[a]",
            "[]",
            "a = [1 2]",
            "a = [1,,2]",
            "a = {b = 1,}",
            "a = {b = 1\n}",
            "a = {",
            "a = [",
            "a = 12 m",
            "a = nan",
            "a = inf",
            "a = 1979-05-27",
            "a = True",
            "a = \"x",
            "a = 1\u{1}",
            "a.. = 1",
            "a b = 1",
        ] {
            let reason = read(text).unwrap_err().reason;
            assert!(matches!(reason, Reason::Syntax(_)), "{text:?}: {reason:?}");
        }
        let deep = format!("a = {}1{}", "[".repeat(1000), "]".repeat(1000));
        assert_eq!(read(&deep).unwrap_err().reason, Reason::TooLarge);
        let dotted = format!("{}a = 1", "a.".repeat(1000));
        assert_eq!(read(&dotted).unwrap_err().reason, Reason::TooLarge);
    }

    /// The text has 26 bytes. Five values are counted: the heading, the list, the two numbers in the list, and the
    /// number 3.
    #[test]
    fn bytes_and_values_are_limited() {
        let text = "[a]\nb = [1, 2]\nc = 3 # end";
        assert_eq!(text.len(), 26);
        for (limits, right) in [
            ([26, 5], true),
            ([25, 5], false),
            ([27, 5], true),
            ([26, 4], false),
            ([26, 6], true),
            ([5, 5], false),
            ([26, 1], false),
        ] {
            let found = read_within(limits, text).map(drop).map_err(|fault| fault.reason);
            assert_eq!(found, if right { Ok(()) } else { Err(Reason::TooLarge) }, "{limits:?}");
        }
    }
}
