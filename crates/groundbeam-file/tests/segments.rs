//! Tests the rule for segments of beam and ground: a factor that a segment leaves out has the value that
//! `[beam]` or `[foundation]` gives it at the same position.

use groundbeam::Model;
use proptest::prelude::*;
use std::fmt::Write;

/// A quantity from one end of a table's stretch to the other: one value, or a list of two.
#[derive(Debug, Clone, Copy)]
struct Values(f64, Option<f64>);

impl Values {
    fn at(self, t: f64) -> f64 {
        self.0 + t * (self.1.unwrap_or(self.0) - self.0)
    }

    fn text(self) -> String {
        self.1.map_or(format!("{:?}", self.0), |end| format!("[{:?}, {end:?}]", self.0))
    }
}

/// The quantities of one table, by key.
type Said = Vec<(&'static str, Values)>;

/// One stretch of the beam and the quantities that its segment gives.
#[derive(Debug, Clone)]
struct Stretch {
    from: f64,
    to: f64,
    said: Said,
}

/// A table for the whole beam and its segments.
#[derive(Debug, Clone)]
struct Given {
    whole: Said,
    segments: Vec<Stretch>,
}

fn value_of(said: &Said, key: &str) -> Option<Values> {
    said.iter().find(|(name, _)| *name == key).map(|(_, values)| *values)
}

impl Given {
    fn write(&self, text: &mut String, table: &str, segment: &str) {
        let keys = |text: &mut String, said: &Said| {
            said.iter().for_each(|(key, v)| writeln!(text, "{key} = {}", v.text()).unwrap());
        };
        writeln!(text, "[{table}]").unwrap();
        if table == "beam" {
            writeln!(text, "length = {LENGTH:?}").unwrap();
        }
        keys(text, &self.whole);
        for Stretch { from, to, said } in &self.segments {
            writeln!(text, "[[{segment}]]\nfrom = {from:?}\nto = {to:?}").unwrap();
            keys(text, said);
        }
    }

    /// The segment at x, and the relative position of x in the segment.
    fn segment(&self, x: f64) -> Option<(&Said, f64)> {
        let found = self.segments.iter().find(|s| s.from < x && x < s.to)?;
        Some((&found.said, (x - found.from) / (found.to - found.from)))
    }

    /// The value of a key at x: the value of the segment, or of the whole beam if the segment gives none.
    fn value(&self, key: &str, x: f64) -> Option<f64> {
        let own = self.segment(x).and_then(|(said, t)| Some(value_of(said, key)?.at(t)));
        own.or_else(|| Some(value_of(&self.whole, key)?.at(x / LENGTH)))
    }

    /// A stiffness at x: the segment's product, or the product of the factors if the segment gives one of
    /// them; otherwise the stiffness of the whole beam.
    fn stiffness(&self, [product, a, b]: [&str; 3], x: f64) -> f64 {
        let factors = || self.value(a, x).unwrap() * self.value(b, x).unwrap();
        if let Some((said, t)) = self.segment(x) {
            if let Some(own) = value_of(said, product) {
                return own.at(t);
            }
            if [a, b].iter().any(|key| value_of(said, key).is_some()) {
                return factors();
            }
        }
        value_of(&self.whole, product).map_or_else(factors, |whole| whole.at(x / LENGTH))
    }

    /// μ at x. A segment gives `mu`, or `C2` and `width`, whose product is μ. If it gives only one of `C2` and
    /// `width`, the other is taken from [foundation]. Without these keys μ is that of [foundation].
    fn shear_constant(&self, x: f64) -> f64 {
        let product = || Some(self.value("C2", x)? * self.value("width", x)?);
        if let Some((said, t)) = self.segment(x) {
            if let Some(own) = value_of(said, "mu") {
                return own.at(t);
            }
            let new = ["C2", "width"].iter().any(|key| value_of(said, key).is_some());
            if let Some(product) = product().filter(|_| new) {
                return product;
            }
        }
        let whole = |key| Some(value_of(&self.whole, key)?.at(x / LENGTH));
        let of_area = || Some(whole("C2")? * whole("width")?);
        whole("mu").or_else(of_area).unwrap_or(0.0)
    }
}

const LENGTH: f64 = 12.0;

fn values() -> impl Strategy<Value = Values> {
    (1.0..9.0_f64, prop::option::of(1.0..9.0_f64)).prop_map(|(a, b)| Values(a, b))
}

/// One of several sets of keys, each with random values.
fn said(sets: &'static [&'static [&'static str]]) -> impl Strategy<Value = Said> {
    let values = prop::collection::vec(values(), 4);
    (prop::sample::select(sets), values)
        .prop_map(|(keys, values)| keys.iter().copied().zip(values).collect())
}

/// Stretches of the beam that may touch, each with one of several sets of keys.
fn segments(sets: &'static [&'static [&'static str]]) -> impl Strategy<Value = Vec<Stretch>> {
    let corners = prop::collection::btree_set(0..=24_u32, 0..6);
    (corners, prop::collection::vec((said(sets), any::<bool>()), 5)).prop_map(|(corners, all)| {
        let corners: Vec<f64> = corners.into_iter().map(|half| 0.5 * f64::from(half)).collect();
        let stretches = corners.windows(2).zip(all).filter(|(_, (_, there))| *there);
        stretches.map(|(ends, (said, _))| Stretch { from: ends[0], to: ends[1], said }).collect()
    })
}

fn given(
    whole: &'static [&'static [&'static str]],
    parts: &'static [&'static [&'static str]],
) -> impl Strategy<Value = Given> {
    (said(whole), segments(parts)).prop_map(|(whole, segments)| Given { whole, segments })
}

fn beam() -> impl Strategy<Value = Given> {
    prop_oneof![
        given(&[&["EI"], &["EI", "GA"]], &[&["EI"], &["E", "I"], &["GA"], &["EI", "GA"]]),
        given(
            &[&["E", "I"], &["E", "I", "GA"], &["E", "I", "G", "shear_area"]],
            &[&["EI"], &["E", "I"], &["E"], &["I"], &["GA"], &["E", "GA"]],
        ),
        given(
            &[&["E", "I", "G", "shear_area"]],
            &[&["EI"], &["I", "G"], &["E", "shear_area"], &["G"], &["G", "shear_area"]],
        ),
    ]
}

fn ground() -> impl Strategy<Value = Given> {
    prop_oneof![
        given(
            &[&["k"], &["k", "mu"]],
            &[
                &["k"],
                &["k", "mu"],
                &["mu"],
                &["subgrade_modulus", "width"],
                &["subgrade_modulus", "width", "C2"],
            ],
        ),
        given(
            &[&["subgrade_modulus", "width"], &["subgrade_modulus", "width", "mu"]],
            &[&["k"], &["subgrade_modulus"], &["width"], &["mu"], &["width", "mu"], &["C2"]],
        ),
        given(
            &[&["subgrade_modulus", "width", "C2"]],
            &[&["k"], &["width"], &["C2"], &["mu", "width"], &["subgrade_modulus", "C2"]],
        ),
    ]
}

fn read(text: &str) -> Model {
    match groundbeam_file::parse(text) {
        Ok(document) => document.model,
        Err(found) => panic!("{}", found.render("file.toml", text, false)),
    }
}

#[track_caller]
fn close(found: f64, wanted: f64, text: &str, x: f64) {
    assert!((found - wanted).abs() <= 1e-12 * wanted, "{found} {wanted} at {x} of\n{text}");
}

/// Two positions in every half metre, away from the corners.
fn places() -> impl Iterator<Item = f64> {
    (0..24).flat_map(|half| [0.1, 0.37].map(|inside| 0.5 * f64::from(half) + inside))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..Default::default() })]

    #[test]
    fn a_segment_inherits_missing_values_from_its_table(beam in beam(), ground in ground()) {
        let mut text = String::new();
        beam.write(&mut text, "beam", "beam.segment");
        ground.write(&mut text, "foundation", "foundation.segment");
        let model = read(&text);
        for x in places() {
            let wanted = beam.stiffness(["EI", "E", "I"], x);
            close(model.beam.bending_stiffness_at(x), wanted, &text, x);
            let (k, mu) = model.foundation.constants_at(x);
            close(k, ground.stiffness(["k", "subgrade_modulus", "width"], x), &text, x);
            close(mu, ground.shear_constant(x), &text, x);
            if beam.whole.iter().any(|(key, _)| ["GA", "G"].contains(key)) {
                let wanted = beam.stiffness(["GA", "G", "shear_area"], x);
                close(model.beam.shear_stiffness_at(x).unwrap(), wanted, &text, x);
            }
        }
    }

    /// Outside the beam the ground has the values at the beam's ends, unless a constant segment lies there.
    #[test]
    fn ground_outside_the_beam_has_the_values_at_the_ends_of_the_beam(
        ground in ground(),
        own in said(&[&["k"], &["k", "mu"]]),
        beside in 0.5..4.0_f64,
    ) {
        let own: Said = own.into_iter().map(|(key, values)| (key, Values(values.0, None))).collect();
        let left = Stretch { from: -beside, to: 1.0, said: own };
        let inside: Vec<Stretch> = ground.segments.into_iter().filter(|s| s.from >= 1.0).collect();
        let segments = std::iter::once(left.clone()).chain(inside).collect();
        let ground = Given { segments, ..ground };
        let mut text = format!("[beam]\nlength = {LENGTH:?}\nEI = 1\n");
        ground.write(&mut text, "foundation", "foundation.segment");
        let model = read(&text);
        let constant = ground.whole.iter().all(|(_, values)| values.1.is_none());
        let first = model.foundation.segments.iter().find(|s| s.from <= 0.0).unwrap();
        prop_assert_eq!(first.from, if constant { -beside } else { 0.0 });
        let (k, mu) = model.foundation.constants_at(0.5);
        close(k, value_of(&left.said, "k").unwrap().0, &text, 0.5);
        close(mu, ground.shear_constant(0.5), &text, 0.5);
    }

    /// Segments from end to end need no values of the whole beam, and a gap between them is reported.
    #[test]
    fn segments_without_values_of_the_whole_beam_must_cover_it(
        joint in 1.0..11.0_f64,
        gap in prop_oneof![Just(0.0), 0.1..0.9_f64],
        values in prop::collection::vec(values(), 4),
    ) {
        let mut text = format!("[beam]\nlength = {LENGTH:?}\n");
        let [a, b, c, d] = values[..] else { unreachable!() };
        for (table, key, values) in [("beam", "EI", [a, b]), ("foundation", "k", [c, d])] {
            for (from, to, values) in [(0.0, joint, values[0]), (joint + gap, LENGTH, values[1])] {
                let values = values.text();
                write!(text, "[[{table}.segment]]\nfrom = {from:?}\nto = {to:?}\n{key} = {values}\n").unwrap();
            }
        }
        match groundbeam_file::parse(&text) {
            Ok(document) => {
                prop_assert_eq!(gap, 0.0);
                let x = 0.5 * joint;
                close(document.model.beam.bending_stiffness_at(x), a.at(0.5), &text, x);
                close(document.model.foundation.constants_at(x).0, c.at(0.5), &text, x);
            }
            Err(found) => {
                prop_assert!(gap > 0.0, "{}", found);
                let codes: Vec<&str> = found.iter().map(|fault| fault.code).collect();
                prop_assert_eq!(codes, ["GB004", "GB004"]);
            }
        }
    }
}
