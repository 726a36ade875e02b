//! Pointwise error bounds of settlement, bending moment, deflection and slope on the whole beam.

use crate::balance::Balanced;
use crate::fields::Fields;
use crate::scalar::Scalar;
use crate::size::Size;
use std::ops::Range;

/// Error bounds of the fields on one piece, in the units of the proof.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PieceBounds {
    pub deflection: Size,
    pub slope: Size,
    pub rotation: Size,
    /// Error bound of the balanced moment m, which is in exact equilibrium with the loads.
    pub balanced_moment: Size,
    pub moment: Size,
    pub shear_force: Size,
    pub settlement: Size,
    /// Error bound of the pressure where both the claimed and the exact solution are in contact.
    pub pressure: Size,
}

impl PieceBounds {
    /// No error.
    pub const EXACT: PieceBounds = PieceBounds {
        deflection: Size::ZERO,
        slope: Size::ZERO,
        rotation: Size::ZERO,
        balanced_moment: Size::ZERO,
        moment: Size::ZERO,
        shear_force: Size::ZERO,
        settlement: Size::ZERO,
        pressure: Size::ZERO,
    };

    /// Nothing proven.
    const NOTHING: PieceBounds = PieceBounds {
        deflection: Size::INFINITE,
        slope: Size::INFINITE,
        rotation: Size::INFINITE,
        balanced_moment: Size::INFINITE,
        moment: Size::INFINITE,
        shear_force: Size::INFINITE,
        settlement: Size::INFINITE,
        pressure: Size::INFINITE,
    };
}

/// Input of the bounds.
pub(crate) struct Pointwise<'a, S> {
    pub fields: &'a Fields<'a, S>,
    pub balanced: &'a Balanced<S>,
    pub energy: Size,
}

impl<S: Scalar> Pointwise<'_, S> {
    /// Computes the error bounds on all pieces, except the bounds of the shear force.
    pub fn bounds(&self) -> Vec<PieceBounds> {
        let mut bounds = vec![PieceBounds::NOTHING; self.fields.frame.spans.len()];
        self.moments(&mut bounds);
        let parts = self.parts();
        for (part, error) in parts.iter().zip(self.deflections(&parts)) {
            self.on_part(part, error, &mut bounds);
        }
        for (i, piece) in bounds.iter_mut().enumerate() {
            piece.settlement = self.settlement(i, piece.deflection);
            piece.pressure = self.pressure(i, piece);
        }
        bounds
    }

    pub(crate) fn s2(&self) -> Size {
        (2.0 * self.energy).root()
    }

    /// Bound of the strain energy of the error in beam and springs: E without compression, E/σ under compression. 1 − σ
    /// bounds the ratio of the compression to the critical compression.
    pub(crate) fn beam_energy(&self) -> Size {
        match &self.fields.frame.compression {
            None => self.energy,
            Some(compression) => self.energy.over(compression.margin),
        }
    }

    /// Error bound of the settlement on one piece. See *Settlement* in section 4 of `docs/proof.md`.
    fn settlement(&self, i: usize, deflection: Size) -> Size {
        let fields = self.fields;
        let (span, raised) = (&fields.frame.spans[i], fields.clearance.raised[i]);
        if span.layered {
            let energy = self.s2() * fields.surface.pieces[i].flexibility;
            return energy
                + if span.touches { fields.deflection.pieces[i].bounds[0] } else { raised };
        }
        // On Winkler ground the settlement is max(w − g₀, q/k), so its error is at most that of w plus a correction.
        let sunk = fields.pressures[i].depth.over(span.spring.low());
        deflection + if span.touches { sunk } else { raised }
    }

    /// Bounds the error of the bending moment on each piece. See *Moment* in section 4 of `docs/proof.md`.
    fn moments(&self, bounds: &mut [PieceBounds]) {
        let frame = self.fields.frame;
        let mut stiffness = vec![Size::INFINITE; frame.spans.len()];
        for pair in self.obstacles().windows(2) {
            let short = self.short_kink(pair[0]..pair[1]);
            stiffness[pair[0]..pair[1]].fill(short);
        }
        for side in [0, 1] {
            self.long_kinks(side, &mut stiffness);
        }
        let factor = self.test_factor();
        for (i, (piece, stiffness)) in bounds.iter_mut().zip(stiffness).enumerate() {
            let [a, b] = self.balanced.pieces[i].moments.map(|moment| Size::of(moment.size()));
            let residual = &self.fields.residual.pieces[i];
            let load = Size::of(residual.constant.size()) + residual.rest;
            let bent = frame.spans[i].length().square() * load;
            let delta = a.worst(b) + bent.over(8.0) + self.balanced.pieces[i].added[0];
            piece.balanced_moment = factor * stiffness.root();
            piece.moment = piece.balanced_moment + delta;
        }
    }

    /// The nodes at which test functions must vanish: ends of the beam and rigid supports.
    pub(crate) fn obstacles(&self) -> Vec<usize> {
        let nodes = &self.fields.frame.nodes;
        let stops = |i: &usize| *i == 0 || *i + 1 == nodes.len() || nodes[*i].rigid.is_some();
        (0..nodes.len()).filter(stops).collect()
    }

    /// Error bound of the pressure where the claimed and the exact solution are both in contact. See section 5 of
    /// `docs/proof.md`. Out of contact, it bounds the error of (μC′)′ with the clearance C.
    pub(crate) fn pressure(&self, i: usize, bounds: &PieceBounds) -> Size {
        let span = &self.fields.frame.spans[i];
        let bent = bounds.moment.over(span.bending.low());
        let settled = Size::of(span.spring.high()) * bounds.settlement;
        let Some(stiffness) = span.stiffness.as_ref().filter(|_| span.layered) else {
            let turned = match span.shear.along() {
                Some(_) => span.steepness(&span.shear) * bounds.slope,
                None => Size::ZERO,
            };
            return settled + turned + Size::of(span.shear.size()) * bent;
        };
        let (Some(stiffness), Some(shear)) = (stiffness.even(), span.shear.even()) else {
            return self.varying_pressure(i, bounds);
        };
        let axial = self.fields.frame.axial_force().unwrap_or_else(S::zero);
        let residual = &self.fields.residual.pieces[i];
        let load = [Size::of(residual.constant.size()), residual.rest, residual.misfit[1]];
        let load = load.into_iter().sum();
        sheared_pressure([stiffness, axial, shear], [settled, bent, load], span.touches)
    }

    /// Sets the error bounds of deflection and rotation on a part of the beam between hinges. `error` bounds the error
    /// of the admissible deflection. See *Slope* in section 4 of `docs/proof.md`.
    fn on_part(&self, part: &Range<usize>, error: Size, bounds: &mut [PieceBounds]) {
        let frame = self.fields.frame;
        let closed = &self.fields.deflection.pieces;
        let [s, sheared] = self.flexure(part);
        let mut most = [Size::ZERO; 3];
        for i in part.clone() {
            let curvature =
                bounds[i].moment.over(frame.spans[i].bending.low()) + closed[i].bounds[2];
            let here = [closed[i].bounds[0], closed[i].bounds[1], curvature];
            for (most, here) in most.iter_mut().zip(here) {
                *most = most.worst(here);
            }
        }
        let mut h = (frame.nodes[part.end].x - frame.nodes[part.start].x).low();
        let mut slope = Size::INFINITE;
        for _ in 0..60 {
            let long = Size::of(h);
            let bent = (0.5 * (long * most[2])).least(s * long.over(3.0).root());
            let slid = sheared * Size::of(1.0).over(h).root();
            slope = slope.least((2.0 * error).over(h) + slid + bent);
            h *= 0.7;
        }
        for i in part.clone() {
            bounds[i].deflection = error + most[0];
            bounds[i].rotation = slope + most[1];
            if frame.spans[i].stiffness.is_none() {
                bounds[i].slope = bounds[i].rotation;
            }
        }
    }
}

/// Error bound of the pressure of a Timoshenko beam in contact by (14a) of `docs/proof.md`. Out of contact, it bounds
/// the error of μC″. `settled`, `bent` and `load` bound the errors of ku and φ′ and the sum |r| + |η_S′|.
fn sheared_pressure<S: Scalar>(
    [stiffness, axial, shear]: [S; 3],
    [settled, bent, load]: [Size; 3],
    touches: bool,
) -> Size {
    let whole = stiffness + axial;
    if !(whole.low() > 0.0) {
        return Size::INFINITE;
    }
    let factor = Size::of((shear * stiffness.div(whole)).high());
    let error = settled + factor * (bent + load.over(stiffness.low()));
    if touches { error.over((S::one() + shear.div(whole)).low()) } else { error }
}

#[cfg(test)]
mod tests {
    use super::sheared_pressure;
    use crate::ball::Ball;
    use crate::random::numbers;
    use crate::scalar::Scalar;
    use crate::size::Size;

    /// Checks that the bound holds for random errors and residuals, and that one choice of their signs attains it.
    #[test]
    fn the_pressure_bound_of_a_timoshenko_beam_is_sharp() {
        let mut random = numbers();
        for _ in 0..2000 {
            let [stiffness, shear] = [0, 1].map(|_| 10.0_f64.powf(3.0 * random()));
            let axial = stiffness * (2.0 * random()).max(-0.9);
            let [settled, turned, load] = [0, 1, 2].map(|_| random());
            for touches in [true, false] {
                for signs in [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0]] {
                    let [u, bent, r] = [settled * signs[0], turned * signs[1], load * signs[2]];
                    // The errors of deflection w, rotation φ and pressure p satisfy (S + P)w″ = Sφ′ + p + r, with the
                    // residual r.
                    let whole = stiffness + axial;
                    let curved = match touches {
                        true => (stiffness * bent + u + r) / (whole + shear),
                        false => (stiffness * bent + r) / whole,
                    };
                    // The error of p in contact, and that of μC″ out of contact, with the clearance C.
                    let error = u - shear * curved;
                    let bound = sheared_pressure(
                        [stiffness, axial, shear].map(Ball::of),
                        [u, bent, r].map(|x| Size::of(x.abs())),
                        touches,
                    );
                    let bound = bound.value();
                    assert!(error.abs() <= bound * (1.0 + 1e-9), "{error} {bound}");
                    let aligned = u >= 0.0 && bent <= 0.0 && r <= 0.0;
                    assert!(!aligned || error.abs() >= bound * (1.0 - 1e-9), "{error} {bound}");
                }
            }
        }
    }
}
