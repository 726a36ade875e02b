//! Tests the labels of answers: combination, ground, train and position, method.

use groundbeam::{Error, Options, memory_estimate};
use groundbeam_file::{Document, parse};
use groundbeam_run::{Asked, Compare, Failed, Found, OneThread, Run};

const BEAM: &str = "[beam]\nlength = 12\nEI = 1.2e9\n[foundation]\nk = 40e6\n";
const CASES: &str = "[[load]]\npoint = 6e5\nat = 4\ncase = 'G'\n
    [[load]]\npoint = -9e5\nat = 8\ncase = 'W'\n
    [[combination]]\nname = 'a'\nfactors = { G = 1 }\n
    [[combination]]\nname = 'b'\nfactors = { G = 1, W = 1 }\n";
const TRAIN: &str = "[[train]]\nname = 'wheel'\naxles = [{ at = 0, force = 1e5 }]\n";

fn document(parts: &[&str]) -> Document {
    parse(&parts.concat()).unwrap()
}

#[test]
fn every_combination_is_solved_on_every_ground_of_the_band() {
    let band = "[foundation.band]\nk = [0.5, 2]\n";
    let answers = Run::of(&document(&[BEAM, band, CASES])).solve(&OneThread).unwrap();
    assert_eq!(answers.asked, Asked::Combinations);
    let label = |i: usize| {
        let combination = &answers.list[i].label.combination;
        (&*combination.name, combination.ground.unwrap()[0])
    };
    assert_eq!(answers.list.len(), 6);
    assert_eq!([label(0), label(2)], [("a; best ground", 1.0), ("a; 2 k", 2.0)]);
    // All loads act upward, so no equilibrium exists.
    assert!(answers.list[3..].iter().all(|a| matches!(a.found, Found::NoEquilibrium(_))));
    assert_eq!(answers.alone.iter().map(|alone| alone.stands()).collect::<Vec<_>>(), [true, false]);
}

#[test]
fn every_position_of_a_train_has_its_label() {
    let file = document(&[BEAM, CASES, TRAIN]);
    let run = Run::of_one(&file, file.combination("a").unwrap());
    assert_eq!((run.asked(), run.pieces(), Run::of(&file).pieces()), (Asked::Trains, 2, 4));
    let answers = run.solve(&OneThread).unwrap();
    let passages = answers.passages();
    let [passage, without] = &passages.all[..] else { panic!("with and without the train") };
    assert!(without.is_without_train() && without.answers().len() == 1);
    let with = answers.list.len() - 1;
    assert_eq!((passage.combination(), passage.answers().len()), (Some("a"), with));
    for (answer, (first_axle, _)) in answers.list.iter().zip(passage.solved()) {
        let placed = answer.label.train.as_ref().unwrap();
        assert_eq!((&*placed.train.name, placed.first_axle), ("wheel", first_axle));
        assert_eq!(*answer.label.model(), *answer.solution().unwrap().model());
    }
    // A single position gives the same model.
    let train = &file.trains[0];
    let alone = Run::at_position(&file, file.combination("a").unwrap(), train, 6.0);
    let alone = alone.solve(&OneThread).unwrap();
    assert_eq!((alone.asked, alone.list.len()), (Asked::One, 1));
    assert_eq!(alone.list[0].label.model().loads.len(), 2);
}

#[test]
fn every_method_has_its_name() {
    let file = document(&[BEAM, "[[load]]\npoint = 6e5\nat = 6\n"]);
    let compare = Compare { elements: 8, most_sweeps: 10, ..Compare::default() };
    let answers = Run::of(&file).compare(compare, &OneThread).unwrap();
    let names: Vec<&str> = answers.list.iter().map(|answer| answer.label.method).collect();
    assert_eq!(names, ["exact", "active-set", "psor", "uzawa"]);
    assert_eq!(names.len(), Compare::PIECES);
    assert!(matches!(answers.list[3].found, Found::NotConverged(_)), "{:?}", answers.list[3].found);
    // Only the exact method solves a beam that the ground keeps from buckling.
    let pressed = "[beam]\nlength = 5\nEI = 1\naxial_force = -0.5\n[foundation]\nk = 1\n";
    let file = document(&[pressed, "[[load]]\ndistributed = 1\n"]);
    let answers = Run::of(&file).compare(compare, &OneThread).unwrap();
    assert!(matches!(answers.list[3].found, Found::Unsolved(_)), "{:?}", answers.list[3].found);
}

#[test]
fn a_check_solves_nothing_and_a_refused_model_has_no_answers() {
    let answers = Run::of(&document(&[BEAM, CASES])).check().unwrap();
    let founds: Vec<bool> =
        answers.list.iter().map(|a| matches!(a.found, Found::Exists(_))).collect();
    assert_eq!((founds, answers.solved().count()), (vec![true, false], 0));
    let mut wrong = document(&[BEAM]);
    wrong.model.beam.length = -1.0;
    let refused = Run::of(&wrong).solve(&OneThread);
    assert!(matches!(refused, Err(Failed::Refused(_))), "{refused:?}");
}

#[test]
fn the_solutions_of_all_combinations_count_for_the_memory() {
    let named =
        |i: usize| format!("[[combination]]\nname = '{i}'\nfactors = {{ G = {} }}\n", i + 1);
    let load = "[[load]]\npoint = 6e5\nat = 4\ncase = 'G'\n";
    let many: String = (0..50).map(named).collect();
    let run = Run::of(&document(&[BEAM, load, &many]));
    let one = memory_estimate(&run.combinations()[0].model, &Options::default());
    let limited = |memory_limit| {
        let options = Options { memory_limit, ..Options::default() };
        run.clone().with_options(options).solve(&OneThread)
    };
    // Each model is below the limit, but all together exceed it.
    match limited(5 * one) {
        Err(Failed::Refused(Error::TooLarge(refused))) => assert_eq!(refused.needed, 11 * one),
        other => panic!("{other:?}"),
    }
    assert_eq!(limited(11 * one).unwrap().list.len(), 50);
}

/// A train with a load case has the factor of each combination. It does not pass in combinations without that
/// case.
#[test]
fn a_train_with_a_load_case_has_the_factor_of_each_combination() {
    let train = "[[train]]\nname = 'wheel'\ncase = 'T'\ndynamic = 2\n\
                 axles = [{ at = 0, force = 1e5 }]\nuniform = [{ from = 1, to = 2, load = 1e4 }]\n";
    let loads = "[[load]]\npoint = 6e5\nat = 4\ncase = 'G'\n\
                 [[combination]]\nname = 'with'\nfactors = { G = 1, T = 1.5 }\n\
                 [[combination]]\nname = 'without'\nfactors = { G = 1 }\n";
    let file = document(&[BEAM, loads, train]);
    let answers = Run::of(&file).solve(&OneThread).unwrap();
    let passages = answers.passages();
    let labels: Vec<String> = passages.all.iter().map(|passage| passage.label()).collect();
    assert_eq!(labels, ["with; wheel", "with; no train", "without; no train"]);
    let moving = passages.all[0].train();
    // The dynamic factor multiplies only the axle; the partial factor multiplies all loads.
    assert_eq!((moving.axles[0].force, moving.uniform[0].intensity), (3e5, 1.5e4));
}

/// The lane load is placed on the whole beam, on each half, and left out.
#[test]
fn a_lane_load_is_placed_on_the_whole_beam_and_on_each_half() {
    let train = "[[train]]\nname = 'lane'\naxles = [{ at = 0, force = 1e5 }]\n\
                 uniform = [{ load = 1e4 }]\n";
    let load = "[[load]]\npoint = 6e5\nat = 4\n";
    let answers = Run::of(&document(&[BEAM, load, train])).solve(&OneThread).unwrap();
    let passages = answers.passages();
    let resultant = |i: usize| {
        let (_, solution) = passages.all[i].nearest(6.0).unwrap();
        solution.existence().resultant()
    };
    let found: Vec<f64> = (0..passages.all.len()).map(resultant).collect();
    let expected = [82e4, 76e4, 76e4, 70e4];
    assert!(found.len() == 4 && found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-3));
    assert_eq!(passages.all[1].label(), "lane, spread load on the left half");
}
