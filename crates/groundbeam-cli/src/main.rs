//! The program `groundbeam` reads model files and writes reports. It connects `groundbeam_file`, `groundbeam`
//! and `groundbeam_report`.

mod check;
mod colour;
mod command;
mod compare;
mod distinct;
mod failure;
mod host;
mod input;
mod option_value;
mod output;
mod pages;
#[cfg(feature = "serve")]
mod serve;
mod solve;
mod starter;
mod status;
#[cfg(feature = "study")]
mod study;
mod verify;
mod waiting;

use clap::Parser;
use command::{Command, CommandLine};
use failure::Failure;
use status::Status;
use std::process::ExitCode;

fn main() -> ExitCode {
    let line = match CommandLine::try_parse() {
        Ok(line) => line,
        Err(error) => return failure::usage(&error),
    };
    match run(&line.command) {
        Ok(status) => status.into(),
        Err(failure) => failure.report(),
    }
}

fn run(command: &Command) -> Result<Status, Failure> {
    match command {
        Command::Solve(solve) => solve::run(solve),
        Command::Check(check) => check::run(check),
        Command::Verify(verify) => verify::run(verify),
        Command::Compare(compare) => compare::run(compare),
        Command::New(new) => starter::run(new),
        #[cfg(feature = "serve")]
        Command::Serve(serve) => serve::run(serve),
        #[cfg(feature = "study")]
        Command::Study(study) => study::run(study),
        #[cfg(feature = "study")]
        Command::Merge(merge) => study::merge(merge),
        Command::Schema { study } => pages::schema(*study),
        Command::Completions { shell } => pages::completions(*shell),
        Command::Man => pages::manual(),
    }
}
