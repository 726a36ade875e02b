//! Tests supports in closed form: one-way supports without a reaction, and hinges at supports that restrain the slope.

use crate::one_document::{document, verified};
use groundbeam_proof::{
    Acts, Log, Scalar, Support, SupportKind, Wide, read_model, verify, verify_and_log,
};
use serde_json::{Value, json};

/// A beam above a gap of 100 on pins at 0 and 2.
const BEAM: &str = "[foundation]\nk = 1\n[[gap]]\nat = 0\nvalue = 100\n[beam]\nlength = 2\nEI = 1\n\
                    [[support]]\nat = 0\ntype = 'pinned'\n[[support]]\nat = 2\ntype = 'pinned'\n";

/// A symmetric deflection with these coefficients of t on the left half, and the forces of both pins.
fn symmetric(left: [f64; 4], force: f64) -> Value {
    let [a, b, c, d] = left;
    let piece = |from: u32, w: [f64; 4]| json!({"x": [from, from + 1], "half": 0.5, "touches": false, "deflection": w});
    json!({
        "pieces": [piece(0, left), piece(1, [a, -b, c, -d])],
        "reactions": [{"force": force}, {"force": force}],
        "contact": [],
    })
}

/// Under the force 6 at the middle w = 3x/2 − x³/2 on the left half. A one-way support at ½, where w = 11/16, has no reaction and
/// no node of its own.
#[test]
fn a_support_without_a_reaction_must_be_clear_of_the_beam() {
    let document = symmetric([0.6875, 0.5625, -0.1875, -0.0625], 3.0).to_string();
    for (acts, sign) in [("up", 1.0), ("down", -1.0)] {
        for (clearance, is_clear) in [(1e-3, true), (1e-9, true), (0.0, false), (-1e-3, false)] {
            let model = format!(
                "{BEAM}[[load]]\npoint = 6\nat = 1\n\
                 [[support]]\nat = 0.5\ntype = 'pinned'\nacts = '{acts}'\nsettlement = {:?}\n",
                0.6875 + sign * clearance
            );
            let what = format!("{acts} {clearance}");
            match verified(&model, &document) {
                Ok(found) => assert!(is_clear && found.shortfall.is_none(), "{what}"),
                Err(why) => assert!(!is_clear && why.what.contains("too close"), "{what}: {why}"),
            }
        }
    }
}

#[test]
fn the_listed_state_of_a_one_way_support_is_proven() {
    let model = format!(
        "{BEAM}[[load]]\npoint = 6\nat = 1\n\
         [[support]]\nat = 0.5\nspring = 1\nacts = 'up'\nsettlement = 0.6885\n"
    );
    for (state, force, proven) in [
        ("lifted", 0.0, true),
        ("slack", 0.0, false),
        ("acting", 0.0, false),
        ("acting", 1e-30, false),
        ("lifted", 1e-30, false),
    ] {
        let mut document = symmetric([0.6875, 0.5625, -0.1875, -0.0625], 3.0);
        let reaction = json!({"force": force, "state": state});
        document["reactions"].as_array_mut().expect("reactions").push(reaction);
        let is_proven =
            verified(&model, &document.to_string()).is_ok_and(|found| found.shortfall.is_none());
        assert_eq!(is_proven, proven, "{state} {force}");
    }
}

/// Under end moments 2 and with a hinge k_φ = 4 at the middle, w = 9x/4 − x² on the left half. The slope has two values at the
/// hinge, so only a pin may stand there.
#[test]
fn a_hinge_at_a_support_that_restrains_the_slope_is_refused() {
    let loads = "[[load]]\nmoment = 2\nat = 0\n[[load]]\nmoment = -2\nat = 2\n\
                 [[hinge]]\nat = 1\nrotational_spring = 4\n";
    let document = document(&symmetric([0.875, 0.625, -0.25, 0.0], 0.0).to_string());
    let turning = SupportKind::Spring { spring: Wide::zero(), rotational_spring: Wide::one() };
    for (kind, restrains) in
        [(SupportKind::Fixed, true), (turning, true), (SupportKind::Pinned, false)]
    {
        let mut model = read_model::<Wide>(&(BEAM.to_owned() + loads), None).expect("a model");
        let (at, settlement) = (Wide::one(), Wide::of(1.25));
        model.supports.push(Support { at, kind, settlement, acts: Acts::Both });
        match verify(&model, &document) {
            Ok(found) => assert!(!restrains && found.shortfall.is_none(), "{kind:?}"),
            Err(why) => assert!(restrains && why.what.contains("restrains the slope"), "{why}"),
        }
    }
}

/// The log names the directions of each support: 0 for both, 1 for up, −1 for down.
#[test]
fn the_log_has_the_directions_of_the_supports() {
    let model = format!(
        "{BEAM}[[load]]\npoint = 6\nat = 1\n\
         [[support]]\nat = 0.5\ntype = 'pinned'\nacts = 'up'\nsettlement = 1\n\
         [[support]]\nat = 0.5\ntype = 'pinned'\nacts = 'down'\nsettlement = 0.5\n"
    );
    let model = model.replacen("at = 0.5", "at = 1.5", 1);
    let model = read_model::<Wide>(&model, None).expect("a model");
    let document = document(&symmetric([0.6875, 0.5625, -0.1875, -0.0625], 3.0).to_string());
    let mut log = Log::new();
    verify_and_log(&model, &document, Some(&mut log)).expect("bounds");
    let lines = log.text().lines().map(|line| serde_json::from_str::<Value>(line).expect("JSON"));
    let acts: Vec<Value> =
        lines.filter(|line| line["name"] == "support").map(|line| line["acts"].clone()).collect();
    assert_eq!(json!(acts), json!([0, 0, 1, -1]));
}
