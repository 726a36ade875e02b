//! Solves random models of every family and counts the failures.
//!
//! ```text
//! … --example random_models -- [COUNT] [exact | active-set] [FAMILY] [FIRST]
//! ```
//!
//! The program solves COUNT models of each family from number FIRST on, but at most 2000 of three slow families.
//! `active-set` uses meshes of 1 to 10 000 elements and solves only the families of `Family::ALL`.

use groundbeam::{Method, Options, Outcome, solve_with};
use groundbeam_verification::random::{Family, model};
use rayon::prelude::*;
use std::time::{Duration, Instant};

/// Families that take a long time or that only the exact method solves, with the maximum number of models of
/// each family.
const OTHERS: [(Family, u64); 4] = [
    (Family::Shearing, u64::MAX),
    (Family::Extreme, 2000),
    (Family::Compressed, 2000),
    (Family::CompressedToo, 2000),
];

/// One solve.
struct Solved {
    number: u64,
    time: Duration,
    /// Relative energy gap of the solution and number of its contact zones, or the reason why there is no solution.
    answer: Result<(f64, usize), String>,
}

fn solved(family: Family, number: u64, method: Method) -> Solved {
    let elements = [1, 3, 10, 33, 100, 333, 1000, 10_000][number as usize % 8];
    let options = Options { method, elements, ..Options::default() };
    let model = model(family, number);
    let start = Instant::now();
    let outcome = solve_with(&model, &options);
    let time = start.elapsed();
    let answer = match outcome {
        Ok(Outcome::Equilibrium(solution)) => {
            Ok((solution.certificate().relative_gap(), solution.contact().len()))
        }
        Ok(Outcome::NoEquilibrium(_)) => Err("no equilibrium".to_owned()),
        Err(error) => Err(error.to_string()),
    };
    Solved { number, time, answer }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |i: usize| arguments.get(i).and_then(|n| n.parse::<u64>().ok());
    let count = number(0).unwrap_or(100);
    let on_mesh = arguments.get(1).is_some_and(|method| method == "active-set");
    let first = number(3).unwrap_or(0);
    let method = if on_mesh { Method::ActiveSet } else { Method::Exact };
    let wanted = |family: Family| arguments.get(2).is_none_or(|a| *a == format!("{family:?}"));
    let others = OTHERS.into_iter().filter(|_| !on_mesh);
    let families = Family::ALL.into_iter().map(|family| (family, u64::MAX)).chain(others);
    for (family, most) in families.filter(|(family, _)| wanted(*family)) {
        let numbers = first..first + count.min(most);
        let all: Vec<Solved> =
            numbers.into_par_iter().map(|number| solved(family, number, method)).collect();
        let (mut failed, mut worst, mut zones) = (0, 0.0_f64, 0);
        for one in &all {
            match &one.answer {
                Ok((gap, contact)) => (worst, zones) = (worst.max(*gap), zones.max(*contact)),
                Err(why) => {
                    failed += 1;
                    println!("{family:?} {}: {why}", one.number);
                }
            }
        }
        let total: Duration = all.iter().map(|one| one.time).sum();
        let (slowest, number) =
            all.iter().map(|one| (one.time, one.number)).max().unwrap_or_default();
        println!(
            "{family:?}: {failed} of {} failed, largest relative gap {worst:.1e}, up to {zones} zones, {:.1} s, \
             the slowest number {number} {:.2} s",
            all.len(),
            total.as_secs_f64(),
            slowest.as_secs_f64()
        );
    }
}
