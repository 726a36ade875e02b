//! Thousands of random models: each is solved, certified, and invariant under scaling and mirroring.

use groundbeam::{
    Error, Field, Method, Model, Options, Outcome, Solution, solution::Side, solve, solve_with,
};
use groundbeam_verification::proven::proven_bounds;
use groundbeam_verification::random::{Family, model};

fn exact(model: &Model) -> Result<Solution, String> {
    match solve(model) {
        Ok(Outcome::Equilibrium(solution)) => Ok(*solution),
        Ok(Outcome::NoEquilibrium(_)) => Err("no equilibrium".into()),
        Err(error) => Err(error.to_string()),
    }
}

fn report(faults: &[String]) {
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

/// No failure, and no result without a certificate.
#[test]
fn exact_solutions_are_certified() {
    let mut faults = Vec::new();
    for family in Family::ALL.into_iter().chain([Family::Shearing, Family::Extreme]) {
        let numbers = match family {
            Family::Hard => 0..40,
            Family::Varying => 0..60,
            Family::Long => 0..100,
            // Models of this range take less than a second.
            Family::Extreme => 5..18,
            _ => 0..500,
        };
        // Arches a million times higher than the settlement; an edge that moves over hundreds of wave lengths.
        let hardest: &[u64] = if family == Family::Hard { &[1617, 4179, 6195, 7814] } else { &[] };
        for number in numbers.chain(hardest.iter().copied()) {
            match exact(&model(family, number)) {
                Ok(solution) => {
                    let certificate = solution.certificate();
                    if certificate.relative_gap() > 1e-10 {
                        faults.push(format!("{family:?} {number}: {certificate:?}"));
                    }
                }
                Err(error) => faults.push(format!("{family:?} {number}: {error}")),
            }
        }
    }
    report(&faults);
}

/// For any number of elements, the solution is within the bound of its own certificate from the exact one.
#[test]
fn active_set_solutions_stay_within_their_certificate() {
    let mut faults = Vec::new();
    for family in Family::ALL.into_iter().chain([Family::Shearing]) {
        let count = match family {
            Family::Hard | Family::Varying => 30,
            Family::Long => 60,
            Family::Shearing => 200,
            _ => 250,
        };
        for number in 0..count {
            let model = model(family, number);
            // Seven elements for a thousand wave lengths prove nothing: such models get meshes that resolve them.
            let elements = match family {
                Family::Hard => [100, 200, 333, 1000][number as usize % 4],
                _ => [1, 2, 7, 16, 50, 100, 333, 1000][number as usize % 8],
            };
            let options = Options { method: Method::ActiveSet, elements, ..Options::default() };
            let coarse = match solve_with(&model, &options) {
                Ok(Outcome::Equilibrium(solution)) => solution,
                other => {
                    faults.push(format!("{family:?} {number} {elements}: {other:?}"));
                    continue;
                }
            };
            let Ok(exact) = exact(&model) else { continue };
            let certificate = coarse.certificate();
            // Between nodes the beam may pierce the ground, so the energy may lie on either side of the exact one.
            let excess = certificate.primal_energy() - exact.certificate().primal_energy();
            let rounding = 1e-9 * exact.certificate().primal_energy().abs();
            if excess.abs() > certificate.gap() + rounding {
                faults.push(format!(
                    "{family:?} {number} {elements}: energy off by {excess:e}, gap {:e}",
                    certificate.gap()
                ));
            }
            let [bound, ..] = proven_bounds(&coarse);
            for i in 0..=20 {
                let x = model.beam.length * f64::from(i) / 20.0;
                let error = (coarse.settlement(x) - exact.settlement(x)).abs();
                if error > bound * (1.0 + 1e-9) + 1e-9 * exact.settlement(x).abs() {
                    faults.push(format!(
                        "{family:?} {number} {elements}: u({x}) off by {error:e}, bound {bound:e}"
                    ));
                    break;
                }
            }
        }
    }
    report(&faults);
}

/// Multiplying the loads by 2ᵏ multiplies every field by 2ᵏ, bit for bit, with the same contact.
#[test]
fn scaling_by_a_power_of_two_is_bit_identical() {
    let families = [
        Family::Plain,
        Family::Tension,
        Family::Segments,
        Family::Winkler,
        Family::Supported,
        Family::Varying,
        Family::Curled,
        Family::Settled,
        Family::Beside,
        Family::Neighbours,
        Family::Shearing,
    ];
    let mut faults = Vec::new();
    for family in families {
        for number in 0..200 {
            let mut model = model(family, number);
            model.gap.clear();
            let factor = 2_f64.powi([-20, -3, 1, 11, 40][number as usize % 5]);
            let mut scaled = model.clone().with_loads_scaled(factor);
            for support in &mut scaled.supports {
                support.settlement *= factor;
            }
            for method in [Method::Exact, Method::ActiveSet] {
                let options = Options { method, elements: 37, ..Options::default() };
                if matches!(solve_with(&model, &options), Err(Error::Unsupported(_))) {
                    continue;
                }
                let (Ok(Outcome::Equilibrium(a)), Ok(Outcome::Equilibrium(b))) =
                    (solve_with(&model, &options), solve_with(&scaled, &options))
                else {
                    faults.push(format!("{family:?} {number}: no answer"));
                    continue;
                };
                let same = a.contact() == b.contact()
                    && a.iterations() == b.iterations()
                    && (0..=50).all(|i| {
                        let x = model.beam.length * f64::from(i) / 50.0;
                        let (a, b) = (a.at(x, Side::Right), b.at(x, Side::Right));
                        Field::ALL.iter().all(|&f| {
                            (a.get(f) * factor).to_bits() == b.get(f).to_bits() || a.get(f) == 0.0
                        })
                    });
                if !same {
                    faults.push(format!("{family:?} {number} {method:?}: not the same bits"));
                }
            }
        }
    }
    report(&faults);
}

/// The mirrored model has the mirrored answer.
#[test]
fn mirrored_models_have_mirrored_solutions() {
    let mut faults = Vec::new();
    for family in [
        Family::Plain,
        Family::Tension,
        Family::Segments,
        Family::Winkler,
        Family::Supported,
        Family::Gap,
        Family::Varying,
        Family::Curled,
        Family::Settled,
        Family::Beside,
        Family::Neighbours,
        Family::Shearing,
    ] {
        for number in 0..200 {
            let model = model(family, number);
            let l = model.beam.length;
            let (Ok(a), Ok(b)) = (exact(&model), exact(&model.mirrored())) else {
                faults.push(format!("{family:?} {number}: no answer"));
                continue;
            };
            let largest = |f: Field| {
                let range = a.range(f);
                range.max.value.abs().max(range.min.value.abs())
            };
            // The shear force of a beam under moments only is rounding error.
            let scale = |f: Field| match f {
                Field::ShearForce => largest(f).max(largest(Field::Moment) / l),
                _ => largest(f),
            };
            // A stiff beam that a settled pin holds deep in the ground: its bending is in the last digits of
            // its deflection, so only the accuracy of the certificate is reached.
            let bounds = match family {
                Family::Settled => [&a, &b].map(proven_bounds),
                _ => [[0.0; 3]; 2],
            };
            let bound = |i: usize| bounds[0][i] + bounds[1][i];
            let uncertain = |f: Field| match f {
                _ if family != Family::Settled => 0.0,
                Field::Slope | Field::Rotation => 1e-11 * largest(Field::Deflection) / l,
                Field::Moment => bound(1),
                Field::ShearForce => bound(2),
                _ => 0.0,
            };
            for i in 1..50 {
                // Away from places where fields jump.
                let x = l * (f64::from(i) + 0.123_456_7) / 51.0;
                let (here, there) = (a.at(x, Side::Right), b.at(l - x, Side::Left));
                for (field, sign) in [
                    (Field::Deflection, 1.0),
                    (Field::Moment, 1.0),
                    (Field::ShearForce, -1.0),
                    (Field::Slope, -1.0),
                    (Field::Rotation, -1.0),
                ] {
                    let error = (here.get(field) - sign * there.get(field)).abs();
                    if error > 1e-9 * scale(field) + uncertain(field) {
                        faults.push(format!(
                            "{family:?} {number}: {} at {x}: {error:e}",
                            field.name()
                        ));
                    }
                }
            }
            let (p, q) = (a.end_forces(), b.end_forces());
            let total: f64 = scale(Field::ShearForce) + p.left + p.right;
            if (p.left - q.right).abs() + (p.right - q.left).abs() > 1e-9 * total {
                faults.push(format!("{family:?} {number}: end forces {p:?} {q:?}"));
            }
        }
    }
    report(&faults);
}

/// For μ → 0 the solution tends to that on Winkler ground. Number 27 is a beam about to lift off in its middle: with μ
/// = 10⁻⁶√(k EI) the exact method finds no edges there and fails, a known gap.
#[test]
fn a_vanishing_shear_layer_gives_winkler_ground() {
    for number in (0..50).filter(|number| *number != 27) {
        let winkler = model(Family::Winkler, number);
        let at = winkler.beam.length * 0.3;
        let reference = exact(&winkler).expect("an answer").value(Field::Deflection, at);
        let natural = (winkler.foundation.subgrade * winkler.beam.bending_stiffness).sqrt();
        let mut last = f64::INFINITY;
        for power in [-4, -6, -8] {
            let mut soft = winkler.clone();
            soft.foundation.shear_layer = natural * 10_f64.powi(power);
            let w = exact(&soft).expect("an answer").value(Field::Deflection, at);
            let error = (w - reference).abs()
                / exact(&winkler).expect("an answer").range(Field::Deflection).max.value.abs();
            assert!(error < last * 0.5 || error < 1e-7, "{number}: {error:e} after {last:e}");
            last = error;
        }
    }
}
