//! Tests files with combinations: exit status and outputs.

use crate::common::{Folder, LIFTS};
use serde_json::{Value, json};

/// A unit load with a small factor, and a moment with a large factor.
fn combined() -> String {
    let cases = LIFTS.replace("point = 1\n", "point = 1\ncase = \"G\"\n");
    cases.replace("moment = 0.49\n", "moment = 0.49\ncase = \"W\"\n")
        + "[[combination]]\nname = \"both\"\nfactors = { G = 1, W = 1 }\n\
           [[combination]]\nname = \"heavy\"\nfactors = { G = 2, W = 1 }\n"
}

/// The same, with an additional combination that tips.
fn tips() -> String {
    combined() + "[[combination]]\nname = \"storm\"\nfactors = { G = 1, W = 1.5 }\n"
}

#[test]
fn all_combinations_are_solved() {
    let folder = Folder::with(&combined());
    let done = folder.run(&["solve", "model.toml"]);
    done.is_clean(0);
    assert!(done.stdout.contains("Combinations    1  both\n"));
    assert!(done.stdout.contains("W, not a physical state"));
    let done = folder.run(&["solve", "model.toml", "--json", "--at", "0,1"]);
    done.is_clean(0);
    let found = done.json();
    assert_eq!((&found["status"], &found["units"]), (&json!("solved"), &json!("none")));
    assert_eq!(found["envelope"]["x"], json!([0.0, 1.0]));
    // In `both` the left end has almost lifted off.
    let edge = found["combinations"][0]["contact"][0]["from"].as_f64().unwrap();
    assert!((edge - 0.811326256449155).abs() < 1e-12);
    assert_eq!(found["extremes"]["gap"]["max"]["combination"], "both");
    assert_eq!(found["envelope"]["gap"]["governs_max"][0], "both");
}

#[test]
fn a_combination_without_equilibrium_does_not_hide_the_others() {
    let folder = Folder::with(&tips());
    let outputs = ["--csv", "t.csv", "--plot", "p.svg"];
    let done = folder.run(&[&["solve", "model.toml"][..], &outputs].concat());
    done.is_clean(3);
    assert!(done.stdout.contains("   3  none: the beam tips about its right end"));
    assert!(done.stdout.contains("exact, 2 of 3 combinations solved"));
    assert!(folder.read("t.csv").starts_with("x,deflection_min,deflection_max,"));
    assert!(folder.read("p.svg").starts_with("<svg "));
    let done = folder.run(&["solve", "model.toml", "--json"]);
    done.is_clean(3);
    let found = done.json();
    let status = |i: usize| found["combinations"][i]["status"].clone();
    assert_eq!([status(0), status(1), status(2)], ["solved", "solved", "no-equilibrium"]);
    assert_eq!(found["status"], "no-equilibrium");
    for arguments in [&["check", "model.toml"][..], &["check", "model.toml", "--json"]] {
        folder.run(arguments).is_clean(3);
    }
    let checked = folder.run(&["check", "model.toml", "--json"]).json();
    assert_eq!(checked["combinations"][0]["status"], "equilibrium-exists");
    assert!(folder.run(&["check", "model.toml"]).stdout.contains("   1  one          both\n"));
}

#[test]
fn exit_status_of_combinations_that_do_not_converge() {
    let stopped = ["solve", "model.toml", "--json", "--method", "uzawa", "--most-sweeps", "2"];
    let done = Folder::with(&combined()).run(&stopped);
    done.is_clean(4);
    assert_eq!(done.json()["status"], "not-converged");
    // A missing equilibrium takes precedence over missing convergence.
    Folder::with(&tips()).run(&stopped).is_clean(3);
    // The heavy combination touches everywhere, as the initial guess of the method does. Its result is still
    // given.
    assert_eq!(done.json()["combinations"][0]["status"], "not-converged");
    assert_eq!(done.json()["combinations"][1]["status"], "solved");
    assert_eq!(done.json()["extremes"]["moment"]["max"]["combination"], "heavy");
}

#[test]
fn a_selected_combination_has_the_results_that_it_has_among_all() {
    let folder = Folder::with(&tips());
    let one = |name: &str| folder.run(&["solve", "model.toml", "--json", "--combination", name]);
    let done = one("both");
    done.is_clean(0);
    let alone = done.json();
    assert_eq!(alone["title"], "Kikuchi 1980, case IV: both");
    let all = folder.run(&["solve", "model.toml", "--json"]).json();
    for key in ["contact", "stations", "extremes", "certificate", "existence"] {
        assert_eq!(alone[key], all["combinations"][0][key], "{key}");
    }
    one("storm").is_clean(3);
    one("bot").fails(2, "there is `both`, `storm`, `heavy`");
    Folder::with(LIFTS)
        .run(&["solve", "model.toml", "--combination", "both"])
        .fails(2, "the file has no [[combination]]");
}

#[test]
fn load_factors_and_history_need_a_selected_combination() {
    let folder = Folder::with(&combined());
    folder.run(&["solve", "model.toml", "--factors=W"]).fails(2, "add --combination NAME");
    folder.run(&["solve", "model.toml", "--history", "h.csv"]).fails(2, "add --combination NAME");
    let arguments = ["solve", "model.toml", "--json", "--combination", "heavy", "--factors=W"];
    let done = folder.run(&arguments);
    done.is_clean(0);
    let loss = &done.json()["load_factors"]["loss_of_equilibrium"];
    // A moment of 0.49 tips the beam under a force of 2 if multiplied by more than 1/0.49.
    assert!((loss["factor"].as_f64().unwrap() - 1.0 / 0.49).abs() < 1e-14);
}

#[test]
fn any_number_of_threads_gives_the_same_bytes() {
    let folder = Folder::with(&tips());
    let run = |threads: &str| {
        let mut command = folder.command(&["solve", "model.toml", "--json"]);
        let output = command.env("RAYON_NUM_THREADS", threads).output().unwrap();
        let text = String::from_utf8(output.stdout).unwrap();
        let lines = text.lines().filter(|line| !line.contains("\"seconds\""));
        lines.map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(run("1"), run("4"));
}

#[test]
fn a_set_of_a_design_code_generates_its_combinations() {
    let actions = "[[case]]\nname = \"G\"\naction = \"permanent\"\n\
                   [[case]]\nname = \"W\"\naction = \"wind\"\n\
                   [[combination]]\nset = \"EN 1990 EQU\"\n";
    let folder = Folder::with(&(combined().replace("0.49", "0.2") + actions));
    let found = folder.run(&["solve", "model.toml", "--json"]).json();
    let names: Vec<&str> = found["combinations"]
        .as_array()
        .unwrap()
        .iter()
        .map(|combination| combination["name"].as_str().unwrap())
        .collect();
    let made = ["EQU: 1.1 G + 1.5 W", "EQU: 0.9 G + 1.5 W", "EQU: 1.1 G", "EQU: 0.9 G"];
    assert_eq!(names[2..], made);
}

/// [`combined`] with limit states and a check of the lifted share, which `both` fails.
fn judged() -> String {
    combined()
        .replace("name = \"both\"\n", "name = \"both\"\nlimit_state = \"STR/GEO\"\n")
        .replace("name = \"heavy\"\n", "name = \"heavy\"\nlimit_state = \"SLS characteristic\"\n")
        + "[checks]\nlifted_share = 0.5\n"
}

/// The check is judged only in its own limit state.
#[test]
fn a_check_is_judged_in_its_limit_state() {
    let folder = Folder::with(&judged());
    let done = folder.run(&["solve", "model.toml", "--strict"]);
    done.is_clean(0);
    assert!(done.stdout.contains("lifted off, 50 % allowed: passes; SLS characteristic, heavy"));
    let found = folder.run(&["solve", "model.toml", "--json", "--at", "0,1"]).json();
    let check = &found["checks"][0];
    assert_eq!(
        (&check["limit_state"], &check["passes"]),
        (&json!("SLS characteristic"), &json!(true))
    );
    let names = |i: usize| found["envelopes"][i]["limit_state"].clone();
    assert_eq!([names(0), names(1)], ["STR/GEO", "SLS characteristic"]);
    assert_eq!(found["envelopes"][1]["gap"]["governs_max"][0], "heavy");
    let csv = folder.run(&["solve", "model.toml", "--at", "0,1", "--csv", "t.csv"]);
    csv.is_clean(0);
    let table = folder.read("t.csv");
    let states: Vec<&str> = table.lines().filter_map(|line| line.rsplit(',').next()).collect();
    let [all, strength, service] = ["all", "STR/GEO", "SLS characteristic"];
    assert_eq!(states, ["limit_state", all, all, strength, strength, service, service]);
}

#[test]
fn the_strict_option_fails_for_failed_or_missing_verdicts() {
    let folder = Folder::with(&judged().replace("SLS characteristic", "EQU"));
    let done = folder.run(&["solve", "model.toml"]);
    done.is_clean(0);
    let words = done.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
    let expected = "lifted share not judged: no combination has the limit state SLS characteristic or allowable stress";
    assert!(words.contains(expected), "{words}");
    folder.run(&["solve", "model.toml", "--strict"]).is_clean(1);
    // Without combinations the check applies to the loads as given.
    let folder = Folder::with(&(LIFTS.to_owned() + "[checks]\nlifted_share = 0.5\n"));
    let done = folder.run(&["solve", "model.toml"]);
    done.is_clean(0);
    assert!(done.stdout.contains("81.13 % lifted off, 50 % allowed: fails"));
    assert!(done.stdout.contains("the checks use the loads as given"));
    folder.run(&["solve", "model.toml", "--strict"]).is_clean(1);
}

/// The file has a combination of the check's limit state, but another combination is selected.
#[test]
fn a_check_without_a_selected_combination_of_its_limit_state_is_not_judged() {
    let folder = Folder::with(&judged());
    let done = folder.run(&["solve", "model.toml", "--combination", "both"]);
    let words = done.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
    let expected =
        "lifted share not judged: no selected combination has the limit state SLS characteristic";
    assert!(words.contains(expected), "{words}");
    folder.run(&["solve", "model.toml", "--combination", "both", "--strict"]).is_clean(1);
}

/// A check is never left out in silence: loads without a resultant have no eccentricity.
#[test]
fn an_eccentricity_that_does_not_exist_is_not_judged() {
    let held = "[[support]]\nat = 0\ntype = \"pinned\"\n[checks]\neccentricity = \"l/6\"\n\
                overturning = 1.5\n";
    let folder = Folder::with(&(LIFTS.replace("point = 1\n", "point = 0\n") + held));
    let done = folder.run(&["solve", "model.toml"]);
    done.is_clean(0);
    assert!(done.stdout.contains("eccentricity not judged: the loads have no resultant"));
    // The beam is pinned at one end, and no load turns it about this end.
    let expected = "no overturning load; the required safety factor is 1.5: passes";
    assert!(done.stdout.contains(expected), "{}", done.stdout);
    let checks = folder.run(&["solve", "model.toml", "--json"]).json()["checks"].clone();
    assert_eq!(
        (&checks[0]["passes"], &checks[0]["reason"]),
        (&json!(null), &json!("no resultant"))
    );
    folder.run(&["solve", "model.toml", "--strict"]).is_clean(1);
}

/// The verdicts of a model in the result document.
fn verdicts(folder: &Folder) -> Vec<Value> {
    let document = folder.run(&["solve", "model.toml", "--json"]).json();
    document["checks"].as_array().unwrap().clone()
}

/// A peak pressure leaves out the force at a corner of the ground.
#[test]
fn a_peak_pressure_names_the_forces_that_it_leaves_out() {
    let checks = "[[gap]]\nat = 0.4\nvalue = 0\n[[gap]]\nat = 0.6\nvalue = 0.1\n\
                  [checks]\nbearing_pressure = 9\nwidth = 1\n[[combination]]\nname = \"D\"\n\
                  limit_state = \"allowable stress\"\nfactors = {}\n";
    let folder = Folder::with(&(LIFTS.replace("moment = 0.49", "moment = 0.1") + checks));
    let done = folder.run(&["solve", "model.toml"]);
    done.is_clean(0);
    let words = done.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
    let expected = "(right), force 0.3131 at x = 0.4 in addition; allowable stress, D";
    assert!(words.contains(expected), "{words}");
}

/// A beam with a dead load and limits, under combinations of a set or by hand.
fn under(action: &str, combinations: &str) -> Folder {
    let checks =
        "[checks]\nsettlement = 5\neccentricity = 0.4\nbearing_resistance = 9\nwidth = 1\n";
    let case = format!("[[case]]\nname = \"D\"\naction = \"{action}\"\n");
    let model = LIFTS
        .replace("moment = 0.49", "moment = 0.1")
        .replace("at = 0.5", "at = 0.5\ncase = \"D\"");
    Folder::with(&(model + checks + &case + combinations))
}

/// A clause belongs to the code of the combinations. Combinations by hand belong to none.
#[test]
fn only_combinations_of_the_eurocodes_cite_their_clauses() {
    let set = |name: &str| format!("[[combination]]\nset = \"{name}\"\n");
    let by_hand = "[[combination]]\nname = \"C\"\nlimit_state = [\"STR/GEO\", \"SLS frequent\"]\n\
                   factors = { D = 1 }\n";
    let eurocode = set("EN 1990 6.10") + &set("EN 1990 frequent");
    let american = set("ASCE 7-22 LRFD") + &set("ASCE 7-22 ASD");
    for (action, combinations, cites) in [
        ("permanent", &eurocode, true),
        ("dead", &american, false),
        ("permanent", &by_hand.to_owned(), false),
        ("permanent", &String::new(), false),
    ] {
        let folder = under(action, combinations);
        let done = folder.run(&["solve", "model.toml"]);
        done.is_clean(0);
        assert_eq!(done.stdout.contains("(EN 1997-1, 6.5.4)"), cites, "{}", done.stdout);
        let found: Vec<Value> = verdicts(&folder).iter().map(|of| of["clause"].clone()).collect();
        let of_eurocode = ["EN 1997-1, 6.5.2", "EN 1997-1, 6.6", "EN 1997-1, 6.5.4"];
        match cites {
            true => assert_eq!(found, of_eurocode),
            false => assert!(found.iter().all(Value::is_null), "{found:?}"),
        }
    }
}

/// A design resistance is no allowable pressure, so one value is judged on one level of loads.
#[test]
fn a_bearing_resistance_is_a_design_value_or_an_allowable_value() {
    let set = |name: &str| format!("[[combination]]\nset = \"{name}\"\n");
    let [lrfd, asd] = ["ASCE 7-22 LRFD", "ASCE 7-22 ASD"].map(set);
    for (combinations, state, words) in [
        (lrfd.clone() + &asd, "STR/GEO", "V_d = 1.4 on the effective area, resistance 7.2"),
        (lrfd, "STR/GEO", "V_d = 1.4 on the effective area, resistance 7.2"),
        (asd, "allowable stress", "V = 1 on the effective area, 7.2 allowed"),
    ] {
        let folder = under("dead", &combinations);
        let all = verdicts(&folder);
        let of_it = all.iter().filter(|of| of["name"] == "bearing-resistance");
        let states: Vec<_> = of_it.map(|of| of["limit_state"].clone()).collect();
        assert_eq!(states, [state]);
        let text = folder.run(&["solve", "model.toml"]).stdout;
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(words), "{text}");
    }
    // The value keeps its meaning if only a part of the combinations is solved.
    let folder = under("dead", &(set("ASCE 7-22 LRFD") + &set("ASCE 7-22 ASD")));
    let done = folder.run(&["solve", "model.toml", "--set", "ASCE 7-22 ASD"]);
    let words = done.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
    let expected =
        "bearing resistance not judged: no selected combination has the limit state STR/GEO";
    assert!(words.contains(expected), "{words}");
}

#[test]
fn a_set_is_selected_by_its_name() {
    let of_sets = LIFTS.replace("point = 1\n", "point = 1\ncase = \"G\"\n")
        + "[[case]]\nname = \"G\"\naction = \"permanent\"\n\
           [[combination]]\nset = \"EN 1990 6.10\"\n[[combination]]\nset = \"EN 1990 EQU\"\n";
    let folder = Folder::with(&of_sets.replace("moment = 0.49", "moment = 0.1"));
    let done = folder.run(&["solve", "model.toml", "--set", "EN 1990 STR"]);
    done.is_clean(0);
    assert!(done.stdout.contains("6.10: 1.35 G") && !done.stdout.contains("EQU"));
    let done = folder.run(&["solve", "model.toml", "--set", "EN 1990 GEO"]);
    assert_eq!(done.status, 2);
    assert!(done.stderr.contains("`EN 1990 EQU`, `EN 1990 STR/GEO B`"), "{}", done.stderr);
}

#[test]
fn a_limit_state_without_a_solved_position_of_a_train_has_no_rows() {
    let text = tips().replace("name = \"storm\"", "name = \"storm\"\nlimit_state = \"EQU\"")
        + "[[train]]\naxles = [{ at = 0, force = 0.01 }]\n";
    let text = text.replace("name = \"heavy\"", "name = \"heavy\"\nlimit_state = \"SLS frequent\"");
    let folder = Folder::with(&text);
    folder.run(&["solve", "model.toml", "--csv", "t.csv"]).is_clean(3);
    let table = folder.read("t.csv");
    let rows: Vec<Vec<&str>> = table.lines().map(|row| row.split(',').collect()).collect();
    assert!(rows.iter().all(|row| row.len() == rows[0].len()), "{table}");
    let of = |state: &str| rows.iter().filter(|row| row.last() == Some(&state)).count();
    assert!(of("all") > 10 && of("SLS frequent") == of("all") && of("EQU") == 0, "{table}");
}
