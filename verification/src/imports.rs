//! Finds the names that each source file of a crate uses from the other files of this crate.
//!
//! A re-exported name belongs to the file that defines it. Unit tests and method calls, which contain no path, are not
//! counted.

use crate::architecture::{Source, sources};
use petgraph::algo::tarjan_scc;
use petgraph::graph::DiGraph;
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use std::collections::{BTreeMap, BTreeSet};
use syn::{Attribute, Item, UseTree};

type Path = Vec<String>;

/// A source file with its module, the names that it defines, and the paths that it contains.
struct File {
    name: String,
    module: Path,
    defined: BTreeSet<String>,
    /// The names that `use` imports, each as a path and a local name.
    uses: Vec<(Path, String)>,
    /// All paths outside `use` declarations. Each pair contains the module in which the path occurs, and the path.
    paths: Vec<(Path, Path)>,
}

/// The imports between the files of one crate.
pub struct Imports {
    files: Vec<File>,
    modules: BTreeMap<Path, usize>,
    /// For each pair of source files, the items that the second file defines and the first file uses.
    edges: BTreeMap<(usize, usize), BTreeSet<String>>,
}

impl Imports {
    /// Reads all files below `src` of a crate in `folder`.
    pub fn of_crate(folder: &str) -> Self {
        let prefix = format!("{folder}/src/");
        let files: Vec<File> =
            sources(&prefix).iter().map(|source| File::read(source, &prefix)).collect();
        let modules = files.iter().enumerate().map(|(i, file)| (file.module.clone(), i)).collect();
        let mut imports = Imports { files, modules, edges: BTreeMap::new() };
        for i in 0..imports.files.len() {
            imports.connect(i);
        }
        imports
    }

    /// Returns the cycles of files that import each other, one list per cycle.
    pub fn cycles(&self) -> Vec<Vec<String>> {
        let edges = self
            .edges
            .keys()
            .map(|&(from, to)| (self.files[from].name.clone(), self.files[to].name.clone()));
        cycles(edges)
    }

    /// Returns the imports between modules of the crate (top folders or files). Each import has the using module, the
    /// used module and a text `file -> file: names`.
    pub fn between_modules(&self) -> Vec<(String, String, String)> {
        let mut found = Vec::new();
        for (&(from, to), names) in &self.edges {
            let [from, to] = [from, to].map(|i| self.files[i].name.as_str());
            if module_of(from) != module_of(to) {
                let names: Vec<&str> = names.iter().map(String::as_str).collect();
                let text = format!("{from} -> {to}: {}", names.join(", "));
                found.push((module_of(from).to_owned(), module_of(to).to_owned(), text));
            }
        }
        found
    }

    /// Returns the cycles of modules that import each other, one list per cycle.
    pub fn cycles_of_modules(&self) -> Vec<Vec<String>> {
        cycles(self.between_modules().into_iter().map(|(from, to, _)| (from, to)))
    }

    fn connect(&mut self, from: usize) {
        let file = &self.files[from];
        let mut found = BTreeSet::new();
        for (path, alias) in &file.uses {
            let whole = self.absolute(&file.module, path);
            // An import of a whole module is not counted, but each used name of this module is counted.
            let is_module = whole.as_ref().is_some_and(|whole| self.modules.contains_key(whole));
            if let Some(whole) = whole.filter(|_| !is_module && file.names(alias)) {
                found.extend(self.origin(&whole, 0));
            }
        }
        for (module, path) in &file.paths {
            let known = file.uses.iter().find(|(_, alias)| *alias == path[0]);
            let path: Path = match known {
                Some((head, _)) => head.iter().chain(&path[1..]).cloned().collect(),
                None => path.clone(),
            };
            if let Some(whole) = self.absolute(module, &path) {
                found.extend(self.origin(&whole, 0));
            }
        }
        for (to, name) in found.into_iter().filter(|(to, _)| *to != from) {
            self.edges.entry((from, to)).or_default().insert(name);
        }
    }

    /// Returns a path relative to the root of the crate; `None` if the path leads out of the crate.
    fn absolute(&self, module: &Path, path: &Path) -> Option<Path> {
        let mut base = module.clone();
        let mut rest = path.as_slice();
        match path[0].as_str() {
            "crate" => return Some(path[1..].to_vec()),
            "self" => rest = &rest[1..],
            "super" => {
                while rest.first().is_some_and(|part| part == "super") {
                    base.pop();
                    rest = &rest[1..];
                }
            }
            child => {
                let child: Path = base.iter().cloned().chain([child.to_owned()]).collect();
                self.modules.get(&child)?;
            }
        }
        Some(base.into_iter().chain(rest.iter().cloned()).collect())
    }

    /// Returns the file that defines the item at the end of a path, and the name of the item.
    fn origin(&self, path: &[String], depth: usize) -> Option<(usize, String)> {
        let cut = (0..=path.len()).rev().find(|cut| self.modules.contains_key(&path[..*cut]))?;
        let at = self.modules[&path[..cut]];
        let file = &self.files[at];
        let name = path.get(cut)?;
        if file.defined.contains(name) || depth > 8 {
            return Some((at, name.clone()));
        }
        for (target, alias) in &file.uses {
            let glob = target.last().is_some_and(|last| last == "*");
            if alias != name && !glob {
                continue;
            }
            let Some(mut whole) = self.absolute(&file.module, target) else { continue };
            if glob {
                whole.pop();
                whole.push(name.clone());
            }
            if let Some(found) = self.origin(&whole, depth + 1)
                && (!glob || self.files[found.0].defined.contains(&found.1))
            {
                return Some(found);
            }
        }
        Some((at, name.clone()))
    }
}

impl File {
    fn read(source: &Source, prefix: &str) -> Self {
        let name = source.path.strip_prefix(prefix).unwrap_or(&source.path).to_owned();
        let mut module: Path = name.trim_end_matches(".rs").split('/').map(str::to_owned).collect();
        let top = module.len() == 1 && ["lib", "main"].contains(&module[0].as_str());
        if top || module.last().is_some_and(|last| last == "mod") {
            module.pop();
        }
        let parsed = syn::parse_file(source.code())
            .unwrap_or_else(|error| panic!("{}: {error}", source.path));
        let mut file =
            File { name, module, defined: BTreeSet::new(), uses: Vec::new(), paths: Vec::new() };
        let module = file.module.clone();
        for item in &parsed.items {
            file.add(item, &module);
        }
        file
    }

    fn add(&mut self, item: &Item, module: &Path) {
        if attributes(item).iter().any(is_test) {
            return;
        }
        match item {
            Item::Use(item) => {
                leaves(&item.tree, &mut Vec::new(), &mut self.uses);
                return;
            }
            Item::Const(item) => self.define(&item.ident),
            Item::Enum(item) => self.define(&item.ident),
            Item::Fn(item) => self.define(&item.sig.ident),
            Item::Static(item) => self.define(&item.ident),
            Item::Struct(item) => self.define(&item.ident),
            Item::Trait(item) => self.define(&item.ident),
            Item::Type(item) => self.define(&item.ident),
            Item::Macro(item) => {
                if let Some(name) = &item.ident {
                    self.define(name);
                }
            }
            Item::Mod(item) => {
                if let Some((_, items)) = &item.content {
                    self.define(&item.ident);
                    let inner: Path =
                        module.iter().cloned().chain([item.ident.to_string()]).collect();
                    items.iter().for_each(|item| self.add(item, &inner));
                }
                return;
            }
            _ => {}
        }
        self.paths_in(item.to_token_stream(), module);
    }

    fn define(&mut self, name: &impl ToString) {
        self.defined.insert(name.to_string());
    }

    /// Whether the body of the file uses a name. A `pub use` that only re-exports the name does not count.
    fn names(&self, alias: &str) -> bool {
        alias == "*" || self.paths.iter().any(|(_, path)| path[0] == alias)
    }

    /// Collects the paths among tokens, including the paths in macro calls. A single name is a path with one part.
    fn paths_in(&mut self, tokens: TokenStream, module: &Path) {
        let mut path: Path = Vec::new();
        let mut colons = 0;
        for token in tokens {
            match token {
                TokenTree::Ident(name) => {
                    if colons != 2 {
                        self.keep(&mut path, module);
                    }
                    path.push(name.to_string());
                    colons = 0;
                }
                TokenTree::Punct(mark) if mark.as_char() == ':' => colons += 1,
                TokenTree::Group(group) => {
                    self.keep(&mut path, module);
                    self.paths_in(group.stream(), module);
                    colons = 0;
                }
                _ => {
                    self.keep(&mut path, module);
                    colons = 0;
                }
            }
        }
        self.keep(&mut path, module);
    }

    fn keep(&mut self, path: &mut Path, module: &Path) {
        if !path.is_empty() {
            self.paths.push((module.clone(), std::mem::take(path)));
        }
    }
}

/// Collects all names that a `use` imports, each with its path and its local name.
fn leaves(tree: &UseTree, before: &mut Path, found: &mut Vec<(Path, String)>) {
    let mut leaf = |last: &str, alias: &str| {
        let own = (last != "self").then(|| last.to_owned());
        found.push((before.iter().cloned().chain(own).collect(), alias.to_owned()));
    };
    match tree {
        UseTree::Name(name) => {
            let name = name.ident.to_string();
            let alias = if name == "self" { before.last().cloned() } else { None };
            leaf(&name, &alias.unwrap_or(name.clone()));
        }
        UseTree::Rename(rename) => leaf(&rename.ident.to_string(), &rename.rename.to_string()),
        UseTree::Glob(_) => leaf("*", "*"),
        UseTree::Group(group) => group.items.iter().for_each(|tree| leaves(tree, before, found)),
        UseTree::Path(path) => {
            before.push(path.ident.to_string());
            leaves(&path.tree, before, found);
            before.pop();
        }
    }
}

/// Returns the name of the top-level folder of the crate in which `file` lies. If `file` lies in no folder, returns its
/// own name without `.rs`.
pub fn module_of(file: &str) -> &str {
    file.split('/').next().unwrap_or(file).trim_end_matches(".rs")
}

fn cycles(edges: impl Iterator<Item = (String, String)>) -> Vec<Vec<String>> {
    let mut graph = DiGraph::new();
    let mut nodes = BTreeMap::new();
    for (from, to) in edges {
        let [from, to] = [from, to]
            .map(|name| *nodes.entry(name.clone()).or_insert_with(|| graph.add_node(name)));
        graph.update_edge(from, to, ());
    }
    let components = tarjan_scc(&graph).into_iter().filter(|component| component.len() > 1);
    let named = components.map(|component| {
        let mut names: Vec<String> = component.iter().map(|node| graph[*node].clone()).collect();
        names.sort();
        names
    });
    named.collect()
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

fn is_test(attribute: &Attribute) -> bool {
    attribute.path().is_ident("cfg")
        && attribute.meta.to_token_stream().to_string().replace(' ', "") == "cfg(test)"
}
