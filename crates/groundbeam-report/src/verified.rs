//! What is proven of the results of a document.

use crate::quantity::Units;
use groundbeam::proof::{NotProven, Verification};

/// What is proven of a document.
#[derive(Debug, Clone, PartialEq)]
pub struct Verified {
    /// How the numbers are to be read.
    pub units: Units,
    /// Why the document does not belong to the model file; none if it does.
    pub other_model: Option<String>,
    /// How many combinations the model file has, and the names of those that the document leaves out.
    pub left_out: Option<LeftOut>,
    /// Of each of its results.
    pub results: Vec<Named>,
}

/// Combinations of a model file that a document does not hold.
#[derive(Debug, Clone, PartialEq)]
pub struct LeftOut {
    /// How many combinations the file has.
    pub all: usize,
    /// The names of those that are missing.
    pub names: Vec<String>,
}

/// What is proven of one result.
#[derive(Debug, Clone, PartialEq)]
pub struct Named {
    /// The combination; none for the model as it is written.
    pub combination: Option<String>,
    /// Where the model of the proof stands.
    pub model: ModelOf,
    /// The proof, or why nothing is proven.
    pub found: Result<Verification, NotProven>,
}

/// Where the model of a proof stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ModelOf {
    /// In the model file.
    File,
    /// In the document: the second reader does not read the model file.
    Document,
}

impl Named {
    /// Whether all is proven.
    pub fn is_proven(&self) -> bool {
        self.found.as_ref().is_ok_and(|found| found.shortfall.is_none())
    }
}

impl Verified {
    /// Whether all results are proven.
    pub fn is_proven(&self) -> bool {
        self.other_model.is_none() && self.results.iter().all(Named::is_proven)
    }

    /// Whether a model of the document was taken for that of the file.
    pub fn is_of_document(&self) -> bool {
        self.results.iter().any(|named| named.model == ModelOf::Document)
    }

    /// Whether there is a key with numbers of which nothing is claimed, or a combination of the file is missing.
    pub fn leaves_out(&self) -> bool {
        if self.left_out.is_some() {
            return true;
        }
        let found = self.results.iter().filter_map(|named| named.found.as_ref().ok());
        found.into_iter().any(|found| !found.not_covered.is_empty())
    }
}
