//! Values of expected kinds from a JSON object: numbers, texts, lists and objects under their keys.

use crate::json::{Json, JsonError};
use std::collections::BTreeMap;

/// An object from which each read value is removed. The remaining keys are unknown.
pub(crate) type Object = BTreeMap<String, Json>;

/// The fault of a document with another form.
pub(crate) fn wrong<T>(what: impl Into<String>) -> Result<T, JsonError> {
    Err(JsonError { line: 0, column: 0, what: what.into() })
}

/// The value as an object.
pub(crate) fn object(value: Json, name: &str) -> Result<Object, JsonError> {
    match value {
        Json::Object(object) => Ok(object),
        _ => wrong(format!("`{name}` is not an object")),
    }
}

/// The value as a list.
pub(crate) fn list(value: Json, name: &str) -> Result<Vec<Json>, JsonError> {
    match value {
        Json::List(list) => Ok(list),
        _ => wrong(format!("`{name}` is not a list")),
    }
}

/// The objects of a list; an empty list if the key is missing.
pub(crate) fn elements(parent: &mut Object, key: &str) -> Result<Vec<Object>, JsonError> {
    let Some(value) = parent.remove(key) else { return Ok(Vec::new()) };
    list(value, key)?.into_iter().map(|element| object(element, key)).collect()
}

/// A text; `None` if it is missing or null.
pub(crate) fn text_of(parent: &mut Object, key: &str) -> Result<Option<String>, JsonError> {
    match parent.remove(key) {
        None | Some(Json::Null) => Ok(None),
        Some(Json::Text(text)) => Ok(Some(text)),
        Some(_) => wrong(format!("`{key}` is not a text")),
    }
}

/// A number; `None` if it is missing or null.
pub(crate) fn optional(parent: &mut Object, key: &str) -> Result<Option<f64>, JsonError> {
    match parent.remove(key) {
        None | Some(Json::Null) => Ok(None),
        Some(Json::Number(number)) => Ok(Some(number)),
        Some(_) => wrong(format!("`{key}` is not a number")),
    }
}

/// A number that must be present.
pub(crate) fn number(parent: &mut Object, key: &str) -> Result<f64, JsonError> {
    optional(parent, key)?.map_or_else(|| wrong(format!("`{key}` is missing")), Ok)
}

/// The value as a list of numbers.
pub(crate) fn all_numbers(value: Json, name: &str) -> Result<Vec<f64>, JsonError> {
    let number = |value| match value {
        Json::Number(number) => Ok(number),
        _ => wrong(format!("`{name}` contains a value that is not a number")),
    };
    list(value, name)?.into_iter().map(number).collect()
}

/// A list of numbers; `None` if it is missing or null.
pub(crate) fn numbers(parent: &mut Object, key: &str) -> Result<Option<Vec<f64>>, JsonError> {
    match parent.remove(key) {
        None | Some(Json::Null) => Ok(None),
        Some(value) => all_numbers(value, key).map(Some),
    }
}

/// Two numbers; `None` if the key is missing or null.
pub(crate) fn pair(parent: &mut Object, key: &str) -> Result<Option<[f64; 2]>, JsonError> {
    match parent.remove(key) {
        None | Some(Json::Null) => Ok(None),
        Some(value) => two(value, key).map(Some),
    }
}

/// Two numbers.
pub(crate) fn two(value: Json, name: &str) -> Result<[f64; 2], JsonError> {
    match all_numbers(value, name)?[..] {
        [a, b] => Ok([a, b]),
        _ => wrong(format!("`{name}` must be a list of two numbers")),
    }
}
