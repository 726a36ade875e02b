//! Files of results, read again.

use super::StoreError;
use super::column::{Column, Values};
use super::table::Head;
use groundbeam_file::open_file;
use parquet::column::reader::ColumnReader;
use parquet::errors::{ParquetError, Result as Done};
use parquet::file::metadata::ParquetMetaData;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::schema::types::TypePtr;
use std::fs::File;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// A file of results.
pub struct Results {
    path: PathBuf,
    file: SerializedFileReader<File>,
}

impl Results {
    pub fn open(path: &Path) -> Result<Self, StoreError> {
        let file = open_file(path).map_err(|error| StoreError::io(path, &error))?;
        let file = SerializedFileReader::new(file);
        let file = file.map_err(|error| StoreError::parquet(path, &error))?;
        Ok(Results { path: path.to_owned(), file })
    }

    fn metadata(&self) -> &ParquetMetaData {
        self.file.metadata()
    }

    /// What is wrong with this file.
    pub fn wrong(&self, error: &ParquetError) -> StoreError {
        StoreError::parquet(&self.path, error)
    }

    /// What it says of itself.
    pub fn head(&self) -> Head {
        let pairs = self.metadata().file_metadata().key_value_metadata();
        let ours = pairs.into_iter().flatten().filter(|pair| pair.key.starts_with("groundbeam."));
        let ours = ours.map(|pair| (pair.key.clone(), pair.value.clone().unwrap_or_default()));
        Head { pairs: ours.collect() }
    }

    /// How many rows it has.
    pub fn rows(&self) -> u64 {
        u64::try_from(self.metadata().file_metadata().num_rows()).unwrap_or(0)
    }

    /// Its columns.
    pub fn schema(&self) -> TypePtr {
        self.metadata().file_metadata().schema_descr().root_schema_ptr()
    }

    /// How many groups of rows it has.
    pub fn groups(&self) -> usize {
        self.metadata().num_row_groups()
    }

    /// The columns of a group, to be read, and how many rows it has.
    pub fn group(&self, group: usize) -> Done<(Vec<ColumnReader>, usize)> {
        let group = self.file.get_row_group(group)?;
        let columns = 0..group.metadata().num_columns();
        let columns = columns.map(|column| group.get_column_reader(column)).collect::<Done<_>>()?;
        Ok((columns, rows(group.metadata().num_rows())))
    }

    /// The number of its first sample.
    pub fn first(&self) -> Result<Option<u64>, StoreError> {
        if self.groups() == 0 {
            return Ok(None);
        }
        let first = self.column(0, 0, 1).map_err(|error| self.wrong(&error))?;
        Ok(match first.values {
            Values::Whole(numbers) => numbers.first().copied().map(i64::cast_unsigned),
            _ => None,
        })
    }

    /// The first rows of a group in one column.
    fn column(&self, group: usize, column: usize, most: usize) -> Done<Column> {
        let mut reader = self.file.get_row_group(group)?.get_column_reader(column)?;
        let mut rows = Column::before(&reader)?;
        rows.read(&mut reader, most)?;
        Ok(rows)
    }
}

/// A number of rows as the file states it.
fn rows(stated: i64) -> usize {
    usize::try_from(stated).unwrap_or(0)
}

/// A whole file of results, of which columns are read one by one.
pub struct Whole {
    results: Results,
}

impl Whole {
    /// The file, if it is there and holds these samples of the study and no other.
    pub fn of(path: &Path, head: &Head, samples: &Range<u64>) -> Result<Option<Self>, StoreError> {
        if !path.exists() {
            return Ok(None);
        }
        let results = Results::open(path)?;
        if results.head().get("digest") != head.get("digest") {
            return Err(StoreError::Foreign(path.to_owned()));
        }
        if results.first()? != Some(samples.start) || results.rows() != samples.end - samples.start
        {
            return Err(StoreError::Unlike(format!(
                "{}: it holds other samples of the study than {} to {}; name another file, or --restart",
                path.display(),
                samples.start,
                samples.end - 1
            )));
        }
        Ok(Some(Whole { results }))
    }

    /// In how many groups its rows are read.
    pub fn groups(&self) -> usize {
        self.results.groups()
    }

    /// A column of numbers in a group of rows; where there is none it is not a number.
    pub fn numbers(&self, group: usize, name: &str) -> Result<Vec<f64>, StoreError> {
        let Column { values, definitions, .. } = self.column(group, name)?;
        let Values::Numbers(numbers) = values else { return Ok(Vec::new()) };
        let mut numbers = numbers.into_iter();
        let number = |level: &i16| if *level > 0 { numbers.next() } else { None };
        Ok(definitions.iter().map(number).map(|number| number.unwrap_or(f64::NAN)).collect())
    }

    /// A column of words in a group of rows.
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
        let Results { path, file } = &self.results;
        let columns = self.results.metadata().file_metadata().schema_descr().columns();
        let place = columns.iter().position(|column| column.path().parts() == [name]);
        let missing = || StoreError::File(path.clone(), format!("there is no column {name:?}"));
        let most = rows(file.metadata().row_group(group).num_rows());
        let column = self.results.column(group, place.ok_or_else(missing)?, most);
        column.map_err(|error| self.results.wrong(&error))
    }
}
