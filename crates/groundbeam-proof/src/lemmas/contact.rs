//! Tests the proof that the slope of the clearance between beam and ground does not decrease from left to right at a node.

#![cfg(test)]

use crate::contact_set::Contact;
use crate::given_claim::with_fields;
use crate::pointwise::PieceBounds;
use serde_json::json;

/// Returns `Contact::bends_open` for the node at x = 1. `gap` contains the initial gap at x = 0, 1 and 2, and `added`
/// further tables of the model file.
fn bends_open(shears: bool, gap: [f64; 3], added: &str) -> bool {
    let stiffness = if shears { "shear_stiffness = 1\n" } else { "" };
    let corner = |(at, value): (usize, &f64)| format!("[[gap]]\nat = {at}\nvalue = {value}\n");
    let corners: String = gap.iter().enumerate().map(corner).collect();
    let model = format!(
        "[foundation]\nk = 1\nmu = 1\n[beam]\nlength = 2\nEI = 1\n{stiffness}{corners}{added}"
    );
    let piece = |from: f64| {
        let mut piece =
            json!({"x": [from, from + 1.0], "half": 0.5, "touches": true, "deflection": [9]});
        if shears {
            piece["rotation"] = json!([0]);
        }
        piece
    };
    let document = json!({"pieces": [piece(0.0), piece(1.0)]});
    with_fields(&model, &document, |fields| {
        let bounds = [PieceBounds::EXACT; 2];
        Contact { fields, bounds: &bounds }.bends_open(1)
    })
}

/// Checks the jump of the slope of the clearance at a node: [g₀′], plus F/(S + P) under a downward force F if the beam
/// has shear deformation. The reaction F of a support has an unknown sign.
#[test]
fn the_clearance_bends_open_at_upward_corners_and_under_loads() {
    let down = "[[load]]\npoint = 1e-9\nat = 1\n";
    let up = "[[load]]\npoint = -1e-9\nat = 1\n";
    let pin = "[[support]]\nat = 1\ntype = 'pinned'\n";
    let spring = "[[support]]\nat = 1\nspring = 1\n";
    for added in ["", down, up, pin, spring] {
        assert!(bends_open(false, [0.0; 3], added), "{added}");
    }
    for (added, expected) in [("", true), (down, true), (up, false), (pin, false), (spring, false)]
    {
        assert_eq!(bends_open(true, [0.0; 3], added), expected, "{added}");
    }
    let (pin_and_load, spring_and_load) = (pin.to_owned() + down, spring.to_owned() + down);
    assert!(!bends_open(true, [0.0; 3], &pin_and_load));
    assert!(!bends_open(true, [0.0; 3], &spring_and_load));
    for shears in [false, true] {
        for (gap, expected) in [
            ([1.0, 0.0, 1.0], true),
            ([0.0, 1.0, 3.0], true),
            ([3.0, 1.0, 0.0], true),
            ([0.0, 1.0, 0.0], false),
            ([0.0, 2.0, 3.0], false),
            ([3.0, 2.0, 0.0], false),
        ] {
            assert_eq!(bends_open(shears, gap, ""), expected, "{gap:?}");
        }
    }
}

/// Checks that nothing is proven at hinges, forces on the ground, and jumps of μ or of the shear stiffness. The slope
/// jumps there by an unknown amount.
#[test]
fn the_clearance_may_bend_shut_at_hinges_and_steps() {
    let ground = "[[foundation.segment]]\nfrom = 0\nto = 1\nk = 1\nmu = ";
    let beam = "[[beam.segment]]\nfrom = 0\nto = 1\nshear_stiffness = 2\n";
    for added in [
        "[[hinge]]\nat = 1\n",
        "[[ground_load]]\npoint = 1\nat = 1\n",
        &format!("{ground}2\n"),
        &format!("{ground}0\n"),
    ] {
        for gap in [[0.0; 3], [1.0, 0.0, 1.0]] {
            assert!(!bends_open(false, gap, added) && !bends_open(true, gap, added), "{added}");
        }
    }
    assert!(!bends_open(true, [0.0; 3], beam));
}
