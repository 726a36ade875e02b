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
    /// Returns N_c = ((1 − σ)N Σhc′²)^½, which bounds the residual of the axial force. N is the compression `force`.
    /// σ is `margin`: the work of N is at most (1 − σ) times the strain energy of the beam. `turned` is the sum Σhc′²
    /// over all pieces, with the length h of a piece and the slope c′ of the correction of the deflection.
    pub fn misfit(&self, turned: Size) -> Size {
        (Size::of((1.0 - self.margin).next_up()) * Size::of(self.force.high()) * turned).root()
    }

    /// Returns the factor by which error bounds of a compressed beam multiply the energy norm of a test function. It is
    /// ((s₂ + N_c)² + s₂²)^½/√σ, where s₂ = √(2E) with the error energy E = `energy`. N_c = [`Compression::misfit`]
    /// bounds the residual of the axial force. σ is `margin`: the work of the compression is at most (1 − σ) times
    /// the strain energy. Without compression, the factor is s₂.
    pub fn test_factor(&self, energy: Size, turned: Size) -> Size {
        let root = (2.0 * energy).root();
        let missed = root + self.misfit(turned);
        (missed.square() + root.square()).over(self.margin).root()
    }

    /// Returns an axial tension T for error bounds of a beam with the axial compression N. The energy of a test
    /// function z on a beam with the axial tension P is K² = K₁² + P∫z′², where K₁² is the energy without axial
    /// force. On the compressed beam, T replaces P.
    ///
    /// The result is T = (((1 − σ)N)^½ + N(σΣhc′²)^½/s₂)². σ is `margin`: the work of N is at most (1 − σ) times the
    /// strain energy of the beam. `turned` is the sum Σhc′² over all pieces, with the length h of a piece and the
    /// slope c′ of the correction of the deflection. s₂ = √(2E) with the error energy E = `energy`. With Z = ∫z′² and
    /// N_c = [`Compression::misfit`], Cauchy's inequality gives
    ///
    /// ```text
    /// (s₂ + N_c)K₁/√σ + s₂((1 − σ)NZ/σ)^½ + N(ZΣhc′²)^½ ≤ (((s₂ + N_c)² + s₂²)/σ)^½ (K₁² + TZ)^½.
    /// ```
    ///
    /// The last two terms on the left side are due to the axial force.
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
