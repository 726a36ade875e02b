//! The context of a report: title, units, ground, limits, load factors.

use crate::quantity::Units;
use crate::verified::Named;
use groundbeam::{LimitStates, Limits};
use groundbeam_file::{Diagnostic, Document, printable};
use groundbeam_run::{Factors, Ground};

/// What a report says besides the result itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Context<'a> {
    /// What the model is called.
    pub title: Option<&'a str>,
    /// How numbers are written.
    pub units: Units,
    /// How long it took \[s\]; left out where nobody measured it.
    pub seconds: Option<f64>,
    /// What becomes of the model as its loads grow; left out where nobody asked.
    pub factors: Option<&'a Factors>,
    /// Where the model's ground comes from; left out where its constants were given per length of beam.
    pub ground: Option<&'a Ground>,
    /// What the design must keep to; left out where nobody asked.
    pub limits: Option<&'a Limits>,
    /// The limit states of the combination that is solved alone; none of loads as they are given.
    pub limit_states: LimitStates,
    /// How many chords of the initial gap replace settlement troughs; left out where there are no troughs.
    pub chords: Option<usize>,
    /// The digest of the model file and of the tables that it names, as [`model_digest`](crate::model_digest) makes it;
    /// left out where the model does not come from a file.
    pub digest: Option<&'a str>,
    /// The combination that is solved alone; left out for a model as it is written.
    pub combination: Option<&'a str>,
    /// Whether a document holds the pieces of the answer, from which it is proven.
    pub pieces: bool,
    /// Whether a document holds the model: the proof does not read the model file.
    pub model: bool,
    /// Warnings about the file.
    pub warnings: &'a [Diagnostic],
    /// The proof of each answer, in their order; empty if none is asked for.
    pub proofs: &'a [Named],
}

impl<'a> Context<'a> {
    /// Title, units, limits and chords of a model file.
    pub fn of(document: &'a Document) -> Self {
        Context {
            title: document.title.as_deref(),
            limits: Some(&document.limits),
            chords: document.chords,
            warnings: &document.warnings,
            ..Context::new(document.printed)
        }
    }

    /// No title, no time.
    pub fn new(units: Units) -> Self {
        Context {
            title: None,
            units,
            seconds: None,
            factors: None,
            ground: None,
            limits: None,
            limit_states: LimitStates::NONE,
            chords: None,
            digest: None,
            combination: None,
            pieces: false,
            model: false,
            warnings: &[],
            proofs: &[],
        }
    }

    /// The same with a title.
    pub fn with_title(self, title: &'a str) -> Self {
        Context { title: Some(title), ..self }
    }

    /// The same with the time it took \[s\].
    pub fn with_seconds(self, seconds: f64) -> Self {
        Context { seconds: Some(seconds), ..self }
    }

    /// The same with load factors.
    pub fn with_factors(self, factors: &'a Factors) -> Self {
        Context { factors: Some(factors), ..self }
    }

    /// The same with where the ground comes from.
    pub fn with_ground(self, ground: &'a Ground) -> Self {
        Context { ground: Some(ground), ..self }
    }

    /// The same with limits to check against.
    pub fn with_limits(self, limits: &'a Limits) -> Self {
        Context { limits: Some(limits), ..self }
    }

    /// The title on one line, without characters that would steer a terminal or break XML.
    pub(crate) fn clean_title(&self) -> Option<String> {
        self.title.map(clean).filter(|title| !title.is_empty())
    }
}

/// Words of a file on one line, without characters that would steer a terminal or break XML.
pub(crate) fn clean(words: &str) -> String {
    printable(&words.split_whitespace().collect::<Vec<_>>().join(" ")).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_cannot_steer_a_terminal() {
        let context = Context::new(Units::SI).with_title(" a\u{1b}[31m\tb\n ");
        assert_eq!(context.clean_title().as_deref(), Some(r"a\u{1b}[31m b"));
        assert_eq!(Context::new(Units::SI).with_title(" \n").clean_title(), None);
    }
}
