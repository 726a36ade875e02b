//! The answer of beam and ground to a parameter, forward: what it changes of the equations as a load, one solve, and
//! every output read off.
//!
//! A load that is no polynomial acts on an element by its work on the element's four functions alone: at nodes the
//! answer is exact, for the functions are the solutions without load, and every output looks at a node.

use super::change::{Against, Change};
use super::field::{Field, POINTS};
use super::linearised::{Linearised, dot, is_rigid};
use super::output::Functional;
use super::parameter::SupportNumber;
use crate::derivatives::{NotDifferentiable, Output, Side, Solution};
use crate::element::operator::ZoneKind;
use crate::ground::link;
use crate::mesh::deflection::BeamPoint;
use crate::model::SupportKind;

/// The answer to a change.
struct Answer {
    field: Field,
    /// All that was pushed.
    pushed: Functional,
    /// What is spread along each element, as loads on its four.
    spread: Vec<[f64; 4]>,
    /// Moments at nodes that stand for forces which move away from them.
    leaving: Vec<(usize, [f64; 4])>,
    /// What is spread along open ground, as forces at the ends of the strips of every joint.
    on_ground: Vec<Vec<f64>>,
}

impl Solution {
    /// The derivatives of all outputs by each of the changes.
    pub(super) fn forward(
        &self,
        lin: &Linearised,
        outputs: &[Output],
        changes: &[Change],
    ) -> Result<Vec<Vec<f64>>, NotDifferentiable> {
        let unit = lin.unit_fields();
        let row = |change: &Change| {
            let answer = lin.forward(change, &unit).ok_or(NotDifferentiable::NotUnique)?;
            let read = |output: &Output| self.read(lin, *output, change, &answer);
            outputs.iter().map(read).collect()
        };
        changes.iter().map(row).collect()
    }

    fn read(
        &self,
        lin: &Linearised,
        output: Output,
        change: &Change,
        answer: &Answer,
    ) -> Result<f64, NotDifferentiable> {
        if output == Output::PotentialEnergy {
            return Ok(self.energy(lin, std::slice::from_ref(change)).rates[0].value);
        }
        let (functional, _) = self.functional(lin, output)?;
        let mut rate = lin.read(&functional, answer) + lin.direct(&functional, change);
        if let Output::Edge(region, side) = output {
            rate += self.edge_follows(lin, region, side, change);
        }
        if let Output::Smallest(field) | Output::Largest(field) = output {
            let place = self.extreme(field, matches!(output, Output::Largest(_)));
            rate += place.slope * self.moves_forward(lin, &place, change, answer);
        }
        Ok(rate)
    }

    /// How the place of an extreme moves.
    fn moves_forward(
        &self,
        lin: &Linearised,
        place: &super::extreme::Place,
        change: &Change,
        answer: &Answer,
    ) -> f64 {
        match lin.edge_at(place.x).filter(|_| place.slope != 0.0) {
            Some(edge) => lin.read(&edge, answer) + lin.direct(&edge, change),
            None => lin.follows(place, change),
        }
    }
}

impl Linearised {
    /// Each of an element's four functions, in all elements at once.
    fn unit_fields(&self) -> [Field; 4] {
        std::array::from_fn(|j| {
            let mut unit = [0.0; 4];
            unit[j] = 1.0;
            self.spanned(vec![unit; self.elements.len()])
        })
    }

    /// j of the answer to one change.
    pub fn answer_of(
        &self,
        functional: &Functional,
        change: &Change,
    ) -> Result<f64, NotDifferentiable> {
        let answer = self.forward(change, &self.unit_fields());
        let answer = answer.ok_or(NotDifferentiable::NotUnique)?;
        Ok(self.read(functional, &answer))
    }

    fn forward(&self, change: &Change, unit: &[Field; 4]) -> Option<Answer> {
        let mut f = Functional::default();
        let mut spread = vec![[0.0; 4]; self.elements.len()];
        for (i, piece) in self.pieces.iter().enumerate() {
            for (j, field) in unit.iter().enumerate() {
                let points = &field.points[i * POINTS..(i + 1) * POINTS];
                spread[piece.element][j] += self.piece_rate(change, i, points, false) * piece.half;
            }
        }
        f.push.loads.extend(spread.iter().copied().enumerate());
        let mut on_ground = self.push_open_ground(change, &mut f);
        for right in [false, true] {
            let y = self.at_the_end(&self.state, right);
            let rates = change.beyond[usize::from(right)].iter();
            let parts = link::energies_beside(&self.beyond(right));
            let taken = rates.zip(&parts).map(|(r, part)| r[0] * part[0] + r[1] * part[1]);
            let force = self.pressed_beside(change, right) - y * taken.sum::<f64>();
            self.push_at_the_end(&mut f, &mut on_ground, right, force);
        }
        let leaving = self.push_points(change, &mut f, &mut on_ground);
        self.push_held(change, &mut f);
        let field = self.answer(&f.push).ok()?;
        Some(Answer { field, pushed: f, spread, leaving, on_ground })
    }

    /// Open ground under the beam, and the gap at the ends of its joints.
    fn push_open_ground(&self, change: &Change, f: &mut Functional) -> Vec<Vec<f64>> {
        let mut all = Vec::with_capacity(self.joints.len());
        for (j, joint) in self.joints.iter().enumerate() {
            if change.gap.is_some() {
                let at = |end: Option<BeamPoint>| {
                    let x = end.map(|spot| self.mesh.cells[spot.cell].global(spot.s));
                    x.map_or(0.0, |x| change.gap_at(&self.model, x))
                };
                f.push.parted.push((j, joint.ends.map(at)));
            }
            let mut forces = vec![0.0; joint.strips.len() + 1];
            for (strip, piece) in joint.strips.iter().enumerate() {
                let Some(i) = *piece else { continue };
                for (end, force) in forces[strip..strip + 2].iter_mut().enumerate() {
                    let heights = if end == 0 { [1.0, 0.0] } else { [0.0, 1.0] };
                    let points = self.open_strip(i, heights);
                    *force += self.piece_rate(change, i, &points, false) * self.pieces[i].half;
                }
            }
            for (height, force) in forces.iter().enumerate() {
                if *force != 0.0 {
                    self.read_height(f, j, height, *force);
                }
            }
            all.push(forces);
        }
        all
    }

    /// The ground beyond an end of the beam, whose u there is 1.
    fn push_at_the_end(
        &self,
        f: &mut Functional,
        on_ground: &mut [Vec<f64>],
        right: bool,
        force: f64,
    ) {
        if force == 0.0 || self.joints.is_empty() {
            return;
        }
        let j = if right { self.joints.len() - 1 } else { 0 };
        let strip = if right { self.joints[j].strips.len() - 1 } else { 1 };
        self.read_height(f, j, strip, force);
        on_ground[j][strip] += force;
    }

    /// What changes at points; of it the moments that stand for forces which move.
    fn push_points(
        &self,
        change: &Change,
        f: &mut Functional,
        on_ground: &mut [Vec<f64>],
    ) -> Vec<(usize, [f64; 4])> {
        let l = self.model.beam.length;
        let mut leaving = Vec::new();
        for point in &change.points {
            let (x, weight) = (point.x, point.weight);
            if point.against == Against::Settlement && !(0.0..=l).contains(&x) {
                let right = x > l;
                let out = if right { x - l } else { -x };
                let u = link::beside(&self.beyond(right), 1.0, out);
                self.push_at_the_end(f, on_ground, right, weight * u);
                continue;
            }
            let spot = self.spot(x, Side::Right);
            match point.against {
                Against::Deflection => {
                    self.read_deflection(f, spot, weight);
                    if change.moves.is_some() && (x <= 0.0 || x >= l) {
                        leaving.extend(f.push.loads.last().copied());
                    }
                }
                Against::Rotation => self.read_rotation(f, spot, weight),
                Against::SlopeBeside => {
                    let edge = self.edge_at_force(point.against, x);
                    let within = if edge == Some(Side::Right) { Side::Left } else { Side::Right };
                    self.read_slope(f, self.spot(x, within), weight);
                    leaving.extend(f.push.loads.last().copied());
                    if let Some(open) = edge {
                        self.push_edge(f, x, open);
                    }
                }
                Against::RotationBeside => {
                    self.read_rotation(f, spot, weight);
                    leaving.extend(f.push.loads.last().copied());
                }
                Against::BendBeside => {
                    self.read_moment(f, spot, -weight / self.stiffness_at(spot));
                }
                Against::CurlBeside => self.read_moment(f, spot, -weight),
                Against::Settlement => {
                    if self.pieces[self.piece_at(spot)].touch == ZoneKind::Contact {
                        self.read_deflection(f, spot, weight);
                    } else {
                        self.read_ground(f, spot, weight);
                    }
                }
            }
        }
        leaving
    }

    /// An edge of contact that moves with a force leaves a gap, where the ground falls away at an angle.
    fn push_edge(&self, f: &mut Functional, x: f64, open: Side) {
        let Some(zone) = self.zone_at(x, open) else { return };
        let y = self.look(&self.state, self.spot(x, open), true);
        let cell = &self.mesh.cells[self.spot(x, open).cell];
        let mut parted = self.force_at_edge(zone, open);
        parted.scale(y.rise + cell.gap_slope - y.slope);
        f.push.loads.extend(parted.push.loads);
        f.push.jumps.extend(parted.push.jumps);
        f.push.parted.extend(parted.push.parted);
    }

    fn push_held(&self, change: &Change, f: &mut Functional) {
        if let Some(hinge) = change.hinge.and_then(|i| self.model.hinges.get(i)) {
            let [left, right] = [Side::Left, Side::Right].map(|side| self.spot(hinge.at, side));
            let slope = |spot| self.at_node(&self.state, spot)[1];
            let turn = slope(right) - slope(left);
            self.read_rotation(f, right, -turn);
            self.read_rotation(f, left, turn);
        }
        let Some((i, number)) = change.support else { return };
        let Some(support) = self.model.supports.get(i) else { return };
        let spot = self.spot(support.at, Side::Right);
        let [w, slope] = self.at_node(&self.state, spot);
        match (number, support.kind) {
            (SupportNumber::Settlement, SupportKind::Spring { spring, .. }) => {
                self.read_deflection(f, spot, spring);
            }
            (SupportNumber::Settlement, kind) if is_rigid(kind) => {
                f.push.settled.push((self.mesh.node_at(support.at), 1.0));
            }
            (SupportNumber::Spring, _) => {
                self.read_deflection(f, spot, support.settlement - w);
            }
            (SupportNumber::RotationalSpring, _) => self.read_rotation(f, spot, -slope),
            _ => {}
        }
    }

    /// j of an answer.
    fn read(&self, functional: &Functional, answer: &Answer) -> f64 {
        let (field, push) = (&answer.field, &functional.push);
        let mut sum = 0.0;
        // What an element does beyond a kink at its end.
        let within = |element: usize| {
            let mut v = field.shapes[element];
            for (_, own) in answer.pushed.push.jumps.iter().filter(|(e, _)| *e == element) {
                for (v, own) in v.iter_mut().zip(own) {
                    *v -= own;
                }
            }
            v
        };
        for (element, row) in &push.loads {
            // An output that looks from the right sees what is beyond a kink; the forces under an end do not.
            let looks = functional.looks.is_some();
            let v = if looks { within(*element) } else { field.shapes[*element] };
            sum += dot(row, &v);
        }
        for (element, jump) in &push.jumps {
            let stiffness = self.elements[*element].element.stiffness;
            let demanded = stiffness.map(|row| dot(&row, &within(*element)));
            sum += dot(jump, &demanded) - dot(jump, &answer.spread[*element]);
            // A support feels what moves away from it; a place where an output looks does not.
            if functional.looks.is_none() {
                let own = answer.leaving.iter().filter(|(e, _)| e == element);
                sum -= own.map(|(_, row)| dot(jump, row)).sum::<f64>();
            }
        }
        for (j, jump) in &push.parted {
            // What the strips at both ends bring there themselves, and all that is pushed in between.
            let spread = &answer.on_ground[*j];
            let last = spread.len() - 1;
            let ends = [(0, spread[0]), (last, spread[last])];
            let within = answer.pushed.push.on_joint(*j).chain(ends);
            let forces = self.joints[*j].forces_under(&field.heights[*j], within);
            sum += jump[0] * forces[0] + jump[1] * forces[1];
        }
        for (j, strip, weight) in &push.on_ground {
            sum += weight * field.heights[*j][*strip];
        }
        for (node, weight) in &push.settled {
            sum += weight * self.reaction(field, &answer.pushed.push, self.mesh.nodes[*node].x);
        }
        sum
    }
}
