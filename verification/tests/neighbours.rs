//! Loads on the ground outside the beam and under it: superposition, reciprocity, Green's function; and ground that
//! ends outside the beam compared with infinite ground.
//!
//! Claims: `docs/ground.md`.

use groundbeam::{Beam, Field, Foundation, Load, Model, model::GroundEnd};
use groundbeam_verification::proven::proven_bounds;
use groundbeam_verification::solved::solved;

const SPRING: f64 = 9.0;
const SHEAR: f64 = 4.0;

fn footing() -> Model {
    Model::new(Beam::uniform(10.0, 40.0), Foundation::pasternak(SPRING, SHEAR))
        .with_load(Load::uniform_force(0.0, 10.0, 9.0))
        .with_load(Load::point_force(2.0, 5.0))
}

/// (2.4): the settlement of infinite ground under a unit force.
fn green(distance: f64) -> f64 {
    let b = f64::sqrt(SPRING / SHEAR);
    (-b * distance.abs()).exp() / (2.0 * SHEAR * b)
}

/// The free-field settlement acts like a clearance of the same size.
#[test]
fn a_load_on_the_ground_acts_like_an_initial_gap() {
    for (at, force) in [(-0.5, 14.0), (-3.0, 60.0), (10.0, 25.0), (11.5, 200.0)] {
        let model = footing().with_load(Load::ground_force(at, force));
        let exact = solved(&model);
        const CORNERS: u32 = 2000;
        let mut given = footing();
        for i in 0..=CORNERS {
            let x = 10.0 * f64::from(i) / f64::from(CORNERS);
            given = given.with_gap(x, force * green(x - at));
        }
        let sampled = solved(&given);
        assert!(exact.certificate().relative_gap() < 1e-12 && exact.lift_off().len() <= 1);
        // Between corners the error of the gap is at most h²/8 max|g₀″| = h²/8 b² force g(0).
        let off = (10.0 / f64::from(CORNERS)).powi(2) / 8.0 * (SPRING / SHEAR) * force * green(0.0);
        for i in 0..=40 {
            let x = 0.25 * f64::from(i);
            let [a, b] = [&exact, &sampled].map(|s| s.value(Field::Deflection, x));
            assert!((a - b).abs() < 2.0 * off, "{at} {x}: {a} {b} {off:e}");
        }
        let [a, b] = [&exact, &sampled].map(|s| s.contact()[0]);
        assert!((a.from - b.from).abs() < 2e-2 && (a.to - b.to).abs() < 2e-2, "{a:?} {b:?}");
    }
}

/// Betti: in full contact, the settlement of the ground at y under a force on the beam equals the deflection of the
/// beam under the same force on the ground at y.
#[test]
fn loads_on_beam_and_ground_satisfy_the_theorem_of_betti() {
    let layered = Foundation::pasternak(SPRING, SHEAR)
        .with_segment(-4.0, -1.0, 2.0, 7.0)
        .with_segment(3.0, 6.0, 5.0, 1.0)
        .with_ends(GroundEnd::Free { at: -5.0 }, GroundEnd::Held { at: 12.0 });
    let force = 1e-3;
    for ground in [Foundation::pasternak(SPRING, SHEAR), layered] {
        let base = Model { foundation: ground, ..footing() };
        let before = solved(&base);
        for x in [0.0, 2.5, 6.0, 10.0] {
            let loaded = solved(&base.clone().with_load(Load::point_force(x, force)));
            for y in [-4.5, -2.0, -0.25, 10.0, 11.25] {
                let beside = base.clone().with_load(Load::ground_force(y, force));
                let beside = solved(&beside);
                assert_eq!(beside.contact().len(), 1);
                let sunk = loaded.settlement(y) - before.settlement(y);
                let bent = beside.value(Field::Deflection, x) - before.value(Field::Deflection, x);
                assert!((sunk - bent).abs() < 1e-9 * force, "{x} {y}: {sunk:e} {bent:e}");
            }
        }
    }
}

/// u outside the beam follows from Green's function and all pressures on the ground.
#[test]
fn the_surface_outside_the_beam_follows_from_greens_function() {
    let model = footing()
        .with_load(Load::ground_force(-1.5, 20.0))
        .with_load(Load::ground_force(5.0, 8.0))
        .with_load(Load::distributed_ground_force(9.0, 13.0, 1.0, 6.0));
    let solution = solved(&model);
    assert!(!solution.lift_off().is_empty());
    let ends = solution.end_forces();
    let mut places = solution.stations(400);
    places.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    for y in [-4.0, -1.5, -0.2, 10.0, 10.7, 12.0, 15.0] {
        let mut u = ends.left * green(y) + ends.right * green(y - 10.0) + 20.0 * green(y + 1.5);
        u += 8.0 * green(y - 5.0);
        for force in solution.concentrated_forces() {
            u += force.force * green(y - force.at);
        }
        let simpson = |from: f64, to: f64, p: &dyn Fn(f64, bool) -> f64| {
            let middle = 0.5 * (from + to);
            let at = |x: f64, right: bool| p(x, right) * green(y - x);
            (to - from) / 6.0 * (at(from, true) + 4.0 * at(middle, true) + at(to, false))
        };
        let pressure = |x: f64, right: bool| {
            let side = if right {
                groundbeam::solution::Side::Right
            } else {
                groundbeam::solution::Side::Left
            };
            solution.at(x, side).pressure
        };
        u += places.windows(2).map(|x| simpson(x[0], x[1], &pressure)).sum::<f64>();
        let load = |x: f64, _: bool| 1.0 + 5.0 * (x - 9.0) / 4.0;
        let step = |i: u32| 9.0 + 0.01 * f64::from(i);
        u += (0..400).map(|i| simpson(step(i), step(i + 1), &load)).sum::<f64>();
        let found = solution.settlement(y);
        assert!((u - found).abs() < 1e-5 * found, "{y}: {u} {found}");
    }
}

/// Ground cut far away behaves like infinite ground; cut nearer it is softer, held nearer it is stiffer.
#[test]
fn ground_cut_near_the_beam_is_softer() {
    let sunk = |end: fn(f64) -> GroundEnd, distance: f64| {
        let ground = Foundation::pasternak(SPRING, SHEAR);
        let ground = ground.with_ends(end(-distance), end(10.0 + distance));
        let solution = solved(&Model { foundation: ground, ..footing() });
        let [error, ..] = proven_bounds(&solution);
        (solution.value(Field::Deflection, 0.0), error)
    };
    let (endless, _) = sunk(|_| GroundEnd::Endless, 1.0);
    let (mut free, mut held) = (f64::INFINITY, 0.0);
    for distance in [0.01, 0.1, 0.5, 1.0, 3.0, 30.0] {
        let (more, error) = sunk(|at| GroundEnd::Free { at }, distance);
        let (less, _) = sunk(|at| GroundEnd::Held { at }, distance);
        assert!(endless - error <= more && more <= free && held <= less && less <= endless + error);
        (free, held) = (more, less);
    }
    assert!((free - held).abs() < 1e-12, "{free} {held} {endless}");
}

/// Winkler ground under a beam's end is not coupled to a shear layer outside it: the surface may jump there.
#[test]
fn a_shear_layer_beside_winkler_ground_has_no_effect() {
    let springs = Model::new(Beam::uniform(10.0, 10.0), Foundation::winkler(5.0))
        .with_load(Load::uniform_force(0.0, 10.0, 1.0))
        .with_load(Load::point_force(0.0, 1.0));
    let mut beside = springs.clone();
    beside.foundation =
        beside.foundation.with_segment(-1.0, 0.0, 50.0, 20.0).with_segment(10.0, 12.0, 5.0, 3.0);
    let [alone, beside] = [&springs, &beside].map(solved);
    assert!(beside.certificate().relative_gap() < 1e-20);
    assert_eq!(beside.end_forces().left, 0.0);
    for i in 0..=20 {
        let x = 0.5 * f64::from(i);
        let [a, b] = [&alone, &beside].map(|s| s.value(Field::Deflection, x));
        assert_eq!(a.to_bits(), b.to_bits());
    }
}
