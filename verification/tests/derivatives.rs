//! Derivatives: against central differences of exact solutions, forward against backward, and closed forms.

use groundbeam::sensitivity::{
    Extent, LoadNumber, Output, Parameter, Property, SupportNumber,
};
use groundbeam::{Field, Load, Model, Outcome, Side, Solution, solve, solve_near, Options};
use groundbeam_verification::random::{Family, model};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn solved(model: &Model) -> Option<Solution> {
    match solve(model) {
        Ok(Outcome::Equilibrium(solution)) => Some(*solution),
        _ => None,
    }
}

/// The families whose models every derivative is tried on.
const FAMILIES: [Family; 14] = [
    Family::Plain,
    Family::Tension,
    Family::Segments,
    Family::Winkler,
    Family::Supported,
    Family::Gap,
    Family::Mixed,
    Family::Varying,
    Family::Curled,
    Family::Settled,
    Family::Hinged,
    Family::OneWay,
    Family::Beside,
    Family::Neighbours,
];

/// Everything that a model has.
fn parameters(model: &Model) -> Vec<Parameter> {
    use Property::{BendingStiffness, Shear, Spring};
    let mut all = vec![Parameter::AxialForce, Parameter::LoadFactor];
    let neighbours = model.loads.iter().any(Load::is_on_ground);
    for property in [BendingStiffness, Spring, Shear] {
        if neighbours && property != BendingStiffness {
            continue;
        }
        let segments = match property {
            BendingStiffness => model.beam.segments.len(),
            _ => model.foundation.segments.len(),
        };
        for extent in [Extent::Whole, Extent::OutsideSegments]
            .into_iter()
            .chain((0..segments).map(Extent::Segment))
        {
            all.push(Parameter::Factor(property, extent));
            let value = Parameter::Value(property, extent);
            if value.value(model).is_some_and(|value| value > 0.0) {
                all.push(value);
            }
        }
    }
    for i in 0..model.loads.len() {
        use LoadNumber::{At, End, From, Size, Start, To};
        all.extend([Size, At, From, To, Start, End].map(|number| Parameter::Load(i, number)));
    }
    for i in 0..model.supports.len() {
        use SupportNumber::{RotationalSpring, Settlement, Spring};
        let numbers = [Settlement, Spring, RotationalSpring];
        all.extend(numbers.map(|number| Parameter::Support(i, number)));
    }
    all.extend((0..model.hinges.len()).map(Parameter::HingeSpring));
    all.extend((0..model.gap.len()).map(Parameter::Gap));
    all.retain(|parameter| parameter.value(model).is_some());
    all
}

fn largest(solution: &Solution, field: Field) -> f64 {
    let range = solution.range(field);
    range.min.value.abs().max(range.max.value.abs())
}

/// Outputs, drawn at random, and what is large among their kind.
fn outputs(solution: &Solution, rng: &mut ChaCha8Rng) -> Vec<(Output, f64)> {
    let l = solution.model().beam.length;
    let mut all = Vec::new();
    for field in Field::ALL {
        let at = rng.random_range(0.0..1.0) * l;
        let side = if rng.random_bool(0.5) { Side::Left } else { Side::Right };
        let size = largest(solution, field);
        all.push((Output::Value(field, at, side), size));
        all.push((Output::Smallest(field), size));
        all.push((Output::Largest(field), size));
    }
    for i in 0..solution.contact().len().min(3) {
        all.extend([Side::Left, Side::Right].map(|side| (Output::Edge(i, side), l)));
    }
    let forces = largest(solution, Field::ShearForce);
    all.extend([Side::Left, Side::Right].map(|side| (Output::EndForce(side), forces)));
    for i in 0..solution.model().supports.len() {
        all.push((Output::SupportForce(i), forces));
        all.push((Output::SupportMoment(i), largest(solution, Field::Moment)));
    }
    if !solution.model().loads.iter().any(Load::is_on_ground) {
        all.push((Output::PotentialEnergy, solution.certificate().primal_energy.abs()));
    }
    all
}

fn value(solution: &Solution, output: Output) -> Option<f64> {
    Some(match output {
        Output::Value(field, x, side) => solution.at(x, side).get(field),
        Output::Smallest(field) => solution.range(field).min.value,
        Output::Largest(field) => solution.range(field).max.value,
        Output::Edge(i, side) => {
            let region = solution.contact().get(i)?;
            if side == Side::Left { region.from } else { region.to }
        }
        Output::EndForce(Side::Left) => solution.end_forces().left,
        Output::EndForce(Side::Right) => solution.end_forces().right,
        Output::SupportForce(i) => solution.reactions()[i].force,
        Output::SupportMoment(i) => solution.reactions()[i].moment,
        Output::PotentialEnergy => solution.certificate().primal_energy,
        _ => return None,
    })
}

/// A change of a parameter that matters.
fn unit(model: &Model, solution: &Solution, parameter: Parameter) -> f64 {
    let own = parameter.value(model).unwrap_or(0.0).abs();
    let l = model.beam.length;
    match parameter {
        Parameter::AxialForce => own.max(0.1 * model.beam.bending_stiffness / (l * l)),
        Parameter::Load(_, LoadNumber::At | LoadNumber::From | LoadNumber::To) => l,
        Parameter::Load(i, _) => match model.loads[i] {
            Load::PointForce { .. } | Load::PointMoment { .. } | Load::GroundForce { .. } => own,
            Load::Distributed { start, end, .. }
            | Load::DistributedMoment { start, end, .. }
            | Load::Curvature { start, end, .. }
            | Load::GroundDistributed { start, end, .. } => start.abs().max(end.abs()),
        },
        Parameter::Gap(_) | Parameter::Support(_, SupportNumber::Settlement) => {
            largest(solution, Field::Deflection)
        }
        Parameter::HingeSpring(_) => own.max(model.beam.bending_stiffness / l),
        _ => own,
    }
}

/// The difference quotient over a step; from one side where the other is no model.
fn quotients(solution: &Solution, outputs: &[(Output, f64)], parameter: Parameter, step: f64) -> Vec<Option<f64>> {
    let model = solution.model();
    let own = parameter.value(model).expect("a number");
    let after = |steps: f64| -> Option<Vec<Option<f64>>> {
        let model = parameter.set(model, own + steps * step)?;
        match solve_near(&model, &Options::default(), Some(solution)) {
            Ok(Outcome::Equilibrium(solution)) => {
                Some(outputs.iter().map(|(output, _)| value(&solution, *output)).collect())
            }
            _ => None,
        }
    };
    let at = |values: &[(f64, Vec<Option<f64>>)], i: usize| -> Option<f64> {
        let mut sum = 0.0;
        for (weight, values) in values {
            sum += weight * values[i]?;
        }
        Some(sum / step)
    };
    let here: Vec<Option<f64>> = outputs.iter().map(|(output, _)| value(solution, *output)).collect();
    let values = match (after(1.0), after(-1.0)) {
        (Some(more), Some(less)) => vec![(0.5, more), (-0.5, less)],
        (Some(more), None) => match after(2.0) {
            Some(most) => vec![(-1.5, here), (2.0, more), (-0.5, most)],
            None => return vec![None; outputs.len()],
        },
        (None, Some(less)) => match after(-2.0) {
            Some(least) => vec![(1.5, here), (-2.0, less), (0.5, least)],
            None => return vec![None; outputs.len()],
        },
        _ => return vec![None; outputs.len()],
    };
    (0..outputs.len()).map(|i| at(&values, i)).collect()
}

/// Every derivative of every output by every number of a model, against differences of solutions of their own.
#[test]
fn derivatives_are_limits_of_differences() {
    let from = std::env::var("FROM").ok().and_then(|v| v.parse().ok()).unwrap_or(0_u64);
    let count = std::env::var("COUNT").ok().and_then(|v| v.parse().ok()).unwrap_or(75_u64);
    let only = std::env::var("FAMILY").ok();
    let (mut compared, mut one_sided, mut models, mut bad, mut differ) = (0, 0, 0, 0, 0);
    for family in FAMILIES {
        if only.as_ref().is_some_and(|only| *only != format!("{family:?}")) { continue; }
        let mut wrong = 0;
        for number in from..from + count {
            let mut rng = ChaCha8Rng::seed_from_u64(number);
            rng.set_stream(100 + family as u64);
            let model = model(family, number);
            let Some(solution) = solved(&model) else { continue };
            let all = outputs(&solution, &mut rng);
            let mut parameters = parameters(&model);
            if let Ok(only) = std::env::var("PARAM") { parameters.retain(|p| format!("{p:?}").contains(&only)); }
            let alone: Vec<Output> = all.iter().map(|(output, _)| *output).collect();
            let gradients = match solution.gradients(&alone, &parameters) {
                Ok(g) => g,
                Err(e) => { println!("{family:?} {number}: {e}"); wrong += 1; continue; }
            };
            models += 1;
            let rows = solution.responses(&alone, &parameters).expect("forward");
            for (i, gradient) in gradients.iter().enumerate() {
                for (p, row) in rows.iter().enumerate() {
                    let (a, b) = (gradient.derivatives[p], row[i]);
                    let unit = unit(&model, &solution, parameters[p]);
                    let size = (a.abs() * unit).max(all[i].1);
                    if !((a - b).abs() * unit <= 1e-9 * size) && !gradient.one_sided.iter().any(|w| matches!(w, groundbeam::sensitivity::OneSided::Place{..})) {
                        differ += 1;
                        if differ < 30 { println!("FORWARD {family:?} {number}: {:?} by {:?}: {a:e} {b:e} {:.1e}", all[i].0, parameters[p], (a - b).abs() * unit / size); }
                    }
                }
            }
            for (p, parameter) in parameters.iter().enumerate() {
                let unit = unit(&model, &solution, *parameter);
                if unit == 0.0 { continue; }
                let mut errors = vec![f64::INFINITY; all.len()];
                let mut nearest = vec![f64::NAN; all.len()];
                let doubtful = |g: &groundbeam::sensitivity::Gradient| {
                    g.one_sided.iter().any(|why| match why {
                        groundbeam::sensitivity::OneSided::Place { parameter, .. } => *parameter == p,
                        _ => true,
                    })
                };
                for step in [1e-4, 1e-5, 1e-6, 1e-3, 1e-7] {
                    let quotients = quotients(&solution, &all, *parameter, step * unit);
                    for (i, quotient) in quotients.into_iter().enumerate() {
                        let Some(quotient) = quotient else { continue };
                        let exact = gradients[i].derivatives[p];
                        let size = (exact.abs() * unit).max(all[i].1);
                        let error = (quotient - exact).abs() * unit / size;
                        if error < errors[i] || errors[i].is_infinite() {
                            errors[i] = error;
                            nearest[i] = quotient;
                        }
                    }
                    let done = (0..all.len()).all(|i| errors[i] <= 1e-6 || doubtful(&gradients[i]));
                    if done { break; }
                }
                for i in 0..all.len() {
                    if doubtful(&gradients[i]) { one_sided += 1;
                        if std::env::var_os("WHY").is_some() { println!("{family:?} {number} {:?} {parameter:?} {:?}", all[i].0, gradients[i].one_sided.first()); }
                        continue; }
                    if all[i].1 == 0.0 { continue; }
                    compared += 1;
                    if !(errors[i] <= 1e-6) {
                        wrong += 1;
                        if wrong < 12 && std::env::var_os("QUIET").is_none() {
                            if std::env::var_os("MODEL").is_some() { println!("{:?} {:?} {:?}\n", model, solution.contact(), gradients[i]); }
                            println!("{family:?} {number}: {:?} by {parameter:?}: {:e} against {:e} error {:.1e} margin {:?}", all[i].0, gradients[i].derivatives[p], nearest[i], errors[i], solution.nearest_change().ok().flatten().map(|n| (n.condition, n.margin)));
                        }
                    }
                }
            }
        }
        println!("{family:?}: {wrong} wrong");
        bad += wrong;
    }
    println!("{models} models, {compared} compared, {one_sided} one-sided");
    assert_eq!(bad, 0);
}
