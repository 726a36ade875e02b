//! The pressure and a first bound of the slope of a beam with shear deformation on a shear layer where S or μ
//! varies.
//!
//! With a = μ/(S + P) the slope w′ = (Sφ + T + η)/(S + P) and T′ = p − f + r give, where both answers touch,
//!
//! ```text
//! (1 + a)(p − p*) = k(u − u*) − a[S′(φ − φ*) + S(φ′ − φ*′) + r + η′] − a′(S + P)(w′ − w*′).
//! ```
//!
//! So the bound of the pressure needs that of the slope, this needs that of the shear force, and this needs
//! that of the pressure. On a length h of one piece ε_T ≤ A/h + B + ½h(p₀ + C + Dε_T), with C + Dε_T the
//! right side above and p₀ the pressure where only one of the two solutions is in contact. For h < 2/D
//!
//! ```text
//! ε_T ≤ (A/h + B + ½h(p₀ + C))/(1 − ½hD).
//! ```

use crate::coefficient::Coefficient;
use crate::frame::Span;
use crate::pointwise::{PieceBounds, Pointwise};
use crate::scalar::Scalar;
use crate::size::Size;
use crate::test_functions::least_of_halves;

/// S of a piece with shear deformation on a shear layer where S or μ varies.
fn varying<S>(span: &Span<S>) -> Option<&Coefficient<S>>
where
    S: Scalar,
{
    let stiffness = span.stiffness.as_ref().filter(|_| span.layered)?;
    (stiffness.even().is_none() || span.shear.even().is_none()).then_some(stiffness)
}

impl<S: Scalar> Pointwise<'_, S> {
    /// |p − p*| where both are in contact. On open pieces it bounds the error of (μC′)′, without the divisor 1 + a.
    pub(crate) fn varying_pressure(&self, i: usize, bounds: &PieceBounds) -> Size {
        let span = &self.fields.frame.spans[i];
        let Some(stiffness) = varying(span) else { return Size::INFINITE };
        let [fixed, turned] = self.parts_of_pressure(i, stiffness, bounds);
        let error = fixed + turned * bounds.slope;
        let axial = self.fields.frame.axial_force().unwrap_or_else(S::zero);
        let whole = (S::of(stiffness.high()) + axial).high();
        match span.touches && whole > 0.0 {
            true => error.over((S::one() + S::of(span.shear.low()).div(S::of(whole))).low()),
            false => error,
        }
    }

    /// The two parts of the bound of (1 + a)(p − p*): kε_u + a[|S′|ε_φ + Sε_κ + |r| + |η′|], and the factor
    /// |a′|(S + P) = |μ′ − aS′| of the error of the slope.
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

    /// Bounds of the slope and of the pressure on pieces with shear deformation where S or μ varies. They use
    /// only the change of moment within the piece.
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
        // ε_θ has a part that does not depend on ε_T, `resting`, and the part ε_T/(S + P).
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

    /// Lowers the bounds of the pressure that need the slope.
    pub(crate) fn lower_pressures(&self, bounds: &mut [PieceBounds]) {
        for (i, piece) in bounds.iter_mut().enumerate() {
            if varying(&self.fields.frame.spans[i]).is_some() {
                piece.pressure = piece.pressure.least(self.pressure(i, piece));
            }
        }
    }
}
