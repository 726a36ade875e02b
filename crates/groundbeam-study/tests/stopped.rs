//! Tests that a study may be stopped at any stage: no file is incomplete, and the same call resumes it.

use groundbeam_file::study::read_study;
use groundbeam_study::{
    Draws, Finished, Progress, Shard, Stage, StoreError, Watch, merge, run, summary,
};
use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// Hypercubes of the same size need a multiple of their number, 8.
const SAMPLES: u64 = 2400;

fn draws() -> Draws {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/random-ground.toml");
    let study = read_study(&path).unwrap();
    let plan = study.plan.with(Some(SAMPLES), None);
    Draws::new(study, plan).unwrap()
}

/// An empty folder of its own.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("stopped").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

fn stop_at(stage: Stage) -> impl FnMut(Progress) -> ControlFlow<()> {
    move |now| if now.stage == stage { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

fn on(draws: &Draws, out: &Path, watch: &mut Watch) -> Finished {
    run(draws, out, Shard::WHOLE, false, 2, watch).unwrap()
}

#[test]
fn a_study_stopped_during_the_merge_can_be_resumed() {
    let (draws, folder) = (draws(), folder("parts"));
    let [undisturbed, out] = ["undisturbed.parquet", "stopped.parquet"].map(|n| folder.join(n));
    on(&draws, &undisturbed, &mut |_| ControlFlow::Continue(()));
    let Finished::Stopped(Progress { done, of, .. }) =
        on(&draws, &out, &mut stop_at(Stage::Merging))
    else {
        panic!("it was not stopped");
    };
    assert_eq!((done, of), (SAMPLES, SAMPLES));
    assert_eq!(names(&folder), ["stopped.parquet.parts", "undisturbed.parquet"]);
    // No samples remain.
    assert_eq!(on(&draws, &out, &mut |_| ControlFlow::Continue(())), Finished::Whole(0));
    assert_eq!(fs::read(&out).unwrap(), fs::read(&undisturbed).unwrap());
}

#[test]
fn a_stopped_merge_or_summary_leaves_no_files() {
    let (draws, folder) = (draws(), folder("merge"));
    let [out, merged] = ["all.parquet", "merged.parquet"].map(|name| folder.join(name));
    on(&draws, &out, &mut |_| ControlFlow::Continue(()));
    let stopped = merge(std::slice::from_ref(&out), &merged, &mut stop_at(Stage::Merging));
    assert!(matches!(stopped, Err(StoreError::Stopped)));
    assert_eq!(names(&folder), ["all.parquet"]);
    let stopped = summary(&draws, &out, &mut stop_at(Stage::Summarizing));
    assert!(matches!(stopped, Err(StoreError::Stopped)));
}

/// The progress never decreases and ends at the total.
#[test]
fn the_progress_increases_and_reaches_its_total() {
    let (draws, folder) = (draws(), folder("progress"));
    let out = folder.join("all.parquet");
    let mut seen: Vec<Progress> = Vec::new();
    let mut see = |now| {
        seen.push(now);
        ControlFlow::Continue(())
    };
    on(&draws, &out, &mut see);
    summary(&draws, &out, &mut see).unwrap();
    for stage in [Stage::Solving, Stage::Merging, Stage::Summarizing] {
        let own: Vec<&Progress> = seen.iter().filter(|now| now.stage == stage).collect();
        assert!(own.is_sorted_by_key(|now| now.done), "{stage:?}: {own:?}");
        let last = own.last().unwrap();
        assert_eq!((last.done, stage), (last.of, stage));
    }
}
