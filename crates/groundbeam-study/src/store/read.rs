//! Reads and verifies files of results.

use super::StoreError;
use super::checksum::{self, Checksums};
use super::column::{Column, Values};
use super::table::Head;
use crate::progress::{Progress, Stage, Watch};
use groundbeam_file::open_file;
use parquet::column::reader::ColumnReader;
use parquet::errors::{ParquetError, Result as Done};
use parquet::file::metadata::ParquetMetaData;
use parquet::file::reader::{FileReader, RowGroupReader, SerializedFileReader};
use parquet::schema::types::TypePtr;
use std::fs::File;
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// A file of results. Every byte is verified before it is decoded.
pub struct Results {
    path: PathBuf,
    file: SerializedFileReader<File>,
    checksums: Checksums,
}

impl Results {
    pub fn open(path: &Path) -> Result<Self, StoreError> {
        let wrong = |error: io::Error| StoreError::io(path, &error);
        let file = open_file(path).map_err(wrong)?;
        let checksums = Checksums::open(path, file.try_clone().map_err(wrong)?)?;
        let file = SerializedFileReader::new(file);
        let file = file.map_err(|error| StoreError::parquet(path, &error))?;
        Ok(Results { path: path.to_owned(), file, checksums })
    }

    fn metadata(&self) -> &ParquetMetaData {
        self.file.metadata()
    }

    /// The error of this file.
    pub fn wrong(&self, error: &ParquetError) -> StoreError {
        StoreError::parquet(&self.path, error)
    }

    /// The header of the file.
    pub fn head(&self) -> Head {
        let pairs = self.metadata().file_metadata().key_value_metadata();
        let ours = pairs
            .into_iter()
            .flatten()
            .filter(|pair| pair.key.starts_with("groundbeam.") && pair.key != checksum::KEY);
        let ours = ours.map(|pair| (pair.key.clone(), pair.value.clone().unwrap_or_default()));
        Head { pairs: ours.collect() }
    }

    /// Number of rows.
    pub fn rows(&self) -> u64 {
        u64::try_from(self.metadata().file_metadata().num_rows()).unwrap_or(0)
    }

    /// The columns.
    pub fn schema(&self) -> TypePtr {
        self.metadata().file_metadata().schema_descr().root_schema_ptr()
    }

    /// Number of groups of rows.
    pub fn groups(&self) -> usize {
        self.metadata().num_row_groups()
    }

    /// The column readers of a group, and its number of rows.
    pub fn group(&self, group: usize) -> Result<(Vec<ColumnReader>, usize), StoreError> {
        let group = self.verified(group)?;
        let columns = 0..group.metadata().num_columns();
        let columns: Done<_> = columns.map(|column| group.get_column_reader(column)).collect();
        let columns = columns.map_err(|error| self.wrong(&error))?;
        Ok((columns, rows(group.metadata().num_rows())))
    }

    /// Returns a group of rows after its bytes have been verified.
    fn verified(&self, group: usize) -> Result<Box<dyn RowGroupReader + '_>, StoreError> {
        if !self.checksums.is_sound(group)? {
            let counts = self.metadata().row_groups().iter().map(|group| group.num_rows());
            let first: i64 = counts.clone().take(group).sum();
            let end: i64 = counts.take(group + 1).sum();
            let what = format!("rows {first} to {}", end - 1);
            return Err(StoreError::Damaged(self.path.clone(), what));
        }
        self.file.get_row_group(group).map_err(|error| self.wrong(&error))
    }

    /// Verifies all row groups of the Parquet file. After each row group, `verified` is called with its number of rows.
    pub fn verify(
        &self,
        verified: &mut dyn FnMut(u64) -> Result<(), StoreError>,
    ) -> Result<(), StoreError> {
        (0..self.groups()).try_for_each(|group| {
            let rows = rows(self.verified(group)?.metadata().num_rows());
            verified(rows as u64)
        })
    }

    /// Range of the samples in the file; `None` for a file without rows. Fails if the samples are not
    /// consecutive.
    pub fn samples(&self) -> Result<Option<Range<u64>>, StoreError> {
        let Some(last) = self.groups().checked_sub(1) else { return Ok(None) };
        let most = rows(self.metadata().row_group(last).num_rows());
        let [head, tail] = [self.column(0, 0, 1)?, self.column(last, 0, most)?];
        let (Values::Whole(head), Values::Whole(tail)) = (head.values, tail.values) else {
            return Ok(None);
        };
        let (Some(&first), Some(&last)) = (head.first(), tail.last()) else { return Ok(None) };
        let [first, last] = [first, last].map(i64::cast_unsigned);
        match last.checked_sub(first).and_then(|steps| steps.checked_add(1)) {
            Some(samples) if samples == self.rows() => Ok(Some(first..last + 1)),
            _ => Err(StoreError::Unlike(format!(
                "{}: it has {} rows, but its samples are numbered from {first} to {last}; delete this file and run \
                 the study again, which computes its samples again",
                self.path.display(),
                self.rows()
            ))),
        }
    }

    /// Reads the first `most` rows of one column of a group.
    fn column(&self, group: usize, column: usize, most: usize) -> Result<Column, StoreError> {
        let group = self.verified(group)?;
        let read = || {
            let mut reader = group.get_column_reader(column)?;
            let mut rows = Column::before(&reader)?;
            rows.read(&mut reader, most)?;
            Ok(rows)
        };
        read().map_err(|error| self.wrong(&error))
    }
}

/// Verifies a file of results of any study, and returns its number of samples.
///
/// # Errors
///
/// Fails if the file cannot be read, is damaged, or contains no results. Returns [`StoreError::Stopped`] if `watch`
/// stops the work.
pub fn verify(path: &Path, watch: &mut Watch) -> Result<u64, StoreError> {
    let results = Results::open(path)?;
    results.verify(&mut counted(results.rows(), watch))?;
    Ok(results.rows())
}

/// Returns a function that receives the number of rows of each verified row group. The function reports to `watch` how
/// many rows have been verified so far, out of `of` rows.
pub fn counted(of: u64, watch: &mut Watch) -> impl FnMut(u64) -> Result<(), StoreError> {
    let mut done = 0;
    move |rows| {
        done += rows;
        let now = Progress { stage: Stage::Verifying, done, before: 0, of };
        if watch(now).is_break() { Err(StoreError::Stopped) } else { Ok(()) }
    }
}

/// Number of rows that the file states, or 0 if the stated number is negative.
fn rows(stated: i64) -> usize {
    usize::try_from(stated).unwrap_or(0)
}

/// A complete file of results, read column by column.
pub struct Whole {
    results: Results,
}

impl Whole {
    /// Opens a file that contains exactly these samples of the study. Returns `None` if the file does not exist.
    pub fn of(path: &Path, head: &Head, samples: &Range<u64>) -> Result<Option<Self>, StoreError> {
        if !path.exists() {
            return Ok(None);
        }
        let results = Results::open(path)?;
        if results.head().get("digest") != head.get("digest") {
            return Err(StoreError::Foreign(path.to_owned()));
        }
        if results.samples()?.as_ref() != Some(samples) {
            return Err(StoreError::Unlike(format!(
                "{}: this file does not contain the samples {} to {}; name another file, or \
                 start again with the option `restart`",
                path.display(),
                samples.start,
                samples.end - 1
            )));
        }
        Ok(Some(Whole { results }))
    }

    /// Verifies all rows.
    pub fn verify(&self, watch: &mut Watch) -> Result<(), StoreError> {
        self.results.verify(&mut counted(self.results.rows(), watch))
    }

    /// Number of groups of rows in the file.
    pub fn groups(&self) -> usize {
        self.results.groups()
    }

    /// A column of numbers in a group of rows; missing numbers are NaN.
    pub fn numbers(&self, group: usize, name: &str) -> Result<Vec<f64>, StoreError> {
        let Column { values, definitions, .. } = self.column(group, name)?;
        let Values::Numbers(numbers) = values else { return Ok(Vec::new()) };
        let mut numbers = numbers.into_iter();
        let number = |level: &i16| if *level > 0 { numbers.next() } else { None };
        Ok(definitions.iter().map(number).map(|number| number.unwrap_or(f64::NAN)).collect())
    }

    /// Passes each text of a column in a group of rows to `take`.
    pub fn words(
        &self,
        group: usize,
        name: &str,
        mut take: impl FnMut(&str),
    ) -> Result<(), StoreError> {
        if let Values::Words(words) = self.column(group, name)?.values {
            words.iter().for_each(|word| take(word.as_utf8().unwrap_or_default()));
        }
        Ok(())
    }

    fn column(&self, group: usize, name: &str) -> Result<Column, StoreError> {
        let Results { path, file, .. } = &self.results;
        let columns = self.results.metadata().file_metadata().schema_descr().columns();
        let place = columns.iter().position(|column| column.path().parts() == [name]);
        let missing = || StoreError::File(path.clone(), format!("there is no column {name:?}"));
        let most = rows(file.metadata().row_group(group).num_rows());
        self.results.column(group, place.ok_or_else(missing)?, most)
    }
}
