//! The certificate's claims: errors stay within their bounds, and the bounds are sharp.

use groundbeam::{Field, Method, Model, Options, Outcome, Side, Solution, solve, solve_with};
use groundbeam_verification::estimated::estimated_bounds;
use groundbeam_verification::random::{Family, model};
use groundbeam_verification::reference::Answer;

/// Models whose coarse mesh takes minutes (tests/reference.rs).
const TOO_STIFF: [&str; 3] = ["hard-005", "hard-006", "hard-007"];

fn solved(model: &Model, options: &Options) -> Option<Solution> {
    match solve_with(model, options) {
        Ok(Outcome::Equilibrium(solution)) => Some(*solution),
        _ => None,
    }
}

fn largest(solution: &Solution, field: Field) -> f64 {
    let range = solution.range(field);
    range.max.value.abs().max(range.min.value.abs())
}

/// √∫(M − M*)²/EI, by Gauss's rule between every two places where either may have a corner.
fn moment_error(coarse: &Solution, exact: &Solution) -> f64 {
    const GAUSS: [(f64, f64); 3] = [
        (0.238_619_186_083_196_9, 0.467_913_934_572_691),
        (0.661_209_386_466_264_5, 0.360_761_573_048_138_6),
        (0.932_469_514_203_152, 0.171_324_492_379_170_4),
    ];
    let mut x = coarse.stations(0);
    x.extend(exact.stations(0));
    x.extend(
        (0..=coarse.elements())
            .map(|i| coarse.model().beam.length * (i as f64 / coarse.elements() as f64)),
    );
    x.sort_by(f64::total_cmp);
    let mut sum = 0.0;
    for pair in x.windows(2).filter(|pair| pair[0] < pair[1]) {
        let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
        let stiffness = coarse.model().beam.bending_stiffness_at(middle);
        for (s, weight) in GAUSS {
            for at in [middle - half * s, middle + half * s] {
                let moment = |solution: &Solution| solution.at(at, Side::Right).moment;
                let error = moment(coarse) - moment(exact);
                sum += weight * half * error * error / stiffness;
            }
        }
    }
    sum.sqrt()
}

/// A mesh's answer is as close to the exact one as it says.
#[test]
fn a_mesh_is_as_good_as_it_says() {
    let (mut faults, mut count) = (Vec::new(), 0);
    let mut sharpest = [0.0_f64; 2];
    for family in Family::ALL {
        let numbers = if family == Family::Hard || family == Family::Long { 15 } else { 60 };
        for number in 0..numbers {
            let model = model(family, 1000 + number);
            let elements = [3, 10, 40, 160][number as usize % 4];
            let options = Options { method: Method::ActiveSet, elements, ..Options::default() };
            let Some(exact) = solved(&model, &Options::default()) else { continue };
            let Some(coarse) = solved(&model, &options) else { continue };
            count += 1;
            let [own, other] = [&coarse, &exact].map(|solution| estimated_bounds(solution)[0]);
            let bound = own + other;
            let l = model.beam.length;
            for i in 0..=40 {
                let x = l * (f64::from(i) / 40.0);
                let error = (coarse.settlement(x) - exact.settlement(x)).abs();
                if error > bound {
                    faults.push(format!("{family:?} {number}: u({x}): {error:e} > {bound:e}"));
                    break;
                }
                if bound.is_finite() && error > 0.0 {
                    sharpest[0] = sharpest[0].max(error / bound);
                }
            }
            // (∫(M − M*)²/EI)^½ ≤ ‖m − M*‖ + ‖δ‖, each at most (2E)^½.
            let energies = [&coarse, &exact].map(|solution| solution.certificate().gap());
            let bound: f64 = energies.iter().map(|energy| 2.0 * (2.0 * energy).sqrt()).sum();
            let error = moment_error(&coarse, &exact);
            if error.is_nan() || error > bound {
                faults.push(format!("{family:?} {number}: M: {error:e} > {bound:e}"));
            }
            if error > 0.0 {
                sharpest[1] = sharpest[1].max(error / bound);
            }
        }
    }
    println!(
        "{count} models, largest error over bound: u {:.2}, M {:.2}",
        sharpest[0], sharpest[1]
    );
    assert!(count > 400, "{count}");
    assert!(faults.is_empty(), "{} of {count}:\n{}", faults.len(), faults.join("\n"));
    // A bound that is never nearly reached would say little.
    assert!(sharpest[0] > 0.1 && sharpest[1] > 0.25, "{sharpest:?}");
}

/// The exact method's settlements are within their bounds of sixty digits, rounding and all, and the bounds
/// are small.
#[test]
fn bounds_hold_against_sixty_digits() {
    let mut faults = Vec::new();
    let mut relative = Vec::new();
    for answer in Answer::all().into_iter().filter(|a| !TOO_STIFF.contains(&a.name.as_str())) {
        let Ok(Outcome::Equilibrium(solution)) = solve(&answer.parsed()) else { continue };
        let [bound, ..] = estimated_bounds(&solution);
        if !bound.is_finite() {
            continue;
        }
        let numbers = |key: &str| -> Vec<f64> {
            let list = answer.stations[key].as_array().expect("a list of numbers");
            list.iter().map(|v| v.as_f64().unwrap_or(f64::NAN)).collect()
        };
        for (x, wanted) in numbers("x").into_iter().zip(numbers("settlement")) {
            let error = (solution.settlement(x) - wanted).abs();
            // The bound is that of the polynomials, before a value is computed.
            if error > bound + 2.0 * f64::EPSILON * wanted.abs() {
                faults.push(format!("{}: u({x}): {error:e} > {bound:e}", answer.name));
                break;
            }
        }
        relative.push(bound / largest(&solution, Field::Settlement));
    }
    relative.sort_by(f64::total_cmp);
    let median = relative[relative.len() / 2];
    let most = relative[relative.len() * 9 / 10];
    println!("{} bounds, median {median:.1e}, nine tenths below {most:.1e}", relative.len());
    assert!(faults.is_empty(), "{} of {}:\n{}", faults.len(), relative.len(), faults.join("\n"));
    assert!(median < 1e-12 && most < 1e-10, "{median:e} {most:e}");
}
