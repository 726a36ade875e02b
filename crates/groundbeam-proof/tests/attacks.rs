//! Tests documents with wrong answers: none is proven, and every given bound holds.
//!
//! Claims: `docs/proof.md`.

use groundbeam_proof::{
    Answer, NotProven, Proof, ReadError, Reason, Scalar, SupportKind, Wide, prove, read_model,
};
use serde_json::Value;

/// One document with the true solution, from `cases/attacks.json`.
struct Attack {
    name: String,
    model: String,
    claimed: String,
    truth: Value,
    /// The expected exit status; `None` if both 0 and 1 are correct.
    exit: Option<i64>,
}

fn attacks() -> Vec<Attack> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/attacks.json");
    let text = std::fs::read_to_string(path).expect("cases/attacks.json");
    let all: Vec<Value> = serde_json::from_str(&text).expect("attacks");
    let word = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let one = |attack: &Value| Attack {
        name: word(&attack["name"]),
        model: word(&attack["model"]),
        claimed: match &attack["claimed_text"] {
            Value::String(text) => text.clone(),
            _ => attack["claimed"].to_string(),
        },
        truth: attack["truth"].clone(),
        exit: attack["exit"].as_i64(),
    };
    all.iter().map(one).collect()
}

/// The result for a document: unreadable, not proven, or proven.
enum Verdict {
    Unreadable,
    NotProven(NotProven),
    Proven(Answer, Box<Proof>),
}

fn verdict(attack: &Attack) -> Verdict {
    let Ok(answer) = Answer::from_json(&attack.claimed) else { return Verdict::Unreadable };
    match read_model::<Wide>(&attack.model, None) {
        Err(ReadError { reason: Reason::OutOfRange(what), .. }) => {
            Verdict::NotProven(NotProven { what, at: None })
        }
        Err(_) => Verdict::Unreadable,
        Ok(model) => match prove(&model, &answer) {
            Err(why) => Verdict::NotProven(why),
            Ok(proof) => Verdict::Proven(answer, Box::new(proof)),
        },
    }
}

/// w, w′ and w″ of an answer at x.
fn fields(answer: &Answer, x: f64) -> [f64; 3] {
    let piece = answer.pieces.iter().find(|piece| x <= piece.x[1]).expect("a piece");
    let t = (x - 0.5 * (piece.x[0] + piece.x[1])) / piece.half;
    let value = |c: &[f64]| c.iter().rev().fold(0.0, |sum, c| sum * t + c);
    let derived = |c: &[f64]| -> Vec<f64> {
        let terms = c.iter().enumerate().skip(1);
        terms.map(|(j, c)| j as f64 * c / piece.half).collect()
    };
    let slope = derived(&piece.deflection);
    [value(&piece.deflection), value(&slope), value(&derived(&slope))]
}

/// The largest of error over bound for deflection, slope and moment at the stations and for reactions, and the energy of
/// the error over E.
fn worst(attack: &Attack, answer: &Answer, proof: &Proof) -> f64 {
    let model = read_model::<Wide>(&attack.model, None).expect("a model");
    let number = |value: &Value| value.as_str().and_then(|x| x.parse().ok()).unwrap_or(f64::NAN);
    let mut worst: f64 = 0.0;
    for station in attack.truth["stations"].as_array().expect("stations") {
        let [w, slope, bent] = fields(answer, number(&station["x"]));
        let moment = -model.beam.bending_stiffness.middle() * bent;
        for (claimed, name, bound) in [
            (w, "deflection", proof.bounds.deflection.error),
            (slope, "slope", proof.bounds.slope.error),
            (moment, "moment", proof.bounds.moment.error),
        ] {
            let truth = number(&station[name]);
            // The claimed values contain rounding errors.
            let error = (claimed - truth).abs() - 1e-13 * truth.abs();
            assert!(error.is_finite(), "{}: {name}", attack.name);
            worst = worst.max(error / bound);
        }
    }
    for (i, reaction) in attack.truth["reactions"].as_array().into_iter().flatten().enumerate() {
        let claimed = answer.reactions.iter().find(|claimed| claimed.support == i);
        let claimed = claimed.map_or(0.0, |claimed| claimed.force);
        let truth = number(if reaction.is_object() { &reaction["force"] } else { reaction });
        let error = (claimed - truth).abs() - 1e-13 * truth.abs();
        assert!(error.is_finite(), "{}: reaction {i}", attack.name);
        worst = worst.max(error / proof.reactions[i].force.error);
    }
    let energy = number(&attack.truth["energy_of_error"]);
    worst.max(energy / proof.energy)
}

/// A proven contact set is the exact one, with every edge and end force in its interval.
fn contact_is_true(attack: &Attack, proof: &Proof) {
    let Ok(contact) = &proof.contact else { return };
    let number = |value: &Value| value.as_str().and_then(|x| x.parse().ok()).unwrap_or(f64::NAN);
    let list = |name: &str| attack.truth[name].as_array().cloned().unwrap_or_default();
    let mut exact: Vec<[f64; 2]> =
        list("contact").iter().map(|region| [number(&region[0]), number(&region[1])]).collect();
    exact.extend(list("points").iter().map(|at| [number(at); 2]));
    exact.sort_by(|a, b| a[0].total_cmp(&b[0]));
    assert_eq!(contact.regions.len(), exact.len(), "{}: {contact:?}", attack.name);
    // The true values have 20 digits, a double has 16.
    let holds = |[low, high]: [f64; 2], x: f64| {
        let rounding = 4.0 * f64::EPSILON * x.abs();
        low - rounding <= x && x <= high + rounding
    };
    for (region, [from, to]) in contact.regions.iter().zip(&exact) {
        assert!(holds(region.from, *from) && holds(region.to, *to), "{}: {region:?}", attack.name);
    }
    let length = read_model::<Wide>(&attack.model, None).expect("a model").beam.length.middle();
    for (end, x) in [0.0, length].into_iter().enumerate() {
        let wanted = number(&attack.truth["end_forces"][end]);
        let found = contact.forces.iter().find(|force| force.x == x);
        let held = found.map_or([0.0; 2], |force| force.force);
        assert!(wanted.is_nan() || holds(held, wanted), "{}: {held:?} {wanted}", attack.name);
    }
}

#[test]
fn attacks_are_refused_and_all_bounds_hold() {
    for attack in attacks() {
        let (exit, what) = match verdict(&attack) {
            Verdict::Unreadable => (2, "it cannot be read".to_owned()),
            Verdict::NotProven(why) => (1, why.to_string()),
            Verdict::Proven(answer, proof) => {
                let ratio = worst(&attack, &answer, &proof);
                assert!(ratio <= 1.0, "{}: {ratio}", attack.name);
                contact_is_true(&attack, &proof);
                let shortfall = proof.shortfall();
                let exit = i64::from(shortfall.is_some());
                let why = shortfall.map_or_else(|| "proven".to_owned(), |why| why.to_string());
                (exit, format!("{why}; error over bound {ratio:.2}"))
            }
        };
        println!("{:30} {exit} {what}", attack.name);
        match attack.exit {
            Some(expected) => assert_eq!(exit, expected, "{}: {what}", attack.name),
            None => assert!(exit < 2, "{}: {what}", attack.name),
        }
    }
}

/// A pin cannot hold a moment: an answer that claims one is refused.
#[test]
fn a_moment_at_a_pin_is_refused() {
    let all = attacks();
    let pinned = all.iter().find(|attack| attack.name == "pin-between-springs-1").expect("a pin");
    let Verdict::Proven(mut answer, _) = verdict(pinned) else { panic!("it has bounds") };
    let model = read_model::<Wide>(&pinned.model, None).expect("a model");
    for reaction in &mut answer.reactions {
        let spring = matches!(model.supports[reaction.support].kind, SupportKind::Spring { .. });
        reaction.moment = if spring { 0.0 } else { 1e-9 };
    }
    let why = prove(&model, &answer).expect_err("a moment at a pin");
    assert!(why.what.contains("a pin has a moment"), "{why}");
}

/// Pieces that are omitted, repeated, reordered or changed, and other loads: the proof refuses the answer, or E covers the
/// error.
#[test]
fn changed_documents_are_not_proven() {
    let all = attacks();
    let right = all.iter().find(|attack| attack.name == "right-layer").expect("right-layer");
    let Verdict::Proven(answer, proof) = verdict(right) else { panic!("right-layer is proven") };
    let good = proof.energy / proof.strain_energy;
    let model = read_model::<Wide>(&right.model, None).expect("a model");
    type Change = (&'static str, fn(&mut Answer));
    let changes: [Change; 9] = [
        ("no pieces", |answer| answer.pieces.clear()),
        ("a piece left out", |answer| drop(answer.pieces.remove(1))),
        ("a piece twice", |answer| answer.pieces.insert(1, answer.pieces[1].clone())),
        ("pieces swapped", |answer| answer.pieces.swap(0, 1)),
        ("a NaN", |answer| answer.pieces[1].deflection[0] = f64::NAN),
        ("an infinite end", |answer| answer.pieces[2].x[1] = f64::INFINITY),
        ("1e308", |answer| answer.pieces[1].deflection[2] = 1e308),
        ("many coefficients", |answer| answer.pieces[1].deflection.resize(40, 0.0)),
        ("many pieces", |answer| {
            let piece = answer.pieces[0].clone();
            answer.pieces.resize(200_000, piece);
        }),
    ];
    for (what, change) in changes {
        let mut changed = answer.clone();
        change(&mut changed);
        assert!(prove(&model, &changed).is_err(), "{what}");
    }
    for (old, new) in
        [("moment = 0.4", "moment = -0.4"), ("point = 1", "point = 1.001"), ("mu = 1", "mu = 2")]
    {
        let other = right.model.replace(old, new);
        assert_ne!(other, right.model, "{old}");
        let other = read_model::<Wide>(&other, None).expect("a model");
        let shown = prove(&other, &answer).map_or(f64::INFINITY, |p| p.energy / p.strain_energy);
        assert!(shown > 1e-10 && shown > 1e20 * good, "{new}: {shown:e}");
    }
}
