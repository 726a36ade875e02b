//! Tests beams in partial contact with a shear layer, in closed form, with and without shear deformation and tension.
//!
//! k = μ = 1, ground endless on the right and ending free at the left end of the beam. The beam is straight, w = 2 − x. It
//! touches up to x = 1, where its slope is that of the open ground, u = exp(1 − x): w ≤ u beyond. So p = 2 − x up to the
//! edge, the layer pushes with 1 under the left end, and M = V = 0. The loads are p, 1 + P at the left end and −P at the
//! right end.

use crate::one_document;
use groundbeam_proof::{Model, Verification, Wide, read_model, verify};
use serde_json::{Value, json};

/// Shear stiffness, if the beam has shear deformation, and the tension.
const BEAMS: [(Option<f64>, f64); 5] =
    [(None, 0.0), (None, 0.25), (Some(0.5), 0.0), (Some(64.0), 0.0), (Some(2.0), 0.25)];

fn model((stiffness, tension): (Option<f64>, f64)) -> Model<Wide> {
    let shear = stiffness.map_or_else(String::new, |s| format!("shear_stiffness = {s}\n"));
    let text = format!(
        "[beam]\nlength = 2\nEI = 0.5\n{shear}axial_force = {tension}\n[foundation]\nk = 1\nmu = 1\n\
         left = {{ ends = 0, as = 'free' }}\n[[load]]\ndistributed = [2, 1]\nfrom = 0\nto = 1\n\
         [[load]]\npoint = {}\nat = 0\n[[load]]\npoint = {}\nat = 2\n",
        1.0 + tension,
        -tension,
    );
    read_model(&text, None).expect("a model")
}

/// The coefficients in t of 2 − x + ε(x² − x³/3) on a piece, and of its derivative.
fn coefficients([from, to]: [f64; 2], epsilon: f64) -> [Vec<f64>; 2] {
    let (m, h) = (0.5 * (from + to), 0.5 * (to - from));
    let w = [
        2.0 - m + epsilon * (m * m - m.powi(3) / 3.0),
        h * (-1.0 + epsilon * (2.0 * m - m * m)),
        h * h * epsilon * (1.0 - m),
        -h.powi(3) * epsilon / 3.0,
    ];
    let slope = [w[1] / h, 2.0 * w[2] / h, 3.0 * w[3] / h];
    [w.to_vec(), slope.to_vec()]
}

/// The answer w = 2 − x + ε(x² − x³/3) with contact up to an edge.
fn document((stiffness, _): (Option<f64>, f64), edge: f64, epsilon: f64) -> Value {
    let piece = |ends: [f64; 2], touches: bool| {
        let [deflection, rotation] = coefficients(ends, epsilon);
        let half = 0.5 * (ends[1] - ends[0]);
        let mut piece =
            json!({"x": ends, "half": half, "touches": touches, "deflection": deflection});
        if stiffness.is_some() {
            piece["rotation"] = json!(rotation);
        }
        piece
    };
    let at_edge = 2.0 - edge + epsilon * (edge * edge - edge.powi(3) / 3.0);
    let open = |ends: [f64; 2]| {
        let mut open = piece(ends, false);
        open["open"] = json!(ends.map(|x| at_edge * (edge - x).exp()));
        open
    };
    // The load ends at 1, so a piece ends there too.
    let pieces = match edge {
        1.0 => vec![piece([0.0, 1.0], true), open([1.0, 2.0])],
        _ if edge < 1.0 => vec![piece([0.0, edge], true), open([edge, 1.0]), open([1.0, 2.0])],
        _ => vec![piece([0.0, 1.0], true), piece([1.0, edge], true), open([edge, 2.0])],
    };
    json!({
        "pieces": pieces,
        "forces": [{"x": 0, "force": 1}, {"x": edge, "force": 0}],
        "reactions": [],
        "contact": [{"from": 0, "to": edge}],
    })
}

fn verified(beam: (Option<f64>, f64), document: &Value) -> Verification {
    let document = one_document::document(&document.to_string());
    verify(&model(beam), &document).unwrap_or_else(|why| panic!("{beam:?}: {why}"))
}

/// The proven contact set is the exact one: from 0 to 1, with the force 1 at 0 and no force at 1.
fn is_exact_contact(what: &str, found: &Verification) {
    let set = found.proof.contact.as_ref().expect("a contact set");
    let holds = |[low, high]: [f64; 2], x: f64| low <= x && x <= high;
    let [region] = &set.regions[..] else { panic!("{what}: {set:?}") };
    assert!(region.from == [0.0; 2] && holds(region.to, 1.0), "{what}: {region:?}");
    for force in &set.forces {
        let exact = if force.x == 0.0 { 1.0 } else { 0.0 };
        assert!(holds(force.force, exact), "{what}: {force:?}");
    }
}

#[test]
fn a_straight_beam_in_partial_contact_is_proven() {
    for beam in BEAMS {
        let found = verified(beam, &document(beam, 1.0, 0.0));
        assert_eq!(found.shortfall, None, "{beam:?}");
        is_exact_contact(&format!("{beam:?}"), &found);
        let to = found.proof.contact.expect("a contact set").regions[0].to;
        assert!(to[1] - to[0] < 1e-9, "{beam:?}: {to:?}");
        // ½∫ku² + ½∫μu′² = ½·(7/3 + 1) in contact, and ½u² at the edge for the open ground; ½Pw′² per length.
        let strain = 13.0 / 6.0 + beam.1;
        assert!((found.proof.strain_energy / strain - 1.0).abs() < 1e-12, "{beam:?}");
    }
}

/// The edge of the claim is moved. The claimed beam is right, the pressure and the settlement beside the edge are not.
#[test]
fn a_moved_edge_is_not_proven_and_the_bound_covers_the_settlement() {
    for beam in BEAMS {
        for shift in (3..=12).flat_map(|n| [1.0, -1.0].map(|sign| sign * 0.1_f64.powi(n))) {
            let edge = 1.0 + shift;
            let found = verified(beam, &document(beam, edge, 0.0));
            let what = format!("{beam:?} {shift:e}");
            assert!(found.shortfall.is_some() && found.proof.contact.is_err(), "{what}");
            assert_eq!([found.edges.error, found.forces.error], [f64::INFINITY; 2], "{what}");
            let surface = |edge: f64, x: f64| match x <= edge {
                true => 2.0 - x,
                false => (2.0 - edge) * (edge - x).exp(),
            };
            for x in [0.5 * (1.0 + edge), 1.0, edge, 1.5, 2.0] {
                let error = (surface(edge, x) - surface(1.0, x)).abs();
                let bound = found.proof.bounds.settlement.error;
                assert!(error <= bound + 1e-15, "{what}: {error:e} {bound:e}");
            }
        }
    }
}

/// All errors of w = 2 − x + ε(x² − x³/3) are known: εx²(1 − x/3) ≤ 4ε/3, ε(2x − x²) ≤ ε, 2εEI(1 − x) ≤ ε, 2εEI = ε. The
/// pressure is w − w″ in contact, so its error is at most 2ε, at x = 0.
#[test]
fn the_bounds_of_a_bent_claim_cover_its_errors() {
    for beam in BEAMS {
        for epsilon in [1e-7, -1e-7] {
            let found = verified(beam, &document(beam, 1.0, epsilon));
            let what = format!("{beam:?} {epsilon:e}");
            assert!(found.shortfall.is_some(), "{what}");
            is_exact_contact(&what, &found);
            let (bounds, unit) = (&found.proof.bounds, epsilon.abs());
            for (name, bound, error) in [
                ("deflection", bounds.deflection.error, 4.0 / 3.0 * unit),
                ("slope", bounds.slope.error, unit),
                ("rotation", bounds.rotation.error, unit),
                ("moment", bounds.moment.error, unit),
                ("shear force", bounds.shear_force.error, unit),
                ("settlement", bounds.settlement.error, 2.0 / 3.0 * unit),
                ("pressure", bounds.pressure.error, 2.0 * unit),
            ] {
                let ratio = bound / error;
                assert!((1.0 - 1e-6..3000.0).contains(&ratio), "{what}: {name} {ratio}");
            }
        }
    }
}

/// A force that is not listed counts as zero: the force under the left end is 1.
#[test]
fn the_bound_of_an_unlisted_force_is_the_exact_force() {
    let mut document = document(BEAMS[0], 1.0, 0.0);
    document["forces"] = json!([{"x": 1, "force": 0}]);
    let found = verified(BEAMS[0], &document);
    assert!(found.shortfall.is_some() && (found.listed.unlisted - 1.0).abs() < 1e-9);
    assert_eq!(found.forces.error, found.listed.unlisted);
}

/// A beam at rest, w = 1, over endless ground with a corner at x = 1: g₀ = ½c|x − 1|, u = 1 − g₀. The layer pushes with c at
/// the corner, and with u − u′ = 1 − c under both ends. The loads are the contact forces. For c < 0 it would have to pull.
#[test]
fn contact_at_a_corner_of_the_ground_is_proven_only_if_the_ground_pushes() {
    for corner in [0.25, 1e-3, 1e-6, -1e-6, -1e-3] {
        let gap = |at: u32, value: f64| format!("[[gap]]\nat = {at}\nvalue = {value}\n");
        let point = |at: u32, size: f64| format!("[[load]]\npoint = {size}\nat = {at}\n");
        let along = |from: u32, ends: [f64; 2]| {
            format!("[[load]]\ndistributed = {ends:?}\nfrom = {from}\nto = {}\n", from + 1)
        };
        let low = 1.0 - 0.5 * corner;
        let text = [
            "[beam]\nlength = 2\nEI = 1\n[foundation]\nk = 1\nmu = 1\n".to_owned(),
            gap(0, 0.5 * corner) + &gap(1, 0.0) + &gap(2, 0.5 * corner),
            along(0, [low, 1.0]) + &along(1, [1.0, low]),
            point(0, 1.0 - corner) + &point(1, corner) + &point(2, 1.0 - corner),
        ];
        let model = read_model::<Wide>(&text.concat(), None).expect("a model");
        let piece = |from: f64| json!({"x": [from, from + 1.0], "half": 0.5, "touches": true, "deflection": [1]});
        let ends = json!({"left": 1.0 - corner, "right": 1.0 - corner});
        let document = json!({
            "pieces": [piece(0.0), piece(1.0)],
            "contact": [{"from": 0, "to": 2}],
            "end_forces": ends,
            "forces": [{"x": 1, "force": corner}],
        });
        let document = one_document::document(&document.to_string());
        let found = verify(&model, &document).expect("bounds");
        if corner > 0.0 {
            assert_eq!(found.shortfall, None, "{corner}");
            assert!(found.forces.error < 1e-9 && found.edges.error < 1e-9, "{corner}");
        } else {
            let why = found.proof.contact.expect_err("a pulling force");
            assert!(why.what.contains("may be tensile") && why.at == Some(1.0), "{corner}: {why}");
        }
    }
}

/// A beam that is clamped at x = 1 at the height of level Winkler ground. The left part, s = 1 − x, carries 3 at its end above
/// a gap, w = 3s²/2 − s³/2. The right part is not loaded and rests: w = 0 in contact without pressure. The smallest action
/// or step there makes the claim undecided.
#[test]
fn an_unloaded_part_beside_a_clamp_is_in_contact() {
    let contact = |added: &str| {
        let text = format!(
            "[beam]\nlength = 2\nEI = 1\n[foundation]\nk = 1\n[[load]]\npoint = 3\nat = 0\n\
             [[support]]\nat = 1\ntype = 'fixed'\n[[gap]]\nat = 0\nvalue = 100\n[[gap]]\nat = 1\nvalue = 0\n{added}"
        );
        let model = read_model::<Wide>(&text, None).expect("a model");
        let piece = |from: f64| json!({"x": [from, from + 0.5], "half": 0.25, "touches": true, "deflection": [0]});
        let bent = [0.3125, -0.5625, 0.1875, 0.0625];
        let open = json!({"x": [0, 1], "half": 0.5, "touches": false, "deflection": bent});
        let mut reactions = vec![json!({"force": 3, "moment": 3})];
        reactions.resize(model.supports.len(), json!({"force": 0}));
        let document = json!({
            "pieces": [open, piece(1.0), piece(1.5)],
            "reactions": reactions,
            "contact": [{"from": 1, "to": 2}],
        });
        let document = one_document::document(&document.to_string());
        let found = verify(&model, &document).unwrap_or_else(|why| panic!("{added}: {why}"));
        found.proof.contact.is_ok()
    };
    assert!(contact(""));
    for added in [
        "[[load]]\npoint = -1e-9\nat = 2\n",
        "[[load]]\npoint = -1e-9\nat = 1.5\n",
        "[[load]]\nmoment = 1e-9\nat = 2\n",
        "[[load]]\nmoment = 1e-9\nat = 1.5\n",
        "[[load]]\ndistributed = -1e-9\nfrom = 1\nto = 2\n",
        "[[load]]\ncurvature = 1e-9\nfrom = 1\nto = 2\n",
        "[[gap]]\nat = 2\nvalue = 1e-9\n",
        "[[support]]\nat = 2\nspring = 1\n",
        "[[support]]\nat = 1.5\nspring = 1\n",
    ] {
        assert!(!contact(added), "{added}");
    }
}
