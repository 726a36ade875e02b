//! Compares settled supports with closed forms.

use groundbeam::{
    Beam, Field, Foundation, Load, Method, Model, Options, Outcome, Solution, Support,
    solution::Side, solve_with,
};

const METHODS: [Method; 2] = [Method::Exact, Method::ActiveSet];

fn solved(model: &Model, method: Method) -> Solution {
    solved_on(model, method, 400)
}

fn solved_on(model: &Model, method: Method, elements: usize) -> Solution {
    let options = Options { method, elements, ..Options::default() };
    match solve_with(model, &options) {
        Ok(Outcome::Equilibrium(solution)) => *solution,
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} {b}: off by {:e}", (a - b).abs());
}

/// Two spans over a middle support that has settled by δ, far above the ground: M = 3 EI δ/L² over it.
#[test]
fn a_settled_middle_support_causes_the_closed_form_moment() {
    let (span, ei, delta) = (3.0, 2.0, 0.01);
    for method in METHODS {
        let model = Model::new(Beam::uniform(2.0 * span, ei), Foundation::pasternak(1.0, 0.5))
            .with_gap(0.0, 1.0)
            .with_support(Support::pinned(0.0))
            .with_support(Support::pinned(span).settled(delta))
            .with_support(Support::pinned(2.0 * span));
        let found = solved(&model, method);
        let moment = 3.0 * ei * delta / (span * span);
        assert!(found.contact().is_empty());
        close(found.value(Field::Moment, span), moment, 1e-13);
        close(found.value(Field::Deflection, span), delta, 1e-15);
        let forces: Vec<f64> = found.reactions().iter().map(|r| r.force).collect();
        for (force, expected) in forces.iter().zip([1.0, -2.0, 1.0]) {
            close(*force, expected * moment / span, 1e-13);
        }
        let energy = found.certificate();
        // −½ Σ R δ: the work that pulled the support down.
        close(energy.primal_energy(), 0.5 * 2.0 * moment / span * delta, 1e-14);
        close(energy.dual_energy(), energy.primal_energy(), 1e-14);
    }
}

/// A long weightless beam that a support presses into Winkler ground by δ: w = δ e^(−λx) (cos λx + sin λx) in contact,
/// with a support force of about 8 EI λ³ δ. Clamped at the end of a half beam, w = δ, w′ = 0, it is the same curve.
#[test]
fn a_settled_support_presses_a_beam_into_the_ground_with_the_closed_form_force() {
    let (l, k, lambda, delta) = (30.0, 4.0, 1.0_f64, 0.01);
    let ei = k / (4.0 * lambda.powi(4));
    let weight = 0.1;
    for method in METHODS {
        let model = Model::new(Beam::uniform(l, ei), Foundation::winkler(k))
            .with_load(Load::uniform_force(0.0, l, weight))
            .with_support(Support::fixed(0.0).settled(delta + weight / k));
        let found = solved_on(&model, method, 4000);
        let tolerance = if method == Method::Exact { 1e-13 } else { 1e-6 };
        for i in 0..=50 {
            let x = 0.3 * f64::from(i);
            let (sin, cos) = (lambda * x).sin_cos();
            let decay = (-lambda * x).exp();
            let w = weight / k + delta * decay * (cos + sin);
            close(found.value(Field::Deflection, x), w, tolerance);
            let moment = 2.0 * ei * lambda * lambda * delta * decay * (cos - sin);
            close(found.value(Field::Moment, x), moment, 10.0 * tolerance);
        }
        let [clamp] = found.reactions() else { panic!() };
        close(clamp.force, -4.0 * ei * lambda.powi(3) * delta, 10.0 * tolerance);
        close(clamp.moment, 2.0 * ei * lambda * lambda * delta, 10.0 * tolerance);
    }
}

/// A settled spring equals an unsettled spring with an additional force k δ down.
#[test]
fn a_settled_spring_equals_a_spring_and_a_force() {
    let (spring, delta) = (3.0, 0.2);
    let plain = Model::new(Beam::uniform(5.0, 1.0), Foundation::pasternak(1.0, 0.4))
        .with_load(Load::uniform_force(0.0, 5.0, 0.3));
    let held = Support::spring(1.0, spring, 0.5);
    let settled = plain.clone().with_support(held.settled(delta));
    let pressed = plain.with_support(held).with_load(Load::point_force(1.0, spring * delta));
    for method in METHODS {
        let [a, b] = [&settled, &pressed].map(|model| solved(model, method));
        for i in 0..=50 {
            let x = 0.1 * f64::from(i);
            let [a, b] = [&a, &b].map(|s| s.at(x, Side::Left));
            for field in Field::ALL {
                close(a.get(field), b.get(field), 1e-12);
            }
        }
        close(a.reactions()[0].force, b.reactions()[0].force - spring * delta, 1e-12);
        assert!(a.certificate().relative_gap() < 1e-3);
    }
}

/// Nodal pressures: the active set and both iterations of the paper on the same mesh.
#[test]
fn all_methods_agree_on_settled_supports_on_one_mesh() {
    let base = Model::new(Beam::uniform(4.0, 2.0), Foundation::pasternak(1.0, 0.8))
        .with_load(Load::uniform_force(0.0, 4.0, 0.2))
        .with_load(Load::uniform_curvature(0.0, 3.0, -0.05));
    let supports = [
        vec![Support::pinned(1.0).settled(0.1)],
        vec![Support::pinned(0.0).settled(-0.05), Support::spring(3.0, 2.0, 0.0).settled(0.1)],
        vec![Support::fixed(4.0).settled(0.07)],
    ];
    for supports in supports {
        let model = Model { supports, ..base.clone() };
        let by = |method| {
            let options = Options { method, elements: 8, ..Options::default() };
            match solve_with(&model, &options) {
                Ok(Outcome::Equilibrium(solution)) => *solution,
                other => panic!("{method:?}: {other:?}"),
            }
        };
        let [a, b, c] = [Method::ActiveSet, Method::Uzawa, Method::Psor].map(by);
        for i in 0..=8 {
            let x = 0.5 * f64::from(i);
            for other in [&b, &c] {
                close(a.value(Field::Deflection, x), other.value(Field::Deflection, x), 1e-8);
                close(a.value(Field::Settlement, x), other.value(Field::Settlement, x), 1e-8);
            }
        }
    }
}
