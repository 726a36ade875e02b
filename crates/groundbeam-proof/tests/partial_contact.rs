//! Tests beams in partial contact with a shear layer, in closed form, with and without shear deformation and tension.
//!
//! k = μ = 1, ground endless on the right and ending free at the left end of the beam. The beam is straight, w = 2 − x. It
//! touches up to x = 1, where its slope is that of the open ground, u = exp(1 − x): w ≤ u beyond. So p = 2 − x up to the
//! edge, the layer pushes with 1 under the left end, and M = V = 0. The loads are p, 1 + P at the left end and −P at the
//! right end.

use crate::one_document;
use groundbeam_proof::{Log, Model, Verification, Wide, read_model, verify, verify_and_log};
use serde_json::{Value, json};

/// A beam and its ground.
#[derive(Debug, Clone, Copy)]
struct Beam {
    /// Shear stiffness, if the beam has shear deformation.
    stiffness: Option<&'static str>,
    tension: f64,
    /// μ at x = 0. It falls to 1 at x = 1, so that p = 2 − x + μ′ and the force under the left end is μ(0).
    layer: f64,
}

const fn beam(stiffness: Option<&'static str>, tension: f64, layer: f64) -> Beam {
    Beam { stiffness, tension, layer }
}

impl Beam {
    /// Whether S or μ varies on a beam with shear deformation. The bounds are larger there.
    fn varies(self) -> bool {
        self.stiffness.is_some_and(|s| s.starts_with('[') || self.layer != 1.0)
    }
}

const BEAMS: [Beam; 9] = [
    beam(None, 0.0, 1.0),
    beam(None, 0.25, 1.0),
    beam(None, 0.0, 1.5),
    beam(Some("0.5"), 0.0, 1.0),
    beam(Some("64"), 0.0, 1.0),
    beam(Some("2"), 0.25, 1.0),
    beam(Some("[1, 4]"), 0.0, 1.0),
    beam(Some("[4, 1]"), 0.25, 1.0),
    beam(Some("2"), 0.25, 1.5),
];

fn model(Beam { stiffness, tension, layer }: Beam) -> Model<Wide> {
    let shear = stiffness.map_or_else(String::new, |s| format!("shear_stiffness = {s}\n"));
    let varying = match layer {
        1.0 => String::new(),
        _ => format!("[[foundation.segment]]\nfrom = 0\nto = 1\nk = 1\nmu = [{layer:?}, 1]\n"),
    };
    let text = format!(
        "[beam]\nlength = 2\nEI = 0.5\n{shear}axial_force = {tension}\n[foundation]\nk = 1\nmu = 1\n\
         left = {{ ends = 0, as = 'free' }}\n{varying}[[load]]\ndistributed = [{}, {}]\nfrom = 0\nto = 1\n\
         [[load]]\npoint = {}\nat = 0\n[[load]]\npoint = {}\nat = 2\n",
        3.0 - layer,
        2.0 - layer,
        layer + tension,
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
fn document(Beam { stiffness, layer, .. }: Beam, edge: f64, epsilon: f64) -> Value {
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
        "forces": [{"x": 0, "force": layer}, {"x": edge, "force": 0}],
        "reactions": [],
        "contact": [{"from": 0, "to": edge}],
    })
}

fn verified(beam: Beam, document: &Value) -> Verification {
    let document = one_document::document(&document.to_string());
    verify(&model(beam), &document).unwrap_or_else(|why| panic!("{beam:?}: {why}"))
}

/// The proven contact set is the exact one: from 0 to 1, with the force μ(0) at 0 and no force at 1.
fn is_exact_contact(beam: Beam, what: &str, found: &Verification) {
    let set = found.proof.contact.as_ref().expect("a contact set");
    let holds = |[low, high]: [f64; 2], x: f64| low <= x && x <= high;
    let [region] = &set.regions[..] else { panic!("{what}: {set:?}") };
    assert!(region.from == [0.0; 2] && holds(region.to, 1.0), "{what}: {region:?}");
    for force in &set.forces {
        let exact = if force.x == 0.0 { beam.layer } else { 0.0 };
        assert!(holds(force.force, exact), "{what}: {force:?}");
    }
}

#[test]
fn a_straight_beam_in_partial_contact_is_proven() {
    for beam in BEAMS {
        let found = verified(beam, &document(beam, 1.0, 0.0));
        assert_eq!(found.shortfall, None, "{beam:?}");
        is_exact_contact(beam, &format!("{beam:?}"), &found);
        let to = found.proof.contact.expect("a contact set").regions[0].to;
        assert!(to[1] - to[0] < if beam.varies() { 1e-7 } else { 1e-9 }, "{beam:?}: {to:?}");
        // ½∫ku² = 7/6 and ½∫μu′² in contact, and ½u² at the edge for the open ground; ½Pw′² per length.
        let strain = 5.0 / 3.0 + 0.25 * (beam.layer + 1.0) + beam.tension;
        assert!((found.proof.strain_energy / strain - 1.0).abs() < 1e-12, "{beam:?}");
    }
}

/// The edge of the claim is moved. The claimed beam is right, the pressure and the settlement beside the edge are not.
#[test]
fn a_moved_edge_is_not_proven_and_the_bound_covers_the_settlement() {
    for beam in BEAMS.into_iter().filter(|beam| beam.layer == 1.0) {
        for shift in (3..=12).flat_map(|n| [1.0, -1.0].map(|sign| sign * 0.1_f64.powi(n))) {
            let edge = 1.0 + shift;
            let found = verified(beam, &document(beam, edge, 0.0));
            let what = format!("{beam:?} {shift:e}");
            assert!(found.shortfall.is_some() && found.proof.contact.is_err(), "{what}");
            assert_eq!([found.edges.error, found.forces.error], [f64::INFINITY; 2], "{what}");
            assert_eq!(found.error_of("pressure"), f64::INFINITY, "{what}");
            assert_eq!(found.without_bound(), found.proof.contact.as_ref().err(), "{what}");
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
/// pressure is w − (μw′)′ in contact, so its error is at most 2εμ(0), at x = 0.
#[test]
fn the_bounds_of_a_bent_claim_cover_its_errors() {
    for beam in BEAMS {
        for epsilon in [1e-7, -1e-7] {
            let found = verified(beam, &document(beam, 1.0, epsilon));
            let what = format!("{beam:?} {epsilon:e}");
            assert!(found.shortfall.is_some(), "{what}");
            is_exact_contact(beam, &what, &found);
            let (bounds, unit) = (&found.proof.bounds, epsilon.abs());
            for (name, bound, error) in [
                ("deflection", bounds.deflection.error, 4.0 / 3.0 * unit),
                ("slope", bounds.slope.error, unit),
                ("rotation", bounds.rotation.error, unit),
                ("moment", bounds.moment.error, unit),
                ("shear force", bounds.shear_force.error, unit),
                ("settlement", bounds.settlement.error, 2.0 / 3.0 * unit),
                ("pressure", bounds.pressure.error, 2.0 * beam.layer * unit),
            ] {
                let ratio = bound / error;
                let most = if beam.varies() { 1e5 } else { 3000.0 };
                assert!((1.0 - 1e-6..most).contains(&ratio), "{what}: {name} {ratio}");
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

/// A beam at rest, w = 1, over endless ground with a corner at x = 1, of the mean slope s: g₀ = s(x − 1) + ½c|x − 1|, u = 1 −
/// g₀. The layer pushes with c at the corner, and with u ∓ u′ = 1 ± 2s − c under the ends. The loads are the contact forces.
struct AtRest {
    beam: &'static str,
    slope: f64,
    corner: f64,
    /// A force at x = 1 beside that of the corner.
    force: f64,
    /// Supports, and the force of each.
    supports: &'static str,
    reactions: &'static [f64],
    /// The claim is w = 1 + ε(x − 1)².
    epsilon: f64,
}

const STIFF: &str = "";
const SHEARING: &str = "shear_stiffness = 2\n";
const AT_REST: AtRest = AtRest {
    beam: STIFF,
    slope: 0.0,
    corner: 0.0,
    force: 0.0,
    supports: "",
    reactions: &[],
    epsilon: 0.0,
};

impl AtRest {
    fn verified(&self) -> Verification {
        let AtRest { beam, slope, corner, force, supports, reactions, epsilon } = self;
        let gap = |at: u32, value: f64| format!("[[gap]]\nat = {at}\nvalue = {value}\n");
        let point = |at: u32, size: f64| format!("[[load]]\npoint = {size}\nat = {at}\n");
        let along = |from: u32, ends: [f64; 2]| {
            format!("[[load]]\ndistributed = {ends:?}\nfrom = {from}\nto = {}\n", from + 1)
        };
        let heights = [0.5 * corner - slope, 0.5 * corner + slope];
        let ends = [1.0, -1.0].map(|sign| 1.0 + 2.0 * sign * slope - corner);
        let text = [
            format!("[beam]\nlength = 2\nEI = 1\n{beam}[foundation]\nk = 1\nmu = 1\n{supports}"),
            gap(0, heights[0]) + &gap(1, 0.0) + &gap(2, heights[1]),
            along(0, [1.0 - heights[0], 1.0]) + &along(1, [1.0, 1.0 - heights[1]]),
            point(0, ends[0]) + &point(2, ends[1]),
            if corner + force == 0.0 { String::new() } else { point(1, corner + force) },
        ];
        let model = read_model::<Wide>(&text.concat(), None).expect("a model");
        let piece = |from: f64, sign: f64| {
            let bent = epsilon * 0.25;
            let mut piece = json!({
                "x": [from, from + 1.0], "half": 0.5, "touches": true,
                "deflection": [1.0 + bent, sign * 2.0 * bent, bent],
            });
            if *beam == SHEARING {
                piece["rotation"] = json!([sign * epsilon, epsilon]);
            }
            piece
        };
        let reactions: Vec<Value> = reactions.iter().map(|force| json!({"force": force})).collect();
        let document = json!({
            "pieces": [piece(0.0, -1.0), piece(1.0, 1.0)],
            "contact": [{"from": 0, "to": 2}],
            "end_forces": {"left": ends[0], "right": ends[1]},
            "forces": [{"x": 1, "force": corner}],
            "reactions": reactions,
        });
        verify(&model, &one_document::document(&document.to_string())).expect("bounds")
    }

    /// Whether the contact is proven from 0 to 2; if not, the node at x = 1 is the reason.
    fn is_proven(&self, what: &str) -> bool {
        match self.verified().proof.contact {
            Ok(set) => {
                let [region] = &set.regions[..] else { panic!("{what}: {set:?}") };
                assert!(region.to[0] <= 2.0 && 2.0 <= region.to[1], "{what}: {set:?}");
                true
            }
            Err(why) => {
                let is_reason = why.what.contains("not proven to be compressive");
                assert!(is_reason && why.at == Some(1.0), "{what}: {why}");
                false
            }
        }
    }
}

/// For c < 0 the layer would have to pull at the corner.
#[test]
fn contact_at_a_corner_of_the_ground_is_proven_only_if_the_ground_pushes() {
    for (slope, beam) in [(0.0, STIFF), (0.125, STIFF), (-0.125, STIFF), (0.125, SHEARING)] {
        for corner in [0.25, 1e-3, 1e-6, -1e-6, -1e-3] {
            let what = format!("{slope} {beam} {corner}");
            let at_rest = AtRest { beam, slope, corner, ..AT_REST };
            assert_eq!(at_rest.is_proven(&what), corner > 0.0, "{what}");
            if corner > 0.0 {
                let found = at_rest.verified();
                assert_eq!(found.shortfall, None, "{what}");
                assert!(found.forces.error < 1e-9 && found.edges.error < 1e-9, "{what}");
            }
            // The error of the claim exceeds the force of the corner.
            if corner.abs() < 0.01 {
                let bent = AtRest { epsilon: 0.1 * corner.abs(), ..at_rest };
                assert_eq!(bent.is_proven(&what), corner > 0.0, "{what}");
            }
        }
    }
}

/// A force or a support at x = 1 that pushes the beam up lifts a beam with shear deformation off the ground there, [C*′] =
/// F/(S + P). A support that carries nothing may push up. A beam without shear deformation has no kink and stays in contact.
#[test]
fn contact_under_a_kink_is_proven_only_if_a_load_bends_the_beam_down() {
    let pin = "[[support]]\nat = 1\ntype = 'pinned'\nsettlement = 1\n";
    let spring = "[[support]]\nat = 1\nspring = 1\nsettlement = 1\n";
    let pushing = "[[support]]\nat = 1\nspring = 1\nsettlement = 0.999999\n";
    for (what, at_rest, shearing) in [
        ("no force", AT_REST, true),
        ("a load", AtRest { force: 1e-6, ..AT_REST }, true),
        ("an upward force", AtRest { force: -1e-6, ..AT_REST }, false),
        ("an idle pin", AtRest { supports: pin, reactions: &[0.0], ..AT_REST }, false),
        ("a pushing pin", AtRest { supports: pin, reactions: &[1e-6], ..AT_REST }, false),
        ("an idle spring", AtRest { supports: spring, reactions: &[0.0], ..AT_REST }, false),
        ("a pushing spring", AtRest { supports: pushing, reactions: &[1e-6], ..AT_REST }, false),
    ] {
        assert!(at_rest.is_proven(what), "{what}");
        let at_rest = AtRest { beam: SHEARING, ..at_rest };
        assert_eq!(at_rest.is_proven(what), shearing, "{what}");
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

/// At the edge the pressure jumps from 1 to 0. A listed pressure between both is right, on the left and on the right of the
/// jump. Other fields are compared there as elsewhere.
#[test]
fn listed_numbers_at_an_edge_are_compared() {
    for key in ["stations", "left_of_jumps"] {
        for (listed, off) in [(0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (-0.5, 0.5), (1.5, 0.5)] {
            let mut document = document(BEAMS[0], 1.0, 0.0);
            document[key] = json!({"x": [1], "pressure": [listed]});
            let found = verified(BEAMS[0], &document);
            assert_eq!((found.checked.at_edges, found.checked.values), (1, 0));
            assert!((found.error_of("pressure") - off).abs() < 1e-12, "{key} {listed}");
            assert_eq!(found.shortfall.is_some(), off > 0.0, "{key} {listed}");
        }
        let mut document = document(BEAMS[0], 1.0, 0.0);
        document[key] = json!({"x": [1], "deflection": [1.25]});
        let found = verified(BEAMS[0], &document);
        assert_eq!((found.checked.at_edges, found.checked.values), (0, 1));
        assert!((found.error_of("deflection") - 0.25).abs() < 1e-9, "{key}");
    }
}

/// The same beam in other units, 2ᵐ of length and 2ⁿ of force: every error has the same digits.
#[test]
fn documents_in_other_units_have_the_same_errors() {
    let errors = |[length, force]: [i32; 2], stations: bool| {
        let by = |x: f64, f: i32, l: i32| x * 2.0_f64.powi(f * force + l * length);
        let text = format!(
            "[beam]\nlength = {}\nEI = {}\n[foundation]\nk = {}\nmu = {}\nleft = {{ ends = 0, as = 'free' }}\n\
             [[load]]\ndistributed = [{}, {}]\nfrom = 0\nto = {}\n[[load]]\npoint = {}\nat = 0\n\
             [[ground_load]]\ndistributed = {}\nfrom = {}\nto = {}\n",
            by(2.0, 0, 1),
            by(0.5, 1, 2),
            by(1.0, 1, -2),
            by(1.0, 1, 0),
            by(2.0, 1, -1),
            by(1.0, 1, -1),
            by(1.0, 0, 1),
            by(1.0, 1, 0),
            by(1e-7, 1, -1),
            by(2.5, 0, 1),
            by(3.0, 0, 1),
        );
        let mut document = document(BEAMS[0], 1.0, 1e-7);
        let times = |value: &Value, f: i32, l: i32| match value {
            Value::Array(all) => {
                all.iter().map(|x| by(x.as_f64().expect("a number"), f, l)).collect()
            }
            one => json!(by(one.as_f64().expect("a number"), f, l)),
        };
        for piece in document["pieces"].as_array_mut().expect("pieces") {
            piece["pressure"] =
                if piece["touches"] == true { json!([1.5, -0.5]) } else { json!([1e-9, 0, 1e-8]) };
            for (key, f, l) in [
                ("x", 0, 1),
                ("half", 0, 1),
                ("deflection", 0, 1),
                ("open", 0, 1),
                ("pressure", 1, -1),
            ] {
                if !piece[key].is_null() {
                    piece[key] = times(&piece[key], f, l);
                }
            }
        }
        for (list, keys) in [
            ("forces", [("x", 0, 1), ("force", 1, 0)]),
            ("contact", [("from", 0, 1), ("to", 0, 1)]),
        ] {
            for one in document[list].as_array_mut().expect("a list") {
                for (key, f, l) in keys {
                    one[key] = times(&one[key], f, l);
                }
            }
        }
        let place = by(1.0, 0, 1);
        // Without stations the error of the pressure is that of the pressures stored with the pieces.
        let place = if stations { place } else { by(0.75, 0, 1) };
        document["stations"] = json!({
            "x": [by(0.25, 0, 1), place],
            "moment": [by(1e-9, 1, 1), by(2e-9, 1, 1)],
        });
        if stations {
            document["stations"]["pressure"] = json!([by(1.7, 1, -1), by(-0.25, 1, -1)]);
        }
        document["extremes"] = json!({
            "deflection": {
                "max": {"x": by(0.5, 0, 1), "value": by(1.5, 0, 1)},
                "min": {"x": by(1.5, 0, 1), "value": by(0.25, 0, 1)},
            },
            "moment": {"max": {"x": by(0.5, 0, 1), "value": by(1e-8, 1, 1)}},
            "gap": {"max": {"x": by(2.0, 0, 1), "value": by(0.25, 0, 1)}},
        });
        let document = one_document::document(&document.to_string());
        let model = read_model::<Wide>(&text, None).expect("a model");
        let found = verify(&model, &document).expect("bounds");
        let unit = |name: &str| match name {
            "deflection" | "settlement" | "gap" | "edges" => (0, 1),
            "moment" | "reaction_moments" | "hinge_moments" => (1, 1),
            "shear_force" | "forces" | "reactions" | "end_forces" => (1, 0),
            "pressure" => (1, -1),
            _ => (0, 0),
        };
        let back = |x: f64, (f, l): (i32, i32)| by(x, -f, -l);
        let mut all: Vec<f64> = Vec::new();
        for (name, errors) in found.errors() {
            all.extend(errors.iter().map(|x| back(*x, unit(name))));
        }
        for (name, bound) in found.named() {
            all.push(back(bound.scale, unit(name)));
        }
        for placed in &found.extremes {
            all.push(back(placed.error(), (0, 1)));
            all.extend(placed.places.iter().flatten().map(|x| back(*x, (0, 1))));
        }
        all.extend(found.without_pressure.iter().flatten().map(|x| back(*x, (0, 1))));
        all
    };
    for stations in [true, false] {
        let one = errors([0, 0], stations);
        assert!(one.iter().filter(|x| x.is_finite()).count() > 30, "{one:?}");
        for units in [[10, 0], [0, 40], [-9, 31]] {
            assert_eq!(errors(units, stations), one, "{units:?}");
        }
    }
}

/// The mirrored beam, w = x, lies on the ground from 1 on. The left end of its region is the edge. Its force is listed at a
/// position that is a rounding error off the end.
#[test]
fn a_region_at_the_right_end_is_compared_at_its_edge() {
    let text = "[beam]\nlength = 2\nEI = 0.5\n[foundation]\nk = 1\nmu = 1\nright = { ends = 2, as = 'free' }\n\
        [[load]]\ndistributed = [1, 2]\nfrom = 1\nto = 2\n[[load]]\npoint = 1\nat = 2\n";
    let model = read_model::<Wide>(text, None).expect("a model");
    for key in ["stations", "left_of_jumps"] {
        for (listed, off) in [(0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (-0.5, 0.5), (1.5, 0.5)] {
            let mut document = json!({
                "pieces": [
                    {"x": [0, 1], "half": 0.5, "touches": false, "deflection": [0.5, 0.5], "open": [f64::exp(-1.0), 1]},
                    {"x": [1, 2], "half": 0.5, "touches": true, "deflection": [1.5, 0.5]},
                ],
                "forces": [{"x": 2.000_000_000_000_004, "force": 1}],
                "contact": [{"from": 1, "to": 2}],
            });
            document[key] = json!({"x": [1], "pressure": [listed]});
            let document = one_document::document(&document.to_string());
            let found = verify(&model, &document).expect("bounds");
            assert!((found.error_of("pressure") - off).abs() < 1e-12, "{key} {listed}");
            assert!(found.forces.error < 1e-9, "{key} {listed}");
            assert_eq!(
                found.shortfall.is_some(),
                off > 0.0,
                "{key} {listed}: {:?}",
                found.shortfall
            );
        }
    }
}

/// Open ground over 40 decay lengths, u = exp(1 − x): listed settlements and gaps are right everywhere, and wrong ones are found.
/// The stored surface of the open piece may be a polynomial; its error counts.
#[test]
fn long_open_ground_is_compared_along_its_whole_length() {
    let text = "[beam]\nlength = 41\nEI = 0.5\n[foundation]\nk = 1\nmu = 1\nleft = { ends = 0, as = 'free' }\n\
        [[load]]\ndistributed = [2, 1]\nfrom = 0\nto = 1\n[[load]]\npoint = 1\nat = 0\n";
    let model = read_model::<Wide>(text, None).expect("a model");
    let u = |x: f64| if x <= 1.0 { 2.0 - x } else { f64::exp(1.0 - x) };
    let places = [0.0, 0.5, 1.25, 1.5, 3.0, 7.25, 12.0, 20.5, 21.0, 33.75, 40.0, 41.0];
    let base = json!({
        "pieces": [
            {"x": [0, 1], "half": 0.5, "touches": true, "deflection": [1.5, -0.5]},
            {"x": [1, 41], "half": 20, "touches": false, "deflection": [-19, -20], "open": [1, f64::exp(-40.0)]},
        ],
        "forces": [{"x": 0, "force": 1}],
        "contact": [{"from": 0, "to": 1}],
    });
    let verified = |document: &Value| {
        verify(&model, &one_document::document(&document.to_string())).expect("bounds")
    };
    let mut document = base.clone();
    document["stations"] = json!({
        "x": places,
        "settlement": places.map(u),
        "gap": places.map(|x| u(x) - (2.0 - x)),
    });
    document["extremes"] = json!({
        "settlement": {"max": {"x": 0, "value": 2}},
        "gap": {"max": {"x": 41, "value": 39.0 + f64::exp(-40.0)}, "min": {"x": 0.5, "value": 0}},
    });
    let found = verified(&document);
    assert_eq!(found.shortfall, None);
    assert!(found.error_of("settlement") < 1e-13 && found.error_of("gap") < 1e-12);
    for i in 0..places.len() {
        for field in ["settlement", "gap"] {
            let mut wrong = document.clone();
            wrong["stations"][field][i] =
                json!(document["stations"][field][i].as_f64().expect("a number") + 1e-3);
            let error = verified(&wrong).error_of(field);
            assert!((error - 1e-3).abs() < 1e-9, "{field} {i}: {error}");
        }
    }
    // The chord of u from 1 to 41 is wrong by nearly 0.9 at x = 5.
    let mut chord = base;
    chord["pieces"][1]["settlement"] = json!([0.5, -0.5]);
    let error = verified(&chord).error_of("settlement");
    assert!(error > 0.9 - f64::exp(-4.0), "{error}");
}

/// The lines of the log are JSON objects. They contain the problem, the claim and the bounds of the proof.
#[test]
fn the_log_has_the_numbers_of_the_proof() {
    for beam in BEAMS {
        let document = one_document::document(&document(beam, 1.0, 1e-7).to_string());
        let mut log = Log::new();
        let found = verify_and_log(&model(beam), &document, Some(&mut log)).expect("bounds");
        let lines: Vec<Value> =
            log.text().lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
        let named = |name: &str| -> Vec<&Value> {
            lines.iter().filter(|line| line["name"] == name).collect()
        };
        for (name, count) in [
            ("problem", 1),
            ("ground beside the beam", 2),
            ("node", 3),
            ("piece", 2),
            ("admissible at a node", 3),
            ("closing", 2),
            ("pull", 2),
            ("ground", 2),
            ("clearance", 1),
            ("energy", 1),
            ("bounds", 2),
            ("edge", 2),
            ("tolerance of a force", 3),
            ("contact set", 1),
            ("supports", 1),
            ("unique", 1),
        ] {
            assert_eq!(named(name).len(), count, "{beam:?}: {name}");
        }
        assert_eq!(named("round").is_empty(), beam.stiffness.is_none(), "{beam:?}");
        let exponents = &named("problem")[0]["units"];
        let unit = |force: i32, length: i32| {
            let exponent = |i: usize| exponents[i].as_i64().expect("an exponent") as i32;
            2.0_f64.powi(force * exponent(0) + length * exponent(1))
        };
        let most = |key: &str| {
            let all = named("bounds").into_iter().map(|line| line[key].as_f64().expect("a bound"));
            all.fold(0.0, f64::max)
        };
        let bounds = &found.proof.bounds;
        for (logged, proven, force, length) in [
            (named("energy")[0]["E"].as_f64().expect("E"), found.proof.energy, 1, 1),
            (most("w"), bounds.deflection.error, 0, 1),
            (most("slope"), bounds.slope.error, 0, 0),
            (most("rotation"), bounds.rotation.error, 0, 0),
            (most("M"), bounds.moment.error, 1, 1),
            (most("V"), bounds.shear_force.error, 1, 0),
            (most("u"), bounds.settlement.error, 0, 1),
        ] {
            let ratio = logged / (proven * unit(-force, -length));
            let other = logged / (proven * unit(force, length));
            assert!(
                (ratio - 1.0).abs() < 1e-9 || (other - 1.0).abs() < 1e-9,
                "{beam:?}: {ratio} {other}"
            );
        }
        let pieces = named("piece");
        assert!(pieces[0]["touches"] == true && pieces[1]["touches"] == false);
        assert_eq!(pieces[0]["phi"].is_null(), beam.stiffness.is_none());
        assert_eq!(pieces[0]["w"].as_array().expect("a field").len(), 4);
        assert_eq!(pieces[0]["k"].as_array().expect("a ball").len(), 3);
        assert_eq!(named("contact set")[0]["shown"], json!([true, true]));
        assert_eq!(named("unique")[0]["shown"], json!(true));
        assert_eq!(named("problem")[0]["P"].is_null(), beam.tension == 0.0);
        assert_eq!(named("node")[0]["acts"], json!(0));
    }
}
