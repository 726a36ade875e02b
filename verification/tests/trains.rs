//! Compares passages of trains with closed forms, brute force and the mirrored model.

use groundbeam::model::{Axle, Train};
use groundbeam::{
    Beam, Field, Foundation, Load, Model, Outcome,
    model::{Action, Extent},
    solution::Side,
    solve,
};
use groundbeam_file::MovingTrain;
use groundbeam_run::{Answers, OneThread, Run};
use groundbeam_verification::random::{Family, model};
use std::f64::consts::{FRAC_PI_2, PI};

const EI: f64 = 6.4e6;
const K: f64 = 40e6;

fn axle(behind: f64, force: f64) -> Axle {
    Axle { behind, force }
}

fn single(force: f64) -> Train {
    Train { axles: vec![axle(0.0, force)], uniform: Vec::new() }
}

/// A heavy rail on Winkler ground.
fn rail(length: f64, weight: f64) -> Model {
    Model::new(Beam::uniform(length, EI), Foundation::winkler(K))
        .with_load(Load::uniform_force(0.0, length, weight))
}

fn beta() -> f64 {
    (K / (4.0 * EI)).powf(0.25)
}

fn run(model: &Model, train: &Train, range: [f64; 2]) -> Run {
    let (name, train) = ("train".to_owned(), train.clone());
    Run::train(model.clone().into(), MovingTrain { name, train, range, ..MovingTrain::absent() })
}

fn answers(model: &Model, train: &Train, range: [f64; 2]) -> Answers {
    run(model, train, range).solve(&OneThread).unwrap()
}

/// Zimmermann, Die Berechnung des Eisenbahnoberbaues (1888), and Hetényi, Beams on Elastic Foundation (1946), § 3:
/// under a wheel F on an infinite rail M = F/(4β), w = Fβ/(2k) and V = ±F/2; at a quarter wave, βx = π/2, M = −e^(−π/2)
/// F/(4β).
#[test]
fn a_wheel_on_a_long_rail_agrees_with_zimmermann_and_hetenyi() {
    let (force, weight) = (100e3, 40e3);
    let answers = answers(&rail(20.0, weight), &single(force), [0.0, 20.0]);
    let passage = answers.passages().all[0];
    assert!(passage.reach().largest() <= 1e-3, "{:?}", passage.reach());
    assert_eq!(passage.uplift().ahead, None);
    let moment = force / (4.0 * beta());
    for x in [9.0, 9.77, 10.0, 10.3] {
        let all = passage.at(x).unwrap();
        let [deflection, bending, shear] =
            [Field::Deflection, Field::Moment, Field::ShearForce].map(|field| all[field.index()]);
        assert!((bending[1].value / moment - 1.0).abs() < 1e-3);
        assert!((bending[1].first_axle - x).abs() < 1e-12);
        assert!((bending[0].value / moment + (-FRAC_PI_2).exp()).abs() < 1e-3);
        let under = force * beta() / (2.0 * K) + weight / K;
        assert!((deflection[1].value / under - 1.0).abs() < 1e-3);
        for [bound, sign] in [[shear[0].value, -1.0], [shear[1].value, 1.0]] {
            assert!((bound / (0.5 * force) - sign).abs() < 1e-3);
        }
    }
}

/// The same closed form with the weight q: the rail first lifts off at βx = π on both sides of the wheel, under F = 2 q
/// e^π/β.
#[test]
fn a_rail_lifts_off_on_both_sides_of_the_wheel_at_the_closed_form_force() {
    let weight = 3e3;
    let limit = 2.0 * weight * PI.exp() / beta();
    let uplift = |force: f64| {
        let answers = answers(&rail(30.0, weight), &single(force), [12.0, 18.0]);
        answers.passages().all[0].uplift()
    };
    let before = uplift(0.999 * limit);
    assert_eq!((before.ahead, before.between, before.behind), (None, None, None));
    let after = uplift(1.01 * limit);
    let (ahead, behind) = (after.ahead.unwrap(), after.behind.unwrap());
    assert!((ahead.value / behind.value - 1.0).abs() < 1e-3);
    for gap in [ahead, behind] {
        assert!((beta() * (gap.x - gap.first_axle).abs() / PI - 1.0).abs() < 0.05);
    }
}

/// Compares the longest free span and the largest clearance with separate solves of each position, evaluated point by
/// point.
#[test]
fn free_spans_agree_with_separate_solves_of_each_position() {
    let (model, train) = (rail(30.0, 3e3), single(250e3));
    let answers = answers(&model, &train, [0.0, 30.0]);
    let passage = answers.passages().all[0];
    let found = passage.free_spans().unwrap();
    let [_, highest] = passage.range(Field::Gap).unwrap();
    let gap = found.highest.stretch.largest_gap;
    assert_eq!(
        (gap.x, gap.value, found.highest.first_axle),
        (highest.x, highest.value, highest.first_axle)
    );
    const STEPS: usize = 3000;
    let step = 30.0 / STEPS as f64;
    let (mut longest, mut largest) = (0.0_f64, 0.0_f64);
    for (at, _) in passage.solved() {
        let Outcome::Equilibrium(solution) = solve(&train.on(&model, at)).unwrap() else {
            panic!()
        };
        let mut open = 0.0;
        for i in 0..STEPS {
            let gap = solution.at((i as f64 + 0.5) * step, Side::Right).gap;
            open = if gap > 1e-15 { open + step } else { 0.0 };
            longest = longest.max(open);
            largest = largest.max(gap);
        }
    }
    assert!((found.longest.stretch.length() - longest).abs() <= 2.0 * step, "{longest} {found:?}");
    assert!(gap.value >= largest && gap.value < 1.01 * largest, "{largest} {found:?}");
    // A wheel that causes no lift-off.
    let light = run(&rail(30.0, 40e3), &single(1e3), [10.0, 20.0]).with_error(1e-2);
    let light = light.solve(&OneThread).unwrap();
    assert_eq!(light.passages().all[0].free_spans(), None);
}

/// A downward wheel and an upward one 9 m behind it: a slab tips about its right end where the moments about it vanish,
/// q l²/2 + F (l − s) = ¾F (l − s + 9).
#[test]
fn a_slab_tips_at_the_position_given_by_statics() {
    let (l, q, force) = (10.0, 2.65e3, 20e3);
    let slab = Model::new(Beam::uniform(l, 1e9), Foundation::pasternak(40e6, 4e6))
        .with_load(Load::uniform_force(0.0, l, q));
    let train = Train { axles: vec![axle(0.0, force), axle(9.0, -0.75 * force)], uniform: vec![] };
    let answers = answers(&slab, &train, [9.0, 10.0]);
    let passage = answers.passages().all[0];
    let edge = l - (0.75 * 9.0 * force - 0.5 * q * l * l) / (0.25 * force);
    let [[from, to]] = passage.without_equilibrium() else {
        panic!("{edge}: {:?}", passage.without_equilibrium())
    };
    assert!((from - edge).abs() < 1e-7 && *to == 10.0, "{edge}: {from} to {to}");
    assert!(passage.solved().count() > 10);
}

fn random() -> impl Iterator<Item = (String, Model)> {
    use Family::{Curled, Plain, Segments, Shearing, Supported, Winkler};
    [Plain, Winkler, Segments, Supported, Curled, Shearing]
        .into_iter()
        .flat_map(|family| (0..2).map(move |i| (format!("{family:?} {i}"), model(family, i))))
}

/// A train whose loads are comparable to those of the model.
fn suited(model: &Model) -> Train {
    let force =
        model.beam_loads().fold(0.0_f64, |most, load| match (load.action(), load.extent()) {
            (Action::Force, Extent::Point { size, .. }) => most.max(size.abs()),
            (Action::Force, Extent::Distributed { start, from, to, .. }) => {
                most.max((start * (to - from)).abs())
            }
            _ => most,
        });
    let behind = 0.13 * model.beam.length;
    Train { axles: vec![axle(0.0, force), axle(behind, 0.5 * force)], uniform: vec![] }
}

/// The solutions at twenty times as many positions lie within the envelope.
#[test]
fn solutions_at_more_positions_lie_within_the_envelope() {
    let mut faults = Vec::new();
    for (name, model) in random() {
        let (train, l) = (single(suited(&model).axles[0].force), model.beam.length);
        let answers = answers(&model, &train, [0.2 * l, 0.8 * l]);
        let passage = answers.passages().all[0];
        let scale = Field::ALL.map(|field| {
            let [min, max] =
                passage.range(field).map_or([0.0; 2], |r| r.map(|end| end.value.abs()));
            min.max(max)
        });
        let count = (20 * passage.answers().len()).min(1500);
        let sections: Vec<f64> = (0..=24).map(|i| l * f64::from(i) / 24.0).collect();
        let bounds: Vec<_> = sections.iter().map(|&x| passage.at(x)).collect();
        let mut worst = (0.0_f64, Field::Deflection, 0.0, 0.0);
        for i in 0..=count {
            let s = l * (0.2 + 0.6 * i as f64 / count as f64);
            let Ok(Outcome::Equilibrium(solution)) = solve(&train.on(&model, s)) else { continue };
            for (&x, bounds) in sections.iter().zip(&bounds) {
                let Some(bounds) = bounds else { continue };
                for side in [Side::Left, Side::Right] {
                    let here = solution.at(x, side);
                    for ((field, [min, max]), scale) in Field::ALL.iter().zip(bounds).zip(scale) {
                        let value = here.get(*field);
                        let out = (value - max.value).max(min.value - value) / scale;
                        if out > worst.0 {
                            worst = (out, *field, x, s);
                        }
                    }
                }
            }
        }
        let reach = passage.reach();
        println!("{name}: {} positions, {reach:?}, {worst:?}", passage.answers().len());
        if worst.0 > reach.asked.max(reach.of(worst.1)) {
            faults.push(format!("{name}: {worst:?} {reach:?}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// A train from the other side gives the mirrored results.
#[test]
fn a_train_from_the_other_side_gives_mirrored_results() {
    for (name, model) in random() {
        let (train, l) = (suited(&model), model.beam.length);
        let [from, to] = [0.2 * l, 0.8 * l];
        let seen = answers(&model, &train, [from, to]);
        let seen = seen.passages().all[0];
        // In the mirror, the last axle becomes the first.
        let mirrored = [to, from].map(|s| l - s + train.length());
        let image = answers(&model.mirrored(), &train.mirrored(), mirrored);
        let image = image.passages().all[0];
        for field in [Field::Deflection, Field::Moment, Field::Settlement] {
            let (Some(a), Some(b)) = (seen.range(field), image.range(field)) else {
                assert!(seen.range(field).is_none() && image.range(field).is_none(), "{name}");
                continue;
            };
            let error = 2.0 * seen.reach().of(field).max(image.reach().of(field)).max(1e-3);
            let scale = a[0].value.abs().max(a[1].value.abs());
            for (a, b) in a.iter().zip(&b) {
                let out = (a.value - b.value).abs() / scale;
                assert!(out <= error, "{name} {field:?}: {out} {:?}", seen.reach());
            }
        }
    }
}
