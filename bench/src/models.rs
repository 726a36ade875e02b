//! Generates the benchmark models, most of them at random with fixed seeds.

use groundbeam::{Beam, Foundation, Load, Model, Verdict, exists};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Model file of the long beam (case B).
const LONG_BEAM: &str = include_str!("../../cases/long-beam.toml");

/// Returns case B, a long soft beam with eight contact zones, under an axial force.
pub fn long_beam(axial_force: f64) -> Model {
    let document = groundbeam_file::parse(LONG_BEAM).expect("the case is readable");
    let mut model = document.model;
    model.beam.axial_force = axial_force;
    model
}

/// Returns random beams of 50 m length under random forces and moments (case C of the benchmark).
pub fn random_beams(count: usize) -> Vec<Model> {
    drawn(count, 1, |rng| {
        let l = 50.0;
        let stiffness = decade(rng, -1.0, 2.0);
        let shear = decade(rng, -2.0, 1.0);
        let mut model = Model::new(Beam::uniform(l, stiffness), Foundation::pasternak(1.0, shear));
        for _ in 0..rng.random_range(1..=12) {
            let force = rng.random_range(0.1..1.5);
            model.loads.push(Load::point_force(rng.random_range(0.0..l), force));
        }
        for _ in 0..rng.random_range(0..=4) {
            let force = -rng.random_range(0.05..0.4);
            model.loads.push(Load::point_force(rng.random_range(0.0..l), force));
        }
        for _ in 0..rng.random_range(0..=2) {
            let moment = rng.random_range(-1.0..1.0);
            model.loads.push(Load::point_moment(rng.random_range(0.0..l), moment));
        }
        model
    })
}

/// Returns random footings of typical size under 3 to 6 loads: column forces, column moments and usually the
/// self-weight. The footings have 1 to 3 contact zones.
pub fn footings(count: usize) -> Vec<Model> {
    drawn(count, 2, |rng| {
        let l: f64 = rng.random_range(4.0..16.0);
        let (width, depth) = (rng.random_range(0.8..2.5), rng.random_range(0.3..0.9));
        let stiffness = 30e9 * width * depth * depth * depth / 12.0;
        let spring = width * decade(rng, 7.0, 8.0);
        let shear = spring * rng.random_range(0.02..0.5);
        let mut model =
            Model::new(Beam::uniform(l, stiffness), Foundation::pasternak(spring, shear));
        let columns = rng.random_range(2..=4);
        for i in 0..columns {
            let at = l * (i as f64 + rng.random_range(0.2..0.8)) / f64::from(columns);
            model.loads.push(Load::point_force(at, rng.random_range(1e5..1.5e6)));
            if rng.random_range(0..3) == 0 {
                model.loads.push(Load::point_moment(at, rng.random_range(-1.5e6..1.5e6)));
            }
        }
        model.loads.push(Load::uniform_force(0.0, l, 24e3 * width * depth));
        model.loads.truncate(6);
        model
    })
}

/// Returns a rail of `length` metres under four-axle wagons, with one axle per five metres on average. The rail lifts
/// off between wagons that are far apart.
pub fn rail(length: f64, number: u64) -> Model {
    let mut rng = ChaCha8Rng::seed_from_u64(number);
    // The rail is a UIC60 profile on ballast with a shear layer. Its uniform load is its own weight plus half the
    // weight of the sleepers.
    let mut model = Model::new(Beam::uniform(length, 6.4e6), Foundation::pasternak(30e6, 2e6));
    model.loads.push(Load::uniform_force(0.0, length, 2500.0));
    let mut at = 2.0;
    let mut axle = 0;
    while at < length - 1.0 {
        model.loads.push(Load::point_force(at, rng.random_range(4e4..1.1e5)));
        // A wagon has four axles in two bogies. The distance between two wagons is random.
        axle += 1;
        at += match axle % 4 {
            1 | 3 => 1.8,
            2 => rng.random_range(5.0..8.0),
            _ => rng.random_range(4.0..14.0),
        };
    }
    model
}

fn decade(rng: &mut ChaCha8Rng, low: f64, high: f64) -> f64 {
    10_f64.powf(rng.random_range(low..high))
}

/// Draws random models and returns the first `count` of them that have a unique equilibrium.
fn drawn(count: usize, family: u64, draw: impl Fn(&mut ChaCha8Rng) -> Model) -> Vec<Model> {
    let mut rng = ChaCha8Rng::seed_from_u64(family);
    let stands = |model: &Model| exists(model).is_ok_and(|e| e.verdict == Verdict::Unique);
    std::iter::repeat_with(|| draw(&mut rng)).filter(stands).take(count).collect()
}
