//! Changes every model file of the repository at random. Reading must not panic, every fault must have a
//! location, and an accepted file must be written and read again as the same model.
//!
//! `GROUNDBEAM_MUTATIONS=1000000 GROUNDBEAM_SEED=7` runs more changes, from another seed.

pub mod corpus;
mod mutate;

use crate::common::well_placed;
use corpus::{Sample, samples};
use groundbeam_file::study::{StudyError, read_study};
use groundbeam_file::{Document, parse_beside, write_toml};
use mutate::edit;
use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::{RngSeed, TestRunner};
use std::cell::Cell;
use std::fs;
use std::path::Path;

/// Runner with this number of changed files by default.
fn runner(files: u32) -> TestRunner {
    let asked = |name, otherwise| {
        std::env::var(name).map_or(otherwise, |value| value.parse().expect("a number"))
    };
    TestRunner::new(ProptestConfig {
        cases: asked("GROUNDBEAM_MUTATIONS", files),
        rng_seed: RngSeed::Fixed(asked("GROUNDBEAM_SEED", 1).into()),
        failure_persistence: None,
        ..ProptestConfig::default()
    })
}

#[test]
fn a_changed_file_is_refused_with_a_location_or_survives_writing_and_reading() {
    let samples = samples();
    let edits = prop::collection::vec(edit(), 0..4);
    let accepted = Cell::new(0);
    let mut runner = runner(4000);
    let result = runner.run(&(any::<Index>(), edits), |(sample, edits)| {
        let Sample { folder, text } = &samples[sample.index(samples.len())];
        let text = edits.iter().fold(text.clone(), |text, edit| edit.apply(&text));
        match parse_beside(&text, folder) {
            Ok(document) => {
                accepted.set(accepted.get() + 1);
                reads_again(&document, &text);
            }
            Err(found) => well_placed(&found, &text),
        }
        Ok(())
    });
    if let Err(error) = result {
        panic!("{error}");
    }
    assert!(accepted.get() > 500, "{}", accepted.get());
}

/// A changed study file is either refused with a location or read. The study and its model lie in a
/// temporary folder.
#[test]
fn a_changed_study_is_refused_with_a_location_or_read() {
    let is_study =
        |sample: &Sample| ["[[random]]", "[field]"].iter().any(|t| sample.text.contains(t));
    let studies: Vec<Sample> = samples().into_iter().filter(is_study).collect();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("studies");
    fs::create_dir_all(&folder).unwrap();
    for entry in fs::read_dir(&studies[0].folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            fs::copy(&path, folder.join(path.file_name().unwrap())).unwrap();
        }
    }
    let path = folder.join("changed.toml");
    let edits = prop::collection::vec(edit(), 0..4);
    let accepted = Cell::new(0);
    let result = runner(1000).run(&(any::<Index>(), edits), |(study, edits)| {
        let Sample { text, .. } = &studies[study.index(studies.len())];
        let text = edits.iter().fold(text.clone(), |text, edit| edit.apply(&text));
        fs::write(&path, &text).unwrap();
        match read_study(&path) {
            Ok(_) => accepted.set(accepted.get() + 1),
            Err(StudyError::Wrong(found, _, text)) => well_placed(&found, &text),
            Err(error) => panic!("{error}"),
        }
        Ok(())
    });
    if let Err(error) = result {
        panic!("{error}");
    }
    assert!(accepted.get() > 100, "{}", accepted.get());
}

fn reads_again(document: &Document, text: &str) {
    assert_eq!(document.model.problems(), []);
    let written = write_toml(&document.model, document.title.as_deref(), document.units);
    let again = match groundbeam_file::parse(&written) {
        Ok(again) => again,
        Err(found) => {
            panic!("{}\nof\n{text}", found.render("written.toml", &written, false))
        }
    };
    assert_eq!(again.title, document.title);
    assert_eq!(again.units, document.units);
    // `{:?}` distinguishes 0 from −0 and gives the shortest text of the same bits.
    assert_eq!(format!("{:?}", again.model), format!("{:?}", document.model), "{text}");
    assert_eq!(write_toml(&again.model, again.title.as_deref(), again.units), written);
}
