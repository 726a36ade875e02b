//! Reports the progress of a study to a caller that may stop the study.

use std::ops::ControlFlow;

/// The present stage of a study.
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
    /// Number of completed units of work, with those of earlier runs. In the summary, a unit is a column of a row
    /// group. In other stages, it is a sample.
    pub done: u64,
    /// Number of units of work that were completed before this run.
    pub before: u64,
    /// Total amount of work.
    pub of: u64,
}

/// A callback that receives the progress and may stop the work.
pub type Watch<'a> = dyn FnMut(Progress) -> ControlFlow<()> + 'a;
