//! A load that moves, as a moment and steps at the node where it stands.
//!
//! If a load moves to the right by δ, the state to its left continues over the length δ. Seen from the right cell, w, φ
//! and M are then larger by their jumps of slope times δ. Cells and nodes stay where they are: lengths of cells
//! have no derivatives, and things at one place need no cell of length δ between them.

use super::frame::Frame;
use super::tangent::{Motion, Moved};
use crate::element::operator::ZoneKind;
use crate::mesh::deflection::BeamPoint;
use crate::numeric::polynomial::value;
use crate::solution::field::Field;
use crate::solution::fields::Side;

/// Relative difference of two stiffnesses that is no jump.
const SAME: f64 = 1e-9;

/// The effect of a unit of motion at the end of one cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct Steps {
    pub spot: BeamPoint,
    /// A moment on the end of the element.
    pub moment: f64,
    /// By how much the element's own w and φ exceed those of the node.
    pub jump: [f64; 2],
    /// By how much w' of the element's end exceeds that of the beam's own end, where what moves leaves the end free.
    pub slope: f64,
    /// By how much the surface of open ground in the cell exceeds its value at the node.
    pub drift: f64,
}

impl Frame<'_> {
    pub fn steps(&self, moved: &Moved) -> Steps {
        let edge = self.edge_at_force(moved);
        let spot = self.spot(moved.x, edge.unwrap_or(Side::Right));
        let sign = if spot.s < 0.0 { 1.0 } else { -1.0 };
        let mut steps = Steps { spot, moment: 0.0, jump: [0.0; 2], slope: 0.0, drift: 0.0 };
        let stiffness = self.shear_and_pull(spot);
        match (moved.what, stiffness) {
            (Motion::Force(force), None) => steps.moment = force,
            (Motion::Force(force), Some([shear, whole])) => {
                let [mut kink, mut part] = [force / whole, 0.0];
                if edge.is_some() {
                    let slope = |side| self.solution.at(moved.x, side).slope;
                    kink = slope(Side::Left) - slope(Side::Right);
                    part = self.ground_slope(moved.x, Side::Left)
                        - self.ground_slope(moved.x, Side::Right);
                }
                steps.moment = shear * kink;
                steps.jump[0] = sign * kink;
                steps.drift = sign * part;
            }
            (Motion::Moment(moment), _) => steps.jump[1] = sign * moment / self.stiffness_at(spot),
            (Motion::MomentPerLength(moment), _) => steps.moment = moment,
            (Motion::Curvature(curvature), _) => steps.jump[1] = sign * curvature,
            // The point force at the node is a force along the strip, so its kink is none of the beam's own end.
            (Motion::ForcePerLength(force), Some([_, whole])) => {
                steps.slope = -sign * force / whole
            }
            (Motion::ForcePerLength(_), None) => {}
        }
        let part = stiffness.map_or(1.0, |[shear, whole]| shear / whole);
        steps.slope += part * steps.jump[1];
        steps
    }

    /// S and S + N at the end of a cell, if the beam shears.
    fn shear_and_pull(&self, spot: BeamPoint) -> Option<[f64; 2]> {
        let cell = &self.mesh.cells[spot.cell];
        let shear = value(&cell.beam_shear?, spot.s);
        let touches = self.touch[spot.cell] == ZoneKind::Contact;
        let layer = if touches { cell.ground_at(spot.s)[1] } else { 0.0 };
        Some([shear, shear + self.mesh.axial_force + layer])
    }

    /// EI at the end of a cell.
    fn stiffness_at(&self, spot: BeamPoint) -> f64 {
        value(&self.mesh.cells[spot.cell].stiffness_along(), spot.s)
    }

    /// u′ at a position.
    fn ground_slope(&self, x: f64, side: Side) -> f64 {
        let piece = self.solution.candidate().piece_at(x, side);
        let s = piece.local(x);
        let fields = piece.fields(s);
        piece.settlement(s, fields.deflection, fields.slope)[1]
    }

    /// w' on one side of a force that moves, with half of the kink that the force takes along.
    pub fn slope_with_half_kink(&self, x: f64, side: Side, force: f64) -> f64 {
        let spot = self.spot(x, side);
        let half = self.shear_and_pull(spot).map_or(0.0, |[_, whole]| 0.5 * force / whole);
        self.solution.at(x, side).slope + if spot.s > 0.0 { -half } else { half }
    }

    /// Minus the energy of a strip and the work on it, −½(S + P) w'² − ½μ((u' + g₀')² − g₀'²), on one side of a force that an
    /// edge of contact follows (Eshelby's force on the interface).
    pub fn released(&self, x: f64, side: Side) -> f64 {
        let spot = self.spot(x, side);
        let cell = &self.mesh.cells[spot.cell];
        let shear = self.shear_and_pull(spot).map_or(0.0, |[shear, _]| shear);
        let slope = self.solution.at(x, side).slope;
        let (lies, own) = (self.ground_slope(x, side) + cell.gap_slope, cell.gap_slope);
        let layer = cell.ground_at(spot.s)[1];
        -0.5 * ((shear + self.mesh.axial_force) * slope * slope + layer * (lies * lies - own * own))
    }

    /// The open side of a point force on a beam that shears, if an edge of contact stands at its kink. The edge moves with
    /// the force.
    pub fn edge_at_force(&self, moved: &Moved) -> Option<Side> {
        let is_force = matches!(moved.what, Motion::Force(_));
        if !is_force || !self.is_inside(moved.x) || self.shears_at(moved.x) != [true; 2] {
            return None;
        }
        let sides = [Side::Left, Side::Right].map(|side| self.touch[self.spot(moved.x, side).cell]);
        match sides {
            [ZoneKind::Contact, ZoneKind::Open] => Some(Side::Right),
            [ZoneKind::Open, ZoneKind::Contact] => Some(Side::Left),
            _ => None,
        }
    }

    /// Whether a motion to the left differs from one to the right for every output: at a hinge, or at a jump of the stiffness
    /// on which it depends.
    pub fn differs_by_side(&self, moved: &Moved) -> bool {
        let x = moved.x;
        let is_force = matches!(moved.what, Motion::Force(_));
        if !self.is_inside(x) {
            // The contact force at the end stays there, without the force above it.
            let touches = self.touch[self.spot(x, Side::Right).cell] == ZoneKind::Contact
                || [Side::Left, Side::Right].iter().any(|side| self.zone_at(x, *side).is_some());
            return is_force && touches && self.shears_at(x).contains(&true);
        }
        if self.edge_at_force(moved).is_some() {
            return false;
        }
        let differ = |a: f64, b: f64| (a - b).abs() > SAME * a.abs().max(b.abs());
        let [left, right] = [Side::Left, Side::Right].map(|side| self.spot(x, side));
        let jumps = match moved.what {
            Motion::Force(_) => {
                let whole = [left, right].map(|spot| {
                    self.shear_and_pull(spot).map_or(f64::INFINITY, |[_, whole]| whole)
                });
                whole != [f64::INFINITY; 2] && differ(whole[0], whole[1])
            }
            Motion::Moment(_) => differ(self.stiffness_at(left), self.stiffness_at(right)),
            _ => false,
        };
        let turns = !matches!(moved.what, Motion::ForcePerLength(_));
        jumps || turns && self.mesh.nodes[self.mesh.node_at(x)].hinge.is_some()
    }

    /// Whether a field or its slope jumps at a load that moves.
    pub fn is_rough(&self, field: Field, moved: &Moved) -> bool {
        let shears = self.shears_at(moved.x).contains(&true);
        // The first derivative of w, and of φ, that jumps.
        let [by_w, by_rotation] = match moved.what {
            Motion::Force(_) => [if shears { 1 } else { 3 }, 3],
            Motion::Moment(_) | Motion::Curvature(_) => [2, 2],
            Motion::MomentPerLength(_) => [3, 3],
            Motion::ForcePerLength(_) => [if shears { 2 } else { 4 }, 4],
        };
        match field {
            Field::Deflection | Field::Settlement | Field::Gap => by_w <= 1,
            Field::Slope => by_w <= 2,
            Field::Rotation => by_rotation <= 2,
            Field::Moment => by_rotation <= 3,
            Field::ShearForce => true,
            Field::Pressure => by_w <= 3,
        }
    }

    /// Whether a field jumps at a load that moves.
    pub fn jumps(&self, field: Field, moved: &Moved) -> bool {
        let shears = self.shears_at(moved.x).contains(&true);
        match moved.what {
            Motion::Force(_) => match field {
                Field::ShearForce => true,
                Field::Slope | Field::Pressure => shears,
                _ => false,
            },
            Motion::Moment(_) => {
                matches!(field, Field::Moment | Field::ShearForce | Field::Pressure)
            }
            _ => false,
        }
    }
}
