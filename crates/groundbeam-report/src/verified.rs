//! Contains the proven statements about the results of a document.

use crate::quantity::Units;
use groundbeam::proof::{NotProven, Verification};
use groundbeam::{Field, Solution};

/// The proven statements about a document.
#[derive(Debug, Clone, PartialEq)]
pub struct Verified {
    /// Units of the numbers in the report.
    pub units: Units,
    /// Reason why the document does not belong to the model file; `None` if it does.
    pub other_model: Option<String>,
    /// Number of combinations of the model file, and the names of the combinations that the document omits;
    /// `None` if it omits none.
    pub left_out: Option<LeftOut>,
    /// The proof of each result.
    pub results: Vec<Named>,
}

/// Combinations of a model file for which the result document contains no result.
#[derive(Debug, Clone, PartialEq)]
pub struct LeftOut {
    /// Number of all combinations of the model file.
    pub all: usize,
    /// Names of the combinations of the model file for which the result document contains no result.
    pub names: Vec<String>,
}

/// The proof of one result.
#[derive(Debug, Clone, PartialEq)]
pub struct Named {
    /// Name of the combination; `None` for the model as written in the file.
    pub combination: Option<String>,
    /// Source of the model that the proof uses.
    pub model: ModelOf,
    /// The proof, or the reason why nothing is proven.
    pub found: Result<Verification, NotProven>,
}

/// Source of the model that a proof uses: the model file or the result document.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ModelOf {
    /// The proof uses the model of the model file.
    File,
    /// The proof uses the model in the result document, because the proof's own file reader does not support a key
    /// that occurs in the model file.
    Document,
}

impl Named {
    /// Whether the result is proven completely.
    pub fn is_proven(&self) -> bool {
        self.found.as_ref().is_ok_and(|found| found.shortfall.is_none())
    }

    /// The first reason why the result is not completely proven.
    pub(crate) fn shortfall(&self) -> Option<&NotProven> {
        self.found.as_ref().map_or_else(Some, |found| found.shortfall.as_ref())
    }

    /// Error bound of a field along the beam; infinite if no bound is proven.
    pub(crate) fn error_of(&self, field: Field) -> f64 {
        self.found.as_ref().map_or(f64::INFINITY, |found| found.error_of(field.name()))
    }

    /// Error bound of a field at a position; infinite if no bound is proven.
    pub(crate) fn error_at(&self, field: Field, x: f64) -> f64 {
        self.found.as_ref().map_or(f64::INFINITY, |found| found.error_at(field.name(), x))
    }

    /// Error bound of the force under an end of the beam (0: left); infinite if no bound is proven.
    pub(crate) fn error_of_end_force(&self, end: usize) -> f64 {
        let listed = self.found.as_ref().ok().and_then(|found| found.listed.end_forces);
        listed.map_or(f64::INFINITY, |ends| ends[end])
    }

    /// Error bound of the lifted share: the error bounds of all contact edges, divided by the beam length, plus the
    /// rounding error. For n lift-off zones, the rounding error is at most (n + 8)·2⁻⁵² of the lifted share.
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

    /// Whether at least one proof uses the model in the result document instead of the model file.
    pub fn is_of_document(&self) -> bool {
        self.results.iter().any(|named| named.model == ModelOf::Document)
    }

    /// Whether the document contains numbers that the proof does not cover, or lacks a combination of the model
    /// file.
    pub fn leaves_out(&self) -> bool {
        if self.left_out.is_some() {
            return true;
        }
        let found = self.results.iter().filter_map(|named| named.found.as_ref().ok());
        found.into_iter().any(|found| !found.not_covered.is_empty())
    }
}
