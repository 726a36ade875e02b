//! Reads values of expected types from a JSON object: numbers, strings, arrays and objects.

use crate::json::{Json, JsonError};
use std::collections::BTreeMap;

/// A JSON object. Each value is removed when it is read, so any keys that remain at the end do not belong to the
/// format.
pub(crate) type Object = BTreeMap<String, Json>;

/// Returns the error of a document that does not have the expected form.
pub(crate) fn wrong<T>(what: impl Into<String>) -> Result<T, JsonError> {
    Err(JsonError { line: 0, column: 0, what: what.into() })
}

/// Converts a value to an object.
pub(crate) fn object(value: Json, name: &str) -> Result<Object, JsonError> {
    match value {
        Json::Object(object) => Ok(object),
        _ => wrong(format!("`{name}` is not an object")),
    }
}

/// Converts a value to a list.
pub(crate) fn list(value: Json, name: &str) -> Result<Vec<Json>, JsonError> {
    match value {
        Json::List(list) => Ok(list),
        _ => wrong(format!("`{name}` is not a list")),
    }
}

/// Reads a list of objects. Returns an empty list if the key is missing.
pub(crate) fn elements(parent: &mut Object, key: &str) -> Result<Vec<Object>, JsonError> {
    let Some(value) = parent.remove(key) else { return Ok(Vec::new()) };
    list(value, key)?.into_iter().map(|element| object(element, key)).collect()
}

/// Reads a string. Returns `None` if the key is missing or its value is null.
pub(crate) fn text_of(parent: &mut Object, key: &str) -> Result<Option<String>, JsonError> {
    match parent.remove(key) {
        None | Some(Json::Null) => Ok(None),
        Some(Json::Text(text)) => Ok(Some(text)),
        Some(_) => wrong(format!("`{key}` is not a string")),
    }
}

/// Reads a number. Returns `None` if the key is missing or its value is null.
pub(crate) fn optional(parent: &mut Object, key: &str) -> Result<Option<f64>, JsonError> {
    match parent.remove(key) {
        None | Some(Json::Null) => Ok(None),
        Some(Json::Number(number)) => Ok(Some(number)),
        Some(_) => wrong(format!("`{key}` is not a number")),
    }
}

/// Reads a number. A missing number is an error.
pub(crate) fn number(parent: &mut Object, key: &str) -> Result<f64, JsonError> {
    optional(parent, key)?.map_or_else(|| wrong(format!("`{key}` is missing")), Ok)
}

/// Converts a value to a list of numbers.
pub(crate) fn all_numbers(value: Json, name: &str) -> Result<Vec<f64>, JsonError> {
    let number = |value| match value {
        Json::Number(number) => Ok(number),
        _ => wrong(format!("`{name}` contains a value that is not a number")),
    };
    list(value, name)?.into_iter().map(number).collect()
}

/// Reads a list of numbers. Returns `None` if the list is missing or null.
pub(crate) fn numbers(parent: &mut Object, key: &str) -> Result<Option<Vec<f64>>, JsonError> {
    match parent.remove(key) {
        None | Some(Json::Null) => Ok(None),
        Some(value) => all_numbers(value, key).map(Some),
    }
}

/// Reads a list of two numbers. Returns `None` if the list is missing or null.
pub(crate) fn pair(parent: &mut Object, key: &str) -> Result<Option<[f64; 2]>, JsonError> {
    match parent.remove(key) {
        None | Some(Json::Null) => Ok(None),
        Some(value) => two(value, key).map(Some),
    }
}

/// Converts a value to a list of two numbers.
pub(crate) fn two(value: Json, name: &str) -> Result<[f64; 2], JsonError> {
    match all_numbers(value, name)?[..] {
        [a, b] => Ok([a, b]),
        _ => wrong(format!("`{name}` must be a list of two numbers")),
    }
}
