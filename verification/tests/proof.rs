//! The proof of solutions: gaps, covered models, and wrong answers that are refused.
//!
//! Claims: `docs/proof.md`.

use groundbeam::proof::{Ball, ContactForce, ContactSet, NotProven, Proof, Wide, prove};
use groundbeam::{Field, Model, Outcome, Solution, Verdict, solve};
use groundbeam_verification::cases;
use groundbeam_verification::claims::{energy_of_error, error_bound, over_bound};
use groundbeam_verification::random::{Family, model};
use groundbeam_verification::reference::Answer;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Gaps relative to the strain energy, as measured in numbers of 106 bits.
const REACHED: [(&str, f64); 16] = [
    ("kikuchi-1980/case-1.toml", 3.1e-32),
    ("kikuchi-1980/case-2.toml", 1.1e-31),
    ("kikuchi-1980/case-3.toml", 4.8e-29),
    ("kikuchi-1980/case-4.toml", 3.8e-30),
    ("kikuchi-1980/figure-2-c-stands.toml", 9.9e-32),
    ("long-beam.toml", 1.8e-28),
    ("footings/strip-footing-under-three-columns.toml", 1.6e-29),
    ("limits/a-beam-ten-thousand-wavelengths-long.toml", 1.7e-19),
    ("limits/a-concentrated-force-at-a-ridge-of-the-ground.toml", 3.8e-29),
    ("limits/resultant-a-millionth-inside-an-end.toml", 1.7e-28),
    ("limits/resultant-outside-the-beam-held-by-tension.toml", 6.8e-31),
    ("textbook/rigid-footing-of-kikuchi-about-to-lift-off.toml", 1.3e-31),
    ("textbook/rigid-footing-of-kikuchi-lifted-off.toml", 1.8e-31),
    ("textbook/hetenyi-1946-hinge-under-a-force.toml", 1.3e-29),
    ("textbook/kerr-1964-endless-beam-on-a-shear-layer-g-1.5.toml", 5.7e-29),
    (
        "textbook/pavlovic-tsikkos-1982-simply-supported-beam-on-springs-that-do-not-pull.toml",
        1.6e-29,
    ),
];

/// Why a solution of a case file is not proven.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Cause {
    /// The equilibrium is one of many: the beam stands on one point, about which it may turn.
    OneOfMany,
    /// The load is the one at which an edge of contact appears: the pressure there is exactly zero.
    Threshold,
    /// The compression is above the critical load of the beam on its supports alone. The ground stabilises it.
    Compression,
}

/// The case files with a solution that is not proven, with the reason that the program gives. docs/proof.md lists them.
const EXCEPTIONS: [(&str, Cause, &str); 8] = [
    (
        "limits/balanced-on-a-corner-of-the-ground.toml",
        Cause::OneOfMany,
        "contact pressure and supports cannot balance the moment of the loads",
    ),
    (
        "limits/balanced-on-an-end-of-a-shear-layer.toml",
        Cause::OneOfMany,
        "contact pressure and supports cannot balance the moment of the loads",
    ),
    (
        "textbook/hetenyi-1946-free-beam-central-force-beta-l-pi.toml",
        Cause::Threshold,
        "the contact set is not proven: the difference between deflection and initial gap is too small to decide \
         contact on Winkler ground",
    ),
    (
        "textbook/lovtsov-2025-beam-loaded-at-both-ends-about-to-lift-off.toml",
        Cause::Threshold,
        "the contact set is not proven: the difference between deflection and initial gap is too small to decide \
         contact on Winkler ground",
    ),
    (
        "textbook/rigid-footing-of-kikuchi-about-to-lift-off.toml",
        Cause::Threshold,
        "the contact set is not proven: the clearance between beam and ground is too small to exclude contact",
    ),
    (
        "textbook/engesser-1891-pinned-beam-that-shears-in-compression.toml",
        Cause::Compression,
        "the critical load is not proven to exceed the compression",
    ),
    (
        "textbook/hetenyi-1946-half-endless-beam-in-compression.toml",
        Cause::Compression,
        "the critical load is not proven to exceed the compression",
    ),
    (
        "textbook/timoshenko-gere-1961-pinned-beam-on-springs-in-compression.toml",
        Cause::Compression,
        "the critical load is not proven to exceed the compression",
    ),
];

/// All solutions of the case files.
fn solutions() -> Vec<(String, Solution)> {
    let models: Vec<_> = cases::all()
        .into_iter()
        .map(|case| case.expect("a case that can be read"))
        .flat_map(|case| case.models().into_iter().map(move |model| (case.path.clone(), model)))
        .collect();
    let solved = models.into_par_iter().filter_map(|(path, model)| match solve(&model) {
        Ok(Outcome::Equilibrium(solution)) => Some((path, *solution)),
        _ => None,
    });
    solved.collect()
}

fn relative(proof: &Proof) -> f64 {
    proof.energy / proof.strain_energy
}

/// Every solution under tension or without an axial force that is the only one is proven, but for the three at a threshold.
#[test]
fn solutions_of_all_case_files_are_proven_but_for_the_listed_exceptions() {
    let found: Vec<(String, Solution, Result<Proof, NotProven>)> = solutions()
        .into_par_iter()
        .map(|(path, solution)| {
            let proof = solution.prove();
            (path, solution, proof)
        })
        .collect();
    let mut exceptions: Vec<(&str, &Solution, String)> = Vec::new();
    for (path, solution, proof) in &found {
        let why = match proof {
            Ok(proof) => {
                let (gap, today) = (relative(proof), solution.certificate().relative_gap());
                // A quiet element is longer than all others, and the error of a moment grows with its length.
                let least = if path.contains("heavy-beam-lifted") { 4e-26 } else { 4e-27 };
                assert!(gap <= (1.01 * today).max(least), "{path}: {gap:e}, certificate {today:e}");
                proof.shortfall().map(|why| why.what)
            }
            Err(why) => Some(why.what.clone()),
        };
        exceptions.extend(why.map(|why| (path.as_str(), solution, why)));
    }
    let (all, proven) = (found.len(), found.len() - exceptions.len());
    println!("{proven} of {all} solutions are proven");
    for (path, solution, why) in &exceptions {
        let listed = EXCEPTIONS.iter().find(|(listed, ..)| listed == path);
        let (_, cause, reason) = listed.unwrap_or_else(|| panic!("{path} is not listed: {why}"));
        assert!(why.starts_with(reason), "{path}: {why}");
        let compressed = solution.model().beam.axial_force < 0.0;
        let of = match solution.existence().verdict {
            Verdict::NotUnique(_) if !compressed => Cause::OneOfMany,
            Verdict::Unique if !compressed => Cause::Threshold,
            Verdict::Local(_) if compressed => Cause::Compression,
            other => panic!("{path}: {other:?}"),
        };
        assert_eq!(of, *cause, "{path}");
    }
    for (path, ..) in EXCEPTIONS {
        assert!(exceptions.iter().any(|(found, ..)| *found == path), "{path} is proven");
    }
    let chapter = include_str!("../../docs/proof.md");
    assert_eq!(listed(chapter), EXCEPTIONS.map(row), "the table of docs/proof.md");
    let count = format!("Of the {all} solutions of the case files {proven} are proven");
    assert!(chapter.contains(&count), "docs/proof.md does not state: {count}");
    for (path, reached) in REACHED {
        let of_path = found.iter().filter(|(found, ..)| found == path);
        for (_, _, proof) in of_path {
            let gap = relative(proof.as_ref().expect("proven"));
            assert!(gap <= 2.0 * reached, "{path}: {gap:e} in place of {reached:e}");
        }
    }
}

/// Name, equilibrium and reason of an exception, as docs/proof.md lists them.
fn row((path, cause, reason): (&str, Cause, &str)) -> [String; 3] {
    let equilibrium = match cause {
        Cause::OneOfMany => "one of many",
        Cause::Threshold => "the only one",
        Cause::Compression => "local, under compression",
    };
    [path.rsplit('/').next().unwrap_or(path), equilibrium, reason].map(str::to_owned)
}

/// The rows of the table of exceptions in docs/proof.md: case file, equilibrium, reason of the program.
fn listed(chapter: &str) -> Vec<[String; 3]> {
    let (_, table) = chapter.split_once("| case file | equilibrium |").expect("the table");
    let rows = table.lines().skip(2).take_while(|line| line.starts_with('|'));
    let rows = rows.map(|line| {
        let cells: Vec<&str> = line.split('|').map(|cell| cell.trim().trim_matches('`')).collect();
        [1, 2, 3].map(|i| cells.get(i).copied().unwrap_or_default().to_owned())
    });
    rows.collect()
}

/// The proof in numbers of fewer digits has a larger bound.
#[test]
fn more_digits_give_smaller_proven_bounds() {
    for (path, solution) in solutions().iter().filter(|(path, _)| path.starts_with("kikuchi")) {
        let (model, answer) = solution.claim::<Ball>();
        let ball = prove(&model, &answer).expect("proven");
        let (model, answer) = solution.claim::<Wide>();
        let wide = prove(&model, &answer).expect("proven");
        assert!(wide.energy <= ball.energy * (1.0 + 1e-9), "{path}");
    }
}

/// The largest errors of a solution relative to their bounds, by quantity, against the answer in 60 digits.
fn errors(answer: &Answer, solution: &Solution, proof: &Proof) -> Vec<(&'static str, f64)> {
    let fields = Field::of(&solution.model().beam).filter_map(|field| {
        Some((field.name(), answer.largest_error(solution, field) / error_bound(proof, field)?))
    });
    let mut errors: Vec<_> = fields.collect();
    for (bound, found) in proof.reactions.iter().zip(solution.reactions()) {
        let exact = answer.reactions.iter().find(|exact| exact.at == found.at);
        let exact = exact.expect("a reaction of every support");
        // The exact reactions are rounded to doubles.
        let off = |a: f64, b: f64| (a - b).abs() - f64::EPSILON * b.abs();
        errors.push(("reaction", off(found.force, exact.force) / bound.force.error));
        errors.push(("support moment", off(found.moment, -exact.moment) / bound.moment.error));
    }
    errors
}

/// The answers in 60 digits lie within every bound, and nearly all solutions are proven.
#[test]
fn the_answers_in_sixty_digits_lie_within_every_bound() {
    let judged: Vec<_> = Answer::all()
        .into_par_iter()
        .filter_map(|answer| {
            let Ok(Outcome::Equilibrium(solution)) = solve(&answer.parsed()) else { return None };
            let proof = solution.prove().ok()?;
            let errors = errors(&answer, &solution, &proof);
            Some((answer.name, errors, proof.shortfall()))
        })
        .collect();
    let mut worst = BTreeMap::new();
    for (name, errors, shortfall) in &judged {
        for (kind, error) in errors {
            assert!(error.is_nan() || *error <= 1.0, "{name}: {kind} {error}");
            let worst = worst.entry(kind).or_insert(0.0_f64);
            *worst = worst.max(*error);
        }
        if let Some(why) = shortfall {
            println!("{name}: {why}");
        }
    }
    let proven = judged.iter().filter(|(_, _, shortfall)| shortfall.is_none()).count();
    println!("{proven} of {} are proven; errors over bounds {worst:.2?}", judged.len());
    assert!(judged.len() >= 246, "only {} models have bounds", judged.len());
    println!("{proven} solutions are proven");
    assert!(proven >= 239, "only {proven} models are proven");
}

/// The exact edges and concentrated forces outside the intervals of a proven contact set.
fn outside(answer: &Answer, contact: &ContactSet, length: f64) -> Vec<String> {
    let holds = |[low, high]: [f64; 2], x: f64, scale: f64| {
        let rounding = 4.0 * f64::EPSILON * scale;
        low - rounding <= x && x <= high + rounding
    };
    let mut regions: Vec<[[f64; 2]; 2]> = Vec::new();
    for region in &contact.regions {
        // Contact on both sides of an end of a layer is one region of the answer.
        match regions.last_mut() {
            Some(last) if region.from[0] <= last[1][1] => last[1] = region.to,
            _ => regions.push([region.from, region.to]),
        }
    }
    let mut wrong = Vec::new();
    if regions.len() != answer.contact.len() {
        wrong.push(format!("{regions:?} in place of {:?}", answer.contact));
    }
    for ([from, to], exact) in regions.iter().zip(&answer.contact) {
        if !holds(*from, exact[0], length) || !holds(*to, exact[1], length) {
            wrong.push(format!("{exact:?} is not in {from:?}, {to:?}"));
        }
    }
    let end = |key: &str| answer.end_forces.get(key).copied();
    let ends = [(0.0, end("left")), (length, end("right"))];
    let ends = ends.into_iter().filter_map(|(x, force)| Some((x, force?)));
    let inner = answer.inner_forces.iter().map(|force| (force.x, force.force));
    for (x, exact) in ends.chain(inner) {
        let near = |found: &&ContactForce| (found.x - x).abs() <= 1e-14 * length;
        let interval = contact.forces.iter().find(near).map_or([0.0; 2], |found| found.force);
        if !holds(interval, exact, exact.abs()) {
            wrong.push(format!("force {exact} at {x} is not in {interval:?}"));
        }
    }
    wrong
}

/// The edges and forces of the answers in 60 digits lie within their intervals, and nearly all contact sets are shown.
#[test]
fn the_answers_in_sixty_digits_have_the_proven_contact_set() {
    let judged: Vec<(String, Result<Vec<String>, String>)> = Answer::all()
        .into_par_iter()
        .filter_map(|answer| {
            let Ok(Outcome::Equilibrium(solution)) = solve(&answer.parsed()) else { return None };
            let proof = solution.prove().ok()?;
            let length = solution.model().beam.length;
            let shown = proof.contact.map(|contact| outside(&answer, &contact, length));
            Some((answer.name, shown.map_err(|why| why.to_string())))
        })
        .collect();
    for (name, why) in judged.iter().filter_map(|(name, shown)| Some((name, shown.as_ref().err()?)))
    {
        println!("{name}: {why}");
    }
    let shown = judged.iter().filter(|(_, shown)| shown.is_ok()).count();
    println!("{shown} of {} contact sets are shown", judged.len());
    for (name, wrong) in
        judged.iter().filter_map(|(name, shown)| Some((name, shown.as_ref().ok()?)))
    {
        assert!(wrong.is_empty(), "{name}: {wrong:?}");
    }
    assert!(shown >= 239, "only {shown} contact sets are shown");
}

/// The answer to a model with one number changed is claimed for the original model: every bound
/// holds.
#[test]
fn answers_to_neighbouring_models_lie_within_every_bound() {
    let changes: [fn(&mut Model, f64); 4] = [
        |model, factor| model.beam.bending_stiffness *= factor,
        |model, factor| model.foundation = model.foundation.clone().scaled(factor, 1.0),
        |model, factor| model.foundation = model.foundation.clone().scaled(1.0, factor),
        |model, factor| *model = model.clone().with_loads_scaled(factor),
    ];
    let mut claims = Vec::new();
    for (i, answer) in Answer::all().into_iter().enumerate() {
        for (j, change) in changes.into_iter().enumerate() {
            let size = [1e-6, 1e-4, 1e-2][(i + j) % 3];
            claims.push((answer.name.clone(), answer.parsed(), change, size));
        }
    }
    let judged: Vec<(String, f64, f64)> = claims
        .into_par_iter()
        .filter_map(|(name, model, change, size)| {
            let Ok(Outcome::Equilibrium(truth)) = solve(&model) else { return None };
            let mut neighbour = model.clone();
            change(&mut neighbour, 1.0 + size);
            let Ok(Outcome::Equilibrium(claimed)) = solve(&neighbour) else { return None };
            let (_, answer) = claimed.claim::<Wide>();
            let proof = prove(&model.to_prove::<Wide>(), &answer).ok()?;
            let energy = energy_of_error(&claimed, &truth, true) / proof.energy;
            Some((name, over_bound(&claimed, &truth, &proof, true), energy))
        })
        .collect();
    assert!(judged.len() >= 700, "only {} claims are judged", judged.len());
    let most = judged
        .iter()
        .fold([0.0_f64; 2], |most, (_, bound, energy)| [most[0].max(*bound), most[1].max(*energy)]);
    println!(
        "{} claims, error over bound {:.3}, energy over E {:.3}",
        judged.len(),
        most[0],
        most[1]
    );
    for (name, bound, energy) in &judged {
        assert!(*bound <= 1.0, "{name}: error over bound {bound}");
        assert!(*energy <= 1.001, "{name}: energy of the error over E {energy}");
    }
    // If no error came near its bound, the test would measure nothing.
    assert!(most[0] > 0.1 && most[1] > 0.1, "{most:?}");
}

/// Next to a nearly rigid hinge the ground is open over 1e-10 of the length. The estimate computes the flux of such a
/// stretch from the rise of the beam over it: the difference of two settlements would have no digits.
#[test]
fn the_estimate_is_sharp_on_short_open_stretches() {
    let mut short = 0;
    for number in 0..60 {
        let mut model = model(Family::Hinged, number);
        if model.beam.axial_force < 0.0 {
            continue;
        }
        let stiff = 1e9 * model.beam.bending_stiffness / model.beam.length;
        model.hinges.iter_mut().for_each(|hinge| hinge.rotational_spring = stiff);
        let Ok(Outcome::Equilibrium(solution)) = solve(&model) else {
            panic!("{number}: not solved")
        };
        let open = |x: [f64; 2]| x[1] - x[0] < 1e-8 * model.beam.length;
        let (_, answer) = solution.claim::<f64>();
        short += usize::from(answer.pieces.iter().any(|piece| !piece.touches && open(piece.x)));
        let gap = solution.certificate().relative_gap();
        assert!(gap < 1e-12, "{number}: {gap:e}");
    }
    assert!(short > 3, "{short}");
}
