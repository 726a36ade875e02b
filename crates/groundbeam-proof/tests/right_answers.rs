//! Tests right answers: they are proven, with the same digits in any units, and the bounds cover every changed number.

use groundbeam_proof::{
    Action, Answer, Course, Extent, GroundEnd, Model, Proof, Scalar, SupportKind, Wide, prove,
    read_model,
};
use serde_json::Value;

/// The right answers of `cases/attacks.json`, on a shear layer and on Winkler ground.
fn right_answers() -> Vec<(String, String, Answer)> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/attacks.json");
    let text = std::fs::read_to_string(path).expect("cases/attacks.json");
    let all: Vec<Value> = serde_json::from_str(&text).expect("attacks");
    let word = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let right = all.iter().filter(|attack| word(&attack["name"]).starts_with("right"));
    right
        .map(|attack| {
            let answer = Answer::from_json(&attack["claimed"].to_string()).expect("an answer");
            (word(&attack["name"]), word(&attack["model"]), answer)
        })
        .collect()
}

fn model(text: &str) -> Model<Wide> {
    read_model(text, None).expect("a model")
}

/// The model in other units of length and force, 2ⁿ each.
fn scaled_model(model: &Model<Wide>, length: i32, force: i32) -> Model<Wide> {
    let by = |x: Wide, f: i32, l: i32| x.scaled(f * force + l * length);
    let course = |course: &Course<Wide>, f: i32, l: i32| match course {
        Course::Constant(x) => Course::Constant(by(*x, f, l)),
        Course::Varying(all) => Course::Varying(all.iter().map(|x| by(*x, f, l)).collect()),
    };
    let mut scaled = model.clone();
    scaled.beam.length = by(model.beam.length, 0, 1);
    scaled.beam.bending_stiffness = by(model.beam.bending_stiffness, 1, 2);
    scaled.beam.axial_force = by(model.beam.axial_force, 1, 0);
    scaled.ground.spring = by(model.ground.spring, 1, -2);
    scaled.ground.shear = by(model.ground.shear, 1, 0);
    for segment in &mut scaled.beam.segments {
        (segment.from, segment.to) = (by(segment.from, 0, 1), by(segment.to, 0, 1));
        segment.bending_stiffness = course(&segment.bending_stiffness, 1, 2);
    }
    for end in &mut scaled.ground.ends {
        *end = match *end {
            GroundEnd::Endless => GroundEnd::Endless,
            GroundEnd::Free(at) => GroundEnd::Free(by(at, 0, 1)),
            GroundEnd::Held(at) => GroundEnd::Held(by(at, 0, 1)),
        };
    }
    for load in &mut scaled.loads {
        let (f, l) = match load.action {
            Action::Force => (1, 0),
            Action::Moment => (1, 1),
            Action::Curvature => (0, 0),
        };
        load.extent = match load.extent {
            Extent::Point { at, size } => Extent::Point { at: by(at, 0, 1), size: by(size, f, l) },
            Extent::Distributed { from, to, start, end } => Extent::Distributed {
                from: by(from, 0, 1),
                to: by(to, 0, 1),
                start: by(start, f, l - 1),
                end: by(end, f, l - 1),
            },
        };
    }
    for support in &mut scaled.supports {
        support.at = by(support.at, 0, 1);
        if let SupportKind::Spring { spring, rotational_spring } = &mut support.kind {
            (*spring, *rotational_spring) = (by(*spring, 1, -1), by(*rotational_spring, 1, 1));
        }
    }
    for corner in &mut scaled.gap {
        (corner.at, corner.value) = (by(corner.at, 0, 1), by(corner.value, 0, 1));
    }
    scaled
}

fn scaled_answer(answer: &Answer, length: i32, force: i32) -> Answer {
    let (l, f) = (2.0_f64.powi(length), 2.0_f64.powi(force));
    let mut scaled = answer.clone();
    for piece in &mut scaled.pieces {
        piece.x = piece.x.map(|x| x * l);
        piece.half *= l;
        piece.deflection.iter_mut().for_each(|c| *c *= l);
        piece.open = piece.open.map(|ends| ends.map(|u| u * l));
    }
    for at in &mut scaled.forces {
        (at.x, at.force) = (at.x * l, at.force * f);
    }
    scaled
}

#[test]
fn other_units_give_the_same_digits() {
    for (name, text, answer) in right_answers() {
        let given = model(&text);
        let proof = prove(&given, &answer).expect("proven");
        for (length, force) in [(0, 500), (0, -500), (100, 0), (-100, 0), (60, -200)] {
            let scaled =
                prove(&scaled_model(&given, length, force), &scaled_answer(&answer, length, force));
            let scaled = scaled.unwrap_or_else(|why| panic!("{name}: {why}"));
            let energy = f64::scaled(proof.energy, length + force);
            assert_eq!(scaled.energy, energy, "{name}: 2^{length} m, 2^{force} N");
            let moment = f64::scaled(proof.bounds.moment.error, length + force);
            assert_eq!(scaled.bounds.moment.error, moment, "{name}");
            assert_eq!(scaled.bounds.slope.error, proof.bounds.slope.error, "{name}");
        }
    }
}

/// w at stations.
fn deflections(answer: &Answer) -> Vec<f64> {
    let last = answer.pieces.len() - 1;
    let length = answer.pieces[last].x[1];
    (0..23)
        .map(|i| {
            let x = length * (0.01 + 0.98 * f64::from(i) / 22.0);
            let piece = answer.pieces.iter().find(|piece| x <= piece.x[1]).expect("a piece");
            let t = (x - 0.5 * (piece.x[0] + piece.x[1])) / piece.half;
            piece.deflection.iter().rev().fold(0.0, |sum, c| sum * t + c)
        })
        .collect()
}

/// Every stored number times 1 + 10⁻⁶: the proof refuses the answer, or the old and the new bound cover the difference.
#[test]
fn a_change_of_any_number_is_refused_or_within_the_bounds() {
    let (mut refused, mut accepted) = (0, 0);
    for (name, text, answer) in right_answers() {
        let given = model(&text);
        let proof = prove(&given, &answer).expect("proven");
        let mut check = |what: String, changed: Answer| match prove(&given, &changed) {
            Err(_) => refused += 1,
            Ok(new) => {
                accepted += 1;
                covered(&what, (&answer, &proof), (&changed, &new));
            }
        };
        let change = |x: &mut f64| *x *= 1.0 + 1e-6;
        for (i, piece) in answer.pieces.iter().enumerate() {
            for j in 0..piece.deflection.len() {
                let mut changed = answer.clone();
                change(&mut changed.pieces[i].deflection[j]);
                check(format!("{name}: w[{i}][{j}]"), changed);
            }
            let mut changed = answer.clone();
            change(&mut changed.pieces[i].half);
            check(format!("{name}: half[{i}]"), changed);
            if i > 0 {
                let mut changed = answer.clone();
                change(&mut changed.pieces[i].x[0]);
                changed.pieces[i - 1].x[1] = changed.pieces[i].x[0];
                check(format!("{name}: x[{i}]"), changed);
            }
        }
        for i in 0..answer.forces.len() {
            let mut changed = answer.clone();
            change(&mut changed.forces[i].force);
            check(format!("{name}: force {i}"), changed);
        }
    }
    assert!(refused > 0 && accepted > 50, "{refused} refused, {accepted} accepted");
}

fn covered(what: &str, (old, old_proof): (&Answer, &Proof), (new, new_proof): (&Answer, &Proof)) {
    let bound = old_proof.bounds.deflection.error + new_proof.bounds.deflection.error;
    for (a, b) in deflections(old).iter().zip(deflections(new)) {
        assert!((a - b).abs() <= bound * (1.0 + 1e-9) + 1e-15, "{what}: {a} {b} {bound:e}");
    }
}
