//! Tests that a bare 0 needs no unit, for any key.

use crate::mutations::corpus::{Sample, samples};
use groundbeam_file::study::{StudyError, read_study};
use groundbeam_file::{Diagnostics, UnitSystem, parse_beside, parse_positions};
use std::collections::BTreeSet;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Keys that take words, tables, columns of a survey, or numbers that never have a unit.
const NO_UNIT: &[&str] = &[
    "action",
    "acts",
    "as",
    "axles",
    "band",
    "case",
    "clearance",
    "dynamic",
    "eccentricity",
    "factor",
    "factors",
    "file",
    "fillet",
    "group",
    "layer",
    "left",
    "level",
    "lifted_share",
    "limit_state",
    "limit_states",
    "material",
    "method",
    "name",
    "nu",
    "overturning",
    "right",
    "section",
    "segment",
    "set",
    "shape",
    "shrinkage_difference",
    "soil",
    "source",
    "type",
    "uniform",
    "weight_case",
    "x",
];

/// The keys to which no file in `cases/` or `docs/` gives a unit.
const RARE: &str = r#"
[beam]
length = "12 m"
E = "30 GPa"
I = "0.04 m^4"
G = "12 GPa"
shear_area = "0.4 m^2"
[[beam.segment]]
from = "2 m"
to = "4 m"
shear_stiffness = "900 MN"
[[beam.segment]]
from = "4 m"
to = "5 m"
GA = "900 MN"
[foundation]
C1 = "40 MN/m^3"
C2 = "9 MN/m"
width = "1 m"
[[load]]
distributed_moment = "5 kN m/m"
[[load]]
curvature = "1e-4 1/m"
[[load]]
shrinkage_difference = 3e-4
depth = "0.5 m"
[[support]]
at = "0 m"
rotational_spring = "5 MN m/rad"
"#;

/// A key that no table has.
const STRANGE: &str = "qqqqqqqqqqqq";

#[test]
fn a_bare_zero_needs_no_unit_under_any_key_of_a_model() {
    let mut tried = BTreeSet::new();
    let mut known = BTreeSet::new();
    let rare = Sample { folder: PathBuf::new(), text: RARE.to_owned() };
    for sample in samples().into_iter().chain([rare]) {
        let Ok(document) = parse_beside(&sample.text, &sample.folder) else { continue };
        known.extend(keys(&sample.text, |text| parse_beside(text, &sample.folder).err()));
        if document.units == UnitSystem::Plain {
            continue;
        }
        for quantity in &document.quantities {
            let text = with_zero(&sample.text, quantity.span.clone());
            let found = parse_beside(&text, &sample.folder).err();
            assert!(!mixes(found.as_ref()), "{}: {}\n{text}", quantity.key, found.unwrap());
            tried.insert(quantity.key.clone());
        }
    }
    let no_unit: BTreeSet<String> = NO_UNIT.iter().map(|key| (*key).to_owned()).collect();
    let left: Vec<&String> = known.difference(&tried).collect();
    assert_eq!(left, Vec::from_iter(&no_unit), "no file here gives these a unit");
}

#[test]
fn a_bare_zero_needs_no_unit_in_a_study() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let text = std::fs::read_to_string(docs.join("random-ground.toml")).unwrap();
    let text =
        text.replace("strip-footing.toml", docs.join("strip-footing.toml").to_str().unwrap());
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("zeros.toml");
    let quantities: Vec<Range<usize>> = text
        .match_indices('"')
        .filter(|(i, _)| text[i + 1..].starts_with(|c: char| c.is_ascii_digit()))
        .map(|(i, _)| i..i + 2 + text[i + 1..].find('"').unwrap())
        .collect();
    assert!(quantities.len() >= 6);
    for span in quantities {
        std::fs::write(&path, with_zero(&text, span.clone())).unwrap();
        if let Err(StudyError::Wrong(found, ..)) = read_study(&path) {
            assert!(!mixes(Some(&found)), "{}: {found}", &text[span]);
        }
    }
}

#[test]
fn a_bare_zero_needs_no_unit_among_positions() {
    assert_eq!(parse_positions("0, 0.5 m, -0", UnitSystem::Si).unwrap(), [0.0, 0.5, 0.0]);
    assert!(parse_positions("0 m", UnitSystem::Plain).is_err());
}

/// A bare 0 is allowed in a file without units; a 0 with a unit is not.
#[test]
fn a_zero_with_a_unit_is_refused_in_a_file_without_units() {
    let read = |at: &str, length: &str| {
        let model = "EI = 1\n[foundation]\nk = 1\n[[load]]\npoint = 1\n";
        parse_beside(&format!("[beam]\nlength = {length}\n{model}at = {at}\n"), Path::new(""))
    };
    assert_eq!(read("0", "1").unwrap().units, UnitSystem::Plain);
    assert!(mixes(read("\"0 m\"", "1").err().as_ref()));
    assert!(mixes(read("0", "\"1 m\"").err().as_ref()));
}

fn mixes(found: Option<&Diagnostics>) -> bool {
    found.is_some_and(|found| found.iter().any(|d| d.code == "GB016"))
}

fn with_zero(text: &str, span: Range<usize>) -> String {
    [&text[..span.start], "0", &text[span.end..]].concat()
}

/// Every key that messages list for one of the tables of a text.
fn keys(text: &str, wrong: impl Fn(&str) -> Option<Diagnostics>) -> BTreeSet<String> {
    let mut keys = BTreeSet::new();
    let places = text.match_indices("]\n").map(|(i, _)| (i + 2, "\n"));
    let braces = text.match_indices("{ ").map(|(i, _)| (i + 2, ", "));
    for (place, end) in places.chain(braces) {
        let changed = format!("{}{STRANGE} = 1{end}{}", &text[..place], &text[place..]);
        let Some(found) = wrong(&changed) else { continue };
        let hints = found.iter().filter(|d| d.message.contains(STRANGE));
        let lists = hints.filter_map(|d| d.hint.strip_prefix("allowed here: "));
        keys.extend(lists.flat_map(|list| list.split(", ").map(str::to_owned)));
    }
    keys
}
