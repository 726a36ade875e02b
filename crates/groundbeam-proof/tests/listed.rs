//! Tests the numbers that a document lists beside its pieces: exact numbers are proven, and the bound of a wrong number is
//! its error.

use crate::one_document;
use groundbeam_proof::Verification;
use serde_json::{Value, json};

/// Change of a listed number.
pub const CHANGE: f64 = 1e-3;

/// A right answer of `cases/attacks.json` that lists the exact fields: model, document and exact solution.
pub fn right(name: &str) -> (String, Value, Value) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/attacks.json");
    let text = std::fs::read_to_string(path).expect("cases/attacks.json");
    let all: Vec<Value> = serde_json::from_str(&text).expect("attacks");
    let one = all.into_iter().find(|attack| attack["name"] == name).expect("a right answer");
    let (mut document, truth) = (one["claimed"].clone(), one["truth"].clone());
    let exact = truth["stations"].as_array().expect("stations");
    let mut stations = json!({});
    for key in exact[0].as_object().expect("fields").keys() {
        stations[key] = exact.iter().map(|station| number(&station[key])).collect();
    }
    document["stations"] = stations;
    document["contact"] =
        truth["contact"].as_array().expect("contact").iter().map(region).collect();
    if let Some([left, right]) = truth["end_forces"].as_array().map(Vec::as_slice) {
        document["end_forces"] = json!({"left": number(left), "right": number(right)});
    }
    (one["model"].as_str().expect("a model").to_owned(), document, truth)
}

fn number(value: &Value) -> f64 {
    value.as_str().and_then(|x| x.parse().ok()).expect("a number")
}

pub fn region(ends: &Value) -> Value {
    json!({"from": number(&ends[0]), "to": number(&ends[1])})
}

pub fn verified(model: &str, document: &Value) -> Verification {
    one_document::verified(model, &document.to_string()).expect("bounds")
}

/// Adds to a number of a document, and returns the new document.
pub fn with(document: &Value, pointer: &str, change: f64) -> Value {
    let mut changed = document.clone();
    let place = changed.pointer_mut(pointer).unwrap_or_else(|| panic!("{pointer}"));
    *place = json!(place.as_f64().expect("a number") + change);
    changed
}

/// The document is not proven, and this bound covers the change. It exceeds the change by at most a quarter, because the
/// search for the largest excess ends there.
pub fn covers_change(what: &str, found: &Verification, bound: f64) {
    assert!(found.shortfall.is_some(), "{what}");
    assert!((1.0 - 1e-9..1.25).contains(&(bound / CHANGE)), "{what}: {bound:e}");
}

/// The document is not proven, and this bound is the change.
pub fn is_error(what: &str, found: &Verification, bound: f64) {
    assert!(found.shortfall.is_some(), "{what}");
    assert!((bound / CHANGE - 1.0).abs() < 1e-9, "{what}: {bound:e}");
}

#[test]
fn the_bound_of_a_wrong_field_is_its_error() {
    for name in ["right-layer", "right-springs"] {
        let (model, document, _) = right(name);
        let stations = document["stations"].as_object().expect("stations");
        let count = stations["x"].as_array().expect("places").len();
        let found = verified(&model, &document);
        assert_eq!(found.shortfall, None, "{name}");
        assert_eq!((found.checked.stations, found.checked.values), (count, 6 * count), "{name}");
        for field in stations.keys().filter(|key| *key != "x") {
            for (i, sign) in (0..count).zip([1.0, -1.0].into_iter().cycle()) {
                let place = format!("/stations/{field}/{i}");
                let found = verified(&model, &with(&document, &place, sign * CHANGE));
                is_error(&format!("{name}: {place}"), &found, found.error_of(field));
            }
        }
    }
}

#[test]
fn the_bound_of_a_wrong_edge_or_end_force_is_its_error() {
    for name in ["right-layer", "right-springs"] {
        let (model, document, _) = right(name);
        let found = verified(&model, &document);
        assert_eq!(found.checked.regions, 1, "{name}");
        assert!(found.edges.error < 1e-12 && found.forces.error < 1e-12, "{name}");
        for (end, key) in ["from", "to"].into_iter().enumerate() {
            for change in [CHANGE, -CHANGE] {
                let place = format!("/contact/0/{key}");
                let found = verified(&model, &with(&document, &place, change));
                is_error(&place, &found, found.listed.edges[0][end]);
                is_error(&place, &found, found.edges.error);
            }
        }
        for (end, key) in ["left", "right"].into_iter().enumerate() {
            if document["end_forces"].is_null() {
                continue;
            }
            for change in [CHANGE, -CHANGE] {
                let place = format!("/end_forces/{key}");
                let found = verified(&model, &with(&document, &place, change));
                is_error(&place, &found, found.listed.end_forces.expect("end forces")[end]);
                is_error(&place, &found, found.forces.error);
            }
        }
    }
}

#[test]
fn a_region_that_is_not_listed_is_not_proven() {
    let (model, mut document, _) = right("right-layer");
    document["contact"] = json!([]);
    assert!(verified(&model, &document).shortfall.is_some());
}

/// The pressure jumps from 0 to ku = u at the edge, where M = 0. Listed numbers between both are right.
#[test]
fn a_pressure_at_an_edge_lies_between_the_pressures_on_both_sides() {
    let (model, mut document, truth) = right("right-layer");
    let (edge, pieces) = (number(&truth["contact"][0][0]), &document["pieces"]);
    let inside = pieces[0]["open"][1].as_f64().expect("u at the edge");
    for (listed, off) in
        [(0.0, 0.0), (0.5 * inside, 0.0), (inside, 0.0), (-0.5, 0.5), (1.0, 1.0 - inside)]
    {
        document["stations"] = json!({"x": [edge], "pressure": [listed]});
        let found = verified(&model, &document);
        assert_eq!((found.checked.at_edges, found.checked.values), (1, 0));
        let bound = found.error_of("pressure");
        assert!((bound - off).abs() < 1e-12, "{listed}: {bound:e}");
        assert_eq!(found.shortfall.is_some(), off > 0.0, "{listed}");
        assert_eq!(found.error_at("pressure", edge), f64::INFINITY);
        assert_eq!(found.error_at("pressure", 0.3), bound);
        assert_eq!(found.error_at("deflection", edge), found.error_of("deflection"));
    }
}

/// A clamp at 0 and a pin at 2, joined by a hinge at 1, over a gap that the beam does not close, P = 12 at the hinge:
/// w = 6x² − 2x³, M = 12(x − 1), V = 12 up to the hinge; beyond it w = 4(2 − x), M = 0, V = 0.
const OVER_A_GAP: &str = r#"
[beam]
length = 2
EI = 1
[foundation]
k = 1
mu = 1
[[load]]
point = 12
at = 1
[[support]]
at = 0
type = "fixed"
[[support]]
at = 2
type = "pinned"
[[hinge]]
at = 1
[[gap]]
at = 0
value = 100
"#;

fn over_a_gap() -> Value {
    json!({
        "pieces": [
            {"x": [0, 1], "half": 0.5, "touches": false, "deflection": [1.25, 2.25, 0.75, -0.25]},
            {"x": [1, 2], "half": 0.5, "touches": false, "deflection": [2, -2]},
        ],
        "forces": [],
        "reactions": [{"support": 0, "force": 12, "moment": -12}, {"support": 1, "force": 0}],
        "contact": [],
        "stations": {
            "x": [0, 0.5, 1, 1.5, 2],
            "deflection": [0, 1.25, 4, 2, 0],
            "slope": [0, 4.5, -4, -4, -4],
            "rotation": [0, 4.5, -4, -4, -4],
            "moment": [-12, -6, 0, 0, 0],
            "shear_force": [12, 12, 0, 0, 0],
            "settlement": [0, 0, 0, 0, 0],
            "gap": [100, 98.75, 96, 98, 100],
            "pressure": [0, 0, 0, 0, 0],
        },
        "left_of_jumps": {"x": [1], "slope": [6], "rotation": [6], "shear_force": [12]},
        "extremes": {
            "deflection": {"max": {"x": 1, "value": 4}, "min": {"x": 0, "value": 0}},
            "slope": {"max": {"x": 1, "value": 6}, "min": {"x": 1.25, "value": -4}},
            "rotation": {"max": {"x": 1, "value": 6}, "min": {"x": 1, "value": -4}},
            "moment": {"max": {"x": 1.5, "value": 0}, "min": {"x": 0, "value": -12}},
            "shear_force": {"max": {"x": 0.25, "value": 12}, "min": {"x": 1.75, "value": 0}},
            "gap": {"max": {"x": 2, "value": 100}, "min": {"x": 1, "value": 96}},
        },
        "lift_off": [{"from": 0, "to": 2, "largest_gap": {"x": 0, "value": 100}}],
        "hinges": [{"at": 1, "rotation": -10, "moment": 0}],
    })
}

#[test]
fn the_bound_of_a_wrong_value_at_a_jump_or_of_an_extreme_is_its_error() {
    let document = over_a_gap();
    let found = verified(OVER_A_GAP, &document);
    assert_eq!(found.shortfall, None);
    assert_eq!((found.checked.stations, found.checked.values, found.checked.extremes), (6, 44, 12));
    for field in ["slope", "rotation", "shear_force"] {
        let place = format!("/left_of_jumps/{field}/0");
        let found = verified(OVER_A_GAP, &with(&document, &place, CHANGE));
        is_error(&place, &found, found.error_of(field));
    }
    let fields = document["extremes"].as_object().expect("extremes");
    for (field, end) in fields.keys().flat_map(|field| [(field, "max"), (field, "min")]) {
        for change in [CHANGE, -CHANGE] {
            let place = format!("/extremes/{field}/{end}/value");
            let found = verified(OVER_A_GAP, &with(&document, &place, change));
            covers_change(&place, &found, found.error_of(field));
        }
    }
    let place = "/lift_off/0/largest_gap/value";
    for change in [CHANGE, -CHANGE] {
        let found = verified(OVER_A_GAP, &with(&document, place, change));
        covers_change(place, &found, found.error_of("gap"));
    }
    for (key, field) in [("rotation", "rotation"), ("moment", "moment")] {
        let place = format!("/hinges/0/{key}");
        let found = verified(OVER_A_GAP, &with(&document, &place, CHANGE));
        is_error(&place, &found, found.error_of(field));
    }
    let mut doubled = document;
    doubled["hinges"][0]["rotation"] = json!(-20);
    assert!((verified(OVER_A_GAP, &doubled).error_of("rotation") - 10.0).abs() < 1e-9);
}

/// The coordinate t of the first piece runs from −4/5 to 4/5, that of the second piece from −1 to 1. The values on the left
/// of the hinge are those at t = 4/5.
#[test]
fn the_values_on_the_left_of_a_node_are_those_of_the_left_piece() {
    let mut document = over_a_gap();
    document["pieces"][0]["half"] = json!(0.625);
    document["pieces"][0]["deflection"] = json!([1.25, 2.8125, 1.171875, -0.48828125]);
    let found = verified(OVER_A_GAP, &document);
    assert_eq!(found.shortfall, None);
    for field in ["slope", "rotation", "shear_force", "moment", "deflection", "gap"] {
        assert!(found.error_of(field) < 1e-9, "{field}: {:e}", found.error_of(field));
    }
}

/// An extreme whose value stands at another place: at x = 0.5 the deflection is 2.75 below the largest one.
#[test]
fn an_extreme_at_a_wrong_place_is_not_proven() {
    let mut document = over_a_gap();
    document["extremes"]["deflection"]["max"]["x"] = json!(0.5);
    let found = verified(OVER_A_GAP, &document);
    assert!(found.shortfall.is_some());
    assert!((found.error_of("deflection") - 2.75).abs() < 1e-12);
    let placed =
        found.extremes.iter().find(|e| e.field == "deflection" && e.is_max).expect("placed");
    let [[low, high]] = placed.places[..] else { panic!("{placed:?}") };
    assert!(low <= 1.0 && 1.0 <= high && high - low < 1e-9, "{placed:?}");
    assert!((placed.distance() - 0.5).abs() < 1e-9 && (placed.error() - 0.5).abs() < 1e-9);
}

/// The shear force is largest on the whole stretch from 0 to 1, the moment from 1 to 2.
#[test]
fn claimed_places_of_an_extreme_must_contain_all_exact_places() {
    let claims = |field: &str, end: &str, places: Value| {
        let mut document = over_a_gap();
        document["proof"] = json!({"places": {field: {end: places}}});
        let found = verified(OVER_A_GAP, &document);
        assert_eq!(found.checked.bounds, 1, "{field}");
        found.shortfall.is_none()
    };
    assert!(claims("shear_force", "max", json!([[0, 1.001]])));
    assert!(claims("shear_force", "max", json!([[-1, 1.5]])));
    assert!(!claims("shear_force", "max", json!([[0, 0.999]])));
    assert!(!claims("shear_force", "max", json!([[0.001, 1]])));
    assert!(claims("moment", "max", json!([[0.999, 2.001]])));
    assert!(claims("deflection", "max", json!([[0.999, 1.001]])));
    assert!(!claims("deflection", "max", json!([[1.001, 2]])));
    assert!(!claims("deflection", "min", json!([[0, 1e-3]])));
}

#[test]
fn a_claimed_bound_must_not_be_smaller_than_the_proven_one() {
    let (model, document, _) = right("right-layer");
    let errors = verified(&model, &document).errors();
    let names: Vec<&str> = errors.iter().map(|(name, _)| *name).collect();
    let fields = [
        "deflection",
        "slope",
        "rotation",
        "moment",
        "shear_force",
        "settlement",
        "pressure",
        "gap",
    ];
    let numbers = [
        "edges",
        "forces",
        "reactions",
        "reaction_moments",
        "hinge_rotations",
        "hinge_moments",
        "end_forces",
    ];
    assert_eq!(names, [&fields[..], &numbers].concat());
    let claims = |name: &str, bounds: Vec<f64>| {
        let mut document = document.clone();
        document["proof"] = json!({"bounds": {name: bounds}});
        verified(&model, &document)
    };
    for (name, errors) in &errors {
        let found = claims(name, errors.clone());
        assert_eq!((found.shortfall, found.checked.bounds), (None, errors.len()), "{name}");
        let longer = errors.iter().copied().chain([1.0]).collect();
        assert!(claims(name, longer).shortfall.is_some(), "{name}");
        for i in (0..errors.len()).filter(|i| errors[*i] > 0.0) {
            let mut smaller = errors.clone();
            smaller[i] = smaller[i].next_down();
            assert!(claims(name, smaller).shortfall.is_some(), "{name}");
        }
    }
    let unknown = claims("curvature", vec![1.0]);
    assert!(unknown.not_covered.contains("proof.bounds.curvature"));
    assert_eq!((unknown.shortfall, unknown.checked.bounds), (None, 0));
}

/// w = x − x² is largest at x = ½. There it changes by 10⁻¹⁰ over 10⁻⁵ only, but the place is wrong.
#[test]
fn a_place_of_an_extreme_is_exact_to_a_millionth_of_the_length() {
    let model = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n[[gap]]\nat = 0\nvalue = 100\n\
                 [[load]]\nmoment = 2\nat = 0\n[[load]]\nmoment = -2\nat = 1\n\
                 [[support]]\nat = 0\ntype = 'pinned'\n[[support]]\nat = 1\ntype = 'pinned'\n";
    for (shift, is_right) in
        [(0.0, true), (9e-7, true), (-9e-7, true), (1e-5, false), (-1e-5, false)]
    {
        let document = json!({
            "pieces": [{"x": [0, 1], "half": 0.5, "touches": false, "deflection": [0.25, 0, -0.25]}],
            "reactions": [{"force": 0}, {"force": 0}],
            "contact": [],
            "extremes": {"deflection": {"max": {"x": 0.5 + shift, "value": 0.25}}},
        });
        let shortfall = verified(model, &document).shortfall;
        assert_eq!(shortfall.is_none(), is_right, "{shift:e}: {shortfall:?}");
    }
}
