//! The reason why an answer is not proven.

use std::fmt;

/// The reason why an answer is not proven.
#[derive(Debug, Clone, PartialEq)]
pub struct NotProven {
    /// The reason.
    pub what: String,
    /// Position on the beam \[m\] to which the reason refers; `None` for a reason without a position.
    pub at: Option<f64>,
}

impl NotProven {
    /// Creates a reason that refers to no position on the beam.
    pub fn new(what: impl Into<String>) -> Self {
        NotProven { what: what.into(), at: None }
    }

    /// Adds a position \[m\] to the reason.
    pub fn at(self, at: f64) -> Self {
        NotProven { at: Some(at), ..self }
    }
}

impl fmt::Display for NotProven {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.at {
            Some(at) => write!(f, "{} (at {at})", self.what),
            None => write!(f, "{}", self.what),
        }
    }
}

impl std::error::Error for NotProven {}

#[cfg(test)]
mod tests {
    use super::NotProven;

    #[test]
    fn a_reason_is_written_with_its_position() {
        assert_eq!(NotProven::new("a reason").to_string(), "a reason");
        assert_eq!(NotProven::new("a reason").at(2.5).to_string(), "a reason (at 2.5)");
    }
}
