//! Progress of a study, reported to a caller that may stop it.

use std::ops::ControlFlow;

/// The present stage of the work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// Existing results are verified against their checksums.
    Verifying,
    /// Samples are solved.
    Solving,
    /// Parts are merged.
    Merging,
    /// Results are read for the summary.
    Summarizing,
}

/// The progress of the work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// The present stage.
    pub stage: Stage,
    /// Amount of work done: samples verified; samples solved, including those of earlier runs; samples
    /// merged; columns of row groups read.
    pub done: u64,
    /// Amount of work that was done before this run.
    pub before: u64,
    /// Total amount of work.
    pub of: u64,
}

/// A callback that receives the progress and may stop the work.
pub type Watch<'a> = dyn FnMut(Progress) -> ControlFlow<()> + 'a;
