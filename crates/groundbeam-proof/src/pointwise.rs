//! Bounds at every point of the beam: of settlement, bending moment, deflection and slope.
//!
//! All follow from the parts of E, each of which is at most E: with s₂ = √(2E), e = w̄ − w*, d = ū − u*,
//!
//! ```text
//! ‖d‖_b ≤ s₂,   (∫EI e″²)^½ ≤ s₂,   (∫P e′²)^½ ≤ s₂,   √κ|e| ≤ s₂ at springs,   ⟨p̄, C*⟩ ≤ E.
//! ```

use crate::balance::Balanced;
use crate::fields::Fields;
use crate::scalar::Scalar;
use crate::size::Size;
use std::ops::Range;

/// Bounds of the error at every point of the beam: |claimed − exact| is at most this. Infinite: nothing is proven.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Of w \[m\].
    pub deflection: f64,
    /// Of w′ \[rad\], on both sides of hinges.
    pub slope: f64,
    /// Of M \[N·m\].
    pub moment: f64,
    /// Of u \[m\].
    pub settlement: f64,
}

/// The bounds on one piece, in the units of the proof.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PieceBounds {
    pub deflection: Size,
    pub slope: Size,
    pub moment: Size,
    pub settlement: Size,
}

/// Everything that the bounds are computed from.
pub(crate) struct Pointwise<'a, S> {
    pub fields: &'a Fields<'a, S>,
    pub balanced: &'a Balanced<S>,
    pub energy: Size,
}

impl<S: Scalar> Pointwise<'_, S> {
    /// The bounds on all pieces.
    pub fn bounds(&self) -> Vec<PieceBounds> {
        let moments = self.moments();
        let mut bounds: Vec<PieceBounds> = moments
            .iter()
            .map(|moment| PieceBounds {
                deflection: Size::INFINITE,
                slope: Size::INFINITE,
                moment: *moment,
                settlement: Size::INFINITE,
            })
            .collect();
        let parts = self.parts();
        for (part, error) in parts.iter().zip(self.deflections(&parts)) {
            self.on_part(part, error, &moments, &mut bounds);
        }
        for (i, piece) in bounds.iter_mut().enumerate() {
            piece.settlement = self.settlement(i, piece.deflection);
        }
        bounds
    }

    pub(crate) fn s2(&self) -> Size {
        (2.0 * self.energy).root()
    }

    /// |u − u*| in a layer: d(x) = b(d, g(x, ·)) ≤ s₂√g, and what closing and lifting add. On separate springs
    /// u* = max(w* − g₀, 0).
    fn settlement(&self, i: usize, deflection: Size) -> Size {
        let fields = self.fields;
        let (span, raised) = (&fields.frame.spans[i], fields.clearance.raised[i]);
        if span.layered {
            let energy = self.s2() * fields.surface.flexibility[i];
            return energy
                + if span.touches { fields.deflection.pieces[i].bounds[0] } else { raised };
        }
        let sunk = fields.pressures[i].depth.over(span.spring.low());
        deflection + if span.touches { sunk } else { raised }
    }

    /// |M − M*| on each piece: s₂ K(z) + |δ| with
    ///
    /// ```text
    /// K² = ∫EI z″² + ∫(P + μ)z′² + ∫kz² + K₀z(0)² + K_lz(l)² + Σκz² + Σκ_θz′²
    /// ```
    ///
    /// for any z with a unit kink at x, z = 0 at rigid supports and z′ = 0 at clamps.
    fn moments(&self) -> Vec<Size> {
        let frame = self.fields.frame;
        let last = frame.spans.len();
        let stops =
            |node: &usize| *node == 0 || *node == last || frame.nodes[*node].rigid.is_some();
        let stops: Vec<usize> = (0..=last).filter(stops).collect();
        let mut stiffness = vec![Size::INFINITE; last];
        for pair in stops.windows(2) {
            let short = self.short_kink(pair[0]..pair[1]);
            stiffness[pair[0]..pair[1]].fill(short);
        }
        for side in [0, 1] {
            self.long_kinks(side, &mut stiffness);
        }
        let moment = |(i, stiffness): (usize, &Size)| {
            let [a, b] = self.balanced.moments[i].map(|moment| Size::of(moment.size()));
            let residual = &self.fields.residual.pieces[i];
            let load = Size::of(residual.constant.size()) + residual.rest;
            let bent = frame.spans[i].length().square() * load;
            let delta = a.worst(b) + bent.over(8.0) + self.balanced.added[i][0];
            self.s2() * stiffness.root() + delta
        };
        stiffness.iter().enumerate().map(moment).collect()
    }

    /// ε_w = sup|e| + max|c|, and ε_φ = min_h {2 sup|e|/h + s_γ/h^½ + min(½h max(ε_κ + |c″|), s(h/3)^½)} + max|c′| with
    /// ε_κ = ε_M/EI. Where the beam does not shear ε_θ = ε_φ.
    fn on_part(
        &self,
        part: &Range<usize>,
        error: Size,
        moments: &[Size],
        bounds: &mut [PieceBounds],
    ) {
        let frame = self.fields.frame;
        let closed = &self.fields.deflection.pieces;
        let [s, sheared] = self.flexure(part);
        let mut most = [Size::ZERO; 3];
        for i in part.clone() {
            let curvature = moments[i].over(frame.spans[i].bending.low()) + closed[i].bounds[2];
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
            if frame.spans[i].stiffness.is_none() {
                bounds[i].slope = slope + most[1];
            }
        }
    }
}
