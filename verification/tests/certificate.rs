//! Checks the certificate: errors stay within their bounds, and the bounds are sharp.

use groundbeam::{
    Beam, Error, Field, Foundation, Load, Method, Model, NotConverged, Options, Outcome, Solution,
    Support, solution::Side, solve, solve_with,
};
use groundbeam_verification::proven::proven_bounds;
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

/// √∫(M − M*)²/EI, by Gauss's rule between the positions where either moment may have a corner.
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

/// Two moments of 10¹³ N·m cancel each other beside a force of 1 N. The beam is rigid, so its pressure comes
/// from the force alone.
#[test]
fn moments_that_cancel_do_not_spoil_the_certificate() {
    let model = Model::new(Beam::uniform(1.0, 1e30), Foundation::winkler(1.0))
        .with_load(Load::point_force(0.5, 1.0))
        .with_load(Load::point_moment(0.4, 1e13))
        .with_load(Load::point_moment(0.6, -1e13));
    let solution = solved(&model, &Options::default()).expect("an equilibrium");
    assert!(solution.certificate().relative_gap() < 1e-20, "{:?}", solution.certificate());
    for x in [0.0, 0.3, 0.5, 1.0] {
        assert!((solution.value(Field::Pressure, x) - 1.0).abs() < 1e-12);
    }
    let pressure = solution.prove().expect("a proof").bounds.pressure;
    assert!(pressure.error < 1e-12, "{pressure:?}");
}

/// Large forces and a moment cancel each other up to a rounding error that rotates the beam.
#[test]
fn loads_that_cancel_to_rounding_error_are_reported() {
    for size in [1e13, 1e14, 1e15].map(|size| size / 3.0) {
        let model = Model::new(Beam::uniform(1.0, 1e30), Foundation::winkler(1.0))
            .with_load(Load::uniform_force(0.0, 1.0, 1.0))
            .with_load(Load::point_force(0.3, size))
            .with_load(Load::point_force(0.6, -size))
            .with_load(Load::point_moment(0.5, 0.3 * size));
        let Err(Error::NotConverged(stopped)) = solve(&model) else { panic!("{size}: solved") };
        let named = matches!(stopped.why, NotConverged::CancellingLoads(gap) if gap > 1e-9);
        assert!(named, "{size}: {stopped:?}");
    }
}

/// The clamp carries all loads: the beam has no contact, and the energy of the error is compared with the strain energy
/// only.
#[test]
fn a_beam_carried_by_a_clamp_alone_is_certified() {
    let model = Model::new(Beam::uniform(49.0, 26e3), Foundation::pasternak(43.0, 14.1e3))
        .with_load(Load::point_moment(40.1, -4.8))
        .with_load(Load::distributed_moment(0.0, 10.1, -0.00123, 0.0247))
        .with_support(Support::fixed(28.8));
    let solution = solved(&model, &Options::default()).expect("an equilibrium");
    assert!(solution.certificate().relative_gap() < 1e-15, "{:?}", solution.certificate());
}

/// A beam rotates by 10¹² about a contact of a thousandth of its length. A piece there is a ten-thousandth of its
/// distance from the left end, the origin of positions. Its ends in terms of t are differences of near positions.
#[test]
fn short_pieces_far_from_the_left_end_keep_their_accuracy() {
    let folder = groundbeam_verification::frozen::folder();
    let all = groundbeam_verification::frozen::family(&folder, "Extreme").expect("a family");
    let one = all.iter().find(|one| one.number() == 47).expect("a frozen model");
    let solution = solved(&one.model().expect("a model"), &Options::default());
    let gap = solution.expect("an equilibrium").certificate().relative_gap();
    assert!(gap < 1e-14, "{gap:e}");
}

/// A mesh solution is within its own bound of the exact one.
#[test]
fn the_error_of_a_mesh_is_within_its_own_bound() {
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
            let [own, other] = [&coarse, &exact].map(|solution| proven_bounds(solution)[0]);
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
    // A bound that is much larger than every error would be useless.
    assert!(sharpest[0] > 0.1 && sharpest[1] > 0.25, "{sharpest:?}");
}

/// The settlements of the exact method are within their bounds of the 60-digit answers, including rounding, and the
/// bounds are small.
#[test]
fn bounds_cover_the_answers_in_sixty_digits() {
    let mut faults = Vec::new();
    let mut relative = Vec::new();
    for answer in Answer::all().into_iter().filter(|a| !TOO_STIFF.contains(&a.name.as_str())) {
        let Ok(Outcome::Equilibrium(solution)) = solve(&answer.parsed()) else { continue };
        let [bound, ..] = proven_bounds(&solution);
        if !bound.is_finite() {
            continue;
        }
        let numbers = |key: &str| -> Vec<f64> {
            let list = answer.stations[key].as_array().expect("a list of numbers");
            list.iter().map(|v| v.as_f64().unwrap_or(f64::NAN)).collect()
        };
        for (x, wanted) in numbers("x").into_iter().zip(numbers("settlement")) {
            let error = (solution.settlement(x) - wanted).abs();
            // The bound applies to the polynomials, before rounding of the value.
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
