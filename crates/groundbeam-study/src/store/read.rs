//! Files of results, read again.

use super::StoreError;
use super::table::Head;
use arrow_array::Array;
use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, UInt64Type};
use parquet::arrow::ProjectionMask;
use parquet::arrow::arrow_reader::{ParquetRecordBatchReader, ParquetRecordBatchReaderBuilder};
use std::fs::File;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// A file of results.
pub struct Columns {
    path: PathBuf,
    builder: ParquetRecordBatchReaderBuilder<File>,
}

/// What a file of results says of itself.
pub fn head_of(path: &Path) -> Result<Head, StoreError> {
    Ok(Columns::open(path)?.head())
}

impl Columns {
    pub fn open(path: &Path) -> Result<Self, StoreError> {
        let file = File::open(path).map_err(|error| StoreError::io(path, &error))?;
        let builder = ParquetRecordBatchReaderBuilder::try_new(file);
        let builder = builder.map_err(|error| StoreError::parquet(path, &error))?;
        Ok(Columns { path: path.to_owned(), builder })
    }

    /// What it says of itself.
    pub fn head(&self) -> Head {
        let pairs = self.builder.metadata().file_metadata().key_value_metadata();
        let ours = pairs.into_iter().flatten().filter(|pair| pair.key.starts_with("groundbeam."));
        let ours = ours.map(|pair| (pair.key.clone(), pair.value.clone().unwrap_or_default()));
        Head { pairs: ours.collect() }
    }

    /// How many rows it has.
    pub fn rows(&self) -> u64 {
        u64::try_from(self.builder.metadata().file_metadata().num_rows()).unwrap_or(0)
    }

    /// Its columns, as the file describes them.
    pub fn schema(&self) -> arrow_schema::SchemaRef {
        // What the file says of itself is kept apart from its columns.
        let schema = self.builder.schema();
        std::sync::Arc::new(arrow_schema::Schema::new(schema.fields().clone()))
    }

    /// The number of its first sample.
    pub fn first(self) -> Result<Option<u64>, StoreError> {
        let path = self.path.clone();
        let Some(batch) = self.batches()?.next() else { return Ok(None) };
        let batch = batch.map_err(|error| StoreError::File(path, error.to_string()))?;
        Ok(batch.column(0).as_primitive::<UInt64Type>().values().first().copied())
    }

    /// All rows, in batches.
    pub fn batches(self) -> Result<ParquetRecordBatchReader, StoreError> {
        let path = self.path;
        self.builder
            .with_batch_size(super::table::ROWS_IN_A_GROUP)
            .build()
            .map_err(|error| StoreError::parquet(&path, &error))
    }
}

/// A whole file of results, of which columns are read one by one.
#[derive(Debug)]
pub struct Whole {
    path: PathBuf,
}

impl Whole {
    /// The file, if it is there and holds these samples of the study and no other.
    pub fn of(path: &Path, head: &Head, samples: &Range<u64>) -> Result<Option<Self>, StoreError> {
        if !path.exists() {
            return Ok(None);
        }
        let columns = Columns::open(path)?;
        if columns.head().get("digest") != head.get("digest") {
            return Err(StoreError::Foreign(path.to_owned()));
        }
        let rows = columns.rows();
        if columns.first()? != Some(samples.start) || rows != samples.end - samples.start {
            return Err(StoreError::Unlike(format!(
                "{}: it holds other samples of the study than {} to {}; name another file, or --restart",
                path.display(),
                samples.start,
                samples.end - 1
            )));
        }
        Ok(Some(Whole { path: path.to_owned() }))
    }

    /// A column of numbers; null is not a number.
    pub fn numbers(&self, name: &str) -> Result<Vec<f64>, StoreError> {
        let mut all = Vec::new();
        self.each(name, |column| match column.as_primitive_opt::<Float64Type>() {
            Some(numbers) => all.extend(numbers.iter().map(|value| value.unwrap_or(f64::NAN))),
            None => {
                let whole = column.as_primitive::<UInt64Type>();
                all.extend(whole.iter().map(|value| value.map_or(f64::NAN, |value| value as f64)));
            }
        })?;
        Ok(all)
    }

    /// A column of words.
    pub fn words(&self, name: &str, mut take: impl FnMut(&str)) -> Result<(), StoreError> {
        self.each(name, |column| column.as_string::<i32>().iter().flatten().for_each(&mut take))
    }

    fn each(&self, name: &str, mut take: impl FnMut(&dyn Array)) -> Result<(), StoreError> {
        let wrong = |what: String| StoreError::File(self.path.clone(), what);
        let Columns { builder, .. } = Columns::open(&self.path)?;
        let schema = builder.schema();
        let index = schema.index_of(name).map_err(|error| wrong(error.to_string()))?;
        let mask = ProjectionMask::roots(builder.parquet_schema(), [index]);
        let reader = builder.with_projection(mask).with_batch_size(super::table::ROWS_IN_A_GROUP);
        let reader = reader.build().map_err(|error| StoreError::parquet(&self.path, &error))?;
        for batch in reader {
            take(batch.map_err(|error| wrong(error.to_string()))?.column(0));
        }
        Ok(())
    }
}
