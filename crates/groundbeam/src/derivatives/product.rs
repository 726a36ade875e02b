//! The derivative of an output: the change of the equations at the solution times the output's dual field.

use super::change::Change;
use super::field::{Field, POINTS, Point};
use super::linearised::{Linearised, is_rigid};
use super::parameter::SupportNumber;
use super::push::Push;
use crate::element::operator::ZoneKind;
use crate::ground::link;
use crate::mesh::deflection::BeamPoint;
use crate::model::SupportKind;
use crate::numeric::polynomial::value;
use crate::numeric::quadrature::gauss;
use crate::solution::field::Field as Quantity;
use crate::solution::fields::Side;

/// A dual field, and what is special about it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Dual<'a> {
    pub field: &'a Field,
    pub push: &'a Push,
    /// At which field the output looks, where, and from which side.
    pub looks: Option<(Quantity, f64, Side)>,
    /// It is minus the solution itself: of the energy, whose forms count half.
    pub energy: bool,
}

/// So many decay lengths from the beam its ground does not move.
const FAR: f64 = 50.0;

/// A derivative, and whether it holds for growing parameters alone.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Rate {
    pub value: f64,
    /// The place at which what moves stands on a jump \[m\].
    pub jumps_at: Option<f64>,
}

impl Linearised {
    /// −∂a(y, z) + ∂F(z) for the solution y and a dual field z.
    pub fn rate(&self, change: &Change, dual: &Dual) -> Rate {
        let mut rate = Rate { value: self.spread_rate(change, dual), jumps_at: None };
        rate.value += self.joint_rate(change, dual) + self.held_rate(change, dual);
        for point in &change.points {
            self.add_point(point, change.moves.is_some(), dual, &mut rate);
        }
        rate
    }

    /// What is spread along the beam.
    fn spread_rate(&self, change: &Change, dual: &Dual) -> f64 {
        let mut sum = 0.0;
        for (i, piece) in self.pieces.iter().enumerate() {
            let own = i * POINTS..(i + 1) * POINTS;
            sum += self.piece_rate(change, i, &dual.field.points[own], dual.energy) * piece.half;
        }
        sum
    }

    /// The same of one piece of half length 1, by the dual field at its points.
    pub fn piece_rate(&self, change: &Change, i: usize, dual: &[Point], energy: bool) -> f64 {
        let piece = &self.pieces[i];
        let cell = &piece.cell;
        let half = if energy { 0.5 } else { 1.0 };
        let own = &self.state.points[i * POINTS..(i + 1) * POINTS];
        let mut sum = 0.0;
        for (((s, weight), y), z) in gauss().zip(own).zip(dual) {
            let rates = change.at(&self.model, piece, s);
            let stiffness =
                if cell.beam_varies() { value(&cell.stiffness_along(), s) } else { cell.stiffness };
            let [k, mu] = cell.ground_at(s);
            let mut form = rates.stiffness * stiffness * y.bend * z.bend;
            if let Some(shear) = &cell.beam_shear {
                form += rates.shear_stiffness * value(shear, s) * y.strain * z.strain;
            }
            form += rates.axial * y.slope * z.slope;
            form += rates.spring * k * y.u * z.u + rates.shear * mu * y.rise * z.rise;
            let mut work = rates.force * z.w + rates.moment * z.rotation;
            work += rates.curvature * stiffness * z.bend + rates.ground * z.u;
            if piece.touch == ZoneKind::Contact {
                work += k * rates.gap * z.u + mu * rates.gap_slope * z.rise;
            }
            sum += weight * (work - half * form);
        }
        sum
    }

    /// Open ground: what gaps at its ends do, and all that is beyond the beam.
    fn joint_rate(&self, change: &Change, dual: &Dual) -> f64 {
        let mut sum = 0.0;
        for (j, (joint, heights)) in self.joints.iter().zip(&dual.field.heights).enumerate() {
            if change.gap.is_some() {
                let forces = joint.forces_under(heights, dual.push.on_joint(j));
                for (end, force) in joint.ends.into_iter().zip(forces) {
                    let at = end.map(|spot| self.mesh.cells[spot.cell].global(spot.s));
                    sum += force * at.map_or(0.0, |x| change.gap_at(&self.model, x));
                }
            }
        }
        for right in [false, true] {
            let rates = &change.beyond[usize::from(right)];
            if rates.iter().all(|rate| *rate == [0.0; 2]) {
                continue;
            }
            let half = if dual.energy { 0.5 } else { 1.0 };
            let [y, z] = [&self.state, dual.field].map(|field| self.at_the_end(field, right));
            let parts = link::energies_beside(&self.beyond(right));
            for (rate, part) in rates.iter().zip(&parts) {
                sum -= half * y * z * (rate[0] * part[0] + rate[1] * part[1]);
            }
        }
        sum + self.beside_rate(change, dual)
    }

    /// Loads spread on the ground beside the beam.
    fn beside_rate(&self, change: &Change, dual: &Dual) -> f64 {
        let part =
            |right: bool| self.pressed_beside(change, right) * self.at_the_end(dual.field, right);
        part(false) + part(true)
    }

    /// What changes of loads spread on the ground beside the beam, by their work on u that is 1 at the beam's end.
    pub fn pressed_beside(&self, change: &Change, right: bool) -> f64 {
        let l = self.model.beam.length;
        let mut sum = 0.0;
        for ([from, to], [start, end]) in change.on_ground() {
            let ends = if right { [from.max(l), to] } else { [from, to.min(0.0)] };
            if ends[1] <= ends[0] {
                continue;
            }
            let beyond = self.beyond(right);
            let mut cuts = ends.to_vec();
            let mut depth = 0.0;
            for layer in &beyond.layers {
                let decay = (layer.shear_layer / layer.subgrade).sqrt();
                let length = layer.length.min(FAR * decay);
                let place = |d: f64| if right { l + d } else { -d };
                let mut x = [place(depth), place(depth + length)];
                x.sort_by(f64::total_cmp);
                cuts.extend(x);
                link::cut(x, decay, &mut cuts);
                depth += layer.length;
            }
            cuts.retain(|x| *x >= ends[0] && *x <= ends[1]);
            cuts.sort_by(f64::total_cmp);
            for part in cuts.windows(2) {
                let (middle, half) = (0.5 * (part[0] + part[1]), 0.5 * (part[1] - part[0]));
                for (s, weight) in gauss() {
                    let x = middle + half * s;
                    let q = (start * (to - x) + end * (x - from)) / (to - from);
                    let out = if right { x - l } else { -x };
                    sum += weight * half * q * link::beside(&beyond, 1.0, out);
                }
            }
        }
        sum
    }

    /// Supports and hinges.
    fn held_rate(&self, change: &Change, dual: &Dual) -> f64 {
        let half = if dual.energy { 0.5 } else { 1.0 };
        let mut sum = 0.0;
        if let Some(hinge) = change.hinge.and_then(|i| self.model.hinges.get(i)) {
            let turn = |field: &Field| {
                let side = |side| self.at_node(field, self.spot(hinge.at, side))[1];
                side(Side::Right) - side(Side::Left)
            };
            sum -= half * turn(&self.state) * turn(dual.field);
        }
        let Some((i, number)) = change.support else { return sum };
        let Some(support) = self.model.supports.get(i) else { return sum };
        let spot = self.spot(support.at, Side::Right);
        let [w, slope] = self.at_node(&self.state, spot);
        let [z, turn] = self.at_node(dual.field, spot);
        // Of the energy: what its springs give way, not w.
        let z = if dual.energy { support.settlement - w } else { z };
        sum + match (number, support.kind) {
            (SupportNumber::Settlement, SupportKind::Spring { spring, .. }) => spring * z,
            (SupportNumber::Spring, _) => -half * (w - support.settlement) * z,
            (SupportNumber::RotationalSpring, _) => -half * slope * turn,
            _ => 0.0,
        }
    }

    /// Where a change settles a rigid support.
    pub fn settlement_of_rigid(&self, change: &Change) -> Option<f64> {
        let (i, number) = change.support?;
        let support = self.model.supports.get(i)?;
        (number == SupportNumber::Settlement && is_rigid(support.kind)).then_some(support.at)
    }

    /// u of a dual field anywhere.
    pub fn settlement(&self, field: &Field, x: f64) -> f64 {
        let l = self.model.beam.length;
        if x < 0.0 || x > l {
            let (right, out) = (x > l, if x > l { x - l } else { -x });
            return link::beside(&self.beyond(right), self.at_the_end(field, right), out);
        }
        // Where the beam stands on it, what steps between the two is beside that place.
        let (spot, node) = (self.spot(x, Side::Right), self.mesh.node_at(x));
        let tied = |end: &BeamPoint| end.cell + usize::from(end.s > 0.0) == node;
        if self.joints.iter().flat_map(|joint| joint.ends).flatten().any(|end| tied(&end)) {
            return self.at_node(field, spot)[0];
        }
        self.look(field, spot, false).u
    }

    /// u at an end of the ground under the beam, as the ground beyond sees it.
    pub fn at_the_end(&self, field: &Field, right: bool) -> f64 {
        let joint = if right { self.joints.last() } else { self.joints.first() };
        let heights = if right { field.heights.last() } else { field.heights.first() };
        let (Some(joint), Some(heights)) = (joint, heights) else { return 0.0 };
        match right {
            false if joint.ends[0].is_none() => heights[1],
            true if joint.ends[1].is_none() => heights[heights.len() - 2],
            _ => 0.0,
        }
    }

    pub fn beyond(&self, right: bool) -> crate::model::GroundOutside {
        let cells = &self.mesh.cells;
        let at_end =
            if right { cells[cells.len() - 1].ground_at(1.0) } else { cells[0].ground_at(-1.0) };
        self.model.foundation.beyond(right, self.model.beam.length, at_end)
    }

    /// EI at an end of an element.
    pub fn stiffness_at(&self, spot: BeamPoint) -> f64 {
        let cell = &self.pieces[self.piece_at(spot)].cell;
        if cell.beam_varies() { value(&cell.stiffness_along(), spot.s) } else { cell.stiffness }
    }
}
