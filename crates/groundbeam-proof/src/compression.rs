//! The axial compression N, and a number σ such that the work of N is at most (1 − σ) times the strain energy of the beam.

use crate::scalar::Scalar;
use crate::size::Size;

/// An axial compression.
#[derive(Debug)]
pub(crate) struct Compression<S> {
    /// Axial compression N = −P, where P is the axial force, positive in tension.
    pub force: S,
    /// A number σ > 0 such that, for every deflection, the work of the compression is at most (1 − σ) times the
    /// strain energy of the beam and its two-way supports.
    pub margin: f64,
}

impl<S: Scalar> Compression<S> {
    /// Returns N_c = ((1 − σ)NΣhc′²)^½ of section 3 of docs/proof.md, a bound of the residual of the axial force. N is
    /// `force`, σ is `margin`, and `turned` is Σhc′².
    pub fn misfit(&self, turned: Size) -> Size {
        (Size::of((1.0 - self.margin).next_up()) * Size::of(self.force.high()) * turned).root()
    }

    /// Returns the factor that replaces s₂ = √(2 `energy`) in bounds from test functions, by section 4 of
    /// docs/proof.md. It is ((s₂ + N_c)² + s₂²)^½/√σ, where N_c is [`Compression::misfit`] and σ is `margin`.
    pub fn test_factor(&self, energy: Size, turned: Size) -> Size {
        let root = (2.0 * energy).root();
        let missed = root + self.misfit(turned);
        (missed.square() + root.square()).over(self.margin).root()
    }

    /// Returns the tension that replaces the axial force in bounds from test functions, by section 4 of docs/proof.md.
    /// It is (((1 − σ)N)^½ + N(σ `turned`)^½/s₂)², where N is `force`, σ is `margin`, and s₂ = √(2 `energy`).
    pub fn as_tension(&self, energy: Size, turned: Size) -> Size {
        let force = Size::of(self.force.high());
        let convex = (Size::of((1.0 - self.margin).next_up()) * force).root();
        if turned == Size::ZERO {
            return convex.square();
        }
        let closed = force * (self.margin * turned).root();
        let root = (2.0 * energy.value()).sqrt().next_down();
        (convex + closed.over(root)).square()
    }
}

#[cfg(test)]
mod tests {
    use super::Compression;
    use crate::scalar::Scalar;
    use crate::size::Size;
    use crate::wide::Wide;

    #[test]
    fn the_misfit_is_the_norm_of_the_lost_convexity() {
        let compression = Compression { force: Wide::of(3.0), margin: 0.75 };
        let misfit = compression.misfit(Size::of(12.0)).value();
        assert!((3.0..3.0 + 1e-14).contains(&misfit), "{misfit}");
    }
}
