//! Solves random models with the code of the pinned commit, and writes the models and their answers to text files.
//!
//! `run.sh` builds this folder within the sources of that commit. `verification/src/frozen` reads the files.

mod answer;
mod model;

use groundbeam::{Outcome, solve};
use groundbeam_verification::random::{self, Family};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

/// All families.
const FAMILIES: [Family; 20] = [
    Family::Plain,
    Family::Tension,
    Family::Segments,
    Family::Winkler,
    Family::Supported,
    Family::Gap,
    Family::Hard,
    Family::Long,
    Family::Mixed,
    Family::Varying,
    Family::Curled,
    Family::Settled,
    Family::Hinged,
    Family::OneWay,
    Family::Beside,
    Family::Neighbours,
    Family::Shearing,
    Family::Compressed,
    Family::CompressedToo,
    Family::Extreme,
];

/// Number of models of each family that are written to the files, in addition to the models in `NAMED`.
const FIRST: u64 = 200;
/// Number of models of each family with fields at all positions, in addition to those in `NAMED`. Other models have
/// fields at five positions.
const IN_FULL: u64 = 40;

/// For each family, the numbers of the models that measurements, documents or tests mention.
const NAMED: [(Family, &[u64]); 14] = [
    (Family::Supported, &[8, 973, 1303]),
    (Family::Gap, &[4, 30, 738, 7429]),
    (
        Family::Hard,
        &[
            22, 41, 47, 53, 172, 515, 542, 680, 774, 822, 855, 1617, 2396, 4179, 6164, 6195, 6209,
            7371,
        ],
    ),
    (Family::Mixed, &[3, 803, 864, 1447]),
    (Family::Varying, &[1, 11, 955]),
    (Family::Curled, &[41, 195, 602]),
    (Family::Settled, &[5, 33, 309, 531, 851, 870, 2606]),
    (Family::Hinged, &[46, 364, 507]),
    (Family::OneWay, &[301, 314, 432, 649]),
    (Family::Beside, &[68]),
    (Family::Shearing, &[162, 250, 308, 320, 361, 366, 439, 478]),
    (Family::Compressed, &[211]),
    (Family::CompressedToo, &[8, 12, 22, 37, 69]),
    (Family::Extreme, &[13, 19, 30, 54, 62, 218, 230, 463]),
];

/// Models that are omitted because the pinned program takes too long.
const LEFT_OUT: [(Family, &[u64]); 1] = [(Family::CompressedToo, &[168])];

fn named(family: Family) -> &'static [u64] {
    of(&NAMED, family)
}

fn of(lists: &[(Family, &'static [u64])], family: Family) -> &'static [u64] {
    lists.iter().find(|(listed, _)| *listed == family).map_or(&[], |(_, numbers)| numbers)
}

/// The texts of one random model, its answer and its certificate.
struct Written {
    model: String,
    answer: String,
    certificate: String,
}

fn write(family: Family, number: u64) -> Written {
    let start = Instant::now();
    let title = format!("{family:?} {number}\n");
    let model = random::model(family, number);
    let drawn = start.elapsed().as_secs_f64();
    let outcome = solve(&model);
    let seconds = start.elapsed().as_secs_f64();
    if seconds > 2.0 {
        eprintln!("{family:?} {number}: drawn in {drawn:.1} s, solved in {:.1} s", seconds - drawn);
    }
    let in_full = number < IN_FULL || named(family).contains(&number);
    let certificate = match &outcome {
        Ok(Outcome::Equilibrium(solution)) => answer::certificate(solution),
        _ => String::new(),
    };
    Written {
        model: format!("{title}{}\n", model::text(&model)),
        answer: format!("{title}{}\n", answer::text(&outcome, in_full)),
        certificate: format!("{title}{certificate}\n"),
    }
}

/// Writes the random models of one family with the given numbers, their answers and their certificates to three files.
fn write_family(folder: &Path, family: Family, numbers: &[u64]) -> std::io::Result<()> {
    let (next, written) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(&number) = numbers.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let one = write(family, number);
                    written.lock().expect("no thread panics").push((number, one));
                }
            });
        }
    });
    let mut written = written.into_inner().expect("no thread panics");
    written.sort_by_key(|(number, _)| *number);
    let file = |kind: &str, text: fn(&Written) -> &str| {
        let all: String = written.iter().map(|(_, one)| text(one)).collect();
        let folder: PathBuf = folder.join(kind);
        fs::create_dir_all(&folder)?;
        fs::write(folder.join(format!("{family:?}.txt")), all)
    };
    file("models", |one| &one.model)?;
    file("answers", |one| &one.answer)?;
    file("certificates", |one| &one.certificate)
}

fn main() -> std::io::Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let folder = PathBuf::from(arguments.first().expect("a folder to write to"));
    let wanted = arguments.get(1);
    let number = |i: usize| arguments.get(i).map(|text| text.parse::<u64>().expect("a number"));
    for family in FAMILIES {
        if wanted.is_some_and(|wanted| *wanted != format!("{family:?}")) {
            continue;
        }
        let numbers: Vec<u64> = match (number(2), number(3)) {
            (Some(from), Some(to)) => (from..to).collect(),
            _ => {
                let later = named(family).iter().copied().filter(|number| *number >= FIRST);
                let left_out = of(&LEFT_OUT, family);
                (0..FIRST).chain(later).filter(|number| !left_out.contains(number)).collect()
            }
        };
        let start = Instant::now();
        write_family(&folder, family, &numbers)?;
        eprintln!("{family:?}: {} models, {:.0} s", numbers.len(), start.elapsed().as_secs_f64());
    }
    Ok(())
}
