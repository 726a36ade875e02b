//! Results on their way: parts of a study in a folder beside the file they will become.
//!
//! A part is written under another name, brought to the disk and renamed: what has its name is whole. Which samples it
//! holds stands in the name. Whoever works here holds a lock that ends with the process.

use super::read::head_of;
use super::table::{ROWS_IN_A_GROUP, Table, writer};
use super::{Columns, StoreError};
use crate::draws::Draw;
use crate::row::Row;
use arrow_array::RecordBatch;
use arrow_schema::ArrowError;
use arrow_select::concat::concat_batches;
use parquet::arrow::ArrowWriter;
use std::fs::{self, File, TryLockError};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The folder of parts of one file of results.
#[derive(Debug)]
pub struct Parts {
    /// What they will become.
    out: PathBuf,
    folder: PathBuf,
    /// Held until the work ends.
    _lock: File,
}

impl Parts {
    /// Begins or goes on; with `restart`, whatever is there is thrown away.
    pub fn open(out: &Path, table: &Table, restart: bool) -> Result<Self, StoreError> {
        let mut folder = out.as_os_str().to_owned();
        folder.push(".parts");
        let folder = PathBuf::from(folder);
        fs::create_dir_all(&folder).map_err(|error| StoreError::io(&folder, &error))?;
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
        if let Some((_, path)) = parts.all()?.first()
            && head_of(path)?.get("digest") != table.head.get("digest")
        {
            return Err(StoreError::Foreign(out.to_owned()));
        }
        Ok(parts)
    }

    /// Whether results wait here to be gone on with.
    pub fn wait(out: &Path) -> bool {
        let mut folder = out.as_os_str().to_owned();
        folder.push(".parts");
        Path::new(&folder).is_dir()
    }

    /// Every whole part and its samples, in their order.
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

    /// What of a range no part holds.
    pub fn missing(&self, of: Range<u64>) -> Result<Vec<Range<u64>>, StoreError> {
        let mut missing = Vec::new();
        let mut reached = of.start;
        for (range, _) in self.all()? {
            if range.start > reached {
                missing.push(reached..range.start.min(of.end));
            }
            reached = reached.max(range.end);
        }
        if reached < of.end {
            missing.push(reached..of.end);
        }
        Ok(missing)
    }

    /// Keeps the rows of consecutive samples.
    pub fn keep(&self, table: &Table, first: u64, rows: &[(Draw, Row)]) -> Result<(), StoreError> {
        let range = first..first + rows.len() as u64;
        // So many digits that names sort as numbers do.
        let path = self.folder.join(format!("{:015}-{:015}.parquet", range.start, range.end));
        let unfinished = path.with_extension("unfinished");
        let mut writer = table.writer(&unfinished)?;
        let wrong = |error| StoreError::parquet(&unfinished, &error);
        writer.write(&table.batch(first, rows)).map_err(wrong)?;
        let file = writer.into_inner().map_err(wrong)?;
        let renamed = file.sync_all().and_then(|()| fs::rename(&unfinished, &path));
        renamed.map_err(|error| StoreError::io(&path, &error))
    }

    /// Makes one file of all parts, and removes them.
    pub fn finish(self, table: &Table) -> Result<(), StoreError> {
        let all = self.all()?;
        let paths: Vec<&Path> = all.iter().map(|(_, path)| &**path).collect();
        assembled(&self.out, table, &paths)?;
        fs::remove_dir_all(&self.folder).map_err(|error| StoreError::io(&self.folder, &error))
    }
}

/// One file of several, row after row.
pub fn assembled(out: &Path, table: &Table, paths: &[&Path]) -> Result<(), StoreError> {
    let mut name = out.as_os_str().to_owned();
    name.push(".unfinished");
    let unfinished = PathBuf::from(name);
    let mut writer = writer(&unfinished, &table.schema, &table.head)?;
    // Where pages end depends on how rows are handed over: always as many at once, whatever the parts were.
    let mut waiting: Vec<RecordBatch> = Vec::new();
    let mut rows = 0;
    for path in paths {
        let wrong = |error: ArrowError| StoreError::File((*path).to_owned(), error.to_string());
        for batch in Columns::open(path)?.batches()? {
            let mut batch = batch.map_err(wrong)?;
            while rows + batch.num_rows() >= ROWS_IN_A_GROUP {
                let fitting = ROWS_IN_A_GROUP - rows;
                waiting.push(batch.slice(0, fitting));
                hand_over(&mut writer, table, &mut waiting, &unfinished)?;
                batch = batch.slice(fitting, batch.num_rows() - fitting);
                rows = 0;
            }
            rows += batch.num_rows();
            waiting.push(batch);
        }
    }
    hand_over(&mut writer, table, &mut waiting, &unfinished)?;
    let file = writer.into_inner().map_err(|error| StoreError::parquet(&unfinished, &error))?;
    let renamed = file.sync_all().and_then(|()| fs::rename(&unfinished, out));
    renamed.map_err(|error| StoreError::io(out, &error))
}

/// Writes what waits as one batch.
fn hand_over(
    writer: &mut ArrowWriter<File>,
    table: &Table,
    waiting: &mut Vec<RecordBatch>,
    path: &Path,
) -> Result<(), StoreError> {
    let wrong = |error: ArrowError| StoreError::File(path.to_owned(), error.to_string());
    // What a file says of itself stands in its own schema.
    let ours = |batch: RecordBatch| batch.with_schema(Arc::clone(&table.schema));
    let batches: Vec<RecordBatch> =
        waiting.drain(..).map(ours).collect::<Result<_, _>>().map_err(wrong)?;
    let whole = concat_batches(&table.schema, &batches).map_err(wrong)?;
    writer.write(&whole).map_err(|error| StoreError::parquet(path, &error))
}
