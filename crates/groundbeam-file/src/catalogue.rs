//! Finds entries by name in the built-in lists of materials, trains and sets of combinations.

use serde::de::DeserializeOwned;

/// An entry of a built-in list.
pub(crate) trait Entry {
    fn name(&self) -> &str;
    /// Alternative names of the entry.
    fn also(&self) -> &[String];

    fn is_called(&self, name: &str) -> bool {
        self.name() == name || self.also().iter().any(|also| also == name)
    }
}

/// Returns all names of all entries, including the alternative names.
pub(crate) fn spellings<'e, E: Entry + 'e>(
    entries: impl IntoIterator<Item = &'e E>,
) -> Vec<&'e str> {
    let names =
        |entry: &'e E| std::iter::once(entry.name()).chain(entry.also().iter().map(|s| &**s));
    entries.into_iter().flat_map(names).collect()
}

/// Parses the data files of a built-in list. The tests check that these files are valid.
pub(crate) fn files<F: DeserializeOwned>(texts: &[&str]) -> Vec<F> {
    let read =
        |text: &&str| toml::from_str(text).expect("the data files of the built-in lists are valid");
    texts.iter().map(read).collect()
}

#[cfg(test)]
mod tests {
    use crate::{materials, sets, trains};

    #[test]
    fn names_are_unique() {
        for mut names in [materials::spellings(), sets::spellings(), trains::spellings()] {
            let count = names.len();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), count);
        }
    }
}
