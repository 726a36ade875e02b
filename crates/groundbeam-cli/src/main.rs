//! The program `groundbeam`: model files in, reports out. A thin shell around `groundbeam_file`,
//! `groundbeam` and `groundbeam_report`.

mod check;
mod combinations;
mod compare;
mod distinct;
mod failure;
mod input;
mod output;
mod pages;
mod request;
mod serve;
mod solve;
mod starter;
mod study;
mod trains;
mod typed;
mod waiting;

use clap::Parser;
use failure::Failure;
use groundbeam_report::Overall;
use request::Request;
use std::process::ExitCode;

fn main() -> ExitCode {
    let typed = match typed::Typed::try_parse() {
        Ok(typed) => typed,
        Err(error) => return failure::usage(&error),
    };
    match Request::of(typed).and_then(run) {
        Ok(status) => status.into(),
        Err(failure) => failure.report(),
    }
}

/// What the program says to the one who called it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Status {
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

fn run(request: Request) -> Result<Status, Failure> {
    match request {
        Request::Solve(solve) => solve::run(&solve),
        Request::Check(check) => check::run(&check),
        Request::Compare(compare) => compare::run(&compare),
        Request::New(new) => starter::run(&new),
        Request::Serve(serve) => serve::run(&serve),
        Request::Study(study) => study::run(&study),
        Request::Merge(merge) => study::merge(&merge),
        Request::Completions(shell) => pages::completions(shell),
        Request::Manual => pages::manual(),
    }
}
