//! Tests the second reader on model files, and on files and documents with random changes.

use groundbeam_proof::{
    Action, Ball, Course, Document, Extent, Load, Model, ReadError, Reason, Scalar, Wide,
    read_model,
};
use groundbeam_testing::{files, repository};
use std::time::{Duration, Instant};

fn read(text: &str) -> Result<Model<Wide>, ReadError> {
    read_model(text, None)
}

fn reason(text: &str) -> Reason {
    read(text).map(|model| panic!("{model:?}")).unwrap_or_else(|error| error.reason)
}

/// The size of a load at its left end.
fn size(load: &Load<Wide>) -> f64 {
    match load.extent {
        Extent::Point { size, .. } => size.middle(),
        Extent::Distributed { start, .. } => start.middle(),
    }
}

const SMALL: &str = "[beam]\nlength = 2\nEI = 3\n[foundation]\nk = 4\nmu = 5\n";

#[test]
fn numbers_without_units_are_read_unchanged() {
    let model = read(SMALL).unwrap();
    assert_eq!(model.beam.bending_stiffness.middle(), 3.0);
    assert_eq!([model.ground.spring.middle(), model.ground.shear.middle()], [4.0, 5.0]);
    assert!(read_model::<Ball>(SMALL, None).is_ok());
}

/// A haunch from 1.2 m to 0.8 m: EI at mid-length is that of 1 m, exactly; its self-weight is linear.
#[test]
fn a_haunch_is_a_polynomial_of_its_height() {
    let text = "[beam]\nlength = '12 m'\nE = '30 GPa'\nunit_weight = '25 kN/m^3'\nweight_case = 'G'\n\
                section = { width = '1 m', height = ['1.2 m', '0.8 m'] }\n[foundation]\nk = '1 MPa'\n\
                [[combination]]\nname = 'c'\nfactors = { G = 1.1 }\n";
    let model = read(text).unwrap();
    let Course::Varying(values) = &model.beam.segments[0].bending_stiffness else { panic!() };
    let middle: f64 =
        values.iter().zip([1.0, 3.0, 3.0, 1.0]).map(|(v, n)| n * v.middle() / 8.0).sum();
    assert!((middle / 2.5e9 - 1.0).abs() < 1e-15);
    assert_eq!(size(&model.loads[0]), 30e3);
    let combined = read_model::<Wide>(text, Some("c")).unwrap();
    assert_eq!(size(&combined.loads[0]), 33e3);
    let missing = read_model::<Wide>(text, Some("d")).unwrap_err();
    assert_eq!(missing.reason, Reason::NoCombination("d".into()));
}

#[test]
fn curvatures_are_computed_from_the_depth() {
    let text = "[beam]\nlength = '4 m'\nmaterial = 'C30/37'\ncamber = '10 mm'\n\
                section = { width = '1 m', height = '0.25 m' }\n[foundation]\nk = '1 MPa'\n\
                [[load]]\ntemperature_difference = '15 K'\n\
                [[load]]\nshrinkage_difference = 2e-4\ndepth = '0.5 m'\n";
    let model = read(text).unwrap();
    assert!(model.loads.iter().all(|load| load.action == Action::Curvature));
    let sizes: Vec<f64> = model.loads.iter().map(size).collect();
    assert_eq!(sizes, [6e-4, -4e-4, 5e-3]);
}

#[test]
fn ground_per_area_is_read_with_its_segments() {
    let text = "[beam]\nlength = '10 m'\nEI = '1 MN m^2'\n[foundation]\nC1 = ['10 MN/m^3', '30 MN/m^3']\n\
                width = '0.5 m'\nC2 = '4 MN/m'\nright = { ends = '12 m', as = 'held' }\n\
                [[foundation.segment]]\nfrom = '-1 m'\nto = '5 m'\nwidth = '1 m'\n";
    let ground = read(text).unwrap().ground;
    assert_eq!(ground.segments.len(), 2);
    let [own, rest] = &ground.segments[..] else { panic!() };
    // A value that varies along the beam ends with the beam.
    assert_eq!([own.from.middle(), own.to.middle()], [0.0, 5.0]);
    let Course::Varying(k) = &own.spring else { panic!() };
    assert_eq!([k[0].middle(), k[1].middle()], [10e6, 20e6]);
    let Course::Constant(mu) = &own.shear else { panic!() };
    assert_eq!(mu.middle(), 4e6);
    let Course::Varying(k) = &rest.spring else { panic!() };
    assert_eq!([k[0].middle(), k[1].middle()], [10e6, 15e6]);
}

/// EN 1990, expression (6.10): wind leads, the floor load accompanies with ψ₀ = 0.7.
#[test]
fn a_set_of_a_design_code_generates_its_combinations() {
    let load = |case: &str| format!("[[load]]\npoint = 1\nat = 1\ncase = '{case}'\n");
    let case =
        |name: &str, action: &str| format!("[[case]]\nname = '{name}'\naction = '{action}'\n");
    let text = [
        SMALL.to_owned(),
        load("G") + &load("Q") + &load("W"),
        case("G", "permanent") + &case("Q", "imposed B") + &case("W", "wind"),
        "[[combination]]\nset = 'EN 1990 6.10'\n".to_owned(),
    ]
    .concat();
    let sizes = |name: &str| -> Vec<f64> {
        read_model::<Wide>(&text, Some(name)).unwrap().loads.iter().map(size).collect()
    };
    assert_eq!(sizes("6.10: 1.35 G + 1.5 W + 1.05 Q"), [1.35, 1.05, 1.5]);
    assert_eq!(sizes("6.10: G"), [1.0]);
    assert!(read_model::<Wide>(&text, Some("6.10: 1.35 G + 1.5 Q + 1.5 W")).is_err());
}

#[test]
fn unsupported_tables_are_refused_by_name() {
    for (text, key) in [
        ("[gap_survey]\nfile = 'a.csv'\n", "gap_survey"),
        ("[[gap_trough]]\nat = 1\n", "gap_trough"),
        ("[[train]]\nset = 'LM71'\n", "train"),
    ] {
        assert_eq!(reason(&format!("{SMALL}{text}")), Reason::NotRead(key));
    }
    let soil = "[foundation]\nwidth = 1\n[foundation.soil]\nmethod = 'modified-vlasov'\n";
    let text = SMALL.replace("[foundation]\nk = 4\nmu = 5\n", soil);
    assert_eq!(reason(&text), Reason::NotRead("modified-vlasov"));
}

/// A band names its grounds; with combinations the name of the combination comes first.
#[test]
fn a_band_makes_a_model_of_each_ground() {
    let band = format!("{SMALL}[foundation.band]\nk = [0.5, 2]\nmu = [0, 1.5]\n");
    let ground = |text: &str, name: &str| {
        let ground = read_model::<Wide>(text, Some(name)).unwrap().ground;
        [ground.spring, ground.shear].map(|number| number.middle())
    };
    assert_eq!(ground(&band, "best ground"), [4.0, 5.0]);
    assert_eq!(ground(&band, "0.5 k, 1.5 mu"), [2.0, 7.5]);
    let winkler = read_model::<Wide>(&band, Some("2 k, 0 mu")).unwrap().ground;
    assert_eq!(winkler.shear, Wide::of(0.0));
    assert!(read_model::<Wide>(&band, Some("2 k")).is_err());
    let loads = "[[load]]\npoint = 1\nat = 1\ncase = 'G'\n\
                 [[combination]]\nname = 'G'\nfactors = { G = 3 }\n";
    let text = format!("{band}{loads}");
    assert_eq!(ground(&text, "G; 2 k, 1 mu"), [8.0, 5.0]);
    let missing = read_model::<Wide>(&text, Some("G")).unwrap_err();
    assert_eq!(missing.reason, Reason::NoCombination("G".into()));
    for wrong in ["k = [1.5, 2]", "k = [0.5]", "k = [0, 2]", "mu = [0.5, 0.9]", ""] {
        let text = format!("{SMALL}[foundation.band]\n{wrong}\n");
        assert!(read(&text).is_err(), "{wrong}");
    }
}

#[test]
fn invalid_values_are_refused() {
    let value = |text: &str| assert!(matches!(reason(text), Reason::Value(_)), "{text}");
    let large = reason(&format!("{SMALL}[[load]]\npoint = 1e61\nat = 1\n"));
    assert!(matches!(large, Reason::OutOfRange(_)), "{large:?}");
    for added in [
        "[[load]]\npoint = '1 kN'\nat = 1\n",
        "[[load]]\npoint = 1\nat = 3\n",
        "[[load]]\ndistributed = 1\nfrom = 1\nto = 1\n",
        "[[load]]\ndistributed = [1, 2, 3]\n",
        "[[load]]\npoint = 'x'\nat = 1\n",
        "[[support]]\nat = 1\nspring = -1\n",
        "[[support]]\nat = 1\ntype = 'roller'\n",
        "[[support]]\nat = 1\ntype = 'fixed'\nacts = 'up'\n",
        "[[support]]\nat = 1\ntype = 'pinned'\n[[support]]\nat = 1\nspring = 1\n",
        "[[hinge]]\nat = 0\n",
        "[[hinge]]\nat = 1\n[[load]]\nmoment = 1\nat = 1\n",
        "[[gap]]\nat = 1\nvalue = 1\n[[gap]]\nat = 1\nvalue = 2\n",
        "[[beam.segment]]\nfrom = 0\nto = 1\nEI = 1\n[[beam.segment]]\nfrom = 0.5\nto = 2\nEI = 1\n",
        "[[foundation.segment]]\nfrom = 0\nto = 1\nmu = [1, 0]\n",
        "[[ground_load]]\npoint = -1\nat = 1\n",
        "[[load]]\npoint = 1\nat = 1\n[[ground_load]]\ndistributed = 1\nfrom = 0\nto = '1 m'\n",
    ] {
        value(&format!("{SMALL}{added}"));
    }
    value(&SMALL.replace("EI = 3", "EI = '3 kN m'"));
    value(&SMALL.replace("EI = 3", "EI = 0"));
    value("[beam]\nlength = 2\nE = 1\nsection = { rail = '60E1' }\n[foundation]\nk = 1\n");
    let unknown = reason(&SMALL.replace("EI = 3", "EI = 3\nlenght = 1"));
    assert_eq!(unknown, Reason::Unknown("lenght".into()));
    assert_eq!(reason("[beam]\nlength = 1\nEI = 1\n"), Reason::Missing("foundation"));
    let both = SMALL.replace("EI = 3", "EI = 3\nE = 1\nI = 1");
    assert_eq!(reason(&both), Reason::Together("EI", "E"));
    let error = read(&format!("{SMALL}[[load]]\npoint = 1\nat = true\n")).unwrap_err();
    assert_eq!((error.line, error.column), (9, 6));
}

/// Random numbers.
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: usize) -> usize {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % n.max(1)
    }
}

/// A text with random bytes flipped, removed, repeated or replaced by characters of the syntax.
fn changed(text: &str, dice: &mut Dice) -> String {
    const TOKENS: [&str; 16] = [
        "\"", "'", "[", "]", "{", "}", "\n", "=", ",", ".", "\\u", "1e400", "-", "nan", "[[", "'''",
    ];
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..1 + dice.below(4) {
        let at = dice.below(bytes.len());
        match dice.below(5) {
            0 => bytes[at] ^= 1 << dice.below(8),
            1 => drop(bytes.remove(at)),
            2 => {
                let part = bytes[at..(at + dice.below(40)).min(bytes.len())].to_vec();
                let to = dice.below(bytes.len());
                bytes.splice(to..to, part);
            }
            3 => drop(bytes.drain(at..(at + dice.below(10)).min(bytes.len()))),
            _ => drop(bytes.splice(at..at, TOKENS[dice.below(16)].bytes())),
        }
        if bytes.is_empty() {
            break;
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// All model files of the repository, including invalid ones.
fn texts() -> Vec<String> {
    let mut texts = vec![SMALL.to_owned()];
    for folder in ["cases", "docs"] {
        let found = files(&repository().join(folder), "toml");
        texts.extend(found.iter().flat_map(std::fs::read_to_string));
    }
    texts.sort();
    texts
}

/// The reader never panics, and each file is read or refused at once.
#[test]
fn changed_model_files_are_read_or_refused() {
    let (texts, mut dice) = (texts(), Dice(1));
    let mut read_alike = 0;
    for number in 0..30_000 {
        let text = changed(&texts[number % texts.len()], &mut dice);
        let start = Instant::now();
        let read = read(&text);
        read_alike += usize::from(read.is_ok());
        assert!(start.elapsed() < Duration::from_secs(2), "{text}");
    }
    assert!(read_alike > 1000, "{read_alike}");
}

#[test]
fn changed_documents_are_read_or_refused() {
    let piece = r#"{"x": [0, 1.5], "half": 0.75, "touches": true, "deflection": [1, 2.5e-3], "open": [0.5, 1]}"#;
    let text = format!(
        r#"{{"status": "solved", "pieces": [{piece}], "forces": [{{"x": 0, "force": 4.5}}],
        "reactions": [{{"support": 1, "force": 2, "moment": -1}}], "contact": [{{"from": 0, "to": 1.5}}],
        "end_forces": {{"left": 4.5, "right": 0}}, "stations": {{"x": [0, 1], "deflection": [1, 2]}},
        "extremes": {{"moment": {{"min": {{"x": 0, "value": 1}}}}}}, "proof": {{"bounds": {{"edges": [1e-13]}}}}}}"#
    );
    assert!(Document::read(&text).is_ok());
    let mut dice = Dice(2);
    let read = (0..30_000).filter(|_| Document::read(&changed(&text, &mut dice)).is_ok()).count();
    assert!(read > 1000, "{read}");
}

/// EI of sections with closed forms, E = 1 GPa: π d⁴/64 of a circle, the difference of two of a tube, a T by Steiner's rule.
#[test]
fn sections_have_their_second_moments() {
    let circle = |d: f64| std::f64::consts::PI * d.powi(4) / 64.0;
    // Flange 1 × 0.1 at the top, web 0.2 × 0.4, with the areas and the depth of the centroid.
    let (flange, web) = (0.1, 0.08);
    let centre = (flange * 0.05 + web * 0.3) / (flange + web);
    let own = 0.1_f64.powi(3) / 12.0 + 0.2 * 0.4_f64.powi(3) / 12.0;
    let t = own + flange * f64::powi(centre - 0.05, 2) + web * f64::powi(0.3 - centre, 2);
    for (section, exact) in [
        ("shape = 'circle', diameter = '0.5 m'", circle(0.5)),
        ("shape = 'tube', diameter = '0.5 m', wall = '0.1 m'", circle(0.5) - circle(0.3)),
        ("shape = 'T', width = '1 m', height = '0.5 m', flange = '0.1 m', web = '0.2 m'", t),
        ("width = '0.5 m', height = '0.2 m'", 0.5 * 0.008 / 12.0),
    ] {
        let text = format!(
            "[beam]\nlength = '2 m'\nE = '1 GPa'\nsection = {{ {section} }}\n[foundation]\nk = '1 MPa'\n"
        );
        let found = read(&text).unwrap().beam.bending_stiffness.middle() / 1e9;
        assert!((found / exact - 1.0).abs() < 1e-14, "{section}: {found} {exact}");
    }
    let varying = "section = { shape = 'T', width = '1 m', height = ['0.5 m', '0.6 m'], flange = '0.1 m', web = '0.2 m' }";
    let text =
        format!("[beam]\nlength = '2 m'\nE = '1 GPa'\n{varying}\n[foundation]\nk = '1 MPa'\n");
    assert!(matches!(reason(&text), Reason::Value(_)));
}

/// The short and the long name of a class of wood are the same material.
#[test]
fn classes_of_wood_have_short_names() {
    let stiffness = |name: &str| {
        let text = format!(
            "[beam]\nlength = '2 m'\nmaterial = '{name}'\nI = '1 m^4'\n[foundation]\nk = '1 MPa'\n"
        );
        read(&text).map(|model| model.beam.bending_stiffness.middle()).ok()
    };
    assert_eq!(stiffness("D30"), Some(11e9));
    for class in ["D30", "C24", "C14"] {
        let long = stiffness(&format!("timber {class}"));
        assert!(long.is_some() && stiffness(class) == long, "{class}");
    }
    assert_ne!(stiffness("C30/37"), stiffness("timber C30"));
    assert_eq!(stiffness("D"), None);
}

/// Escapes, ends of lines and strings on several lines: the load belongs to the case with the other spelling.
#[test]
fn strings_have_one_value_in_all_spellings() {
    let factor = |case: &str, key: &str| {
        let text = format!(
            "{SMALL}[[load]]\npoint = 1\nat = 1\ncase = {case}\n[[combination]]\nname = 'c'\nfactors = {{ {key} = 3 }}\n"
        );
        read_model::<Wide>(&text, Some("c")).map(|model| size(&model.loads[0])).ok()
    };
    for (case, key) in [
        (r#""a\b\t\n\f\r\"\\c""#, r#""a\u0008\u0009\u000a\u000c\u000d\u0022\u005cc""#),
        (r#""\u00e9\U0001F600""#, "'é😀'"),
        ("\"\"\"\nGH\"\"\"", "GH"),
        ("\"\"\"\r\nGH\"\"\"", "GH"),
        ("'''\nGH'''", "GH"),
        ("\"\"\"G\\\n   \n\t H\"\"\"", "GH"),
        ("\"\"\"G\\\r\n H\"\"\"", "GH"),
        ("\"\"\"G\\  \n H\"\"\"", "GH"),
        ("\"\"\"G\nH\"\"\"", r#""G\nH""#),
        ("\"\"\"G\"H\"\"\"", "'G\"H'"),
        ("\"\"\"\"GH\"\"\"\"\"", "'\"GH\"\"'"),
        ("''''GH'''''", "\"'GH''\""),
    ] {
        assert_eq!(factor(case, key), Some(3.0), "{case:?} {key:?}");
    }
    for (case, key) in [
        ("\"G\nH\"", "GH"),
        ("'G\nH'", "GH"),
        ("\"G\\\n H\"", "GH"),
        ("\"G\\ H\"", "GH"),
        ("\"G\\xH\"", "GH"),
        ("'G'", "\"\"\"G\"\"\""),
        ("'G'", "'''G'''"),
    ] {
        assert_eq!(factor(case, key), None, "{case:?} {key:?}");
    }
}

#[test]
fn lines_end_with_a_line_feed_or_with_both_characters() {
    let text = format!("# comment\n{SMALL}# another\n\n[[load]] # here\npoint = 1\nat = 1\n");
    let dos = text.replace('\n', "\r\n");
    assert_eq!(read(&text).unwrap(), read(&dos).unwrap());
    for wrong in ["# a\r", "# a\rb\n", "# a\u{1}\n", "\r", "[a]\r"] {
        assert!(read(&format!("{SMALL}{wrong}")).is_err(), "{wrong:?}");
    }
}

/// Terzaghi's k of clay is that of a square for a beam shorter than its width.
#[test]
fn a_short_beam_on_clay_counts_as_a_square() {
    let spring = |length: &str| {
        let text = format!(
            "[beam]\nlength = '{length}'\nEI = '1 MN m^2'\n[foundation]\nwidth = '3 m'\n[foundation.soil]\n\
             method = 'terzaghi-clay'\nplate_modulus = '20 MN/m^3'\nplate_width = '0.3 m'\n"
        );
        read(&text).unwrap().ground.spring.middle()
    };
    // k = (k_plate b_plate)(L/B + ½)/(1.5 L/B).
    for (length, ratio) in [("2 m", 1.0), ("3 m", 1.0), ("6 m", 2.0), ("30 m", 10.0)] {
        let exact = 6e6 * (ratio + 0.5) / (1.5 * ratio);
        assert!((spring(length) / exact - 1.0).abs() < 1e-14, "{length}");
    }
}

/// The reader refuses a point force on Winkler ground, and a point force beyond the end of the ground.
#[test]
fn a_point_force_on_the_ground_needs_a_layer() {
    let text = |at: f64, segments: &str| {
        format!(
            "[beam]\nlength = 4\nEI = 3\n[foundation]\nk = 4\nmu = 5\n{segments}[[ground_load]]\npoint = 1\nat = {at}\n"
        )
    };
    let springs = |from: u32| {
        format!("[[foundation.segment]]\nfrom = {from}\nto = {}\nk = 4\nmu = 0\n", from + 1)
    };
    for (at, right) in [
        (0.5, true),
        (1.0, true),
        (1.5, false),
        (2.0, true),
        (3.0, true),
        (-1.0, true),
        (5.0, true),
    ] {
        assert!(read(&text(at, "")).is_ok(), "{at}");
        assert_eq!(read(&text(at, &springs(1))).is_ok(), right, "{at}");
    }
    let both = springs(1) + &springs(2);
    assert!(read(&text(2.0, &both)).is_err() && read(&text(3.0, &both)).is_ok());
    for (end, at) in [
        ("left = { ends = -1, as = 'free' }\n", -2.0),
        ("right = { ends = 5, as = 'held' }\n", 6.0),
    ] {
        assert!(read(&text(at, end)).is_err() && read(&text(2.0, end)).is_ok(), "{end}");
    }
}

/// Files that would take long to read or that nest deeply.
#[test]
fn long_files_are_read_in_limited_time() {
    let many = |part: &str, n: usize| format!("{SMALL}{}", part.repeat(n));
    let cases: String =
        (0..100_000).map(|i| format!("[[load]]\npoint = 1\nat = 1\ncase = '{i}'\n")).collect();
    let files = [
        many("[[load]]\npoint = 1\nat = 1\n", 100_000),
        many("[[a.a.a.a.a.a.a.a]]\n", 100_000),
        many("a.b.c.d.e.f.g.h = 1\n", 100_000),
        many("[[load]]\nat = ", 1) + &"[".repeat(1_000_000),
        many("[[load]]\nat = ", 1) + &"{a = ".repeat(1_000_000),
        many("[[load]]\nat = 1\npoint = ", 1) + &"9".repeat(10_000_000),
        many("[[load]]\nat = 1\npoint = '1 ", 1) + &"(".repeat(1_000_000) + "'",
        many("[[load]]\nat = 1\npoint = '1 ", 1) + &"kNm".repeat(100_000) + "'",
        many("[[load]]\nat = 1\npoint = '1 ", 1) + &"m ".repeat(1_000_000) + "'",
        many("[[load]]\nat = 1\npoint = \"\"\"", 1) + &"\\\n".repeat(1_000_000),
        many("[[load]]\nat = 1\npoint = \"", 1) + &"\"\"".repeat(1_000_000),
        format!("{SMALL}{cases}[[combination]]\nset = 'EN 1990 6.10'\n"),
        "[".repeat(10_000_000),
        "#".repeat(10_000_000),
        "a".repeat(10_000_000),
        "\n".repeat(10_000_000),
    ];
    for text in files {
        let start = Instant::now();
        let _ = read_model::<Wide>(&text, Some("6.10: 1"));
        let _ = Document::read(&text);
        let took = start.elapsed();
        assert!(took < Duration::from_secs(10), "{took:?}: {}", &text[..200.min(text.len())]);
    }
    for text in ["[".repeat(10_000_000), "{\"a\":".repeat(1_000_000), "\"".repeat(1_000_000)] {
        assert!(Document::read(&text).is_err());
    }
}

fn ground(beam: &str, foundation: &str) -> Result<Model<Wide>, ReadError> {
    read(&format!("[beam]\nlength = 2\nEI = 3\n{beam}[foundation]\n{foundation}"))
}

#[test]
fn the_ground_ends_outside_the_beam() {
    let end = |side: &str, at: f64, kind: &str| {
        ground("", &format!("k = 4\nmu = 5\n{side} = {{ ends = {at}, as = '{kind}' }}\n")).is_ok()
    };
    for (side, [outside, at_end, under]) in [("left", [-1.0, 0.0, 0.5]), ("right", [3.0, 2.0, 1.5])]
    {
        assert!(end(side, outside, "free") && end(side, outside, "held"), "{side}");
        assert!(end(side, at_end, "free") && !end(side, at_end, "held"), "{side}");
        assert!(!end(side, under, "free") && !end(side, under, "held"), "{side}");
    }
}

/// If segments cover the whole beam, k and μ beyond them are those of the rightmost segment.
#[test]
fn the_rightmost_segment_continues() {
    let segment = |from: f64, to: f64, k: f64| {
        format!(
            "[[foundation.segment]]\nfrom = {from:?}\nto = {to:?}\nk = {k:?}\nmu = {:?}\n",
            k + 1.0
        )
    };
    let (left, right) = (segment(0.0, 1.0, 6.0), segment(1.0, 2.0, 7.0));
    for segments in [left.clone() + &right, right + &left] {
        let ground = ground("", &segments).expect("a model").ground;
        assert_eq!([ground.spring.middle(), ground.shear.middle()], [7.0, 8.0]);
    }
    assert!(ground("", &left).is_err());
}

#[test]
fn varying_ground_ends_with_the_beam() {
    let segment = |from: f64, to: f64, values: &str| {
        format!("[[foundation.segment]]\nfrom = {from:?}\nto = {to:?}\n{values}\n")
    };
    for (whole, from, to, values, accepted) in [
        ("k = [4, 5]", -1.0, 1.0, "k = 6", true),
        ("k = [4, 5]", 0.0, 1.0, "k = [6, 7]", true),
        ("k = [4, 5]", -1.0, 1.0, "k = [6, 7]", false),
        ("k = [4, 5]", 1.0, 3.0, "k = [6, 7]", false),
        ("k = [4, 5]", -1.0, 1.0, "mu = [6, 7]", false),
        ("k = [4, 5]", -2.0, -1.0, "mu = 6", true),
        ("k = 4", -2.0, -1.0, "k = [6, 6]", true),
        ("k = 4", -2.0, -1.0, "k = [6, 7]", false),
        ("k = 4", -2.0, -1.0, "k = [7, 6]", false),
        ("C1 = 4\nC2 = 2\nwidth = 3", 0.0, 1.0, "width = 2\nmu = 7", true),
    ] {
        let found = ground("", &format!("{whole}\n{}", segment(from, to, values)));
        assert_eq!(found.is_ok(), accepted, "{whole} {from} {to} {values}: {found:?}");
    }
}

#[test]
fn stiffnesses_are_within_the_range_of_the_proof() {
    for (stiffness, accepted) in
        [("1e-59", true), ("1e59", true), ("1e-61", false), ("1e61", false)]
    {
        let found = ground("", &format!("k = {stiffness}\n"));
        assert_eq!(found.is_ok(), accepted, "{stiffness}: {found:?}");
    }
    for (modulus, accepted) in [("1e-20", true), ("1e20", true), ("1e-40", false), ("1e40", false)]
    {
        let text =
            format!("[beam]\nlength = 2\nE = {modulus}\nI = {modulus}\n[foundation]\nk = 4\n");
        let found = read(&text);
        assert_eq!(found.is_ok(), accepted, "{modulus}: {found:?}");
    }
}

#[test]
fn a_quantity_has_one_source_and_its_own_unit() {
    let double = ground("", "subgrade_modulus = 4\nC1 = 4\nwidth = 2\n").expect_err("two sources");
    assert_eq!(double.reason, Reason::Together("subgrade_modulus", "C1"));
    for (beam, accepted) in [
        ("axial_force = 1_0\n", true),
        ("axial_force = 1__0\n", false),
        ("axial_force = 1_\n", false),
        ("axial_force = -_1\n", false),
        ("axial_force = 1._5\n", false),
        ("axial_force = 1e_5\n", false),
        ("axial_force = 1_e5\n", false),
        ("shear_area = 1\n", false),
        ("G = 1\n", false),
        ("G = 1\nshear_area = 1\n", true),
    ] {
        let found = ground(beam, "k = 4\n");
        assert_eq!(found.is_ok(), accepted, "{beam}: {found:?}");
    }
    for (unit, accepted) in
        [("kN", true), ("m", false), ("kN m", false), ("kN/m", false), ("Pa", false)]
    {
        let text = format!(
            "[beam]\nlength = '2 m'\nEI = '3 N m^2'\naxial_force = '1 {unit}'\n[foundation]\nk = '4 Pa'\n"
        );
        assert_eq!(read(&text).is_ok(), accepted, "{unit}");
    }
    let bending = |nu: &str| {
        let text = format!(
            "[beam]\nlength = 2\nE = 3\nI = 1\nnu = {nu}\nshear_area = 1\n[foundation]\nk = 4\n"
        );
        read(&text).map(|model| model.beam.shear_stiffness.map(Scalar::middle))
    };
    assert_eq!(bending("0.5").expect("a model"), Some(1.0));
    assert_eq!(bending("0").expect("a model"), Some(1.5));
    assert!(bending("0.6").is_err() && bending("-0.1").is_err());
}

/// A beam of two metres with `keys`, segments and more tables.
fn rest_of(beam: &str, tables: &str) -> Result<Model<Wide>, ReadError> {
    read(&format!("[beam]\nlength = '2 m'\n{beam}[foundation]\nk = '1 MPa'\n{tables}"))
}

/// The size of the first load at its left end.
fn first_load(beam: &str, tables: &str) -> Result<f64, Reason> {
    rest_of(beam, tables).map(|model| size(&model.loads[0])).map_err(|error| error.reason)
}

const WIDE: &str = "E = '30 GPa'\nsection = { width = '1 m', height = '0.5 m' }\n";

fn beam_segment(from: &str, to: &str, keys: &str) -> String {
    format!("[[beam.segment]]\nfrom = '{from} m'\nto = '{to} m'\n{keys}\n")
}

/// EI or I of a segment says nothing about its area, so the self-weight γbh is not known. A segment with another E has the
/// section of the beam.
#[test]
fn a_segment_with_its_own_stiffness_has_no_known_area_and_depth() {
    for (keys, weights) in [
        ("E = '20 GPa'", Some(vec![12.5e3, 12.5e3])),
        ("section = { width = '1 m', height = '1 m' }", Some(vec![25e3, 12.5e3])),
        ("EI = '1 MN m^2'", None),
        ("I = '1 m^4'", None),
    ] {
        let beam = format!("{WIDE}unit_weight = '25 kN/m^3'\n{}", beam_segment("0", "1", keys));
        let found =
            rest_of(&beam, "").map(|model| model.loads.iter().map(size).collect::<Vec<_>>());
        assert_eq!(found.as_ref().ok(), weights.as_ref(), "{keys}: {found:?}");
        // The curvature of the temperature difference αΔT/h needs the depth.
        let load =
            "[[load]]\ntemperature_difference = '10 K'\nexpansion = '1e-5 1/K'\nto = '1 m'\n";
        let beam = format!("{WIDE}{}", beam_segment("0", "1", keys));
        let depth = if keys.contains("height") { 1.0 } else { 0.5 };
        let exact =
            if weights.is_some() { Ok(1e-4 / depth) } else { Err(Reason::Missing("depth")) };
        assert_eq!(first_load(&beam, load), exact, "{keys}");
    }
}

/// A temperature load along stretches with equal depths has the curvature αΔT/h; along different depths it needs `depth`.
#[test]
fn stretches_with_equal_depths_count_as_one() {
    let section = |height: &str| format!("section = {{ width = '1 m', height = '{height}' }}");
    let load = |from: &str, to: &str| {
        format!(
            "[[load]]\ntemperature_difference = '10 K'\nexpansion = '1e-5 1/K'\nfrom = '{from} m'\nto = '{to} m'\n"
        )
    };
    let equal =
        beam_segment("0.5", "1", "E = '20 GPa'") + &beam_segment("1", "1.5", &section("500 mm"));
    let higher =
        beam_segment("0.5", "1", "E = '20 GPa'") + &beam_segment("1", "1.5", &section("1 m"));
    for (segments, from, to, depth) in [
        (&equal, "0", "2", Some(0.5)),
        (&equal, "0.75", "1.25", Some(0.5)),
        (&higher, "0", "1", Some(0.5)),
        (&higher, "1", "1.5", Some(1.0)),
        (&higher, "1.5", "2", Some(0.5)),
        (&higher, "0", "1.25", None),
        (&higher, "1.25", "2", None),
        (&higher, "0", "2", None),
    ] {
        let found = first_load(&format!("{WIDE}{segments}"), &load(from, to));
        assert_eq!(found, depth.map(|h| 1e-4 / h).ok_or(Reason::Missing("depth")), "{from} {to}");
    }
}

/// A segment of another material or E has another weight and expansion than the material of the beam.
#[test]
fn weight_and_expansion_of_a_material_need_one_material() {
    let beam = "material = 'C30/37'\nsection = { width = '1 m', height = '0.5 m' }\n";
    let load = "[[load]]\ntemperature_difference = '10 K'\n";
    for (keys, one) in [
        ("section = { width = '1 m', height = '0.5 m' }", true),
        ("material = 'C20/25'", false),
        ("material = 'C30/37'", false),
        ("E = '30 GPa'", false),
    ] {
        for segments in [
            beam_segment("0", "1", keys),
            beam_segment("0", "1", keys) + &beam_segment("1", "2", "I = '1 m^4'"),
            beam_segment("0", "1", "I = '1 m^4'") + &beam_segment("1", "2", keys),
        ] {
            let load = format!("{load}depth = '0.5 m'\n");
            let found = first_load(&format!("{beam}{segments}"), &load);
            assert_eq!(
                found,
                if one { Ok(2e-4) } else { Err(Reason::Missing("expansion")) },
                "{segments}"
            );
        }
        let weight = format!("{beam}unit_weight = 'material'\n{}", beam_segment("0", "1", keys));
        assert_eq!(
            first_load(&weight, ""),
            match one {
                true => Ok(12.5e3),
                false =>
                    Err(Reason::Value("no unit weight of this beam's material is listed".into())),
            },
            "{keys}"
        );
    }
}

/// A moment, a clamp or a rotational spring may be beside each of three hinges, but not at one of them.
#[test]
fn nothing_turns_the_beam_at_a_hinge() {
    let hinges = "[[hinge]]\nat = 0.5\n[[hinge]]\nat = 1.5\n[[hinge]]\nat = 1\n";
    for (at, free) in [
        (0.25, true),
        (0.5, false),
        (0.75, true),
        (1.0, false),
        (1.25, true),
        (1.5, false),
        (1.75, true),
    ] {
        for (table, turns) in [
            ("[[load]]\nmoment = 1\n", true),
            ("[[load]]\nmoment = 0\n", false),
            ("[[load]]\npoint = 1\n", false),
            ("[[support]]\ntype = 'fixed'\n", true),
            ("[[support]]\nspring = 1\nrotational_spring = 1\n", true),
            ("[[support]]\nspring = 1\nrotational_spring = 0\n", false),
            ("[[support]]\ntype = 'pinned'\n", false),
        ] {
            let found = read(&format!("{SMALL}{hinges}{table}at = {at:?}\n"));
            assert_eq!(found.is_ok(), free || !turns, "{at} {table}: {found:?}");
        }
    }
}

/// The layer under x = 1 to 2 only: a point force on the ground must be there.
#[test]
fn ground_without_mu_has_no_layer_beside_its_segments() {
    for (mu, elsewhere) in [("", false), ("mu = 0\n", false), ("mu = 1\n", true)] {
        for (at, inside) in [(0.5, false), (1.0, true), (1.5, true), (2.0, true)] {
            let text = format!(
                "[beam]\nlength = 2\nEI = 3\n[foundation]\nk = 4\n{mu}\
                 [[foundation.segment]]\nfrom = 1\nto = 2\nk = 4\nmu = 5\n[[ground_load]]\npoint = 1\nat = {at:?}\n"
            );
            assert_eq!(read(&text).is_ok(), inside || elsewhere, "{mu} {at}");
        }
    }
}

/// A band with three factors of k and three of μ makes nine grounds, and 111 combinations on nine grounds are 999.
#[test]
fn combinations_count_once_for_each_ground() {
    let load = "[[load]]\npoint = 1\nat = 1\ncase = 'G'\n";
    let band = format!("[foundation.band]\nk = [0.5, 2]\nmu = [0, 1.5]\n{load}");
    let combinations = |count: usize| -> String {
        let one = |i: usize| format!("[[combination]]\nname = '{i}'\nfactors = {{ G = 2 }}\n");
        (0..count).map(one).collect()
    };
    let is_read = |tables: &str, count: usize, name: &str| {
        let text = format!("{SMALL}{tables}{}", combinations(count));
        read_model::<Wide>(&text, Some(name)).is_ok()
    };
    for (count, right) in [(111, true), (112, false)] {
        assert_eq!(is_read(&band, count, "0; best ground"), right, "{count}");
    }
    for (count, right) in [(1000, true), (1001, false)] {
        assert_eq!(is_read(load, count, "0"), right, "{count}");
    }
    // With combinations, a ground alone is not a name. Without combinations, all loads act on each ground.
    assert!(is_read(&band, 0, "best ground") && !is_read(&band, 0, "0; best ground"));
    assert!(is_read(&band, 1, "0; best ground"));
    assert!(!is_read(&band, 1, "best ground") && !is_read(&band, 1, "0"));
}

/// Without permanent cases, a set makes a combination without any case only if the file has loads without a case.
#[test]
fn loads_without_a_case_are_a_combination() {
    let set = "[[case]]\nname = 'Q'\naction = 'imposed B'\n[[combination]]\nset = 'EN 1990 6.10'\n";
    let (cased, bare) =
        ("[[load]]\npoint = 1\nat = 1\ncase = 'Q'\n", "[[load]]\npoint = 2\nat = 1\n");
    let sizes = |loads: &str, name: &str| {
        let model = read_model::<Wide>(&format!("{SMALL}{loads}{set}"), Some(name));
        model
            .map(|model| model.loads.iter().map(size).collect::<Vec<_>>())
            .map_err(|why| why.reason)
    };
    let none = "6.10: loads without a case";
    assert_eq!(sizes(&format!("{cased}{bare}"), none), Ok(vec![2.0]));
    assert_eq!(sizes(&format!("{cased}{bare}"), "6.10: 1.5 Q"), Ok(vec![1.5, 2.0]));
    assert_eq!(sizes(cased, none), Err(Reason::NoCombination(none.into())));
    assert_eq!(sizes(cased, "6.10: 1.5 Q"), Ok(vec![1.5]));
}

/// The shear area of a section does not contradict a given shear stiffness, but a given shear area does.
#[test]
fn a_shear_stiffness_replaces_the_shear_area_of_a_section() {
    let shear = |keys: &str| {
        let found = rest_of(&format!("{WIDE}{keys}"), "");
        found.map(|model| model.beam.shear_stiffness.map(Scalar::middle)).map_err(|why| why.reason)
    };
    assert_eq!(shear(""), Ok(None));
    assert_eq!(shear("shear_stiffness = '5 MN'\n"), Ok(Some(5e6)));
    assert_eq!(shear("G = '12 MPa'\n"), Ok(Some(5e6)));
    assert_eq!(shear("G = '10 MPa'\nshear_area = '0.5 m^2'\n"), Ok(Some(5e6)));
    let both = Err(Reason::Together("shear_stiffness", "shear_area"));
    assert_eq!(shear("shear_stiffness = '5 MN'\nshear_area = '0.5 m^2'\n"), both);
    let both = Err(Reason::Together("shear_stiffness", "G"));
    assert_eq!(shear("shear_stiffness = '5 MN'\nG = '10 MPa'\n"), both);
}

/// EI excludes each of its factors by name.
#[test]
fn a_stiffness_excludes_each_of_its_factors() {
    for (keys, factor) in [("E = 1\n", "E"), ("I = 1\n", "I"), ("E = 1\nI = 1\n", "E")] {
        let both = reason(&SMALL.replace("EI = 3\n", &format!("EI = 3\n{keys}")));
        assert_eq!(both, Reason::Together("EI", factor));
    }
}

/// EI = [3, 3] is constant, and EI = [3, 4] varies. Equal quantities may have different units.
#[test]
fn equal_values_along_the_beam_are_one_value() {
    let segments = |values: &str, k: &str| {
        let text = format!("[beam]\nlength = '2 m'\nEI = {values}\n[foundation]\nk = {k}\n");
        let model = read(&text).expect("a model");
        [model.beam.segments.len(), model.ground.segments.len()]
    };
    let (one, two) = ("['3 kN m^2', '3000 N m^2']", "['3 kN m^2', '4 kN m^2']");
    assert_eq!(segments(one, "['1 MPa', '1e6 Pa']"), [0, 0]);
    assert_eq!(segments(two, "['1 MPa', '1e6 Pa']"), [1, 0]);
    assert_eq!(segments(one, "['1 MPa', '2 MPa']"), [0, 1]);
    assert_eq!(segments("['3 kN m^2', '3 kN m^2', '3 kN m^2', '4 kN m^2']", "'1 MPa'"), [1, 0]);
}

/// A list may have 100 000 tables. The first table lacks the size of its load.
#[test]
fn a_list_of_tables_is_limited() {
    for (count, found) in [(100_000, Reason::Missing("point")), (100_001, Reason::TooLarge)] {
        let tables = "{},".repeat(count);
        assert_eq!(reason(&format!("load = [{tables}]\n{SMALL}")), found, "{count}");
    }
}
