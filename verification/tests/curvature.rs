//! Compares imposed curvature with closed forms of curling slabs, and with equivalent point moments.

use groundbeam::{
    Beam, Field, Foundation, Load, Method, Model, Options, Outcome, Solution, Support,
    load_factors, model::Profile, solution::Side, solve_with,
};
use groundbeam_verification::solved::solved;

#[track_caller]
fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} {b}: off by {:e}", (a - b).abs());
}

/// Every field of one solution equals the field of the other solution, plus `more` for moment and shear
/// force.
#[track_caller]
fn alike(curled: &Solution, bent: &Solution, more: impl Fn(f64) -> [f64; 2]) {
    let l = curled.model().beam.length;
    for i in 0..=60 {
        let x = (l * (f64::from(i) / 60.0 + 1e-4)).min(l);
        let [a, b] = [curled, bent].map(|s| s.at(x, Side::Left));
        for field in [Field::Deflection, Field::Slope, Field::Settlement, Field::Pressure] {
            close(a.get(field), b.get(field), 1e-12);
        }
        let [moment, shear] = more(x);
        close(a.moment, b.moment + moment, 1e-12);
        close(a.shear_force, b.shear_force + shear, 1e-11);
    }
}

/// A uniform curvature equals a pair of moments EI κ₀ at the ends of its stretch: the same deflection, and EI κ₀ more
/// moment between them.
#[test]
fn a_uniform_curvature_equals_a_pair_of_moments() {
    for foundation in [Foundation::pasternak(1.0, 0.3), Foundation::winkler(2.0)] {
        let plain = Model::new(Beam::uniform(6.0, 1.5), foundation)
            .with_load(Load::point_force(2.0, 1.0))
            .with_load(Load::uniform_force(0.0, 6.0, 0.4));
        let curled = solved(&plain.clone().with_load(Load::uniform_curvature(1.0, 4.5, 0.2)));
        let moments =
            plain.with_load(Load::point_moment(1.0, -0.3)).with_load(Load::point_moment(4.5, 0.3));
        alike(&curled, &solved(&moments), |x| [if x > 1.0 && x <= 4.5 { 0.3 } else { 0.0 }, 0.0]);
        assert!(curled.certificate().relative_gap() < 1e-26);
    }
}

/// If EI and κ₀ are linear, EI κ₀ is a parabola: equivalent to end moments and a distributed moment −(EI κ₀)'.
#[test]
fn a_varying_curvature_of_a_varying_beam_equals_a_distributed_moment() {
    let (l, ei, curvature) = (4.0, |x: f64| 2.0 - 0.25 * x, |x: f64| 0.1 + 0.05 * x);
    let beam = Beam::uniform(l, 1.0).with_varying_segment(0.0, l, Profile::linear(ei(0.0), ei(l)));
    let plain = Model::new(beam, Foundation::pasternak(1.5, 0.4))
        .with_load(Load::point_force(1.3, 0.7))
        .with_load(Load::uniform_force(0.0, l, 0.3));
    let load = Load::distributed_curvature(0.0, l, curvature(0.0), curvature(l));
    let curled = plain.clone().with_load(load);
    let moment = |x: f64| ei(x) * curvature(x);
    let rise = |x: f64| 0.05 * ei(x) - 0.25 * curvature(x);
    let spread = Load::distributed_moment(0.0, l, -rise(0.0), -rise(l));
    let bent = plain
        .with_load(Load::point_moment(0.0, -moment(0.0)))
        .with_load(Load::point_moment(l, moment(l)))
        .with_load(spread);
    alike(&solved(&curled), &solved(&bent), |x| [moment(x), rise(x)]);
    // The equivalence also holds on a mesh.
    let options = Options { method: Method::ActiveSet, elements: 9, ..Options::default() };
    let [a, b] = [&curled, &bent].map(|model| match solve_with(model, &options) {
        Ok(Outcome::Equilibrium(solution)) => *solution,
        other => panic!("{other:?}"),
    });
    alike(&a, &b, |x| [moment(x), rise(x)]);
}

/// Westergaard, *Analysis of stresses in concrete pavements due to variations of temperature* (1926): near the free end
/// of a long slab M = EI κ₀ (1 − √2 e^(−λx) sin(λx + π/4)), and the end moves down by κ₀/(2λ²).
#[test]
fn the_end_of_a_long_slab_curls_by_the_formula_of_westergaard() {
    let (l, k, lambda, curvature) = (60.0, 4.0, 1.0_f64, 0.1);
    let ei = k / (4.0 * lambda.powi(4));
    let slab = Model::new(Beam::uniform(l, ei), Foundation::winkler(k))
        .with_load(Load::uniform_force(0.0, l, 0.5));
    for sign in [1.0, -1.0] {
        let curvature = sign * curvature;
        let found = solved(&slab.clone().with_load(Load::uniform_curvature(0.0, l, curvature)));
        assert_eq!(found.contact().len(), 1);
        close(found.contact()[0].to, l, 0.0);
        for i in 0..=100 {
            let x = 0.3 * f64::from(i);
            let (decay, turn) = ((-lambda * x).exp(), lambda * x);
            let westergaard =
                1.0 - 2_f64.sqrt() * decay * (turn + std::f64::consts::FRAC_PI_4).sin();
            close(found.value(Field::Moment, x), ei * curvature * westergaard, 1e-13);
            let sunk = curvature / (2.0 * lambda * lambda) * decay * (turn.cos() - turn.sin());
            close(found.value(Field::Deflection, x), 0.5 / k + sunk, 1e-13);
        }
    }
}

/// A slab with a warmer top that stands on its two ends: a simple beam under its own weight, with κ₀ l²/8 more
/// deflection.
#[test]
fn a_curled_beam_on_its_ends_deflects_like_a_simple_beam() {
    let (l, ei, q, curvature, k, mu) = (4.0_f64, 2.0, 0.03, 0.5, 40.0, 90.0);
    let model = Model::new(Beam::uniform(l, ei), Foundation::pasternak(k, mu))
        .with_load(Load::uniform_force(0.0, l, q))
        .with_load(Load::uniform_curvature(0.0, l, curvature));
    let found = solved(&model);
    assert_eq!(
        found.contact().iter().map(|c| (c.from, c.to)).collect::<Vec<_>>(),
        [(0.0, 0.0), (l, l)]
    );
    let b = (k / mu).sqrt();
    let sunk = 0.5 * q * l * (1.0 + (-b * l).exp()) / (2.0 * (k * mu).sqrt());
    for i in 0..=20 {
        let x = l * f64::from(i) / 20.0;
        let bent = q * x * (l.powi(3) - 2.0 * l * x * x + x.powi(3)) / (24.0 * ei);
        let curled = -0.5 * curvature * x * (l - x);
        close(found.value(Field::Deflection, x), sunk + bent + curled, 1e-13);
        close(found.value(Field::Moment, x), 0.5 * q * x * (l - x), 1e-13);
    }
}

/// If curling is not restrained there is no moment, for any EI. Clamped at both ends the beam stays straight under M =
/// EI κ₀. Clamped at one end and propped at the other it has M = 3/2 EI κ₀ at the clamp.
#[test]
fn restrained_curvature_causes_moments() {
    let (l, curvature) = (3.0, 0.2);
    let haunched = Beam::uniform(l, 1.0).with_varying_segment(0.0, l, Profile::linear(1.0, 3.0));
    let with = |beam: &Beam, left: Support, right: Support| {
        let model = Model::new(beam.clone(), Foundation::winkler(1.0));
        let model = model.with_support(left).with_support(right);
        solved(&model.with_load(Load::uniform_curvature(0.0, l, curvature)))
    };
    let even = Beam::uniform(l, 1.5);
    for beam in [&even, &haunched] {
        let simple = with(beam, Support::pinned(0.0), Support::pinned(l));
        for x in [0.0, 0.4, 1.5, 2.9] {
            close(simple.value(Field::Deflection, x), -0.5 * curvature * x * (l - x), 1e-14);
            close(simple.value(Field::Moment, x), 0.0, 1e-14);
        }
    }
    let fixed = with(&even, Support::fixed(0.0), Support::fixed(l));
    let propped = with(&even, Support::fixed(0.0), Support::pinned(l));
    for x in [0.0, 0.4, 1.5, 2.9] {
        close(fixed.value(Field::Moment, x), 1.5 * curvature, 1e-14);
        close(fixed.value(Field::Deflection, x), 0.0, 1e-14);
        close(propped.value(Field::Moment, x), 1.5 * 1.5 * curvature * (1.0 - x / l), 1e-14);
    }
    let [clamp, prop] = propped.reactions() else { panic!() };
    close(clamp.moment, 1.5 * 1.5 * curvature, 1e-14);
    close(prop.force, 1.5 * 1.5 * curvature / l, 1e-14);
}

/// With a hot top the middle of a slab rises: the factor on the temperature at first lift-off.
#[test]
fn a_slab_first_lifts_at_the_temperature_of_its_closed_form() {
    let (l, k, q) = (60.0, 4.0, 0.5);
    let slab = Model::new(Beam::uniform(l, 1.0), Foundation::winkler(k))
        .with_load(Load::uniform_force(0.0, l, q))
        .with_load(Load::uniform_curvature(0.0, l, 1.0));
    let found = load_factors(&slab, |load| load == 1).expect("factors");
    let groundbeam::load_factors::FirstLiftOff::At { factor, .. } = found.first_lift_off else {
        panic!("{found:?}")
    };
    // w has its minimum at λx = π/2: q/k = κ₀/(2λ²) e^(−π/2).
    close(factor, 2.0 * q / k * std::f64::consts::FRAC_PI_2.exp(), 1e-11);
}
