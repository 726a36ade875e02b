//! Compares beams with shear deformation with the simplest elements, with equivalent models, and with limits.
//!
//! Claims: `docs/shear.md`.

use groundbeam::{
    Beam, Field, Foundation, Hinge, Load, Model, Solution, Support, load_factors,
    load_factors::FirstLiftOff, model::Profile, own_buckling_load, solution::Side,
};
use groundbeam_verification::linear::Linear;
use groundbeam_verification::random::{Family, model};
use groundbeam_verification::solved::solved;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::PI;

fn largest(solution: &Solution, field: Field) -> f64 {
    let range = solution.range(field);
    range.max.value.abs().max(range.min.value.abs())
}

/// Compares with elements with linear w and φ, one integration point each, nodal springs and contact by trial; they
/// share only the model with the solver. The limit of two meshes is compared, with a tolerance for the contact.
#[test]
fn linear_elements_converge_to_the_same_solution() {
    let mut rng = ChaCha8Rng::seed_from_u64(1921);
    let mut touching = 0;
    for number in 0..120 {
        let model = sheared(&mut rng);
        let exact = solved(&model);
        touching += usize::from(exact.contact().len() > 1);
        let [coarse, fine] = [400, 1600].map(|elements| Linear::solve(&model, elements));
        let size = largest(&exact, Field::Deflection);
        let [far, near] = [&coarse, &fine].map(|mesh| {
            let errors = mesh.w.iter().enumerate().map(|(i, w)| {
                let x = model.beam.length * (i as f64 / (mesh.w.len() - 1) as f64);
                (exact.value(Field::Deflection, x) - w).abs() / size
            });
            errors.fold(0.0, f64::max)
        });
        assert!(near < 1e-4 && near < 0.5 * far + 3e-5, "{number}: {far:e} {near:e} {model:?}");
        let turned = fine.rotation.iter().enumerate().skip(1).step_by(7).map(|(i, turned)| {
            let x = model.beam.length * (i as f64 / (fine.rotation.len() - 1) as f64);
            (exact.at(x, Side::Right).rotation - turned).abs()
        });
        let range = exact.range(Field::Rotation);
        let size = range.max.value.abs().max(range.min.value.abs()) + size / model.beam.length;
        let turned = turned.fold(0.0, f64::max) / size;
        assert!(turned < 2e-3, "{number}: φ off by {turned:e} {model:?}");
    }
    assert!(touching > 10, "{touching}");
}

/// A beam with loads, a support or a corner of the gap at the nodes of a uniform mesh.
fn sheared(rng: &mut ChaCha8Rng) -> Model {
    let node = |rng: &mut ChaCha8Rng| f64::from(rng.random_range(0..=20)) / 20.0;
    let (l, k) = (2.0, 1.0);
    let ei: f64 = 10_f64.powf(rng.random_range(-2.0..0.5));
    let mu = 10_f64.powf(rng.random_range(-2.0..0.5));
    let shear = ei * 10_f64.powf(rng.random_range(-0.5..2.5));
    let beam = Beam::uniform(l, ei).with_shear_stiffness(shear);
    let mut model = Model::new(beam, Foundation::pasternak(k, mu));
    model.beam.axial_force = if rng.random_bool(0.3) { rng.random_range(0.0..1.0) } else { 0.0 };
    model = model.with_load(Load::uniform_force(0.0, l, rng.random_range(0.3..1.0)));
    for _ in 0..rng.random_range(1..4) {
        let force = rng.random_range(-0.3..1.0);
        model = model.with_load(Load::point_force(l * node(rng), force));
    }
    if rng.random_bool(0.5) {
        let moment = rng.random_range(-0.2..0.2);
        model = model.with_load(Load::point_moment(l * node(rng), moment));
    }
    if rng.random_bool(0.4) {
        let at = l * node(rng);
        model = model.with_support(match rng.random_range(0..3) {
            0 => Support::pinned(at),
            1 => Support::fixed(at),
            _ => Support::spring(at, 3.0, 2.0),
        });
    }
    if rng.random_bool(0.4) {
        let (at, value) =
            (0.1 + 0.05 * f64::from(rng.random_range(1..36)), rng.random_range(-0.2..0.2));
        model = model.with_gap(0.0, 0.0).with_gap(at, value).with_gap(l, 0.0);
    }
    model
}

/// With increasing shear stiffness S the solution approaches the solution without shear deformation. The
/// error is proportional to 1/S.
#[test]
fn large_shear_stiffness_approaches_the_solution_of_bending() {
    for number in 0..60 {
        let plain = model(Family::Plain, number);
        let reference = solved(&plain);
        let at = |solution: &Solution, i: usize| {
            solution.value(Field::Deflection, plain.beam.length * i as f64 / 8.0)
        };
        let size = largest(&reference, Field::Deflection);
        let unit = plain.beam.bending_stiffness / plain.beam.length.powi(2);
        let mut last = f64::INFINITY;
        for power in [4, 6, 8] {
            let mut stiff = plain.clone();
            let waves = plain.foundation.subgrade * plain.beam.length.powi(2);
            stiff.beam.shear_stiffness = Some(10_f64.powi(power) * (unit + waves));
            let found = solved(&stiff);
            let error =
                (0..=8).map(|i| (at(&found, i) - at(&reference, i)).abs()).fold(0.0, f64::max);
            assert!(error < 0.05 * last || error < 1e-9 * size, "{number}: {error:e} {last:e}");
            last = error;
        }
    }
}

/// Betti's theorem for two loads on bonded beams.
#[test]
fn two_loads_on_a_bonded_beam_satisfy_the_theorem_of_betti() {
    let bed = Load::uniform_force(0.0, 3.0, 1.0);
    let beam = Beam::uniform(3.0, 0.4).with_shear_stiffness(2.0).with_shearing_segment(
        0.0,
        3.0,
        0.3,
        Profile::linear(1.0, 4.0),
    );
    let base = Model::new(beam, Foundation::pasternak(1.0, 0.6)).with_load(bed);
    let (force, moment) = (Load::point_force(0.7, 0.02), Load::point_moment(2.2, 0.015));
    let [alone, first, second] = [
        solved(&base),
        solved(&base.clone().with_load(force)),
        solved(&base.clone().with_load(moment)),
    ];
    for solution in [&alone, &first, &second] {
        assert_eq!(solution.contact().len(), 1, "{:?}", solution.contact());
    }
    let by_moment = second.value(Field::Deflection, 0.7) - alone.value(Field::Deflection, 0.7);
    let turned = |solution: &Solution| solution.at(2.2, Side::Right).rotation;
    let by_force = turned(&first) - turned(&alone);
    let [there, back] = [0.02 * by_moment, 0.015 * by_force];
    assert!((there - back).abs() < 1e-12 * there.abs(), "{there:e} {back:e}");
}

/// Engesser: P = P_E/(1 + P_E/S) for columns whose shear force comes from the axial force only.
#[test]
fn columns_buckle_at_the_load_of_engesser() {
    let (l, ei): (f64, f64) = (2.0, 3.0);
    for shear in [0.01, 1.0, 30.0, 1e6] {
        let beam = Beam::uniform(l, ei).with_shear_stiffness(shear);
        let column = Model::new(beam, Foundation::winkler(1.0));
        let load = |supports: [Support; 2]| {
            let [left, right] = supports;
            own_buckling_load(&column.clone().with_support(left).with_support(right))
        };
        let engesser = |euler: f64| euler / (1.0 + euler / shear);
        let euler = PI * PI * ei / (l * l);
        for (found, wanted) in [
            (load([Support::pinned(0.0), Support::pinned(l)]), engesser(euler)),
            (load([Support::fixed(0.0), Support::fixed(l)]), engesser(4.0 * euler)),
            (
                own_buckling_load(&column.clone().with_support(Support::fixed(0.0))),
                engesser(0.25 * euler),
            ),
        ] {
            assert!((found / wanted - 1.0).abs() < 1e-10, "{shear}: {found} {wanted}");
        }
    }
}

/// Where S + P is small, w and φ change rapidly, so cells are short. A beam with one segment and a beam with the same
/// stiffness in many segments have the same solution.
#[test]
fn a_compression_near_the_least_shear_stiffness_keeps_the_accuracy() {
    let model = |axial: f64, parts: u32| {
        let mut beam = Beam::uniform(10.0, 1e6).with_axial_force(axial);
        for i in 0..parts {
            let [from, to] = [i, i + 1].map(|i| 10.0 * f64::from(i) / f64::from(parts));
            let shear = Profile::linear(10.0 - 0.9 * from, 10.0 - 0.9 * to);
            beam = beam.with_shearing_segment(from, to, 1e6, shear);
        }
        Model::new(beam, Foundation::pasternak(0.1, 0.1))
            .with_support(Support::fixed(0.0))
            .with_support(Support::fixed(10.0))
            .with_load(Load::uniform_force(0.0, 10.0, 1.0))
    };
    for axial in [-0.9, -0.99, -0.999] {
        let [one, many] = [1, 64].map(|parts| solved(&model(axial, parts)));
        let gap = one.certificate().relative_gap();
        assert!(gap < 1e-18, "{axial}: {gap:e}");
        for i in 0..=20 {
            let x = 0.5 * f64::from(i);
            let [a, b] = [&one, &many].map(|solution| solution.value(Field::Deflection, x));
            let most = 1e-9 * largest(&one, Field::Deflection);
            assert!((a - b).abs() <= most, "{axial} {x}: {a} {b}");
        }
    }
}

/// A force causes a kink, with a concentrated contact force μF/(S + P + μ); at a pin that pushes up the kink opens and
/// the beam lifts off.
#[test]
fn a_kink_has_a_concentrated_contact_force_or_opens() {
    let (s, p, mu, force) = (3.0, 0.5, 0.8, 0.7);
    let beam = Beam::uniform(4.0, 1.0).with_shear_stiffness(s).with_axial_force(p);
    let base = Model::new(beam, Foundation::pasternak(1.0, mu))
        .with_load(Load::uniform_force(0.0, 4.0, 1.0));
    let pressed = solved(&base.clone().with_load(Load::point_force(1.5, force)));
    let [atom] = pressed.concentrated_forces() else { panic!() };
    assert!((atom.at - 1.5).abs() < 1e-12);
    assert!((atom.force - mu * force / (s + p + mu)).abs() < 1e-13);
    let [before, after] = [Side::Left, Side::Right].map(|side| pressed.at(1.5, side));
    assert!((before.slope - after.slope - force / (s + p + mu)).abs() < 1e-13);
    assert!((before.rotation - after.rotation).abs() < 1e-15);
    let held = solved(&base.with_support(Support::pinned(1.5).settled(0.5)));
    assert!(held.reactions()[0].force > 0.0);
    assert!(held.lift_off().iter().any(|span| span.from < 1.5 && span.to > 1.5));
}

/// The bonded beam gives the first lift-off.
#[test]
fn beams_with_shear_have_load_factors() {
    let beam = Beam::uniform(4.0, 1.0).with_shear_stiffness(2.0);
    let base = Model::new(beam, Foundation::pasternak(1.0, 0.3))
        .with_load(Load::uniform_force(0.0, 4.0, 1.0));
    let lifted = base.clone().with_load(Load::point_force(2.0, -0.1));
    let factors = load_factors(&lifted, |load| load == 1).expect("factors");
    // An upward force of any size opens the kink under it.
    assert_eq!(factors.first_lift_off, FirstLiftOff::AtOnce);
    let pushed = base.with_load(Load::point_moment(1.0, 1.0));
    let factors = load_factors(&pushed, |load| load == 1).expect("factors");
    let FirstLiftOff::At { factor, .. } = factors.first_lift_off else { panic!("{factors:?}") };
    let at = |factor: f64| {
        let mut model = pushed.clone();
        model.loads[1] = model.loads[1].scaled(factor);
        solved(&model).lift_off().len()
    };
    assert_eq!((at(factor * 0.999), at(factor * 1.001)), (0, 1));
}

/// An elastic hinge equals a short soft stretch of the beam without shear deformation.
#[test]
fn an_elastic_hinge_equals_a_short_soft_stretch() {
    let beam = Beam::uniform(3.0, 1.0).with_shear_stiffness(1.5);
    let model = Model::new(beam, Foundation::winkler(1e-13))
        .with_support(Support::fixed(0.0))
        .with_hinge(Hinge::elastic(1.0, 0.5))
        .with_load(Load::point_force(3.0, 0.2));
    let found = solved(&model);
    // F l³/3EI + F l/S + (F·2/k_φ)·2.
    let tip = 0.2 * (9.0 + 2.0 + 8.0);
    assert!((found.value(Field::Deflection, 3.0) - tip).abs() < 1e-10);
    assert!((found.hinges()[0].rotation - 0.8).abs() < 1e-11);
}
