//! The figures of a certificate, and the conditions under which it holds.

use crate::numeric::tolerance::CERTIFICATE;

/// The proof of a solution, computed from the model and the solution alone.
///
/// Every solution carries one (`Solution::certificate`). Only a solve makes one, from the
/// model and everything that the solution claims, so none is empty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Certificate {
    pub(super) primal_energy: f64,
    pub(super) dual_energy: f64,
    pub(super) gap: f64,
    pub(super) relative_gap: f64,
    pub(super) force_balance: f64,
    pub(super) moment_balance: f64,
    pub(super) smallest_pressure: f64,
    pub(super) deepest_penetration: f64,
    pub(super) continuity: f64,
    pub(super) complementarity: f64,
    pub(super) settlement_bound: f64,
    pub(super) moment_bound: f64,
    pub(super) moment_rms_bound: f64,
}

impl Certificate {
    /// The relative violation above which a result is refused.
    pub const TOLERANCE: f64 = CERTIFICATE;

    /// ½∫(EI (w″ − κ₀)² + P w'²) + ½b(u, u) − F(w): (3.8) and the ground's own energy \[N·m\].
    pub fn primal_energy(&self) -> f64 {
        self.primal_energy
    }

    /// The reciprocal energy ∫m κ₀ − ½∫m²/EI − ½∫P w'² − ½⟨p, Gp⟩ − ⟨p, g₀⟩ − Σ R δ \[N·m\].
    pub fn dual_energy(&self) -> f64 {
        self.dual_energy
    }

    /// Primal less dual energy, summed from parts none of which can be negative \[N·m\].
    pub fn gap(&self) -> f64 {
        self.gap
    }

    /// The gap relative to the strain energy of beam, ground and springs, and of bending straight what an imposed
    /// curvature has bent, ½∫EI κ₀².
    pub fn relative_gap(&self) -> f64 {
        self.relative_gap
    }

    /// |ΣF| relative to the sum of all forces' sizes.
    pub fn force_balance(&self) -> f64 {
        self.force_balance
    }

    /// |ΣM| relative to the sum of all moments' sizes.
    pub fn moment_balance(&self) -> f64 {
        self.moment_balance
    }

    /// The smallest contact pressure relative to the largest; negative would be a pull.
    pub fn smallest_pressure(&self) -> f64 {
        self.smallest_pressure
    }

    /// The deepest interpenetration w − u − g₀, relative to the largest deflection.
    pub fn deepest_penetration(&self) -> f64 {
        self.deepest_penetration
    }

    /// The largest jump of w, of w' or of a position where two pieces meet or a support holds, relative to
    /// the largest w, w' or the length.
    pub fn continuity(&self) -> f64 {
        self.continuity
    }

    /// The largest |p (u + g₀ − w)| of a concentrated force, relative to largest force × deflection.
    pub fn complementarity(&self) -> f64 {
        self.complementarity
    }

    /// |u − u*| is at most this, anywhere \[m\]. Nothing is claimed (infinity) without a shear layer.
    pub fn settlement_bound(&self) -> f64 {
        self.settlement_bound
    }

    /// √∫(M − M*)²/EI is at most this \[√(N·m)\].
    pub fn moment_bound(&self) -> f64 {
        self.moment_bound
    }

    /// The root mean square over the beam of M − M* is at most this \[N·m\].
    pub fn moment_rms_bound(&self) -> f64 {
        self.moment_rms_bound
    }

    /// All figures with the names that results give them, in the order in which results list them.
    pub fn figures(&self) -> [(&'static str, f64); 13] {
        [
            ("primal_energy", self.primal_energy),
            ("dual_energy", self.dual_energy),
            ("gap", self.gap),
            ("relative_gap", self.relative_gap),
            ("force_balance", self.force_balance),
            ("moment_balance", self.moment_balance),
            ("smallest_pressure", self.smallest_pressure),
            ("deepest_penetration", self.deepest_penetration),
            ("continuity", self.continuity),
            ("complementarity", self.complementarity),
            ("settlement_bound", self.settlement_bound),
            ("moment_bound", self.moment_bound),
            ("moment_rms_bound", self.moment_rms_bound),
        ]
    }

    /// Whether every condition that no mesh excuses holds to rounding.
    pub fn holds(&self) -> bool {
        self.violation() <= Self::TOLERANCE
    }

    /// The largest relative violation of balance, signs, continuity and complementarity.
    pub fn violation(&self) -> f64 {
        let finite = if self.relative_gap.is_finite() { 0.0 } else { f64::INFINITY };
        [
            self.force_balance,
            self.moment_balance,
            -self.smallest_pressure,
            self.continuity,
            self.complementarity,
            finite,
        ]
        .into_iter()
        .fold(0.0, |worst, part| if part.is_nan() { f64::INFINITY } else { worst.max(part) })
    }
}
