//! Merges the shards of one study.

use super::StoreError;
use super::parts::assembled;
use super::read::Results;
use super::table::{Head, Table};
use crate::progress::Watch;
use groundbeam_file::output::Identity;
use parquet::schema::types::TypePtr;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The result of a merge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Merged {
    /// Number of samples.
    pub samples: u64,
    /// Number of files.
    pub files: usize,
}

/// Merges the shards of a study. The merged file is bitwise equal to the file of a run on one machine.
///
/// # Errors
///
/// Fails if a file cannot be read or written, or if the files belong to different studies, overlap or lack samples.
/// Returns [`StoreError::Stopped`] if `watch` stops the merge.
pub fn merge(paths: &[PathBuf], out: &Path, watch: &mut Watch) -> Result<Merged, StoreError> {
    let mut shards: Vec<(Range<u64>, &Path)> = Vec::new();
    let mut known: Option<(Head, TypePtr, &Path)> = None;
    let replaced = Identity::of(out).map_err(|error| StoreError::io(out, &error))?;
    for path in paths {
        let results = Results::open(path)?;
        if replaced.is_some()
            && Identity::of(path).map_err(|error| StoreError::io(path, &error))? == replaced
        {
            let what = "this output is one of the files that are merged; name another output";
            return Err(StoreError::File(out.to_owned(), what.to_owned()));
        }
        let (head, schema) = (results.head(), results.schema());
        if head.get("digest").is_none() {
            return Err(StoreError::Unlike(format!(
                "{}: this file contains no results of a study",
                path.display()
            )));
        }
        match &known {
            None => known = Some((head, schema, path)),
            Some((other, _, first)) if *other != head => {
                return Err(StoreError::Unlike(format!(
                    "{} and {} differ in their study, model, seed or version; merge only shards of one study",
                    first.display(),
                    path.display()
                )));
            }
            Some(_) => {}
        }
        shards.extend(results.samples()?.map(|samples| (samples, &**path)));
    }
    let Some((head, schema, _)) = known else {
        return Err(StoreError::Unlike("there are no files to merge".to_owned()));
    };
    shards.sort_by_key(|(samples, _)| samples.start);
    let samples: u64 = head.get("samples").and_then(|samples| samples.parse().ok()).unwrap_or(0);
    let mut reached = 0;
    for &(Range { start: from, end: to }, path) in &shards {
        if from != reached {
            let what = if from > reached { "are missing" } else { "occur twice" };
            let [a, b] = [from.min(reached), from.max(reached) - 1];
            let what = format!("{}: samples {a} to {b} {what}", path.display());
            return Err(StoreError::Unlike(what));
        }
        reached = to;
    }
    if reached != samples {
        let what = format!("samples {reached} to {} are missing", samples.saturating_sub(1));
        return Err(StoreError::Unlike(what));
    }
    let table = Table::read(head, schema);
    let paths: Vec<&Path> = shards.iter().map(|(_, path)| *path).collect();
    assembled(out, &table, &paths, samples, watch)?;
    Ok(Merged { samples, files: paths.len() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Draws, Progress, Shard, Stage, run};
    use groundbeam_file::study::read_study;
    use std::fs;
    use std::ops::ControlFlow;

    #[test]
    fn a_file_that_lacks_samples_between_others_is_refused() {
        let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/random-ground.toml");
        let study = read_study(&docs).unwrap();
        let plan = study.plan.with(Some(64), None);
        let draws = Draws::new(study, plan).unwrap();
        let folder = std::env::temp_dir().join(format!("groundbeam-merge-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let out = folder.join("r.parquet");
        let mut stop = |now: Progress| match now.stage {
            Stage::Merging => ControlFlow::Break(()),
            _ => ControlFlow::Continue(()),
        };
        run(&draws, &out, Shard::WHOLE, true, 2, &mut stop).unwrap();
        let mut parts: Vec<PathBuf> = fs::read_dir(folder.join("r.parquet.parts"))
            .unwrap()
            .map(|entry| entry.unwrap().path())
            .filter(|path| path.extension().is_some())
            .collect();
        parts.sort();
        let holed = folder.join("holed.parquet");
        let mut never = |_: Progress| ControlFlow::Continue(());
        let paths = [&*parts[0], &*parts[2]];
        assembled(&holed, &Table::of(&draws), &paths, 32, &mut never).unwrap();
        let refused = merge(&[holed], &folder.join("all.parquet"), &mut never).unwrap_err();
        let said = refused.to_string();
        fs::remove_dir_all(&folder).unwrap();
        assert!(
            said.contains("it has 32 rows, but its samples are numbered from 0 to 47"),
            "{said}"
        );
    }
}
