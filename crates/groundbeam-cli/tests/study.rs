//! Tests `groundbeam study` and `groundbeam merge`.
//!
//! Claims: `docs/studies.md`.

use crate::common::{Folder, LIFTS};
use std::fs;
use std::process::Stdio;
use std::time::Duration;

/// Kikuchi's beam on random ground under a random moment: some samples tip.
const STUDY: &str = "\
model = \"model.toml\"
samples = 3000
seed = 5
[[random]]
what = \"load[1]\"
distribution = \"normal\"
mean = 0.4
deviation = 0.05
[field]
k = { cov = 0.3 }
mu = { cov = 0.2 }
rho = 0.5
length = 0.3
[keep]
ground = true
extremes = [\"deflection\"]
fields = [\"settlement\"]
at = [-0.5, 0, 1]
[[event]]
name = \"deep\"
quantity = \"deflection.max\"
above = 0.5
";

fn folder() -> Folder {
    let folder = Folder::with(LIFTS);
    folder.write("study.toml", STUDY.as_bytes());
    folder
}

fn bytes(folder: &Folder, name: &str) -> Vec<u8> {
    fs::read(folder.path(name)).unwrap()
}

#[test]
fn a_study_estimates_known_probabilities() {
    let folder = folder();
    let done = folder.run(&["study", "study.toml", "--out", "r.parquet", "--json"]);
    done.is_clean(0);
    let json = done.json();
    assert_eq!(json["samples"], 3000);
    let event = |i: usize| &json["events"][i];
    // The static reaction of the left end is ½ − M₀. With a normal moment it vanishes with probability Φ(−2)
    // = 0.02275.
    assert_eq!(event(0)["name"], "no equilibrium");
    let [low, high] = [0, 1].map(|i| event(0)["interval"]["bounds"][i].as_f64().unwrap());
    assert!(low < 0.02275 && 0.02275 < high && high - low < 0.02, "{low} {high}");
    // For a beam that tips, every event counts as occurred.
    let probability = |i: usize| event(i)["probability"].as_f64().unwrap();
    assert!(probability(1) > 0.5 && probability(1) > probability(0));
    assert!(probability(2) >= probability(0));
    assert!(json["largest_gap"].as_f64().unwrap() < 1e-9);
    assert_eq!(json["not_converged"], 0);
    let counted: u64 = json["spreads"][0]["histogram"]
        .as_array()
        .unwrap()
        .iter()
        .map(|n| n.as_u64().unwrap())
        .sum();
    assert_eq!(counted, 3000);
    let again = folder.run(&["study", "study.toml", "--out", "r.parquet", "--plot", "s.svg"]);
    again.is_clean(0);
    assert!(again.stdout.lines().all(|line| line.chars().count() <= 80), "{}", again.stdout);
    assert_eq!(folder.names(), ["model.toml", "r.parquet", "s.svg", "study.toml"]);
    let picture = fs::read_to_string(folder.path("s.svg")).unwrap();
    assert!(picture.contains(">deep<") && picture.contains(">deflection max<"), "{picture}");
}

#[test]
fn threads_and_shards_do_not_change_the_bytes_of_a_study() {
    let folder = folder();
    let run = |more: &[&str]| folder.run(&[&["study", "study.toml"], more].concat()).is_clean(0);
    run(&["--out", "one.parquet", "--threads", "1"]);
    run(&["--out", "three.parquet", "--threads", "3"]);
    assert!(bytes(&folder, "one.parquet") == bytes(&folder, "three.parquet"));
    for shard in ["2/3", "1/3", "3/3"] {
        let out = format!("shard-{}.parquet", &shard[..1]);
        run(&["--out", &out, "--shard", shard]);
    }
    let shards = ["shard-3.parquet", "shard-1.parquet", "shard-2.parquet"];
    folder.run(&[&["merge"], &shards[..], &["--out", "all.parquet"]].concat()).is_clean(0);
    assert!(bytes(&folder, "one.parquet") == bytes(&folder, "all.parquet"));
    let merge =
        |files: &[&str]| folder.run(&[&["merge"], files, &["--out", "bad.parquet"]].concat());
    merge(&shards[..2]).fails(2, "samples 1000 to 1999 are missing");
    merge(&["shard-1.parquet", "shard-1.parquet"]).fails(2, "occur twice");
    run(&["--out", "other.parquet", "--seed", "6", "--shard", "2/3"]);
    merge(&["shard-1.parquet", "other.parquet"]).fails(2, "differ in their study");
    assert!(!folder.path("bad.parquet").exists());
    // Another seed is another study.
    assert!(bytes(&folder, "other.parquet") != bytes(&folder, "shard-2.parquet"));
}

/// A merge to standard output writes only the file. The merge and the study refuse a damaged shard.
#[test]
fn damaged_results_are_refused_and_standard_output_holds_only_the_file() {
    let folder = folder();
    let study = |more: &[&str]| {
        folder.run(
            &[&["study", "study.toml", "--samples", "64", "--out", "r.parquet"], more].concat(),
        )
    };
    study(&[]).is_clean(0);
    let merged = folder.command(&["merge", "r.parquet", "--out", "/dev/stdout"]).output().unwrap();
    assert!(merged.status.success() && merged.stdout == bytes(&folder, "r.parquet"));
    let mut damaged = bytes(&folder, "r.parquet");
    damaged[1000] ^= 4;
    folder.write("r.parquet", &damaged);
    let what = "error: r.parquet: rows 0 to 63 are damaged: the checksum differs from the one that was written; \
                delete this file and run the study again, which computes its samples again";
    study(&[]).fails(2, what);
    folder.run(&["merge", "r.parquet", "--out", "m.parquet"]).fails(2, what);
    assert_eq!(folder.names(), ["model.toml", "r.parquet", "study.toml"]);
    std::fs::remove_file(folder.path("r.parquet")).unwrap();
    study(&[]).is_clean(0);
    folder
        .run(&["merge", "r.parquet", "--out", "./r.parquet"])
        .fails(2, "one of the files that are merged");
}

/// The same without fields: thousands of samples in a short time, and more rows than one page of the file
/// holds.
fn many() -> Folder {
    let folder = folder();
    let (before, rest) = STUDY.split_once("[field]").unwrap();
    let (_, after) = rest.split_once("[keep]").unwrap();
    folder.write("study.toml", format!("{before}[keep]{after}").as_bytes());
    folder
}

/// Runs a long study, and stops it when parts exist.
fn interrupted(
    folder: &Folder,
    stop: impl FnOnce(&mut std::process::Child),
) -> std::process::Output {
    let mut command =
        folder.command(&["study", "study.toml", "--out", "r.parquet", "--samples", "40000"]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let parts = folder.path("r.parquet.parts");
    let there = || {
        let names =
            fs::read_dir(&parts).into_iter().flatten().flatten().map(|entry| entry.file_name());
        names.filter(|name| name.to_string_lossy().ends_with(".parquet")).count()
    };
    while there() == 0 {
        std::thread::sleep(Duration::from_millis(5));
    }
    stop(&mut child);
    child.wait_with_output().unwrap()
}

#[test]
fn a_killed_study_resumes_and_ends_with_the_same_bytes() {
    let folder = many();
    let all = ["study", "study.toml", "--samples", "40000", "--json"];
    folder.run(&[&all[..], &["--out", "whole.parquet"]].concat()).is_clean(0);
    interrupted(&folder, |child| child.kill().unwrap());
    assert!(!folder.path("r.parquet").exists());
    // An unfinished part is ignored.
    folder.write("r.parquet.parts/000000000039000-000000000040000.unfinished", b"PAR1");
    // Saved parts belong to one study only.
    let other = folder.run(&["study", "study.toml", "--out", "r.parquet", "--seed", "9"]);
    other.fails(2, "another study, model, survey, seed");
    folder.run(&[&all[..], &["--out", "r.parquet"]].concat()).is_clean(0);
    assert!(bytes(&folder, "r.parquet") == bytes(&folder, "whole.parquet"));
    assert!(!folder.path("r.parquet.parts").exists());
}

#[cfg(unix)]
#[test]
fn an_interrupted_study_keeps_its_finished_samples() {
    let folder = many();
    let output = interrupted(&folder, |child| {
        let sent =
            std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status();
        assert!(sent.unwrap().success());
    });
    assert_eq!(output.status.code(), Some(130));
    let said = String::from_utf8(output.stderr).unwrap();
    let kept: u64 =
        said.strip_prefix("stopped: ").unwrap().split(' ').next().unwrap().parse().unwrap();
    assert!(kept > 0 && kept < 40000, "{said}");
    let parts = fs::read_dir(folder.path("r.parquet.parts")).unwrap().flatten();
    let samples = parts.filter_map(|entry| {
        let name = entry.file_name().into_string().unwrap();
        let (from, to) = name.strip_suffix(".parquet")?.split_once('-')?;
        Some(to.parse::<u64>().unwrap() - from.parse::<u64>().unwrap())
    });
    assert_eq!(samples.sum::<u64>(), kept);
}

#[test]
fn two_processes_cannot_run_the_same_study() {
    let folder = many();
    let mut busy = None;
    interrupted(&folder, |child| {
        busy =
            Some(folder.run(&["study", "study.toml", "--out", "r.parquet", "--samples", "40000"]));
        child.kill().unwrap();
    });
    busy.unwrap().fails(2, "another process is writing these results");
}

#[test]
fn errors_in_a_study_file_are_reported_at_their_location() {
    let folder = folder();
    let wrong = |from: &str, to: &str, expected: &[&str]| {
        assert!(STUDY.contains(from), "{from}");
        folder.write("wrong.toml", STUDY.replace(from, to).as_bytes());
        let done = folder.run(&["study", "wrong.toml", "--out", "w.parquet"]);
        for part in expected {
            done.fails(2, part);
        }
        assert!(!folder.path("w.parquet").exists() && !folder.path("w.parquet.parts").exists());
    };
    wrong("load[1]", "load[2]", &["wrong.toml:5:8", "the model has 2"]);
    wrong("normal", "lognormel", &["wrong.toml:6:16", "did you mean `lognormal`?"]);
    wrong("deviation = 0.05", "deviation = -0.05", &["wrong.toml:8:13", "must be positive"]);
    wrong("deviation = 0.05\n", "", &["`cov` or `deviation`"]);
    wrong("mean = 0.4", "mean = \"0.4 kN m\"", &["wrong.toml:7:8"]);
    wrong("length = 0.3", "length = 0", &["a correlation length must be positive"]);
    wrong("rho = 0.5", "rho = 1.5", &["a correlation lies between -1 and 1"]);
    wrong("samples = 3000", "samples = 0", &["wrong.toml:2:11"]);
    wrong("samples = 3000", "sampels = 3000", &["did you mean `samples`?"]);
    wrong("deflection.max", "deflection.most", &["is not a result of a solve"]);
    wrong("model.toml", "none.toml", &["wrong.toml:1:9", "none.toml"]);
    let sobol = "samples = 3200\nsampling = \"sobol\"";
    wrong("samples = 3000", sobol, &["even only over powers of two", "4096 samples are even"]);
    let uneven = "samples = 3000\nsampling = \"latin-hypercube\"";
    wrong("samples = 3000", uneven, &["16 equal replicates; 2992 samples can"]);
    let random = "[[random]]\nwhat = \"k[]\"\ndistribution = \"lognormal\"\ncov = 0.1\n[field]";
    wrong("[field]", random, &["`k` is a random field and also the [[random]] number `k[]`"]);
    wrong("at = [-0.5, 0, 1]", "at = [0, 1, 0]", &["wrong.toml:18:13", "listed twice"]);
    wrong(
        "name = \"deep\"",
        "name = \"no equilibrium\"",
        &["this name is reserved: every study has this event"],
    );
    // All faults are reported together.
    wrong("normal\"\nmean = 0.4", "gumble\"\nmeen = 0.4", &["gumble", "meen"]);
    // A fault of the model is reported in the model's file.
    folder.write("model.toml", LIFTS.replace("EI = 1", "EI = -1").as_bytes());
    let done = folder.run(&["study", "study.toml", "--out", "w.parquet"]);
    done.fails(2, "model.toml:4:6");
    for shard in ["0/3", "4/3", "x", "1/0"] {
        let done = folder.run(&["study", "study.toml", "--out", "w.parquet", "--shard", shard]);
        done.fails(2, "of N as i/N");
    }
}

#[test]
fn a_study_refuses_units_and_folders_before_it_solves() {
    let folder = folder();
    let study = |more: &[&str]| folder.run(&[&["study", "study.toml"], more].concat());
    study(&["--out", "r.parquet", "--units", "si"]).fails(2, "the file has no units");
    study(&["--out", "missing/r.parquet"]).fails(2, "No such file or directory");
    assert_eq!(folder.names(), ["model.toml", "study.toml"]);
}
