//! Violations of the rules of a model, each with the part of the model, a message and the remedy.

use super::Profile;
use std::fmt;

/// Part of the model that a [`Problem`] concerns. Indices count from 0 in the order given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Part {
    /// The beam itself.
    Beam,
    /// Segment of the beam, by its index.
    BeamSegment(usize),
    /// The foundation itself.
    Foundation,
    /// Segment of the foundation, by its index.
    FoundationSegment(usize),
    /// Load, by its index.
    Load(usize),
    /// Support, by its index.
    Support(usize),
    /// Hinge, by its index.
    Hinge(usize),
    /// Corner of the initial gap, by its index.
    Gap(usize),
}

/// Violation of a rule of a model. `message` and `hint` contain `{0}`, `{1}`, … in place of the positions in `numbers`.
/// [`Problem::fill`] inserts these positions in any unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
    /// A fixed code, one for each rule, such as `GB101`.
    pub code: &'static str,
    /// The part of the model.
    pub part: Part,
    /// Name of the field of `part` in the model: `length`, `at`, `from`, `spring`, …
    pub field: &'static str,
    /// The fault as text.
    pub message: String,
    /// The remedy.
    pub hint: String,
    /// Positions \[m\] that `message` and `hint` refer to as `{0}`, `{1}`, …
    pub numbers: Vec<f64>,
}

impl Problem {
    pub(super) fn new(
        code: &'static str,
        part: Part,
        field: &'static str,
        message: impl Into<String>,
        hint: impl Into<String>,
    ) -> Self {
        Problem { code, part, field, message: message.into(), hint: hint.into(), numbers: vec![] }
    }

    pub(super) fn with_numbers(mut self, numbers: &[f64]) -> Self {
        self.numbers = numbers.to_vec();
        self
    }

    /// Replaces `{0}`, `{1}`, … in `text` by the entries of `numbers`, which are positions along the beam. `write`
    /// formats each of these positions.
    pub fn fill(&self, text: &str, write: impl Fn(f64) -> String) -> String {
        let mut filled = text.to_owned();
        for (i, &number) in self.numbers.iter().enumerate() {
            filled = filled.replace(&format!("{{{i}}}"), &write(number));
        }
        filled
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plain = |x: f64| x.to_string();
        write!(
            f,
            "[{}] {:?}, {}: {} ({})",
            self.code,
            self.part,
            self.field,
            self.fill(&self.message, plain),
            self.fill(&self.hint, plain)
        )
    }
}

/// Whether the square and the cube of a number are in the range of a double.
pub(crate) fn in_range(value: f64) -> bool {
    value == 0.0 || (value.is_finite() && (1e-60..=1e60).contains(&value.abs()))
}

pub(crate) fn describe(value: f64) -> String {
    if value.is_nan() {
        "not a number".into()
    } else if value.is_infinite() {
        "infinite".into()
    } else if value < 0.0 && in_range(value) {
        "negative".into()
    } else if value == 0.0 {
        "zero".into()
    } else {
        format!("{value:e}, outside the range of computable numbers")
    }
}

/// Returns the allowed range of numbers as the remedy if a finite value is out of this range. Otherwise returns the
/// rule.
pub(crate) fn remedy(value: f64, rule: &str) -> String {
    if value.is_finite() && !in_range(value) {
        "allowed values are 0 and magnitudes between 1e-60 and 1e60".into()
    } else {
        rule.into()
    }
}

pub(crate) fn positive(
    found: &mut Vec<Problem>,
    code: &'static str,
    part: Part,
    field: &'static str,
    value: f64,
    what: &str,
) {
    if !(in_range(value) && value > 0.0) {
        let message = format!("{what} is {}", describe(value));
        let hint = remedy(value, "it must be positive");
        found.push(Problem::new(code, part, field, message, hint));
    }
}

/// Requires that all control values of a quantity that varies along the beam are positive. Then the quantity is
/// positive everywhere.
pub(crate) fn positive_along(
    found: &mut Vec<Problem>,
    code: &'static str,
    part: Part,
    field: &'static str,
    profile: &Profile,
    what: &str,
) {
    let wrong = profile.control_values().iter().find(|value| !(in_range(**value) && **value > 0.0));
    if let Some(value) = wrong {
        positive(found, code, part, field, *value, what);
    }
}

pub(crate) fn finite(found: &mut Vec<Problem>, part: Part, field: &'static str, value: f64) {
    if !in_range(value) {
        let message = format!("the value is {}", describe(value));
        let hint = remedy(value, "give a finite number");
        found.push(Problem::new("GB302", part, field, message, hint));
    }
}

/// Requires that a load on the ground acts downward.
pub(crate) fn down(found: &mut Vec<Problem>, part: Part, field: &'static str, value: f64) {
    finite(found, part, field, value);
    if value < 0.0 {
        let message = "a load on the ground acts upward";
        let hint = "it must act downward";
        found.push(Problem::new("GB211", part, field, message, hint));
    }
}

/// Number of bytes, displayed in decimal units such as 4 GB or 2.5 MB.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bytes(pub u64);

impl fmt::Display for Bytes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let units =
            [(1e15, "PB"), (1e12, "TB"), (1e9, "GB"), (1e6, "MB"), (1e3, "kB"), (1.0, "bytes")];
        let bytes = self.0 as f64;
        let (size, unit) =
            units.into_iter().find(|(size, _)| bytes >= *size).unwrap_or((1.0, "bytes"));
        // A number below 10 is rounded to one decimal, a larger number to an integer.
        let scaled = bytes / size;
        let shown = if scaled < 10.0 { (scaled * 10.0).round() / 10.0 } else { scaled.round() };
        write!(f, "{shown} {unit}")
    }
}
