//! Tests beams that touch the ground of a shear layer at one point, in closed form: a ridge pushes with R.
//!
//! k = μ = 1 and endless ground, so the layer settles by u = ½R exp(−|x − 1|) under the ridge at x = 1. The beam carries its
//! load at the ridge. It is straight, w = ½Rx on a pin at 0, or it bends, w = ½R(3x² − x³)/2 from a clamp at 0.

use crate::one_document;
use groundbeam_proof::{Model, NotProven, Verification, Wide, read_model, verify};
use serde_json::{Value, json};

const RIDGE: &str = "[beam]\nlength = 2\nEI = 1\n[foundation]\nk = 1\nmu = 1\n\
    [[gap]]\nat = 0\nvalue = 3\n[[gap]]\nat = 1\nvalue = 0\n[[gap]]\nat = 2\nvalue = 3\n";

/// The model in which the ridge pushes with R; for R < 0 the beam hovers above it.
fn model(support: &str, force: f64) -> Model<Wide> {
    // The deflection ½R of a clamped beam needs the load 1.5R beside that of the ground.
    let load = if support == "fixed" { 2.5 } else { 1.0 } * force;
    let text = format!(
        "{RIDGE}[[load]]\npoint = {load}\nat = 1\n[[support]]\nat = 0\ntype = '{support}'\n"
    );
    read_model(&text, None).expect("a model")
}

/// The answer in which the ridge pushes with R.
fn document(support: &str, force: f64) -> Value {
    let [left, right, reaction] = match support {
        "fixed" => [vec![0.3125, 0.5625, 0.1875, -0.0625], vec![1.75, 0.75], vec![1.5, -1.5]],
        _ => [vec![0.5, 0.5], vec![1.5, 0.5], vec![0.0, 0.0]],
    };
    let times = |numbers: Vec<f64>, factor: f64| -> Vec<f64> {
        numbers.into_iter().map(|number| factor * number).collect()
    };
    let [top, foot] = [0.5 * force, 0.5 * force * f64::exp(-1.0)];
    let piece = |from: f64, w: Vec<f64>, open: [f64; 2]| {
        let (x, w) = ([from, from + 1.0], times(w, 0.5 * force));
        json!({"x": x, "half": 0.5, "touches": false, "deflection": w, "open": open})
    };
    let reaction = times(reaction, force);
    json!({
        "pieces": [piece(0.0, left, [foot, top]), piece(1.0, right, [top, foot])],
        "forces": [{"x": 1, "force": force}],
        "reactions": [{"support": 0, "force": reaction[0], "moment": reaction[1]}],
        "contact": [{"from": 1, "to": 1}],
    })
}

fn verified(model: &Model<Wide>, document: &Value) -> Result<Verification, NotProven> {
    verify(model, &one_document::document(&document.to_string()))
}

#[test]
fn contact_at_a_point_is_proven() {
    for support in ["pinned", "fixed"] {
        for force in [2.0, 1e-3] {
            let found =
                verified(&model(support, force), &document(support, force)).expect("bounds");
            assert_eq!(found.shortfall, None, "{support} {force}");
            let set = found.proof.contact.expect("a contact set");
            let [region] = &set.regions[..] else { panic!("{support}: {set:?}") };
            assert!(region.from == region.to && region.from[0] <= 1.0 && 1.0 <= region.from[1]);
            assert!(region.from[1] - region.from[0] < 1e-12, "{support}: {region:?}");
        }
    }
}

/// The answer for R = 2 is claimed for other models. A proven force contains the exact one. A beam that hovers has none.
#[test]
fn a_wrong_force_at_a_point_is_not_proven() {
    let mut shown = 0;
    for support in ["pinned", "fixed"] {
        for force in [2.000_001, 1.999, 1.9, 1.5, 1.0, 0.1, 1e-3, -1e-3, -1.0] {
            let Ok(found) = verified(&model(support, force), &document(support, 2.0)) else {
                continue;
            };
            let what = format!("{support} {force}");
            assert!(found.shortfall.is_some(), "{what}");
            // The deflection of the right end. A pinned beam that hovers has no equilibrium.
            let tip = match (support, force > 0.0) {
                ("fixed", true) => 1.25 * force,
                ("fixed", false) => 2.5 * 5.0 / 6.0 * force,
                (_, true) => force,
                (_, false) => f64::INFINITY,
            };
            let error = (tip - if support == "fixed" { 2.5 } else { 2.0 }).abs();
            let bound = found.proof.bounds.deflection.error;
            assert!(bound >= error * (1.0 - 1e-9), "{what}: {bound} {error}");
            let Ok(set) = found.proof.contact else { continue };
            shown += 1;
            let [held] = &set.forces[..] else { panic!("{what}: {set:?}") };
            assert!(
                force > 0.0 && held.force[0] <= force && force <= held.force[1],
                "{what}: {held:?}"
            );
        }
    }
    assert!(shown >= 3, "{shown}");
}

/// The force is multiplied by 1 + λ, so that it balances the load of a pinned beam: |λ| must be less than ½.
#[test]
fn a_point_must_keep_half_of_its_claimed_force() {
    for (force, kept) in [(0.9, false), (1.1, true), (2.9, true), (3.1, false)] {
        let found = verified(&model("pinned", force), &document("pinned", 2.0));
        assert_eq!(found.is_ok(), kept, "{force}");
    }
}
