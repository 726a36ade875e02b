//! Solves random models of every family and counts what fails: `… --example random_models -- 1000`, or with
//! `active-set` behind the number by the mesh, with 1 to 10 000 elements.

use groundbeam::{Method, Options, Outcome, solve_with};
use groundbeam_verification::random::{Family, model};

fn main() {
    let mut arguments = std::env::args().skip(1);
    let count: u64 = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(100);
    let mesh = arguments.next().is_some_and(|method| method == "active-set");
    for family in Family::ALL {
        let (mut failed, mut worst) = (0, 0.0_f64);
        for number in 0..count {
            let elements = [1, 3, 10, 33, 100, 333, 1000, 10_000][number as usize % 8];
            let method = if mesh { Method::ActiveSet } else { Method::Exact };
            let options = Options { method, elements, ..Options::default() };
            match solve_with(&model(family, number), &options) {
                Ok(Outcome::Equilibrium(solution)) => {
                    worst = worst.max(solution.certificate().relative_gap);
                }
                Ok(Outcome::NoEquilibrium(_)) => failed += 1,
                Err(error) => {
                    failed += 1;
                    println!("{family:?} {number}: {error}");
                }
            }
        }
        println!("{family:?}: {failed} of {count} failed, largest relative gap {worst:.1e}");
    }
}
