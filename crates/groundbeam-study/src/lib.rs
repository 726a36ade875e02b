//! Studies: one model under many grounds and loads, drawn at random or given, and what follows for probabilities.
//!
//! | module | holds |
//! |---|---|
//! | [`Draws`] | sample i of a study: its numbers, which depend on the seed and on i alone |
//! | [`Wanted`], [`Row`] | what is kept of an answer |
//! | [`run()`] | the samples solved, part by part, and written so that nothing is lost or done twice |
//! | [`merge()`] | parts and shards put together |
//! | [`verify()`] | a file of results compared with its checksums |
//! | [`summary()`] | probabilities with their intervals, means and quantiles |
//!
//! A study file is read by [`groundbeam_file::study`].

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
