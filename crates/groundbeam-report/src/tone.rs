//! Tones that mark text as good, doubtful or bad.

/// The tone of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Tone {
    Plain,
    Heading,
    Good,
    Doubtful,
    Bad,
}

impl Tone {
    /// Name of the mark that calculation reports give to a text: plain, good, doubtful or bad.
    pub fn name(self) -> &'static str {
        match self {
            Tone::Plain | Tone::Heading => "plain",
            Tone::Good => "good",
            Tone::Doubtful => "doubtful",
            Tone::Bad => "bad",
        }
    }

    /// Terminal escape sequence that prints text in this tone; empty for plain text.
    pub fn code(self) -> &'static str {
        match self {
            Tone::Plain => "",
            Tone::Heading => "\u{1b}[1m",
            Tone::Good => "\u{1b}[1;32m",
            Tone::Doubtful => "\u{1b}[1;33m",
            Tone::Bad => "\u{1b}[1;31m",
        }
    }
}
