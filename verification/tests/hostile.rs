//! Extreme numbers, positions that differ by a rounding error and files with random changes: nothing panics.

use groundbeam::{Beam, Foundation, Hinge, Load, Model, NodalSolution, NodalSolver};
use groundbeam_verification::hostile::{exercise, exercise_text, model, mutated, panics, texts};

/// Models for which the exact method fails only after many continuation steps.
const SLOW: [u64; 5] = [50, 60, 67, 76, 96];

#[test]
fn no_model_panics() {
    let mut faults = Vec::new();
    // The number of elements overflowed in the last three.
    for number in (0..100).chain([249, 629, 937]).filter(|number| !SLOW.contains(number)) {
        if let Some(panic) = panics(|| exercise(&model(number))) {
            faults.push(format!("{number}: {panic}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn no_file_panics() {
    let texts = texts();
    assert!(texts.len() > 50);
    let mut faults = Vec::new();
    for number in 0..150 {
        let text = mutated(&texts[number as usize % texts.len()], number);
        if let Some(panic) = panics(|| exercise_text(&text)) {
            faults.push(format!("{number}: {panic}\n{text}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn a_hinge_within_rounding_of_an_end_does_not_panic() {
    let beam = Beam::uniform(1e16, 1.0);
    let model = Model::new(beam, Foundation::winkler(4.0))
        .with_hinge(Hinge::elastic(3.0, 0.5))
        .with_load(Load::point_force(3.0, 1.0))
        .with_load(Load::uniform_force(0.0, 1e16, 1.0));
    assert_eq!(panics(|| exercise(&model)), None);
}

#[test]
fn numbers_of_nodes_that_overflow_are_refused() {
    let model = Model::new(Beam::uniform(1.0, 1e-60), Foundation::pasternak(1.0, 1.0))
        .with_load(Load::uniform_force(0.0, 1.0, 1.0));
    let stretched = Model { beam: model.beam.clone().with_axial_force(1e60), ..model.clone() };
    for (model, elements) in [(&model, usize::MAX), (&stretched, 1)] {
        let solved = NodalSolver::new().solve_into(model, elements, &mut NodalSolution::default());
        assert!(matches!(solved, Err(groundbeam::Error::TooLarge(_))), "{solved:?}");
    }
}
