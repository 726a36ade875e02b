//! Runs studies: solves one model many times with random or given ground parameters and loads, and estimates probabilities.
//!
//! | item | purpose |
//! |---|---|
//! | [`Draws`] | random numbers of sample i, which depend only on the seed and on i |
//! | [`Wanted`], [`Row`] | stored values of a solution |
//! | [`run()`] | solves the samples part by part, and can be resumed |
//! | [`merge()`] | merges parts and shards |
//! | [`verify()`] | compares a file of results with its checksums |
//! | [`summary()`] | computes probabilities with confidence intervals, means and quantiles |
//!
//! [`groundbeam_file::study`] reads a study file.

#![forbid(unsafe_code)]
#![deny(missing_docs)]

mod distribution;
mod draws;
mod fields;
mod interval;
mod points;
mod progress;
mod row;
mod run;
mod statistics;
mod store;
mod summary;
mod symmetric;

pub use draws::{Draw, Draws, Impossible};
pub use progress::{Progress, Stage, Watch};
pub use row::{Row, Status, Trouble, Wanted};
pub use run::{Finished, Shard, digest, is_done, run};
pub use store::{Merged, StoreError, merge, verify};
pub use summary::summary;
