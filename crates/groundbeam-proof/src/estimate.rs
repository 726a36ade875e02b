//! Estimates the error energy and the energies of an answer in doubles, without proof. Every solve computes this estimate.

use crate::answer::Answer;
use crate::energies::Energies;
use crate::fields::Fields;
use crate::float::TINY;
use crate::given::frame;
use crate::idle;
use crate::model::Model;
use crate::refusal::NotProven;

/// Largest energy of unbalanced loads that is treated as rounding error, relative to the strain energy.
const ROUNDING: f64 = 1e-8;

/// Error energy, strain energy and potential energy of a claimed solution, computed in double precision.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// Error energy E \[N·m\]: the potential energy of the corrected deflection minus the dual (reciprocal) energy
    /// of the moments and pressures that are in exact equilibrium.
    pub energy: f64,
    /// The strain energy of beam, ground and springs \[N·m\].
    pub strain_energy: f64,
    /// The potential energy J of the claimed deflection \[N·m\].
    pub potential_energy: f64,
}

/// Estimates the energies of an answer. Under compression, `stability` is the fraction of the convexity of the
/// energy that remains: 1 minus the compression divided by the critical compression. If `stability` is `None`, the
/// fraction is computed from supports and stiffness alone.
///
/// # Errors
///
/// Returns the reason why no balanced pressure or no admissible deflection can be constructed from the answer.
pub fn estimate(
    model: &Model<f64>,
    answer: &Answer,
    stability: Option<f64>,
) -> Result<Estimate, NotProven> {
    let frame = frame(model, answer, stability, &[])?;
    idle::nearly_clear(&frame)?;
    let fields = Fields::of(&frame)?;
    let energies = Energies::of(&fields);
    let energy = match fields.energy() {
        Ok((energy, _)) => energy,
        Err(_) => fields.nearly_balanced_energy(ROUNDING * energies.strain)?,
    };
    let restored = |x: f64| frame.units.restored(x, 1, 1);
    // An energy of exactly zero is stored as a number of at most `TINY`, because sizes are rounded up.
    let energy = if energy.value() <= TINY { 0.0 } else { energy.value() };
    Ok(Estimate {
        energy: restored(energy),
        strain_energy: restored(energies.strain),
        potential_energy: restored(energies.potential),
    })
}
