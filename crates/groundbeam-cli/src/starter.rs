//! The command `groundbeam new`: writes starter model files.

use crate::command::{New, Starter};
use crate::failure::Failure;
use crate::output::print;
use crate::status::Status;
use groundbeam_file::printable;
use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};

/// Writes a commented model file, unless the file exists.
pub fn run(request: &New) -> Result<Status, Failure> {
    let path = &request.file;
    let opened = OpenOptions::new().write(true).create_new(true).open(path);
    let written = opened.and_then(|mut file| file.write_all(text(request.kind).as_bytes()));
    let shown = printable(&path.to_string_lossy()).into_owned();
    match written {
        Ok(()) => {
            print(&format!("wrote {shown}; next: groundbeam solve {shown}\n"))?;
            Ok(Status::Done)
        }
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {
            Err(Failure::usage(format!("`{shown}` exists already and is not replaced")))
        }
        Err(error) => Err(Failure::file(path, &error)),
    }
}

fn text(kind: Starter) -> &'static str {
    match kind {
        Starter::Footing => include_str!("../starters/footing.toml"),
        Starter::Rail => include_str!("../starters/rail.toml"),
        Starter::Slab => include_str!("../starters/slab.toml"),
        Starter::Pipeline => include_str!("../starters/pipeline.toml"),
    }
}
