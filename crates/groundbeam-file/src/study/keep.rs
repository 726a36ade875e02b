//! Reads `[keep]`: the values that a study saves for each sample.

use crate::code;
use crate::fault::Fault;
use crate::keys::{Table, Value, key};
use crate::quantity::POSITION;
use crate::reader::Reader;
use crate::suggest;
use crate::table::Section;
use groundbeam::Field;
use toml::de::DeValue;

/// Values saved for each sample in addition to the status, the end forces, the lifted share and the relative
/// energy gap.
#[derive(Debug, Clone, PartialEq)]
pub struct Keep {
    /// Fields whose smallest and largest values are saved, with their positions.
    pub extremes: Vec<Field>,
    /// Fields whose values at the positions `at` are saved.
    pub fields: Vec<Field>,
    /// Positions \[m\] at which the values of `fields` are saved.
    pub at: Vec<f64>,
    /// Whether the values of the random fields are saved, at all points of each field.
    pub ground: bool,
}

const FIELDS: Value = Value::List(
    &Value::Name("deflection", || Field::ALL.map(Field::name).to_vec()),
    [0, usize::MAX],
);

pub(super) static TABLE: Table = Table {
    name: "[keep]",
    keys: &[
        key(
            "extremes",
            FIELDS,
            "Fields whose extremes are saved; default: deflection, moment, shear, pressure.",
        ),
        key("fields", FIELDS, "Fields that are saved at the positions `at`."),
        key(
            "at",
            Value::List(&Value::Quantity(&POSITION), [0, usize::MAX]),
            "The positions for `fields`.",
        ),
        key("ground", Value::Flag, "Whether the random fields are saved; default: false."),
    ],
};

pub(super) fn read(reader: &mut Reader, root: &Section) -> Keep {
    let usual = || {
        let most = [Field::Deflection, Field::Moment, Field::ShearForce, Field::Pressure];
        most.to_vec()
    };
    let Some(table) = reader.table(root, "keep") else {
        return Keep { extremes: usual(), fields: Vec::new(), at: Vec::new(), ground: false };
    };
    let extremes = fields(reader, &table, "extremes").unwrap_or_else(usual);
    let (fields, at) =
        (fields(reader, &table, "fields").unwrap_or_default(), positions(reader, &table));
    if let (true, Some(value)) = (at.is_empty(), table.value("fields")) {
        let message = "`fields` needs positions, but `at` gives no position";
        let hint =
            format!("add {}", POSITION.line("at", reader.is_plain()).replace("= ", "= [") + "]");
        reader.report(Fault::new(code::INCOMPLETE, value.span(), message, "", hint));
    }
    let ground = match table.value("ground") {
        None => false,
        Some(value) => match value.get_ref() {
            DeValue::Boolean(keep) => *keep,
            _ => {
                let message = "`ground` must be true or false".to_owned();
                reader.wrong_type(value, message, "write ground = true".to_owned());
                false
            }
        },
    };
    Keep { extremes, fields, at, ground }
}

fn fields(reader: &mut Reader, table: &Section, key: &str) -> Option<Vec<Field>> {
    let value = table.value(key)?;
    let DeValue::Array(list) = value.get_ref() else {
        let hint = format!("write a list, as in {key} = [\"deflection\", \"moment\"]");
        reader.wrong_type(value, format!("`{key}` must be a list"), hint);
        return Some(Vec::new());
    };
    let mut all = Vec::new();
    for word in list.iter() {
        let Some(name) = word.get_ref().as_str() else {
            let hint = format!("write names in quotes, as in {key} = [\"deflection\", \"moment\"]");
            reader.wrong_type(word, "give the name of a field".to_owned(), hint);
            continue;
        };
        match field(name) {
            Ok(field) if all.contains(&field) => {
                let message = format!("`{name}` is listed twice");
                reader.report(Fault::new(
                    code::REPEATED,
                    word.span(),
                    message,
                    "",
                    "list each field once",
                ));
            }
            Ok(field) => all.push(field),
            Err(hint) => {
                let message = format!("there is no field `{name}`");
                reader.report(Fault::new(code::UNKNOWN_WORD, word.span(), message, "", hint));
            }
        }
    }
    Some(all)
}

/// Returns the field with this name. The error message is a hint with similar names.
pub(super) fn field(name: &str) -> Result<Field, String> {
    let names = Field::ALL.map(Field::name);
    Field::named(name.trim()).ok_or_else(|| suggest::advice(name, &names, "the fields: {}"))
}

fn positions(reader: &mut Reader, table: &Section) -> Vec<f64> {
    let Some(value) = table.value("at") else { return Vec::new() };
    let DeValue::Array(list) = value.get_ref() else {
        let hint = format!("as in at = {}", reader.pair(&POSITION));
        reader.wrong_type(value, "`at` must be a list".to_owned(), hint);
        return Vec::new();
    };
    let mut all = Vec::new();
    for at in list.iter() {
        let position = reader.field("at", at, &POSITION);
        if all.contains(&position.value) {
            let message = "this position is listed twice";
            let hint = "list each position once";
            reader.report(Fault::new(code::REPEATED, position.span, message, "", hint));
        } else {
            all.push(position.value);
        }
    }
    all
}
