//! Compares the present program with the frozen answers of the pinned one.

use groundbeam::{Options, Outcome, solve, solve_near};
use groundbeam_verification::frozen::{
    self, Frozen, bits, bounds, model as format, record::Record,
};
use groundbeam_verification::random::{Family, model};
use rayon::prelude::*;

/// Families whose models may take seconds, and the number of models of each compared here. The command compares all.
const SLOW: [(&str, u64); 3] = [("Compressed", 20), ("CompressedToo", 4), ("Extreme", 10)];
/// A model of another family that takes seconds.
const SLOW_MODELS: [&str; 1] = ["Shearing 308"];

/// A beam balanced on one corner of its gap, whose moments are rounding error.
const ROUNDING: [&str; 1] = ["Gap 738"];

fn all_frozen() -> Vec<Frozen> {
    let folder = frozen::folder();
    let families = frozen::families(&folder).expect("the folder of the frozen files");
    let family = |name: &String| frozen::family(&folder, name).expect("the files of a family");
    families.iter().flat_map(family).collect()
}

fn is_quick(one: &Frozen) -> bool {
    let slow = SLOW.iter().find(|(family, _)| one.title().starts_with(&format!("{family} ")));
    let left_out = SLOW_MODELS.contains(&one.title()) || ROUNDING.contains(&one.title());
    slow.is_none_or(|(_, count)| one.number() < *count) && !left_out
}

#[test]
fn answers_agree_with_the_frozen_ones() {
    let same_bits = std::env::var_os("GROUNDBEAM_SAME_BITS").is_some();
    let quick: Vec<Frozen> = all_frozen().into_iter().filter(is_quick).collect();
    let differences = |one: &Frozen| match same_bits {
        true => bits::differences(one, &one.solved_again().expect("a model")),
        false => bounds::differences(one, &solve(&one.model().expect("a model"))),
    };
    let found: Vec<String> =
        quick.par_iter().flat_map_iter(differences).map(|one| one.to_string()).collect();
    assert!(quick.len() > 3000, "{} models", quick.len());
    assert!(found.is_empty(), "{} differences:\n{}", found.len(), found.join("\n"));
}

#[test]
fn a_frozen_model_is_read_bit_for_bit() {
    for one in all_frozen() {
        let read = one.model().expect("a model");
        let again = Record::new(one.title(), &format::text(&read));
        assert_eq!(again, one.model);
    }
}

#[test]
fn a_random_model_is_read_back_as_written() {
    let families = [
        Family::Segments,
        Family::Supported,
        Family::Gap,
        Family::Long,
        Family::Varying,
        Family::Curled,
        Family::Settled,
        Family::Hinged,
        Family::OneWay,
        Family::Neighbours,
        Family::Shearing,
    ];
    for family in families {
        for number in 0..30 {
            let drawn = model(family, number);
            let written = Record::new("", &format::text(&drawn));
            let read = format::read(&written).expect("a model");
            assert_eq!(format!("{read:?}"), format!("{drawn:?}"), "{family:?} {number}");
        }
    }
}

#[test]
fn invalid_frozen_models_are_refused() {
    for line in ["beam 1.0 1.0", "point_force 0.5", "spring 1.0 2.0", "support 0.5 glued 0.0 both"]
    {
        assert!(format::read(&Record::new("", line)).is_err(), "{line}");
    }
}

/// A solve from another start stays within the bounds; a model that differs by 10⁻⁵ does not.
#[test]
fn the_bounds_separate_rounding_from_a_change() {
    let folder = frozen::folder();
    for family in ["Plain", "Segments", "Varying", "Hinged"] {
        for one in frozen::family(&folder, family).expect("the files of a family").iter().take(10) {
            let model = one.model().expect("a model");
            let Ok(Outcome::Equilibrium(near)) = solve(&model.clone().with_loads_scaled(1.01))
            else {
                panic!("{}: no answer", one.title())
            };
            let same = solve_near(&model, &Options::default(), Some(&near));
            assert_eq!(bounds::differences(one, &same), [], "{}", one.title());
            let other = solve(&model.with_loads_scaled(1.0 + 1e-5));
            assert!(!bounds::differences(one, &other).is_empty(), "{}", one.title());
        }
    }
}
