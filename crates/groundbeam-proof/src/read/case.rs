//! Loads with their load cases.

use super::error::{Read, wrong};
use super::fields::Section;
use crate::Load;

/// A load, its case, and its position in the file.
#[derive(Debug, Clone)]
pub(crate) struct Cased<S> {
    pub load: Load<S>,
    pub case: Option<String>,
    pub at: usize,
}

/// The name of a load case.
pub(crate) fn case(section: Section, key: &'static str) -> Read<Option<String>> {
    match section.words(key)? {
        Some((name, at)) if name.trim().is_empty() => wrong(at, "the load case has no name"),
        name => Ok(name.map(|(name, _)| name.trim().to_owned())),
    }
}
