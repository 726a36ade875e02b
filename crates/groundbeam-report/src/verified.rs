//! What is proven of the results of a document.

use crate::quantity::Units;
use groundbeam::proof::{NotProven, Verification};
use groundbeam::{Field, Solution};

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

    /// The first reason why not all is proven.
    pub(crate) fn shortfall(&self) -> Option<&NotProven> {
        self.found.as_ref().map_or_else(Some, |found| found.shortfall.as_ref())
    }

    /// The bound of the error of a field along the beam; infinite if there is none.
    pub(crate) fn error_of(&self, field: Field) -> f64 {
        self.found.as_ref().map_or(f64::INFINITY, |found| found.error_of(field.name()))
    }

    /// The bound of the error of a field at a place; infinite if there is none.
    pub(crate) fn error_at(&self, field: Field, x: f64) -> f64 {
        self.found.as_ref().map_or(f64::INFINITY, |found| found.error_at(field.name(), x))
    }

    /// The bound of the error of the force under an end of the beam, 0 the left one; infinite if there is none.
    pub(crate) fn error_of_end_force(&self, end: usize) -> f64 {
        let listed = self.found.as_ref().ok().and_then(|found| found.listed.end_forces);
        listed.map_or(f64::INFINITY, |ends| ends[end])
    }

    /// The bound of the error of the lifted share: the errors of all edges, and the rounding of the sum of n lengths and of
    /// their quotient by l, which is at most (n + 8)·2⁻⁵² of the share.
    pub(crate) fn error_of_lifted_share(&self, solution: &Solution) -> f64 {
        let Ok(found) = &self.found else { return f64::INFINITY };
        let length = solution.model().beam.length;
        let edges: f64 = found.listed.edges.iter().flatten().sum();
        let terms = (solution.lift_off().len() + 8) as f64;
        let rounding = terms * f64::EPSILON * solution.lifted_share();
        (edges / length * (1.0 + terms * f64::EPSILON)).next_up() + rounding
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
