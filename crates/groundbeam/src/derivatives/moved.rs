//! Represents the derivative of a solution with respect to a load's position by a moment and jumps at the node of the load.
//!
//! Cells and nodes keep their positions. See *Positions* in `docs/derivatives.md`.

use super::frame::Frame;
use super::tangent::{Motion, Moved};
use crate::element::operator::ZoneKind;
use crate::mesh::deflection::BeamPoint;
use crate::numeric::polynomial::value;
use crate::solution::field::Field;
use crate::solution::fields::Side;

/// Relative difference below which two stiffnesses count as equal.
const EQUAL_STIFFNESS: f64 = 1e-9;

/// Derivatives of the moment and of the jumps at a cell end, with respect to the position of a load at this end.
#[derive(Debug, Clone, Copy)]
pub(super) struct Steps {
    /// End of the cell.
    pub spot: BeamPoint,
    /// Derivative of the moment on the end of the element with respect to the position of the load.
    pub moment: f64,
    /// Derivatives of the jumps of the deflection w and the rotation φ with respect to the position of the load. A jump
    /// is the value at the end of the element minus the value at its node.
    pub jump: [f64; 2],
    /// Derivative of the imposed jump of the slope w' with respect to the position of the load. The jump is w' at the
    /// end of the element minus w' at its node.
    pub slope: f64,
    /// Derivative of the jump of the ground settlement with respect to the load's position, out of contact. The jump is
    /// the settlement at the cell end minus that at its node.
    pub drift: f64,
}

impl Frame<'_> {
    pub fn steps(&self, moved: &Moved) -> Steps {
        let edge = self.edge_at_force(moved);
        let spot = self.spot(moved.x, edge.unwrap_or(Side::Right));
        let sign = if spot.s < 0.0 { 1.0 } else { -1.0 };
        let mut steps = Steps { spot, moment: 0.0, jump: [0.0; 2], slope: 0.0, drift: 0.0 };
        let stiffness = self.shear_and_total_stiffness(spot);
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
            // A point force represents the moving end of a distributed force. An imposed jump of w' cancels the kink of
            // w that a point force causes in a beam with shear deformation.
            (Motion::ForcePerLength(force), Some([_, whole])) => {
                steps.slope = -sign * force / whole
            }
            (Motion::ForcePerLength(_), None) => {}
        }
        let part = stiffness.map_or(1.0, |[shear, whole]| shear / whole);
        steps.slope += part * steps.jump[1];
        steps
    }

    /// Returns the shear stiffness S and the sum S + N at a cell end, or `None` without shear deformation. In contact,
    /// the tension N includes the stiffness of the shear layer.
    fn shear_and_total_stiffness(&self, spot: BeamPoint) -> Option<[f64; 2]> {
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

    /// Computes the mean of the slopes w' just left and just right of a moving point force: w' on the given side, plus
    /// or minus half of the jump of w' at the force.
    pub fn slope_with_half_kink(&self, x: f64, side: Side, force: f64) -> f64 {
        let spot = self.spot(x, side);
        let half =
            self.shear_and_total_stiffness(spot).map_or(0.0, |[_, whole]| 0.5 * force / whole);
        self.solution.at(x, side).slope + if spot.s > 0.0 { -half } else { half }
    }

    /// Computes Eshelby's configurational force on one side of a point force with which a contact edge moves. Its left
    /// value minus its right value is the derivative of the energy with respect to the position.
    pub fn released(&self, x: f64, side: Side) -> f64 {
        let spot = self.spot(x, side);
        let cell = &self.mesh.cells[spot.cell];
        let shear = self.shear_and_total_stiffness(spot).map_or(0.0, |[shear, _]| shear);
        let slope = self.solution.at(x, side).slope;
        let (lies, own) = (self.ground_slope(x, side) + cell.gap_slope, cell.gap_slope);
        let layer = cell.ground_at(spot.s)[1];
        -0.5 * ((shear + self.mesh.axial_force) * slope * slope + layer * (lies * lies - own * own))
    }

    /// Returns the side without contact at a point force on a beam with shear deformation, if a contact edge lies at
    /// the kink under the force. The edge then moves with the force.
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

    /// Whether the derivatives for a move of a load to the left and to the right differ, for example at a hinge or at a
    /// jump of the stiffness.
    pub fn differs_by_side(&self, moved: &Moved) -> bool {
        let x = moved.x;
        let is_force = matches!(moved.what, Motion::Force(_));
        if !self.is_inside(x) {
            // A point force at an end of the beam acts above the concentrated contact force under this end. If the
            // point force moves along the beam, the contact force stays under the end.
            let touches = self.touch[self.spot(x, Side::Right).cell] == ZoneKind::Contact
                || [Side::Left, Side::Right].iter().any(|side| self.zone_at(x, *side).is_some());
            return is_force && touches && self.shears_at(x).contains(&true);
        }
        if self.edge_at_force(moved).is_some() {
            return false;
        }
        let differ = |a: f64, b: f64| (a - b).abs() > EQUAL_STIFFNESS * a.abs().max(b.abs());
        let [left, right] = [Side::Left, Side::Right].map(|side| self.spot(x, side));
        let jumps = match moved.what {
            Motion::Force(_) => {
                let whole = [left, right].map(|spot| {
                    self.shear_and_total_stiffness(spot).map_or(f64::INFINITY, |[_, whole]| whole)
                });
                whole != [f64::INFINITY; 2] && differ(whole[0], whole[1])
            }
            Motion::Moment(_) => differ(self.stiffness_at(left), self.stiffness_at(right)),
            _ => false,
        };
        let turns = !matches!(moved.what, Motion::ForcePerLength(_));
        jumps || turns && self.mesh.nodes[self.mesh.node_at(x)].hinge.is_some()
    }

    /// Returns the order of the lowest derivative of a field with respect to x that jumps at a moving load: 0 for the
    /// field itself, negative for its integrals.
    fn order_of_jump(&self, field: Field, moved: &Moved) -> i32 {
        let shears = self.shears_at(moved.x).contains(&true);
        // Orders of the lowest derivatives with respect to x that jump at the load, for the deflection w and for the
        // integral of the rotation φ.
        let [by_w, by_rotation] = match moved.what {
            Motion::Force(_) => [if shears { 1 } else { 3 }, 3],
            Motion::Moment(_) | Motion::Curvature(_) => [2, 2],
            Motion::MomentPerLength(_) => [3, 3],
            Motion::ForcePerLength(_) => [if shears { 2 } else { 4 }, 4],
        };
        match field {
            Field::Deflection | Field::Settlement | Field::Gap => by_w,
            Field::Slope => by_w - 1,
            Field::Rotation => by_rotation - 1,
            Field::Moment => by_rotation - 2,
            Field::ShearForce => by_rotation - 3,
            Field::Pressure => by_w - 2,
        }
    }

    /// Whether a field or its slope jumps at a moving load.
    pub fn is_rough(&self, field: Field, moved: &Moved) -> bool {
        self.order_of_jump(field, moved) <= 1
    }

    /// Whether a field jumps at a moving point load.
    pub fn jumps(&self, field: Field, moved: &Moved) -> bool {
        matches!(moved.what, Motion::Force(_) | Motion::Moment(_))
            && self.order_of_jump(field, moved) <= 0
    }
}
