//! Runs the command `groundbeam new`, which writes a starter model file.

use crate::command::{New, Starter};
use crate::failure::Failure;
use crate::output::print;
use crate::status::Status;
use groundbeam_file::printable;
use std::fs::{OpenOptions, remove_file};
use std::io::{ErrorKind, Write};
use std::path::Path;

/// Writes a commented model file. An existing file is not replaced.
pub fn run(request: &New) -> Result<Status, Failure> {
    let path = &request.file;
    let opened = OpenOptions::new().write(true).create_new(true).open(path);
    let written = opened.and_then(|mut file| {
        let written = file.write_all(text(request.kind).as_bytes());
        if written.is_err() {
            // An incomplete file would prevent the next attempt, so it is removed. Only the error of the write is
            // reported.
            let _ = remove_file(path);
        }
        written
    });
    let shown = printable(&path.to_string_lossy()).into_owned();
    match written {
        Ok(()) => {
            print(&format!("wrote {shown}; next: groundbeam solve {}\n", argument(path)))?;
            Ok(Status::Done)
        }
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {
            Err(Failure::usage(format!("`{shown}` exists already and is not replaced")))
        }
        Err(error) => Err(Failure::file(path, &error)),
    }
}

/// Returns the path as an argument of a shell command.
fn argument(path: &Path) -> String {
    let name = path.to_string_lossy();
    // A path with a leading `-` would be read as an option or as standard input.
    let name = if name.starts_with('-') { format!("./{name}") } else { name.into_owned() };
    let is_plain = |c: char| c.is_alphanumeric() || "-_./\\:+,@%".contains(c);
    let name = printable(&name);
    if name.chars().all(is_plain) {
        name.into_owned()
    } else {
        format!("'{}'", name.replace('\'', "'\\''"))
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
