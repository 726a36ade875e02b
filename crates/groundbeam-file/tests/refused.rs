//! Tests of model files that are refused with a remedy that works, and of neighbouring files that are read.

use groundbeam_file::{Document, parse, parse_beside};

const BASE: &str =
    "[beam]\nlength = 10\nEI = 1\n[foundation]\nk = 1\n[[load]]\npoint = 1\nat = 3\n";

fn read(text: &str) -> Document {
    parse(text).unwrap_or_else(|found| panic!("{}", found.render("file.toml", text, false)))
}

/// Checks that the file has one fault, with this code and a hint that contains the words.
#[track_caller]
fn refused(text: &str, code: &str, hint: &str) {
    let found = parse(text).expect_err("the file is read");
    let shown = found.render("file.toml", text, false);
    let [one] = found.as_slice() else { panic!("{shown}") };
    assert!(one.code == code && one.hint.contains(hint), "{shown}");
}

fn with_widths(whole: &str, segment: &str, checks: &str) -> String {
    format!(
        "[beam]\nlength = 12\nEI = 1\n[foundation]\nsubgrade_modulus = 1\nwidth = {whole}\n\
         [[foundation.segment]]\nfrom = 0\nto = 6\nwidth = {segment}\n\
         [[load]]\ndistributed = 1\n[checks]\n{checks}\n"
    )
}

#[test]
fn bearing_checks_need_a_width_that_is_safe_for_every_segment() {
    for check in ["bearing_pressure = 1", "bearing_resistance = 1"] {
        let with = |width: &str| format!("{check}\n{width}");
        refused(&with_widths("3", "1", check), "GB007", "add `width` to [checks]");
        refused(&with_widths("3", "[3, 4]", check), "GB007", "add `width` to [checks]");
        refused(&with_widths("3", "1", &with("width = 2")), "GB017", "the smallest width");
        refused(&with_widths("[1, 3]", "3", &with("width = 2")), "GB017", "the smallest width");
        // Each remedy works.
        read(&with_widths("3", "1", &with("width = 1")));
        read(&with_widths("[1, 3]", "3", &with("width = 1")));
        read(&with_widths("3", "3", check));
    }
    read(&with_widths("3", "1", "settlement = 1"));
}

#[test]
fn a_survey_row_with_more_cells_than_the_header_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let text = BASE.to_owned() + "[gap_survey]\nfile = \"levels.csv\"\n";
    let with = |table: &str| {
        std::fs::write(folder.path().join("levels.csv"), table).unwrap();
        parse_beside(&text, folder.path())
    };
    let found = with("x,z\n0,1,0\n6,1,5\n").unwrap_err();
    let places: Vec<_> = found.iter().map(|found| (found.code, found.line, found.column)).collect();
    assert_eq!(places, [("GB023", 2, 5), ("GB023", 3, 5)]);
    assert!(found.as_slice()[0].hint.contains("decimal points"));
    // Cells without text at the end of a row are no cells of decimals.
    assert_eq!(with("x,z\n0,1.0,\n6,1.5,\n").unwrap().model.gap.len(), 3);
}

#[test]
fn a_datum_or_start_that_cannot_be_read_gives_one_message() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("levels.csv"), "x,z\n0,1\n6,2\n").unwrap();
    for (line, code) in
        [("datum = \"abc\"", "GB011"), ("datum = [1, 2, 3]", "GB005"), ("start = \"abc\"", "GB011")]
    {
        let text = format!("{BASE}[gap_survey]\nfile = \"levels.csv\"\n{line}\n");
        let found = parse_beside(&text, folder.path()).unwrap_err();
        let codes: Vec<&str> = found.iter().map(|found| found.code).collect();
        assert_eq!(codes, [code], "{line}: {found}");
    }
}

#[test]
fn the_load_case_of_the_weight_needs_a_name() {
    let weight = "section = { width = 1, height = 1 }\nE = 1\nunit_weight = 1\nweight_case = \" \"";
    refused(&BASE.replace("EI = 1", weight), "GB020", "as in weight_case = \"Q\"");
}

#[test]
fn an_eccentricity_is_a_fraction_of_the_length() {
    for wrong in ["l", "l/", "l/nan", "l/inf", "l/1e300", "l/x"] {
        let text = format!("{BASE}[checks]\neccentricity = \"{wrong}\"\n");
        refused(&text, "GB011", "write \"l/6\"");
    }
    for wrong in ["\"l/0\"", "\"l/-3\"", "\"l/1\"", "0.6"] {
        refused(&format!("{BASE}[checks]\neccentricity = {wrong}\n"), "GB017", "write \"l/6\"");
    }
    for right in ["\"l/6\"", "\"L / 6\""] {
        let limits = read(&format!("{BASE}[checks]\neccentricity = {right}\n")).limits;
        assert_eq!(limits.eccentricity, Some(1.0 / 6.0));
    }
}

#[test]
fn a_check_needs_a_limit_state_in_its_list() {
    let text = format!("{BASE}[checks]\nsettlement = 1\nlimit_states = {{ settlement = [] }}\n");
    refused(&text, "GB020", "leave the key out");
}

#[test]
fn a_fillet_of_zero_is_none() {
    let section = |fillet: &str| {
        let sides = "width = 0.3, height = 0.6, flange = 0.1, web = 0.1";
        let section = format!("E = 1\nsection = {{ shape = \"I\", {sides}{fillet} }}");
        BASE.replace("EI = 1", &section)
    };
    let sharp = read(&section("")).model;
    assert_eq!(read(&section(", fillet = 0")).model, sharp);
    assert_eq!(read(&section(", fillet = [0, 0]")).model, sharp);
    refused(&section(", fillet = -0.1"), "GB017", "it must be positive");
}

#[test]
fn remedies_name_what_the_file_may_contain() {
    let beam = |line: &str| BASE.replace("EI = 1", line);
    refused(&beam("EI = 1\nnu = 0.2\nshear_area = 0.4"), "GB007", "replace `EI`");
    let sides = "width = 1, height = 1";
    read(&beam(&format!("E = 1\nnu = 0.2\nsection = {{ {sides} }}")));
    refused(&beam("EI = 1\nG = 1"), "GB007", "in place of `EI` or `I`");
    read(&beam(&format!("E = 1\nG = 1\nsection = {{ {sides} }}")));
    for key in ["k = 1\nmu", "k"] {
        let ground = |values: &str| BASE.replace("k = 1", &format!("{key} = {values}"));
        refused(&ground("[1, 2, 3, 4, 5, 6, 7]"), "GB005", "or three control values");
        read(&ground("[1, 2, 4]"));
    }
    let load = |line: &str| BASE.replace("point = 1\nat = 3", line);
    refused(
        &load("distributed = 1\nat = 3"),
        "GB008",
        "the defaults are 0 and the length of the beam",
    );
    read(&load("distributed = 1\nfrom = 3"));
}
