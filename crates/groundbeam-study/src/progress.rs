//! Progress of a study, reported to a caller who may stop it.

use std::ops::ControlFlow;

/// What is being done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// Results that are there are verified against their checksums.
    Verifying,
    /// Samples are solved.
    Solving,
    /// Parts are put together.
    Merging,
    /// Results are read for the summary.
    Summarizing,
}

/// How far the work is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// What is being done.
    pub stage: Stage,
    /// How much of it is: samples that are verified; samples that are solved, those of earlier runs too; samples that are
    /// put together; columns of groups of samples that are read.
    pub done: u64,
    /// How much of it was when the work was begun.
    pub before: u64,
    /// How much there is to be.
    pub of: u64,
}

/// Is told how far the work is, and may stop it.
pub type Watch<'a> = dyn FnMut(Progress) -> ControlFlow<()> + 'a;
