//! Loads and solves the test models, and takes pictures apart.

mod parts;

pub use parts::parts;

use groundbeam::{Outcome, Solution};
use groundbeam_file::{Document, UnitSystem};
use groundbeam_report::{Context, Units};
use groundbeam_run::{Answers, OneThread, Run};

/// Models that have an equilibrium.
pub const SOLVABLE: [&str; 11] = [
    "compressed",
    "curled",
    "footing",
    "gap",
    "jointed",
    "kikuchi-4",
    "long-beam",
    "neighbours",
    "supports",
    "tiny",
    "winkler",
];

/// The model file `tests/models/NAME.toml`.
pub fn document(name: &str) -> Document {
    let path = format!("{}/tests/models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    groundbeam_file::parse(&std::fs::read_to_string(path).unwrap()).unwrap()
}

pub fn context(document: &Document) -> Context<'_> {
    let units = match document.units {
        UnitSystem::Si => Units::SI,
        UnitSystem::Plain => Units::PLAIN,
    };
    Context { title: document.title.as_deref(), ..Context::new(units) }.with_seconds(0.0015)
}

pub fn solved(document: &Document) -> Solution {
    match groundbeam::solve(&document.model).unwrap() {
        Outcome::Equilibrium(solution) => *solution,
        Outcome::NoEquilibrium(existence) => panic!("{existence:?}"),
    }
}

/// The answers to all models of a file.
pub fn answers(document: &Document) -> Answers {
    Run::of(document).solve(&OneThread).unwrap()
}
