//! Solves random models of every family and counts what fails: `… --example random_models -- 1000`. Behind the
//! number may stand a method (`exact`, or `active-set` with 1 to 10 000 elements), a family, and the number
//! of the first model.

use groundbeam::{Method, Options, Outcome, solve_with};
use groundbeam_verification::random::{Family, model};
use std::time::{Duration, Instant};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |i: usize| arguments.get(i).and_then(|n| n.parse::<u64>().ok());
    let count = number(0).unwrap_or(100);
    let mesh = arguments.get(1).is_some_and(|method| method == "active-set");
    let first = number(3).unwrap_or(0);
    let wanted = |family: &Family| arguments.get(2).is_none_or(|a| *a == format!("{family:?}"));
    for family in Family::ALL.into_iter().chain([Family::Extreme]).filter(wanted) {
        let (mut failed, mut worst, mut zones) = (0, 0.0_f64, 0);
        let (mut all, mut slowest) = (Duration::ZERO, (Duration::ZERO, 0));
        for number in first..first + count {
            let elements = [1, 3, 10, 33, 100, 333, 1000, 10_000][number as usize % 8];
            let method = if mesh { Method::ActiveSet } else { Method::Exact };
            let options = Options { method, elements, ..Options::default() };
            let model = model(family, number);
            let start = Instant::now();
            let outcome = solve_with(&model, &options);
            let time = start.elapsed();
            all += time;
            slowest = slowest.max((time, number));
            match outcome {
                Ok(Outcome::Equilibrium(solution)) => {
                    worst = worst.max(solution.certificate().relative_gap());
                    zones = zones.max(solution.contact().len());
                }
                Ok(Outcome::NoEquilibrium(_)) => failed += 1,
                Err(error) => {
                    failed += 1;
                    println!("{family:?} {number}: {error}");
                }
            }
        }
        println!(
            "{family:?}: {failed} of {count} failed, largest relative gap {worst:.1e}, up to {zones} zones, {:.1} s, \
             the slowest number {} {:.2} s",
            all.as_secs_f64(),
            slowest.1,
            slowest.0.as_secs_f64()
        );
    }
}
