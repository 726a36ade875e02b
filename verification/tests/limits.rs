//! Well-posed models near a limit of the theory: each has a unique solution that rounding error must not hide.

use groundbeam::{
    Beam, Field, Foundation, Hinge, Load, Model, Outcome, Solution, Support, Verdict, load_factors,
    load_factors::LossOfEquilibrium, solution::EndForces, solve,
};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

fn solution(model: &Model) -> Solution {
    match solve(model) {
        Ok(Outcome::Equilibrium(solution)) => *solution,
        other => panic!("{other:?}"),
    }
}

/// A beam on Winkler ground held by a clamp at ground level has pressure up to the clamp: ψ = κx²/2 there.
#[test]
fn rounding_errors_cause_no_lift_off_beside_a_clamp_on_winkler_ground() {
    let named = Model::new(Beam::uniform(1.0, 2.0), Foundation::pasternak(4.0, 0.0))
        .with_load(Load::point_force(0.25, 2.0))
        .with_load(Load::point_force(0.5, 2.0))
        .with_load(Load::point_force(0.75, 1.0))
        .with_load(Load::uniform_force(0.0, 1.0, 1.0))
        .with_support(Support::fixed(1.0));
    let draw = |number: u64| {
        let mut rng = ChaCha8Rng::seed_from_u64(number);
        let stiffness = 10_f64.powf(rng.random_range(-1.0..2.0));
        let mut model = named.clone();
        model.beam = Beam::uniform(1.0, stiffness);
        for load in &mut model.loads {
            *load = load.scaled(rng.random_range(0.1..3.0));
        }
        model.supports[0] = Support::fixed([0.0, 0.4, 1.0][number as usize % 3]);
        model
    };
    let models: Vec<Model> = std::iter::once(named.clone()).chain((0..600).map(draw)).collect();
    models.into_par_iter().for_each(|model| {
        let found = solution(&model);
        for pair in found.contact().windows(2) {
            assert!(pair[1].from - pair[0].to > 1e-6, "{:?} of {model:?}", found.contact());
        }
        let clamp = model.supports[0].at;
        let near = |x: f64| x != clamp && (x - clamp).abs() < 1e-6;
        let ends = found.contact().iter().flat_map(|zone| [zone.from, zone.to]);
        assert!(!ends.into_iter().any(near), "{:?} of {model:?}", found.contact());
    });
}

/// A dimensionless beam B(l, EI, k, μ).
fn beam(length: f64, stiffness: f64, spring: f64, layer: f64) -> Model {
    let ground = match layer {
        0.0 => Foundation::winkler(spring),
        _ => Foundation::pasternak(spring, layer),
    };
    Model::new(Beam::uniform(length, stiffness), ground)
}

/// The largest difference of two solutions' deflection, moment and pressure between two positions of the first,
/// relative to the largest value of the second. The beam of the second begins at `from`.
fn difference(whole: &Solution, part: &Solution, from: f64) -> f64 {
    let l = part.model().beam.length;
    let fields = [Field::Deflection, Field::Moment, Field::Pressure];
    let of_field = |field: Field| {
        let range = part.range(field);
        let size = range.max.value.abs().max(range.min.value.abs());
        let at = |i: u32| {
            let x = l * (f64::from(i) + 0.5) / 50.0;
            (whole.value(field, from + x) - part.value(field, x)).abs() / size
        };
        (0..50).map(at).fold(0.0, f64::max)
    };
    fields.map(of_field).into_iter().fold(0.0, f64::max)
}

fn may_move(solution: &Solution) -> bool {
    matches!(solution.existence().verdict, Verdict::NotUnique(_))
}

/// The beam rotates about its end. The ground's surface decays there over √(μ/k), l/31.6.
#[test]
fn a_force_over_an_end_of_a_long_beam_on_a_shear_layer_is_solved() {
    for mu in [4.0, 0.4, 0.04, 0.004] {
        let on_left = beam(10.0, 1.0, 4.0, mu).with_load(Load::point_force(0.0, 1.0));
        for (model, end) in [(on_left.mirrored(), 10.0), (on_left, 0.0)] {
            let found = solution(&model);
            assert!(may_move(&found));
            let EndForces { left, right } = found.end_forces();
            assert!((if end == 0.0 { left } else { right } - 1.0).abs() < 1e-12, "{mu}");
            // (2.2): a force on infinite ground settles its surface by F/(2√(kμ)).
            let settled = found.settlement(end);
            assert!((settled * 2.0 * (4.0 * mu).sqrt() - 1.0).abs() < 1e-12, "{mu}: {settled}");
        }
    }
}

/// Closed form on Winkler ground: the contact length of a rigid beam is three times the distance of the resultant from
/// the end.
#[test]
fn a_resultant_near_an_end_on_winkler_ground_has_the_closed_form_contact_length() {
    for off in [1e-3, 1e-6, 1e-9] {
        let model = beam(1.0, 1.0, 4.0, 0.0).with_load(Load::point_force(off, 1.0));
        for (model, end) in [(model.clone(), 0.0), (model.mirrored(), 1.0)] {
            let found = solution(&model);
            let [zone] = found.contact() else { panic!("{off}: one zone") };
            let touches = (zone.to - zone.from) / off;
            assert!((touches - 3.0).abs() < 1e-2, "{off}, {end}: {touches}");
            assert!([zone.from, zone.to].contains(&end), "{off}: {zone:?}");
        }
    }
}

/// Unloaded parts beyond a free hinge rotate freely. The rest has the solution without these parts.
#[test]
fn unloaded_parts_beyond_free_hinges_do_not_change_the_rest() {
    let force = Load::point_force;
    let hinged = |layer: f64| {
        [2.0, 4.0, 6.0]
            .into_iter()
            .fold(beam(8.0, 1.0, 1.0, layer), |model, at| model.with_hinge(Hinge::free(at)))
    };
    let mut cases = vec![(
        beam(10.0, 1.0, 4.0, 0.4).with_load(force(5.0, 1.0)).with_hinge(Hinge::free(9.9)),
        beam(9.9, 1.0, 4.0, 0.4).with_load(force(5.0, 1.0)),
        0.0,
    )];
    for layer in [0.0, 1.0] {
        let three = beam(3.0, 1.0, 1.0, layer).with_load(force(0.7, 1.0));
        let two = |at: f64| beam(2.0, 1.0, 1.0, layer).with_load(force(at, 1.0));
        cases.push((three.with_hinge(Hinge::free(2.0)), two(0.7), 0.0));
        cases.push((hinged(layer).with_load(force(1.0, 1.0)), two(1.0), 0.0));
        cases.push((hinged(layer).with_load(force(2.5, 1.0)), two(0.5), 2.0));
        cases.push((hinged(layer).with_load(force(7.5, 1.0)), two(1.5), 6.0));
    }
    for (model, rest, from) in cases {
        let (whole, part) = (solution(&model), solution(&rest));
        assert!(may_move(&whole), "{model:?}");
        let different = difference(&whole, &part, from);
        assert!(different < 1e-4, "{different}: {model:?}");
        let on_layer = model.foundation.shear_layer > 0.0;
        assert!(!on_layer || different < 1e-9, "{different}: {model:?}");
    }
    // A force on a hinge between two unloaded parts is carried at that point.
    let found = solution(&hinged(1.0).with_load(force(2.0, 1.0)));
    assert!(may_move(&found) && found.concentrated_forces().len() == 1);
    assert!((found.concentrated_forces()[0].force - 1.0).abs() < 1e-12);
}

/// Closed form on endless ground: a force between two quiet stretches settles by F/(2 EI σπ), σ = (N/EI + 2π)^½, π = (k/EI)^½.
#[test]
fn a_beam_of_a_million_metres_has_the_closed_form_settlement() {
    let l = 1e6;
    let model = beam(l, 1.0, 4.0, 1.0)
        .with_load(Load::uniform_force(0.0, l, 1.0))
        .with_load(Load::point_force(0.5 * l, 1.0));
    let found = solution(&model);
    assert!(found.elements() < 200, "{}", found.elements());
    let settled = 0.25 + 1.0 / (2.0 * 5_f64.sqrt() * 2.0);
    assert!((found.value(Field::Deflection, 0.5 * l) - settled).abs() < 1e-14);
    assert!(found.certificate().relative_gap() < 1e-18);
    assert_eq!(found.contact().len(), 1);
}

/// Nothing acts: the beam lies where it is.
#[test]
fn an_unloaded_beam_over_a_gap_does_not_move() {
    let model = beam(12.0, 1.2e9, 40e6, 0.0).with_gap(0.0, 0.002).with_gap(4.0, 0.0);
    let found = solution(&model);
    assert!(may_move(&found));
    assert_eq!(found.certificate().relative_gap(), 0.0);
    assert_eq!(found.range(Field::Deflection).max.value, 0.0);
    assert_eq!(found.range(Field::Pressure).max.value, 0.0);
}

/// Zones with ends between corners of the clearance and a hinge, on a beam with shear deformation and a stiff
/// layer.
#[test]
fn a_hinged_beam_with_shear_deformation_over_corners_of_the_clearance_is_solved() {
    let mut model = beam(0.71, 0.59, 240.0, 3700.0)
        .with_load(Load::point_moment(0.43, 0.1))
        .with_load(Load::uniform_force(0.0, 0.71, 1.5))
        .with_gap(0.024, 0.00076)
        .with_gap(0.57, 0.0035)
        .with_gap(0.69, -0.0011)
        .with_hinge(Hinge::free(0.22));
    model.beam.shear_stiffness = Some(0.54);
    assert_eq!(solution(&model).contact().len(), 3);
}

/// At the factor of the loss of equilibrium the resultant is over an end, and a beam on a shear layer has an
/// equilibrium.
#[test]
fn equilibrium_exists_at_the_factor_of_its_loss() {
    let model = beam(10.0, 1.0, 4.0, 0.4)
        .with_load(Load::point_force(5.0, 1.0))
        .with_load(Load::point_moment(5.0, -1.0));
    let found = load_factors(&model, |load| load == 1).expect("factors");
    let LossOfEquilibrium::At { factor, .. } = found.loss_of_equilibrium else {
        panic!("{found:?}")
    };
    assert_eq!(factor, 5.0);
    let mut at_loss = model;
    at_loss.loads[1] = at_loss.loads[1].scaled(factor);
    let found = solution(&at_loss);
    assert!(may_move(&found) && found.end_forces().left > 0.999, "{:?}", found.end_forces());
}
