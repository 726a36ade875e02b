//! Defines outputs, which are results of a solution, and how the linearised problem evaluates each output.

use super::extreme::Place;
use super::frame::Frame;
use super::tangent::{Motion, Moved};
use crate::solution::field::Field as Quantity;
use crate::solution::fields::Side;

/// A result of a solution.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Output {
    /// A field on one side of a fixed position x \[m\]. x is on the beam; for the settlement, x may also be outside the
    /// beam.
    Value(Quantity, f64, Side),
    /// The smallest value of a field on the beam.
    Smallest(Quantity),
    /// The largest value of a field on the beam.
    Largest(Quantity),
    /// The position of an end of a contact zone \[m\]; zones are numbered from 0 as in
    /// [`Solution::contact`](crate::Solution::contact).
    Edge(usize, Side),
    /// Concentrated contact force at an end of the beam, p₀ or p_l \[N\].
    EndForce(Side),
    /// Force of a support, positive up \[N\].
    SupportForce(usize),
    /// Moment of a support \[N·m\], positive if it rotates the right side of the beam down.
    SupportMoment(usize),
    /// The potential energy \[N·m\]: the elastic energy plus ½∫P w'² dx of the axial force P, minus the work of the
    /// loads.
    PotentialEnergy,
}

/// The value of an output, and the way in which its derivatives with respect to the parameters are computed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reading {
    pub value: f64,
    pub of: Read,
    /// Another position at which the field has the same extreme value.
    pub rival: Option<f64>,
}

/// The way in which the linearised problem evaluates an output.
#[derive(Debug, Clone, Copy)]
pub(super) enum Read {
    /// A value that does not depend on the parameters. Its derivatives are zero.
    Constant,
    /// The value of a field at a position. `follows` states how this position depends on the parameters.
    Field {
        field: Quantity,
        x: f64,
        side: Side,
        follows: Follows,
    },
    /// The settlement at a position outside the beam.
    Beside {
        x: f64,
    },
    /// The position of an end of a contact zone.
    Edge {
        zone: usize,
        side: Side,
    },
    /// A concentrated force at an end of a contact zone.
    EdgeForce {
        zone: usize,
        side: Side,
    },
    /// The force or moment of a support. `number` is the index of the support among the active supports.
    Support {
        number: usize,
        moment: bool,
    },
    Energy,
}

/// How the position at which a field is evaluated depends on the parameters. `slope` is the derivative of the field
/// with respect to x at this position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Follows {
    /// The position is fixed by the caller.
    Given,
    /// The slope of the field is zero at the position of its extreme value. A small shift of this position has no
    /// first-order effect on the value.
    Nothing,
    /// The field has its extreme value at a contact edge, where it has a kink.
    Edge { zone: usize, side: Side, slope: f64 },
    /// The position is that of a load. No other part of the model has the same position.
    Load { slope: f64 },
    /// The field has its extreme value at a kink, at a jump or at an end of the beam. This position does not depend on
    /// the parameters.
    Kink,
}

impl Frame<'_> {
    /// Returns the value of an output and the way in which its derivatives are computed. Returns `None` if the solution
    /// does not have the output.
    pub fn reading(&self, output: Output) -> Option<Reading> {
        let solution = self.solution;
        let l = self.model.beam.length;
        let mut rival = None;
        let (value, of) = match output {
            Output::Value(field, x, side) if (0.0..=l).contains(&x) => {
                let follows = Follows::Given;
                (solution.at(x, side).get(field), Read::Field { field, x, side, follows })
            }
            Output::Value(Quantity::Settlement, x, _) if x.is_finite() => {
                (solution.settlement(x), Read::Beside { x })
            }
            Output::Value(..) => return None,
            Output::Smallest(field) | Output::Largest(field) => {
                let place = solution.extreme(field, matches!(output, Output::Largest(_)));
                rival = place.rival;
                let (x, side, follows) = (place.x, place.side, self.follows(&place));
                let read = Read::Field { field, x, side, follows };
                (place.value, if place.always { Read::Constant } else { read })
            }
            Output::Edge(region, side) => {
                let region = solution.contact().get(region)?;
                let x = if side == Side::Left { region.from } else { region.to };
                (x, Read::Edge { zone: self.zone_at(x, side)?, side })
            }
            Output::EndForce(side) => {
                let ends = solution.end_forces();
                let [x, value] =
                    if side == Side::Left { [0.0, ends.left] } else { [l, ends.right] };
                let layered = self.mesh.cells[self.spot(x, Side::Right).cell].shear_layer > 0.0;
                let zone = self.zone_at(x, side).filter(|_| layered);
                (value, zone.map_or(Read::Constant, |zone| Read::EdgeForce { zone, side }))
            }
            Output::SupportForce(i) | Output::SupportMoment(i) => {
                let moment = matches!(output, Output::SupportMoment(_));
                let reaction = solution.reactions().get(i)?;
                let number = self.number_among_acting(i);
                let read = number.map_or(Read::Constant, |number| Read::Support { number, moment });
                (if moment { reaction.moment } else { reaction.force }, read)
            }
            Output::PotentialEnergy => (solution.certificate().primal_energy(), Read::Energy),
        };
        Some(Reading { value, of, rival })
    }

    /// Determines how the position of an extreme value depends on the parameters.
    fn follows(&self, place: &Place) -> Follows {
        let (x, slope) = (place.x, place.slope);
        if slope == 0.0 {
            return Follows::Nothing;
        }
        // At a load, a support or a hinge the field has a kink that is not due to a contact edge.
        let node = &self.mesh.nodes[self.mesh.node_at(x)];
        let loaded = node.force != 0.0 || node.moment != 0.0;
        let held = node.pinned || node.spring != 0.0 || node.rotational_spring != 0.0;
        if !loaded && !held && node.hinge.is_none() && self.is_same_place(x, node.x) {
            let moves = |side| self.zone_at(x, side).filter(|zone| !self.stays(*zone, side));
            if let Some((zone, side)) =
                [Side::Left, Side::Right].into_iter().find_map(|side| Some((moves(side)?, side)))
            {
                return Follows::Edge { zone, side, slope };
            }
        }
        if self.stands_alone(x) { Follows::Load { slope } } else { Follows::Kink }
    }

    /// Whether the derivative of an output with respect to the position of a load holds in one direction only.
    pub fn is_one_sided(&self, read: &Read, moved: &Moved) -> bool {
        if matches!(read, Read::Constant) {
            return false;
        }
        if matches!(read, Read::Energy) {
            let is_force = matches!(moved.what, Motion::Force(_));
            let kinks = is_force && self.shears_at(moved.x).contains(&true);
            return kinks && self.is_inside(moved.x) && !self.stands_alone(moved.x);
        }
        if self.differs_by_side(moved) {
            return true;
        }
        let here = |x: f64| self.is_same_place(x, moved.x);
        match *read {
            Read::Field { field, x, follows, .. } => {
                // If the load moves away from a support, a hinge or another load, the field has new values between
                // them. One of these values may be the extreme value.
                let leaves = follows != Follows::Given
                    && !self.stands_alone(moved.x)
                    && self.jumps(field, moved);
                match follows {
                    Follows::Load { .. } if here(x) => false,
                    _ => leaves || here(x) && self.is_rough(field, moved),
                }
            }
            Read::Edge { zone, side } | Read::EdgeForce { zone, side } => {
                let x = self.position(self.end_of(zone, side));
                here(x) && self.is_inside(x) && !self.edge_follows(zone, side, moved)
            }
            _ => false,
        }
    }

    /// Whether a contact edge lies at the kink under a point force and moves with the force.
    pub fn edge_follows(&self, zone: usize, side: Side, moved: &Moved) -> bool {
        let spot = self.end_of(zone, side);
        let held = self.mesh.cells[spot.cell].beam_shear.is_some() && self.stays(zone, side);
        let is_force = matches!(moved.what, Motion::Force(_));
        let x = self.position(spot);
        held && is_force && self.is_same_node(x, moved.x) && self.stands_alone(x)
    }
}
