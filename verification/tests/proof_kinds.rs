//! The proof of kinds of model beyond those of the 60-digit answers: right answers of frozen random models, and answers
//! of neighbouring models claimed for them.
//!
//! Claims: `docs/proof.md`.

use groundbeam::proof::{Proof, Wide, prove};
use groundbeam::{
    Field, Load, Model, Outcome, Solution, SupportKind, model::Extent, own_buckling_load, solve,
};
use groundbeam_verification::carried::model as carried;
use groundbeam_verification::claims::{CHANGES, energy_of_error, over_bound};
use groundbeam_verification::frozen;
use rayon::prelude::*;

/// The frozen models of a family that have an equilibrium, with their number and solution.
fn solutions(family: &str) -> Vec<(String, Solution)> {
    let all = frozen::family(&frozen::folder(), family).expect("a family");
    let models = all.par_iter().map(|one| (format!("{family} {}", one.number()), one.model()));
    let solved = models.filter_map(|(name, model)| match solve(&model.ok()?) {
        Ok(Outcome::Equilibrium(solution)) => Some((name, *solution)),
        _ => None,
    });
    solved.collect()
}

/// The same models under a compression between a tenth and nine tenths of the critical load of the beam
/// alone, if it has a critical load.
fn compressed(family: &str) -> Vec<(String, Solution)> {
    let all = frozen::family(&frozen::folder(), family).expect("a family");
    let solved = all.par_iter().enumerate().take(150).filter_map(|(i, one)| {
        let mut model = one.model().ok()?;
        let two_way = |model: &Model| {
            let mut held = model.clone();
            held.supports.retain(|support| !support.is_one_way());
            held
        };
        let critical = own_buckling_load(&two_way(&model));
        if !(critical > 0.0 && critical < f64::INFINITY) {
            return None;
        }
        model.beam.axial_force = -critical * [0.1, 0.3, 0.5, 0.7, 0.9][i % 5];
        match solve(&model) {
            Ok(Outcome::Equilibrium(solution)) => {
                Some((format!("{family} {} compressed", one.number()), *solution))
            }
            _ => None,
        }
    });
    solved.collect()
}

/// The ends of the true contact zones outside all intervals of a proven contact set.
fn missed_edges(truth: &Solution, proof: &Proof) -> Vec<f64> {
    let Ok(set) = &proof.contact else { return Vec::new() };
    let rounding = 1e-8 * truth.model().beam.length;
    let holds = |[low, high]: [f64; 2], x: f64| low - rounding <= x && x <= high + rounding;
    let known = |x: f64| set.regions.iter().any(|r| holds(r.from, x) || holds(r.to, x));
    let edges = truth.contact().iter().flat_map(|zone| [zone.from, zone.to]);
    edges.filter(|x| !known(*x)).collect()
}

/// Whether the ground and the loads on it are the same.
fn same_ground(a: &Model, b: &Model) -> bool {
    a.foundation == b.foundation && a.ground_loads().eq(b.ground_loads())
}

/// σ of a compression: 1 minus the compression over the critical load.
fn margin(model: &Model) -> f64 {
    let axial = model.beam.axial_force;
    if axial < 0.0 { 1.0 + axial / own_buckling_load(model) } else { 1.0 }
}

/// The results of the claims of a family.
struct Judged {
    /// E relative to the strain energy for the right answers, in increasing order.
    gaps: Vec<f64>,
    /// The reasons why right answers are not proven.
    refused: Vec<String>,
    /// Number of proven contact sets of right answers.
    shown: usize,
    /// Number of right answers that are completely proven.
    proven: usize,
    claims: usize,
    /// The largest ratios for wrong claims: of error to bound, and of the energy of the error to E.
    most: [f64; 2],
}

fn judge(family: &str, solutions: &[(String, Solution)]) -> Judged {
    let right: Vec<_> = solutions.par_iter().map(|(name, s)| (name, s.prove())).collect();
    let mut found = Judged {
        gaps: Vec::new(),
        refused: Vec::new(),
        shown: 0,
        proven: 0,
        claims: 0,
        most: [0.0; 2],
    };
    for (name, proof) in right {
        match proof {
            Ok(proof) => {
                let gap = proof.energy / proof.strain_energy;
                if gap > 1e-18 {
                    println!("{name}: E is {gap:.1e} of {:.1e}", proof.strain_energy);
                }
                found.gaps.push(gap);
                found.shown += usize::from(proof.contact.is_ok());
                found.proven += usize::from(proof.shortfall().is_none());
                if let Some(why) = proof.shortfall() {
                    println!("{name}: {why}");
                }
            }
            Err(why) => found.refused.push(format!("{name}: {why}")),
        }
    }
    found.gaps.sort_by(f64::total_cmp);
    let mut claims = Vec::new();
    for (i, (name, truth)) in solutions.iter().enumerate() {
        for (j, change) in CHANGES.into_iter().enumerate() {
            let size = [1e-6, 1e-4, 1e-3, 1e-2, 1e-1][(i + j) % 5];
            claims.push((name, truth, change, size));
        }
    }
    let judged: Vec<(&String, f64, f64)> = claims
        .into_par_iter()
        .filter_map(|(name, truth, change, size)| {
            let mut neighbour = truth.model().clone();
            change(&mut neighbour, 1.0 + size);
            if neighbour == *truth.model() {
                return None;
            }
            let Ok(Outcome::Equilibrium(claimed)) = solve(&neighbour) else { return None };
            let (_, answer) = claimed.claim::<Wide>();
            let proof = prove(&truth.model().to_prove::<Wide>(), &answer).ok()?;
            // The proof solves the open ground with the model's own numbers, but the claimed surface belongs
            // to the neighbour's numbers.
            let ground = same_ground(&neighbour, truth.model());
            let energy = margin(truth.model()) * energy_of_error(&claimed, truth, ground);
            let missed = missed_edges(truth, &proof);
            assert!(missed.is_empty(), "{name}: edges {missed:?} are not in {:?}", proof.contact);
            let ratio = over_bound(&claimed, truth, &proof, ground);
            // The solver's solution, taken as the true one, has an error of its own.
            let own = truth.certificate().gap();
            let limit = proof.energy + own + 2.0 * (proof.energy * own).sqrt();
            Some((name, ratio, energy / limit))
        })
        .collect();
    found.claims = judged.len();
    for (name, bound, energy) in judged {
        assert!(bound <= 1.0, "{name}: error over bound {bound}");
        assert!(energy <= 1.001, "{name}: energy of the error over E {energy}");
        found.most = [found.most[0].max(bound), found.most[1].max(energy)];
    }
    println!("{}", found.refused.join("\n"));
    println!(
        "{family}: {} proven, E over strain energy median {:.1e}, most {:.1e}; {} contact sets shown, {} small bounds; {} claims, error over bound {:.3}, energy over E {:.3}",
        found.gaps.len(),
        found.gaps.get(found.gaps.len() / 2).copied().unwrap_or(f64::NAN),
        found.gaps.last().copied().unwrap_or(f64::NAN),
        found.shown,
        found.proven,
        found.claims,
        found.most[0],
        found.most[1],
    );
    found
}

#[test]
fn beams_on_one_way_supports_are_proven() {
    let found = judge("OneWay", &solutions("OneWay"));
    assert!(found.gaps.len() >= 195 && found.claims >= 800, "{}", found.claims);
    assert!(found.gaps.last().is_some_and(|gap| *gap < 1e-18));
    assert!(found.most[0] > 0.1 && found.most[1] > 0.1, "{:?}", found.most);
}

#[test]
fn beams_with_shear_deformation_are_proven() {
    let found = judge("Shearing", &solutions("Shearing"));
    assert!(found.gaps.len() >= 133 && found.shown >= 130, "{} {}", found.gaps.len(), found.shown);
    assert!(found.proven >= 127 && found.claims >= 600, "{} {}", found.proven, found.claims);
    assert!(found.gaps.last().is_some_and(|gap| *gap < 1e-18));
    assert!(found.most[0] > 0.1 && found.most[1] > 0.1, "{:?}", found.most);
}

/// The frozen models of a family with a shear stiffness proportional to EI.
fn sheared(family: &str) -> Vec<(String, Solution)> {
    let all = frozen::family(&frozen::folder(), family).expect("a family");
    let solved = all.par_iter().enumerate().filter_map(|(i, one)| {
        let mut model = one.model().ok()?;
        model.beam.axial_force = model.beam.axial_force.max(0.0);
        let factor = [3.0, 30.0, 300.0][i % 3] / (model.beam.length * model.beam.length);
        model.beam.shear_stiffness = Some(factor * model.beam.bending_stiffness);
        for segment in &mut model.beam.segments {
            segment.shear_stiffness = Some(segment.bending_stiffness.scaled(factor));
        }
        match solve(&model) {
            Ok(Outcome::Equilibrium(solution)) => {
                Some((format!("{family} {} sheared", one.number()), *solution))
            }
            _ => None,
        }
    });
    solved.collect()
}

#[test]
fn beams_of_varying_shear_stiffness_are_proven() {
    let found = judge("sheared", &sheared("Varying"));
    assert!(found.refused.is_empty(), "{:?}", found.refused);
    assert!(found.gaps.len() >= 201 && found.shown >= 177, "{}", found.shown);
    assert!(found.claims >= 1050, "{}", found.claims);
    assert!(found.most[0] > 0.1 && found.most[1] > 0.1, "{:?}", found.most);
}

#[test]
fn models_that_vary_within_segments_are_proven() {
    let found = judge("Varying", &solutions("Varying"));
    for why in &found.refused {
        assert!(why.contains("the critical load is not proven"), "{why}");
    }
    assert!(found.gaps.len() >= 194 && found.shown >= 187, "{}", found.shown);
    assert!(found.claims >= 840, "{}", found.claims);
    // Two models have no strain energy.
    assert!(found.gaps.iter().filter(|gap| gap.is_finite()).all(|gap| *gap < 1e-15));
    assert!(found.most[0] > 0.1 && found.most[1] > 0.1, "{:?}", found.most);
}

/// Frozen models with loads on the ground, unchanged and on Winkler ground.
#[test]
fn models_with_loads_on_the_ground_are_proven() {
    let mut all: Vec<_> = ["Beside", "Neighbours"].into_iter().flat_map(solutions).collect();
    let given: Vec<(String, Model)> =
        all.iter().map(|(name, solution)| (name.clone(), solution.model().clone())).collect();
    let others = given.into_par_iter().filter_map(|(name, mut model)| {
        model.foundation = model.foundation.scaled(1.0, 0.0);
        let at_a_point = |load: &Load| matches!(load.extent(), Extent::Point { .. });
        model.loads.retain(|load| !(load.is_on_ground() && at_a_point(load)));
        match solve(&model) {
            Ok(Outcome::Equilibrium(solution)) => Some((format!("{name} on springs"), *solution)),
            _ => None,
        }
    });
    all.extend(others.collect::<Vec<_>>());
    all.retain(|(_, s)| s.model().loads.iter().any(|load| load.is_on_ground()));
    let found = judge("ground loads", &all);
    assert!(
        found.gaps.len() >= 306 && found.shown >= 306 && found.claims >= 1100,
        "{}",
        found.claims
    );
    assert!(found.gaps.last().is_some_and(|gap| *gap < 1e-18));
    assert!(found.most[0] > 0.1 && found.most[1] > 0.1, "{:?}", found.most);
}

/// Frozen models under a compression. Without a proven critical load, the reason is returned.
#[test]
fn beams_under_compression_are_proven_or_the_reason_is_returned() {
    let families = ["Supported", "Settled", "OneWay", "Shearing", "Hinged"];
    let solutions: Vec<_> = families.into_iter().flat_map(compressed).collect();
    let found = judge("compression", &solutions);
    for why in &found.refused {
        let named = ["the critical load is not proven", "not covered: "];
        assert!(named.iter().any(|name| why.contains(name)), "{why}");
    }
    assert!(found.gaps.len() >= 245 && found.claims >= 1300, "{}", found.claims);
    assert!(found.gaps.last().is_some_and(|gap| *gap < 1e-15));
    assert!(found.most[0] > 0.1 && found.most[1] > 0.1, "{:?}", found.most);
}

/// An inactive support is moved to the beam. The answer stays the same; rounding decides whether the support is active.
#[test]
fn a_support_within_rounding_of_acting_is_named_and_all_bounds_hold() {
    let (mut judged, mut most) = (0, 0.0_f64);
    for (name, apart) in solutions("OneWay") {
        let mut model = apart.model().clone();
        let idle = (0..model.supports.len())
            .find(|i| model.supports[*i].is_one_way() && apart.reactions()[*i].force == 0.0);
        let Some(i) = idle else { continue };
        let at = model.supports[i].at;
        model.supports[i].settlement = apart.value(Field::Deflection, at);
        let Ok(Outcome::Equilibrium(close)) = solve(&model) else { continue };
        if apart.prove().is_err() {
            continue;
        }
        let proof = close.prove().unwrap_or_else(|why| panic!("{name}: {why}"));
        assert!(proof.energy <= 1e-18 * proof.strain_energy, "{name}: {}", proof.energy);
        let ratio = over_bound(&close, &apart, &proof, true);
        assert!(ratio <= 1.0, "{name}: error over bound {ratio}");
        if let Err(why) = &proof.supports {
            assert!(
                why.what.starts_with("the beam is too close to a one-way support"),
                "{name}: {why}"
            );
            assert!(why.at == Some(at) && proof.shortfall().is_some(), "{name}: {why}");
            judged += 1;
        }
        most = most.max(ratio);
    }
    println!("{judged} supports are not decided, error over bound {most:.3}");
    assert!(judged > 80, "{judged}");
}

/// Beams that touch one end or one corner of the ground only: without the tension, the contact force has no lever arm.
#[test]
fn beams_balanced_by_tension_are_proven() {
    let solved = (0..120_u64).into_par_iter().filter_map(|number| match solve(&carried(number)) {
        Ok(Outcome::Equilibrium(solution)) => Some((format!("carried {number}"), *solution)),
        _ => None,
    });
    let solutions: Vec<_> = solved.collect();
    let found = judge("carried", &solutions);
    assert!(found.refused.is_empty(), "{:?}", found.refused);
    assert!(found.gaps.len() >= 100 && found.claims >= 500, "{}", found.claims);
    assert!(found.gaps.last().is_some_and(|gap| *gap < 1e-18));
    assert!(found.most[0] > 0.1 && found.most[1] > 0.1, "{:?}", found.most);
}

/// Hinges of both kinds, rotational springs, clamps on the ground, and tension.
#[test]
fn beams_with_springs_hinges_and_tension_are_proven() {
    let families = ["Hinged", "Supported", "Settled", "Mixed", "Tension"];
    let solutions: Vec<_> = families.into_iter().flat_map(solutions).collect();
    let found = judge("held", &solutions);
    for why in &found.refused {
        assert!(why.contains("the critical load is not proven"), "{why}");
    }
    let counts = [found.gaps.len(), found.shown, found.proven, found.claims];
    assert!(counts[0] >= 1000 && counts[1] >= 985 && counts[2] >= 980, "{counts:?}");
    assert!(counts[3] >= 4700, "{counts:?}");
    assert!(found.most[0] > 0.1 && found.most[1] > 0.1, "{:?}", found.most);
}

/// Models that are each proven by one particular rule.
#[test]
fn models_that_need_a_particular_rule_are_proven() {
    for (title, rule) in [
        ("Hinged 9", "parts joined by an elastic hinge are bounded together"),
        ("OneWay 85", "a spring against rotation bounds the slope"),
        ("Shearing 71", "it bounds the slope of a beam that nearly reaches a support"),
        ("Supported 35", "a clamp stands on open ground of a layer"),
        ("Mixed 72", "an end without load rests beside a clamp, on Winkler ground"),
        ("Hinged 93", "an end without load rests beside a clamp, on a layer"),
        ("Tension 5", "the curvature bounds the shear force under tension"),
        ("Extreme 4", "the pressure beside an edge is that near the edge"),
    ] {
        let (family, number) = title.split_once(' ').expect("a family and a number");
        let all = frozen::family(&frozen::folder(), family).expect("a family");
        let number: u64 = number.parse().expect("a number");
        let one = all.iter().find(|one| one.number() == number).expect("a frozen model");
        let Ok(Outcome::Equilibrium(solution)) = solve(&one.model().expect("a model")) else {
            panic!("{title}: no solution")
        };
        let proof = solution.prove().unwrap_or_else(|why| panic!("{title}: {why}"));
        assert_eq!(proof.shortfall(), None, "{title}: {rule}");
    }
}

/// The answer to a model without its active supports, claimed for the model with these as inactive: nothing is proven,
/// or bounds that hold.
#[test]
fn a_beam_that_penetrates_a_support_is_not_proven() {
    let (mut judged, mut bounded, mut most) = (0, 0, 0.0_f64);
    for (name, truth) in solutions("OneWay") {
        let acts =
            |i: usize| truth.model().supports[i].is_one_way() && truth.reactions()[i].force != 0.0;
        let kept: Vec<usize> = (0..truth.reactions().len()).filter(|i| !acts(*i)).collect();
        let mut without = truth.model().clone();
        without.supports = kept.iter().map(|i| truth.model().supports[*i]).collect();
        if kept.len() == truth.model().supports.len() {
            continue;
        }
        let Ok(Outcome::Equilibrium(claimed)) = solve(&without) else { continue };
        let (_, mut answer) = claimed.claim::<Wide>();
        for reaction in &mut answer.reactions {
            reaction.support = kept[reaction.support];
        }
        judged += 1;
        let Ok(proof) = prove(&truth.model().to_prove::<Wide>(), &answer) else { continue };
        assert!(proof.shortfall().is_some(), "{name} is proven");
        let ratio = over_bound(&claimed, &truth, &proof, true);
        assert!(ratio <= 1.0, "{name}: error over bound {ratio}");
        (bounded, most) = (bounded + 1, most.max(ratio));
    }
    println!("{judged} answers, {bounded} have bounds, error over bound {most:.3}");
    assert!(judged > 100, "{judged}");
}

/// The answer to a model with clamps, claimed for pins: the proof refuses it, because a pin has no moment.
#[test]
fn a_moment_at_a_pin_is_refused() {
    let mut judged = 0;
    for (name, clamped) in solutions("Supported") {
        let mut pinned = clamped.model().clone();
        for support in &mut pinned.supports {
            if support.kind == SupportKind::Fixed {
                support.kind = SupportKind::Pinned;
            }
        }
        let (_, answer) = clamped.claim::<Wide>();
        if answer.reactions.iter().all(|reaction| reaction.moment == 0.0)
            || pinned == *clamped.model()
        {
            continue;
        }
        let proof = prove(&pinned.to_prove::<Wide>(), &answer);
        assert!(proof.is_err(), "{name} is accepted");
        judged += 1;
    }
    assert!(judged > 20, "{judged}");
}
