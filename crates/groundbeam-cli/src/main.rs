//! The program `groundbeam` reads model files and writes reports. It connects `groundbeam_file`, `groundbeam`
//! and `groundbeam_report`.

mod check;
mod colour;
mod compare;
mod distinct;
mod failure;
mod host;
mod input;
mod output;
mod pages;
mod request;
#[cfg(feature = "serve")]
mod serve;
mod solve;
mod starter;
mod status;
#[cfg(feature = "study")]
mod study;
mod typed;
mod verify;
mod waiting;

use clap::Parser;
use failure::Failure;
use request::Request;
use status::Status;
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

fn run(request: Request) -> Result<Status, Failure> {
    match request {
        Request::Solve(solve) => solve::run(&solve),
        Request::Check(check) => check::run(&check),
        Request::Verify(verify) => verify::run(&verify),
        Request::Compare(compare) => compare::run(&compare),
        Request::New(new) => starter::run(&new),
        #[cfg(feature = "serve")]
        Request::Serve(serve) => serve::run(&serve),
        #[cfg(feature = "study")]
        Request::Study(study) => study::run(&study),
        #[cfg(feature = "study")]
        Request::Merge(merge) => study::merge(&merge),
        Request::Schema { study } => pages::schema(study),
        Request::Completions(shell) => pages::completions(shell),
        Request::Manual => pages::manual(),
    }
}
