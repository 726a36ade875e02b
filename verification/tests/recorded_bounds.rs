//! Compares the bounds of proofs with recorded ones: a term that the checker loses or adds changes a bound.
//!
//! The claims are answers of neighbouring models. Their errors exceed all rounding errors, so the bounds have digits.

use groundbeam::proof::{Bound, ContactSet, Proof, Wide, prove};
use groundbeam::{Model, Outcome, Solution, own_buckling_load, solve};
use groundbeam_testing::expect_file_by;
use groundbeam_verification::claims::CHANGES;
use groundbeam_verification::frozen;
use rayon::prelude::*;

const RECORD: &str = "verification/recorded/bounds.tsv";

/// Families without compression.
const FAMILIES: [&str; 17] = [
    "Plain",
    "Tension",
    "Segments",
    "Winkler",
    "Supported",
    "Gap",
    "Hard",
    "Long",
    "Mixed",
    "Varying",
    "Curled",
    "Settled",
    "Hinged",
    "OneWay",
    "Beside",
    "Neighbours",
    "Shearing",
];
const MODELS: usize = 4;

/// Change of every kind of number of the model, from 1 to 7 times this.
const CHANGE: f64 = 1e-6;

/// Permitted relative change of a number: its last recorded digit.
const SAME: f64 = 1e-3;
/// Smaller numbers are rounding errors.
const ROUNDING: f64 = 1e-13;

fn width([low, high]: [f64; 2]) -> f64 {
    high - low
}

/// The sums of the widths of all intervals of edges and of forces.
fn widths(set: &ContactSet) -> [f64; 2] {
    let edges = set.regions.iter().map(|region| width(region.from) + width(region.to));
    let forces = set.forces.iter().map(|force| width(force.force));
    [edges.sum(), forces.sum()]
}

/// The numbers of a proof: √(E over the strain energy); bounds over scales of fields, of the reactions together, of
/// edges and of concentrated forces. NaN stands for a missing bound.
fn numbers(proof: &Proof) -> Vec<f64> {
    let ratio = |bound: Bound| bound.error / bound.scale;
    let largest = |of: fn(&groundbeam::proof::ReactionBound) -> Bound| {
        proof.reactions.iter().map(|reaction| ratio(of(reaction))).fold(0.0, f64::max)
    };
    let [edges, forces] = proof.contact.as_ref().map_or([f64::NAN; 2], widths);
    let mut numbers = vec![(proof.energy / proof.strain_energy).sqrt()];
    numbers.extend(proof.bounds.named().map(|(_, bound)| ratio(bound)));
    numbers.extend([largest(|reaction| reaction.force), largest(|reaction| reaction.moment)]);
    numbers.extend([edges / proof.scales.length, forces / proof.scales.force]);
    numbers.push(if proof.unique.is_ok() { 1.0 } else { 0.0 });
    numbers
}

/// The same model under a compression of 0.3 of the beam's own buckling load.
fn compressed((name, mut model): (String, Model)) -> Option<(String, Model)> {
    model.supports.retain(|support| !support.is_one_way());
    let critical = own_buckling_load(&model);
    model.beam.axial_force = -0.3 * critical;
    (0.0 < critical && critical < f64::INFINITY).then(|| (format!("{name} compressed"), model))
}

/// The numbers of the proof of a neighbour's answer, as a row of the record.
fn row((name, model): &(String, Model)) -> Option<String> {
    let solved = |model: &_| match solve(model) {
        Ok(Outcome::Equilibrium(solution)) => Some(*solution),
        _ => None,
    };
    let mut neighbour = model.clone();
    for (factor, change) in (1..).zip(CHANGES) {
        change(&mut neighbour, 1.0 + f64::from(factor) * CHANGE);
    }
    let claimed: Solution = solved(&neighbour)?;
    let (_, answer) = claimed.claim::<Wide>();
    let proof = prove(&model.to_prove::<Wide>(), &answer);
    let found = match &proof {
        Ok(proof) => numbers(proof).iter().map(|x| format!("{x:.3e}")).collect(),
        Err(why) => vec![why.what.clone()],
    };
    Some(format!("{}\t{}", name, found.join("\t")))
}

/// Whether two rows agree; prints them if they differ.
fn same_row(recorded: &str, found: &str) -> bool {
    let near = |a: &str, b: &str| match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) if a.is_finite() => (a - b).abs() <= SAME * a.abs() + ROUNDING,
        _ => a == b,
    };
    let (a, b): (Vec<_>, Vec<_>) = (recorded.split('\t').collect(), found.split('\t').collect());
    let same = a.len() == b.len() && a.iter().zip(b).all(|(a, b)| near(a, b));
    if !same {
        println!("recorded {recorded}\nfound    {found}");
    }
    same
}

#[test]
fn bounds_are_the_recorded_ones() {
    let first = |name: &&str| {
        let all = frozen::family(&frozen::folder(), name).expect("a family");
        let model = |one: frozen::Frozen| (one.title().to_owned(), one.model().expect("a model"));
        all.into_iter().take(MODELS).map(model)
    };
    let mut models: Vec<_> = FAMILIES.iter().flat_map(first).collect();
    models.extend(["Supported", "Shearing"].iter().flat_map(first).filter_map(compressed));
    let found: Vec<String> = models.par_iter().filter_map(row).collect();
    expect_file_by(RECORD, &(found.join("\n") + "\n"), |recorded, found| {
        let (recorded, found): (Vec<_>, Vec<_>) =
            (recorded.lines().collect(), found.lines().collect());
        let changed = recorded.iter().zip(&found).filter(|(a, b)| !same_row(a, b)).count();
        changed == 0 && recorded.len() == found.len()
    });
}
