//! A train's passage over a beam, as it is reported.

use groundbeam::Field;
use groundbeam::train::{Located, Passage};

/// A train that passed over a beam.
#[derive(Debug, Clone, Copy)]
pub struct Moving<'a> {
    /// What it is called.
    pub name: &'a str,
    /// The set of a code of practice it is of.
    pub set: Option<&'a str>,
    /// What its loads were multiplied by.
    pub factor: f64,
    /// From where to where its first axle went.
    pub range: [f64; 2],
    /// What came out.
    pub passage: &'a Passage,
}

/// Even steps of the envelope in documents and tables.
const EVEN_STEPS: usize = 100;

impl Moving<'_> {
    /// Sections at which the envelope is listed if nobody says.
    pub fn default_stations(&self) -> Vec<f64> {
        self.passage.stations(EVEN_STEPS)
    }

    /// The moment that is largest in size, and where the train then stands.
    pub(crate) fn largest_moment(&self) -> Option<Located> {
        let [min, max] = self.passage.range(Field::Moment)?;
        Some(if max.value >= -min.value { max } else { min })
    }

    /// `solved`, or what is missing.
    pub(crate) fn status(&self) -> &'static str {
        if !self.passage.without_equilibrium().is_empty() {
            "no-equilibrium"
        } else if self.passage.not_converged().next().is_some() {
            "not-converged"
        } else {
            "solved"
        }
    }
}
