//! Contains the results of a probabilistic study for reports: probabilities of events, and distributions.

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
    /// Fraction of the variance of the random fields that their truncated series retain; `None` without
    /// random fields.
    pub variance: Option<f64>,
    /// Number of samples with a certified result.
    pub solved: u64,
    /// Number of samples without equilibrium.
    pub without_equilibrium: u64,
    /// Number of samples without a certified result.
    pub not_converged: u64,
    /// Number of samples with an invalid model.
    pub wrong: u64,
    /// Largest energy gap of all certificates, relative to the strain energy.
    pub largest_gap: f64,
    /// Estimated probabilities of events.
    pub events: Vec<Estimate>,
    /// Distributions of the random inputs and of the results.
    pub spreads: Vec<Spread>,
}

/// Estimated probability of an event.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Estimate {
    /// Name of the event.
    pub name: String,
    /// The limit above or below which the event occurs; `None` for an event without a limit.
    #[serde(flatten)]
    pub limit: Option<Limit>,
    /// Number of samples in which the event occurs.
    pub count: u64,
    /// Fraction of the samples in which the event occurs.
    pub probability: f64,
    /// 95 % confidence interval of the probability.
    pub interval: Interval,
}

/// A limit of a quantity.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Limit {
    /// Name of the limited quantity. The distribution of its values in the study has the same name.
    pub quantity: String,
    /// Whether the event occurs above the limit. Otherwise the event occurs below the limit.
    pub above: bool,
    /// Value of the limit.
    pub limit: f64,
}

/// A confidence interval.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Interval {
    /// Lower and upper bound of the confidence interval.
    pub bounds: [f64; 2],
    /// Method by which the confidence interval was computed.
    pub by: Way,
}

impl Interval {
    /// Number of significant digits of the bounds. It is chosen so that the width of the interval has two
    /// digits.
    pub(crate) fn digits(&self) -> usize {
        let [low, high] = self.bounds;
        let digits = 2.0 + (high / (high - low)).log10().ceil();
        // `digits` is NaN if both bounds are zero.
        if digits >= 3.0 { digits.min(6.0) as usize } else { 3 }
    }
}

/// Method of a confidence interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Way {
    /// Method of Clopper and Pearson. It uses the number of occurrences and is exact for any probability.
    #[serde(rename = "exact for independent samples (Clopper and Pearson)")]
    Counts,
    /// Method with Student's t distribution. It uses the number of occurrences in each independent replicate.
    #[serde(rename = "the scatter of replicates (Student's t)")]
    Replicates,
}

impl Way {
    /// Name of the method of the confidence interval.
    pub fn words(self) -> &'static str {
        match self {
            Way::Counts => "exact for independent samples (Clopper and Pearson)",
            Way::Replicates => "the scatter of replicates (Student's t)",
        }
    }
}

/// Distribution of a quantity over the samples in which the quantity exists.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Spread {
    /// Name of the quantity's column in the results.
    pub name: String,
    /// Physical quantity, which determines the unit; `None` for plain numbers.
    #[serde(skip)]
    pub kind: Option<Kind>,
    /// Mean of the quantity.
    pub mean: f64,
    /// Standard deviation of the quantity.
    pub deviation: f64,
    /// Minimum, 5 % quantile, median, 95 % quantile and maximum.
    pub quantiles: [f64; 5],
    /// Histogram: number of samples in each of several equal intervals between the minimum and the maximum.
    pub histogram: Vec<u64>,
}

impl Spread {
    /// Label of the quantity in reports.
    pub(crate) fn label(&self) -> String {
        match &*self.name {
            "left" | "right" => format!("{} end force", self.name),
            name => clean(&name.replace('_', " ")),
        }
    }

    /// Largest magnitude of the quantity, which determines its unit.
    pub(crate) fn largest(&self) -> f64 {
        let [least, .., most] = self.quantiles;
        least.abs().max(most.abs())
    }
}
