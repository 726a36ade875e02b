//! Stores the parts of a running study in a folder beside the final file.
//!
//! The name of a part contains the range of its samples. A process that writes parts locks the folder until it ends.

use super::StoreError;
use super::column::Column;
use super::read::{Results, counted};
use super::table::Table;
use super::write::{Packing, Writer};
use crate::progress::{Progress, Stage, Watch};
use std::fs::{self, File, TryLockError};
use std::io::ErrorKind;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The folder with the parts of the results file `out`.
fn folder(out: &Path) -> PathBuf {
    let mut name = out.as_os_str().to_owned();
    name.push(".parts");
    PathBuf::from(name)
}

/// The folder with the parts of one file of results. Each part is a file with the rows of consecutive samples.
#[derive(Debug)]
pub struct Parts {
    /// The final file.
    out: PathBuf,
    folder: PathBuf,
    /// The lock of the folder, held until the work ends.
    _lock: File,
}

impl Parts {
    /// Opens the folder, which is new or contains the parts of an earlier run. `restart` removes these parts.
    pub fn open(out: &Path, restart: bool) -> Result<Self, StoreError> {
        let folder = folder(out);
        match fs::create_dir(&folder) {
            Err(error) if error.kind() != ErrorKind::AlreadyExists => {
                return Err(StoreError::io(&folder, &error));
            }
            _ => {}
        }
        let lock_path = folder.join("lock");
        let lock = File::create(&lock_path).map_err(|error| StoreError::io(&lock_path, &error))?;
        match lock.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(StoreError::Busy(out.to_owned())),
            Err(TryLockError::Error(error)) => return Err(StoreError::io(&lock_path, &error)),
        }
        let parts = Parts { out: out.to_owned(), folder, _lock: lock };
        if restart {
            for (_, path) in parts.all()? {
                fs::remove_file(&path).map_err(|error| StoreError::io(&path, &error))?;
            }
        }
        Ok(parts)
    }

    /// Verifies that each part is undamaged, belongs to this study, and contains the samples in its name. The
    /// samples of a part must be among `samples` and in no other part.
    pub fn verify(
        &self,
        table: &Table,
        samples: &Range<u64>,
        watch: &mut Watch,
    ) -> Result<(), StoreError> {
        let all = self.all()?;
        let rows = all.iter().map(|(range, _)| range.end.saturating_sub(range.start)).sum();
        let mut verified = counted(rows, watch);
        let mut reached = samples.start;
        for (range, path) in all {
            let results = Results::open(&path)?;
            if results.head().get("digest") != table.head.get("digest") {
                return Err(StoreError::Foreign(self.out.clone()));
            }
            if range.start < reached || range.end > samples.end {
                return Err(StoreError::Unlike(format!(
                    "{}: these samples belong to another shard or to another part; run that shard, name another output, \
                     or use --restart, which deletes all parts of this output",
                    path.display()
                )));
            }
            reached = range.end;
            results.verify(&mut verified)?;
            let found = results.samples()?.unwrap_or(range.start..range.start);
            if found != range {
                return Err(StoreError::Unlike(format!(
                    "{}: it contains samples {} to {}, not those of its name; delete this file and run the study \
                     again, which computes them again",
                    path.display(),
                    found.start,
                    found.end.saturating_sub(1)
                )));
            }
        }
        Ok(())
    }

    /// Whether a folder with parts of an earlier run exists for the results file `out`.
    pub fn wait(out: &Path) -> bool {
        folder(out).is_dir()
    }

    /// All complete parts with the ranges of their samples, in the order of the samples.
    pub fn all(&self) -> Result<Vec<(Range<u64>, PathBuf)>, StoreError> {
        let wrong = |error: std::io::Error| StoreError::io(&self.folder, &error);
        let mut all = Vec::new();
        for entry in fs::read_dir(&self.folder).map_err(wrong)? {
            let entry = entry.map_err(wrong)?;
            let name = entry.file_name();
            let range = name.to_str().and_then(|name| {
                let (from, to) = name.strip_suffix(".parquet")?.split_once('-')?;
                Some(from.parse().ok()?..to.parse().ok()?)
            });
            all.extend(range.map(|range| (range, entry.path())));
        }
        all.sort_by_key(|(range, _)| range.start);
        Ok(all)
    }

    /// Returns the ranges of those samples in `of` that no part file contains.
    pub fn missing(&self, of: Range<u64>) -> Result<Vec<Range<u64>>, StoreError> {
        let mut missing = Vec::new();
        let mut reached = of.start;
        for (range, _) in self.all()? {
            let start = range.start.min(of.end);
            if start > reached {
                missing.push(reached..start);
            }
            reached = reached.max(range.end);
        }
        if reached < of.end {
            missing.push(reached..of.end);
        }
        Ok(missing)
    }

    /// Stores the rows of consecutive samples as one part file in the folder.
    pub fn keep(
        &self,
        table: &Table,
        range: Range<u64>,
        columns: Vec<Column>,
    ) -> Result<(), StoreError> {
        let rows = usize::try_from(range.end - range.start).unwrap_or(0);
        // Leading zeros make names sort like numbers.
        let path = self.folder.join(format!("{:015}-{:015}.parquet", range.start, range.end));
        let mut writer = Writer::new(&path, table, Packing::Passing)?;
        writer.write(columns, rows)?;
        writer.finish()
    }

    /// Joins all parts into one results file, and then deletes the parts.
    pub fn finish(self, table: &Table, watch: &mut Watch) -> Result<(), StoreError> {
        let all = self.all()?;
        let paths: Vec<&Path> = all.iter().map(|(_, path)| &**path).collect();
        let samples = all.iter().map(|(range, _)| range.end - range.start).sum();
        assembled(&self.out, table, &paths, samples, watch)?;
        fs::remove_dir_all(&self.folder).map_err(|error| StoreError::io(&self.folder, &error))
    }
}

/// Writes the rows of several files, one file after the other, to the file `out`.
pub fn assembled(
    out: &Path,
    table: &Table,
    paths: &[&Path],
    samples: u64,
    watch: &mut Watch,
) -> Result<(), StoreError> {
    let mut writer = Writer::new(out, table, Packing::Kept)?;
    let mut done = 0;
    let mut copied = |rows: usize| {
        done += rows as u64;
        let now = Progress { stage: Stage::Merging, done, before: 0, of: samples };
        if watch(now).is_break() { Err(StoreError::Stopped) } else { Ok(()) }
    };
    let mut results = paths.iter().map(|path| Results::open(path));
    results.try_for_each(|results| writer.copy(&results?, &mut copied))?;
    writer.finish()
}
