//! Certificate of a solution: its energies and an estimate of the energy of its error, from model and solution only.

use crate::model::{Action, Model};
use crate::numeric::tolerance::GAP;
use crate::solution::candidate::Candidate;
use crate::solution::claim::answer;
use groundbeam_proof::{Estimate, estimate};

/// The energies of a solution and an estimate of the energy of its error, computed in doubles by `groundbeam_proof`.
///
/// Without rounding errors, the energy gap is an upper bound. [`Solution::prove`](crate::Solution::prove) computes a
/// bound that includes rounding errors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Certificate {
    primal_energy: f64,
    gap: f64,
    relative_gap: f64,
}

impl Certificate {
    /// Computes the certificate of a candidate. For a beam under compression, `stability` is 1 + P/P_cr with the
    /// axial force P < 0 and the buckling load P_cr > 0.
    pub(crate) fn of(candidate: &Candidate, stability: f64) -> Self {
        let model = candidate.model.to_prove();
        let stability = (candidate.model.beam.axial_force < 0.0).then_some(stability);
        let Ok(found) = estimate(&model, &answer(candidate), stability) else {
            let none = f64::INFINITY;
            return Certificate { primal_energy: f64::NAN, gap: none, relative_gap: none };
        };
        let Estimate { energy: gap, strain_energy, potential_energy } = found;
        let relative_gap = if gap == 0.0 { 0.0 } else { gap / strain_energy };
        Certificate { primal_energy: potential_energy, gap, relative_gap }
    }

    /// The primal energy \[N·m\], (3.8) of Kikuchi's paper: the strain energy of beam, ground and springs minus the
    /// work of the loads.
    pub fn primal_energy(&self) -> f64 {
        self.primal_energy
    }

    /// The dual energy \[N·m\], which is the primal energy minus the energy gap. It is the dual functional of the
    /// moments and pressures, which are in equilibrium with the loads.
    pub fn dual_energy(&self) -> f64 {
        self.primal_energy - self.gap
    }

    /// The energy gap E, which is the primal minus the dual energy \[N·m\]. It is an upper bound of the sum of
    /// the energies of the errors of (w, u) and of (M, p).
    pub fn gap(&self) -> f64 {
        self.gap
    }

    /// The energy gap relative to a sum of energies. The sum contains the strain energy of beam, ground and
    /// springs, and the energy ½∫EI κ₀² of the imposed curvature κ₀.
    pub fn relative_gap(&self) -> f64 {
        self.relative_gap
    }

    /// Whether rounding errors of the loads can cause the energy gap. Loads can cancel each other, so the gap is
    /// compared with the sum of the energies that they cause one at a time.
    pub(crate) fn is_rounding_of_loads(&self, model: &Model) -> bool {
        self.gap <= GAP * f64::EPSILON * energy_of_single_loads(model)
    }

    /// All numbers of the certificate with their names, in the order in which results list them.
    pub fn figures(&self) -> [(&'static str, f64); 4] {
        [
            ("primal_energy", self.primal_energy),
            ("dual_energy", self.dual_energy()),
            ("gap", self.gap),
            ("relative_gap", self.relative_gap),
        ]
    }
}

/// Estimates the sum of the strain energies of all loads, each acting alone. It adds the energies of a rigid beam, of a
/// beam that bends over the length `wave`, and of the largest support settlement.
fn energy_of_single_loads(model: &Model) -> f64 {
    let (l, k, ei) = (model.beam.length, model.foundation.subgrade, model.beam.bending_stiffness);
    let wave = (4.0 * ei / k).sqrt().sqrt().min(l);
    let (mut forces, mut moments) = (0.0, 0.0);
    for load in model.loads.iter().filter(|load| !load.is_on_ground()) {
        let size = load.extent().total();
        match load.action() {
            Action::Force => forces += size,
            Action::Moment => moments += size,
            Action::Curvature => moments += ei * load.extent().largest(),
        }
    }
    let sunk = forces * (forces / (k * l));
    let turned = moments / l * (moments / (k * l * l));
    let bending = moments + forces * wave;
    let bent = bending * wave * (bending / ei);
    let settled = model.supports.iter().map(|s| s.settlement.abs()).fold(0.0, f64::max) / wave;
    sunk + turned + bent + ei / wave * (settled * settled)
}
