//! The exit status of the program.

use groundbeam_run::Overall;
use std::process::ExitCode;

/// The exit status of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// The model is solved, or the requested action is done.
    Done,
    /// A result is not proven, or a check is undecided.
    NotProven,
    /// A design check fails, or it has no verdict, for example because the loads have no resultant.
    CheckFailed,
    /// The input or the command line is wrong.
    Wrong,
    /// The model is valid, but has no equilibrium.
    NoEquilibrium,
    /// The result is proven for the model in the result document, but not for the model file.
    ProvenForDocument,
    /// The solver did not reach its tolerance.
    NotConverged,
    /// The user stopped a study from the keyboard. Completed samples are saved.
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
    /// Returns the number of the exit status.
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
