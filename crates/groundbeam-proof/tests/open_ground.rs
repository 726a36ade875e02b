//! Tests the settlements, gaps and stretches that a document lists for open ground between contact points, in closed form.

use crate::listed::{CHANGE, covers_change, is_error, region, right, verified, with};
use groundbeam_proof::{Document, Verification};
use serde_json::{Value, json};

/// A level beam, w = 1, stands on two ridges at x = 1 and 3 of endless ground with μ = 1 and k = b². Between and beside them the
/// ground lies 2b lower. u = A(exp(−b|x − 1|) + exp(−b|x − 3|)) is 1 at both, and each carries the load 2Ab.
struct OnRidges {
    b: f64,
    size: f64,
}

impl OnRidges {
    fn new(b: f64) -> Self {
        OnRidges { b, size: 1.0 / (1.0 + (-2.0 * b).exp()) }
    }

    fn settlement(&self, x: f64) -> f64 {
        self.size * ((-self.b * (x - 1.0).abs()).exp() + (-self.b * (x - 3.0).abs()).exp())
    }

    fn gap(&self, x: f64) -> f64 {
        let ground = 2.0 * self.b * (x - 1.0).abs().min((x - 3.0).abs());
        self.settlement(x) + ground - 1.0
    }

    fn model(&self) -> String {
        let height = 2.0 * self.b;
        let corner = |x: u32| {
            format!("[[gap]]\nat = {x}\nvalue = {}\n", if x % 2 == 1 { 0.0 } else { height })
        };
        let load = |x: u32| format!("[[load]]\npoint = {}\nat = {x}\n", 2.0 * self.size * self.b);
        let ground = format!("[foundation]\nk = {}\nmu = 1\n", self.b * self.b);
        let corners: String = (0..=4).map(corner).collect();
        format!("[beam]\nlength = 4\nEI = 1\n{ground}{corners}{}{}", load(1), load(3))
    }

    fn document(&self) -> Value {
        let piece = |from: u32| json!({"x": [from, from + 1], "half": 0.5, "touches": false, "deflection": [1]});
        let force = 2.0 * self.size * self.b;
        let places: Vec<f64> = (0..=64).map(|i| f64::from(i) / 16.0).collect();
        let stretch = |from: f64, to: f64, x: f64| json!({"from": from, "to": to, "largest_gap": {"x": x, "value": self.gap(x)}});
        json!({
            "pieces": [piece(0), piece(1), piece(2), piece(3)],
            "forces": [{"x": 1, "force": force}, {"x": 3, "force": force}],
            "contact": [{"from": 1, "to": 1}, {"from": 3, "to": 3}],
            "stations": {
                "settlement": places.iter().map(|x| self.settlement(*x)).collect::<Vec<_>>(),
                "gap": places.iter().map(|x| self.gap(*x)).collect::<Vec<_>>(),
                "x": places,
            },
            "extremes": {
                "settlement": {"max": {"x": 1, "value": 1}, "min": {"x": 0, "value": self.settlement(0.0)}},
                "gap": {"max": {"x": 2, "value": self.gap(2.0)}, "min": {"x": 3, "value": 0}},
            },
            "lift_off": [stretch(0.0, 1.0, 0.0), stretch(1.0, 3.0, 2.0), stretch(3.0, 4.0, 4.0)],
        })
    }

    fn verified(&self, document: &Value) -> Verification {
        verified(&self.model(), document)
    }
}

#[test]
fn the_bound_of_a_wrong_value_on_open_ground_is_its_error() {
    for b in [1.0, 8.0, 40.0] {
        let ridges = OnRidges::new(b);
        let document = ridges.document();
        let found = ridges.verified(&document);
        assert_eq!(found.shortfall, None, "{b}");
        for field in ["settlement", "gap"] {
            assert!(found.error_of(field) < 1e-12, "{b} {field}: {:e}", found.error_of(field));
        }
        for (field, i) in
            ["settlement", "gap"].into_iter().flat_map(|f| (1..64).step_by(9).map(move |i| (f, i)))
        {
            let place = format!("/stations/{field}/{i}");
            let found = ridges.verified(&with(&document, &place, CHANGE));
            is_error(&format!("{b}: {place}"), &found, found.error_of(field));
        }
        for i in 0..3 {
            for change in [CHANGE, -CHANGE] {
                let place = format!("/lift_off/{i}/largest_gap/value");
                let found = ridges.verified(&with(&document, &place, change));
                covers_change(&format!("{b}: {place}"), &found, found.error_of("gap"));
            }
        }
    }
}

#[test]
fn a_listed_stretch_is_open_and_lies_between_listed_edges() {
    let ridges = OnRidges::new(8.0);
    let refused = |from: f64, to: f64, x: f64| {
        let mut document = ridges.document();
        let largest = json!({"x": x, "value": ridges.gap(x)});
        document["lift_off"] = json!([{"from": from, "to": to, "largest_gap": largest}]);
        ridges.verified(&document).shortfall.map(|why| why.what)
    };
    for (from, to, x) in [(0.0, 1.0, 0.0), (1.0, 3.0, 2.0), (3.0, 4.0, 4.0)] {
        assert_eq!(refused(from, to, x), None, "{from} {to}");
    }
    for (from, to, x) in [
        (0.0, 0.5, 0.0),
        (0.5, 1.0, 0.5),
        (2.0, 3.0, 2.0),
        (1.0, 2.0, 2.0),
        (0.0, 1.0, 2.0),
        (1.0, 3.0, 0.0),
    ] {
        let why = refused(from, to, x).expect("a wrong stretch");
        assert!(why.contains("does not end at a listed edge"), "{from} {to} {x}: {why}");
    }
    for (from, to) in [(0.0, 3.0), (1.0, 4.0), (0.0, 4.0)] {
        let why = refused(from, to, 2.0).expect("a stretch with a point of contact");
        assert!(why.contains("is in contact"), "{from} {to}: {why}");
    }
    // The region of contact itself, and the largest gap of a part of a stretch.
    let (model, mut document, truth) = right("right-layer");
    let edges = region(&truth["contact"][0]);
    let [from, to] = [&edges["from"], &edges["to"]];
    document["lift_off"] =
        json!([{"from": from, "to": to, "largest_gap": {"x": from, "value": 0}}]);
    let why = verified(&model, &document).shortfall.expect("a region of contact").what;
    assert!(why.contains("is in contact"), "{why}");
    for (from, to, x, largest) in
        [(0.0, 1.0, 0.5, 0.0), (1.0, 3.0, 1.5, 2.0), (1.0, 3.0, 2.5, 2.0), (3.0, 4.0, 3.5, 4.0)]
    {
        let mut document = ridges.document();
        let part = json!({"x": x, "value": ridges.gap(x)});
        document["lift_off"] = json!([{"from": from, "to": to, "largest_gap": part}]);
        let found = ridges.verified(&document);
        let missed = ridges.gap(largest) - ridges.gap(x);
        assert!(found.shortfall.is_some(), "{x}");
        assert!((1.0 - 1e-9..1.25).contains(&(found.error_of("gap") / missed)), "{x}");
        assert_eq!(found.checked.values, 2 * 65 + 1, "{x}");
    }
}

/// Under a beam on pins with end moments, w = x − x², springs k = 3 carry the load q = 1 + x: u = q/3.
#[test]
fn the_bound_of_a_wrong_settlement_of_loaded_springs_is_its_error() {
    let model = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 3\n[[gap]]\nat = 0\nvalue = 100\n\
                 [[ground_load]]\ndistributed = [1, 2]\nfrom = 0\nto = 1\n\
                 [[support]]\nat = 0\ntype = 'pinned'\n[[support]]\nat = 1\ntype = 'pinned'\n\
                 [[load]]\nmoment = 2\nat = 0\n[[load]]\nmoment = -2\nat = 1\n";
    let places = [0.0, 0.25, 0.5, 1.0];
    let settled = places.map(|x| (1.0 + x) / 3.0);
    let gaps = places.map(|x| 100.0 + (1.0 + x) / 3.0 - x + x * x);
    let document = json!({
        "pieces": [{"x": [0, 1], "half": 0.5, "touches": false, "deflection": [0.25, 0, -0.25]}],
        "reactions": [{"force": 0}, {"force": 0}],
        "contact": [],
        "stations": {"x": places, "settlement": settled, "gap": gaps},
    });
    let found = verified(model, &document);
    assert_eq!(found.shortfall, None);
    for field in ["settlement", "gap"] {
        assert!(found.error_of(field) < 1e-12, "{field}");
        for i in 0..places.len() {
            let place = format!("/stations/{field}/{i}");
            let found = verified(model, &with(&document, &place, CHANGE));
            is_error(&place, &found, found.error_of(field));
        }
    }
}

#[test]
fn a_stretch_whose_ends_are_moved_by_rounding_errors_covers_the_same_pieces() {
    let ridges = OnRidges::new(8.0);
    let mut document = ridges.document();
    let from = 1.0_f64.next_up();
    document["contact"] = json!([{"from": from, "to": from}, {"from": 3, "to": 3}]);
    let listed = |x: f64| {
        let largest = json!({"x": x, "value": ridges.gap(x)});
        json!([{"from": from, "to": 3, "largest_gap": largest}])
    };
    document["lift_off"] = listed(2.0);
    assert_eq!(ridges.verified(&document).shortfall, None);
    document["lift_off"] = listed(2.875);
    let missed = ridges.gap(2.0) - ridges.gap(2.875);
    let found = ridges.verified(&document);
    assert!(found.shortfall.is_some() && found.error_of("gap") >= (1.0 - 1e-9) * missed);
    // The whole beam as one stretch, without a list of contact regions.
    let mut document = ridges.document();
    let members = document.as_object_mut().expect("an object");
    members.remove("contact");
    let largest = json!({"x": 2, "value": ridges.gap(2.0)});
    document["lift_off"] = json!([{"from": 0, "to": 4, "largest_gap": largest}]);
    let why = ridges.verified(&document).shortfall.expect("points of contact").what;
    assert!(why.contains("is in contact"), "{why}");
}

#[test]
fn a_listed_verdict_agrees_with_the_proof() {
    let ridges = OnRidges::new(8.0);
    for (verdict, wrong) in
        [("unique", false), ("not-unique", true), ("local", true), ("none", true)]
    {
        let mut document = ridges.document();
        document["existence"] = json!({"verdict": verdict});
        assert_eq!(ridges.verified(&document).shortfall.is_some(), wrong, "{verdict}");
    }
    let text = json!({"combinations": [], "existence": {"verdict": "none"}}).to_string();
    assert!(Document::read(&text).is_err());
}

#[test]
fn stretches_do_not_overlap_and_hinges_are_those_of_the_model() {
    let ridges = OnRidges::new(8.0);
    let mut document = ridges.document();
    let first = document["lift_off"][0].clone();
    document["lift_off"] = json!([first, first]);
    let why = ridges.verified(&document).shortfall.expect("two equal stretches").what;
    assert!(why.contains("overlap"), "{why}");
    let mut document = ridges.document();
    document["hinges"] = json!([{"at": 2, "rotation": 0, "moment": 0}]);
    let why = ridges.verified(&document).shortfall.expect("no hinge").what;
    assert!(why.contains("not a hinge of the model"), "{why}");
}
