//! The energies of an answer in doubles: an error estimate without proof, computed in every solve.

use crate::answer::Answer;
use crate::energies::Energies;
use crate::fields::Fields;
use crate::float::TINY;
use crate::given::frame;
use crate::idle;
use crate::model::Model;
use crate::refusal::NotProven;

/// The largest energy of unbalanced loads, relative to the strain energy, that counts as rounding error.
const ROUNDING: f64 = 1e-8;

/// The energies of an answer, in plain doubles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// E \[N·m\]: the difference between the potential energy and the reciprocal energy of the fields that
    /// are constructed from the answer.
    pub energy: f64,
    /// The strain energy of beam, ground and springs \[N·m\].
    pub strain_energy: f64,
    /// The potential energy J of the claimed deflection \[N·m\].
    pub potential_energy: f64,
}

/// Estimates the energies of an answer. Under compression, `stability` is the fraction of the energy's
/// convexity that remains: 1 minus the compression divided by its critical value. If it is `None`, it is
/// computed from supports and stiffness alone.
///
/// # Errors
///
/// The reason why no balanced pressure or no admissible deflection can be constructed from the answer.
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
    // An exact zero is rounded up to TINY.
    let energy = if energy.value() <= TINY { 0.0 } else { energy.value() };
    Ok(Estimate {
        energy: restored(energy),
        strain_energy: restored(energies.strain),
        potential_energy: restored(energies.potential),
    })
}
