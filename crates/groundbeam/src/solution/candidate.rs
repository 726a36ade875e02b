//! Candidate for an equilibrium: the fields, contact zones and forces that a certificate checks, and reusable memory.

use crate::contact::edge_error::EdgeError;
use crate::existence::verdict::Existence;
use crate::model::Model;
use crate::model::support::Reaction;
use crate::solution::fields::{
    ConcentratedForce, ContactZone, EndForces, Fields, Side, SolutionPiece,
};

/// Candidate for an equilibrium: the fields, contact zones and forces that a certificate checks.
#[derive(Debug, Clone)]
pub(crate) struct Candidate {
    pub model: Model,
    pub pieces: Vec<SolutionPiece>,
    pub contact: Vec<ContactZone>,
    pub edge_error: EdgeError,
    pub end_forces: EndForces,
    pub concentrated: Vec<ConcentratedForce>,
    pub reactions: Vec<Reaction>,
    pub elements: usize,
}

impl Candidate {
    /// The contact zones as pairs of positions \[m\].
    pub fn contact_positions(&self) -> Vec<[f64; 2]> {
        self.contact.iter().map(|zone| [zone.from, zone.to]).collect()
    }

    /// Values of all fields at the position x of the beam. `side` selects the value where a field jumps.
    pub fn at(&self, x: f64, side: Side) -> Fields {
        let x = x.clamp(0.0, self.model.beam.length);
        let piece = self.piece_at(x, side);
        piece.fields(piece.local(x))
    }

    pub fn piece_at(&self, x: f64, side: Side) -> &SolutionPiece {
        let i = match side {
            Side::Right => self.pieces.partition_point(|s| s.x[1] <= x),
            Side::Left => self.pieces.partition_point(|s| s.x[1] < x),
        };
        &self.pieces[i.min(self.pieces.len() - 1)]
    }

    /// Returns the verdict on existence and uniqueness for the contact zones of this candidate. One-way supports
    /// with zero reaction are omitted from the model for this verdict.
    pub fn settled_existence(&self, existence: Existence) -> Existence {
        let contact = self.contact_positions();
        if !self.model.has_one_way_supports() {
            return existence.with_contact(&self.model, &contact);
        }
        let carries = |i: usize| self.reactions[i].force != 0.0;
        let holding = self.model.with_supports_that(|i, s| !s.is_one_way() || carries(i));
        existence.with_contact(&holding, &contact)
    }
}

/// Memory of a candidate solution that is no longer needed, for reuse by the next candidate.
#[derive(Debug, Clone, Default)]
pub(crate) struct Workspace {
    model: Option<Model>,
    pieces: Vec<SolutionPiece>,
    contact: Vec<ContactZone>,
    concentrated: Vec<ConcentratedForce>,
}

impl Workspace {
    /// Stores the memory of a candidate for reuse.
    pub fn recycle(&mut self, candidate: Candidate) {
        let Candidate { model, pieces, contact, concentrated, .. } = candidate;
        *self = Workspace { model: Some(model), pieces, contact, concentrated };
    }

    /// Creates a candidate for a model, with empty lists.
    pub(super) fn blank(&mut self, model: &Model) -> Candidate {
        let Workspace { model: memory, mut pieces, mut contact, mut concentrated } =
            std::mem::take(self);
        let model = match memory {
            Some(mut memory) => {
                memory.copy_from(model);
                memory
            }
            None => model.clone(),
        };
        pieces.clear();
        contact.clear();
        concentrated.clear();
        let end_forces = EndForces { left: 0.0, right: 0.0 };
        let (reactions, elements) = (Vec::new(), 0);
        let edge_error = EdgeError::default();
        Candidate {
            model,
            pieces,
            contact,
            edge_error,
            end_forces,
            concentrated,
            reactions,
            elements,
        }
    }
}
