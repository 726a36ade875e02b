//! Converts columns to the representation of Parquet, which consists of the existing values and of levels.
//!
//! The definition level of an entry is 0 without a value or list, and has its maximum with a value. The repetition
//! level is 0 for the first entry of a row and 1 for the others (Melnik and others, *Dremel*, PVLDB 3 (2010), section
//! 4).

use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::column::reader::ColumnReader;
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::{ParquetError, Result};
use parquet::schema::types::{GroupTypeBuilder, Type, TypePtr};
use std::sync::Arc;

/// The kind of a column of results.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// An integer in every row.
    Whole,
    /// Text in every row or in some rows.
    Word(Repetition),
    /// A number, which may be missing.
    Number,
    /// A list of numbers. The whole list may be missing in a row.
    Numbers,
}

impl Kind {
    /// Returns the schema of a column of this kind with the given name.
    pub fn column(self, name: &str) -> TypePtr {
        let one = |name: &str, physical, logical, repetition| {
            let built = Type::primitive_type_builder(name, physical)
                .with_logical_type(logical)
                .with_repetition(repetition)
                .build();
            Arc::new(built.expect("a column of one value"))
        };
        let group = |group: GroupTypeBuilder, of: TypePtr, repetition| {
            let built = group.with_fields(vec![of]).with_repetition(repetition).build();
            Arc::new(built.expect("a group of one column"))
        };
        let number = |name: &str| one(name, Physical::DOUBLE, None, Repetition::OPTIONAL);
        match self {
            Kind::Whole => {
                let whole = Some(LogicalType::integer(64, false));
                one(name, Physical::INT64, whole, Repetition::REQUIRED)
            }
            Kind::Word(repetition) => {
                one(name, Physical::BYTE_ARRAY, Some(LogicalType::String), repetition)
            }
            Kind::Number => number(name),
            Kind::Numbers => {
                let places = Type::group_type_builder("list");
                let places = group(places, number("item"), Repetition::REPEATED);
                let list =
                    Type::group_type_builder(name).with_logical_type(Some(LogicalType::List));
                group(list, places, Repetition::OPTIONAL)
            }
        }
    }
}

/// The values of a column, without the missing ones.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Integers, stored as the bits of a `u64`.
    Whole(Vec<i64>),
    /// Numbers.
    Numbers(Vec<f64>),
    /// Texts in UTF-8.
    Words(Vec<ByteArray>),
}

/// Some rows of a column.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    pub values: Values,
    /// Parquet definition level of each entry; empty if every row has a value.
    pub definitions: Vec<i16>,
    /// Parquet repetition level of each entry; empty unless the column contains lists.
    repetitions: Vec<i16>,
}

impl Column {
    /// A column without rows.
    fn empty(values: Values) -> Self {
        Column { values, definitions: Vec::new(), repetitions: Vec::new() }
    }

    /// A column of integers.
    pub fn whole(numbers: impl Iterator<Item = u64>) -> Self {
        Column::empty(Values::Whole(numbers.map(u64::cast_signed).collect()))
    }

    /// A column with a text in every row.
    pub fn words<'a>(words: impl Iterator<Item = &'a str>) -> Self {
        Column::empty(Values::Words(words.map(ByteArray::from).collect()))
    }

    /// A column with a text in some rows.
    pub fn some_words(words: impl Iterator<Item = Option<String>>) -> Self {
        let mut all = Vec::new();
        let mut definitions = Vec::new();
        for word in words {
            definitions.push(i16::from(word.is_some()));
            all.extend(word.map(|word| ByteArray::from(word.into_bytes())));
        }
        Column { definitions, ..Column::empty(Values::Words(all)) }
    }

    /// A column of numbers, in which NaN becomes a missing value.
    pub fn numbers(numbers: impl Iterator<Item = f64>) -> Self {
        let mut values = Vec::new();
        let mut definitions = Vec::new();
        for number in numbers {
            definitions.push(i16::from(!number.is_nan()));
            values.extend((!number.is_nan()).then_some(number));
        }
        Column { definitions, ..Column::empty(Values::Numbers(values)) }
    }

    /// Creates a column of lists of numbers, with one row for each entry of `lists`. `None` becomes a row
    /// without a list (a null value).
    pub fn lists<'a>(lists: impl Iterator<Item = Option<&'a [f64]>>) -> Self {
        let mut values = Vec::new();
        let (mut definitions, mut repetitions) = (Vec::new(), Vec::new());
        for list in lists {
            match list {
                None | Some([]) => {
                    definitions.push(i16::from(list.is_some()));
                    repetitions.push(0);
                }
                Some(numbers) => {
                    values.extend_from_slice(numbers);
                    definitions.extend(numbers.iter().map(|_| 3));
                    repetitions.extend((0..numbers.len()).map(|i| i16::from(i > 0)));
                }
            }
        }
        Column { values: Values::Numbers(values), definitions, repetitions }
    }

    /// Appends the rows of another column of the same kind.
    pub fn append(&mut self, other: Column) {
        match (&mut self.values, other.values) {
            (Values::Whole(all), Values::Whole(more)) => all.extend(more),
            (Values::Numbers(all), Values::Numbers(more)) => all.extend(more),
            (Values::Words(all), Values::Words(more)) => all.extend(more),
            _ => debug_assert!(false, "columns of two kinds"),
        }
        self.definitions.extend(other.definitions);
        self.repetitions.extend(other.repetitions);
    }

    /// An empty column with the type of values that the reader reads.
    pub fn before(reader: &ColumnReader) -> Result<Self> {
        Ok(Column::empty(match reader {
            ColumnReader::Int64ColumnReader(_) => Values::Whole(Vec::new()),
            ColumnReader::DoubleColumnReader(_) => Values::Numbers(Vec::new()),
            ColumnReader::ByteArrayColumnReader(_) => Values::Words(Vec::new()),
            _ => return Err(foreign()),
        }))
    }

    /// Appends the next `count` rows of a reader.
    pub fn read(&mut self, reader: &mut ColumnReader, count: usize) -> Result<()> {
        let levels = (Some(&mut self.definitions), Some(&mut self.repetitions));
        let (rows, _, _) = match (reader, &mut self.values) {
            (ColumnReader::Int64ColumnReader(reader), Values::Whole(values)) => {
                reader.read_records(count, levels.0, levels.1, values)?
            }
            (ColumnReader::DoubleColumnReader(reader), Values::Numbers(values)) => {
                reader.read_records(count, levels.0, levels.1, values)?
            }
            (ColumnReader::ByteArrayColumnReader(reader), Values::Words(values)) => {
                reader.read_records(count, levels.0, levels.1, values)?
            }
            _ => return Err(foreign()),
        };
        if rows == count {
            Ok(())
        } else {
            Err(ParquetError::EOF(format!("the column has {rows} rows instead of {count}")))
        }
    }

    /// Removes all rows.
    pub fn clear(&mut self) {
        match &mut self.values {
            Values::Whole(values) => values.clear(),
            Values::Numbers(values) => values.clear(),
            Values::Words(values) => values.clear(),
        }
        self.definitions.clear();
        self.repetitions.clear();
    }

    /// Writes all rows at once.
    pub fn write(&self, writer: &mut ColumnWriter) -> Result<()> {
        let definitions = Some(&*self.definitions).filter(|levels| !levels.is_empty());
        let repetitions = Some(&*self.repetitions).filter(|levels| !levels.is_empty());
        match (writer, &self.values) {
            (ColumnWriter::Int64ColumnWriter(writer), Values::Whole(values)) => {
                writer.write_batch(values, definitions, repetitions)?
            }
            (ColumnWriter::DoubleColumnWriter(writer), Values::Numbers(values)) => {
                writer.write_batch(values, definitions, repetitions)?
            }
            (ColumnWriter::ByteArrayColumnWriter(writer), Values::Words(values)) => {
                writer.write_batch(values, definitions, repetitions)?
            }
            _ => return Err(foreign()),
        };
        Ok(())
    }
}

/// Returns the error for a file that has a column of an unexpected type. Results files have no such column.
fn foreign() -> ParquetError {
    ParquetError::General(
        "the file has a column of a type that does not occur in study results".to_owned(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tests the repetition and definition levels of lists of numbers, of an empty list and of a missing list.
    /// The Parquet format prescribes the expected levels.
    #[test]
    fn lists_have_their_definition_and_repetition_levels() {
        let lists = [Some(&[1.0, 2.0][..]), Some(&[]), None, Some(&[3.0])];
        let Column { values, definitions, repetitions } = Column::lists(lists.into_iter());
        assert_eq!(values, Values::Numbers(vec![1.0, 2.0, 3.0]));
        assert_eq!(definitions, [3, 3, 1, 0, 3]);
        assert_eq!(repetitions, [0, 1, 0, 0, 0]);
    }

    #[test]
    fn values_that_are_not_numbers_are_skipped() {
        let column = Column::numbers([1.0, f64::NAN, f64::INFINITY].into_iter());
        assert_eq!(column.values, Values::Numbers(vec![1.0, f64::INFINITY]));
        assert_eq!(column.definitions, [1, 0, 1]);
    }
}
