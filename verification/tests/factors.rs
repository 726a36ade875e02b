//! Checks load factors of random models: contact and equilibrium hold just below a factor, and are lost just above it.
//!
//! Claims: `docs/load-factors.md`.

use groundbeam::{
    Beam, Field, Foundation, Load, Model, Outcome, Support, Verdict, exists, load_factors,
    load_factors::{FirstLiftOff, LossOfEquilibrium},
    model::Acts,
    solve,
};
use groundbeam_verification::random::{Family, model};

/// Relative distances from the factor of first lift-off at which models are solved; all must be solved.
const BESIDE: [f64; 4] = [1e-6, 1e-3, 1e-8, 1e-10];
/// Models that the exact method refuses near their factor. Settled 5: a thousandth beyond it, the edge of the new zone
/// beside a clamp alternates between the clamp and a hundred-millionth of the length from it. Varying 21: a millionth
/// beyond it, an edge lies 3e-13 of the length beside a jump of the ground, and the stored settlement has no slope
/// there.
const REFUSED: [(Family, u64); 2] = [(Family::Settled, 5), (Family::Varying, 21)];
/// A model with zero pressure at one position under the constant loads: its factor is rounding error.
const RESTING: (Family, u64) = (Family::Neighbours, 35);
/// Next to a clamp on Winkler ground, rounding of the pressure makes gaps of this fraction of the length.
const SHORT_GAP: f64 = 1e-6;

/// A random model under a constant uniform load, with its own loads increasing.
fn weighted(family: Family, number: u64) -> Model {
    let mut model = model(family, number);
    let l = model.beam.length;
    // Enough to close the gaps, and not negligible compared with the other loads.
    let depth = model.gap.iter().map(|corner| corner.value).fold(0.0, f64::max);
    let share = [0.01, 0.3, 3.0][number as usize % 3];
    let weight = 3.0 * model.foundation.subgrade * depth + share / l;
    model.loads.push(Load::uniform_force(0.0, l, weight));
    model
}

/// All loads except the last, multiplied by a factor; loads that press on the ground remain.
fn at(model: &Model, factor: f64) -> Model {
    let mut model = model.clone();
    let count = model.loads.len() - 1;
    for load in &mut model.loads[..count] {
        *load = load.scaled(if load.is_on_ground() { factor.abs() } else { factor });
    }
    model
}

/// Whether the beam is in contact along its whole length without tensile pressure, and whether this holds
/// apart from short gaps.
fn touches_all_along(model: &Model) -> Result<[bool; 2], String> {
    match solve(model) {
        Ok(Outcome::Equilibrium(found)) => {
            let l = model.beam.length;
            let open: f64 = found.lift_off().iter().map(|stretch| stretch.to - stretch.from).sum();
            // Within its certificate, a solution may have tensile pressure of a billionth of the largest pressure.
            let ends = found.end_forces();
            let in_tension = found.range(Field::Pressure).min.value < 0.0
                || ends.left < 0.0
                || ends.right < 0.0
                || found.concentrated_forces().iter().any(|c| c.force < 0.0);
            Ok([open == 0.0 && !in_tension, open <= SHORT_GAP * l])
        }
        Ok(Outcome::NoEquilibrium(_)) => Ok([false; 2]),
        Err(error) => Err(error.to_string()),
    }
}

fn report(faults: &[String]) {
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn first_lift_off_lies_between_contact_and_lift_off() {
    let mut faults = Vec::new();
    let mut seen = [0; 3];
    // Where the ground ends with the beam, gaps of 1e-12 of its length are not always certified. With loads on such
    // ground, only the certified solutions are compared.
    for family in Family::ALL.into_iter().filter(|family| *family != Family::Beside) {
        let count = if matches!(family, Family::Long | Family::Hard) { 10 } else { 40 };
        for number in (0..count).filter(|number| (family, *number) != RESTING) {
            let model = weighted(family, number);
            let last = model.loads.len() - 1;
            let found = match load_factors(&model, |load| load != last) {
                Ok(found) => found.first_lift_off,
                Err(error) => {
                    faults.push(format!("{family:?} {number}: {error}"));
                    continue;
                }
            };
            let touches = |factor: f64| touches_all_along(&at(&model, factor));
            let holds = |factor: f64| matches!(touches(factor), Ok([_, true]));
            let ends = |factor: f64| {
                let [first, others @ ..] = BESIDE.map(|beside| touches(factor * (1.0 + beside)));
                if family == Family::Neighbours {
                    let all = || others.iter().chain([&first]).flatten();
                    return all().count() > 0 && all().all(|[touches, _]| !touches);
                }
                if REFUSED.contains(&(family, number)) {
                    return matches!(first, Ok([false, _]) | Err(_));
                }
                matches!(first, Ok([false, _])) && others.iter().all(Result::is_ok)
            };
            let right = match found {
                FirstLiftOff::AtOnce => {
                    seen[0] += 1;
                    matches!(touches(1e-6), Ok([false, _]))
                }
                FirstLiftOff::At { factor, .. } => {
                    seen[1] += 1;
                    holds(factor * (1.0 - BESIDE[0])) && ends(factor)
                }
                FirstLiftOff::Never => {
                    seen[2] += 1;
                    holds(1e3)
                }
            };
            if !right {
                faults.push(format!("{family:?} {number}: {found:?}"));
            }
        }
    }
    report(&faults);
    assert!(seen.iter().all(|&count| count > 20), "{seen:?}");
}

#[test]
fn equilibrium_is_lost_at_the_factor() {
    let mut faults = Vec::new();
    let mut lost = 0;
    for family in Family::ALL {
        for number in 0..500 {
            let model = weighted(family, number);
            let last = model.loads.len() - 1;
            // The reversed loads lift the beam.
            let model = if number % 2 == 0 { model } else { at(&model, -1.0) };
            let found = load_factors(&model, |load| load != last);
            let none = |factor: f64| {
                matches!(exists(&at(&model, factor)).map(|e| e.verdict), Ok(Verdict::None(_)))
            };
            let right = match found.as_ref().map(|found| found.loss_of_equilibrium) {
                Ok(LossOfEquilibrium::AtOnce(_)) => none(1e-6),
                Ok(LossOfEquilibrium::At { factor, .. }) => {
                    lost += 1;
                    !none(factor * (1.0 - 1e-9))
                        && none(factor * (1.0 + 1e-9))
                        && !none(1e-9 * factor)
                }
                Ok(LossOfEquilibrium::Never) => {
                    [1e-6, 1.0, 1e6].iter().all(|&factor| !none(factor))
                }
                Err(_) => false,
            };
            if !right {
                faults.push(format!("{family:?} {number}: {found:?}"));
            }
        }
    }
    report(&faults);
    assert!(lost > 500, "{lost}");
}

/// Without constant loads and without a gap the fields are proportional to the factor.
#[test]
fn weightless_beams_lift_off_at_factor_zero_or_never() {
    let mut faults = Vec::new();
    for family in Family::ALL.into_iter().filter(|f| !matches!(f, Family::Gap | Family::Mixed)) {
        for number in 0..60 {
            let mut model = model(family, number);
            model.gap.clear();
            for support in &mut model.supports {
                support.settlement = 0.0;
            }
            let found = load_factors(&model, |_| true);
            let Ok(found) = found else {
                faults.push(format!("{family:?} {number}: {found:?}"));
                continue;
            };
            let touches = touches_all_along(&model);
            let right = match found.first_lift_off {
                FirstLiftOff::AtOnce => matches!(touches, Ok([false, _])),
                FirstLiftOff::Never => matches!(touches, Ok([_, true])),
                FirstLiftOff::At { .. } => false,
            };
            if !right || found.loss_of_equilibrium != LossOfEquilibrium::Never {
                faults.push(format!("{family:?} {number}: {found:?}, {touches:?}"));
            }
        }
    }
    report(&faults);
}

/// The mirrored beam lifts off at the same factor, at the mirrored position. If the constant loads are multiplied by a
/// power of two, the factors are multiplied by it, bit for bit.
#[test]
fn mirrored_and_scaled_models_have_the_same_load_factors() {
    let mut faults = Vec::new();
    for family in [Family::Plain, Family::Tension, Family::Segments, Family::Winkler] {
        for number in 0..200 {
            let model = weighted(family, number);
            let l = model.beam.length;
            let last = model.loads.len() - 1;
            let factors = |model: &Model| load_factors(model, |load| load != last).ok();
            let mut heavy = model.clone();
            heavy.loads[last] = heavy.loads[last].scaled(8.0);
            let (found, mirror, heavy) =
                (factors(&model), factors(&model.mirrored()), factors(&heavy));
            let lift_off = |found: Option<groundbeam::load_factors::LoadFactors>| match found?
                .first_lift_off
            {
                FirstLiftOff::At { factor, x } => Some((factor, x)),
                _ => None,
            };
            let right = match (lift_off(found), lift_off(mirror), lift_off(heavy)) {
                (Some((a, x)), Some((b, y)), Some((c, z))) => {
                    let together = (a - b).abs() <= 1e-10 * a;
                    // A symmetric beam lifts off at two positions at once.
                    let there = (x - (l - y)).abs() <= 1e-5 * l || (x == y && a == b);
                    together && there && c == 8.0 * a && z == x
                }
                (None, None, None) => true,
                _ => false,
            };
            if !right {
                faults.push(format!("{family:?} {number}: {found:?} {mirror:?} {heavy:?}"));
            }
        }
    }
    report(&faults);
}

/// A rigid beam of length l and weight q l on Winkler ground, with a bearing under its left end. A force at its right
/// end increases. The beam rotates about the bearing while the bearing carries force, and then as if there were no
/// bearing. The force of the bearing and the pressure under the left end follow from two equations of equilibrium.
#[test]
fn a_beam_lifts_from_a_bearing_before_it_lifts_from_the_ground() {
    let (l, q, k, down) = (2.0, 3.0, 5.0, 0.4);
    // The bearing holds the left end at δ < q/k, so it carries a part of the weight.
    let model = Model::new(Beam::uniform(l, 1e9), Foundation::winkler(k))
        .with_load(Load::uniform_force(0.0, l, q))
        .with_support(Support::pinned(0.0).settled(down).acting(Acts::Up))
        .with_load(Load::point_force(l, 1.0));
    let found = load_factors(&model, |load| load == 1).expect("factors");
    // Without the bearing w(0) = q/k − 2F/(kl). The beam leaves the bearing at the F for which w(0) = δ, and the ground
    // at w(0) = 0.
    let wanted = 0.5 * q * l;
    let FirstLiftOff::At { factor, x } = found.first_lift_off else { panic!("{found:?}") };
    assert!((factor / wanted - 1.0).abs() < 1e-8 && x == 0.0, "{factor} {wanted} {x}");
    let left = 0.5 * (q - k * down) * l;
    for (force, carries) in [(0.99 * left, true), (1.01 * left, false)] {
        let mut at = model.clone();
        at.loads[1] = at.loads[1].scaled(force);
        let Ok(Outcome::Equilibrium(solution)) = solve(&at) else { panic!("it stands") };
        assert_eq!(solution.reactions()[0].force > 0.0, carries, "{force}");
        assert!(solution.lift_off().is_empty());
    }
    assert_eq!(found.loss_of_equilibrium, LossOfEquilibrium::Never);
    // A hold-down instead of the bearing limits the rise of the end, and carries force from there on.
    let mut hold_down = model;
    hold_down.supports[0] = Support::pinned(0.0).settled(down).acting(Acts::Down);
    let found = load_factors(&hold_down, |load| load == 1).expect("factors");
    assert_eq!(found.first_lift_off, FirstLiftOff::Never);
}

/// A load on the ground beside a footing lowers the ground under its near end. With contact along the whole beam, the
/// pressure is linear in this load. Solves on both sides confirm the factor at which this ends.
#[test]
fn a_growing_load_on_the_ground_causes_lift_off_at_its_factor() {
    let model = Model::new(Beam::uniform(4.0, 40.0), Foundation::pasternak(2.0, 3.0))
        .with_load(Load::uniform_force(0.0, 4.0, 1.0))
        .with_load(Load::ground_force(-0.3, 1.0))
        .with_load(Load::point_moment(1.0, 0.2));
    let found = load_factors(&model, |load| load == 1).expect("factors");
    let FirstLiftOff::At { factor, x } = found.first_lift_off else { panic!("{found:?}") };
    assert_eq!(x, 0.0);
    assert_eq!(found.loss_of_equilibrium, LossOfEquilibrium::Never);
    let force = |factor: f64| {
        let mut at = model.clone();
        at.loads[1] = at.loads[1].scaled(factor);
        let Ok(Outcome::Equilibrium(solution)) = solve(&at) else { panic!("it stands") };
        (solution.lift_off().len(), solution.end_forces().left)
    };
    // The end force decreases linearly to zero.
    let [none, half] = [0.0, 0.5].map(|part| force(part * factor));
    assert!((half.1 / none.1 - 0.5).abs() < 1e-9, "{none:?} {half:?}");
    assert_eq!((force(0.9999 * factor).0, force(1.001 * factor).0), (0, 1));
    // The load on the ground may also be constant while another load increases.
    let turned = load_factors(&model, |load| load == 2).expect("factors");
    let alone = Model { loads: vec![model.loads[0], model.loads[2]], ..model.clone() };
    let without = load_factors(&alone, |load| load == 1).expect("factors");
    let at = |found: groundbeam::load_factors::LoadFactors| match found.first_lift_off {
        FirstLiftOff::At { factor, .. } => factor,
        other => panic!("{other:?}"),
    };
    assert!(at(turned) < at(without));
}
