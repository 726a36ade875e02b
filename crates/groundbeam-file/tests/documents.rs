//! Tests of valid files in all their forms.

use groundbeam::derivatives::Parameter;
use groundbeam::model::{Part, Problem};
use groundbeam::{Load, Support, SupportKind, model::Acts};
use groundbeam_file::{Document, UnitSystem, parse, set_the_same_number, write_toml};

#[track_caller]
fn read(text: &str) -> Document {
    match parse(text) {
        Ok(document) => document,
        Err(diagnostics) => panic!("{}", diagnostics.render("file.toml", text, false)),
    }
}

const WHOLE: &str = r#"
title = "Strip footing under three columns"

[beam]
length = "12 m"
EI = "1.2e6 kN m^2"
axial_force = "10 kN"

[foundation]
k = "40 MN/m^2"
mu = "9 MN"

[[foundation.segment]]
from = "0 m"
to = "2 m"
k = "20 MN/m^2"

[[foundation.segment]]
from = "2 m"
to = "15 m"
mu = "0 MN"

[[load]]
point = "600 kN"
at = "1 m"

[[load]]
moment = "50 kN m"
at = "6 m"

[[load]]
distributed = ["0 kN/m", "20 kN/m"]
from = "0 m"
to = "10 m"

[[load]]
distributed_moment = "5 kN m/m"

[[support]]
at = "0 m"
type = "pinned"

[[support]]
at = "6 m"
type = "fixed"

[[support]]
at = "12 m"
rotational_spring = "5 MN m/rad"

[[gap]]
at = "0 m"
value = "2 mm"
"#;

#[test]
fn every_value_of_a_complete_file_is_read() {
    let document = read(WHOLE);
    let model = &document.model;
    assert_eq!(document.title.as_deref(), Some("Strip footing under three columns"));
    assert_eq!(document.units, UnitSystem::Si);
    assert_eq!((model.beam.length, model.beam.bending_stiffness), (12.0, 1.2e9));
    assert_eq!(model.beam.axial_force, 1e4);
    assert_eq!((model.foundation.subgrade, model.foundation.shear_layer), (4e7, 9e6));
    assert_eq!(model.foundation.constants_at(1.0), (2e7, 9e6), "mu from [foundation]");
    assert_eq!(model.foundation.constants_at(3.0), (4e7, 0.0), "k from [foundation]");
    let loads = [
        Load::point_force(1.0, 6e5),
        Load::point_moment(6.0, 5e4),
        Load::distributed_force(0.0, 10.0, 0.0, 2e4),
        Load::distributed_moment(0.0, 12.0, 5e3, 5e3),
    ];
    assert_eq!(model.loads, loads);
    let spring = SupportKind::Spring { spring: 0.0, rotational_spring: 5e6 };
    let supports = [
        Support::pinned(0.0),
        Support::fixed(6.0),
        Support { at: 12.0, kind: spring, settlement: 0.0, acts: Acts::Both },
    ];
    assert_eq!(model.supports, supports);
    assert_eq!((model.gap[0].at, model.gap[0].value), (0.0, 0.002));
}

#[test]
fn numbers_without_units_are_read_unchanged() {
    let document = read(
        "[beam]\nlength = 100\nEI = 1.0\n[foundation]\nk = \"1\"\nmu = 0.1\n\
         [[load]]\npoint = 1.2503646726300526\nat = 0x10\n",
    );
    assert_eq!(document.units, UnitSystem::Plain);
    assert_eq!(document.model.loads, [Load::point_force(16.0, 1.2503646726300526)]);
}

/// A beam of 12 m with `beam` in its table, on ground with `ground` in its table.
fn with(beam: &str, ground: &str) -> Document {
    read(&format!("[beam]\nlength = \"12 m\"\n{beam}\n[foundation]\n{ground}\n"))
}

#[test]
fn the_bending_stiffness_is_the_product_of_its_factors() {
    let ei = |beam| with(beam, "k = \"1 N/m^2\"").model.beam.bending_stiffness;
    assert_eq!(ei("EI = \"1.2e6 kN m^2\""), 1.2e9);
    assert_eq!(ei("E = \"30 GPa\"\nI = \"0.04 m^4\""), 1.2e9);
    let section = "section = { width = \"1 m\", height = \"80 cm\" }";
    assert_eq!(ei(&format!("E = \"30 GPa\"\n{section}")), 3e10 * (0.8_f64.powi(3) / 12.0));
    let k = |ground| with("EI = \"1 N m^2\"", ground).model.foundation.subgrade;
    assert_eq!(k("subgrade_modulus = \"40 MN/m^3\"\nwidth = \"500 mm\""), 2e7);
}

#[test]
fn segments_inherit_missing_values() {
    let document = with(
        "E = \"30 GPa\"\nI = \"0.04 m^4\"
         [[beam.segment]]\nfrom = \"0 m\"\nto = \"1 m\"\nI = \"0.02 m^4\"
         [[beam.segment]]\nfrom = \"1 m\"\nto = \"2 m\"\nE = \"10 GPa\"
         [[beam.segment]]\nfrom = \"2 m\"\nto = \"3 m\"\nEI = \"1 N m^2\"",
        "subgrade_modulus = \"40 MN/m^3\"\nwidth = \"1 m\"\nmu = \"1 N\"
         [[foundation.segment]]\nfrom = \"0 m\"\nto = \"1 m\"\nwidth = \"2 m\"
         [[foundation.segment]]\nfrom = \"1 m\"\nto = \"2 m\"\nsubgrade_modulus = \"10 MN/m^3\"
         [[foundation.segment]]\nfrom = \"2 m\"\nto = \"3 m\"\nmu = \"2 N\"",
    );
    let ei: Vec<f64> =
        document.model.beam.segments.iter().map(|s| s.bending_stiffness.start()).collect();
    assert_eq!(ei, [6e8, 4e8, 1.0]);
    let ground: Vec<(f64, f64)> = document
        .model
        .foundation
        .segments
        .iter()
        .map(|s| (s.subgrade.start(), s.shear_layer.start()))
        .collect();
    assert_eq!(ground, [(8e7, 1.0), (1e7, 1.0), (4e7, 2.0)]);
}

#[test]
fn two_values_vary_linearly_from_end_to_end() {
    // The beam is 12 m long. Values of the whole beam apply outside the segments.
    let document = with(
        "E = \"2 Pa\"\nI = [\"1 m^4\", \"4 m^4\"]
         [[beam.segment]]\nfrom = \"4 m\"\nto = \"8 m\"\nE = \"3 Pa\"
         [[beam.segment]]\nfrom = \"8 m\"\nto = \"10 m\"\nEI = [\"5 N m^2\", \"7 N m^2\"]",
        "subgrade_modulus = [\"1 N/m^3\", \"4 N/m^3\"]\nwidth = [\"2 m\", \"1 m\"]\nmu = \"3 N\"
         [[foundation.segment]]\nfrom = \"-2 m\"\nto = \"3 m\"\nmu = [\"1 N\", \"2 N\"]",
    );
    let beam = &document.model.beam;
    let runs: Vec<(f64, f64, Vec<f64>)> = beam
        .segments
        .iter()
        .map(|s| (s.from, s.to, s.bending_stiffness.control_values().to_vec()))
        .collect();
    assert_eq!(
        runs,
        [
            (4.0, 8.0, vec![6.0, 9.0]),
            (8.0, 10.0, vec![5.0, 7.0]),
            (0.0, 4.0, vec![2.0, 4.0]),
            (10.0, 12.0, vec![7.0, 8.0]),
        ]
    );
    let ground = &document.model.foundation;
    let (k, mu) = ground.constants_at(6.0);
    assert!((k - 2.5 * 1.5).abs() < 1e-14 && mu == 3.0);
    assert_eq!((ground.segments[0].from, ground.segments[0].to), (0.0, 3.0));
    assert_eq!(ground.constants_at(0.0), (2.0, 1.0));
    assert!((ground.constants_at(1.5).0 - 1.375 * 1.875).abs() < 1e-14);
}

#[test]
fn a_section_of_varying_height_has_a_cubic_stiffness() {
    let haunch = with(
        "E = \"12 Pa\"\nsection = { width = \"1 m\", height = [\"2 m\", \"1 m\"] }",
        "k = \"1 N/m^2\"",
    );
    let beam = &haunch.model.beam;
    for (x, height) in [(0.0, 2.0_f64), (3.0, 1.75), (6.0, 1.5), (11.0, 13.0 / 12.0)] {
        let wanted = height.powi(3);
        assert!((beam.bending_stiffness_at(x) - wanted).abs() < 1e-14 * wanted, "{x}");
    }
}

#[test]
fn segments_that_cover_the_beam_need_no_values_of_the_whole_beam() {
    let document = with(
        "[[beam.segment]]\nfrom = \"6 m\"\nto = \"12 m\"\nEI = \"2 N m^2\"
         [[beam.segment]]\nfrom = \"0 m\"\nto = \"600 cm\"\nEI = \"1 N m^2\"",
        "[[foundation.segment]]\nfrom = \"-1 m\"\nto = \"4 m\"\nk = \"1 N/m^2\"\nmu = \"3 N\"
         [[foundation.segment]]\nfrom = \"4 m\"\nto = \"12 m\"\nk = \"2 N/m^2\"",
    );
    // The right end belongs to no segment, so the last segment applies there.
    assert_eq!(document.model.beam.bending_stiffness_at(12.0), 2.0);
    assert_eq!(document.model.foundation.constants_at(12.0), (2.0, 0.0));
}

#[test]
fn one_table_can_be_written_in_several_ways() {
    let usual =
        read("[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n[[load]]\npoint = 1\nat = 0");
    let inline = read(
        "beam.length = 1\nbeam.EI = 1\nfoundation = { k = 1 }\nload = [ { point = 1, at = 0 } ]",
    );
    assert_eq!(usual.model, inline.model);
}

#[test]
fn fields_of_a_read_document_have_their_location() {
    let document = read(WHOLE);
    let place = |part, field| {
        let span = document.field_span(part, field).unwrap();
        &document.text()[span]
    };
    assert_eq!(place(Part::Beam, "axial_force"), "\"10 kN\"");
    assert_eq!(place(Part::Load(2), "end"), "\"20 kN/m\"");
    assert_eq!(place(Part::Load(3), "to"), "[[load]]", "left out: the heading");
    assert_eq!(place(Part::FoundationSegment(1), "subgrade"), "[[foundation.segment]]");
    assert_eq!(document.part_span(Part::Support(7)), None);

    let mut problem = Problem {
        code: "GB999",
        part: Part::Gap(0),
        field: "value",
        message: "between {0} and {1}".into(),
        hint: "try {0}".into(),
        numbers: vec![1.5, 12.0],
    };
    let diagnostic = document.diagnostic_for(&problem);
    assert_eq!(diagnostic.to_string(), "53:9: [GB999] between 1.5 m and 12 m (try 1.5 m)");
    problem.part = Part::Support(7);
    assert_eq!(document.diagnostic_for(&problem).line, 1);
}

#[test]
fn all_of_many_errors_are_found_and_a_hundred_are_shown() {
    let slip = "[[load]]\npoint = \"1 kM\"\nat = \"1 m\"\n";
    let text = format!(
        "[beam]\nlength = \"2 m\"\nEI = \"1 N m^2\"\n[foundation]\nk = \"1 Pa\"\n{}",
        slip.repeat(3000)
    );
    let diagnostics = parse(&text).unwrap_err();
    assert_eq!(diagnostics.as_slice().len(), 3000);
    let shown = diagnostics.render("long.toml", &text, false);
    assert_eq!(shown.matches("error[GB014]").count(), 100);
    assert!(shown.ends_with("\n... and 2900 more in long.toml\n"));
}

/// Self-weight follows the sections. Its load has its own load case and comes after the file's loads.
#[test]
fn self_weight_follows_the_sections() {
    let text = r#"
        [beam]
        length = "12 m"
        E = "30 GPa"
        section = { width = "1 m", height = ["0.5 m", "1 m"] }
        unit_weight = "25 kN/m^3"
        weight_case = " G "
        [[beam.segment]]
        from = "3 m"
        to = "6 m"
        section = { shape = "circle", diameter = "1 m" }
        [foundation]
        k = "40 MN/m^2"
        [[load]]
        point = "1 kN"
        at = "1 m"
        case = "Q"
    "#;
    let document = parse(text).unwrap();
    let [_, first, second, third] = document.model.loads[..] else { panic!("four loads") };
    let along = |from, to, start, end| Load::distributed_force(from, to, start, end);
    assert_eq!(first, along(0.0, 3.0, 12_500.0, 15_625.0));
    let round = 25_000.0 * std::f64::consts::PI / 4.0;
    assert_eq!(second, along(3.0, 6.0, round, round));
    assert_eq!(third, along(6.0, 12.0, 18_750.0, 25_000.0));
    let cases: Vec<_> = document.cases.iter().map(Option::as_deref).collect();
    assert_eq!(cases, [Some("Q"), Some("G"), Some("G"), Some("G")]);
}

const TROUGH: &str = "[beam]\nlength = '120 m'\nEI = '150 MN m^2'\n[foundation]\nk = '20 MN/m^2'\n
    [[load]]\ndistributed = '1.5 kN/m'\ncase = 'G'\n
    [[gap_trough]]\nat = '60 m'\nsettlement = '0.2 m'\nwidth = '20 m'\n";

#[test]
fn the_number_of_chords_depends_on_ground_and_loads() {
    let chords = |more: &str| read(&format!("{TROUGH}{more}")).chords.unwrap();
    let plain = chords("");
    assert_eq!(read(TROUGH).model.gap.len(), plain + 1);
    // 1/h is proportional to the square root of k, and decreases with the load.
    let doubled = 2.0_f64.sqrt() * plain as f64;
    for more in [
        "[foundation.band]\nk = [0.5, 2]\n",
        "[[combination]]\nname = 'low'\nfactors = { G = 0.5 }\n",
    ] {
        assert!((chords(more) as f64 / doubled - 1.0).abs() < 0.1, "{more}: {}", chords(more));
    }
    assert_eq!(
        chords(
            "[[combination]]\nname = 'none'\nfactors = {}\n[[combination]]\nname = 'one'\nfactors = { G = 1 }\n"
        ),
        plain
    );
}

#[test]
fn a_written_trough_is_read_back_as_the_same_polygon() {
    let document = read(TROUGH);
    let again = read(&write_toml(&document.model, None, document.units));
    assert_eq!((again.model, again.chords), (document.model, None));
}

#[test]
fn a_trough_far_from_the_beam_is_accepted() {
    let document = read(&TROUGH.replace("at = '60 m'", "at = '-500 m'"));
    assert!(document.model.gap.iter().all(|corner| corner.value < 1e-60));
}

#[test]
fn soil_data_are_written_back_as_soil_data() {
    let elastic = "E = '20 MPa'\nnu = 0.3\n";
    let plate = "plate_modulus = '60 MN/m^3'\nplate_width = '0.3 m'\n";
    let layer = "[[foundation.soil.layer]]\nE = '20 MPa'\nnu = 0.3\nthickness = '4 m'\n";
    let layers = format!("gamma = 1.25\n{layer}");
    let methods = [
        ("modified-vlasov", layer),
        ("vlasov", &layers),
        ("vesic", elastic),
        ("biot", elastic),
        ("meyerhof-baike", elastic),
        ("selvadurai", elastic),
        ("terzaghi-clay", plate),
        ("terzaghi-sand", plate),
    ];
    for (method, soil) in methods {
        let text = format!(
            "[beam]\nlength = '12 m'\nEI = '1 GN m^2'\n[foundation]\nwidth = '1.2 m'\n\
             [foundation.soil]\nmethod = '{method}'\n{soil}"
        );
        let model = parse(&text).expect(method).model;
        let written = write_toml(&model, None, UnitSystem::Si);
        assert!(written.contains(method), "{written}");
        assert_eq!(parse(&written).expect(method).model, model);
    }
}

/// A beam on ground, before the loads and combinations of a test.
const BARE: &str = "[beam]\nlength = 12\nEI = 1\n[foundation]\nk = 1\n";
const UNIFORM: &str = "[[load]]\ndistributed = 2\n";

/// A point load with a case of this name and action.
fn case(name: &str, action: &str) -> String {
    format!(
        "[[load]]\npoint = 1\nat = 3\ncase = '{name}'\n[[case]]\nname = '{name}'\naction = '{action}'\n"
    )
}

fn set(name: &str) -> String {
    format!("[[combination]]\nset = '{name}'\n")
}

/// The only message about a file with an error.
#[track_caller]
fn fault(text: &str) -> (&'static str, usize, String) {
    let found = parse(text).expect_err(text);
    let [one] = &*found.iter().collect::<Vec<_>>() else { panic!("{found:?}") };
    (one.code, one.line, format!("{}; {}", one.message, one.hint))
}

#[test]
fn loads_without_a_case_are_a_combination_of_a_set_by_themselves() {
    let names = |text: &[String]| read(&(BARE.to_owned() + &text.concat())).combination_names();
    let (uniform, wind) = (UNIFORM.to_owned(), case("W", "wind"));
    let alone = |label: &str| format!("{label}: loads without a case");
    assert_eq!(names(&[uniform.clone(), set("EN 1990 6.10")]), [alone("6.10")]);
    let both = [uniform, wind, set("EN 1990 6.10"), set("EN 1990 quasi-permanent")];
    assert_eq!(names(&both), ["6.10: 1.5 W", &alone("6.10"), &alone("quasi-permanent")]);
    let document = read(&(BARE.to_owned() + &both.concat()));
    assert_eq!(document.combinations()[1].model.loads, [Load::uniform_force(0.0, 12.0, 2.0)]);
}

#[test]
fn a_set_without_any_combination_is_refused() {
    let text = format!("{BARE}{}{}", case("W", "wind"), set("EN 1990 quasi-permanent"));
    let (code, line, said) = fault(&text);
    assert_eq!((code, line), ("GB004", text.lines().count()));
    assert!(said.contains("has no combination") && said.contains("leave out this set"), "{said}");
    let text = format!("{BARE}{UNIFORM}{}{}", case("W", "wind"), set("EN 1990 seismic"));
    let (code, _, said) = fault(&text);
    assert!(code == "GB004" && said.contains("action = \"seismic\""), "{said}");
}

#[test]
fn a_train_with_a_case_is_absent_where_no_factor_is_given() {
    let train = "[[train]]\ncase = 'T'\naxles = [{ at = 0, force = 1 }]\n";
    let combination = "[[combination]]\nname = 'none'\nfactors = {}\n";
    let document = read(&format!("{BARE}{UNIFORM}{train}{combination}"));
    let factor = |text: &Document| text.wanted()[0].factor_of(&document.trains[0]);
    assert_eq!(factor(&document), None);
    assert_eq!(factor(&read(&format!("{BARE}{UNIFORM}{train}"))), Some(1.0));
}

#[test]
fn a_thousand_combinations_are_the_limit_on_all_grounds_together() {
    let file = |count: usize, band: &str| {
        let one = |i| format!("[[combination]]\nname = '{i}'\nfactors = {{ W = 1 }}\n");
        let all: String = (0..count).map(one).collect();
        format!("{BARE}{band}{}{all}", case("W", "wind"))
    };
    let band = "mu = 1\n[foundation.band]\nk = [0.5, 2]\nmu = [0.5, 2]\n";
    assert_eq!(read(&file(1000, "")).combinations().len(), 1000);
    assert_eq!(read(&file(111, band)).combinations().len(), 999);
    let (code, _, said) = fault(&file(1001, ""));
    assert!(code == "GB010" && said.contains("more than 1000 combinations;"), "{said}");
    let (code, _, said) = fault(&file(112, band));
    assert!(
        code == "GB010"
            && said.contains("111 combinations for each of 9 pairs of factors on k and mu"),
        "{said}"
    );
}

#[test]
fn parameters_that_set_the_same_number_are_found() {
    let same = |a: &str, b: &str| {
        let [a, b] = [a, b].map(|name| Parameter::named(name).unwrap());
        assert_eq!(set_the_same_number(a, b), set_the_same_number(b, a));
        set_the_same_number(a, b)
    };
    for (a, b) in
        [("k", "k"), ("k", "k[]"), ("load[1]", "load[1].start"), ("load[1].end", "load[1]")]
    {
        assert!(same(a, b), "{a} {b}");
    }
    for (a, b) in [
        ("k", "mu"),
        ("k", "k_factor"),
        ("k[0]", "k[]"),
        ("load[1]", "load[2].start"),
        ("load[1].start", "load[1].end"),
        ("load[1]", "load[1].from"),
    ] {
        assert!(!same(a, b), "{a} {b}");
    }
}

#[test]
fn a_train_has_loads_and_a_case_with_a_name() {
    let train = |keys: &str| fault(&format!("{BARE}{UNIFORM}[[train]]\n{keys}\n"));
    let (code, line, said) = train("axles = [{ at = 0, force = 1 }]\ncase = ' '");
    assert_eq!((code, line), ("GB020", 10));
    assert!(said.contains("the load case has no name"), "{said}");
    let (code, _, said) = train("uniform = []");
    assert!(code == "GB004" && said.contains("add at least one to `uniform`"), "{said}");
}

#[test]
fn a_hint_shows_a_value_that_is_allowed() {
    let train = |keys: &str| {
        let base = "[beam]\nlength = '12 m'\nEI = '1 GN m^2'\n[foundation]\nk = '40 MN/m^2'\n";
        fault(&format!("{base}[[train]]\nset = 'LM71'\n{keys}\n")).2
    };
    let said = train("factor = '2 kN'");
    assert!(said.ends_with("; give a number without a unit, as in factor = 0.3"), "{said}");
    let train = |keys: &str| fault(&format!("{BARE}[[train]]\n{keys}\n")).2;
    for axles in ["'LM71'", "['LM71']"] {
        let said = train(&format!("axles = {axles}"));
        assert!(said.contains("as in axles = [{ at = ") && !said.contains("an axle"), "{said}");
    }
}
