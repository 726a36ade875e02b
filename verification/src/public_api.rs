//! Reads the public items of the library from its sources: names at the root, and members of every public type.

use crate::architecture::{Source, sources};
use quote::ToTokens;
use std::collections::{BTreeMap, BTreeSet};
use syn::{Fields, ImplItem, Item, Signature, TraitItem, UseTree, Visibility};

const FOLDER: &str = "crates/groundbeam/src/";

/// The public items of the library.
#[derive(Default)]
pub struct PublicApi {
    /// The names of `pub use` and `pub mod` in `lib.rs`.
    pub root: BTreeSet<String>,
    /// The names that public modules contain.
    exported: BTreeSet<String>,
    /// The members of each type, and the arguments of each function.
    items: BTreeMap<String, BTreeSet<String>>,
}

impl PublicApi {
    /// Reads the sources of the library.
    pub fn read() -> Self {
        let mut api = PublicApi::default();
        let files: Vec<(String, Vec<Item>)> = sources(FOLDER).iter().map(parsed).collect();
        let root = files.iter().find(|(name, _)| name == "lib.rs").expect("lib.rs");
        api.root.extend(root.1.iter().flat_map(public_names));
        for (name, items) in &files {
            let module = name.split(['/', '.']).next().unwrap_or_default();
            let is_entrance = name.ends_with("/mod.rs") || !name.contains('/');
            if name == "lib.rs" || is_entrance && api.root.contains(module) {
                api.exported.extend(items.iter().flat_map(public_names));
            }
            items.iter().for_each(|item| api.add(item));
        }
        api
    }

    /// Returns one line for each public item, with its name and its members.
    pub fn lines(&self) -> Vec<String> {
        let exported = self.items.iter().filter(|(name, _)| self.exported.contains(*name));
        exported
            .map(|(name, members)| {
                let members: Vec<&str> = members.iter().map(String::as_str).collect();
                format!("{name}: {}", members.join(", ")).trim_end_matches([' ', ':']).to_owned()
            })
            .collect()
    }

    fn add(&mut self, item: &Item) {
        match item {
            Item::Struct(item) if is_plain(&item.vis) => {
                self.extend(&item.ident, fields(&item.fields));
            }
            Item::Enum(item) if is_plain(&item.vis) => {
                self.extend(&item.ident, item.variants.iter().map(|v| v.ident.to_string()));
            }
            Item::Trait(item) if is_plain(&item.vis) => {
                let methods = item.items.iter().filter_map(|item| match item {
                    TraitItem::Fn(method) => Some(signature(&method.sig)),
                    _ => None,
                });
                self.extend(&item.ident, methods);
            }
            Item::Fn(item) if is_plain(&item.vis) => {
                self.extend(&item.sig.ident, [signature(&item.sig)]);
            }
            Item::Const(item) if is_plain(&item.vis) => self.extend(&item.ident, []),
            Item::Type(item) if is_plain(&item.vis) => self.extend(&item.ident, []),
            Item::Impl(block) if block.trait_.is_none() => {
                let owner = block.self_ty.to_token_stream().to_string();
                let owner = owner.split([' ', '<']).next().unwrap_or_default().to_owned();
                let members = block.items.iter().filter_map(|item| match item {
                    ImplItem::Fn(method) if is_plain(&method.vis) => Some(signature(&method.sig)),
                    ImplItem::Const(item) if is_plain(&item.vis) => Some(item.ident.to_string()),
                    _ => None,
                });
                self.items.entry(owner).or_default().extend(members);
            }
            _ => {}
        }
    }

    fn extend(&mut self, name: &syn::Ident, members: impl IntoIterator<Item = String>) {
        self.items.entry(name.to_string()).or_default().extend(members);
    }
}

fn parsed(source: &Source) -> (String, Vec<Item>) {
    let file = syn::parse_file(source.code()).unwrap_or_else(|e| panic!("{}: {e}", source.path));
    (source.path.trim_start_matches(FOLDER).to_owned(), file.items)
}

fn is_plain(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

/// Returns the names that an item adds to its module, if the item is public.
fn public_names(item: &Item) -> Vec<String> {
    let (visibility, names) = match item {
        Item::Use(item) => (&item.vis, leaves(&item.tree)),
        Item::Mod(item) => (&item.vis, vec![item.ident.to_string()]),
        Item::Struct(item) => (&item.vis, vec![item.ident.to_string()]),
        Item::Enum(item) => (&item.vis, vec![item.ident.to_string()]),
        Item::Trait(item) => (&item.vis, vec![item.ident.to_string()]),
        Item::Fn(item) => (&item.vis, vec![item.sig.ident.to_string()]),
        Item::Const(item) => (&item.vis, vec![item.ident.to_string()]),
        Item::Type(item) => (&item.vis, vec![item.ident.to_string()]),
        _ => return Vec::new(),
    };
    if is_plain(visibility) { names } else { Vec::new() }
}

fn leaves(tree: &UseTree) -> Vec<String> {
    match tree {
        UseTree::Path(path) => leaves(&path.tree),
        UseTree::Name(name) => vec![name.ident.to_string()],
        UseTree::Rename(renamed) => vec![renamed.rename.to_string()],
        UseTree::Glob(_) => Vec::new(),
        UseTree::Group(group) => group.items.iter().flat_map(leaves).collect(),
    }
}

fn fields(fields: &Fields) -> Vec<String> {
    let public = fields.iter().filter(|field| is_plain(&field.vis));
    public.filter_map(|field| field.ident.as_ref().map(ToString::to_string)).collect()
}

/// Returns the name of a function with the number of its arguments.
fn signature(signature: &Signature) -> String {
    format!("{}({})", signature.ident, signature.inputs.len())
}
