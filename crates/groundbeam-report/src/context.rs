//! The context of a report: title, units, ground, limits, load factors.

use crate::quantity::Units;
use crate::verified::Named;
use groundbeam::design::Limits;
use groundbeam_file::{Combination, Depth, Diagnostic, Document, printable};
use groundbeam_run::{Factors, Ground};

/// Data of a report in addition to the result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Context<'a> {
    /// Title of the model.
    pub title: Option<&'a str>,
    /// Units and digits of numbers.
    pub units: Units,
    /// Duration \[s\]; `None` if it was not measured.
    pub seconds: Option<f64>,
    /// Load factors; `None` if not requested.
    pub factors: Option<&'a Factors>,
    /// Origin of the ground's constants; `None` if they are given per length of beam.
    pub ground: Option<&'a Ground>,
    /// Limits of the design checks; `None` if not requested.
    pub limits: Option<&'a Limits>,
    /// Number of chords of the initial gap that replace settlement troughs; `None` without troughs.
    pub chords: Option<usize>,
    /// Digest of the model file and of the tables that it names, from [`model_digest`](crate::model_digest);
    /// `None` if the model does not come from a file.
    pub digest: Option<&'a str>,
    /// A combination that is solved alone; `None` for a model as written.
    pub combination: Option<&'a Combination>,
    /// Whether the file has more combinations than the requested ones.
    pub selected: bool,
    /// Whether a document contains the pieces of the solution, which its proof needs.
    pub pieces: bool,
    /// Whether a document contains the model, because the second reader does not read the model file.
    pub model: bool,
    /// Depth of the section along the beam, which pictures show; empty if it is not known.
    pub depths: &'a [Depth],
    /// Warnings about the file.
    pub warnings: &'a [Diagnostic],
    /// Proof of each answer, in order; empty if no proof is requested.
    pub proofs: &'a [Named],
}

impl<'a> Context<'a> {
    /// Title, units, limits and chords of a model file.
    pub fn of(document: &'a Document) -> Self {
        Context {
            title: document.title.as_deref(),
            limits: Some(&document.limits),
            chords: document.chords,
            depths: &document.depths,
            warnings: &document.warnings,
            ..Context::new(document.printed)
        }
    }

    /// A context with units only.
    pub fn new(units: Units) -> Self {
        Context {
            title: None,
            units,
            seconds: None,
            factors: None,
            ground: None,
            limits: None,
            chords: None,
            digest: None,
            combination: None,
            selected: false,
            pieces: false,
            model: false,
            depths: &[],
            warnings: &[],
            proofs: &[],
        }
    }

    /// The context with a title.
    pub fn with_title(self, title: &'a str) -> Self {
        Context { title: Some(title), ..self }
    }

    /// The context with a duration \[s\].
    pub fn with_seconds(self, seconds: f64) -> Self {
        Context { seconds: Some(seconds), ..self }
    }

    /// The context with load factors.
    pub fn with_factors(self, factors: &'a Factors) -> Self {
        Context { factors: Some(factors), ..self }
    }

    /// The context with the origin of the ground's constants.
    pub fn with_ground(self, ground: &'a Ground) -> Self {
        Context { ground: Some(ground), ..self }
    }

    /// The context with limits of checks.
    pub fn with_limits(self, limits: &'a Limits) -> Self {
        Context { limits: Some(limits), ..self }
    }

    /// The title on one line, without control characters for terminals and invalid XML characters.
    pub(crate) fn clean_title(&self) -> Option<String> {
        self.title.map(clean).filter(|title| !title.is_empty())
    }
}

/// Text of a file on one line, without control characters for terminals and invalid XML characters.
pub(crate) fn clean(words: &str) -> String {
    printable(&words.split_whitespace().collect::<Vec<_>>().join(" ")).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_in_titles_are_escaped() {
        let context = Context::new(Units::SI).with_title(" a\u{1b}[31m\tb\n ");
        assert_eq!(context.clean_title().as_deref(), Some(r"a\u{1b}[31m b"));
        assert_eq!(Context::new(Units::SI).with_title(" \n").clean_title(), None);
    }
}
