//! Computes the contents of a study's results file: the header from the study's settings, the columns from the sample results.

use super::checksum::hex;
use super::column::{Column, Kind};
use crate::draws::{Draw, Draws};
use crate::row::{Row, Trouble, Wanted};
use groundbeam_file::Document;
use groundbeam_file::study::StudyFile;
use parquet::basic::Repetition;
use parquet::schema::types::{Type, TypePtr};
use sha2::{Digest, Sha256};
use std::sync::Arc;

/// The header of a file of results: keys and values.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Head {
    pub pairs: Vec<(String, String)>,
}

impl Head {
    /// Creates the header of a results file from the sampling plan, the study file and the model file of a
    /// study.
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
        .chain(files_of(document).map(|files| ("files", files)))
        .map(|(key, value)| (format!("groundbeam.{key}"), value))
        .collect();
        let mut digest = Sha256::new();
        for (key, value) in &pairs {
            for part in [key, value] {
                digest.update((part.len() as u64).to_le_bytes());
                digest.update(part);
            }
        }
        pairs.push(("groundbeam.digest".to_owned(), hex(digest)));
        Head { pairs }
    }

    /// The value of a key.
    pub fn get(&self, key: &str) -> Option<&str> {
        let pair =
            self.pairs.iter().find(|(name, _)| name.strip_prefix("groundbeam.") == Some(key));
        pair.map(|(_, value)| &**value)
    }
}

/// Digests of the texts of the files that a model names, in order; `None` if the model names no file.
fn files_of(document: &Document) -> Option<String> {
    let digests = document.files.iter().map(|file| hex(Sha256::new_with_prefix(&file.text)));
    let digests: Vec<String> = digests.collect();
    (!digests.is_empty()).then(|| digests.join(" "))
}

/// The columns of a study.
#[derive(Debug, Clone)]
pub struct Table {
    pub head: Head,
    pub schema: TypePtr,
    pub wanted: Wanted,
    /// Whether the random fields are stored.
    ground: bool,
}

impl Table {
    /// The columns that a study needs.
    pub fn of(draws: &Draws) -> Self {
        let StudyFile { random, field, keep, events, .. } = draws.study();
        let mut extremes = keep.extremes.clone();
        for needed in events.iter().filter_map(|event| event.of.field()) {
            if !extremes.contains(&needed) {
                extremes.push(needed);
            }
        }
        let (at, fields) = (keep.at.clone(), keep.fields.clone());
        let wanted = Wanted { at, fields, extremes, ..Wanted::default() };
        let mut columns =
            vec![Kind::Whole.column("sample"), Kind::Word(Repetition::REQUIRED).column("status")];
        columns.extend(random.iter().map(|random| Kind::Number.column(&random.name)));
        for field in field.iter().filter(|_| keep.ground) {
            columns.extend(field.of.iter().map(|of| Kind::Numbers.column(of.name())));
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
        columns.extend(fixed.map(|name| Kind::Number.column(name)));
        for field in &wanted.extremes {
            let parts = ["min_x", "min", "max_x", "max"];
            columns
                .extend(parts.map(|part| Kind::Number.column(&format!("{}_{part}", field.name()))));
        }
        for field in &wanted.fields {
            let at = wanted.at.iter();
            columns.extend(at.map(|x| Kind::Number.column(&format!("{}@{x}", field.name()))));
        }
        columns.push(Kind::Numbers.column("contact"));
        columns.push(Kind::Word(Repetition::OPTIONAL).column("message"));
        let schema = Type::group_type_builder("results").with_fields(columns).build();
        let schema = Arc::new(schema.expect("columns under a name"));
        Table { head: Head::of(draws), schema, wanted, ground: keep.ground }
    }

    /// The columns of an existing file.
    pub fn read(head: Head, schema: TypePtr) -> Self {
        Table { head, schema, wanted: Wanted::default(), ground: false }
    }

    /// Appends rows of consecutive samples.
    pub fn append(&self, columns: &mut Vec<Column>, first: u64, rows: &[(Draw, Row)]) {
        let more = self.rows(first, rows);
        if columns.is_empty() {
            *columns = more;
        } else {
            columns.iter_mut().zip(more).for_each(|(column, more)| column.append(more));
        }
    }

    /// Converts the rows of consecutive samples to columns.
    fn rows(&self, first: u64, rows: &[(Draw, Row)]) -> Vec<Column> {
        let numbers = |of: &dyn Fn(&(Draw, Row)) -> f64| Column::numbers(rows.iter().map(of));
        let mut columns = vec![
            Column::whole(first..first + rows.len() as u64),
            Column::words(rows.iter().map(|(_, row)| row.status.name())),
        ];
        let drawn = |of: fn(&Draw) -> usize| rows.first().map_or(0, |(draw, _)| of(draw));
        let random = drawn(|draw| draw.numbers.len());
        columns.extend((0..random).map(|i| numbers(&|(draw, _)| draw.numbers[i])));
        if self.ground {
            let fields = 0..drawn(|draw| draw.fields.len());
            columns.extend(
                fields.map(|i| Column::lists(rows.iter().map(|(draw, _)| Some(&*draw.fields[i])))),
            );
        }
        columns.extend([0, 1].map(|end| numbers(&|(_, row)| row.end_forces[end])));
        columns.push(numbers(&|(_, row)| row.lifted_share));
        columns.push(numbers(&|(_, row)| row.relative_gap));
        columns.extend([0, 1, 2].map(|i| numbers(&|(_, row)| row.motion[i])));
        for field in 0..self.wanted.extremes.len() {
            columns.extend([0, 1, 2, 3].map(|i| numbers(&|(_, row)| row.extremes[field][i])));
        }
        let values = self.wanted.fields.len() * self.wanted.at.len();
        columns.extend((0..values).map(|i| numbers(&|(_, row)| row.values[i])));
        columns.push(Column::lists(
            rows.iter().map(|(_, row)| row.trouble.is_none().then_some(row.contact.as_flattened())),
        ));
        columns.push(Column::some_words(rows.iter().map(
            |(_, row)| match row.trouble.as_deref() {
                Some(Trouble::Failed(error)) => Some(error.to_string()),
                _ => None,
            },
        )));
        columns
    }
}
