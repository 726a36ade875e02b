//! Name, short texts and tone (good, doubtful or bad) of each verdict on equilibrium.

use crate::tone::Tone;
use groundbeam::Verdict;

/// The words for a verdict.
pub(crate) struct Wording {
    /// Name of the verdict in documents.
    pub name: &'static str,
    /// The verdict in a few words, such as `exactly one`. The reason for the verdict is printed after these
    /// words.
    pub words: &'static str,
    /// Words for the verdict in a cell of a narrow table.
    pub short: &'static str,
    /// Words for the verdict as a heading in a calculation report.
    pub head: &'static str,
    pub tone: Tone,
}

impl Wording {
    const fn new([name, words, short, head]: [&'static str; 4], tone: Tone) -> Self {
        Wording { name, words, short, head, tone }
    }

    /// The verdict followed by its reason, such as `exactly one: the resultant, …`.
    pub fn with(&self, reason: &str) -> String {
        format!("{}: {reason}", self.words)
    }
}

/// The words for a verdict.
pub(crate) fn wording(verdict: Verdict) -> Wording {
    match verdict {
        Verdict::Unique => {
            Wording::new(["unique", "exactly one", "one", "In equilibrium"], Tone::Good)
        }
        Verdict::NotUnique(_) => Wording::new(
            ["not-unique", "not unique", "not unique", "Equilibrium not unique"],
            Tone::Doubtful,
        ),
        Verdict::Local(_) => {
            Wording::new(["local", "local", "local", "Local equilibrium"], Tone::Doubtful)
        }
        Verdict::None(_) => Wording::new(["none", "none", "none", "No equilibrium"], Tone::Bad),
        Verdict::Buckles(_) => {
            Wording::new(["none", "none", "none: it buckles", "It buckles"], Tone::Bad)
        }
    }
}

/// The name of a verdict in documents: `unique`, `not-unique`, `local` or `none`.
pub fn verdict_name(verdict: Verdict) -> &'static str {
    wording(verdict).name
}
