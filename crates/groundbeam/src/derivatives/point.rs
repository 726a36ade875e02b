//! Changes at a point: sizes of forces and moments there, and the motion of the point.
//!
//! Where a beam that shears has a force F, w' falls by F/(S + N). What moves with the force is then more than the force:
//! it takes its own kink along, the atom that this kink presses into the ground, and an edge of contact that stands at it.

use super::change::{Against, Change, PointChange};
use super::field::Point;
use super::linearised::Linearised;
use super::product::{Dual, Rate};
use crate::element::operator::ZoneKind;
use crate::mesh::deflection::BeamPoint;
use crate::solution::field::Field as Quantity;
use crate::solution::fields::Side;

/// Two sides of a place at which something moves differ by more than this part: the derivative is one-sided.
const SAME: f64 = 1e-9;

impl Linearised {
    /// What changes at a point.
    pub fn add_point(&self, point: &PointChange, moves: bool, dual: &Dual, rate: &mut Rate) {
        let PointChange { x, against, weight } = *point;
        let l = self.model.beam.length;
        if against == Against::Settlement {
            rate.value += weight * self.settlement(dual.field, x);
            return;
        }
        let sides = [Side::Left, Side::Right].map(|side| self.spot(x, side));
        let (inner, looked) = (x > 0.0 && x < l, self.looked_at(dual, x));
        if weight != 0.0 && looked.is_some_and(|(field, ..)| self.tells_sides(field, point, moves))
        {
            rate.jumps_at = Some(x);
        }
        match against {
            // The end of a load that moves off the beam's end is within the element, beyond a step of the dual field.
            Against::Deflection if moves && !inner => {
                rate.value += weight * self.look(dual.field, sides[1], false).w;
                return;
            }
            Against::Deflection => {
                rate.value += weight * self.at_node(dual.field, sides[1])[0];
                return;
            }
            Against::Rotation => {
                rate.value += weight * self.at_node(dual.field, sides[1])[1];
                return;
            }
            _ => {}
        }
        let edge = self.edge_at_force(against, x).filter(|_| inner);
        if dual.energy && edge.is_some() {
            rate.value += self.released(sides[0]) - self.released(sides[1]);
            return;
        }
        let [left, right] = sides.map(|spot| self.seen(spot, point, dual));
        let from_left = matches!(looked, Some((.., Side::Right)));
        let of_a_curl = matches!(against, Against::BendBeside | Against::CurlBeside);
        let value = match (dual.energy, x <= 0.0, x >= l) {
            // A moment that moves takes half of its own bend with it, on either side; beyond the end there is none.
            (true, false, false) if of_a_curl => 0.5 * (left + right),
            (true, ..) if against == Against::BendBeside => 0.5 * right,
            (_, _, true) => left,
            _ if edge == Some(Side::Left) || (from_left && edge.is_none()) => left,
            _ => right,
        };
        rate.value += weight * value;
        let sizes = dual.field.points.iter().map(|z| match against {
            Against::SlopeBeside | Against::RotationBeside => [z.slope.abs(), z.w.abs()],
            _ => [z.bend.abs(), z.w.abs()],
        });
        let sizes = sizes.fold([0.0_f64; 2], |most, own| [0, 1].map(|i| most[i].max(own[i])));
        let size = sizes[0].max(left.abs()).max(right.abs());
        let told = edge.is_some() || (dual.energy && of_a_curl);
        let jump = inner && !told && (left - right).abs() > SAME * size;
        // Where the dual field is a step, what it belongs to jumps as the force passes.
        let step = |spot: BeamPoint| {
            let own = self.at_node(dual.field, spot)[0];
            let within = self.look(dual.field, spot, dual.energy).w;
            (own - within).abs() > SAME * sizes[1]
        };
        let steps = against == Against::SlopeBeside && !dual.energy && sides.into_iter().any(step);
        if weight != 0.0 && (jump || steps) {
            rate.jumps_at = Some(x);
        }
    }

    /// What a unit that moves away from a point does its work on, from a side of it.
    fn seen(&self, spot: BeamPoint, point: &PointChange, dual: &Dual) -> f64 {
        // Of the energy: an imposed curvature bends nothing that it has not bent already.
        let z = if dual.energy && point.against == Against::CurlBeside {
            let y = self.look(&self.state, spot, true);
            Point { bend: -y.bend, ..Point::default() }
        } else {
            self.look(dual.field, spot, false)
        };
        match point.against {
            Against::SlopeBeside => z.slope + self.own_kink(spot, point, &z, dual.energy),
            Against::RotationBeside => z.rotation,
            Against::BendBeside => z.bend,
            _ => z.bend * self.stiffness_at(spot),
        }
    }

    /// Of a force that moves: half the kink that it takes along, and the part of it that is an atom on ground which is
    /// open on this side.
    fn own_kink(&self, spot: BeamPoint, point: &PointChange, z: &Point, energy: bool) -> f64 {
        let Some([shear, _]) = self.shear_stiffness_at(spot) else { return 0.0 };
        if energy {
            let half = 0.5 * point.weight / (shear + self.tension_at(spot));
            return if spot.s > 0.0 { half } else { -half };
        }
        let atom = self.atoms.iter().find(|atom| atom.at == point.x).map_or(0.0, |atom| atom.force);
        let open = self.pieces[self.piece_at(spot)].touch == ZoneKind::Open;
        if open && atom != 0.0 && point.weight != 0.0 {
            atom / point.weight * (z.rise - z.slope)
        } else {
            0.0
        }
    }

    /// On which side of a force that moves an edge of contact goes along, which its kink holds: there the ground is open,
    /// and on the other it is not.
    pub fn edge_at_force(&self, against: Against, x: f64) -> Option<Side> {
        let sides = [Side::Left, Side::Right].map(|side| self.spot(x, side));
        let touches = sides.map(|spot| self.pieces[self.piece_at(spot)].touch == ZoneKind::Contact);
        let shears = sides.iter().all(|spot| self.shear_stiffness_at(*spot).is_some());
        let held = against == Against::SlopeBeside && shears;
        match touches {
            [true, false] if held => Some(Side::Right),
            [false, true] if held => Some(Side::Left),
            _ => None,
        }
    }

    /// Of the energy, where an edge of contact goes with a force: minus the strip's energy and the work of what acts on it,
    /// −½(S + P) w'² − ½μ((u' + g₀')² − g₀'²), on this side.
    fn released(&self, spot: BeamPoint) -> f64 {
        let cell = &self.mesh.cells[spot.cell];
        let ([_, mu], y) = (cell.ground_at(spot.s), self.look(&self.state, spot, true));
        let [shear, _] = self.shear_stiffness_at(spot).unwrap_or_default();
        let (lies, own) = (y.rise + cell.gap_slope, cell.gap_slope);
        let beam = (shear + self.model.beam.axial_force) * y.slope * y.slope;
        -0.5 * (beam + mu * (lies * lies - own * own))
    }

    /// At which field the output looks, if it looks at a place.
    fn looked_at(&self, dual: &Dual, x: f64) -> Option<(Quantity, f64, Side)> {
        let node = |x: f64| self.mesh.node_at(x);
        dual.looks.filter(|(_, at, _)| node(*at) == node(x))
    }

    /// Whether a field jumps where a load stands that moves, once it has passed, or kinks there and tells the sides apart.
    fn tells_sides(&self, field: Quantity, point: &PointChange, moves: bool) -> bool {
        match point.against {
            Against::Rotation => false,
            Against::Deflection => moves && self.steps(field, point.x),
            Against::SlopeBeside => self.steps(field, point.x),
            _ => matches!(field, Quantity::ShearForce | Quantity::Moment | Quantity::Pressure),
        }
    }

    /// Whether a field jumps where a force acts on the beam: its dual field is a step.
    pub fn steps(&self, field: Quantity, x: f64) -> bool {
        let shears = |side| self.shear_stiffness_at(self.spot(x, side)).is_some();
        match field {
            Quantity::ShearForce => true,
            // V is part of the slope, and the pressure is what the slope does.
            Quantity::Slope | Quantity::Pressure => shears(Side::Left) || shears(Side::Right),
            _ => false,
        }
    }

    /// How far an edge of contact follows a force that moves, whose kink holds it.
    pub fn edge_moves(&self, zone: usize, side: Side, change: &Change) -> f64 {
        let Some(ends) = self.zones.get(zone) else { return 0.0 };
        let spot = if side == Side::Left { ends.from } else { ends.to };
        let x = self.mesh.nodes[spot.cell + usize::from(spot.s > 0.0)].x;
        let node = self.mesh.node_at(x);
        let own = change.moves.is_some_and(|x| self.mesh.node_at(x) == node);
        let forced = change.points.iter().any(|point| point.against == Against::SlopeBeside);
        let held = self.shear_stiffness_at(spot).is_some() && self.stays(spot);
        if own && forced && held && self.stands_alone(x) { 1.0 } else { 0.0 }
    }
}
