//! Compares the time to prove a solution with the time to compute the solution by the exact method.

use crate::clock::side_by_side;
use crate::models::{footings, long_beam};
use crate::table::{Table, short};
use groundbeam::proof::{Answer, Ball, Model as Given, Wide, estimate, prove};
use groundbeam::{Model, Outcome, Solution, solve};

/// Number of timed solves and of timed proofs per model.
const RUNS: usize = 200;

pub fn table() -> String {
    let mut table = Table::new(
        "A proof beside the exact solve",
        &[
            "model",
            "pieces",
            "Wide/solve",
            "Ball/solve",
            "estimate/solve",
            "solve µs",
            "E/strain energy",
        ],
    );
    let read = |path: &str| {
        let path = format!("{}/../cases/{path}.toml", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(path).expect("a case file");
        groundbeam_file::parse(&text).expect("a model").model
    };
    let cases = [
        ("Kikuchi's case I", read("kikuchi-1980/case-1")),
        ("Kikuchi's case III", read("kikuchi-1980/case-3")),
        ("Kikuchi's case IV", read("kikuchi-1980/case-4")),
        ("footing under three columns", read("footings/strip-footing-under-three-columns")),
        ("random footing", footings(1).remove(0)),
        ("case B", long_beam(0.0)),
    ];
    for (name, model) in &cases {
        row(&mut table, name, model);
    }
    table.finish("Proofs include the bounds of all fields, the contact set and uniqueness. The estimate is part of every solve.")
}

fn row(table: &mut Table, name: &str, model: &Model) {
    let solved = |model: &Model| -> Solution {
        match solve(model) {
            Ok(Outcome::Equilibrium(solution)) => *solution,
            other => unreachable!("{name} has an answer: {other:?}"),
        }
    };
    let solution = solved(model);
    let wide: (Given<Wide>, Answer) = solution.claim();
    let (ball, _) = solution.claim::<Ball>();
    let (plain, _) = solution.claim::<f64>();
    let [solve, first, second, third] = side_by_side(
        RUNS,
        [
            &mut || drop(solved(model)),
            &mut || drop(prove(&wide.0, &wide.1)),
            &mut || drop(prove(&ball, &wide.1)),
            &mut || drop(estimate(&plain, &wide.1, None)),
        ],
    );
    let ratio = |time: crate::clock::Time| {
        let [least, median] = [time.least / solve.least, time.median / solve.median];
        format!("**{least:.1}** (median {median:.1})")
    };
    let gap = prove(&wide.0, &wide.1).map_or(f64::NAN, |p| p.energy / p.strain_energy);
    table.row(&[
        name.to_owned(),
        wide.1.pieces.len().to_string(),
        ratio(first),
        ratio(second),
        ratio(third),
        short(1e6 * solve.least),
        format!("{gap:.0e}"),
    ]);
}
