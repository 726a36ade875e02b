//! Writes files of results, and compresses rows in groups of equal size.
//!
//! A file gets its name only after it is complete and on the disk ([`Output`]).

use super::StoreError;
use super::checksum::Sealed;
use super::column::Column;
use super::read::Results;
use super::table::{Head, Table};
use groundbeam_file::output::Output;
use parquet::basic::Compression;
use parquet::errors::{ParquetError, Result as Done};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::ColumnPath;
use std::path::Path;
use std::sync::Arc;

/// Number of rows in a group, which are compressed together.
const ROWS_IN_A_GROUP: usize = 1 << 16;

/// The compression level of a file.
#[derive(Debug, Clone, Copy)]
pub enum Packing {
    /// A file that is kept.
    Kept,
    /// A file that is soon merged into another one.
    Passing,
}

/// A file of results that is being written.
pub struct Writer<'a> {
    path: &'a Path,
    file: SerializedFileWriter<Sealed<Output>>,
    /// Rows that are not yet written. Each call of the Parquet writer receives the same number of rows, because
    /// this number determines where the pages of the file end.
    waiting: Vec<Column>,
    rows: usize,
}

impl<'a> Writer<'a> {
    /// Creates a file.
    pub fn new(path: &'a Path, table: &Table, packing: Packing) -> Result<Self, StoreError> {
        let output = Output::create(path).map_err(|error| StoreError::io(path, &error))?;
        let schema = Arc::clone(&table.schema);
        let properties = Arc::new(properties(&table.head, packing));
        let file = SerializedFileWriter::new(Sealed::new(output), schema, properties);
        let file = file.map_err(|error| StoreError::parquet(path, &error))?;
        Ok(Writer { path, file, waiting: Vec::new(), rows: 0 })
    }

    /// Appends at most one group of rows.
    pub fn write(&mut self, columns: Vec<Column>, rows: usize) -> Result<(), StoreError> {
        (self.waiting, self.rows) = (columns, rows);
        self.hand_over()
    }

    /// Appends all rows of another file; `copied` receives the number of copied rows from time to time.
    pub fn copy(
        &mut self,
        results: &Results,
        copied: &mut dyn FnMut(usize) -> Result<(), StoreError>,
    ) -> Result<(), StoreError> {
        let wrong = |error: ParquetError| results.wrong(&error);
        if results.schema().get_fields() != self.file.schema_descr().root_schema().get_fields() {
            return Err(wrong(ParquetError::General("it has other columns".to_owned())));
        }
        for group in 0..results.groups() {
            let (mut readers, mut left) = results.group(group)?;
            if self.waiting.is_empty() {
                let empty = readers.iter().map(Column::before);
                self.waiting = empty.collect::<Done<_>>().map_err(wrong)?;
            }
            while left > 0 {
                let rows = left.min(ROWS_IN_A_GROUP - self.rows);
                for (column, reader) in self.waiting.iter_mut().zip(&mut readers) {
                    column.read(reader, rows).map_err(wrong)?;
                }
                left -= rows;
                self.rows += rows;
                if self.rows == ROWS_IN_A_GROUP {
                    self.hand_over()?;
                }
                copied(rows)?;
            }
        }
        Ok(())
    }

    /// Writes the waiting rows.
    fn hand_over(&mut self) -> Result<(), StoreError> {
        let write = |file: &mut SerializedFileWriter<_>, columns: &mut [Column]| -> Done<()> {
            let mut group = file.next_row_group()?;
            for column in columns {
                if let Some(mut writer) = group.next_column()? {
                    column.write(writer.untyped())?;
                    writer.close()?;
                }
                column.clear();
            }
            group.close()?;
            file.flush()?;
            Ok(())
        };
        self.rows = 0;
        write(&mut self.file, &mut self.waiting)
            .map_err(|error| StoreError::parquet(self.path, &error))?;
        self.file.inner_mut().end_block();
        Ok(())
    }

    /// Completes the file and gives it its final name.
    pub fn finish(mut self) -> Result<(), StoreError> {
        if self.rows > 0 {
            self.hand_over()?;
        }
        let checksums = self.file.inner_mut().begin_tail();
        self.file.append_key_value_metadata(checksums);
        let sealed = self.file.into_inner();
        let sealed = sealed.map_err(|error| StoreError::parquet(self.path, &error))?;
        let finished = sealed.finish().and_then(Output::finish);
        finished.map_err(|error| StoreError::io(self.path, &error))
    }
}

/// Sets the compression, the statistics and the header of a file.
fn properties(head: &Head, packing: Packing) -> WriterProperties {
    let pairs = head.pairs.iter();
    let pairs = pairs.map(|(key, value)| KeyValue::new(key.clone(), value.clone())).collect();
    let (compression, statistics) = match packing {
        Packing::Kept => (Compression::SNAPPY, EnabledStatistics::Chunk),
        Packing::Passing => (Compression::UNCOMPRESSED, EnabledStatistics::None),
    };
    WriterProperties::builder()
        .set_compression(compression)
        // Most columns have no dictionary, because nearly all numbers are different. The two columns of texts
        // have one, because nearly all texts are equal.
        .set_dictionary_enabled(false)
        .set_column_dictionary_enabled(ColumnPath::from("status"), true)
        .set_column_dictionary_enabled(ColumnPath::from("message"), true)
        .set_statistics_enabled(statistics)
        .set_key_value_metadata(Some(pairs))
        .build()
}
