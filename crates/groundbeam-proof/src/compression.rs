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

    /// ((s₂ + N_c)² + s₂²)^½/√σ, which takes the place of s₂ = √(2E) in bounds from test functions.
    pub fn test_factor(&self, energy: Size, turned: Size) -> Size {
        let root = (2.0 * energy).root();
        let missed = root + self.misfit(turned);
        (missed.square() + root.square()).over(self.margin).root()
    }

    /// (((1 − σ)N)^½ + N(σΣhc′²)^½/s₂)², which takes the place of P in K². With the factor of `test_factor`, K² then
    /// bounds the contribution of the misfit s − Pw*′. By Cauchy's inequality,
    ///
    /// ```text
    /// (s₂ + N_c)K₁/√σ + s₂((1 − σ)NZ/σ)^½ + N(ZΣhc′²)^½ ≤ (((s₂ + N_c)² + s₂²)/σ)^½ (K₁² + PZ)^½,   Z = ∫z′².
    /// ```
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
