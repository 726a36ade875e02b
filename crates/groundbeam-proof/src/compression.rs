//! The axial compression, and the fraction of the energy's convexity that remains under it.

use crate::scalar::Scalar;
use crate::size::Size;

/// An axial compression.
#[derive(Debug)]
pub(crate) struct Compression<S> {
    /// N = −P.
    pub force: S,
    /// A lower bound of σ, the fraction of the energy's convexity that remains.
    pub margin: f64,
}

impl<S: Scalar> Compression<S> {
    /// N_c = ((1 − σ)N Σhc′²)^½ from Σhc′².
    pub fn misfit(&self, turned: Size) -> Size {
        (Size::of((1.0 - self.margin).next_up()) * Size::of(self.force.high()) * turned).root()
    }
}
