//! The results of a study as reported.

use crate::context::clean;
use crate::quantity::Kind;
use serde::Serialize;

/// What a study has found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Study {
    /// What its file calls it.
    pub title: Option<String>,
    /// How many samples there are.
    pub samples: u64,
    /// From which all random numbers follow.
    pub seed: u64,
    /// How samples are spread: `monte-carlo`, `latin-hypercube`, `sobol`.
    pub sampling: &'static str,
    /// Into how many parts they are divided that are drawn independently; 1: every sample is independent.
    pub replicates: u64,
    /// Of how many independent numbers a sample is made.
    pub dimensions: usize,
    /// The share of the random fields' variance that is not cut off; none without fields.
    pub variance: Option<f64>,
    /// Samples with a certified answer.
    pub solved: u64,
    /// Samples that have no equilibrium.
    pub without_equilibrium: u64,
    /// Samples of which no answer was certified.
    pub not_converged: u64,
    /// Samples of which the model was refused.
    pub wrong: u64,
    /// The largest gap of all certificates, of the strain energy.
    pub largest_gap: f64,
    /// How probable events are.
    pub events: Vec<Estimate>,
    /// How random numbers and results scatter.
    pub spreads: Vec<Spread>,
}

/// How probable something is.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Estimate {
    /// What may happen.
    pub name: String,
    /// What it is that a number exceeds a limit; none of what is always told.
    #[serde(flatten)]
    pub limit: Option<Limit>,
    /// In how many samples it has.
    pub count: u64,
    /// The part of the samples in which it has.
    pub probability: f64,
    /// Between which bounds the probability lies, with a confidence of 95 %.
    pub interval: Interval,
}

/// What a number must not exceed, or fall below.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Limit {
    /// The name of the number's spread.
    pub quantity: String,
    /// Whether too much of it is what happens; otherwise too little.
    pub above: bool,
    /// The limit.
    pub limit: f64,
}

/// An interval of confidence.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Interval {
    /// From and to.
    pub bounds: [f64; 2],
    /// How it was found.
    pub by: Way,
}

impl Interval {
    /// With how many significant digits its bounds are written, so that two of them tell its width.
    pub(crate) fn digits(&self) -> usize {
        let [low, high] = self.bounds;
        let digits = 2.0 + (high / (high - low)).log10().ceil();
        // Not a number where both are zero.
        if digits >= 3.0 { digits.min(6.0) as usize } else { 3 }
    }
}

/// How an interval of confidence is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Way {
    /// From how often it happened, whatever the probability is.
    #[serde(rename = "exact for independent samples (Clopper and Pearson)")]
    Counts,
    /// From how often it happened in each part that was drawn independently.
    #[serde(rename = "the scatter of replicates (Student's t)")]
    Replicates,
}

impl Way {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Way::Counts => "exact for independent samples (Clopper and Pearson)",
            Way::Replicates => "the scatter of replicates (Student's t)",
        }
    }
}

/// How a number scatters over the samples that have it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Spread {
    /// The column of the results.
    pub name: String,
    /// What it measures, so that it has a unit; none of plain numbers.
    #[serde(skip)]
    pub kind: Option<Kind>,
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// The smallest, the quantiles of 5, 50 and 95 %, the largest.
    pub quantiles: [f64; 5],
    /// How many samples lie in each of so many equal parts, from the smallest to the largest.
    pub histogram: Vec<u64>,
}

impl Spread {
    /// As people read it.
    pub(crate) fn label(&self) -> String {
        match &*self.name {
            "left" | "right" => format!("{} end force", self.name),
            name => clean(&name.replace('_', " ")),
        }
    }

    /// The size of its largest value, by which its unit is chosen.
    pub(crate) fn largest(&self) -> f64 {
        let [least, .., most] = self.quantiles;
        least.abs().max(most.abs())
    }
}
