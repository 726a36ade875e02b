//! Bounds of the pressure and of the slope of a beam with shear deformation on a shear layer where S or μ varies.
//!
//! The bounds of pressure, slope and shear force depend on each other. So the first bound of the slope uses one piece
//! alone. See the text after (14b) in docs/proof.md.

use crate::coefficient::Coefficient;
use crate::frame::Span;
use crate::pointwise::{PieceBounds, Pointwise};
use crate::scalar::Scalar;
use crate::size::Size;
use crate::test_functions::least_of_halves;

/// Returns the shear stiffness S of a piece with shear deformation that lies on a shear layer, if S or the stiffness μ
/// of the layer varies along the piece.
fn varying<S>(span: &Span<S>) -> Option<&Coefficient<S>>
where
    S: Scalar,
{
    let stiffness = span.stiffness.as_ref().filter(|_| span.layered)?;
    (stiffness.even().is_none() || span.shear.even().is_none()).then_some(stiffness)
}

impl<S: Scalar> Pointwise<'_, S> {
    /// Returns the error bound (14b) of docs/proof.md. On a piece in contact, it bounds the error of the pressure where
    /// the exact solution is also in contact. On an open piece, it bounds the error of (μC′)′ with the clearance C.
    pub(crate) fn varying_pressure(&self, i: usize, bounds: &PieceBounds) -> Size {
        let span = &self.fields.frame.spans[i];
        let Some(stiffness) = varying(span) else { return Size::INFINITE };
        let [fixed, turned] = self.parts_of_pressure(i, stiffness, bounds);
        let error = fixed + turned * bounds.slope;
        let axial = self.fields.frame.axial_force().unwrap_or_else(S::zero);
        let whole = (S::of(stiffness.high()) + axial).high();
        match span.touches {
            true => error.over((S::one() + S::of(span.shear.low()).div(S::of(whole))).low()),
            false => error,
        }
    }

    /// Returns the two parts of the bound of the right side of (14b) in docs/proof.md: the part without the error of
    /// the slope, and the factor of the error of the slope.
    fn parts_of_pressure(
        &self,
        i: usize,
        stiffness: &Coefficient<S>,
        bounds: &PieceBounds,
    ) -> [Size; 2] {
        let (span, residual) = (&self.fields.frame.spans[i], &self.fields.residual.pieces[i]);
        let axial = self.fields.frame.axial_force().unwrap_or_else(S::zero);
        let factor = Size::of(span.shear.high()).over((S::of(stiffness.low()) + axial).low());
        let bent = bounds.moment.over(span.bending.low());
        let steep = span.steepness(stiffness);
        let forces = steep * bounds.rotation
            + Size::of(stiffness.high()) * bent
            + Size::of(residual.constant.size())
            + residual.rest
            + residual.misfit[1];
        let settled = Size::of(span.spring.high()) * bounds.settlement;
        [settled + factor * forces, span.steepness(&span.shear) + factor * steep]
    }

    /// Tightens the error bounds of slope and pressure on pieces with varying S or μ. Uses errors of the same piece
    /// only.
    pub(crate) fn first_slopes(&self, bounds: &mut [PieceBounds]) {
        for (i, piece) in bounds.iter_mut().enumerate() {
            let span = &self.fields.frame.spans[i];
            if let Some(stiffness) = varying(span) {
                piece.slope = piece.slope.least(self.first_slope(i, stiffness, piece));
                piece.pressure = piece.pressure.least(self.pressure(i, piece));
            }
        }
    }

    fn first_slope(&self, i: usize, stiffness: &Coefficient<S>, bounds: &PieceBounds) -> Size {
        let span = &self.fields.frame.spans[i];
        let (tension, stiffened) = (self.axial_size(), self.stiffened(stiffness));
        let misfit = self.fields.residual.pieces[i].misfit[0];
        // The error bound of the slope is `resting` plus `by_force` times the error bound of the transverse force.
        // `resting` does not depend on the transverse force.
        let other = self.balancing_shear(i)
            + self.balanced.pieces[i].drawn
            + tension * bounds.rotation
            + tension * misfit.over(stiffness.low());
        let resting = bounds.rotation + (other.over(stiffened) + misfit).over(stiffness.low());
        let by_force = Size::of(1.0).over(stiffened).over(stiffness.low());
        let [fixed, turned] = self.parts_of_pressure(i, stiffness, bounds);
        let pressure = &self.fields.pressures[i];
        let factor = self.balanced.factor(i);
        let alone = match span.touches {
            true => (Size::of(1.0) + factor) * (pressure.field.size(span.tau) + pressure.depth),
            false => self.open_pressure(i),
        };
        let spread = alone + fixed + turned * resting;
        let again = turned * by_force;
        let swing = match tension == Size::ZERO {
            true => tension,
            false => tension * bounds.deflection,
        };
        let change = 2.0 * bounds.balanced_moment + 2.0 * swing;
        let closed =
            tension * self.fields.deflection.pieces[i].bounds[1] + self.balanced.pieces[i].drawn;
        let force = least_of_halves(span.h.low(), |h| {
            let own = change.over(h) + closed + 0.5 * (Size::of(h) * spread);
            let kept = 1.0 - (0.5 * (Size::of(h) * again)).value();
            own.over(kept.next_down())
        });
        resting + force * by_force
    }

    /// Uses the error bounds of the slope to tighten those of the pressure, on pieces where the shear stiffness S of
    /// the beam or the stiffness μ of the layer varies.
    pub(crate) fn lower_pressures(&self, bounds: &mut [PieceBounds]) {
        for (i, piece) in bounds.iter_mut().enumerate() {
            if varying(&self.fields.frame.spans[i]).is_some() {
                piece.pressure = piece.pressure.least(self.pressure(i, piece));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::balance::Balanced;
    use crate::fields::Fields;
    use crate::given_claim::{balanced, with_fields};
    use crate::wide::Wide;
    use serde_json::json;

    /// The fields of a claimed solution, the forces that balance its residual, and the error bounds of the fields.
    struct Claim<'a, 'b> {
        fields: &'a mut Fields<'b, Wide>,
        balanced: Balanced<Wide>,
        bounds: PieceBounds,
    }

    impl Claim<'_, '_> {
        fn pointwise(&self) -> Pointwise<'_, Wide> {
            Pointwise { fields: self.fields, balanced: &self.balanced, energy: Size::ZERO }
        }

        fn first_slope(&self) -> Size {
            let stiffness = varying(&self.fields.frame.spans[0]).expect("a varying stiffness");
            self.pointwise().first_slope(0, stiffness, &self.bounds)
        }
    }

    /// Calls `of` with the claimed deflection w = 2 − x and the shear angle `turned`. The load equals the pressure.
    /// With the tension P, α = μ/(S + P) ≤ 1, |α′|(S + P) ≤ 1 and 1 + P/S ≥ 5/4.
    fn with_claim<T>(turned: f64, touches: bool, of: impl FnOnce(&mut Claim) -> T) -> T {
        let model = "[beam]\nlength = 1\nEI = 0.125\naxial_force = 0.25\n[[beam.segment]]\nfrom = 0\nto = 1\n\
                     shear_stiffness = [1, 0.5]\n[foundation]\nk = 0.25\nmu = 0.25\n\
                     [[foundation.segment]]\nfrom = 0\nto = 1\nk = 0.25\nmu = [0.25, 0.75]\n\
                     [[load]]\ndistributed = [1, 0.75]\n";
        let mut piece = json!({
            "x": [0, 1], "half": 0.5, "touches": touches, "deflection": [1.5, -0.5], "rotation": [-1.0 - turned],
        });
        if !touches {
            piece["settlement"] = json!([1, 0.5]);
        }
        with_fields(model, &json!({"pieces": [piece]}), |fields| {
            if !touches {
                // A beam out of contact has no pressure that balances the load, so this test sets the residual to
                // zero.
                fields.residual.pieces[0].constant = Wide::zero();
                fields.residual.pieces[0].rest = Size::ZERO;
            }
            of(&mut Claim {
                fields,
                balanced: balanced(1),
                bounds: PieceBounds { ..PieceBounds::EXACT },
            })
        })
    }

    fn same(what: &str, found: Size, expected: f64) {
        let ratio = found.value() / expected;
        assert!((1.0..1.0 + 1e-9).contains(&ratio), "{what}: {found:?} {expected}");
    }

    /// Returns the smallest bound of ε_T over h = 1, ½, ¼, … (text after (14b) in docs/proof.md). The arguments are A₁,
    /// A₂ and p₀ + A₃, and A₄ is 1.6.
    fn first_force([moved, closed, spread]: [f64; 3]) -> f64 {
        let force = |j: i32| {
            let h = 0.5_f64.powi(j);
            (moved / h + closed + 0.5 * h * spread) / (1.0 - 0.8 * h)
        };
        (0..24).map(force).fold(f64::INFINITY, f64::min)
    }

    /// Checks that `first_slope` returns `resting` plus 1.6 times the error bound of the transverse force. The moment
    /// has the error 10⁻³, and `turned` or `change` sets one other error.
    fn is_first_slope(
        what: &str,
        turned: f64,
        change: impl FnOnce(&mut Claim),
        [resting, moved, closed, spread]: [f64; 4],
    ) {
        with_claim(turned, true, |claim| {
            claim.bounds.balanced_moment = Size::of(1e-3);
            change(claim);
            let expected = resting + 1.6 * first_force([moved, closed, spread]);
            same(what, claim.first_slope(), expected);
        });
    }

    /// Checks the bound of the slope from errors on one piece: of the moment, and of at most one other quantity.
    #[test]
    fn the_first_slope_follows_from_the_change_of_moment_on_the_piece() {
        let size = Size::of;
        is_first_slope("no error", 0.0, |_| (), [0.0, 2e-3, 0.0, 1.0]);
        is_first_slope(
            "rotation",
            0.0,
            |c| c.bounds.rotation = size(0.1),
            [0.14, 2e-3, 0.0, 1.0 + 0.05 + 0.14],
        );
        is_first_slope("moment", 0.0, |c| c.bounds.moment = size(0.1), [0.0, 2e-3, 0.0, 1.8]);
        is_first_slope(
            "settlement",
            0.0,
            |c| c.bounds.settlement = size(0.4),
            [0.0, 2e-3, 0.0, 1.1],
        );
        is_first_slope(
            "deflection",
            0.0,
            |c| c.bounds.deflection = size(0.1),
            [0.0, 0.052, 0.0, 1.0],
        );
        // The misfit, which is the residual of the shear force, is S/8 with the shear stiffness S ≤ 1. Its derivative
        // has the magnitude 1/16.
        is_first_slope("misfit", 0.125, |_| (), [0.35, 2e-3, 0.0, 1.0 + 0.0625 + 0.35]);
        is_first_slope(
            "balance",
            0.0,
            |c| c.balanced.pieces[0].added[1] = size(0.1),
            [0.16, 2e-3, 0.0, 1.16],
        );
        is_first_slope(
            "tension",
            0.0,
            |c| c.balanced.pieces[0].drawn = size(0.1),
            [0.16, 2e-3, 0.1, 1.16],
        );
        is_first_slope(
            "closing",
            0.0,
            |c| c.fields.deflection.pieces[0].bounds[1] = size(0.4),
            [0.0, 2e-3, 0.1, 1.0],
        );
        let pulled = |c: &mut Claim| {
            c.fields.pressures[0].depth = size(0.2);
            c.balanced.factors[1] = Wide::of(-0.25);
        };
        is_first_slope("pressure", 0.0, pulled, [0.0, 2e-3, 0.0, 1.25 * 1.2]);
        is_first_slope(
            "residual",
            0.0,
            |c| c.fields.residual.pieces[0].constant = Wide::of(-0.1),
            [0.0, 2e-3, 0.0, 1.1],
        );
        is_first_slope(
            "rest of the residual",
            0.0,
            |c| c.fields.residual.pieces[0].rest = size(0.1),
            [0.16, 2e-3, 0.0, 1.0 + 0.1 + 0.16],
        );
    }

    /// In contact, (14b) of docs/proof.md bounds 1 + α times the pressure error, with α = μ/(S + P) ≥ 0.2. So the bound
    /// is divided by 1.2. On an open piece, it is not divided.
    #[test]
    fn the_pressure_needs_the_slope_and_the_slope_the_pressure() {
        for touches in [true, false] {
            with_claim(0.0, touches, |claim| {
                (claim.bounds.settlement, claim.bounds.slope) = (Size::of(0.4), Size::of(0.2));
                let found = claim.pointwise().varying_pressure(0, &claim.bounds);
                same("pressure", found, 0.3 / if touches { 1.2 } else { 1.0 });
                let mut lowered = [PieceBounds { pressure: Size::INFINITE, ..claim.bounds }];
                claim.pointwise().lower_pressures(&mut lowered);
                assert_eq!(lowered[0].pressure, found);
                lowered[0].pressure = Size::of(0.1);
                claim.pointwise().lower_pressures(&mut lowered);
                assert_eq!(lowered[0].pressure, Size::of(0.1));
            });
        }
        with_claim(0.0, false, |claim| {
            claim.bounds.balanced_moment = Size::of(1e-3);
            let pressure = claim.pointwise().open_pressure(0).value();
            same("slope", claim.first_slope(), 1.6 * first_force([2e-3, 0.0, pressure]));
        });
    }
}
