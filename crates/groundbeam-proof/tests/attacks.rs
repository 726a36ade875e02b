//! Documents that claim wrong answers: none is proven, and every bound that is given holds.

use groundbeam_proof::{Answer, NotProven, Proof, Wide, prove, read_model};
use serde_json::Value;

/// One document with the truth, from `cases/attacks.json`.
struct Attack {
    name: String,
    model: String,
    claimed: String,
    truth: Value,
    expected: String,
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
        expected: word(&attack["expected"]),
    };
    all.iter().map(one).collect()
}

/// What comes of a document: unreadable, not proven, or proven.
enum Verdict {
    Unreadable,
    NotProven(NotProven),
    Proven(Answer, Proof),
}

fn verdict(attack: &Attack) -> Verdict {
    let Ok(answer) = Answer::from_json(&attack.claimed) else { return Verdict::Unreadable };
    let Ok(model) = read_model::<Wide>(&attack.model, None) else { return Verdict::Unreadable };
    match prove(&model, &answer) {
        Err(why) => Verdict::NotProven(why),
        Ok(proof) => Verdict::Proven(answer, proof),
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

/// The largest of error over bound for deflection, slope and moment at the stations.
fn worst(attack: &Attack, answer: &Answer, proof: &Proof) -> f64 {
    let model = read_model::<f64>(&attack.model, None).expect("a model");
    let number = |value: &Value| value.as_str().and_then(|x| x.parse().ok()).unwrap_or(f64::NAN);
    let mut worst: f64 = 0.0;
    for station in attack.truth["stations"].as_array().expect("stations") {
        let [w, slope, bent] = fields(answer, number(&station["x"]));
        let moment = -model.beam.bending_stiffness * bent;
        for (claimed, name, bound) in [
            (w, "deflection", proof.bounds.deflection),
            (slope, "slope", proof.bounds.slope),
            (moment, "moment", proof.bounds.moment),
        ] {
            let truth = number(&station[name]);
            // The claimed values here are rounded themselves.
            let error = (claimed - truth).abs() - 1e-13 * truth.abs();
            assert!(error.is_finite(), "{}: {name}", attack.name);
            worst = worst.max(error / bound);
        }
    }
    worst
}

/// Where a contact set is shown it is the exact one, with every edge and end force in its interval.
fn contact_is_true(attack: &Attack, proof: &Proof) {
    let Ok(contact) = &proof.contact else { return };
    let number = |value: &Value| value.as_str().and_then(|x| x.parse().ok()).unwrap_or(f64::NAN);
    let list = |name: &str| attack.truth[name].as_array().cloned().unwrap_or_default();
    let mut exact: Vec<[f64; 2]> =
        list("contact").iter().map(|region| [number(&region[0]), number(&region[1])]).collect();
    exact.extend(list("points").iter().map(|at| [number(at); 2]));
    exact.sort_by(|a, b| a[0].total_cmp(&b[0]));
    assert_eq!(contact.regions.len(), exact.len(), "{}: {contact:?}", attack.name);
    // The truth has 20 digits, of which a double keeps 16.
    let holds = |[low, high]: [f64; 2], x: f64| {
        let rounding = 4.0 * f64::EPSILON * x.abs();
        low - rounding <= x && x <= high + rounding
    };
    for (region, [from, to]) in contact.regions.iter().zip(&exact) {
        assert!(holds(region.from, *from) && holds(region.to, *to), "{}: {region:?}", attack.name);
    }
    let length = read_model::<f64>(&attack.model, None).expect("a model").beam.length;
    for (key, x) in [("left", 0.0), ("right", length)] {
        let wanted = number(&attack.truth["end_forces"][key]);
        let found = contact.forces.iter().find(|force| force.x == x);
        let held = found.map_or([0.0; 2], |force| force.force);
        assert!(wanted.is_nan() || holds(held, wanted), "{}: {held:?} {wanted}", attack.name);
    }
}

#[test]
fn no_attack_is_proven_and_all_bounds_hold() {
    let mut proven = Vec::new();
    for attack in attacks() {
        match verdict(&attack) {
            Verdict::Unreadable => {
                println!("{:30} cannot be read", attack.name);
                assert!(!attack.name.starts_with("right"), "{}", attack.name);
            }
            Verdict::NotProven(why) => {
                println!("{:30} {why}", attack.name);
                assert!(!attack.name.starts_with("right"), "{}: {why}", attack.name);
            }
            Verdict::Proven(answer, proof) => {
                let ratio = worst(&attack, &answer, &proof);
                let relative = proof.energy / proof.strain_energy;
                println!(
                    "{:30} E {relative:.1e} error over bound {ratio:.2} {:?}",
                    attack.name, proof.bounds
                );
                println!("{:30} {:?}", "", proof.contact);
                assert!(ratio <= 1.0, "{}: {ratio}", attack.name);
                contact_is_true(&attack, &proof);
                let right = attack.name.starts_with("right");
                assert!(!right || proof.contact.is_ok(), "{}: {:?}", attack.name, proof.contact);
                // Of a `refused` document the contact may be shown only if E shows the error.
                let shown = attack.expected == "refused" && proof.contact.is_ok();
                assert!(!shown || relative > 1e-20, "{} is shown", attack.name);
                proven.push((attack.name, attack.expected, relative));
            }
        }
    }
    for (name, expected, relative) in &proven {
        let small = *relative < 1e-20;
        assert!(!small || expected != "refused", "{name} is proven");
    }
}

/// Pieces left out, twice, in another order or with other numbers, and loads that act otherwise: refused, or E shows it.
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
