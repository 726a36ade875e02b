//! Tests damaged results: a flipped bit in any byte of a part or of a finished file is detected, and the
//! remedy in the message works.

use groundbeam_file::study::read_study;
use groundbeam_study::{
    Draws, Finished, Progress, Shard, Stage, StoreError, merge, run, summary, verify,
};
use std::fs::{self, OpenOptions};
use std::io::{Seek, SeekFrom, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

const MODEL: &str = "\
[beam]
length = 1
EI = 1
[foundation]
k = 1
mu = 1
[[load]]
point = 1
at = 0.5
";
/// The title contains the key of the checksums.
const STUDY: &str = "\
title = \"groundbeam.checksum\"
model = \"model.toml\"
samples = 64
[[random]]
what = \"load[0]\"
distribution = \"normal\"
cov = 0.2
[keep]
extremes = [\"deflection\"]
";

/// A study in an empty folder of its own.
fn study(name: &str, samples: u64) -> (Draws, PathBuf) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("damaged").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("model.toml"), MODEL).unwrap();
    fs::write(folder.join("study.toml"), STUDY).unwrap();
    let study = read_study(&folder.join("study.toml")).unwrap();
    let plan = study.plan.with(Some(samples), None);
    (Draws::new(study, plan).unwrap(), folder)
}

fn never(_: Progress) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

fn before_merging(now: Progress) -> ControlFlow<()> {
    if now.stage == Stage::Merging { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

fn finish(draws: &Draws, out: &Path) -> Result<Finished, StoreError> {
    run(draws, out, Shard::WHOLE, false, 2, &mut never)
}

fn parts(out: &Path) -> Vec<PathBuf> {
    let mut folder = out.as_os_str().to_owned();
    folder.push(".parts");
    let paths = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut parts: Vec<PathBuf> =
        paths.filter(|path| path.extension().is_some_and(|e| e == "parquet")).collect();
    parts.sort();
    parts
}

/// Changes one byte of a file.
fn put(path: &Path, at: usize, byte: u8) {
    let mut file = OpenOptions::new().write(true).open(path).unwrap();
    file.seek(SeekFrom::Start(at as u64)).unwrap();
    file.write_all(&[byte]).unwrap();
}

/// Checks that the message names the damaged file and the remedy.
#[track_caller]
fn refused<T: std::fmt::Debug>(result: Result<T, StoreError>, path: &Path, at: usize) -> String {
    let message = result.expect_err(&format!("byte {at} of {}", path.display())).to_string();
    assert!(message.starts_with(&format!("{}: ", path.display())), "byte {at}: {message}");
    assert!(message.contains("delete"), "byte {at}: {message}");
    message
}

/// Flips one bit of every byte, one after another.
fn flip_every_byte(path: &Path, mut check: impl FnMut(usize)) {
    for (at, byte) in fs::read(path).unwrap().into_iter().enumerate() {
        put(path, at, byte ^ (1 << (at % 8)));
        check(at);
        put(path, at, byte);
    }
}

#[test]
fn every_flipped_byte_of_a_part_is_refused_on_resume() {
    let (draws, folder) = study("part", 64);
    let out = folder.join("r.parquet");
    run(&draws, &out, Shard::WHOLE, false, 2, &mut before_merging).unwrap();
    let all = parts(&out);
    assert_eq!(all.len(), 4);
    let part = &all[1];
    let mut messages = Vec::new();
    flip_every_byte(part, |at| messages.push(refused(finish(&draws, &out), part, at)));
    assert!(messages[0].contains(": rows 0 to 15 are damaged: "), "{}", messages[0]);
    assert!(messages.iter().any(|message| message.contains(": its metadata are damaged: ")));
    assert!(!out.exists());
    assert_eq!(finish(&draws, &out).unwrap(), Finished::Whole(0));
}

#[test]
fn every_flipped_byte_of_a_finished_file_is_refused() {
    let (draws, folder) = study("whole", 64);
    let [out, merged] = ["r.parquet", "merged.parquet"].map(|name| folder.join(name));
    finish(&draws, &out).unwrap();
    flip_every_byte(&out, |at| {
        refused(finish(&draws, &out), &out, at);
        refused(summary(&draws, &out, &mut never), &out, at);
        refused(merge(std::slice::from_ref(&out), &merged, &mut never), &out, at);
        refused(verify(&out, &mut never), &out, at);
    });
    assert!(!merged.exists());
    assert_eq!(verify(&out, &mut never).unwrap(), 64);
    assert_eq!(summary(&draws, &out, &mut never).unwrap().solved, 64);
}

#[test]
fn truncated_and_extended_files_are_refused() {
    let (draws, folder) = study("cut", 64);
    let out = folder.join("r.parquet");
    finish(&draws, &out).unwrap();
    let bytes = fs::read(&out).unwrap();
    for length in 0..bytes.len() {
        fs::write(&out, &bytes[..length]).unwrap();
        refused(finish(&draws, &out), &out, length);
    }
    for more in [&b"\0"[..], b"PAR1", &bytes] {
        fs::write(&out, [&bytes, more].concat()).unwrap();
        refused(finish(&draws, &out), &out, bytes.len());
    }
}

/// Two groups of rows; a seeded sample of the bits is flipped.
#[test]
fn damage_in_a_later_row_group_is_reported_with_its_rows() {
    let (draws, folder) = study("groups", 70_000);
    let out = folder.join("r.parquet");
    finish(&draws, &out).unwrap();
    let bytes = fs::read(&out).unwrap();
    let mut random: u64 = 7;
    let mut told = [0; 3];
    for _ in 0..60 {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        let at = usize::try_from((random >> 20) % bytes.len() as u64).unwrap();
        put(&out, at, bytes[at] ^ (1 << (random >> 61)));
        let message = refused(summary(&draws, &out, &mut never), &out, at);
        let which = ["rows 0 to 65535 are", "rows 65536 to 69999 are", "metadata are"];
        let which = which.iter().position(|what| message.contains(what));
        told[which.unwrap_or_else(|| panic!("{message}"))] += 1;
        put(&out, at, bytes[at]);
    }
    assert!(told[0] > 10 && told[1] > 0, "{told:?}");
}

#[test]
fn a_damaged_part_that_is_deleted_is_computed_again() {
    let (draws, folder) = study("again", 64);
    let [whole, out] = ["whole.parquet", "r.parquet"].map(|name| folder.join(name));
    finish(&draws, &whole).unwrap();
    run(&draws, &out, Shard::WHOLE, false, 2, &mut before_merging).unwrap();
    let part = parts(&out).remove(2);
    put(&part, 100, !fs::read(&part).unwrap()[100]);
    refused(finish(&draws, &out), &part, 100);
    fs::remove_file(&part).unwrap();
    assert_eq!(finish(&draws, &out).unwrap(), Finished::Whole(16));
    assert_eq!(fs::read(&out).unwrap(), fs::read(&whole).unwrap());
}

#[test]
fn a_part_with_the_name_of_another_part_is_refused() {
    let (draws, folder) = study("renamed", 64);
    let out = folder.join("r.parquet");
    run(&draws, &out, Shard::WHOLE, false, 2, &mut before_merging).unwrap();
    let all = parts(&out);
    fs::copy(&all[0], &all[1]).unwrap();
    let message = refused(finish(&draws, &out), &all[1], 0);
    assert!(message.contains("it contains samples 0 to 15, not those of its name"), "{message}");
}

#[test]
fn parts_of_another_shard_are_refused() {
    let (draws, folder) = study("shards", 64);
    let out = folder.join("r.parquet");
    let shard = |number, restart, watch: &mut dyn FnMut(Progress) -> ControlFlow<()>| {
        run(&draws, &out, Shard { number, of: 2 }, restart, 2, watch)
    };
    for (first, second) in [(2, 1), (1, 2)] {
        shard(first, true, &mut before_merging).unwrap();
        let part = parts(&out).remove(0);
        let message = shard(second, false, &mut never).unwrap_err().to_string();
        assert!(message.starts_with(&part.display().to_string()), "{message}");
        assert!(message.contains("another shard") && message.contains("--restart"), "{message}");
    }
    assert_eq!(shard(1, true, &mut never).unwrap(), Finished::Whole(32));
}

#[test]
fn files_of_other_formats_are_refused_as_results() {
    let (draws, folder) = study("other", 64);
    let out = folder.join("r.parquet");
    for text in [&b""[..], b"PAR1", b"PAR1\0\0\0\0PAR1", b"a,b\n1,2\n", &[0xff; 100]] {
        fs::write(&out, text).unwrap();
        let message = refused(finish(&draws, &out), &out, 0);
        assert!(message.contains("this is not a file of results"), "{message}");
    }
}

#[test]
fn results_do_not_replace_their_input_files() {
    let (draws, folder) = study("inputs", 64);
    let refused = |name: &str, what: &str| {
        let before = fs::read(folder.join(name)).unwrap();
        for restart in [false, true] {
            let result = run(&draws, &folder.join(name), Shard::WHOLE, restart, 1, &mut never);
            let message = result.unwrap_err().to_string();
            assert!(message.contains(what), "{message}");
            assert_eq!(fs::read(folder.join(name)).unwrap(), before);
        }
    };
    refused("model.toml", "the study reads this file");
    refused("study.toml", "the study reads this file");
    let out = folder.join("r.parquet");
    finish(&draws, &out).unwrap();
    let before = fs::read(&out).unwrap();
    let spelled = folder.join("../inputs/r.parquet");
    let message = merge(std::slice::from_ref(&out), &spelled, &mut never).unwrap_err().to_string();
    assert!(message.contains("one of the files that are merged"), "{message}");
    assert_eq!(fs::read(&out).unwrap(), before);
}

#[cfg(unix)]
#[test]
fn results_are_written_through_links_and_only_to_regular_files() {
    let (draws, folder) = study("links", 64);
    let [link, target, merged] = ["r.parquet", "data", "merged"].map(|name| folder.join(name));
    std::os::unix::fs::symlink("data", &link).unwrap();
    finish(&draws, &link).unwrap();
    assert!(link.is_symlink() && !target.is_symlink());
    assert_eq!(verify(&target, &mut never).unwrap(), 64);
    std::os::unix::fs::symlink("data-2", &merged).unwrap();
    merge(std::slice::from_ref(&link), &merged, &mut never).unwrap();
    assert!(merged.is_symlink());
    assert_eq!(fs::read(folder.join("data-2")).unwrap(), fs::read(&target).unwrap());
    let message = finish(&draws, Path::new("/dev/null")).unwrap_err().to_string();
    assert!(message.contains("not a device or a pipe"), "{message}");
    merge(&[link], Path::new("/dev/null"), &mut never).unwrap();
}
