//! With twice as many chords of a settlement trough the results change by less than a thousandth: the quick models of
//! the family. `docs/ground.md` has the figures of all models, with the exceptions.

use groundbeam::{Field, Outcome, solve};
use groundbeam_file::parse;
use groundbeam_verification::troughs::{Result, result};

/// Solves a model with its chords and with twice as many. Returns whether it could be solved.
#[track_caller]
fn holds(number: u64) -> bool {
    match result(number) {
        Result::Solved { changed, .. } => {
            let largest = changed.fields.into_iter().fold(changed.edges, f64::max);
            assert!(largest < 1e-3, "{number}: {changed:?}");
            true
        }
        Result::Failed(error) => panic!("{number}: {error}"),
        Result::Refused(_) | Result::NoEquilibrium => false,
    }
}

#[test]
fn doubling_the_chords_does_not_change_results_on_winkler_ground() {
    let solved = (0..160).step_by(2).filter(|number| holds(*number)).count();
    assert!(solved >= 60, "{solved}");
}

#[test]
fn doubling_the_chords_does_not_change_results_on_a_shear_layer() {
    let solved = SHEAR.into_iter().filter(|number| holds(*number)).count();
    assert_eq!(solved, SHEAR.len());
}

/// Models over a shear layer that take less than a second and satisfy the limit: a guard against regressions, without
/// proof for the others.
const SHEAR: [u64; 23] =
    [1, 9, 11, 13, 15, 23, 27, 29, 33, 45, 47, 53, 57, 59, 69, 77, 79, 81, 83, 91, 99, 101, 103];

/// A pipe over a trough of 20 m: contact at two positions on the curve. The expected pressure comes from 40 000
/// equal chords.
#[test]
fn a_light_pipe_rests_on_both_sides_of_a_trough() {
    let text = "[beam]\nlength = '120 m'\nEI = '150 MN m^2'\n[foundation]\nk = '20 MN/m^2'\n
        [[load]]\ndistributed = '1.5 kN/m'\n
        [[gap_trough]]\nat = '60 m'\nsettlement = '0.8 m'\nwidth = '20 m'\n";
    let document = parse(text).unwrap();
    let Ok(Outcome::Equilibrium(solution)) = solve(&document.model) else { panic!() };
    assert_eq!(solution.contact().len(), 2);
    let pressure = solution.range(Field::Pressure).max.value;
    assert!((pressure / 3191.0 - 1.0).abs() < 1e-3, "{pressure}");
}
