//! Results of a study for reports.

use crate::context::clean;
use crate::quantity::Kind;
use serde::Serialize;

/// Results of a study.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Study {
    /// Title in the study file.
    pub title: Option<String>,
    /// Number of samples.
    pub samples: u64,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Sampling method: `monte-carlo`, `latin-hypercube`, `sobol`.
    pub sampling: &'static str,
    /// Number of independent replicates; 1 if all samples are independent.
    pub replicates: u64,
    /// Number of independent random numbers per sample.
    pub dimensions: usize,
    /// Share of the random fields' variance after truncation; `None` without fields.
    pub variance: Option<f64>,
    /// Number of samples with a certified result.
    pub solved: u64,
    /// Number of samples without equilibrium.
    pub without_equilibrium: u64,
    /// Number of samples without a certified result.
    pub not_converged: u64,
    /// Number of samples with an invalid model.
    pub wrong: u64,
    /// Largest gap of all certificates, relative to the strain energy.
    pub largest_gap: f64,
    /// Estimated probabilities of events.
    pub events: Vec<Estimate>,
    /// Distributions of random numbers and results.
    pub spreads: Vec<Spread>,
}

/// Estimated probability of an event.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Estimate {
    /// Name of the event.
    pub name: String,
    /// The limit that decides the event; `None` for events that are always listed and have no limit.
    #[serde(flatten)]
    pub limit: Option<Limit>,
    /// Number of samples in which it occurs.
    pub count: u64,
    /// Fraction of the samples in which it occurs.
    pub probability: f64,
    /// 95 % confidence interval of the probability.
    pub interval: Interval,
}

/// A limit of a number.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Limit {
    /// Name of the number's distribution.
    pub quantity: String,
    /// Whether the event occurs above the limit; otherwise below.
    pub above: bool,
    /// The limit.
    pub limit: f64,
}

/// A confidence interval.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Interval {
    /// Lower and upper bound.
    pub bounds: [f64; 2],
    /// Method by which it was computed.
    pub by: Way,
}

impl Interval {
    /// Number of significant digits of its bounds, so that two digits show its width.
    pub(crate) fn digits(&self) -> usize {
        let [low, high] = self.bounds;
        let digits = 2.0 + (high / (high - low)).log10().ceil();
        // NaN if both are zero.
        if digits >= 3.0 { digits.min(6.0) as usize } else { 3 }
    }
}

/// Method of a confidence interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Way {
    /// From the number of occurrences, exact for any probability.
    #[serde(rename = "exact for independent samples (Clopper and Pearson)")]
    Counts,
    /// From the number of occurrences in each independent replicate.
    #[serde(rename = "the scatter of replicates (Student's t)")]
    Replicates,
}

impl Way {
    /// Name of the method.
    pub fn words(self) -> &'static str {
        match self {
            Way::Counts => "exact for independent samples (Clopper and Pearson)",
            Way::Replicates => "the scatter of replicates (Student's t)",
        }
    }
}

/// Distribution of a number over the samples that have it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Spread {
    /// Name of its column in the results.
    pub name: String,
    /// Its physical quantity, which determines the unit; `None` for plain numbers.
    #[serde(skip)]
    pub kind: Option<Kind>,
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// Minimum, quantiles of 5, 50 and 95 %, maximum.
    pub quantiles: [f64; 5],
    /// Histogram: number of samples in equal intervals from the minimum to the maximum.
    pub histogram: Vec<u64>,
}

impl Spread {
    /// Label for readers.
    pub(crate) fn label(&self) -> String {
        match &*self.name {
            "left" | "right" => format!("{} end force", self.name),
            name => clean(&name.replace('_', " ")),
        }
    }

    /// Magnitude of its largest value, which determines its unit.
    pub(crate) fn largest(&self) -> f64 {
        let [least, .., most] = self.quantiles;
        least.abs().max(most.abs())
    }
}
