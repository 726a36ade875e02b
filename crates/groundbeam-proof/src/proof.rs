//! The proof: an admissible deflection, an exactly balanced pressure, and a bound of the difference of their energies.

use crate::answer::Answer;
use crate::contact_set::{Contact, ContactSet};
use crate::fields::Fields;
use crate::frame::Frame;
use crate::given::frame;
use crate::idle;
use crate::model::Model;
use crate::pointwise::{Bounds, PieceBounds, Pointwise};
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;

/// What is proven of an answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Proof {
    /// E \[N·m\]: the energy of the error of the deflection and of the settlement, and that of the error of moment and
    /// pressure, together are at most this.
    pub energy: f64,
    /// Bounds of the error of the fields at every point of the beam.
    pub bounds: Bounds,
    /// The exact contact set: an interval for every edge and concentrated force, or the name of the step that fails. The
    /// other bounds hold in both cases.
    pub contact: Result<ContactSet, NotProven>,
    /// The strain energy of beam, ground and springs \[N·m\], an estimate to compare E with.
    pub strain_energy: f64,
}

/// Bounds how far the answer is from the solution of the model.
pub fn prove<S: Scalar>(model: &Model<S>, answer: &Answer) -> Result<Proof, NotProven> {
    let frame = frame(model, answer)?;
    let fields = Fields::of(&frame)?;
    let (energy, balanced) = fields.energy()?;
    if !(energy.value() < f64::INFINITY) {
        return Err(NotProven::new("the bound of the energy is infinite"));
    }
    let pointwise = Pointwise { fields: &fields, balanced: &balanced, energy };
    let pieces = pointwise.bounds();
    idle::clear(&frame, &pieces)?;
    Ok(Proof {
        energy: frame.units.restored(energy.value(), 1, 1),
        bounds: largest(&frame, &pieces),
        contact: Contact { fields: &fields, bounds: &pieces }.set(),
        strain_energy: frame.units.restored(fields.strain_energy(), 1, 1),
    })
}

/// The largest bounds of all pieces, in the units of the model.
fn largest<S: Scalar>(frame: &Frame<S>, pieces: &[PieceBounds]) -> Bounds {
    let most = |of: &dyn Fn(&PieceBounds) -> Size, force: i32, length: i32| {
        let largest = pieces.iter().map(of).fold(Size::ZERO, Size::worst);
        frame.units.restored(largest.value(), force, length)
    };
    Bounds {
        deflection: most(&|piece| piece.deflection, 0, 1),
        slope: most(&|piece| piece.slope, 0, 0),
        moment: most(&|piece| piece.moment, 1, 1),
        settlement: most(&|piece| piece.settlement, 0, 1),
    }
}
