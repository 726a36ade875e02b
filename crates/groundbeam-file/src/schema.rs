//! Generates a JSON Schema (draft 7) with which editors complete and check model files and study files.

use crate::keys::{Key, Table, Value};
use crate::section::MODEL;
use crate::study::STUDY;
use serde_json::{Map, Value as Json, json};

/// Returns the JSON Schema of model files.
///
/// ```
/// let schema = groundbeam_file::model_schema();
/// assert!(schema.contains("\"rotational_spring\""));
/// ```
pub fn model_schema() -> String {
    document(&MODEL, "groundbeam model file")
}

/// Returns the JSON Schema of study files.
pub fn study_schema() -> String {
    document(&STUDY, "groundbeam study file")
}

fn document(root: &Table, title: &str) -> String {
    let mut schema = object(root);
    schema["$schema"] = json!("http://json-schema.org/draft-07/schema#");
    schema["title"] = json!(title);
    format!("{schema:#}\n")
}

/// Returns the JSON Schema of a table. The schema allows only the known keys of the table.
fn object(table: &Table) -> Json {
    let properties: Map<String, Json> =
        table.keys.iter().map(|key| (key.name.to_owned(), property(key))).collect();
    let needed = table.keys.iter().filter(|key| key.needed).map(|key| key.name);
    let needed: Vec<&str> = needed.collect();
    json!({
        "type": "object",
        "properties": properties,
        "required": needed,
        "additionalProperties": false,
    })
}

fn property(key: &Key) -> Json {
    let mut schema = value(&key.value);
    schema["description"] = json!(key.meaning);
    schema
}

fn value(value: &Value) -> Json {
    match *value {
        Value::Quantity(kind) => json!({
            "type": ["number", "string"],
            "examples": [kind.example],
        }),
        Value::Depends => json!({ "type": ["number", "string"] }),
        Value::Along(kind, most) => {
            let one = &Value::Quantity(kind);
            json!({ "anyOf": [self::value(one), list(one, [2, most])] })
        }
        Value::Count([least, most]) => {
            json!({ "type": "integer", "minimum": least, "maximum": most })
        }
        Value::Flag => json!({ "type": "boolean" }),
        Value::Text(example) => json!({ "type": "string", "examples": [example] }),
        Value::Name(_, all) => json!({ "enum": all() }),
        Value::Word(words) => json!({ "enum": (words.all)() }),
        Value::OneOrMore(words) => {
            let one = &Value::Word(words);
            json!({ "anyOf": [self::value(one), list(one, [1, usize::MAX])] })
        }
        Value::List(one, limits) => list(one, limits),
        Value::Factors => {
            json!({ "type": "object", "additionalProperties": { "type": "number" } })
        }
        Value::Table(table) => object(table),
        Value::Tables(table) => json!({ "type": "array", "items": object(table) }),
    }
}

fn list(one: &Value, [least, most]: [usize; 2]) -> Json {
    let mut schema = json!({ "type": "array", "items": value(one), "minItems": least });
    if most < usize::MAX {
        schema["maxItems"] = json!(most);
    }
    schema
}
