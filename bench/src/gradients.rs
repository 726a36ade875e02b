//! Compares the time for derivatives of results with respect to parameters of a model with the time to solve the model.

use crate::clock::side_by_side;
use crate::table::{Table, short};
use groundbeam::derivatives::{Domain, LoadNumber, Output, Parameter, Property};
use groundbeam::{Field, Model, Outcome, Solution, solution::Side, solve};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Number of timed solves and of timed gradient computations per model.
const RUNS: usize = 200;

/// Number of ground segments, each with a different subgrade modulus k.
const SEGMENTS: usize = 100;

pub fn table() -> String {
    let columns = ["model", "outputs × parameters", "gradients/solve", "solve µs"];
    let mut table = Table::new("Gradients beside the exact solve", &columns);
    let read = |path: &str| {
        let path = format!("{}/../cases/{path}.toml", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(path).expect("a case file");
        groundbeam_file::parse(&text).expect("a model").model
    };
    let footing = read("footings/strip-footing-under-three-columns");
    let case = read("kikuchi-1980/case-4");
    let few = [Output::Largest(Field::Moment)];
    let by_k = [Parameter::Factor(Property::Spring, Domain::Whole)];
    row(&mut table, "footing", &footing, &few, &by_k);
    row(&mut table, "footing", &footing, &outputs(&footing), &parameters());
    row(&mut table, "Kikuchi's case IV", &case, &outputs(&case), &parameters());
    let field = on_segments(&footing);
    let three = [Field::Moment, Field::Settlement, Field::Pressure].map(Output::Largest);
    let by_each = (0..SEGMENTS).map(|i| Parameter::Value(Property::Spring, Domain::Segment(i)));
    row(&mut table, "footing, k of 100 segments", &field, &three, &by_each.collect::<Vec<_>>());
    table.finish("The 13 outputs are nine settlements, the largest moment, the smallest shear force, an edge and an end force.")
}

/// Returns nine settlements, the largest moment, the smallest shear force, one contact edge and one end force as the
/// outputs to differentiate.
fn outputs(model: &Model) -> Vec<Output> {
    let at = |i: i32| f64::from(i) * model.beam.length / 10.0;
    let settles = (1..10).map(|i| Output::Value(Field::Settlement, at(i), Side::Right));
    let others = [
        Output::Largest(Field::Moment),
        Output::Smallest(Field::ShearForce),
        Output::Edge(0, Side::Right),
        Output::EndForce(Side::Left),
    ];
    settles.chain(others).collect()
}

fn parameters() -> [Parameter; 8] {
    let factor = |property| Parameter::Factor(property, Domain::Whole);
    [
        factor(Property::BendingStiffness),
        factor(Property::Spring),
        factor(Property::Shear),
        Parameter::AxialForce,
        Parameter::LoadFactor,
        Parameter::Load(0, LoadNumber::Size),
        Parameter::Load(0, LoadNumber::At),
        Parameter::Load(1, LoadNumber::Size),
    ]
}

/// Returns the model with k multiplied by a random factor between 0.75 and 1.33 on each ground segment.
fn on_segments(model: &Model) -> Model {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let mut model = model.clone();
    let [l, shear] = [model.beam.length, model.foundation.shear_layer];
    let at = |i: usize| l * i as f64 / SEGMENTS as f64;
    for i in 0..SEGMENTS {
        let spring = model.foundation.subgrade * rng.random_range(0.75..1.33);
        model.foundation = model.foundation.with_segment(at(i), at(i + 1), spring, shear);
    }
    model
}

fn row(table: &mut Table, name: &str, model: &Model, outputs: &[Output], parameters: &[Parameter]) {
    let solved = |model: &Model| -> Solution {
        match solve(model) {
            Ok(Outcome::Equilibrium(solution)) => *solution,
            other => unreachable!("{name} has an answer: {other:?}"),
        }
    };
    let solution = solved(model);
    let gradients = || solution.gradients(outputs, parameters).expect("derivatives");
    let [solve, own] = side_by_side(RUNS, [&mut || drop(solved(model)), &mut || drop(gradients())]);
    let [least, median] = [own.least / solve.least, own.median / solve.median];
    table.row(&[
        name.to_owned(),
        format!("{} × {}", outputs.len(), parameters.len()),
        format!("**{least:.2}** (median {median:.2})"),
        short(1e6 * solve.least),
    ]);
}
