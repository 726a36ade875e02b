//! What the command line says about itself: completion scripts and the manual page.

use crate::Status;
use crate::failure::Failure;
use crate::output::print;
use crate::typed::Typed;
use clap::CommandFactory;
use clap_complete::Shell;

pub fn completions(shell: Shell) -> Result<Status, Failure> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Typed::command(), "groundbeam", &mut script);
    print(&String::from_utf8_lossy(&script))?;
    Ok(Status::Done)
}

/// The program and its commands, one after the other, as one page.
pub fn manual() -> Result<Status, Failure> {
    let mut page = Vec::new();
    let written = clap_mangen::Man::new(Typed::command()).render(&mut page);
    written.map_err(|error| Failure::usage(error.to_string()))?;
    print(&String::from_utf8_lossy(&page))?;
    Ok(Status::Done)
}
