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
    /// Units of the printed numbers, and the number of their digits.
    pub units: Units,
    /// Duration of the solve \[s\]; `None` if it was not measured.
    pub seconds: Option<f64>,
    /// Load factors; `None` if they are not requested.
    pub factors: Option<&'a Factors>,
    /// Data from which the ground constants k and μ were computed; `None` if the file gives k and μ per length
    /// of the beam.
    pub ground: Option<&'a Ground>,
    /// Limits of the design checks; `None` if no checks are requested.
    pub limits: Option<&'a Limits>,
    /// Total number of straight segments that replace the curve of all settlement troughs in the initial gap;
    /// `None` without troughs.
    pub chords: Option<usize>,
    /// Digest of the model file and of the tables that it names, from [`model_digest`](crate::model_digest);
    /// `None` if the model does not come from a file.
    pub digest: Option<&'a str>,
    /// The selected combination, if it is solved alone; `None` for the model as written.
    pub combination: Option<&'a Combination>,
    /// Whether the file has more combinations than the requested ones.
    pub selected: bool,
    /// Whether the result document contains the piecewise polynomials of the solution, which the proof needs.
    pub pieces: bool,
    /// Whether the result document contains the model. The proof uses this model if the proof's own file reader
    /// does not support the model file.
    pub model: bool,
    /// Depth of the cross-section along the beam, which pictures show; empty if the depth is not known.
    pub depths: &'a [Depth],
    /// Warnings about the file.
    pub warnings: &'a [Diagnostic],
    /// Proof of each result, in the order of the results; empty if no proof is requested.
    pub proofs: &'a [Named],
}

impl<'a> Context<'a> {
    /// Returns a context with the data of a model file, such as the title, the units and the warnings.
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

    /// Returns a context that contains only units.
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

    /// Sets the duration of the solve \[s\].
    pub fn with_seconds(self, seconds: f64) -> Self {
        Context { seconds: Some(seconds), ..self }
    }

    /// Sets the load factors.
    pub fn with_factors(self, factors: &'a Factors) -> Self {
        Context { factors: Some(factors), ..self }
    }

    /// Sets the data from which the ground constants k and μ were computed.
    pub fn with_ground(self, ground: &'a Ground) -> Self {
        Context { ground: Some(ground), ..self }
    }

    /// Sets the limits of the design checks.
    pub fn with_limits(self, limits: &'a Limits) -> Self {
        Context { limits: Some(limits), ..self }
    }

    /// The title on one line, with control characters and invalid XML characters escaped; `None` without a
    /// title.
    pub(crate) fn clean_title(&self) -> Option<String> {
        self.title.map(clean).filter(|title| !title.is_empty())
    }
}

/// Returns a text on one line, with control characters and invalid XML characters escaped.
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
