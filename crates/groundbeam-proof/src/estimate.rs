//! Estimates the error energy and the energies of a solution in double precision, without proof. Every solve computes them.

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

/// Estimates the energies of a claimed solution. Under compression, `stability` is 1 minus the compression divided by
/// the critical compression. `None` means that this number is computed from supports and stiffness alone.
///
/// # Errors
///
/// Returns the reason why pressures in equilibrium or an admissible deflection cannot be constructed.
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
    // Bounds are rounded up, so the bound of an energy of exactly zero can be a positive number of at most `TINY`.
    let energy = if energy.value() <= TINY { 0.0 } else { energy.value() };
    Ok(Estimate {
        energy: restored(energy),
        strain_energy: restored(energies.strain),
        potential_energy: restored(energies.potential),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read::read_model;
    use crate::{Wide, prove};
    use serde_json::{Value, json};

    fn estimated(model: &str, document: &Value) -> Result<Estimate, NotProven> {
        let model = read_model::<f64>(model, None).expect("a model");
        estimate(&model, &Answer::from_json(&document.to_string()).expect("an answer"), None)
    }

    /// Checks the estimate for the claim w = 1 + ε. The exact deflection is 1, so the error energy is ε². The estimate
    /// may be larger, because it includes a bound of the moments that restore equilibrium.
    #[test]
    fn the_estimate_of_a_shifted_beam_covers_its_error_energy() {
        let model = "[beam]\nlength = 2\nEI = 1\n[foundation]\nk = 1\n[[load]]\ndistributed = 1\n";
        for shift in [0.0, 1e-2, -1e-4, 1e-6] {
            let piece =
                json!({"x": [0, 2], "half": 1, "touches": true, "deflection": [1.0 + shift]});
            let document = json!({"pieces": [piece]});
            let found = estimated(model, &document).expect("an estimate");
            let exact = shift * shift;
            assert!((exact..=3.0 * exact).contains(&found.energy), "{shift}: {found:?}");
            let answer = Answer::from_json(&document.to_string()).expect("an answer");
            let model = read_model::<Wide>(model, None).expect("a model");
            let proven = prove(&model, &answer).expect("bounds").energy;
            assert!((found.energy - proven).abs() <= 1e-6 * exact + 1e-24, "{shift}: {proven}");
            let strain = (1.0 + shift) * (1.0 + shift);
            assert!((found.strain_energy / strain - 1.0).abs() < 1e-12, "{shift}: {found:?}");
            let potential = strain - 2.0 * (1.0 + shift);
            assert!((found.potential_energy / potential - 1.0).abs() < 1e-12, "{shift}: {found:?}");
        }
    }

    /// Checks a beam on a pin at midspan under the end forces 3 and 3 + ε. Balancing the moment ε adds the energy
    /// 3ε/EI, which must be at most 10⁻⁸ of the strain energy 3/EI.
    #[test]
    fn a_beam_on_one_pin_may_be_unbalanced_by_rounding_error() {
        for bending in [1.0, 4096.0, 1.0 / 4096.0] {
            for (excess, right) in
                [(1e-9, true), (5e-9, true), (0.99e-8, true), (1.01e-8, false), (1e-3, false)]
            {
                let model = format!(
                    "[beam]\nlength = 2\nEI = {bending:?}\n[foundation]\nk = 1\n\
                     [[gap]]\nat = 0\nvalue = 1e6\n[[support]]\nat = 1\ntype = 'pinned'\n\
                     [[load]]\npoint = 3\nat = 0\n[[load]]\npoint = {:?}\nat = 2\n",
                    3.0 + excess
                );
                let piece = |from: u32, sign: f64| {
                    let w = [0.3125, -0.5625 * sign, 0.1875, 0.0625 * sign].map(|c| c / bending);
                    json!({"x": [from, from + 1], "half": 0.5, "touches": false, "deflection": w})
                };
                let pieces = [piece(0, 1.0), piece(1, -1.0)];
                let found =
                    estimated(&model, &json!({"pieces": pieces, "reactions": [{"force": 6}]}));
                let what = format!("{bending} {excess}: {found:?}");
                match found {
                    Ok(found) => {
                        let ratio = found.energy / (3.0 * excess / bending);
                        assert!(right && (ratio - 1.0).abs() < 1e-3, "{what}: {ratio}");
                    }
                    Err(why) => assert!(!right && why.what.contains("does not balance"), "{what}"),
                }
            }
        }
    }
}
