//! The certificate of a solution: energies of the problem, and an estimate of the energy of the solution's
//! error, from model and solution only.

use crate::model::{Action, Model};
use crate::numeric::tolerance::GAP;
use crate::solution::candidate::Candidate;
use crate::solution::claim::answer;
use groundbeam_proof::{Estimate, estimate};

/// The energies of a solution and the energy of its error, computed in doubles by the crate
/// `groundbeam_proof`.
///
/// The gap bounds the energy of the error except for rounding, so it is an estimate.
/// [`Solution::prove`](crate::Solution::prove) bounds the error in numbers that enclose all rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Certificate {
    primal_energy: f64,
    gap: f64,
    relative_gap: f64,
}

impl Certificate {
    /// The certificate of a candidate. Under compression, `stability` is the fraction of the energy's
    /// convexity that remains.
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

    /// The primal energy ½∫(EI (w″ − κ₀)² + P w'²) + ½b(u, u) − F(w): (3.8) plus the energy of the ground
    /// \[N·m\].
    pub fn primal_energy(&self) -> f64 {
        self.primal_energy
    }

    /// The dual energy, which is the reciprocal energy of moments and pressures in equilibrium: the primal
    /// energy minus the gap \[N·m\].
    pub fn dual_energy(&self) -> f64 {
        self.primal_energy - self.gap
    }

    /// The energy gap E: the primal minus the dual energy \[N·m\]. It bounds the sum of the energies of the
    /// errors of (w, u) and of (M, p).
    pub fn gap(&self) -> f64 {
        self.gap
    }

    /// The energy gap relative to the strain energy of beam, ground and springs, plus the energy ½∫EI κ₀² of the
    /// imposed curvature.
    pub fn relative_gap(&self) -> f64 {
        self.relative_gap
    }

    /// Whether the gap is within the rounding error of loads that cancel each other or that rigid supports
    /// carry. The scale is the energy that each load alone would cause in ground and beam.
    pub(crate) fn is_rounding_of_loads(&self, model: &Model) -> bool {
        self.gap <= GAP * f64::EPSILON * energy_of_single_loads(model)
    }

    /// All numbers of the certificate with their names, in the order of results.
    pub fn figures(&self) -> [(&'static str, f64); 4] {
        [
            ("primal_energy", self.primal_energy),
            ("dual_energy", self.dual_energy()),
            ("gap", self.gap),
            ("relative_gap", self.relative_gap),
        ]
    }
}

/// The sum of the energies that single loads would cause: F²/(kl) + M²/(kl³) for a rigid beam that translates
/// and rotates, (M + Fa)²a/EI for a beam that bends over a wave length a, and EI(δ/a)²/a for settlements of
/// supports.
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
