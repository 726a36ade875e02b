//! Solves the model of a result document again, proves the results of the document, and writes all computed numbers as text.
//!
//! Two platforms give equal texts if their numbers are equal bit by bit. Every NaN is written as `NaN`.

#![cfg_attr(not(target_family = "wasm"), forbid(unsafe_code))]

#[cfg(target_family = "wasm")]
mod module;

use groundbeam_proof::{Ball, Document, Enclosing, Log, Wide, read_model, verify_and_log};

/// Returns the solution of the model in a result document, and the proofs of the result in the number types `Wide` and
/// `Ball` with their logs.
///
/// `input` contains the text of the model file, the name of the load combination (may be empty) and the document of one
/// result, separated by zero bytes.
pub fn results(input: &str) -> String {
    let parts: Vec<&str> = input.split('\0').collect();
    let [file, combination, document] = parts[..] else {
        return format!("the input has {} parts, not 3", parts.len());
    };
    let documents = match Document::read(document) {
        Ok(documents) => documents,
        Err(error) => return error.to_string(),
    };
    let [document] = &documents[..] else {
        return format!("the document has {} results, not 1", documents.len());
    };
    let combination = Some(combination).filter(|name| !name.is_empty());
    let wide = proof::<Wide>(file, combination, document);
    let ball = proof::<Ball>(file, combination, document);
    let solution = solution(document);
    format!("solution: {solution}\nwide: {wide}\nball: {ball}\n")
}

/// Returns the solution of the model that the result document contains.
fn solution(document: &Document) -> String {
    let Some(model) = &document.model else { return "the document has no model".to_owned() };
    match groundbeam_file::parse(model) {
        Ok(file) => format!("{:#?}", groundbeam::solve(&file.model)),
        Err(error) => error.to_string(),
    }
}

/// Computes the proof in the arithmetic of `S`. The model is read from the file, or from the document if the reader
/// refuses the file.
fn proof<S: Enclosing>(file: &str, combination: Option<&str>, document: &Document) -> String {
    let read = read_model::<S>(file, combination);
    let model = match (read, &document.model) {
        (Err(_), Some(own)) => read_model::<S>(own, None),
        (read, _) => read,
    };
    let mut log = Log::new();
    match model {
        Ok(model) => {
            let found = verify_and_log(&model, document, Some(&mut log));
            format!("{found:#?}\n{}", log.text())
        }
        Err(error) => error.to_string(),
    }
}
