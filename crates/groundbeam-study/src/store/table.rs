//! The columns of results, and what stands at the head of a file of them.

use super::StoreError;
use crate::draws::{Draw, Draws};
use crate::row::{Row, Trouble, Wanted};
use arrow_array::builder::{
    FixedSizeListBuilder, Float64Builder, ListBuilder, StringBuilder, UInt64Builder,
};
use arrow_array::{ArrayRef, RecordBatch};
use arrow_schema::{DataType, Field, Schema};
use groundbeam_file::study::StudyFile;
use parquet::arrow::ArrowWriter;
use parquet::basic::Compression;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::schema::types::ColumnPath;
use sha2::{Digest, Sha256};
use std::fs::File;
use std::path::Path;
use std::sync::Arc;

/// Rows that are compressed together.
pub const ROWS_IN_A_GROUP: usize = 1 << 16;

/// What a file of results says of itself: keys and values.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Head {
    pub pairs: Vec<(String, String)>,
}

impl Head {
    /// Of a study and how it is sampled.
    pub fn of(draws: &Draws) -> Self {
        let (StudyFile { document, text, .. }, plan) = (draws.study(), draws.plan());
        let mut pairs: Vec<(String, String)> = [
            ("version", env!("CARGO_PKG_VERSION").to_owned()),
            (
                "units",
                if document.units == groundbeam_file::UnitSystem::Si { "SI" } else { "none" }
                    .to_owned(),
            ),
            ("samples", plan.samples.to_string()),
            ("seed", plan.seed.to_string()),
            ("sampling", plan.sampling.name().to_owned()),
            ("replicates", plan.replicates.to_string()),
            ("study", text.clone()),
            ("model", document.text().to_owned()),
        ]
        .into_iter()
        .map(|(key, value)| (format!("groundbeam.{key}"), value))
        .collect();
        let mut digest = Sha256::new();
        for (key, value) in &pairs {
            for part in [key, value] {
                digest.update((part.len() as u64).to_le_bytes());
                digest.update(part);
            }
        }
        let hex: String = digest.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
        pairs.push(("groundbeam.digest".to_owned(), hex));
        Head { pairs }
    }

    /// The value of a key.
    pub fn get(&self, key: &str) -> Option<&str> {
        let pair =
            self.pairs.iter().find(|(name, _)| name.strip_prefix("groundbeam.") == Some(key));
        pair.map(|(_, value)| &**value)
    }
}

/// The columns of a study.
#[derive(Debug, Clone)]
pub struct Table {
    pub head: Head,
    pub schema: Arc<Schema>,
    pub wanted: Wanted,
    /// How many points the random fields have, if they are kept.
    ground: Option<usize>,
}

impl Table {
    /// The columns that a study asks for.
    pub fn of(draws: &Draws) -> Self {
        let StudyFile { random, field, keep, events, .. } = draws.study();
        let mut extremes = keep.extremes.clone();
        for needed in events.iter().filter_map(|event| event.of.field()) {
            if !extremes.contains(&needed) {
                extremes.push(needed);
            }
        }
        let wanted = Wanted { at: keep.at.clone(), fields: keep.fields.clone(), extremes };
        let number = |name: String| Field::new(name, DataType::Float64, true);
        let mut columns = vec![
            Field::new("sample", DataType::UInt64, false),
            Field::new("status", DataType::Utf8, false),
        ];
        columns.extend(random.iter().map(|random| number(random.name.clone())));
        let ground = field.as_ref().filter(|_| keep.ground).map(|field| field.points);
        if let (Some(field), Some(points)) = (field, ground) {
            let item = Arc::new(Field::new("item", DataType::Float64, true));
            let size = i32::try_from(points).unwrap_or(i32::MAX);
            columns.extend(field.of.iter().map(|of| {
                Field::new(of.name(), DataType::FixedSizeList(Arc::clone(&item), size), true)
            }));
        }
        let fixed = [
            "left",
            "right",
            "lifted_share",
            "relative_gap",
            "motion_left",
            "motion_right",
            "motion_work",
        ];
        columns.extend(fixed.map(|name| number(name.to_owned())));
        for field in &wanted.extremes {
            let parts = ["min_x", "min", "max_x", "max"];
            columns.extend(parts.map(|part| number(format!("{}_{part}", field.name()))));
        }
        for field in &wanted.fields {
            columns.extend(wanted.at.iter().map(|x| number(format!("{}@{x}", field.name()))));
        }
        let edges = Arc::new(Field::new("item", DataType::Float64, true));
        columns.push(Field::new("contact", DataType::List(edges), true));
        columns.push(Field::new("message", DataType::Utf8, true));
        Table { head: Head::of(draws), schema: Arc::new(Schema::new(columns)), wanted, ground }
    }

    /// Those of a file that is there.
    pub fn read(head: Head, schema: Arc<Schema>) -> Self {
        Table { head, schema, wanted: Wanted::default(), ground: None }
    }

    /// Rows of consecutive samples as columns.
    pub fn batch(&self, first: u64, rows: &[(Draw, Row)]) -> RecordBatch {
        let mut columns: Vec<ArrayRef> = Vec::with_capacity(self.schema.fields().len());
        let mut samples = UInt64Builder::with_capacity(rows.len());
        let mut status = StringBuilder::with_capacity(rows.len(), 8 * rows.len());
        for (i, (_, row)) in rows.iter().enumerate() {
            samples.append_value(first + i as u64);
            status.append_value(row.status.name());
        }
        columns.push(Arc::new(samples.finish()));
        columns.push(Arc::new(status.finish()));
        let random = rows.first().map_or(0, |(draw, _)| draw.numbers.len());
        columns.extend((0..random).map(|i| numbers(rows, |(draw, _)| draw.numbers[i])));
        if let Some(points) = self.ground {
            let fields = rows.first().map_or(0, |(draw, _)| draw.fields.len());
            columns.extend((0..fields).map(|i| lists(rows, points, i)));
        }
        columns.extend([0, 1].map(|end| numbers(rows, |(_, row)| row.end_forces[end])));
        columns.push(numbers(rows, |(_, row)| row.lifted_share));
        columns.push(numbers(rows, |(_, row)| row.relative_gap));
        columns.extend([0, 1, 2].map(|i| numbers(rows, |(_, row)| row.motion[i])));
        for field in 0..self.wanted.extremes.len() {
            columns.extend([0, 1, 2, 3].map(|i| numbers(rows, |(_, row)| row.extremes[field][i])));
        }
        let values = self.wanted.fields.len() * self.wanted.at.len();
        columns.extend((0..values).map(|i| numbers(rows, |(_, row)| row.values[i])));
        let mut contact = ListBuilder::new(Float64Builder::new());
        let mut messages = StringBuilder::new();
        for (_, row) in rows {
            contact.values().append_slice(row.contact.as_flattened());
            contact.append(row.trouble.is_none());
            match row.trouble.as_deref() {
                Some(Trouble::Failed(error)) => messages.append_value(error.to_string()),
                _ => messages.append_null(),
            }
        }
        columns.push(Arc::new(contact.finish()));
        columns.push(Arc::new(messages.finish()));
        RecordBatch::try_new(Arc::clone(&self.schema), columns)
            .expect("columns as the schema has them")
    }

    /// A new file for rows of these columns.
    pub fn writer(&self, path: &Path) -> Result<ArrowWriter<File>, StoreError> {
        writer(path, &self.schema, &self.head)
    }
}

/// A new file of results.
pub fn writer(
    path: &Path,
    schema: &Arc<Schema>,
    head: &Head,
) -> Result<ArrowWriter<File>, StoreError> {
    let file = File::create(path).map_err(|error| StoreError::io(path, &error))?;
    let pairs = head.pairs.iter();
    let pairs = pairs.map(|(key, value)| KeyValue::new(key.clone(), value.clone())).collect();
    let properties = WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        // Numbers of which hardly two are equal; words of which nearly all are.
        .set_dictionary_enabled(false)
        .set_column_dictionary_enabled(ColumnPath::from("status"), true)
        .set_column_dictionary_enabled(ColumnPath::from("message"), true)
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_max_row_group_row_count(Some(ROWS_IN_A_GROUP))
        .set_key_value_metadata(Some(pairs))
        .build();
    ArrowWriter::try_new(file, Arc::clone(schema), Some(properties))
        .map_err(|error| StoreError::parquet(path, &error))
}

/// A column of numbers; what is not a number is null.
fn numbers(rows: &[(Draw, Row)], of: impl Fn(&(Draw, Row)) -> f64) -> ArrayRef {
    let mut column = Float64Builder::with_capacity(rows.len());
    for row in rows {
        let value = of(row);
        column.append_option((!value.is_nan()).then_some(value));
    }
    Arc::new(column.finish())
}

/// A column of a random field at its points.
fn lists(rows: &[(Draw, Row)], points: usize, field: usize) -> ArrayRef {
    let size = i32::try_from(points).unwrap_or(i32::MAX);
    let mut column = FixedSizeListBuilder::new(Float64Builder::new(), size);
    for (draw, _) in rows {
        column.values().append_slice(&draw.fields[field]);
        column.append(true);
    }
    Arc::new(column.finish())
}
