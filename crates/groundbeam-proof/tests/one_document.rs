//! Reads and verifies the text of a document with one answer.

use groundbeam_proof::{Document, NotProven, Verification, Wide, read_model, verify};

/// The document of one answer.
pub fn document(text: &str) -> Document {
    let mut all = Document::read(text).expect("a document");
    assert_eq!(all.len(), 1, "answers in the document");
    all.remove(0)
}

/// The verification of a document against a model file.
pub fn verified(model: &str, text: &str) -> Result<Verification, NotProven> {
    verify(&read_model::<Wide>(model, None).expect("a model"), &document(text))
}
