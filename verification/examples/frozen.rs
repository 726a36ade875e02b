//! Compares the results of the present program with the frozen answers, or replaces the frozen answers.
//!
//! ```text
//! … --example frozen -- compare [--bits] [--folder FOLDER] [FAMILY …]
//! … --example frozen -- answer [--folder FOLDER] [FAMILY …]
//! ```
//!
//! `compare` lists the differences that exceed their bounds; with `--bits` it lists all numbers with different bits.
//! `answer` replaces the frozen answers and certificates by those of the present program.

use groundbeam::solve;
use groundbeam_verification::frozen::{self, Frozen, bits, bounds};
use rayon::prelude::*;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

fn main() -> Result<ExitCode, String> {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let by_bits = take(&mut arguments, "--bits");
    let folder = match arguments.iter().position(|argument| argument == "--folder") {
        Some(at) if at + 1 < arguments.len() => {
            PathBuf::from(arguments.drain(at..=at + 1).nth(1).unwrap_or_default())
        }
        _ => frozen::folder(),
    };
    let words = if arguments.is_empty() { "compare".to_owned() } else { arguments.remove(0) };
    let mut different = 0;
    for family in frozen::families(&folder).map_err(|error| error.to_string())? {
        if !arguments.is_empty() && !arguments.contains(&family) {
            continue;
        }
        let all = frozen::family(&folder, &family).map_err(|error| error.to_string())?;
        let start = Instant::now();
        match words.as_str() {
            "compare" => different += compare(&all, by_bits)?,
            "answer" => answer(&folder, &family, &all)?,
            other => return Err(format!("unknown command `{other}`: write `compare` or `answer`")),
        }
        eprintln!("{family}: {} models, {:.1} s", all.len(), start.elapsed().as_secs_f64());
    }
    if words == "compare" {
        println!("{different} models differ");
    }
    Ok(if different == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn take(arguments: &mut Vec<String>, flag: &str) -> bool {
    let before = arguments.len();
    arguments.retain(|argument| argument != flag);
    arguments.len() < before
}

/// Prints the differences and returns the number of models that differ.
fn compare(all: &[Frozen], by_bits: bool) -> Result<usize, String> {
    let one = |one: &Frozen| {
        if by_bits {
            return Ok(bits::differences(one, &one.solved_again()?));
        }
        Ok(bounds::differences(one, &solve(&one.model()?)))
    };
    let found: Vec<Vec<_>> = all.par_iter().map(one).collect::<Result<_, String>>()?;
    for difference in found.iter().flatten() {
        println!("{difference}");
    }
    Ok(found.iter().filter(|differences| !differences.is_empty()).count())
}

fn answer(folder: &Path, family: &str, all: &[Frozen]) -> Result<(), String> {
    let solved: Vec<Frozen> =
        all.par_iter().map(Frozen::solved_again).collect::<Result<_, String>>()?;
    let write = |kind: &str, text: String| {
        let path = frozen::file(folder, kind, family);
        std::fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))
    };
    write("answers", solved.iter().map(|one| one.answer.text()).collect())?;
    write("certificates", solved.iter().map(|one| one.certificate.text()).collect())
}
