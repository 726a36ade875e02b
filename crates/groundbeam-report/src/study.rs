//! What a study of many samples has found, as it is reported.

use groundbeam::Field;
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
    /// In how many samples it has.
    pub count: u64,
    /// The part of the samples in which it has.
    pub probability: f64,
    /// Between which bounds the probability lies, with a confidence of 95 %.
    pub interval: Interval,
}

/// An interval of confidence.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Interval {
    /// From and to.
    pub bounds: [f64; 2],
    /// How it was found.
    pub by: &'static str,
}

/// How a number scatters over the samples that have it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Spread {
    /// The column of the results.
    pub name: String,
    /// The field that it is a value of, so that it has a unit.
    #[serde(skip)]
    pub field: Option<Field>,
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// The smallest, the quantiles of 5, 50 and 95 %, the largest.
    pub quantiles: [f64; 5],
}
