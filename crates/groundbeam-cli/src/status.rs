//! The exit status of the program.

use groundbeam_run::Overall;
use std::process::ExitCode;

/// The exit status of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// Solved, or whatever else was asked for is done.
    Done = 0,
    /// The input or the command line is wrong.
    Wrong = 2,
    /// The model is right and has no equilibrium.
    NoEquilibrium = 3,
    /// The solver did not meet its own tolerance.
    NotConverged = 4,
    /// Stopped from the keyboard; what is done is kept.
    Interrupted = 130,
}

impl From<Overall> for Status {
    fn from(overall: Overall) -> Self {
        match overall {
            Overall::Solved => Status::Done,
            Overall::NoEquilibrium => Status::NoEquilibrium,
            Overall::NotConverged => Status::NotConverged,
        }
    }
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> Self {
        ExitCode::from(status as u8)
    }
}
