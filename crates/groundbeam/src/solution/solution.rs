//! An equilibrium with its certificate: the fields at any position, the contact zones and the forces.

use crate::Step;
use crate::existence::verdict::Existence;
use crate::ground::link;
use crate::mesh::cell::Cell;
use crate::mesh::free_field::{self, Line, ground_loads};
use crate::model::support::Reaction;
use crate::model::{GroundOutside, Model};
use crate::solution::certificate::Certificate;

use crate::options::Method;
use crate::solution::candidate::Candidate;
use crate::solution::claim;
use crate::solution::field::{ByField, Field};
use crate::solution::fields::{
    ConcentratedForce, ContactZone, EndForces, Fields, Range, Side, SolutionPiece,
};
use groundbeam_proof::{NotProven, Proof, Scalar};

/// An equilibrium with its certificate.
///
/// Only [`solve`](crate::solve()) and related functions create a solution, and only if its certificate holds.
#[derive(Debug, Clone)]
pub struct Solution {
    candidate: Candidate,
    certificate: Certificate,
    existence: Existence,
    method: Method,
    history: Vec<Step>,
    soil: Option<SoilRounds>,
}

/// Data of the iteration that computed the ground constants of a solution from the [soil](crate::soil) data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoilRounds {
    /// Decay parameter γ of the settlement over the depth; `None` for soil data without layers.
    pub gamma: Option<f64>,
    /// Number of solves, each with new ground constants k and μ. It is one if the decay parameter γ of the settlement
    /// over the depth does not depend on the solution.
    pub rounds: usize,
}

impl Solution {
    /// Creates a solution from a candidate, its certificate, the verdict on existence that was reached before the
    /// solve, the method, and the steps of the method.
    pub(crate) fn new(
        candidate: Candidate,
        certificate: Certificate,
        existence: Existence,
        method: Method,
        history: Vec<Step>,
    ) -> Self {
        let existence = candidate.settled_existence(existence);
        Solution { candidate, certificate, existence, method, history, soil: None }
    }

    /// Returns the solution with the data of its soil iteration.
    pub(crate) fn on_soil(self, soil: SoilRounds) -> Self {
        Solution { soil: Some(soil), ..self }
    }

    /// Returns the fields, contact zones and forces of the solution, and the steps of the method.
    pub(crate) fn into_parts(self) -> (Candidate, Vec<Step>) {
        (self.candidate, self.history)
    }

    /// The fields, contact zones and forces of the solution.
    pub(crate) fn candidate(&self) -> &Candidate {
        &self.candidate
    }

    /// The pieces of the solution with their closed forms, from left to right.
    pub(crate) fn pieces(&self) -> &[SolutionPiece] {
        &self.candidate.pieces
    }

    /// The solved model. If its ground is given by soil data, its ground constants k and μ are those that the solve
    /// computed.
    pub fn model(&self) -> &Model {
        &self.candidate.model
    }

    /// Data of the soil iteration; `None` for a model with given ground constants.
    pub fn soil(&self) -> Option<SoilRounds> {
        self.soil
    }

    /// The method that computed the solution.
    pub fn method(&self) -> Method {
        self.method
    }

    /// The verdict on existence and uniqueness.
    pub fn existence(&self) -> &Existence {
        &self.existence
    }

    /// The contact zones, from left to right. The list is empty if the beam has no contact.
    pub fn contact(&self) -> &[ContactZone] {
        &self.candidate.contact
    }

    /// Intervals \[m\] on which rounding error decides between contact and open ground, from left to right. See
    /// *Stopping* in docs/methods.md.
    pub fn undecided(&self) -> impl ExactSizeIterator<Item = ContactZone> + '_ {
        self.candidate.edge_error.undecided.iter().map(|&[from, to]| ContactZone { from, to })
    }

    /// The largest distance by which a contact edge moved in the last steps of the exact method \[m\]. It is an
    /// estimate of the error of the edge positions.
    pub fn edge_error(&self) -> f64 {
        self.candidate.edge_error.moved
    }

    /// The concentrated contact forces under the beam's ends.
    pub fn end_forces(&self) -> EndForces {
        self.candidate.end_forces
    }

    /// Concentrated contact forces inside the beam: at jumps of μ, kinks of the initial gap and point contacts. With
    /// the nodal pressures (5.5) of Kikuchi's paper, all contact forces are concentrated.
    pub fn concentrated_forces(&self) -> &[ConcentratedForce] {
        &self.candidate.concentrated
    }

    /// The reactions of the supports, in the order of the model's supports.
    pub fn reactions(&self) -> &[Reaction] {
        &self.candidate.reactions
    }

    /// The certificate of this solution.
    pub fn certificate(&self) -> &Certificate {
        &self.certificate
    }

    /// Proves this solution. The proof uses intervals of 106-bit numbers that enclose all rounding errors. It
    /// holds for the model whose numbers are exactly the doubles of this model.
    pub fn prove(&self) -> Result<Proof, NotProven> {
        claim::prove(&self.candidate)
    }

    /// Converts model and solution to the input of the proof, for proofs in another number type.
    pub fn claim<S: Scalar>(&self) -> (groundbeam_proof::Model<S>, groundbeam_proof::Answer) {
        (self.candidate.model.to_prove(), claim::answer(&self.candidate))
    }

    /// The steps of the iteration, from the first to the last.
    pub fn history(&self) -> &[Step] {
        &self.history
    }

    /// Number of steps of the iteration.
    pub fn iterations(&self) -> usize {
        self.history.len()
    }

    /// Number of elements of the mesh, or number of closed-form pieces of the exact method.
    pub fn elements(&self) -> usize {
        self.candidate.elements
    }

    /// Values of all fields at the position x of the beam, 0 ≤ x ≤ l \[m\]. `side` selects the value where a
    /// field jumps.
    pub fn at(&self, x: f64, side: Side) -> Fields {
        self.candidate.at(x, side)
    }

    /// The smallest and largest value of a field, located by the roots of its derivative.
    pub fn range(&self, field: Field) -> Range {
        self.candidate.range(field)
    }

    /// The ranges of all fields.
    pub fn ranges(&self) -> ByField<Range> {
        let slope = self.range(Field::Slope);
        let shears = self.candidate.model.beam.shears();
        Field::ALL.map(|field| match field {
            Field::Slope => slope,
            // Without shear deformation the rotation equals the slope, so both fields have equal ranges.
            Field::Rotation if !shears => slope,
            _ => self.range(field),
        })
    }

    /// Value of one field at the position x of the beam. Where the field jumps, it is the value from the right,
    /// and at x = l the value from the left.
    pub fn value(&self, field: Field, x: f64) -> f64 {
        self.at(x, Side::Right).get(field)
    }

    /// The settlement u at any position x, also outside the beam \[m\]. It is 0 on open ground without a shear
    /// layer and without load.
    pub fn settlement(&self, x: f64) -> f64 {
        let l = self.candidate.model.beam.length;
        let right = x > l;
        if !right && x >= 0.0 {
            return self.value(Field::Settlement, x);
        }
        let (end, distance) =
            if right { (self.at(l, Side::Left), x - l) } else { (self.at(0.0, Side::Right), -x) };
        let beyond = self.beyond(right);
        if !self.candidate.model.has_ground_loads() {
            return link::beside(&beyond, end.settlement, distance);
        }
        let cells: Vec<Cell> = self.pieces().iter().map(|piece| piece.cell).collect();
        let (other, loads) = (self.beyond(!right), ground_loads(self.model()));
        let both = if right { [&other, &beyond] } else { [&beyond, &other] };
        let line = Line { length: l, beyond: both, loads: &loads };
        let own = |distance: f64| free_field::at(&line, right, &cells, distance);
        link::beside(&beyond, end.settlement - own(0.0), distance) + own(distance)
    }

    /// The ground outside one end of the beam.
    pub(crate) fn beyond(&self, right: bool) -> GroundOutside {
        let at_end = if right {
            self.pieces()[self.pieces().len() - 1].cell.ground_at(1.0)
        } else {
            self.pieces()[0].cell.ground_at(-1.0)
        };
        self.candidate.model.foundation.beyond(right, self.candidate.model.beam.length, at_end)
    }

    /// Positions at which results list the fields: `even` equal steps, every load and support, every end of a
    /// segment, every contact edge, and the extremes of every field.
    pub fn stations(&self, even: usize) -> Vec<f64> {
        let l = self.candidate.model.beam.length;
        let mut x: Vec<f64> = (0..=even).map(|i| l * (i as f64 / even.max(1) as f64)).collect();
        x.extend(
            crate::mesh::mesh::Mesh::build(&self.candidate.model, &[], |_| 1)
                .nodes
                .iter()
                .map(|n| n.x),
        );
        x.extend(self.candidate.contact.iter().flat_map(|c| [c.from, c.to]));
        x.extend(self.ranges().into_iter().flat_map(|range| [range.min.x, range.max.x]));
        x.sort_by(f64::total_cmp);
        x.dedup();
        x
    }
}
