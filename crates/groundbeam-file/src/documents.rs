//! Tests that the tables of keys in `docs/file-format.md` and `docs/studies.md` agree with the code.
//!
//! With `UPDATE_EXPECTED=1`, the test rewrites the tables.

use crate::keys::{Key, Table, Value};
use crate::section::MODEL;
use crate::study::STUDY;
use groundbeam_testing::{expect_file, read};

const END: &str = "<!-- end -->";

/// Returns a table and all tables below it. Of several tables with the same keys, only the first table is returned.
fn tables(root: &'static Table) -> Vec<&'static Table> {
    let mut all = vec![root];
    for key in root.keys {
        if let Value::Table(table) | Value::Tables(table) = key.value {
            let is_new = |table: &&'static Table| {
                all.iter().all(|known| known.keys.as_ptr() != table.keys.as_ptr())
            };
            let new: Vec<_> = tables(table).into_iter().filter(is_new).collect();
            all.extend(new);
        }
    }
    all
}

fn row(Key { name, value, meaning, needed, .. }: &Key) -> String {
    let needed = if *needed { " (needed)" } else { "" };
    format!("| `{name}`{needed} | {} | {meaning} |\n", described(value))
}

fn described(value: &Value) -> String {
    match *value {
        Value::Quantity(kind) if kind.unit.is_empty() => {
            format!("{}, `{}`", kind.what, kind.example)
        }
        Value::Quantity(kind) => format!("{}, `{}`", kind.what, kind.value(false)),
        Value::Depends => "a quantity".to_owned(),
        Value::Along(kind, 2) => format!("{}, or a list of two", described(&Value::Quantity(kind))),
        Value::Along(kind, most) => {
            format!("{}, or a list of 2 to {most}", described(&Value::Quantity(kind)))
        }
        Value::Count([least, most]) => format!("a whole number from {least} to {most}"),
        Value::Flag => "`true` or `false`".to_owned(),
        Value::Text(example) => format!("text, `\"{example}\"`"),
        Value::Name(example, _) => format!("a name, `\"{example}\"`"),
        Value::Word(words) => {
            let words: Vec<String> = (words.all)().iter().map(|w| format!("`\"{w}\"`")).collect();
            words.join(", ")
        }
        Value::OneOrMore(words) => format!("{}, or a list of them", described(&Value::Word(words))),
        Value::List(one, [least, most]) if least == most => {
            format!("a list of {least}: {}", described(one))
        }
        Value::List(one, _) => format!("a list: {}", described(one)),
        Value::Factors => "a table, `{ G = 1.35, Q = 1.5 }`".to_owned(),
        Value::Table(_) => "a table".to_owned(),
        Value::Tables(_) => "tables".to_owned(),
    }
}

/// Returns the text with all tables of keys regenerated, and the names of these tables.
fn made(text: &str, tables: &[&'static Table]) -> (String, Vec<String>) {
    let mut made = String::new();
    let mut names = Vec::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        made += &format!("{line}\n");
        let name = line.strip_prefix("<!-- keys of ").and_then(|line| line.strip_suffix(" -->"));
        let Some(name) = name else { continue };
        names.push(name.to_owned());
        let table = tables.iter().find(|table| table.name == name).expect(name);
        let shown = if name.starts_with('[') { format!("`{name}`") } else { name.to_owned() };
        made += &format!("| {shown} | value | meaning |\n|---|---|---|\n");
        made.extend(table.keys.iter().map(row));
        made += &format!("{END}\n");
        lines.by_ref().find(|line| *line == END).expect(END);
    }
    (made, names)
}

#[test]
fn documents_list_the_keys_that_files_may_have() {
    for (root, name) in [(&MODEL, "docs/file-format.md"), (&STUDY, "docs/studies.md")] {
        let text = read(name);
        let tables = tables(root);
        let (made, mut listed) = made(&text, &tables);
        expect_file(name, &made);
        let mut names: Vec<&str> = tables.iter().map(|table| table.name).collect();
        names.sort_unstable();
        listed.sort_unstable();
        assert_eq!(listed, names, "{name}");
    }
}
