//! Merges the shards of one study.

use super::StoreError;
use super::parts::assembled;
use super::read::Results;
use super::table::{Head, Table};
use crate::progress::Watch;
use groundbeam_file::output::Identity;
use parquet::schema::types::TypePtr;
use std::path::{Path, PathBuf};

/// The result of a merge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Merged {
    /// Number of samples.
    pub samples: u64,
    /// Number of files.
    pub files: usize,
}

/// Merges the shards of a study. The file is the same, to the last bit, as if one machine had run the study.
///
/// # Errors
///
/// Files that cannot be read or written, are not of the same study, overlap, or leave samples out;
/// [`StoreError::Stopped`] if `watch` stops the merge.
pub fn merge(paths: &[PathBuf], out: &Path, watch: &mut Watch) -> Result<Merged, StoreError> {
    let mut shards: Vec<(u64, u64, &Path)> = Vec::new();
    let mut known: Option<(Head, TypePtr, &Path)> = None;
    let replaced = Identity::of(out).map_err(|error| StoreError::io(out, &error))?;
    for path in paths {
        let results = Results::open(path)?;
        if replaced.is_some()
            && Identity::of(path).map_err(|error| StoreError::io(path, &error))? == replaced
        {
            let what = "this is one of the files that are merged; name another output";
            return Err(StoreError::File(out.to_owned(), what.to_owned()));
        }
        let (head, schema, rows) = (results.head(), results.schema(), results.rows());
        if head.get("digest").is_none() {
            return Err(StoreError::Unlike(format!(
                "{}: these are not results of a study",
                path.display()
            )));
        }
        match &known {
            None => known = Some((head, schema, path)),
            Some((other, _, first)) if *other != head => {
                return Err(StoreError::Unlike(format!(
                    "{} and {} differ in their study, model, seed or version",
                    first.display(),
                    path.display()
                )));
            }
            Some(_) => {}
        }
        shards.extend(results.first()?.map(|first| (first, first + rows, &**path)));
    }
    let Some((head, schema, _)) = known else {
        return Err(StoreError::Unlike("there are no files to merge".to_owned()));
    };
    shards.sort_by_key(|shard| shard.0);
    let samples: u64 = head.get("samples").and_then(|samples| samples.parse().ok()).unwrap_or(0);
    let mut reached = 0;
    for &(from, to, path) in &shards {
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
    let paths: Vec<&Path> = shards.iter().map(|shard| shard.2).collect();
    assembled(out, &table, &paths, samples, watch)?;
    Ok(Merged { samples, files: paths.len() })
}
