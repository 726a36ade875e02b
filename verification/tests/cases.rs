//! Checks every model file below `cases/`: its expectations, and two methods against each other.
//!
//! Claims: `docs/verification.md`.

use groundbeam::{
    Error, Field, Method, Options, Outcome, Solution, Verdict, solution::Side, solve, solve_with,
};
use groundbeam_testing::expect_file;
use groundbeam_verification::cases::answers::Answers;
use groundbeam_verification::cases::{Case, all, manual::manual};
use groundbeam_verification::proven::proven_bounds;

fn readable() -> Vec<Case> {
    let (cases, faults): (Vec<_>, Vec<_>) = all().into_iter().partition(Result::is_ok);
    let faults: Vec<String> = faults
        .into_iter()
        .filter_map(Result::err)
        .map(|(path, misread)| format!("cases/{path}: {misread}"))
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    cases.into_iter().filter_map(Result::ok).collect()
}

fn report(faults: &[String]) {
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn every_case_meets_the_expectations_of_its_file() {
    let mut faults = Vec::new();
    for case in readable() {
        let path = &case.path;
        match Answers::of(&case.document) {
            Err(error) => faults.push(format!("cases/{path}: {error}")),
            Ok(answers) => {
                for expectation in &case.expectations {
                    if let Err(what) = answers.judge(expectation, &case.document) {
                        faults.push(format!("cases/{path}:{}: {what}", expectation.line));
                    }
                }
            }
        }
    }
    report(&faults);
}

#[test]
fn the_error_of_a_mesh_is_within_its_certificate() {
    let mut faults = Vec::new();
    let cases = readable();
    let models = cases.iter().flat_map(|case| case.models().into_iter().map(|m| (&case.path, m)));
    for (path, model) in models {
        let model = &model;
        // Eight elements per wave length of the beam, if the mesh is not too large. A mesh cannot resolve a beam of
        // thousands of wave lengths, nor the ground under a beam 10¹² times as stiff.
        let ei = model.beam.bending_stiffness;
        let waves = (model.foundation.subgrade / (4.0 * ei)).powf(0.25) * model.beam.length;
        if !(0.01..1000.0).contains(&waves) {
            continue;
        }
        let elements = (8.0 * waves).max(100.0) as usize;
        let options = Options { method: Method::ActiveSet, elements, ..Options::default() };
        let outcomes = (solve(model), solve_with(model, &options));
        let fault = match outcomes {
            (Ok(Outcome::Equilibrium(exact)), Ok(Outcome::Equilibrium(mesh))) => {
                farther_off_than_proven(&exact, &mesh)
            }
            (Ok(Outcome::NoEquilibrium(a)), Ok(Outcome::NoEquilibrium(b))) if a == b => None,
            // The mesh method refuses a local equilibrium.
            (Ok(Outcome::Equilibrium(exact)), Err(Error::Unsupported(problem)))
                if matches!(exact.existence().verdict, Verdict::Local(_))
                    && problem.code == "GB611" =>
            {
                None
            }
            (Err(error), _) | (_, Err(error)) => Some(error.to_string()),
            _ => Some("one method finds an equilibrium, the other none".to_owned()),
        };
        faults.extend(fault.map(|what| format!("cases/{path}: {what}")));
    }
    report(&faults);
}

/// Compares the bounds of the mesh's certificate with the exact solution. Returns a violation.
fn farther_off_than_proven(exact: &Solution, mesh: &Solution) -> Option<String> {
    let (proof, sharp) = (mesh.certificate(), exact.certificate());
    let strain =
        sharp.primal_energy().abs() + sharp.gap() / sharp.relative_gap().max(f64::MIN_POSITIVE);
    let rounding = 1e-11 * if strain.is_finite() { strain } else { sharp.primal_energy().abs() };
    // Between nodes the beam may pierce the ground, so the energy of a mesh may lie on either side of the exact one.
    let distance = (proof.primal_energy() - sharp.primal_energy()).abs();
    if distance > proof.gap() + rounding {
        return Some(format!(
            "the energy is {distance:e} from the exact one, the gap {:e}",
            proof.gap()
        ));
    }
    let l = exact.model().beam.length;
    let size = |field| {
        let range = exact.range(field);
        range.max.value.abs().max(range.min.value.abs())
    };
    let [settlement, moment, _] = proven_bounds(mesh);
    let settlement = settlement + 1e-10 * size(Field::Settlement);
    let moment = moment + 1e-10 * size(Field::Moment);
    const STATIONS: usize = 2000;
    for i in 0..STATIONS {
        let x = l * (i as f64 + 0.5) / STATIONS as f64;
        let (a, b) = (exact.at(x, Side::Right), mesh.at(x, Side::Right));
        if (a.settlement - b.settlement).abs() > settlement {
            return Some(format!(
                "u({x}) is {} exactly and {} with a mesh, farther apart than {settlement:e}",
                a.settlement, b.settlement
            ));
        }
        if (a.moment - b.moment).abs() > moment {
            return Some(format!(
                "M({x}) is {} exactly and {} with a mesh, farther apart than {moment:e}",
                a.moment, b.moment
            ));
        }
    }
    None
}

#[test]
fn the_verification_manual_agrees_with_the_cases() {
    expect_file("docs/verification.md", &manual(&readable()));
}
