//! Compares stiffness and ground that vary along a segment with equivalent models and limits.
//!
//! Claims: `docs/methods.md`.

use groundbeam::{
    Beam, Field, Foundation, Load, Method, Model, Options, Outcome, Solution, model::Profile,
    own_buckling_load, solution::Side, solve, solve_with,
};
use groundbeam_verification::proven::proven_bounds;

fn exact(model: &Model) -> Solution {
    match solve(model) {
        Ok(Outcome::Equilibrium(solution)) => *solution,
        other => panic!("{other:?}"),
    }
}

fn stiffness() -> Profile {
    Profile::by_control_values(&[1.0, 0.3, 0.5]).expect("a curve")
}

fn spring() -> Profile {
    Profile::linear(1.0, 4.0)
}

fn shear() -> Profile {
    Profile::linear(1.5, 0.4)
}

fn loaded(beam: Beam, ground: Foundation) -> Model {
    Model::new(beam, ground)
        .with_load(Load::point_force(1.0, 1.0))
        .with_load(Load::point_moment(2.0, -0.9))
        .with_load(Load::distributed_force(0.0, 3.0, 0.1, 0.3))
}

fn beam() -> Beam {
    Beam::uniform(4.0, 1.0)
}

fn smooth(shear: Profile) -> Model {
    loaded(
        beam().with_varying_segment(0.0, 4.0, stiffness()),
        Foundation::winkler(1.0).with_varying_segment(0.0, 4.0, spring(), shear),
    )
}

/// The same model with `n` equal steps, each with the values in its middle.
fn staircase(n: usize, shear: Profile) -> Model {
    let (mut beam, mut ground) = (beam(), Foundation::winkler(1.0));
    for i in 0..n {
        let [from, to] = [i, i + 1].map(|i| 4.0 * i as f64 / n as f64);
        let middle = (i as f64 + 0.5) / n as f64;
        beam = beam.with_segment(from, to, stiffness().at(middle));
        ground = ground.with_segment(from, to, spring().at(middle), shear.at(middle));
    }
    loaded(beam, ground)
}

fn fields(solution: &Solution, x: f64) -> [f64; 3] {
    let here = solution.at(x, Side::Right);
    [here.deflection, here.moment, here.settlement]
}

#[test]
fn equal_end_values_give_the_bits_of_a_constant() {
    let uniform = loaded(
        beam().with_segment(0.0, 4.0, 0.7),
        Foundation::winkler(1.0).with_segment(0.0, 4.0, 2.0, 0.5),
    );
    let same = Profile::by_control_values(&[0.7; 5]).expect("a curve");
    let ends = loaded(
        beam().with_varying_segment(0.0, 4.0, same),
        Foundation::winkler(1.0).with_varying_segment(
            0.0,
            4.0,
            Profile::linear(2.0, 2.0),
            Profile::linear(0.5, 0.5),
        ),
    );
    assert_eq!(uniform, ends);
}

/// The largest error of the stepped model in w, M, u at some positions, and in the last edge.
fn staircase_error(wanted: &Solution, n: usize, shear: Profile) -> [f64; 2] {
    let stairs = exact(&staircase(n, shear));
    let error = |x: f64| {
        let pair = fields(&stairs, x).into_iter().zip(fields(wanted, x));
        pair.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    let last = |solution: &Solution| solution.contact().last().map_or(f64::NAN, |zone| zone.to);
    let worst = (0..=16).map(|i| error(0.25 * f64::from(i))).fold(0.0, f64::max);
    [worst, (last(&stairs) - last(wanted)).abs()]
}

/// On Winkler ground; outside the beam the ground of a shear layer continues as the first and the last step.
#[test]
fn stepped_stiffness_converges_quadratically() {
    let even = Profile::constant(0.0);
    let wanted = exact(&smooth(even));
    assert!(wanted.certificate().relative_gap() < 1e-22);
    assert!(wanted.contact()[0].to < 3.9, "it lifts off: {:?}", wanted.contact());
    let errors: Vec<f64> = [16, 32, 64, 128, 256]
        .into_iter()
        .map(|n| staircase_error(&wanted, n, even).into_iter().fold(0.0, f64::max))
        .collect();
    for pair in errors.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!((3.7..4.3).contains(&ratio), "{errors:?}");
    }
}

/// Where μ decreases in steps and w' < 0 each step would need a tensile force −[μ]w'. So the beam lifts off beside
/// every step, and the stepped model converges only linearly.
#[test]
fn a_stepped_shear_layer_converges_linearly() {
    let wanted = exact(&smooth(shear()));
    let errors: Vec<f64> =
        [64, 128, 256, 512].into_iter().map(|n| staircase_error(&wanted, n, shear())[0]).collect();
    assert_eq!(wanted.contact().len(), 1);
    assert!(exact(&staircase(64, shear())).contact().len() > 5);
    for pair in errors.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!((1.7..2.6).contains(&ratio), "{errors:?}");
    }
}

#[test]
fn cutting_a_segment_does_not_change_the_solution() {
    let whole = exact(&smooth(shear()));
    let (a, b) = (0.375, 0.8);
    let (mut beam, mut ground) = (beam(), Foundation::winkler(1.0));
    for [from, to] in [[0.0, a], [a, b], [b, 1.0]] {
        let part = |profile: Profile| profile.part(from, to);
        let (x, y) = (4.0 * from, 4.0 * to);
        beam = beam.with_varying_segment(x, y, part(stiffness()));
        ground = ground.with_varying_segment(x, y, part(spring()), part(shear()));
    }
    let cut = exact(&loaded(beam, ground));
    assert!(cut.concentrated_forces().iter().all(|force| force.force.abs() < 1e-13));
    for i in 0..=40 {
        let x = 0.1 * f64::from(i);
        for (p, q) in fields(&whole, x).into_iter().zip(fields(&cut, x)) {
            assert!((p - q).abs() < 1e-12, "{x}: {p} {q}");
        }
    }
}

#[test]
fn the_mesh_converges_within_its_own_bounds() {
    let wanted = exact(&smooth(shear()));
    let mut gaps = Vec::new();
    for elements in [10, 20, 40, 80] {
        for method in [Method::ActiveSet, Method::Psor] {
            let options = Options { method, elements, ..Options::default() };
            let Ok(Outcome::Equilibrium(found)) = solve_with(&smooth(shear()), &options) else {
                panic!("{method:?} {elements}")
            };
            let proof = found.certificate();
            let excess = proof.primal_energy() - wanted.certificate().primal_energy();
            // Forces at nodes let the beam enter the ground between the nodes.
            assert!(excess >= -proof.gap() && excess <= proof.gap() * (1.0 + 1e-9), "{proof:?}");
            let [bound, ..] = proven_bounds(&found);
            for i in 0..=20 {
                let x = 0.2 * f64::from(i);
                let [_, _, u] = fields(&found, x);
                let [_, _, exact] = fields(&wanted, x);
                assert!((u - exact).abs() <= bound, "{method:?} {elements} {x}");
            }
            if method == Method::ActiveSet {
                gaps.push(proof.relative_gap());
            }
        }
    }
    for pair in gaps.windows(2) {
        assert!(pair[0] / pair[1] > 2.5, "{gaps:?}");
    }
}

/// A column whose EI falls linearly to zero would buckle at a Bessel function's zero; one that falls from
/// (1 + a)² to 1 with the square of a depth has a closed form: w″ + P/(EI₀ (x/b)²) w = 0 is Euler's equation,
/// solved by √x sin(β ln x) with β² = P b²/EI₀ − ¼, so that pins at x = b and x = 2b buckle at β ln 2 = π
/// (Timoshenko and Gere, Theory of Elastic Stability, bars with variable cross section).
#[test]
fn a_tapered_column_buckles_at_its_closed_form_load() {
    let depth = Profile::linear(1.0, 2.0);
    let inertia = depth.times(&depth).expect("a square");
    let column = Beam::uniform(1.0, 1.0).with_varying_segment(0.0, 1.0, inertia);
    let model = Model::new(column, Foundation::winkler(1.0))
        .with_support(groundbeam::Support::pinned(0.0))
        .with_support(groundbeam::Support::pinned(1.0));
    let beta = std::f64::consts::PI / 2_f64.ln();
    let wanted = beta * beta + 0.25;
    let found = own_buckling_load(&model);
    assert!((found / wanted - 1.0).abs() < 1e-11, "{found} {wanted}");
}

#[test]
fn fields_satisfy_their_differential_relations() {
    let solution = exact(&smooth(shear()));
    let h = 1e-5;
    for i in 1..20 {
        let x = 0.2 * f64::from(i) + 0.013;
        let at = |x: f64| solution.at(x, Side::Right);
        let rate = |field: Field| (at(x + h).get(field) - at(x - h).get(field)) / (2.0 * h);
        let here = at(x);
        assert!((rate(Field::Moment) - here.shear_force).abs() < 1e-8, "{x}");
        let bend = here.moment / stiffness().at(x / 4.0);
        assert!((rate(Field::Slope) + bend).abs() < 1e-8, "{x}");
        if here.gap == 0.0 {
            let flux = |x: f64| shear().at(x / 4.0) * at(x).slope;
            let pressure =
                spring().at(x / 4.0) * here.deflection - (flux(x + h) - flux(x - h)) / (2.0 * h);
            assert!((pressure - here.pressure).abs() < 1e-8, "{x}");
        }
    }
    // Outside the beam the ground continues as it is at the end.
    let b = (spring().end() / shear().end()).sqrt();
    let ratio = solution.settlement(4.7) / solution.settlement(4.0);
    assert!((ratio - (-0.7 * b).exp()).abs() < 1e-15);
}
