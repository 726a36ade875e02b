//! Stores results as Parquet: one row per sample, with the study, the model, the seed and checksums in the
//! metadata.

mod checksum;
mod column;
mod merge;
mod parts;
mod read;
mod table;
mod write;

pub(crate) use column::Column;
pub use merge::{Merged, merge};
pub(crate) use parts::Parts;
pub(crate) use read::Whole;
pub use read::verify;
pub(crate) use table::{Head, Table};

use parquet::errors::ParquetError;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// The reason why results cannot be stored or read.
#[derive(Debug)]
pub enum StoreError {
    /// A file cannot be read or written.
    File(PathBuf, String),
    /// A file of results is damaged; the text describes the damage.
    Damaged(PathBuf, String),
    /// The existing results belong to another study.
    Foreign(PathBuf),
    /// Another process works on the same study.
    Busy(PathBuf),
    /// The files to be merged do not form one study; the text gives the reason.
    Unlike(String),
    /// The progress callback `watch` stopped the work.
    Stopped,
}

impl StoreError {
    fn io(path: &Path, error: &io::Error) -> Self {
        StoreError::File(path.to_owned(), error.to_string())
    }

    fn parquet(path: &Path, error: &ParquetError) -> Self {
        StoreError::File(path.to_owned(), error.to_string())
    }
}

impl fmt::Display for StoreError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StoreError::File(path, what) => write!(f, "{}: {what}", path.display()),
            StoreError::Damaged(path, what) => write!(
                f,
                "{}: {what} are damaged: the checksum differs from the one that was written; delete this file and \
                 run the study again, which computes its samples again",
                path.display()
            ),
            StoreError::Foreign(path) => write!(
                f,
                "{}: these results are of another study, model, survey, seed or version of the program; \
                 name another file, or start again with the option `restart`",
                path.display()
            ),
            StoreError::Busy(path) => {
                write!(
                    f,
                    "{}: another process is writing these results; wait until it ends",
                    path.display()
                )
            }
            StoreError::Unlike(what) => f.write_str(what),
            StoreError::Stopped => f.write_str("stopped"),
        }
    }
}

impl std::error::Error for StoreError {}
