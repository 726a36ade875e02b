//! Draws random beams that touch the ground at one point only, so that the axial tension must balance the moment of the loads.

use groundbeam::{Beam, Foundation, Load, Model, Verdict, exists};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Returns the random model with the given number. A number always gives the same model.
pub fn model(number: u64) -> Model {
    let mut rng = ChaCha8Rng::seed_from_u64(number);
    loop {
        let model = draw(&mut rng);
        if exists(&model).is_ok_and(|existence| existence.verdict == Verdict::Unique) {
            return model;
        }
    }
}

fn draw(rng: &mut ChaCha8Rng) -> Model {
    let mut decades = |low: f64, high: f64| 10_f64.powf(rng.random_range(low..high));
    let (length, spring) = (decades(-1.0, 1.0), decades(-1.0, 1.0));
    let stiffness = 0.25 * spring * (length / decades(-0.5, 0.5)).powi(4);
    let layer = (spring * stiffness).sqrt() * decades(-1.0, 1.0);
    let mut beam = Beam::uniform(length, stiffness);
    beam.axial_force = stiffness / (length * length) * decades(-0.5, 1.5);
    if rng.random_bool(0.3) {
        let shear = stiffness / (length * length) * 10_f64.powf(rng.random_range(0.0..2.0));
        beam.shear_stiffness = Some(shear);
    }
    let top = match rng.random_range(0..3) {
        0 => 0.0,
        1 => length,
        _ => length * rng.random_range(0.2..0.8),
    };
    let mut loads = Vec::new();
    // The loads act near the highest point of the ground, so that the beam rotates little.
    for _ in 0..rng.random_range(1..4) {
        let off = length * rng.random_range(-0.1..0.1);
        let at = (top + off).clamp(0.0, length);
        loads.push(Load::point_force(at, rng.random_range(0.2..1.0)));
    }
    let total: f64 = loads.iter().map(|load| load.as_force(length)).sum();
    let turned = total / beam.axial_force;
    let settled = total / (2.0 * (spring * layer).sqrt());
    let fall = 3.0 * length * turned + 3.0 * settled + 0.1 * length;
    let mut model = Model::new(beam, Foundation::pasternak(spring, layer));
    for at in [0.0, top, length] {
        if at == top || (at - top).abs() > 0.1 * length {
            model = model.with_gap(at, fall * (at - top).abs() / length);
        }
    }
    for load in loads {
        model = model.with_load(load);
    }
    if rng.random_bool(0.3) {
        let at = length * rng.random_range(0.3..0.7);
        let hinge = 10_f64.powf(rng.random_range(-2.0..1.0)) * stiffness / length;
        let spring = if rng.random_bool(0.5) { 0.0 } else { hinge };
        model = model.with_hinge(groundbeam::Hinge { at, rotational_spring: spring });
    }
    model
}
