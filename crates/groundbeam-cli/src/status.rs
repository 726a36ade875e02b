//! The exit status of the program.

use groundbeam_run::Overall;
use std::process::ExitCode;

/// The exit status of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// Solved, or the requested action is done.
    Done,
    /// Something is not proven.
    NotProven,
    /// A check fails or is not judged.
    CheckFailed,
    /// The input or the command line is wrong.
    Wrong,
    /// The model is valid, but has no equilibrium.
    NoEquilibrium,
    /// Proven only for the model in the document.
    ProvenForDocument,
    /// The solver did not reach its own tolerance.
    NotConverged,
    /// Stopped from the keyboard; completed samples are saved.
    Interrupted,
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

impl Status {
    /// Number of the status.
    pub fn code(self) -> u8 {
        match self {
            Status::Done => 0,
            Status::NotProven | Status::CheckFailed => 1,
            Status::Wrong => 2,
            Status::NoEquilibrium | Status::ProvenForDocument => 3,
            Status::NotConverged => 4,
            Status::Interrupted => 130,
        }
    }
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> Self {
        ExitCode::from(status.code())
    }
}
