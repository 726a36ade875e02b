//! Tests documents with one wrong number in an otherwise right answer in closed form: none is proven.

use crate::one_document;
use groundbeam_proof::Verification;

/// A clamp at 0, a hinge at 1 and a pin at 2 over a gap that the beam does not close: w = 6x² − 2x³, then linear. A weak
/// spring at the hinge carries κw(1) = 4κ, κ = 2⁻²⁰.
const OVER_A_GAP: &str = r#"
[beam]
length = 2
EI = 1
[foundation]
k = 1
mu = 1
[[load]]
point = 12.000003814697265625
at = 1
[[support]]
at = 0
type = "fixed"
[[support]]
at = 1
spring = 9.5367431640625e-7
[[support]]
at = 2
type = "pinned"
[[hinge]]
at = 1
[[gap]]
at = 0
value = 100
"#;

const HINGED: &str = r#"{
    "pieces": [
        {"x": [0, 1], "half": 0.5, "touches": false, "deflection": [1.25, 2.25, 0.75, -0.25]},
        {"x": [1, 2], "half": 0.5, "touches": false, "deflection": [2, -2]}
    ],
    "forces": [],
    "reactions": [
        {"support": 0, "force": 12, "moment": -12},
        {"support": 1, "force": 3.814697265625e-6, "moment": 0},
        {"support": 2, "force": 0, "moment": 0}
    ],
    "contact": [],
    "hinges": [{"at": 1, "rotation": -10, "moment": 0}]
}"#;

/// A stiff beam at rest on ground with constant k and μ: w = 1, p = 1.
const AT_REST: &str = r#"
[beam]
length = 2
EI = 1
[foundation]
k = 1
mu = 1
[foundation.left]
ends = 0
as = "free"
[foundation.right]
ends = 2
as = "free"
[[load]]
distributed = 1
"#;

const RESTING: &str = r#"{
    "pieces": [
        {"x": [0, 1], "half": 0.5, "touches": true, "deflection": [1], "pressure": [1]},
        {"x": [1, 2], "half": 0.5, "touches": true, "deflection": [1], "pressure": [1]}
    ],
    "forces": [{"x": 0, "force": 0}, {"x": 2, "force": 0}],
    "contact": [{"from": 0, "to": 2}]
}"#;

fn verified(model: &str, document: &str) -> Verification {
    one_document::verified(model, document).expect("bounds")
}

/// Whether a document is called proven.
fn is_proven(model: &str, document: &str) -> bool {
    let found = one_document::verified(model, document);
    match &found {
        Ok(found) => println!("{:?}", found.shortfall),
        Err(why) => println!("{why}"),
    }
    found.is_ok_and(|found| found.shortfall.is_none())
}

/// Replaces a part that occurs once in a document.
fn with(document: &str, old: &str, new: &str) -> String {
    assert_eq!(document.matches(old).count(), 1, "{old}");
    document.replace(old, new)
}

#[test]
fn correct_documents_are_proven() {
    assert!(is_proven(OVER_A_GAP, HINGED));
    assert!(is_proven(AT_REST, RESTING));
}

#[test]
fn a_wrong_hinge_is_not_proven() {
    for (old, new) in
        [("\"rotation\": -10", "\"rotation\": -9"), ("-10, \"moment\": 0", "-10, \"moment\": 0.5")]
    {
        assert!(!is_proven(OVER_A_GAP, &with(HINGED, old, new)), "{new}");
    }
}

#[test]
fn a_force_that_is_listed_twice_is_not_proven() {
    let twice = with(
        HINGED,
        "\"forces\": []",
        "\"forces\": [{\"x\": 0, \"force\": 0}, {\"x\": 0, \"force\": 0}]",
    );
    assert!(!is_proven(OVER_A_GAP, &twice));
}

/// The right part of the deflection is shifted by ε, and with it the reaction κ(w − δ) of the spring at the hinge.
#[test]
fn the_bound_of_a_spring_reaction_at_a_hinge_covers_the_error_of_its_part() {
    let (stiffness, shift) = (2.0_f64.powi(-20), 2.0_f64.powi(-30));
    let shifted = with(HINGED, "[2, -2]", &format!("[{}, -2]", 2.0 + shift));
    let reaction = stiffness * (4.0 + shift);
    let shifted = with(&shifted, "3.814697265625e-6", &format!("{reaction:e}"));
    let found = verified(OVER_A_GAP, &shifted);
    let (bound, error) = (found.proof.reactions[1].force.error, stiffness * shift);
    assert!(bound >= error, "{bound:e} {error:e}");
}

#[test]
fn lift_off_claimed_on_a_stretch_in_contact_is_not_proven() {
    let lifted = r#""contact": [{"from": 0, "to": 2}],
        "lift_off": [{"from": 0, "to": 2, "largest_gap": {"x": 1, "value": 0}}]"#;
    let document = with(RESTING, r#""contact": [{"from": 0, "to": 2}]"#, lifted);
    assert!(!is_proven(AT_REST, &document));
}

#[test]
fn lift_off_without_its_largest_gap_is_not_covered() {
    let contact = r#""contact": [{"from": 0, "to": 2}]"#;
    let lifted = format!(r#"{contact}, "lift_off": [{{"from": 0.5, "to": 0.75}}]"#);
    let found = verified(AT_REST, &with(RESTING, contact, &lifted));
    let named: Vec<&str> = found.not_covered.iter().map(String::as_str).collect();
    assert_eq!(named, ["lift_off.from", "lift_off.to"]);
}

#[test]
fn an_unused_settlement_is_not_proven() {
    let open = "\"touches\": false, \"deflection\": [2, -2]";
    let stored = format!("{open}, \"settlement\": [5]");
    assert!(!is_proven(OVER_A_GAP, &with(HINGED, open, &stored)));
    let stored = r#"{"x": [1, 2], "half": 0.5, "touches": true, "settlement": [7],"#;
    let document = with(RESTING, r#"{"x": [1, 2], "half": 0.5, "touches": true,"#, stored);
    assert!(!is_proven(AT_REST, &document));
}

#[test]
fn a_pressure_or_settlement_of_the_wrong_kind_of_piece_is_not_proven() {
    let open = "\"touches\": false, \"deflection\": [2, -2]";
    for more in ["\"pressure\": [5]", "\"open\": [3, 0]"] {
        assert!(!is_proven(OVER_A_GAP, &with(HINGED, open, &format!("{open}, {more}"))), "{more}");
    }
    let first = r#"{"x": [0, 1], "half": 0.5, "touches": true, "#;
    let document = with(RESTING, first, &format!("{first}\"open\": [0, 0], "));
    assert!(!is_proven(AT_REST, &document));
}

/// |p − p*| has a bound where both are in contact. Here the answer claims that the beam is open on a part of its contact.
#[test]
fn the_pressure_of_a_layer_has_no_bound_without_a_contact_set() {
    let second =
        r#"{"x": [1, 2], "half": 0.5, "touches": true, "deflection": [1], "pressure": [1]}"#;
    let open = r#"{"x": [1, 1.015625], "half": 0.0078125, "touches": false, "deflection": [1], "open": [1, 1]},
        {"x": [1.015625, 2], "half": 0.4921875, "touches": true, "deflection": [1], "pressure": [1]}"#;
    let found = verified(AT_REST, &with(RESTING, second, open));
    assert!(found.proof.contact.is_err() && found.proof.bounds.deflection.error.is_finite());
    // p* = 1, and the answer has p = 0 on the open piece.
    assert_eq!(found.proof.bounds.pressure.error, f64::INFINITY);
}

/// On Winkler ground the pressure p = kw has the error bound kε with the bound ε of the deflection, even if the contact
/// set is not proven. If a part of the ground has a shear layer, the pressure has no bound.
#[test]
fn the_pressure_of_springs_has_a_bound_without_a_contact_set() {
    let springs = "[beam]\nlength = 2\nEI = 1\n[foundation]\nk = 1\n[[load]]\ndistributed = 1\n";
    let mixed = format!(
        "{springs}[[foundation.segment]]\nfrom = 0\nto = 1\nk = 1\nmu = 1\n[foundation.left]\nends = 0\nas = 'free'\n"
    );
    let document = r#"{"pieces": [
        {"x": [0, 1], "half": 0.5, "touches": true, "deflection": [1]},
        {"x": [1, 1.015625], "half": 0.0078125, "touches": false, "deflection": [1]},
        {"x": [1.015625, 2], "half": 0.4921875, "touches": true, "deflection": [1]}
    ]}"#;
    for (model, bounded) in [(springs, true), (&mixed, false)] {
        let found = verified(model, document);
        assert!(found.proof.contact.is_err(), "{model}");
        assert_eq!(found.proof.bounds.pressure.error.is_finite(), bounded, "{model}");
        // p* = 1, and the answer has p = 0 on the open piece.
        assert!(found.proof.bounds.pressure.error >= 1.0, "{model}");
        assert_eq!(found.error_at("pressure", 1.5).is_finite(), bounded, "{model}");
    }
}
