//! How words are marked: good, doubtful, bad.

/// How words are marked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Tone {
    Plain,
    Heading,
    Good,
    Doubtful,
    Bad,
}

impl Tone {
    /// In calculation reports.
    pub fn name(self) -> &'static str {
        match self {
            Tone::Plain | Tone::Heading => "plain",
            Tone::Good => "good",
            Tone::Doubtful => "doubtful",
            Tone::Bad => "bad",
        }
    }

    /// The escape sequence of a terminal.
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
