//! Well-posed models near a limit of the theory: each has a unique answer that rounding error must not hide.

use groundbeam::{Beam, Foundation, Load, Model, Outcome, Solution, Support, solve};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

fn solution(model: &Model) -> Solution {
    match solve(model) {
        Ok(Outcome::Equilibrium(solution)) => *solution,
        other => panic!("{other:?}"),
    }
}

/// A beam on separate springs that a clamp at ground level holds presses up to the clamp: ψ = κx²/2 there.
#[test]
fn no_lift_off_of_rounding_error_beside_a_clamp_on_separate_springs() {
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
