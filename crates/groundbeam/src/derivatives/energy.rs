//! Computes the derivatives of the potential energy with respect to parameters, at fixed displacements (envelope theorem).

use super::linear::Linear;
use super::tangent::{Motion, Moved};
use crate::mesh::energy::{Motion as Field, beam_form, ground_work, work_of_loads};
use crate::mesh::free_field::{self, Line};
use crate::model::SupportKind;
use crate::numeric::dual::Dual;
use crate::numeric::polynomial::{Coefficients, TERMS, derivative, inner, value};
use crate::numeric::real::Real;
use crate::solution::fields::Side;

impl<const N: usize> Linear<'_, N> {
    /// Computes the derivatives of the potential energy of beam, axial force, ground, springs and loads.
    pub fn energy(&self) -> [f64; N] {
        let (mesh, still) = (self.mesh(), self.equilibrium);
        let lifted = |c: &[f64]| c.iter().map(|c| Dual::from(*c)).collect::<Vec<Dual<N>>>();
        let (deflection, rotation) = (lifted(&still.deflection), lifted(&still.rotation));
        let own = Field { deflection: &deflection, rotation: &rotation };
        let mut psi = Vec::with_capacity(deflection.len());
        let mut energy = Dual::ZERO;
        for (i, (cell, w)) in mesh.cells.iter().zip(deflection.chunks(TERMS)).enumerate() {
            psi.extend_from_slice(&cell.obstacle(w)[..TERMS]);
            if cell.has_imposed_curvature() {
                let turned: Coefficients<Dual<N>> = match rotation.get(i * TERMS..(i + 1) * TERMS) {
                    Some(rotation) => derivative(rotation),
                    None => {
                        let mut bend = derivative(&derivative(w));
                        bend.iter_mut().for_each(|c| *c *= 2.0 / cell.length());
                        bend
                    }
                };
                let half = 0.5 * cell.length();
                let [left, right] = cell.curvature;
                let curvature = [(left + right) * 0.5, (right - left) * 0.5];
                let moment = cell.imposed_moment();
                energy += inner(&moment, &curvature, 0) * (0.5 * half) - inner(&moment, &turned, 0);
            }
        }
        energy += (beam_form(mesh, own, own) + ground_work(mesh, self.zones(), &psi, &psi)) * 0.5;
        energy -= work_of_loads(mesh, own);
        // Without the beam, the load q on the ground causes the settlement u₀ and the energy −½∫q u₀ dx.
        if self.frame.model.has_ground_loads() {
            let work = |line: &Line<Dual<N>>| free_field::work_of_loads(line, &mesh.cells);
            energy -= self.on_line(work) * 0.5;
        }
        for number in 0..self.frame.model.supports.len() {
            energy += self.settling(number);
        }
        let mut by = energy.by;
        for (by, tangent) in by.iter_mut().zip(&self.tangents) {
            *by += tangent.moved.map_or(0.0, |moved| self.by_motion(&moved));
        }
        by
    }

    /// Computes the energy due to the settlement δ of a support: ½k (w − δ)² − ½k w² for a spring k under the
    /// deflection w, or the work of a rigid support's reaction.
    fn settling(&self, number: usize) -> Dual<N> {
        let support = &self.frame.model.supports[number];
        let [spring, _, settlement] = self.numbers_of_support(number);
        if matches!(support.kind, SupportKind::Spring { .. }) {
            let w = self.at_node(support.at)[0].value;
            return spring * settlement * (settlement * 0.5 - w);
        }
        if settlement == support.settlement {
            return Dual::ZERO;
        }
        settlement * -self.reaction(support.at)[0].value
    }

    /// Computes the derivative of the energy with respect to the position of a load. A field that jumps at the load
    /// enters with the mean of its values on both sides.
    fn by_motion(&self, moved: &Moved) -> f64 {
        let (frame, x) = (self.frame, moved.x);
        let solution = frame.solution;
        let inside = frame.is_inside(x);
        let ends = if inside { [Side::Left, Side::Right] } else { [Side::Right; 2] };
        if frame.edge_at_force(moved).is_some() {
            let [left, right] = ends.map(|side| frame.released(x, side));
            return left - right;
        }
        let mean = |of: &dyn Fn(Side) -> f64| 0.5 * (of(ends[0]) + of(ends[1]));
        match moved.what {
            Motion::Force(force) => -force * frame.slope_with_half_kink(x, Side::Right, force),
            Motion::Moment(moment) => {
                let bend = |side: Side| {
                    let piece = solution.candidate().piece_at(x, side);
                    let s = piece.local(x);
                    let stiffness = value(&piece.cell.stiffness_along(), s);
                    let [left, right] = piece.cell.curvature;
                    let imposed = 0.5 * (left + right) + 0.5 * (right - left) * s;
                    imposed - value(&piece.moment, s) / stiffness
                };
                let part = if inside { 1.0 } else { 0.5 };
                -moment * part * mean(&bend)
            }
            Motion::MomentPerLength(moment) => {
                -moment * mean(&|side| solution.at(x, side).rotation)
            }
            Motion::Curvature(curvature) => curvature * mean(&|side| solution.at(x, side).moment),
            // The derivative of a distributed force with respect to the position of its end contains a point force at
            // this end. The work of this point force is already included in `energy`.
            Motion::ForcePerLength(_) => 0.0,
        }
    }
}
