//! Checks derivatives against closed forms, general theorems and differences of multiprecision solutions, and the refusals.
//!
//! Claims: `docs/derivatives.md`.

use groundbeam::derivatives::{
    Domain, LoadNumber, NotDifferentiable, OneSided, Output, Parameter, Property, SupportNumber,
};
use groundbeam::{
    Beam, Field, Foundation, Load, Method, Model, Options, Outcome, Solution, Support,
    model::Action, solution::Side, solve_with,
};
use groundbeam_verification::random::{Family, model};
use groundbeam_verification::solved::solved;
use serde::Deserialize;

fn derivatives(solution: &Solution, output: Output, by: &[Parameter]) -> Vec<f64> {
    let gradient = solution.gradients(&[output], by).expect("derivatives").remove(0);
    gradient.derivatives
}

fn near(found: f64, exact: f64) {
    assert!((found - exact).abs() <= 1e-12 * exact.abs().max(1.0), "{found} {exact}");
}

/// A beam on two supports, high above the ground: influence lines of a force F at a, as in textbooks of statics.
#[test]
fn derivatives_of_a_simple_beam_are_its_influence_lines() {
    let (l, ei, a, force, x) = (6.0, 7.0, 2.0, 1.5, 4.0);
    let model = Model::new(Beam::uniform(l, ei), Foundation::winkler(1.0))
        .with_gap(0.0, 1e3)
        .with_support(Support::pinned(0.0))
        .with_support(Support::pinned(l))
        .with_load(Load::point_force(a, force));
    let solution = solved(&model);
    let settles = |i| Parameter::Support(i, SupportNumber::Settlement);
    let by = [
        Parameter::Load(0, LoadNumber::Size),
        Parameter::Load(0, LoadNumber::At),
        Parameter::Value(Property::BendingStiffness, Domain::Whole),
        settles(0),
        settles(1),
    ];
    // With b = l − x, right of the force: M = F a b/l, w = F a b (l² − a² − b²)/6EI l.
    let moment = derivatives(&solution, Output::Value(Field::Moment, x, Side::Right), &by);
    let exact = [a * (l - x) / l, force * (l - x) / l, 0.0, 0.0, 0.0];
    moment.iter().zip(exact).for_each(|(found, exact)| near(*found, exact));
    let b = l - x;
    let w = |a: f64| a * b * (l * l - a * a - b * b) / (6.0 * ei * l);
    let by_a = b * (l * l - 3.0 * a * a - b * b) / (6.0 * ei * l);
    let deflection = derivatives(&solution, Output::Value(Field::Deflection, x, Side::Left), &by);
    let exact = [w(a), force * by_a, -force * w(a) / ei, 1.0 - x / l, x / l];
    deflection.iter().zip(exact).for_each(|(found, exact)| near(*found, exact));
    let reaction = derivatives(&solution, Output::SupportForce(1), &by);
    let exact = [a / l, force / l, 0.0, 0.0, 0.0];
    reaction.iter().zip(exact).for_each(|(found, exact)| near(*found, exact));
}

/// The same for a beam with shear deformation: the force adds F a b/(S l) times a function that is 1 at its
/// position and linear to the supports, and w' decreases by F/S there (Timoshenko and Gere, *Mechanics of
/// Materials*, 1972, sec. 12.12).
#[test]
fn derivatives_of_a_simple_beam_with_shear_deformation() {
    let (l, ei, s, a, force, x) = (6.0, 7.0, 3.0, 2.0, 1.5, 4.0);
    let beam = Beam::uniform(l, ei).with_shear_stiffness(s);
    let model = Model::new(beam, Foundation::winkler(1.0))
        .with_gap(0.0, 1e3)
        .with_support(Support::pinned(0.0))
        .with_support(Support::pinned(l))
        .with_load(Load::point_force(a, force));
    let solution = solved(&model);
    let by = [
        Parameter::Load(0, LoadNumber::Size),
        Parameter::Load(0, LoadNumber::At),
        Parameter::Value(Property::BendingStiffness, Domain::Whole),
        Parameter::Value(Property::ShearStiffness, Domain::Whole),
    ];
    let b = l - x;
    let bends = |a: f64| a * b * (l * l - a * a - b * b) / (6.0 * ei * l);
    let shears = |a: f64| a * b / (s * l);
    let by_a = b * (l * l - 3.0 * a * a - b * b) / (6.0 * ei * l) + b / (s * l);
    let deflection = derivatives(&solution, Output::Value(Field::Deflection, x, Side::Left), &by);
    let exact =
        [bends(a) + shears(a), force * by_a, -force * bends(a) / ei, -force * shears(a) / s];
    deflection.iter().zip(exact).for_each(|(found, exact)| near(*found, exact));
    // At the force w' jumps by F/S, the difference between the slopes of the two linear parts.
    let slope = |side| derivatives(&solution, Output::Value(Field::Slope, a, side), &by[..1])[0];
    near(slope(Side::Left) - slope(Side::Right), 1.0 / s);
    // The rotation of the sections at the force is F a c (c − a)/(3 EI l) on both sides, from bending only.
    let (c, value) = (l - a, |side| Output::Value(Field::Rotation, a, side));
    for side in [Side::Left, Side::Right] {
        let turned = force * a * c * (c - a) / (3.0 * ei * l);
        let found = derivatives(&solution, value(side), &[by[0], by[2], by[3]]);
        let exact = [turned / force, -turned / ei, 0.0];
        found.iter().zip(exact).for_each(|(found, exact)| near(*found, exact));
    }
    // The energy −F w/2 at the force.
    let own = force * force;
    let energy = derivatives(&solution, Output::PotentialEnergy, &by);
    let under = a * a * c * c / (3.0 * ei * l) + a * c / (s * l);
    let moved = (2.0 * a * c * c - 2.0 * a * a * c) / (3.0 * ei * l) + (c - a) / (s * l);
    let exact = [
        -force * under,
        -0.5 * own * moved,
        0.5 * own * a * a * c * c / (3.0 * ei * ei * l),
        0.5 * own * a * c / (s * s * l),
    ];
    energy.iter().zip(exact).for_each(|(found, exact)| near(*found, exact));
}

/// A moment on a fixed support is carried by this support alone. A force turns the beam down on its left.
#[test]
fn derivatives_of_a_moment_on_a_fixed_support() {
    let model = Model::new(Beam::uniform(4.0, 3.0), Foundation::winkler(1.0))
        .with_gap(0.0, 1e3)
        .with_support(Support::fixed(4.0))
        .with_load(Load::point_force(1.0, 2.0))
        .with_load(Load::point_moment(4.0, 0.7));
    let by = [1, 0].map(|i| Parameter::Load(i, LoadNumber::Size));
    let moment = derivatives(&solved(&model), Output::SupportMoment(0), &by);
    near(moment[0], -1.0);
    near(moment[1], 3.0);
}

/// A force F on the ground at a distance d from a beam on a shear layer that does not touch: u = F e^(−b|x|)/(2√(kμ)).
#[test]
fn derivatives_of_the_settlement_outside_the_beam_under_a_force() {
    let (k, mu, force, d) = (3.0, 0.75, 2.0, 0.4);
    let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(k, mu))
        .with_gap(0.0, 1e3)
        .with_support(Support::fixed(0.0))
        .with_load(Load::ground_force(-d, force));
    let solution = solved(&model);
    let by = [
        Parameter::Value(Property::Spring, Domain::Whole),
        Parameter::Value(Property::Shear, Domain::Whole),
        Parameter::Load(0, LoadNumber::Size),
    ];
    let u = |x: f64| force * (-(k / mu).sqrt() * (x + d).abs()).exp() / (2.0 * (k * mu).sqrt());
    for x in [-1.5, -d, 0.5, 2.0] {
        let found = derivatives(&solution, Output::Value(Field::Settlement, x, Side::Right), &by);
        let part = 0.5 * (k / mu).sqrt() * (x + d).abs();
        near(found[0], -u(x) * (0.5 + part) / k);
        near(found[1], -u(x) * (0.5 - part) / mu);
        near(found[2], u(x) / force);
    }
    // Only the ground outside the beam, held at the beam's end, has energy without the beam's own end: −½F u(−d) + C.
    let energy = derivatives(&solution, Output::PotentialEnergy, &by[2..]);
    let held = force * (1.0 - (-2.0 * (k / mu).sqrt() * d).exp()) / (2.0 * (k * mu).sqrt());
    near(energy[0], -(u(-d) - held));
}

/// A uniform load q on uniform ground: w = q/k for any beam; the energy is −q²l/2k.
#[test]
fn derivatives_of_a_beam_under_uniform_load_on_uniform_springs() {
    let (l, k, q) = (3.0, 4.0, 2.0);
    let model = Model::new(Beam::uniform(l, 5.0), Foundation::winkler(k))
        .with_load(Load::uniform_force(0.0, l, q));
    let solution = solved(&model);
    let by = [
        Parameter::Value(Property::Spring, Domain::Whole),
        Parameter::Load(0, LoadNumber::Size),
        Parameter::Factor(Property::BendingStiffness, Domain::Whole),
        Parameter::AxialForce,
    ];
    let deflection = derivatives(&solution, Output::Value(Field::Deflection, 1.0, Side::Left), &by);
    let exact = [-q / (k * k), 1.0 / k, 0.0, 0.0];
    deflection.iter().zip(exact).for_each(|(found, exact)| near(*found, exact));
    let energy = derivatives(&solution, Output::PotentialEnergy, &by);
    let exact = [q * q * l / (2.0 * k * k), -q * l / k, 0.0, 0.0];
    energy.iter().zip(exact).for_each(|(found, exact)| near(*found, exact));
}

/// A rigid beam on Winkler ground, a force at a distance e > l/6 from its middle: the contact length is 3 (l/2 − e) and
/// depends on e only (the kern, as in textbooks on foundations).
#[test]
fn derivatives_of_the_contact_edge_of_a_rigid_beam() {
    let (l, e) = (6.0, 1.5);
    let model = Model::new(Beam::uniform(l, 1e9), Foundation::winkler(1.0))
        .with_load(Load::point_force(0.5 * l - e, 2.0));
    let solution = solved(&model);
    let by = [
        Parameter::Load(0, LoadNumber::At),
        Parameter::LoadFactor,
        Parameter::Factor(Property::Spring, Domain::Whole),
    ];
    let edge = derivatives(&solution, Output::Edge(0, Side::Right), &by);
    for (found, exact) in edge.iter().zip([3.0, 0.0, 0.0]) {
        assert!((found - exact).abs() < 1e-6, "{edge:?}");
    }
}

/// Without a gap and imposed displacements, every field is homogeneous of degree one in the loads, an edge of degree
/// zero, the energy of degree two (Euler's theorem). A deflection is homogeneous of degree −1 in beam, ground and
/// supports together.
#[test]
fn derivatives_satisfy_the_theorem_of_euler_on_homogeneous_functions() {
    let mut models = 0;
    for family in [
        Family::Plain,
        Family::Tension,
        Family::Segments,
        Family::Winkler,
        Family::Varying,
        Family::Shearing,
    ] {
        for number in 100..140 {
            let model = model(family, number);
            let curls = model.loads.iter().any(|load| load.action() == Action::Curvature);
            let imposed = !model.gap.is_empty() || curls;
            if imposed || !model.supports.is_empty() || !model.hinges.is_empty() {
                continue;
            }
            models += 1;
            let solution = solved(&model);
            let by = [
                Parameter::LoadFactor,
                Parameter::AxialForce,
                Parameter::Factor(Property::BendingStiffness, Domain::Whole),
                Parameter::Factor(Property::Spring, Domain::Whole),
                Parameter::Factor(Property::Shear, Domain::Whole),
                Parameter::Factor(Property::ShearStiffness, Domain::Whole),
            ];
            let by = if model.beam.shears() { &by[..] } else { &by[..5] };
            let x = 0.37 * model.beam.length;
            let outputs = [
                (Output::Value(Field::Deflection, x, Side::Left), 1.0, -1.0),
                (Output::Value(Field::Moment, x, Side::Left), 1.0, 0.0),
                (Output::Largest(Field::Pressure), 1.0, 0.0),
                (Output::EndForce(Side::Right), 1.0, 0.0),
                (Output::PotentialEnergy, 2.0, -1.0),
            ];
            for (output, in_loads, in_stiffness) in outputs {
                let found = solution.gradients(&[output], by).expect("derivatives").remove(0);
                let (by_loads, by_axial) = (found.derivatives[0], found.derivatives[1]);
                let [by_ei, by_k, by_mu, ..] = found.derivatives[2..] else {
                    panic!("five derivatives")
                };
                let by_ga = found.derivatives.get(5).copied().unwrap_or(0.0);
                let by_stiffness = by_axial * model.beam.axial_force + by_ei + by_k + by_mu + by_ga;
                let size = [by_ei, by_k, by_mu, found.value, by_loads];
                let size = size.iter().fold(0.0_f64, |size, part| size.max(part.abs()));
                let apart = |found: f64, exact: f64| (found - exact).abs() <= 1e-7 * size;
                assert!(apart(by_loads, in_loads * found.value), "{family:?} {number} {output:?}");
                assert!(
                    apart(by_stiffness, in_stiffness * found.value),
                    "{family:?} {number} {output:?}: {by_stiffness} {}",
                    found.value
                );
            }
        }
    }
    assert!(models > 100);
}

/// The derivatives of one model, by differences of solutions with 60 digits; `reference/derivatives.py` writes them.
#[derive(Debug, Deserialize)]
struct Reference {
    name: String,
    model: String,
    parameters: Vec<String>,
    /// A significant change of each parameter.
    units: Vec<f64>,
    outputs: Vec<ReferenceOutput>,
}

#[derive(Debug, Deserialize)]
struct ReferenceOutput {
    name: String,
    x: Option<f64>,
    value: f64,
    derivatives: Vec<f64>,
}

impl ReferenceOutput {
    /// The output, and the largest size of its kind in a solution.
    fn of(&self, solution: &Solution) -> (Output, f64) {
        let largest = |field| {
            let range = solution.range(field);
            range.min.value.abs().max(range.max.value.abs())
        };
        if let Some(x) = self.x {
            let field = Field::named(&self.name).expect("a field");
            return (Output::Value(field, x, Side::Right), largest(field));
        }
        let output = Output::named(&self.name).expect("an output");
        let size = match output {
            Output::Edge(..) => solution.model().beam.length,
            Output::SupportMoment(_) => largest(Field::Moment),
            _ => largest(Field::ShearForce),
        };
        (output, size)
    }
}

/// Largest difference between derivatives and those of the reference, relative to the largest size of the output.
const NEAR: f64 = 1e-12;

/// The same for a reaction of the beam with hinges. It is EI/h³ ≈ 10⁵ times a difference of deflections, so their rounding
/// errors are 10⁷ times as large as those of the force. The force itself has the same error.
const NEAR_STIFF: f64 = 3e-8;

/// Solves for the parameters and for the output agree with differences of multiprecision solutions.
#[test]
fn derivatives_agree_with_the_multiprecision_reference() {
    let text = include_str!("../../reference/derivatives.json");
    let all: Vec<Reference> = serde_json::from_str(text).expect("the reference derivatives");
    assert_eq!(all.len(), 10);
    for reference in all {
        let document = groundbeam_file::parse(&reference.model).expect("a model");
        let solution = solved(&document.model);
        let by: Vec<Parameter> = reference
            .parameters
            .iter()
            .map(|name| Parameter::named(name).expect("a parameter"))
            .collect();
        let (outputs, sizes): (Vec<Output>, Vec<f64>) =
            reference.outputs.iter().map(|own| own.of(&solution)).unzip();
        let forward = solution.gradients(&outputs, &by).expect("derivatives");
        let near = if reference.name == "hinged" { NEAR_STIFF } else { NEAR };
        let mut worst = (0.0, String::new());
        for (i, exact) in reference.outputs.iter().enumerate() {
            let adjoint = derivatives(&solution, outputs[i], &by);
            let apart = (forward[i].value - exact.value).abs() / sizes[i];
            assert!(apart < near, "{}: {} {}", reference.name, exact.name, apart);
            for (p, unit) in reference.units.iter().enumerate() {
                let scale = unit / sizes[i].max(exact.derivatives[p].abs() * unit);
                for found in [forward[i].derivatives[p], adjoint[p]] {
                    let apart = (found - exact.derivatives[p]).abs() * scale;
                    if apart > worst.0 {
                        let what =
                            format!("{} {:?} by {}", exact.name, exact.x, reference.parameters[p]);
                        worst = (apart, format!("{what}: {found} {}", exact.derivatives[p]));
                    }
                }
            }
        }
        println!("{}: {worst:?}", reference.name);
        assert!(worst.0 < near, "{}: {worst:?}", reference.name);
    }
}

/// Kikuchi's beam just before its left end lifts off: the result names the imminent change of contact.
#[test]
fn an_imminent_change_of_contact_is_reported() {
    let at = |moment: f64| {
        let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
            .with_load(Load::point_force(0.5, 1.0))
            .with_load(Load::point_moment(0.5, moment));
        let solution = solved(&model);
        let output = Output::EndForce(Side::Left);
        let gradient =
            solution.gradients(&[output], &[Parameter::LoadFactor]).expect("derivatives");
        (gradient[0].value, gradient[0].one_sided.clone())
    };
    // p₀ decreases linearly with the moment, from 0.1959… at 0.1 to 0.0146… at 0.3 (design notes of cases I and II).
    let [(a, _), (b, _)] = [at(0.1), at(0.3)];
    let zero = 0.3 + 0.2 * b / (a - b);
    assert!(at(zero - 1e-3).1.is_empty());
    assert!(matches!(at(zero - 1e-9).1[..], [OneSided::Contact(_)]));
}

#[test]
fn unsupported_derivatives_are_refused() {
    let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::winkler(1.0))
        .with_load(Load::point_force(0.5, 1.0));
    let output = [Output::Largest(Field::Deflection)];
    let by = |parameter| solved(&model).gradients(&output, &[parameter]).map(|_| ());
    let mu = Parameter::Value(Property::Shear, Domain::Whole);
    assert_eq!(by(mu), Err(NotDifferentiable::NoShearLayer));
    let none = Parameter::Load(1, LoadNumber::Size);
    assert_eq!(by(none), Err(NotDifferentiable::NoSuchParameter(none)));
    let options = Options { method: Method::ActiveSet, ..Options::default() };
    let Ok(Outcome::Equilibrium(meshed)) = solve_with(&model, &options) else {
        panic!("it stands")
    };
    let refused = meshed.gradients(&output, &[Parameter::LoadFactor]).map(|_| ());
    assert_eq!(refused, Err(NotDifferentiable::Method(Method::ActiveSet)));
}
