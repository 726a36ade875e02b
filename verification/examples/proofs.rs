//! Compares the error bounds of proofs and certificates, for all models under `cases/` and for stored random models.
//!
//! ```text
//! … --example proofs -- [--most N] [NAME …]
//! ```
//!
//! NAME is a part of the path of a case or of the name of a family. N is the number of models of each family. The
//! program prints the energy of the error relative to the strain energy: the estimate of the certificate, and the
//! bounds of the proofs with `Wide` and `Ball`.

use groundbeam::proof::{Ball, Enclosing, Proof, Wide, prove};
use groundbeam::{Model, Outcome, Solution, solve};
use groundbeam_verification::{cases, frozen};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::time::Instant;

/// The result for one model.
enum Outcomes {
    /// The solution has bounds. `why` is the first reason why the solution is not proven, if any.
    Bounded {
        times: [f64; 2],
        gaps: [f64; 3],
        why: Option<String>,
    },
    NotProven(String),
    NoSolution,
}

fn main() -> Result<(), String> {
    let mut names: Vec<String> = std::env::args().skip(1).collect();
    let most = match names.iter().position(|name| name == "--most") {
        Some(at) => names.drain(at..=at + 1).nth(1).and_then(|n| n.parse().ok()).unwrap_or(200),
        None => 200,
    };
    let wanted = |name: &str| names.is_empty() || names.iter().any(|part| name.contains(part));
    let mut models: Vec<(String, String, Model)> = Vec::new();
    for case in cases::all() {
        let case = case.map_err(|(path, misread)| format!("{path}: {misread}"))?;
        if wanted(&case.path) {
            let all = case.models();
            models.extend(all.into_iter().map(|model| ("cases".into(), case.path.clone(), model)));
        }
    }
    let folder = frozen::folder();
    for family in frozen::families(&folder).map_err(|error| error.to_string())? {
        if !wanted(&family) {
            continue;
        }
        let all = frozen::family(&folder, &family).map_err(|error| error.to_string())?;
        for one in all.iter().take(most) {
            models.push((family.clone(), format!("{family} {}", one.number()), one.model()?));
        }
    }
    let found: Vec<_> = models.par_iter().map(|(_, _, model)| of(model)).collect();
    let mut counts: BTreeMap<&str, [usize; 4]> = BTreeMap::new();
    let mut ratios: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    for ((group, name, _), outcome) in models.iter().zip(&found) {
        let count = counts.entry(group).or_default();
        match outcome {
            Outcomes::Bounded { gaps, times, why } => {
                count[usize::from(why.is_some())] += 1;
                ratios.entry(group).or_default().push(gaps[1] / gaps[0]);
                let [certificate, wide, ball] = gaps;
                let [a, b] = times;
                println!(
                    "{name:44} certificate {certificate:7.1e} wide {wide:7.1e} ball {ball:7.1e}  µs {a:6.0} {b:6.0} {}",
                    why.as_deref().map_or(String::new(), |why| format!("not proven: {why}"))
                );
            }
            Outcomes::NotProven(why) => {
                count[2] += 1;
                println!("{name:44} {why}");
            }
            Outcomes::NoSolution => count[3] += 1,
        }
    }
    for (group, [proven, bounded, not, without]) in counts {
        let mut all = ratios.remove(group).unwrap_or_default();
        all.sort_by(f64::total_cmp);
        let at = |part: f64| {
            all.get((part * (all.len().max(1) - 1) as f64) as usize).copied().unwrap_or(f64::NAN)
        };
        println!(
            "{group:12} proven {proven:4}, bounds only {bounded:4}, no bounds {not:4}, no solution {without:4}; bound of \
             `Wide` over estimate of the certificate: smallest {:.1e}, median {:.1e}, 90 % below {:.1e}, largest {:.1e}",
            at(0.0),
            at(0.5),
            at(0.9),
            at(1.0)
        );
    }
    Ok(())
}

fn of(model: &Model) -> Outcomes {
    let Ok(Outcome::Equilibrium(solution)) = solve(model) else { return Outcomes::NoSolution };
    let (wide, a) = timed::<Wide>(&solution);
    let (ball, b) = timed::<Ball>(&solution);
    let gap = |proof: Result<Proof, _>| {
        proof.map_or(f64::INFINITY, |proof: Proof| proof.energy / proof.strain_energy)
    };
    match wide {
        Err(why) => Outcomes::NotProven(why.to_string()),
        Ok(wide) => Outcomes::Bounded {
            why: wide.shortfall().map(|why| why.to_string()),
            times: [a, b],
            gaps: [solution.certificate().relative_gap(), gap(Ok(wide)), gap(ball)],
        },
    }
}

fn timed<S: Enclosing>(solution: &Solution) -> (Result<Proof, groundbeam::proof::NotProven>, f64) {
    let (model, answer) = solution.claim::<S>();
    let start = Instant::now();
    let proof = prove(&model, &answer);
    (proof, start.elapsed().as_secs_f64() * 1e6)
}
