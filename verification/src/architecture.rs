//! Reads the code map and the dependencies of the crates from the sources, for the tests of the rules in `ARCHITECTURE.md`.

use groundbeam_testing::repository;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A source file with its path in the repository and its text.
pub struct Source {
    /// Path of the file in the repository, with `/` between folders.
    pub path: String,
    /// Text of the file.
    pub text: String,
}

impl Source {
    /// Returns the first sentence of the documentation of the file, if there is one.
    pub fn summary(&self) -> Option<String> {
        let lines = self.text.lines().take_while(|line| line.starts_with("//!"));
        let text: Vec<&str> =
            lines.map(|line| line[3..].trim()).take_while(|l| !l.is_empty()).collect();
        let mut text = text.join(" ").replace("\\[", "[").replace("\\]", "]");
        // Links to items of the crate do not work in the code map.
        while let Some(from) = text.find("](crate::") {
            let to = text[from..].find(')').map_or(text.len(), |length| from + length + 1);
            text.replace_range(from..to, "]");
        }
        let text = text.replace("[`", "`").replace("`]", "`");
        let end = text.find(". ").unwrap_or(text.len());
        let text = text[..end].trim_end_matches('.');
        (!text.is_empty()).then(|| text.to_owned())
    }

    /// Returns the text of the file without the tests at its end. If `#![cfg(test)]` excludes the file from the
    /// program, the function returns only the lines before this attribute.
    pub fn code(&self) -> &str {
        if let Some((head, _)) = self.text.split_once("\n#![cfg(test)]\n") {
            return head;
        }
        let tests = ["#[cfg(test)]\nmod ", "#[cfg(test)]\npub(crate) mod "];
        let end = tests.iter().filter_map(|head| self.text.find(head)).min();
        &self.text[..end.unwrap_or(self.text.len())]
    }
}

/// Returns all source files below a folder of the repository, sorted by name.
pub fn sources(folder: &str) -> Vec<Source> {
    let root = repository();
    let mut found = Vec::new();
    let mut folders: Vec<PathBuf> = vec![root.join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).into_iter().flatten() {
            let path = entry.expect("a readable folder").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                found.push(Source { path: spelled(&root, &path), text: text(&path) });
            }
        }
    }
    found.sort_by(|a, b| a.path.cmp(&b.path));
    found
}

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn spelled(root: &Path, path: &Path) -> String {
    let inside = path.strip_prefix(root).expect("a file of the repository");
    let parts: Vec<_> = inside.components().map(|c| c.as_os_str().to_string_lossy()).collect();
    parts.join("/")
}

/// Returns the crates of the workspace, each with its folder and its dependencies outside of tests.
pub fn crates() -> BTreeMap<String, (String, Vec<String>)> {
    let root = repository();
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--no-deps", "--offline", "--format-version", "1"])
        .current_dir(&root)
        .output()
        .expect("cargo runs");
    let metadata: serde_json::Value = serde_json::from_slice(&output.stdout).expect("metadata");
    let list = |value: &serde_json::Value| value.as_array().cloned().unwrap_or_default();
    let word = |value: &serde_json::Value| value.as_str().unwrap_or_default().to_owned();
    let each = |package: &serde_json::Value| {
        // Optional external dependencies are not listed.
        let is_needed = |d: &serde_json::Value| d["optional"] != true || d["path"].is_string();
        let outside_tests = |d: &serde_json::Value| d["kind"].is_null() && is_needed(d);
        let needs = list(&package["dependencies"]);
        let needs = needs.iter().filter(|d| outside_tests(d)).map(|d| word(&d["name"]));
        let manifest = PathBuf::from(word(&package["manifest_path"]));
        let folder = spelled(&root, manifest.parent().expect("a folder"));
        (word(&package["name"]), (folder, needs.collect()))
    };
    list(&metadata["packages"]).iter().map(each).collect()
}

/// Returns the code map, a list of all source files with the first sentences of their documentation.
pub fn map() -> String {
    let mut made = String::from("```text\n");
    for (name, (folder, _)) in crates() {
        writeln!(made, "{name}").expect("text");
        let prefix = format!("{folder}/src/");
        for source in sources(&prefix) {
            let file = source.path.strip_prefix(&prefix).unwrap_or(&source.path);
            let summary = source.summary().unwrap_or_default();
            writeln!(made, "  {file:<26} {summary}").expect("text");
        }
    }
    made + "```\n"
}
