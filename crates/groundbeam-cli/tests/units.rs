//! Tests units and digits of printed results, and warnings about a file.

use crate::common::{Folder, LIFTS};

/// A strip footing in US units.
const STRIP: &str = include_str!("../../../cases/footings/strip-footing-in-us-units.toml");

#[test]
fn results_have_the_units_of_the_file() {
    let folder = Folder::with(STRIP);
    let done = folder.run(&["solve", "model.toml", "--csv", "out.csv", "--plot", "out.svg"]);
    done.is_clean(0);
    for words in ["l = 40 ft", "k = 1296 ksf, mu = 3400 kip", "150 pci", "516 kip", "kip-ft at"] {
        assert!(done.stdout.contains(words), "{words}: {}", done.stdout);
    }
    assert!(!done.stdout.contains("kN"), "{}", done.stdout);
    let table = folder.read("out.csv");
    assert!(table.starts_with("x_ft,deflection_in,slope_rad,moment_kip_ft,"), "{table}");
    let picture = folder.read("out.svg");
    assert!(picture.contains("[kip-ft]") && !picture.contains("kN"));
}

#[test]
fn command_line_options_select_units_and_digits() {
    let folder = Folder::with(STRIP);
    let si = folder.run(&["solve", "model.toml", "--units", "si", "--digits", "7"]);
    si.is_clean(0);
    assert!(si.stdout.contains("l = 12.192 m") && !si.stdout.contains("kip"), "{}", si.stdout);
    assert!(si.stdout.contains("resultant 2295.282 kN"), "{}", si.stdout);
    let json = folder.run(&["solve", "model.toml", "--json", "--units", "us"]).json();
    assert_eq!(json["units"], "SI");
    let length = json["contact"][0]["to"].as_f64().unwrap();
    assert!((7.0..8.0).contains(&length), "{length} m");
    let plain = Folder::with(LIFTS);
    plain.run(&["solve", "model.toml", "--units", "us"]).fails(2, "the file has no units");
}

#[test]
fn warnings_do_not_stop_a_run() {
    let stiff = STRIP.replace("150 pci", "150 kci");
    let folder = Folder::with(&stiff);
    let done = folder.run(&["solve", "model.toml"]);
    assert_eq!(done.status, 0);
    let words = "`subgrade_modulus` has an implausible size";
    assert!(done.stdout.contains(words), "{}", done.stdout);
    let done = folder.run(&["solve", "model.toml", "--json"]);
    assert_eq!((done.status, done.json()["status"].as_str()), (0, Some("solved")));
    assert!(done.stderr.contains("warning[GB901]"), "{}", done.stderr);
}

#[test]
fn the_report_contains_every_input() {
    let folder = Folder::with(&STRIP.replace("[[load]]\npoint = \"210 kip\"", "[gap_survey]\nfile = \"levels.csv\"\nx = \"at\"\nclearance = \"gap\"\n\n[[load]]\npoint = \"210 kip\""));
    folder.write("levels.csv", b"at [ft],gap [in]\n0,0\n40,0.25\n");
    let done = folder.run(&["solve", "model.toml", "--report", "out.html"]);
    assert_eq!(done.status, 0, "{}", done.stderr);
    let report = folder.read("out.html");
    for words in ["at [ft],gap [in]", "levels.csv, 29 bytes", "Checks and picture"] {
        assert!(report.contains(words), "{words}");
    }
}
