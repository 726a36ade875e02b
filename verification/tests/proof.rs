//! The proof of solutions: gaps reached, models covered, and wrong answers refused.

use groundbeam::proof::{Ball, NotProven, Proof, Wide, prove};
use groundbeam::{Outcome, Solution, solve};
use groundbeam_verification::cases;
use rayon::prelude::*;

/// Gaps relative to the strain energy as they were first reached, in numbers of 106 bits.
const REACHED: [(&str, f64); 16] = [
    ("kikuchi-1980/case-1.toml", 3.1e-32),
    ("kikuchi-1980/case-2.toml", 1.1e-31),
    ("kikuchi-1980/case-3.toml", 4.8e-29),
    ("kikuchi-1980/case-4.toml", 3.8e-30),
    ("kikuchi-1980/figure-2-c-stands.toml", 9.9e-32),
    ("long-beam.toml", 1.8e-28),
    ("footings/strip-footing-under-three-columns.toml", 7.3e-30),
    ("limits/a-beam-ten-thousand-wavelengths-long.toml", 2.3e-20),
    ("limits/a-concentrated-force-at-a-ridge-of-the-ground.toml", 3.8e-29),
    ("limits/resultant-a-millionth-inside-an-end.toml", 4.9e-29),
    ("limits/resultant-outside-the-beam-held-by-tension.toml", 6.8e-31),
    ("textbook/rigid-footing-of-kikuchi-about-to-lift-off.toml", 1.3e-31),
    ("textbook/rigid-footing-of-kikuchi-lifted-off.toml", 1.8e-31),
    ("textbook/hetenyi-1946-hinge-under-a-force.toml", 1.3e-29),
    ("textbook/kerr-1964-endless-beam-on-a-shear-layer-g-1.5.toml", 5.7e-29),
    (
        "textbook/pavlovic-tsikkos-1982-simply-supported-beam-on-springs-that-do-not-pull.toml",
        1.6e-29,
    ),
];

/// Balanced on one point: what presses has no lever to balance the rounding of the answer.
const BALANCED: [&str; 2] = [
    "limits/balanced-on-a-corner-of-the-ground.toml",
    "limits/balanced-on-an-end-of-a-shear-layer.toml",
];

/// All solutions of the case files.
fn solutions() -> Vec<(String, Solution)> {
    let models: Vec<_> = cases::all()
        .into_iter()
        .map(|case| case.expect("a case that can be read"))
        .flat_map(|case| case.models().into_iter().map(move |model| (case.path.clone(), model)))
        .collect();
    let solved = models.into_par_iter().filter_map(|(path, model)| match solve(&model) {
        Ok(Outcome::Equilibrium(solution)) => Some((path, *solution)),
        _ => None,
    });
    solved.collect()
}

fn relative(proof: &Proof) -> f64 {
    proof.energy / proof.strain_energy
}

#[test]
fn solutions_of_all_case_files_are_proven_or_their_kind_is_named() {
    let found: Vec<(String, f64, Result<Proof, NotProven>)> = solutions()
        .into_par_iter()
        .map(|(path, solution)| (path, solution.certificate().relative_gap(), solution.prove()))
        .collect();
    let mut proven = 0;
    for (path, today, proof) in &found {
        match proof {
            Ok(proof) => {
                proven += 1;
                let gap = relative(proof);
                assert!(gap <= today.max(1e-28), "{path}: {gap:e}, certificate {today:e}");
            }
            Err(why) if why.what.starts_with("not covered: ") => {}
            Err(why) => {
                assert!(BALANCED.contains(&path.as_str()), "{path}: {why}");
                assert!(why.what.starts_with("no lever"), "{path}: {why}");
            }
        }
    }
    assert!(proven >= 101, "only {proven} solutions are proven");
    for (path, reached) in REACHED {
        let of_path = found.iter().filter(|(found, ..)| found == path);
        for (_, _, proof) in of_path {
            let gap = relative(proof.as_ref().expect("proven"));
            assert!(gap <= 2.0 * reached, "{path}: {gap:e} in place of {reached:e}");
        }
    }
}

/// The same answer in numbers of fewer digits has a larger bound.
#[test]
fn more_digits_prove_more() {
    for (path, solution) in solutions().iter().filter(|(path, _)| path.starts_with("kikuchi")) {
        let (model, answer) = solution.claim::<Ball>();
        let ball = prove(&model, &answer).expect("proven");
        let (model, answer) = solution.claim::<Wide>();
        let wide = prove(&model, &answer).expect("proven");
        assert!(wide.energy <= ball.energy * (1.0 + 1e-9), "{path}");
    }
}
