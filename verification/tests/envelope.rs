//! Compares envelopes of random models with dense sampling of their solutions.
//!
//! Claims: `docs/combinations.md`.

use groundbeam::{
    Field, Model, Outcome, Solution,
    envelope::{Bound, Bounds, Change, Envelope},
    solution::Side,
    solve,
};
use groundbeam_verification::random::{Family, model};

/// Number of positions at which every solution is evaluated.
const SAMPLES: usize = 400;

/// A random model with its loads in several proportions, as in combinations.
fn combinations(family: Family, number: u64) -> Vec<Solution> {
    let whole = model(family, number);
    let count = whole.loads.len();
    let factor = |combination: usize, load: usize| match (combination, load % 3) {
        (0, _) => 1.0,
        (1, 0) => 1.35,
        (2, 1) => 1.5,
        (3, 2) => 0.0,
        (4, _) => 0.6,
        _ => 1.0,
    };
    let made = (0..5).map(|combination| {
        let scaled = (0..count).map(|i| whole.loads[i].scaled(factor(combination, i)));
        Model { loads: scaled.collect(), ..whole.clone() }
    });
    made.filter_map(|model| match solve(&model) {
        Ok(Outcome::Equilibrium(solution)) => Some(*solution),
        _ => None,
    })
    .collect()
}

fn families() -> impl Iterator<Item = (Family, Vec<Solution>)> {
    Family::ALL.into_iter().chain([Family::Shearing]).flat_map(|family| {
        let count = if matches!(family, Family::Long | Family::Hard) { 3 } else { 8 };
        (0..count).map(move |number| (family, combinations(family, number)))
    })
}

fn positions(length: f64) -> impl Iterator<Item = f64> {
    (0..=SAMPLES).map(move |i| length * (i as f64 / SAMPLES as f64))
}

/// The bounds just right of a position.
fn beside(envelope: &Envelope, field: Field, x: f64) -> Bounds {
    envelope.all_beside(x, Side::Right)[field.index()]
}

/// The largest absolute value of a field in any solution.
fn size(envelope: &Envelope, field: Field) -> f64 {
    let range = envelope.range(field);
    range.min.extreme.value.abs().max(range.max.extreme.value.abs())
}

#[test]
fn solutions_lie_within_the_envelope_and_reach_it() {
    for (family, solutions) in families() {
        let envelope = Envelope::of(&solutions);
        let length = solutions[0].model().beam.length;
        for field in Field::ALL {
            let range = envelope.range(field);
            let rounding = 1e-9 * size(&envelope, field);
            for x in positions(length) {
                let here = envelope.at(field, x);
                let values = || {
                    let sides = [Side::Left, Side::Right].into_iter();
                    let of = |side| solutions.iter().map(move |s| s.at(x, side).get(field));
                    sides.flat_map(of)
                };
                let (low, high) = (
                    values().fold(f64::INFINITY, f64::min),
                    values().fold(-f64::INFINITY, f64::max),
                );
                let found = (here.min.extreme.value, here.max.extreme.value);
                assert_eq!(found, (low, high), "{family:?} {field:?} {x}");
                assert!(range.min.extreme.value <= low + rounding, "{family:?} {field:?} {x}");
                assert!(range.max.extreme.value >= high - rounding, "{family:?} {field:?} {x}");
            }
            for governing in [range.min, range.max] {
                let solution = &solutions[governing.by];
                let own = solution.range(field);
                let is_own = [own.min, own.max].iter().any(|own| {
                    let off = (own.value - governing.extreme.value).abs();
                    own.x == governing.extreme.x && off <= rounding
                });
                assert!(is_own, "{family:?} {field:?}");
            }
        }
    }
}

/// Between two changes one solution governs; sampling finds no further change.
#[test]
fn one_solution_governs_between_two_changes() {
    let mut count = 0;
    for (family, solutions) in families() {
        let envelope = Envelope::of(&solutions);
        let length = solutions[0].model().beam.length;
        for field in Field::ALL {
            let rounding = 1e-9 * size(&envelope, field);
            for bound in [Bound::Min, Bound::Max] {
                let changes: Vec<Change> =
                    envelope.changes(field).into_iter().filter(|c| c.bound == bound).collect();
                count += changes.len();
                assert!(changes.windows(2).all(|pair| pair[0].to == pair[1].from));
                let governs = |x: f64| {
                    let after = changes.iter().rfind(|change| change.x <= x);
                    match (after, changes.first()) {
                        (Some(change), _) => Some(change.to),
                        (None, Some(first)) => Some(first.from),
                        (None, None) => None,
                    }
                };
                for x in positions(length) {
                    let here = beside(&envelope, field, x);
                    let here = if bound == Bound::Min { here.min } else { here.max };
                    let by = governs(x).unwrap_or(here.by);
                    let value = solutions[by].at(x, Side::Right).get(field);
                    let off = (value - here.extreme.value).abs();
                    // A steep field may change significantly when x changes by its own rounding.
                    let near = [-1e-9, 1e-9].map(|by| (x + by * length).clamp(0.0, length));
                    let moved = near.map(|x| beside(&envelope, field, x));
                    let steep = moved.iter().map(|b| match bound {
                        Bound::Min => (b.min.extreme.value - here.extreme.value).abs(),
                        Bound::Max => (b.max.extreme.value - here.extreme.value).abs(),
                    });
                    let allowed = rounding + steep.fold(0.0, f64::max);
                    assert!(off <= allowed, "{family:?} {field:?} {bound:?} {x}: {off:e}");
                }
            }
        }
    }
    assert!(count > 500, "{count} changes were looked at");
}

/// With all loads times 2ⁿ and without a gap, the same solutions govern at the same positions.
#[test]
fn scaling_the_loads_does_not_change_the_governing_solutions() {
    for number in 0..6 {
        let solutions = combinations(Family::Plain, number);
        let scaled: Vec<Solution> = solutions
            .iter()
            .map(|solution| match solve(&solution.model().clone().with_loads_scaled(1024.0)) {
                Ok(Outcome::Equilibrium(solution)) => *solution,
                other => panic!("{other:?}"),
            })
            .collect();
        let (one, other) = (Envelope::of(&solutions), Envelope::of(&scaled));
        for field in Field::ALL {
            assert_eq!(one.changes(field), other.changes(field));
        }
        assert_eq!(one.stations(10), other.stations(10));
    }
}
