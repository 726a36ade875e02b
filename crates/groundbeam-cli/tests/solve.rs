//! Tests `groundbeam solve`: exit status and outputs.

use crate::common::{FOOTING, Folder, LIFTS, tips};
use serde_json::json;

#[test]
fn solve_prints_a_text_report() {
    let done = Folder::with(LIFTS).run(&["solve", "model.toml"]);
    done.is_clean(0);
    assert!(done.stdout.starts_with("Kikuchi 1980, case IV\n"));
    assert!(done.stdout.contains("Contact      from 0.8113 to 1\n"));
}

/// A force very near an end of a beam on separate springs. With four digits both edges would be 1.
#[test]
fn the_ends_of_a_short_contact_zone_are_printed_with_different_digits() {
    let beam = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 4\n";
    let folder = Folder::with(&format!("{beam}[[load]]\npoint = 1\nat = 0.999999999\n"));
    let done = folder.run(&["solve", "model.toml"]);
    done.is_clean(0);
    assert!(done.stdout.contains("Contact      from 0.999999997 to 1\n"), "{}", done.stdout);
}

#[test]
fn the_json_option_prints_only_the_result_document() {
    let done = Folder::with(LIFTS).run(&["solve", "model.toml", "--json", "--at", "0,0.25,1"]);
    done.is_clean(0);
    let found = done.json();
    assert_eq!((&found["status"], &found["units"]), (&json!("solved"), &json!("none")));
    assert_eq!(found["existence"]["verdict"], "unique");
    assert_eq!(found["stations"]["x"], json!([0.0, 0.25, 1.0]));
    assert_eq!(found["stations"]["pressure"].as_array().unwrap().len(), 3);
    let edge = found["contact"][0]["from"].as_f64().unwrap();
    assert!((edge - 0.811326256449155).abs() < 1e-12);
    let force = found["end_forces"]["right"].as_f64().unwrap();
    assert!((force - 0.897199981229959).abs() < 1e-12);
    assert!(found["seconds"].as_f64().unwrap() > 0.0);
}

#[test]
fn solve_reads_a_model_from_standard_input() {
    let folder = Folder::new();
    let done = folder.run_with_input(&["solve", "-", "--json"], LIFTS.as_bytes());
    done.is_clean(0);
    let done = folder.run_with_input(&["solve", "-"], b"[beam]\nlenth = 1\n");
    done.fails(2, "--> <stdin>:2:1");
}

#[test]
fn positions_need_units_if_the_file_has_units() {
    let folder = Folder::with(FOOTING);
    let at = |list| folder.run(&["solve", "model.toml", "--json", "--at", list]);
    let done = at("0 m, 50 cm, 12 m");
    done.is_clean(0);
    assert_eq!(done.json()["stations"]["x"], json!([0.0, 0.5, 12.0]));
    at("0 m, 0.5").fails(2, "`0.5` has no unit");
    at("0 m, 13 m").fails(2, "13 m lies outside the beam");
    at("0 m, 13 m").fails(2, "--> --at:1:6");
    at("-1 m").fails(2, "−1 m lies outside the beam");
    at("x").fails(2, "error[GB0");
    at("").fails(2, "a position is missing");
}

#[test]
fn solve_writes_tables_and_pictures() {
    let folder = Folder::with(LIFTS);
    let plain = folder.run(&["solve", "model.toml"]);
    let arguments = [
        "solve",
        "model.toml",
        "--csv",
        "t.csv",
        "--plot",
        "p.SVG",
        "--history",
        "h.csv",
        "--json",
    ];
    folder.run(&arguments).is_clean(0);
    assert_eq!(folder.names(), ["h.csv", "model.toml", "p.SVG", "t.csv"]);
    assert!(folder.read("t.csv").starts_with("x,deflection,slope,"));
    assert!(folder.read("h.csv").starts_with("step,zones,part,decrement\n"));
    assert!(folder.read("p.SVG").starts_with("<svg "));
    // Output files do not change the report, and an old file is replaced.
    folder.write("p.png", b"old");
    let done = folder.run(&["solve", "model.toml", "--plot", "p.png"]);
    done.is_clean(0);
    let without_time = |report: &str| report.rsplit_once(", ").unwrap().0.to_owned();
    assert_eq!(without_time(&done.stdout), without_time(&plain.stdout));
    assert!(std::fs::read(folder.path("p.png")).unwrap().starts_with(b"\x89PNG"));
}

#[test]
fn a_model_without_equilibrium_ends_with_status_3() {
    let folder = Folder::with(&tips());
    let done = folder.run(&["solve", "model.toml", "--csv", "t.csv"]);
    done.fails(3, "tips about its right end");
    done.fails(3, "the left end lifts off, the right end stays in place");
    assert_eq!(folder.names(), ["model.toml"]);
    let done = folder.run(&["solve", "model.toml", "--json"]);
    done.is_clean(3);
    let found = done.json();
    assert_eq!(found["status"], "no-equilibrium");
    assert_eq!(found["existence"]["verdict"], "none");
    let motion = &found["existence"]["failing_motion"];
    assert_eq!((&motion["left"], &motion["right"]), (&json!(-1.0), &json!(0.0)));
    assert!((motion["work"].as_f64().unwrap() - 0.1).abs() < 1e-12);
}

#[test]
fn solve_refuses_an_invalid_model() {
    let folder = Folder::with(&LIFTS.replace("EI = 1", "EI = -1"));
    for arguments in [&["solve", "model.toml"][..], &["solve", "model.toml", "--json"]] {
        folder.run(arguments).fails(2, "error[GB102]: the bending stiffness EI is negative");
        folder.run(arguments).fails(2, "--> model.toml:4:6");
    }
}

#[test]
fn an_unsupported_model_is_reported_at_its_line() {
    let folder = Folder::with(PRESSED);
    let done = folder.run(&["solve", "model.toml", "--method", "active-set"]);
    done.fails(2, "error[GB611]");
    done.fails(2, "--> model.toml:4:15");
    folder.run(&["solve", "model.toml", "--factors"]).fails(2, "error[GB612]");
    // Boundary layers of a millionth of the length, which varying ground would have to resolve with elements.
    let folder = Folder::with(&LIFTS.replace("mu = 1", "mu = [1e12, 2e12]"));
    let done = folder.run(&["solve", "model.toml"]);
    done.fails(2, "error[GB616]: where the beam or the ground varies");
    done.fails(2, "mu = [1e12, 2e12]");
    folder.run(&["solve", "model.toml", "--pressure", "dirac"]).fails(2, "--method exact");
}

#[test]
fn a_model_that_needs_more_memory_than_the_limit_is_refused_at_once() {
    let folder = Folder::with(&FOOTING.replace("12 m", "1e10 m"));
    let done = folder.run(&["solve", "model.toml"]);
    done.fails(2, "error[GB617]: the method `exact` would need about");
    done.fails(2, "more than the limit of 4 GB");
    let folder = Folder::with(FOOTING);
    let meshed = ["solve", "model.toml", "--method", "active-set", "--elements", "5000000"];
    // The nodes do not fit; the nodes fit, the elements in contact do not.
    let nodes = [&meshed[..], &["--memory-limit", "100 MB"]].concat();
    folder.run(&nodes).fails(2, "error[GB617]: the method `active-set` would need about 500 MB");
    folder.run(&meshed).fails(2, "error[GB617]: the method `active-set` would need about 18 GB");
    let little = ["solve", "model.toml", "--memory-limit", "1 kB"];
    folder.run(&little).fails(2, "more than the limit of 1 kB");
    folder.run(&["solve", "model.toml", "--memory-limit", "1 MB"]).is_clean(0);
    folder.run(&["solve", "model.toml", "--memory-limit", "8"]).fails(2, "a size needs a unit");
}

/// A heavy beam in compression that needs the support of the ground.
pub(crate) const PRESSED: &str = "\
[beam]
length = 5
EI = 1
axial_force = -0.5
[foundation]
k = 1
[[load]]
distributed = 1
";

#[test]
fn a_local_equilibrium_is_reported_under_compression() {
    let folder = Folder::with(PRESSED);
    let done = folder.run(&["solve", "model.toml"]);
    done.is_clean(0);
    assert!(
        done.stdout.contains("Equilibrium  local: next to the unloaded state"),
        "{}",
        done.stdout
    );
    assert!(done.stdout.contains("other equilibria"), "{}", done.stdout);
    let existence = &folder.run(&["solve", "model.toml", "--json"]).json()["existence"];
    assert_eq!(existence["verdict"], "local");
    // Value of a mesh with 400 elements; verification/tests/compression.rs confirms nine digits.
    assert!((existence["critical_compression"].as_f64().unwrap() - 0.85611).abs() < 1e-4);
    assert!((existence["stability_margin"].as_f64().unwrap() - 0.416).abs() < 1e-3);

    let folder = Folder::with(&PRESSED.replace("-0.5", "-2"));
    folder.run(&["solve", "model.toml"]).fails(3, "the beam buckles upward at x =");
    let checked = folder.run(&["check", "model.toml", "--json"]);
    assert_eq!(checked.status, 3);
    let existence = &checked.json()["existence"];
    assert_eq!(existence["verdict"], "none");
    assert!((existence["critical_compression"].as_f64().unwrap() - 0.85611).abs() < 1e-4);
    assert!(existence["failing_motion"]["left"].as_f64().is_some());
}

#[test]
fn each_combination_under_compression_has_its_own_verdict() {
    let cases = PRESSED.to_owned()
        + "case = \"G\"\n[[load]]\npoint = -2\nat = 2.5\ncase = \"Q\"\n\
           [[combination]]\nname = \"lies\"\nfactors = { G = 1 }\n\
           [[combination]]\nname = \"lifted\"\nfactors = { G = 1, Q = 1 }\n";
    let folder = Folder::with(&cases.replace("-0.5", "-0.75"));
    let done = folder.run(&["solve", "model.toml", "--json"]);
    assert_eq!(done.status, 3);
    let verdict = |i: usize| done.json()["combinations"][i]["existence"]["verdict"].clone();
    assert_eq!((verdict(0), verdict(1)), (json!("local"), json!("none")));
    let said = folder.run(&["solve", "model.toml"]).stdout;
    assert!(said.contains("none: it buckles"), "{said}");
}

#[test]
fn a_finer_mesh_has_a_smaller_energy_gap() {
    let folder = Folder::with(LIFTS);
    let run = |elements| {
        let arguments =
            ["solve", "model.toml", "--json", "--method", "active-set", "--elements", elements];
        let done = folder.run(&arguments);
        done.is_clean(0);
        done.json()
    };
    let found = run("40");
    assert_eq!(found["method"], "active-set");
    assert!(
        found["certificate"]["relative_gap"].as_f64()
            > run("80")["certificate"]["relative_gap"].as_f64()
    );
}

#[test]
fn a_method_that_does_not_converge_ends_with_status_4() {
    let folder = Folder::with(LIFTS);
    let stopped = ["solve", "model.toml", "--method", "uzawa", "--most-sweeps", "2"];
    folder.run(&stopped).fails(4, "the method `uzawa` stopped");
    let done = folder.run(&[&stopped[..], &["--json"]].concat());
    done.is_clean(4);
    assert_eq!(done.json()["status"], "not-converged");
}

#[test]
fn equal_runs_give_equal_files() {
    let folder = Folder::with(LIFTS);
    for name in ["a", "b"] {
        let [csv, svg, png] = ["csv", "svg", "png"].map(|kind| format!("{name}.{kind}"));
        folder.run(&["solve", "model.toml", "--csv", &csv, "--plot", &svg]).is_clean(0);
        folder.run(&["solve", "model.toml", "--plot", &png]).is_clean(0);
    }
    for kind in ["csv", "svg", "png"] {
        let read = |name: &str| std::fs::read(folder.path(&format!("{name}.{kind}"))).unwrap();
        assert!(read("a") == read("b"), "{kind}");
    }
}

#[test]
fn solve_prints_load_factors_on_request() {
    let folder =
        Folder::with(&LIFTS.replace("0.49", "0.6").replace("moment", "case = \"Q\"\nmoment"));
    // No equilibrium exists under the full moment. The load factor gives the allowed fraction.
    let done = folder.run(&["solve", "model.toml", "--factors=Q", "--json"]);
    done.is_clean(3);
    let found = &done.json()["load_factors"];
    assert_eq!(found["cases"], json!(["Q"]));
    let lift_off = &found["first_lift_off"];
    assert_eq!((&lift_off["when"], &lift_off["x"]), (&json!("at-factor"), &json!(0.0)));
    assert!((lift_off["factor"].as_f64().unwrap() - 0.316105124527 / 0.6).abs() < 1e-11);
    let loss = &found["loss_of_equilibrium"];
    assert!((loss["factor"].as_f64().unwrap() - 0.5 / 0.6).abs() < 1e-15);
    assert_eq!(loss["motion"]["left"], json!(-1.0));
    let done = folder.run(&["solve", "model.toml", "--factors=Q"]);
    done.fails(3, "Load factors first lift-off at 0.5268 times the loads of case Q, at x = 0\n");
    // A weightless beam whose loads all grow has no equilibrium under this moment.
    let done = folder.run(&["solve", "--factors", "model.toml", "--json"]);
    done.is_clean(3);
    let found = &done.json()["load_factors"];
    assert_eq!(
        (&found["cases"], &found["first_lift_off"]["when"]),
        (&json!(null), &json!("at-once"))
    );
    assert_eq!(found["loss_of_equilibrium"]["when"], "at-once");
    // Load factors are printed even if the solve fails.
    let stopped = ["solve", "model.toml", "--factors", "--method", "uzawa", "--most-sweeps", "1"];
    let stands = Folder::with(LIFTS);
    stands.run(&stopped).fails(4, "Load factors a part of the beam is lifted off");
    assert!(stands.run(&["solve", "model.toml", "--json"]).json()["load_factors"].is_null());
}

#[test]
fn unknown_load_cases_are_refused() {
    let folder = Folder::with(&LIFTS.replace("moment", "case = \"Q\"\nmoment"));
    let run = |list: &str| folder.run(&["solve", "model.toml", list]);
    run("--factors=Q,q").fails(2, "error[GB009]: no load belongs to the load case `q`");
    run("--factors=Q,q").fails(2, "--> --factors:1:3");
    run("--factors=wind").fails(2, "the cases of the file: Q");
    run("--factors=").fails(2, "a load case is missing here");
    Folder::with(LIFTS)
        .run(&["solve", "model.toml", "--factors=Q"])
        .fails(2, "no load of the file has the key `case`");
}

/// A rail under two axles.
const TRAIN: &str = "\
[beam]\nlength = '12 m'\nEI = '6.4 MN m^2'\n[foundation]\nk = '40 MN/m^2'\n\
[[load]]\ndistributed = '3 kN/m'\n\
[[train]]\nname = 'bogie'\naxles = [{ at = '0 m', force = '112 kN' }, { at = '1.8 m', force = '112 kN' }]\n";

#[test]
fn a_train_gives_the_envelope_of_its_positions() {
    let folder = Folder::with(TRAIN);
    let done = folder.run(&["solve", "model.toml", "--json", "--at", "0 m,6 m"]);
    done.is_clean(0);
    let found = done.json();
    let train = &found["train"];
    assert_eq!((&found["status"], &train["name"]), (&json!("solved"), &json!("bogie")));
    assert_eq!(train["range"], json!({ "from": 0.0, "to": 13.8 }));
    assert!(train["positions"].as_u64().unwrap() > 32);
    assert!(
        train["error"]["reached"].as_f64().unwrap() <= train["error"]["stated"].as_f64().unwrap()
    );
    assert_eq!(found["envelope"]["x"], json!([0.0, 6.0]));
    let governs = found["envelope"]["moment"]["governs_max"][1].as_f64().unwrap();
    assert!((governs - 6.0).abs() < 1e-6 || (governs - 7.8).abs() < 1e-6);
    assert!(found["extremes"]["moment"]["max"]["first_axle"].is_number());
    assert!(found["uplift"]["behind"]["value"].as_f64().unwrap() > 0.0);
    let report = folder.run(&["solve", "model.toml", "--plot", "p.svg", "--csv", "t.csv"]);
    report.is_clean(0);
    assert!(
        report
            .stdout
            .contains("Train        bogie: 2 axles, 224 kN in total, over a length of 1.8 m\n")
    );
    assert!(report.stdout.lines().all(|line| line.chars().count() <= 80), "{}", report.stdout);
    assert!(folder.read("p.svg").starts_with("<svg "));
    assert!(
        folder
            .read("t.csv")
            .starts_with("x_m,deflection_min_m,deflection_max_m,deflection_governs_min_m,")
    );
    folder.run(&["solve", "model.toml", "--factors"]).fails(2, "the file has a train");
    let checked = folder.run(&["check", "model.toml", "--json"]);
    checked.is_clean(0);
    assert_eq!(checked.json()["trains"][0]["without_equilibrium"], json!([]));
}

#[test]
fn positions_of_a_train_without_equilibrium_are_reported() {
    let lifts = TRAIN.replace("axles = [", "axles = [{ at = '11 m', force = '-40 kN' }, ");
    let done = Folder::with(&lifts).run(&["solve", "model.toml", "--json"]);
    done.is_clean(3);
    let found = done.json();
    assert_eq!(found["status"], "no-equilibrium");
    let ranges = found["train"]["without_equilibrium"].as_array().unwrap();
    assert!(!ranges.is_empty() && found["envelope"]["x"].is_array());
    let checked = Folder::with(&lifts).run(&["check", "model.toml", "--json"]);
    checked.is_clean(3);
    let told = checked.json()["trains"][0]["without_equilibrium"].clone();
    for (told, found) in told.as_array().unwrap().iter().zip(ranges) {
        for end in ["from", "to"] {
            let [a, b] = [told, found].map(|range| range[end].as_f64().unwrap());
            assert!((a - b).abs() < 1e-9, "{told} {found}");
        }
    }
    assert_eq!(told.as_array().unwrap().len(), ranges.len());
}

#[test]
fn a_train_passes_under_a_selected_combination() {
    let both = TRAIN.replace("'3 kN/m'\n", "'3 kN/m'\ncase = 'G'\n")
        + "[[combination]]\nname = 'ULS'\nfactors = { G = 1.35 }\n";
    let folder = Folder::with(&both);
    folder.run(&["solve", "model.toml", "--combination", "ULS"]).is_clean(0);
    let more = both
        + "[[combination]]\nname = 'SLS'\nfactors = { G = 1 }\n\
        [[train]]\nname = 'axle'\naxles = [{ at = '0 m', force = '100 kN' }]\n";
    let folder = Folder::with(&more);
    let done = folder.run(&["solve", "model.toml", "--json", "--at", "6 m"]);
    done.is_clean(0);
    let found = done.json();
    let passages = found["passages"].as_array().unwrap();
    let named = |i: usize| (&passages[i]["combination"], &passages[i]["train"]["name"]);
    // Both trains and no train, under each combination.
    assert_eq!(passages.len(), 6);
    assert_eq!(
        (named(1), named(2), named(3)),
        (
            (&json!("ULS"), &json!("axle")),
            (&json!("ULS"), &json!("no train")),
            (&json!("SLS"), &json!("bogie"))
        )
    );
    // The envelope of all combinations is the largest of the single envelopes.
    let largest =
        |document: &serde_json::Value| document["envelope"]["moment"]["max"][0].as_f64().unwrap();
    let most = passages.iter().map(largest).fold(f64::MIN, f64::max);
    assert_eq!(largest(&found), most);
    let by = found["envelope"]["moment"]["passage_max"][0].as_u64().unwrap() as usize;
    assert_eq!(largest(&passages[by]), most);
    let report = folder.run(&["solve", "model.toml", "--plot", "p.svg", "--csv", "t.csv"]);
    report.is_clean(0);
    assert!(report.stdout.lines().all(|line| line.chars().count() <= 80), "{}", report.stdout);
    assert!(report.stdout.contains("   5  SLS; axle\n"), "{}", report.stdout);
    assert!(folder.read("t.csv").contains("deflection_in_min,"));
}

#[test]
fn solve_writes_a_calculation_report() {
    let folder = Folder::with(LIFTS);
    folder.run(&["solve", "model.toml", "--report", "out.html"]).is_clean(0);
    let page = folder.read("out.html");
    assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
    assert!(page.contains("0.8113"), "where contact begins");
    // The report contains the file line by line.
    assert!(page.contains("<li>[beam]</li>"));
    folder
        .run(&["solve", "model.toml", "--report", "out.doc"])
        .fails(2, "must end in .html or .pdf");
    folder
        .run(&["solve", "model.toml", "--report", "model.toml"])
        .fails(2, "must end in .html or .pdf");
    folder.run(&["solve", "model.toml", "--report", "no/out.html"]).fails(2, "no/out.html");

    let folder = Folder::with(&tips());
    folder.run(&["solve", "model.toml", "--report", "out.html"]).fails(3, "none: ");
    let page = folder.read("out.html");
    assert!(page.contains("No equilibrium"));
}

#[test]
fn the_drawing_is_left_out_in_pipes() {
    let done = Folder::with(LIFTS).run(&["solve", "model.toml"]);
    assert!(!done.stdout.contains('░') && !done.stdout.contains('━'));
}

#[test]
fn the_number_of_chords_of_a_trough_is_reported() {
    let text = "[beam]\nlength = '120 m'\nEI = '150 MN m^2'\n[foundation]\nk = '20 MN/m^2'\n
        [[load]]\ndistributed = '20 kN/m'\n
        [[gap_trough]]\nat = '60 m'\nsettlement = '20 mm'\nwidth = '8 m'\n";
    let folder = Folder::with(text);
    let found = folder.run(&["solve", "model.toml", "--json"]).json();
    let chords = found["trough_chords"].as_u64().unwrap();
    let told = format!("the curve is replaced by {chords} chords; results are for this polygon");
    let done = folder.run(&["solve", "model.toml", "--report", "out.html"]);
    done.is_clean(0);
    assert!(done.stdout.contains(&format!("Trough       {told}")), "{}", done.stdout);
    assert!(folder.read("out.html").contains(&told));
}
