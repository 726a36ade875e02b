//! The fields and the certificate of the contact that an iteration checks, in the memory of a workspace.

use crate::contact::state::ContactState;
use crate::model::Model;
use crate::solution::candidate::{Candidate, Workspace};
use crate::solution::certificate::Certificate;

/// The candidate checked last, with its certificate.
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

    /// The relative gap of a deflection with its contact.
    pub fn judge(&mut self, found: &ContactState) -> f64 {
        if let Some((candidate, _)) = self.last.take() {
            self.workspace.recycle(candidate);
        }
        let (candidate, certificate) = self.certified(found);
        self.last = Some((candidate, certificate));
        certificate.relative_gap()
    }

    /// The candidate checked last. The exact method has checked its result; the methods with a mesh have not.
    pub fn last(mut self, found: &ContactState) -> (Candidate, Certificate) {
        self.last.take().unwrap_or_else(|| self.certified(found))
    }

    fn certified(&mut self, found: &ContactState) -> (Candidate, Certificate) {
        let candidate = Candidate::of(self.model, found, self.workspace);
        let certificate = Certificate::of(&candidate, self.stability);
        (candidate, certificate)
    }
}
