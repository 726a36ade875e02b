//! Compares hinges with a dense problem over all contact sets, with closed forms and limits.
//!
//! Claims: `docs/methods.md`.

use groundbeam::{
    Beam, Error, Field, Foundation, Hinge, Load, Method, Model, Options, Outcome, Solution,
    Verdict, exists, solve,
};
use groundbeam_verification::dense::Dense;
use groundbeam_verification::random::{Family, model};
use groundbeam_verification::solved::{solved, solved_by};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A beam with loads and one or two hinges at the nodes of a uniform mesh.
fn hinged(rng: &mut ChaCha8Rng, elements: usize) -> Model {
    loop {
        let l = 10_f64.powf(rng.random_range(-0.5..1.0));
        let k = 10_f64.powf(rng.random_range(-1.0..1.0));
        let ei = 0.25 * k * (l / 10_f64.powf(rng.random_range(-0.5..0.6))).powi(4);
        let mu = k * (l * 10_f64.powf(rng.random_range(-1.0..0.5))).powi(2);
        let mut model = Model::new(Beam::uniform(l, ei), Foundation::pasternak(k, mu));
        let node =
            |rng: &mut ChaCha8Rng| l * (rng.random_range(0..=elements) as f64 / elements as f64);
        for _ in 0..rng.random_range(1..3) {
            let spring =
                if rng.random_bool(0.5) { 0.0 } else { ei / l * rng.random_range(0.1..10.0) };
            model = model.with_hinge(Hinge { at: node(rng), rotational_spring: spring });
        }
        for _ in 0..rng.random_range(1..5) {
            let force = rng.random_range(-0.3..1.0);
            model.loads.push(Load::point_force(node(rng), force));
        }
        if rng.random_bool(0.5) {
            let moment = l * rng.random_range(-0.1..0.1);
            model.loads.push(Load::point_moment(node(rng), moment));
        }
        if exists(&model).is_ok_and(|e| e.verdict == Verdict::Unique) {
            return model;
        }
    }
}

/// The paper's discrete problem with one additional slope at each hinge, over all sets of touching nodes.
#[test]
fn hinged_beams_agree_with_brute_force_over_all_contact_sets() {
    let mut rng = ChaCha8Rng::seed_from_u64(1866);
    for number in 0..200 {
        let elements = rng.random_range(3..8);
        let model = hinged(&mut rng, elements);
        let (w, _) = Dense::new(&model, elements).by_exhaustion().expect("one set satisfies all");
        let options = Options { method: Method::ActiveSet, elements, ..Options::default() };
        let found = solved_by(&model, &options);
        let size = w.iter().fold(0.0, |m: f64, w| m.max(w.abs()));
        for (i, w) in w.iter().enumerate() {
            let x = model.beam.length * (i as f64 / elements as f64);
            let error = found.value(Field::Deflection, x) - w;
            assert!(error.abs() < 1e-7 * size, "{number} {i}: {error:e} of {size:e} {model:?}");
        }
    }
}

/// The ground has a concentrated force −μ\[w'\] where the beam bends over a hinge, and lifts off where it opens. A free
/// hinge transmits no moment, an elastic one −k_φ\[w'\].
#[test]
fn forces_and_moments_at_a_hinge_satisfy_their_conditions() {
    let (mut pressed, mut parted) = (0, 0);
    for number in 0..400 {
        let model = model(Family::Hinged, number);
        let answer = solved(&model);
        // Each of several pieces is held, in most cases by more than one point.
        assert_eq!(answer.existence().verdict, Verdict::Unique, "{number}: {model:?}");
        let range = answer.range(Field::Moment);
        let size = range.min.value.abs().max(range.max.value.abs());
        for (hinge, turn) in model.hinges.iter().zip(answer.hinges()) {
            let moment = answer.value(Field::Moment, hinge.at);
            assert!(
                (moment - turn.moment).abs() <= 1e-7 * size,
                "{number}: {moment} {turn:?} {size}"
            );
            let inside = answer.contact().iter().any(|c| c.from < hinge.at && hinge.at < c.to);
            let even = model.foundation.segments.is_empty() && model.gap.is_empty();
            if !even || model.foundation.shear_layer == 0.0 {
                continue;
            }
            let mut forces = answer.concentrated_forces().iter().filter(|f| f.at == hinge.at);
            let force = forces.next().map_or(0.0, |force| force.force);
            let wanted = -model.foundation.shear_layer * turn.rotation;
            if inside {
                pressed += usize::from(force > 0.0);
                let scale = model.foundation.shear_layer * size * model.beam.length
                    / model.beam.bending_stiffness;
                assert!(
                    (force - wanted).abs() <= 1e-7 * scale.max(wanted.abs()),
                    "{number}: {force} {wanted}"
                );
            } else {
                parted += usize::from(turn.rotation > 0.0 && force == 0.0);
            }
        }
    }
    assert!(pressed > 50 && parted > 10, "{pressed} {parted}");
}

/// A model with an end piece without loads, which a free hinge allows to rotate.
const UNLOADED: u64 = 78;

/// With increasing stiffness the hinge becomes rigid, with decreasing stiffness free.
#[test]
fn an_elastic_hinge_lies_between_a_free_hinge_and_a_rigid_joint() {
    for number in 0..100 {
        let mut model = model(Family::Hinged, number);
        if model.beam.axial_force < 0.0 {
            continue;
        }
        let unit = model.beam.bending_stiffness / model.beam.length;
        // The rotational stiffness of the ground under the shortest piece.
        let places: Vec<f64> =
            groundbeam::existence::static_reactions(&model).iter().map(|r| r.0).collect();
        let shortest = places.windows(2).map(|x| x[1] - x[0]).fold(f64::INFINITY, f64::min);
        let soft = unit.min(model.foundation.subgrade * shortest.powi(3));
        let mut with = |spring: f64| {
            model.hinges.iter_mut().for_each(|hinge| hinge.rotational_spring = spring);
            solve(&model)
        };
        let Ok(Outcome::Equilibrium(stiff)) = with(1e9 * unit) else {
            panic!("{number}: {model:?}")
        };
        let ends = match with(0.0) {
            Ok(Outcome::Equilibrium(free)) => {
                Some((free, [1e-2 * soft, 1e-4 * soft].map(&mut with)))
            }
            _ => None,
        };
        model.hinges.clear();
        let closed = solved(&model);
        let distance = |a: &Solution, b: &Solution| {
            let range = b.range(Field::Settlement);
            let size = range.min.value.abs().max(range.max.value.abs());
            let x = |i: i32| model.beam.length * f64::from(i) / 20.0;
            let one = |i: i32| (a.settlement(x(i)) - b.settlement(x(i))).abs() / size;
            (0..=20).map(one).fold(0.0, f64::max)
        };
        assert!(distance(&stiff, &closed) < 1e-5, "{number}: {:e}", distance(&stiff, &closed));
        if let Some((free, soft)) = ends {
            let [before, apart] = soft.map(|soft| match soft {
                Ok(Outcome::Equilibrium(soft)) => distance(&soft, &free),
                other => panic!("{number}: {other:?}"),
            });
            // A soft spring displaces a piece in proportion to the spring's stiffness, but an unloaded piece in
            // proportion to the cube root: 0.01^⅓ = 0.215.
            let share = if number == UNLOADED { 0.25 } else { 0.2 };
            assert!(apart < (share * before).max(1e-7), "{number}: {apart:e} after {before:e}");
        }
    }
}

#[test]
fn mirrored_hinged_beams_have_mirrored_solutions() {
    for number in 0..100 {
        let model = model(Family::Hinged, number);
        let [here, there] = [model.clone(), model.mirrored()].map(|model| solved(&model));
        let range = here.range(Field::Deflection);
        let size = range.min.value.abs().max(range.max.value.abs());
        for i in 0..=20 {
            let x = model.beam.length * f64::from(i) / 20.0;
            let [a, b] = [(&here, x), (&there, model.beam.length - x)]
                .map(|(s, x)| s.value(Field::Deflection, x));
            assert!((a - b).abs() < 1e-6 * size, "{number} {x}: {a} {b}");
        }
    }
}

#[test]
fn invalid_hinges_are_refused() {
    let model = Model::new(Beam::uniform(4.0, 1.0), Foundation::pasternak(1.0, 1.0))
        .with_load(Load::point_force(1.0, 1.0))
        .with_load(Load::point_force(3.0, 1.0));
    let hinged = |at: f64| model.clone().with_hinge(Hinge::free(at));
    let code = |model: &Model| match solve(model) {
        Err(Error::Invalid(problems)) => problems[0].code,
        Err(Error::Unsupported(problem)) => problem.code,
        other => panic!("{other:?}"),
    };
    assert_eq!(code(&hinged(0.0)), "GB404");
    assert_eq!(code(&model.clone().with_hinge(Hinge::elastic(2.0, -1.0))), "GB405");
    assert_eq!(code(&hinged(2.0).with_hinge(Hinge::free(2.0))), "GB406");
    assert_eq!(code(&hinged(2.0).with_hinge(Hinge::free(2.0_f64.next_up()))), "GB406");
    assert_eq!(code(&hinged(2.0).with_load(Load::point_moment(2.0, 1.0))), "GB407");
    assert_eq!(code(&hinged(2.0).with_support(groundbeam::Support::fixed(2.0))), "GB407");
    // Two pins hold a beam, but not if a hinge lies between them: then the ground must support it.
    let mut mechanism = hinged(2.0);
    mechanism.beam.axial_force = -1e-6;
    mechanism.supports = vec![groundbeam::Support::pinned(0.0), groundbeam::Support::pinned(4.0)];
    let verdict = |model: &Model| groundbeam::exists(model).map(|existence| existence.verdict);
    assert!(matches!(verdict(&mechanism), Ok(groundbeam::Verdict::Local(_))));
    mechanism.supports[0] = groundbeam::Support::fixed(0.0);
    assert_eq!(verdict(&mechanism), Ok(groundbeam::Verdict::Unique));
    assert!(matches!(solve(&mechanism), Ok(Outcome::Equilibrium(_))));
}

/// Positions closer than 16 ε l count as equal: a hinge there is at the end and has no beam on one side.
#[test]
fn a_hinge_within_rounding_of_an_end_is_refused() {
    let l = 1e16;
    for at in [3.0, 35.0, l - 4.0, l - 34.0] {
        let model = Model::new(Beam::uniform(l, 1.0), Foundation::winkler(4.0))
            .with_hinge(Hinge::elastic(at, 0.5))
            .with_load(Load::point_force(at, 1.0))
            .with_load(Load::uniform_force(0.0, l, 1.0));
        let refused = solve(&model);
        assert!(
            matches!(&refused, Err(Error::Invalid(p)) if p.len() == 1 && p[0].code == "GB404"),
            "{at}: {refused:?}"
        );
    }
}
