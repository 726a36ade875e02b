//! Reads keys whose value is one of a few allowed words.

use crate::code;
use crate::fault::Fault;
use crate::keys::{Value, Words};
use crate::reader::Reader;
use crate::suggest;
use crate::table::Section;
use std::ops::Range;
use toml::de::DeValue;

impl Reader<'_> {
    /// Returns the word under `key` if the file gives an allowed word.
    pub fn word(&mut self, section: &Section, key: &str) -> Option<&'static str> {
        let Value::Word(words) = section.key(key).value else { return None };
        let written = self.text(section, key)?;
        self.one_of(words, written)
    }

    /// Returns the words under `key`, where the file gives one word or a list of words.
    pub fn words(&mut self, section: &Section, key: &str) -> Option<Vec<&'static str>> {
        let Value::OneOrMore(words) = section.key(key).value else { return None };
        let value = self.value(section, key)?;
        let DeValue::Array(list) = value.get_ref() else {
            let written = self.text(section, key)?;
            return Some(self.one_of(words, written).into_iter().collect());
        };
        let mut found = Vec::new();
        for entry in list.iter() {
            match entry.get_ref() {
                DeValue::String(text) => found.extend(self.one_of(words, (text, entry.span()))),
                _ => {
                    let hint = format!(
                        "write each word in quotes, as in {key} = [\"{}\"]",
                        (words.all)()[0]
                    );
                    self.wrong_type(entry, format!("`{key}` is a list of words"), hint);
                }
            }
        }
        Some(found)
    }

    /// Returns the allowed word that equals `written`. Any other word is reported.
    fn one_of(
        &mut self,
        words: &Words,
        (written, span): (&str, Range<usize>),
    ) -> Option<&'static str> {
        let all = (words.all)();
        let known = all.iter().copied().find(|word| *word == written.trim());
        if known.is_none() {
            let lower = written.to_lowercase();
            let other = words.also.iter().find(|(_, others)| others.contains(&lower.as_str()));
            let meant = other.map_or(written, |(word, _)| word);
            let message = words.message.replace("{}", written);
            let hint = suggest::advice(meant, &all, words.hint);
            self.report(Fault::new(code::UNKNOWN_WORD, span, message, "", hint));
        }
        known
    }
}
