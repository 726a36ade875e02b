//! Computes the fields and the certificate of each contact set that an iteration checks, with one reused workspace.

use crate::contact::state::ContactState;
use crate::model::Model;
use crate::solution::candidate::{Candidate, Workspace};
use crate::solution::certificate::Certificate;

/// The last candidate that the iteration checked, with its certificate.
pub(super) struct Judged<'a> {
    model: &'a Model,
    stability: f64,
    workspace: &'a mut Workspace,
    last: Option<(Candidate, Certificate)>,
}

impl<'a> Judged<'a> {
    pub fn new(model: &'a Model, stability: f64, workspace: &'a mut Workspace) -> Self {
        Judged { model, stability, workspace, last: None }
    }

    /// The relative energy gap of a deflection with its contact set.
    pub fn judge(&mut self, found: &ContactState) -> f64 {
        if let Some((candidate, _)) = self.last.take() {
            self.workspace.recycle(candidate);
        }
        let (candidate, certificate) = self.certified(found);
        self.last = Some((candidate, certificate));
        certificate.relative_gap()
    }

    /// Returns the last checked candidate and its certificate, or those of `found` if none was checked, as on a mesh.
    pub fn last(mut self, found: &ContactState) -> (Candidate, Certificate) {
        let (mut candidate, certificate) =
            self.last.take().unwrap_or_else(|| self.certified(found));
        // The iteration estimates the edge error after the check.
        candidate.edge_error.clone_from(&found.edge_error);
        (candidate, certificate)
    }

    fn certified(&mut self, found: &ContactState) -> (Candidate, Certificate) {
        let candidate = Candidate::of(self.model, found, self.workspace);
        let certificate = Certificate::of(&candidate, self.stability);
        (candidate, certificate)
    }
}
