//! Compares one-way supports with a search over all sets of active supports, and with closed forms.
//!
//! Claims: `docs/methods.md`.

use groundbeam::{
    Beam, Error, Field, Foundation, Load, Method, Model, Options, Outcome, Solution, Support,
    Verdict, exists, model::Acts, solution::Side, solve, solve_with,
};
use groundbeam_verification::random::{Family, model};
use groundbeam_verification::solved::solved;

/// The clearance between the beam and a support that pushes up, or holds down; negative beyond it.
fn clearance(solution: &Solution, support: &Support) -> f64 {
    let w = solution.at(support.at, Side::Right).deflection;
    if support.acts == Acts::Up { -w } else { w }
}

fn largest(solution: &Solution) -> f64 {
    let range = solution.range(Field::Deflection);
    range.min.value.abs().max(range.max.value.abs())
}

/// Tries every set of active supports, as two-way supports. The set that satisfies all sign conditions has the same
/// deflection as the solution; every other set violates one.
#[test]
fn one_way_supports_agree_with_brute_force_over_all_active_sets() {
    let (mut states, mut lifted) = (0, 0);
    for number in 0..150 {
        let model = model(Family::OneWay, number);
        let answer = solved(&model);
        let one_way: Vec<usize> =
            (0..model.supports.len()).filter(|i| model.supports[*i].is_one_way()).collect();
        let size = largest(&answer);
        let forces: f64 = answer.reactions().iter().map(|r| r.force.abs()).sum();
        let mut right = 0;
        for state in 0..1_usize << one_way.len() {
            let acts = |i: usize| match one_way.iter().position(|o| *o == i) {
                Some(bit) => state >> bit & 1 == 1,
                None => true,
            };
            let mut choice = model.clone();
            let kept = model.supports.iter().enumerate().filter(|(i, _)| acts(*i));
            choice.supports = kept.map(|(_, support)| support.acting(Acts::Both)).collect();
            let Ok(Outcome::Equilibrium(found)) = solve(&choice) else { continue };
            states += 1;
            let mut reactions = found.reactions().iter();
            let mut keeps = true;
            for (i, support) in model.supports.iter().enumerate() {
                if !acts(i) {
                    keeps &= clearance(&found, support) >= -1e-10 * size;
                    continue;
                }
                let force = reactions.next().expect("a reaction").force;
                keeps &= match support.acts {
                    Acts::Both => true,
                    Acts::Up => force >= -1e-10 * forces,
                    Acts::Down => force <= 1e-10 * forces,
                };
            }
            if !keeps {
                continue;
            }
            right += 1;
            for i in 0..=20 {
                let x = model.beam.length * f64::from(i) / 20.0;
                let [a, b] = [&found, &answer].map(|s| s.value(Field::Deflection, x));
                assert!((a - b).abs() <= 1e-7 * size, "{number} {state} {x}: {a} {b}");
            }
        }
        assert!(right > 0, "{number}: {model:?}");
        lifted += one_way.iter().filter(|i| answer.reactions()[**i].force == 0.0).count();
    }
    assert!(states > 600 && lifted > 100, "{states} {lifted}");
}

/// Checks the conditions themselves, for both methods.
#[test]
fn reactions_and_clearances_satisfy_the_sign_conditions() {
    for number in 0..300 {
        let model = model(Family::OneWay, number);
        for method in [Method::Exact, Method::ActiveSet] {
            let options = Options { method, elements: 40, ..Options::default() };
            let answer = match solve_with(&model, &options) {
                Ok(Outcome::Equilibrium(answer)) => answer,
                other => panic!("{number}: {other:?}"),
            };
            let size = largest(&answer);
            for (support, reaction) in model.supports.iter().zip(answer.reactions()) {
                let sign = match support.acts {
                    Acts::Both => continue,
                    Acts::Up => 1.0,
                    Acts::Down => -1.0,
                };
                assert!(sign * reaction.force >= 0.0, "{number}: {reaction:?}");
                let clear = clearance(&answer, support);
                let rigid = support.kind == groundbeam::SupportKind::Pinned;
                assert!(!rigid || clear >= -1e-9 * size, "{number}: {clear} of {size}");
                assert!(
                    reaction.force == 0.0 || clear <= 1e-9 * size,
                    "{number}: {clear} of {size}"
                );
            }
        }
    }
}

/// A stiff beam on two bearings, off the ground, under a force beyond one of them: it needs a hold-down at the other,
/// where a bearing loses contact.
#[test]
fn a_hold_down_prevents_tipping_where_a_bearing_loses_contact() {
    let beam = |first: Acts| {
        Model::new(Beam::uniform(6.0, 10.0), Foundation::winkler(1.0))
            .with_gap(0.0, 1e6)
            .with_gap(6.0, 1e6)
            .with_support(Support::pinned(0.0).acting(first))
            .with_support(Support::pinned(4.0).acting(Acts::Up))
            .with_load(Load::point_force(5.0, 3.0))
    };
    let held = solved(&beam(Acts::Down));
    let forces: Vec<f64> = held.reactions().iter().map(|r| r.force).collect();
    assert!((forces[0] + 0.75).abs() < 1e-12 && (forces[1] - 3.75).abs() < 1e-12, "{forces:?}");
    assert!(held.certificate().relative_gap() < 1e-20);
    // Without the hold-down the beam tips onto the ground, 10⁶ below.
    let tipped = solved(&beam(Acts::Up));
    assert_eq!(tipped.reactions()[0].force, 0.0);
    assert!(
        tipped.value(Field::Deflection, 6.0) > 1e6 && tipped.value(Field::Deflection, 0.0) < 0.0
    );
}

/// An inactive bearing does not change the solution, bit for bit.
#[test]
fn an_inactive_bearing_does_not_change_the_solution() {
    let free = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
        .with_load(Load::point_force(0.5, 1.0))
        .with_load(Load::point_moment(0.5, 0.49))
        .with_load(Load::point_force(0.0, -0.005));
    let over = free.clone().with_support(Support::pinned(0.0).acting(Acts::Up));
    let [a, b] = [&free, &over].map(solved);
    assert!(a.value(Field::Deflection, 0.0) < 0.0);
    for x in [0.0, 0.3, 0.7, 1.0] {
        assert_eq!(a.value(Field::Deflection, x), b.value(Field::Deflection, x));
    }
    assert_eq!(b.reactions()[0].force, 0.0);
    // The mirrored model gives the same result.
    let mirrored = solved(&over.mirrored());
    let difference = mirrored.value(Field::Deflection, 0.3) - b.value(Field::Deflection, 0.7);
    assert!(difference.abs() < 1e-15);
}

/// A bearing does not prevent lifting; a hold-down prevents it like a pin.
#[test]
fn a_hold_down_prevents_lifting_and_a_bearing_does_not() {
    let tips = Model::new(Beam::uniform(4.0, 1.0), Foundation::pasternak(1.0, 1.0))
        .with_load(Load::point_force(2.0, 1.0))
        .with_load(Load::point_moment(2.0, 2.8));
    let stands = |support: Support| {
        let verdict = exists(&tips.clone().with_support(support)).expect("a verdict").verdict;
        !matches!(verdict, Verdict::None(_))
    };
    for x in [0.0, 1.0, 4.0] {
        assert!(!stands(Support::pinned(x).acting(Acts::Up)));
        assert_eq!(stands(Support::pinned(x).acting(Acts::Down)), stands(Support::pinned(x)));
        assert_eq!(
            stands(Support::spring(x, 1.0, 0.0).acting(Acts::Down)),
            stands(Support::pinned(x))
        );
    }
}

#[test]
fn a_one_way_clamp_is_refused() {
    let model = Model::new(Beam::uniform(4.0, 1.0), Foundation::pasternak(1.0, 1.0))
        .with_load(Load::point_force(2.0, 1.0));
    let fixed = model.with_support(Support::fixed(0.0).acting(Acts::Up));
    assert!(matches!(solve(&fixed), Err(Error::Invalid(p)) if p[0].code == "GB408"));
}
