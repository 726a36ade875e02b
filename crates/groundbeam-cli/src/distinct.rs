//! Refuses output files that would replace each other or an input file, before the run starts.

use crate::failure::Failure;
use groundbeam_file::output::{Identity, Target};
use std::io;
use std::path::Path;

/// Name of an option that writes a file, and the path of this file.
pub type Output<'a> = (&'static str, &'a Path);

/// Checks that all outputs are different files, and that no output is an input file.
pub fn check<'a>(
    outputs: impl IntoIterator<Item = Output<'a>>,
    inputs: impl IntoIterator<Item = &'a Path>,
) -> Result<(), Failure> {
    let mut faults = Vec::new();
    let mut taken: Vec<(Identity, String)> = Vec::new();
    for input in inputs {
        let shown = format!("the input {}", input.display());
        let input = if input.as_os_str() == "-" { Path::new("/dev/stdin") } else { input };
        // A pipe, a device or a deleted file has no identity, and an output file cannot overwrite it.
        if let Ok(Some(identity)) = Identity::of(input) {
            taken.push((identity, shown));
        }
    }
    // If standard output is redirected to a file, no output of the program may replace this file.
    if let Ok(Some(identity)) = Identity::of(Path::new("/dev/stdout")) {
        taken.push((identity, "standard output".to_owned()));
    }
    for (option, path) in outputs {
        let shown = format!("{option} {}", path.display());
        match identity(path) {
            Err(error) => faults.push(format!("{shown}: {error}")),
            Ok(None) => {}
            Ok(Some(identity)) => match taken.iter().find(|(other, _)| *other == identity) {
                Some((_, other)) => faults.push(format!(
                    "{shown}: this is the same file as {other}, and would replace it; name another file"
                )),
                None => taken.push((identity, shown)),
            },
        }
    }
    match faults.len() {
        0 => Ok(()),
        _ => Err(Failure::together(&faults.into_iter().map(Failure::usage).collect::<Vec<_>>())),
    }
}

/// Returns the [`Identity`] of the file that an output would replace or create, or `None` for a device, a pipe or a
/// standard stream.
fn identity(path: &Path) -> io::Result<Option<Identity>> {
    match Target::of(path)? {
        Target::File(_) => Identity::of(path),
        _ => Ok(None),
    }
}
