//! Tests numbers that a document lists at ends, edges and jumps, and positions of extremes: wrong ones are refused.

use crate::one_document;
use groundbeam_proof::{
    Answer, Course, GroundEnd, NotProven, Scalar, Verification, Wide, prove, read_model,
};
use serde_json::{Value, json};

/// A beam at rest, w = 1, half on a shear layer and half on Winkler ground.
const AT_REST: &str = "[beam]\nlength = 2\nEI = 1\n[foundation]\nk = 1\nmu = 1\nleft = { ends = 0, as = 'free' }\n\
    [[foundation.segment]]\nfrom = 1\nto = 2\nk = 1\nmu = 0\n[[load]]\ndistributed = 1\n";

fn at_rest() -> Value {
    let piece = |from: f64| json!({"x": [from, from + 1.0], "half": 0.5, "touches": true, "deflection": [1], "pressure": [1]});
    json!({"pieces": [piece(0.0), piece(1.0)], "forces": [{"x": 0, "force": 0}], "contact": [{"from": 0, "to": 2}]})
}

/// A simple beam of length 4 under end moments above a gap, w = 4x − x², M = 2, V = 0.
const SIMPLE: &str = "[beam]\nlength = 4\nEI = 1\n[foundation]\nk = 1\n[[gap]]\nat = 0\nvalue = 100\n\
    [[load]]\nmoment = 2\nat = 0\n[[load]]\nmoment = -2\nat = 4\n\
    [[support]]\nat = 0\ntype = 'pinned'\n[[support]]\nat = 4\ntype = 'pinned'\n";

fn simple() -> Value {
    json!({
        "pieces": [{"x": [0, 4], "half": 2, "touches": false, "deflection": [4, 0, -4]}],
        "reactions": [{"force": 0}, {"force": 0}],
        "contact": [],
    })
}

/// A clamp at 0 and a pin at 2, joined by a hinge at 1 under the load 12: w = 6x² − 2x³, then 8 − 4x.
const HINGED: &str = "[beam]\nlength = 2\nEI = 1\n[foundation]\nk = 1\n[[gap]]\nat = 0\nvalue = 100\n\
    [[load]]\npoint = 12\nat = 1\n[[hinge]]\nat = 1\n\
    [[support]]\nat = 0\ntype = 'fixed'\n[[support]]\nat = 2\ntype = 'pinned'\n";

fn hinged() -> Value {
    json!({
        "pieces": [
            {"x": [0, 1], "half": 0.5, "touches": false, "deflection": [1.25, 2.25, 0.75, -0.25]},
            {"x": [1, 2], "half": 0.5, "touches": false, "deflection": [2, -2]},
        ],
        "reactions": [{"force": 12, "moment": -12}, {"force": 0}],
        "contact": [],
    })
}

fn verify(model: &str, document: &Value) -> Result<Verification, NotProven> {
    one_document::verified(model, &document.to_string())
}

fn verified(model: &str, document: &Value) -> Verification {
    verify(model, document).expect("bounds")
}

fn is_proven(model: &str, document: &Value) -> bool {
    verified(model, document).shortfall.is_none()
}

/// A document with one more key.
fn with(mut document: Value, key: &str, value: Value) -> Value {
    document[key] = value;
    document
}

/// A region that continues beyond the end of a layer is listed as one region. If no regions are listed, their widths are the
/// errors.
#[test]
fn a_region_across_the_end_of_a_layer_is_one_region() {
    let found = verified(AT_REST, &at_rest());
    assert_eq!(found.shortfall, None);
    // The layer begins at the free end 0 without a force there, so the contact may begin beside it.
    let holds = |([low, high], at): (&[f64; 2], f64)| *low < at && at < *high && high - low < 1e-12;
    assert!(!found.without_pressure.is_empty());
    assert!(found.without_pressure.iter().zip([0.0, 1.0, 1.0]).all(holds), "{found:?}");
    // Without the end of the layer under the beam the pressure has a bound except at the free ends.
    let segment = "[[foundation.segment]]\nfrom = 1\nto = 2\nk = 1\nmu = 0\n";
    let layer = AT_REST.replace(segment, "right = { ends = 2, as = 'free' }\n");
    assert!(is_proven(&layer, &at_rest()));
    let ends = verified(&layer, &at_rest()).without_pressure;
    assert!(ends.len() == 2 && ends.iter().zip([0.0, 2.0]).all(holds), "{ends:?}");
    assert_eq!((found.checked.forces, found.checked.regions), (1, 1));
    for regions in
        [json!([{"from": 0, "to": 1}]), json!([{"from": 0, "to": 1}, {"from": 1, "to": 2}])]
    {
        assert!(!is_proven(AT_REST, &with(at_rest(), "contact", regions)));
    }
    let mut unlisted = at_rest();
    unlisted.as_object_mut().expect("an object").remove("contact");
    let found = verified(AT_REST, &unlisted);
    assert!(found.shortfall.is_none() && found.edges.error < 1e-12, "{:?}", found.edges);
    let ends = json!({"left": 0, "right": 0});
    assert_eq!(verified(AT_REST, &with(at_rest(), "end_forces", ends)).checked.forces, 3);
}

#[test]
fn only_a_solved_document_is_proven() {
    assert!(is_proven(AT_REST, &with(at_rest(), "status", json!("solved"))));
    let why = verify(AT_REST, &with(at_rest(), "status", json!("no-equilibrium")))
        .expect_err("no bounds");
    assert!(why.what.contains("`no-equilibrium`"), "{why}");
}

#[test]
fn a_listed_position_lies_on_the_beam() {
    for (x, inside) in [
        (0.0, true),
        (-1e-15, true),
        (2.0, true),
        (2.000_000_000_000_004, true),
        (-1e-9, false),
        (2.000_000_001, false),
        (-1.0, false),
        (9.0, false),
    ] {
        let document = with(at_rest(), "stations", json!({"x": [x], "deflection": [1]}));
        assert_eq!(is_proven(AT_REST, &document), inside, "{x}");
    }
    let left = json!({"x": [0, 1, 2], "deflection": [1, 1, 1]});
    assert!(is_proven(AT_REST, &with(at_rest(), "left_of_jumps", left)));
    for at in [0.0, 0.5, 2.0] {
        let hinges = json!([{"at": at, "rotation": 0, "moment": 0}]);
        assert!(!is_proven(HINGED, &with(hinged(), "hinges", hinges)), "{at}");
    }
}

#[test]
fn two_forces_at_one_position_are_refused() {
    let both = |x: f64| json!([{"x": 0, "force": 0}, {"x": 1, "force": 0}, {"x": x, "force": 0}]);
    for (x, right) in [(1.0, false), (1.000_000_000_000_004, false), (2.0, true)] {
        assert_eq!(is_proven(AT_REST, &with(at_rest(), "forces", both(x))), right, "{x}");
    }
}

/// V = 0 exactly, so that a listed V must be zero but for rounding error, although its error is small against the loads. The
/// deflection must be right to 10⁻⁶ of its largest value, 4.
#[test]
fn a_listed_number_is_compared_with_its_own_field() {
    for (field, value, right) in [
        ("shear_force", 0.0, true),
        ("shear_force", 2e-12, true),
        ("shear_force", 1e-9, false),
        ("shear_force", -1e-9, false),
        ("deflection", 3.000_003, true),
        ("slope", 2.000_003, true),
        ("rotation", 2.000_003, true),
        ("moment", 2.000_001, true),
        ("gap", 97.000_003, true),
        ("deflection", 3.000_005, false),
    ] {
        let document = with(simple(), "stations", json!({"x": [1], field: [value]}));
        assert_eq!(is_proven(SIMPLE, &document), right, "{field} {value}");
    }
}

/// w is largest at x = 2. Its place must be right to 10⁻⁶ of the length.
#[test]
fn a_place_is_compared_with_the_length() {
    for (shift, right) in
        [(0.0, true), (3.6e-6, true), (-3.6e-6, true), (4.4e-6, false), (-4.4e-6, false)]
    {
        let extremes = json!({"deflection": {"max": {"x": 2.0 + shift, "value": 4}}});
        assert_eq!(is_proven(SIMPLE, &with(simple(), "extremes", extremes)), right, "{shift}");
    }
}

/// w is smallest at both supports. The largest value, 4, is not at x = 0.5.
#[test]
fn an_extreme_is_that_of_the_whole_beam() {
    let claims = |places: Value| {
        let document =
            with(hinged(), "extremes", json!({"deflection": {"min": {"x": 0, "value": 0}}}));
        let places = json!({"places": {"deflection": {"min": places}}});
        is_proven(HINGED, &with(document, "proof", places))
    };
    assert!(claims(json!([[0, 1e-3], [1.999, 2]])));
    assert!(!claims(json!([[0, 1e-3]])) && !claims(json!([[1.999, 2]])));
    let extremes = json!({"deflection": {"max": {"x": 0.5, "value": 1.25}}});
    let found = verified(HINGED, &with(hinged(), "extremes", extremes));
    let error = found.error_of("deflection");
    assert!(found.shortfall.is_some() && (2.75 - 1e-9..3.5).contains(&error), "{error}");
}

/// The claim w = 4x − x² + ε(x − x³/16) has a moment ⅜εx and a shear force ⅜ε that are wrong. The positions of the exact
/// extremes are 2 of w, the ends of w′, and the whole beam of M and V, on which they are constant.
#[test]
fn the_places_of_a_wrong_claim_contain_the_exact_ones() {
    for epsilon in [1e-2, -1e-2, 1e-5, -1e-5] {
        // In t = (x − 2)/2: x − x³/16 = 1.5 + 0.5t − 1.5t² − 0.5t³.
        let w = [4.0 + 1.5 * epsilon, 0.5 * epsilon, -4.0 - 1.5 * epsilon, -0.5 * epsilon];
        let ends = json!({"min": {"x": 1, "value": 0}, "max": {"x": 3, "value": 0}});
        let fields = ["deflection", "slope", "rotation", "moment", "shear_force", "gap"];
        let extremes: Value =
            fields.iter().map(|field| ((*field).to_owned(), ends.clone())).collect();
        let mut document = with(simple(), "extremes", extremes);
        document["pieces"][0]["deflection"] = json!(w);
        let found = verified(SIMPLE, &document);
        assert_eq!(found.extremes.len(), 12);
        for placed in &found.extremes {
            let all: &[f64] = match (placed.field.as_str(), placed.is_max) {
                ("deflection", true) | ("gap", false) => &[2.0],
                ("slope" | "rotation", true) => &[0.0],
                ("slope" | "rotation", false) => &[4.0],
                ("moment" | "shear_force", _) => &[0.0, 0.7, 1.9, 2.0, 3.1, 4.0],
                _ => &[0.0, 4.0],
            };
            for x in all {
                let held = placed.places.iter().any(|[low, high]| low <= x && x <= high);
                assert!(held, "{epsilon} {x}: {placed:?}");
            }
        }
    }
}

/// Pieces must cover the beam from end to end, without a gap and without a piece of length zero.
#[test]
fn pieces_cover_the_beam() {
    let model = read_model::<Wide>(AT_REST, None).expect("a model");
    let refused = |document: &Value| {
        let answer = Answer::from_json(&document.to_string()).expect("an answer");
        prove(&model, &answer).is_err()
    };
    assert!(!refused(&at_rest()));
    let mut apart = at_rest();
    apart["pieces"][1]["x"] = json!([1.001, 2]);
    assert!(refused(&apart));
    let piece = |x: [f64; 2]| json!({"x": x, "half": 0.5, "touches": true, "deflection": [1]});
    for ends in [[-1.0, 0.0], [2.0, 3.0]] {
        let mut longer = at_rest();
        let pieces = longer["pieces"].as_array_mut().expect("pieces");
        pieces.insert(if ends[0] < 0.0 { 0 } else { 2 }, piece(ends));
        assert!(refused(&longer), "{ends:?}");
    }
    let mut empty = at_rest();
    empty["pieces"].as_array_mut().expect("pieces").insert(1, piece([1.0, 1.0]));
    assert!(refused(&empty));
}

/// A node stands for a position of the model that is a rounding error away. Two positions that are so near are refused.
#[test]
fn a_node_stands_for_one_position() {
    let text = |length: f64, loads: &[f64]| {
        let load = |at: &f64| format!("[[load]]\npoint = 0\nat = {at}\n");
        let all: String = loads.iter().map(load).collect();
        format!(
            "[beam]\nlength = {length}\nEI = 1\n[foundation]\nk = 1\n[[load]]\ndistributed = 1\n{all}"
        )
    };
    let answer = |nodes: &[f64]| {
        let piece = |x: &[f64]| json!({"x": x, "half": 0.5 * (x[1] - x[0]), "touches": true, "deflection": [1]});
        let pieces: Vec<Value> = nodes.windows(2).map(piece).collect();
        Answer::from_json(&json!({"pieces": pieces}).to_string()).expect("an answer")
    };
    for length in [1.0, 3.0, 1024.0] {
        for (load, nodes, right) in [
            (vec![0.5], vec![0.0, 0.5, 1.0], true),
            (vec![0.5], vec![0.0, 0.5 + 12.0 * f64::EPSILON, 1.0], true),
            (vec![0.5], vec![0.0, 0.5 - 12.0 * f64::EPSILON, 1.0], true),
            (vec![0.5], vec![0.0, 0.5 + 40.0 * f64::EPSILON, 1.0], false),
            (vec![0.5], vec![0.0, 0.5 - 40.0 * f64::EPSILON, 1.0], false),
            (
                vec![0.5, 0.5 + 24.0 * f64::EPSILON],
                vec![0.0, 0.5, 0.5 + 24.0 * f64::EPSILON, 1.0],
                false,
            ),
            (
                vec![0.5, 0.5 + 64.0 * f64::EPSILON],
                vec![0.0, 0.5, 0.5 + 64.0 * f64::EPSILON, 1.0],
                true,
            ),
        ] {
            let [load, nodes] =
                [load, nodes].map(|all| all.iter().map(|x| length * x).collect::<Vec<f64>>());
            let model = read_model::<Wide>(&text(length, &load), None).expect("a model");
            let found = prove(&model, &answer(&nodes));
            assert_eq!(found.is_ok(), right, "{length} {load:?} {nodes:?}: {found:?}");
        }
    }
}

/// A surface that is held at the end of the beam would have an infinite stiffness there.
#[test]
fn ground_held_at_the_end_of_the_beam_is_refused() {
    let mut model = read_model::<Wide>(AT_REST, None).expect("a model");
    let answer = Answer::from_json(&at_rest().to_string()).expect("an answer");
    model.ground.ends[0] =
        GroundEnd::Held(model.supports.first().map_or(Scalar::of(0.0), |s| s.at));
    let why = prove(&model, &answer).expect_err("no bounds");
    assert!(why.what.contains("held at the end"), "{why}");
}

/// A beam at rest in two troughs of Winkler ground, w = 1, over a ridge of air from 1.0625 to 1.9375: two regions.
#[test]
fn two_regions_are_not_one() {
    let load = |from: f64, to: f64, ends: [f64; 2]| {
        format!("[[load]]\ndistributed = {ends:?}\nfrom = {from}\nto = {to}\n")
    };
    let gap = |at: f64, value: f64| format!("[[gap]]\nat = {at}\nvalue = {value}\n");
    let model = [
        "[beam]\nlength = 3\nEI = 1\n[foundation]\nk = 1\n".to_owned(),
        gap(1.0, 0.0) + &gap(1.5, 8.0) + &gap(2.0, 0.0),
        load(0.0, 1.0, [1.0; 2]) + &load(1.0, 1.0625, [1.0, 0.0]),
        load(1.9375, 2.0, [0.0, 1.0]) + &load(2.0, 3.0, [1.0; 2]),
    ];
    let nodes = [0.0, 1.0, 1.0625, 1.5, 1.9375, 2.0, 3.0];
    let piece = |i: usize| {
        let x = [nodes[i], nodes[i + 1]];
        json!({"x": x, "half": 0.5 * (x[1] - x[0]), "touches": i != 2 && i != 3, "deflection": [1]})
    };
    let pieces: Vec<Value> = (0..6).map(piece).collect();
    for (regions, right) in [
        (json!([{"from": 0, "to": 1.0625}, {"from": 1.9375, "to": 3}]), true),
        (json!([{"from": 0, "to": 3}]), false),
        (json!([{"from": 0, "to": 1.0625}]), false),
    ] {
        let document = json!({"pieces": pieces, "contact": regions});
        assert_eq!(is_proven(&model.concat(), &document), right, "{regions}");
    }
}

/// A cantilever under 3 at its end, w = 3x² − x³/2, above a one-way support at x that is claimed to be inactive. If the beam
/// clears it by `distance`, the claim is right; if it would penetrate it, no proof is possible.
fn beside_an_idle_support(
    at: f64,
    acts: &str,
    distance: f64,
    epsilon: f64,
) -> Result<Verification, NotProven> {
    let w = 3.0 * at * at - 0.5 * at * at * at;
    let settlement = if acts == "up" { w + distance } else { w - distance };
    let text = format!(
        "[beam]\nlength = 2\nEI = 1\n[foundation]\nk = 1\n[[gap]]\nat = 0\nvalue = 100\n[[load]]\npoint = 3\nat = 2\n\
         [[support]]\nat = 0\ntype = 'fixed'\n\
         [[support]]\nat = {at}\ntype = 'pinned'\nacts = '{acts}'\nsettlement = {settlement}\n"
    );
    // The claim is wrong by εx².
    let piece = |from: f64| {
        let (m, h) = (from + 0.5, 0.5);
        let second = 3.0 + epsilon;
        json!({"x": [from, from + 1.0], "half": h, "touches": false, "deflection": [
            second * m * m - 0.5 * m * m * m,
            h * (2.0 * second * m - 1.5 * m * m),
            h * h * (second - 1.5 * m),
            -0.5 * h * h * h,
        ]})
    };
    let document = json!({
        "pieces": [piece(0.0), piece(1.0)],
        "reactions": [{"force": 3, "moment": -6}, {"force": 0}],
        "contact": [],
    });
    verify(&text, &document)
}

#[test]
fn an_inactive_support_must_be_clear_of_the_beam() {
    for acts in ["up", "down"] {
        for at in [0.5, 1.0, 1.75, 2.0] {
            let right = beside_an_idle_support(at, acts, 1e-6, 0.0).expect("bounds");
            assert!(right.shortfall.is_none() && right.proof.supports.is_ok(), "{acts} {at}");
            for distance in [-1e-6, -1.0] {
                let found = beside_an_idle_support(at, acts, distance, 0.0);
                let proven = found
                    .is_ok_and(|found| found.shortfall.is_none() || found.proof.supports.is_ok());
                assert!(!proven, "{acts} {at} {distance}");
            }
            // The claim is wrong by 1e-6 x². Within this error the state of the support is not decided.
            for (distance, decided) in [(1e-7, false), (-1e-7, false), (0.1, true)] {
                let found = beside_an_idle_support(at, acts, distance, 1e-6);
                assert_eq!(
                    found.is_ok_and(|found| found.proof.supports.is_ok()),
                    decided,
                    "{acts} {at} {distance}"
                );
            }
        }
    }
}

/// The layer's surface as a document stores it along the pieces: in contact and on open ground its error counts.
#[test]
fn a_stored_settlement_is_compared_with_the_surface() {
    let stored = |first: Value, second: Value| {
        let mut document = at_rest();
        document["pieces"][0]["settlement"] = first;
        document["pieces"][1]["settlement"] = second;
        verified(AT_REST, &document)
    };
    assert_eq!(stored(json!([1]), json!([1])).shortfall, None);
    for (first, second) in [
        (json!([1.125]), json!([1])),
        (json!([1]), json!([0.875])),
        (json!([1, 0.125]), json!([1])),
    ] {
        let found = stored(first, second);
        let error = found.error_of("settlement");
        assert!(found.shortfall.is_some() && (0.125..0.126).contains(&error), "{error}");
    }
}

/// The same claims where the support carries R = 3d/x³: the end of the beam is wrong by R(x³/3 + x²(2 − x)/2). The bounds hold
/// although the support is claimed to be inactive.
#[test]
fn the_bounds_hold_if_an_inactive_support_is_active() {
    let mut bounded = 0;
    for (acts, at) in [("up", 0.5), ("up", 1.0), ("up", 2.0), ("down", 1.0), ("down", 2.0)] {
        for distance in [1e-6, 1e-3, 1.0] {
            let Ok(found) = beside_an_idle_support(at, acts, -distance, 0.0) else { continue };
            bounded += 1;
            let error = 3.0 * distance * (1.0 / 3.0 + (2.0 - at) / (2.0 * at));
            let bound = found.error_of("deflection");
            assert!(bound >= error * (1.0 - 1e-9), "{acts} {at} {distance}: {bound} {error}");
        }
    }
    assert!(bounded > 3, "{bounded}");
}

/// A load on Winkler ground with a varying k is not covered; a load on constant ground is, and so is varying ground alone.
#[test]
fn loads_on_varying_winkler_ground_are_refused() {
    for (varies, loaded, right) in
        [(false, false, true), (true, false, true), (false, true, true), (true, true, false)]
    {
        let load =
            if loaded { "[[ground_load]]\ndistributed = 1e-9\nfrom = 0\nto = 2\n" } else { "" };
        let text = format!(
            "[beam]\nlength = 2\nEI = 1\n[foundation]\nk = 1\n[[foundation.segment]]\nfrom = 0\nto = 2\nk = 1\nmu = 0\n\
             [[load]]\ndistributed = 1\n{load}"
        );
        let mut model = read_model::<Wide>(&text, None).expect("a model");
        if varies {
            let [one, more] = [1.0, 1.0 + 1e-9].map(Scalar::of);
            model.ground.segments[0].spring = Course::Varying(vec![one, more]);
        }
        let document =
            json!({"pieces": [{"x": [0, 2], "half": 1, "touches": true, "deflection": [1]}]});
        let answer = Answer::from_json(&document.to_string()).expect("an answer");
        let found = prove(&model, &answer);
        assert_eq!(found.is_ok(), right, "{varies} {loaded}: {found:?}");
    }
}

/// A beam that is bent upward between supports at the height of the ground: w = x² − 2x on pins, w = −x²(2 − x)² on clamps. It
/// touches the ground nowhere, and this is proven although w = 0 at both ends.
#[test]
fn a_beam_rises_from_supports_at_the_height_of_the_ground() {
    let pins = "[[load]]\nmoment = -2\nat = 0\n[[load]]\nmoment = 2\nat = 2\n";
    for (support, loads, w, [force, moment]) in [
        ("pinned", pins, json!([-1, 0, 1]), [0.0, 0.0]),
        ("fixed", "[[load]]\ndistributed = -24\n", json!([-1, 0, 2, 0, -1]), [-24.0, 8.0]),
    ] {
        for ground in ["k = 1", "k = 1\nmu = 1"] {
            let at = |x: u32| format!("[[support]]\nat = {x}\ntype = '{support}'\n");
            let model = [
                format!("[beam]\nlength = 2\nEI = 1\n[foundation]\n{ground}\n{loads}"),
                at(0) + &at(2),
            ];
            let document = json!({
                "pieces": [{"x": [0, 2], "half": 1, "touches": false, "deflection": w}],
                "reactions": [{"force": force, "moment": moment}, {"force": force, "moment": -moment}],
                "contact": [],
            });
            let found = verified(&model.concat(), &document);
            assert_eq!(found.shortfall, None, "{support} {ground}");
        }
    }
}
