//! Bounds the error of the shear force next to an edge of contact in closed form, on a beam with shear deformation.
//!
//! Within the distance θ of the edge, only the claimed solution or only the exact solution is in contact. The
//! difference of their contact forces depends on the error e_θ of the slope at the edge. This error depends on the
//! error e_V of the shear force, and e_V depends on the error bound ε_T of the transverse force T. Section 6 of
//! docs/proof.md derives the bounds
//!
//! ```text
//! |∫(p̄ − p*)| ≤ (1 + γ)[(Φ₀ + μe_θ)/(1 + g) + ε_pθ],   e_θ ≤ ε_φ + (e_V + |η|)/S,   e_V(1 + P/S) ≤ ε_T + rest.
//! ```
//!
//! Here p̄ is the balanced pressure and p* the exact pressure, and g = μ/(S + P). ε_p and ε_φ are the error bounds
//! of the pressure and of the rotation φ. γ is the factor of the redistributed pressures, and η = S(w′ − φ) − V is
//! the residual of the shear force. Φ₀ bounds the jump of the flux at the edge without the effect of the error of
//! the slope.
//!
//! Together these bounds have the form ε_T ≤ A + χε_T with χ = (1 + γ)μ/(S + P + μ). A contains the terms without
//! ε_T. If χ < 1, then ε_T ≤ A/(1 − χ).

use crate::contact_set::EdgeShift;
use crate::pointwise::{PieceBounds, Pointwise};
use crate::scalar::Scalar;
use crate::size::Size;

/// Edges of contact at the left and right end of one piece. For each edge: the length on which only the claimed or
/// only the exact solution is in contact, and the bound Φ₀ of the jump of the flux.
pub(crate) type EdgesOfPiece = [Option<[Size; 2]>; 2];

/// Assigns the edges of contact to the ends of every piece.
pub(crate) fn edges_of_pieces(edges: &[EdgeShift], count: usize) -> Vec<EdgesOfPiece> {
    let mut all = vec![[None; 2]; count];
    for edge in edges {
        let (outer, inner) = match edge.side {
            0 => (edge.node.checked_sub(1), Some(edge.node)),
            _ => (Some(edge.node), edge.node.checked_sub(1)),
        };
        // The left end of a contact region is the right end of the piece outside the region, and vice versa.
        let places = [(outer, 1 - edge.side, edge.outside), (inner, edge.side, edge.inside)];
        for ((piece, end, theta), force) in places.into_iter().zip(edge.beyond) {
            if let Some(place) = piece.filter(|piece| *piece < count && theta > Size::ZERO) {
                all[place][end] = Some([theta, force]);
            }
        }
    }
    all
}

impl<S: Scalar> Pointwise<'_, S> {
    /// Returns ε_T, the error bound of the transverse force T, on a piece with edges of contact at its ends.
    /// `steady` bounds the contributions to ε_T that are not due to these edges. `rest` is the term in ε_V(1 +
    /// P/S) ≤ ε_T + `rest`, where ε_V is the error bound of the shear force V. Each edge must lie within one half
    /// of the piece, otherwise the result is infinite.
    pub(crate) fn beside_edges(
        &self,
        i: usize,
        bounds: &PieceBounds,
        edges: &EdgesOfPiece,
        [steady, rest]: [Size; 2],
    ) -> Size {
        let (frame, span) = (self.fields.frame, &self.fields.frame.spans[i]);
        let stiffness = span.stiffness.as_ref().and_then(|stiffness| stiffness.even());
        let (Some(stiffness), Some(layer)) = (stiffness, span.shear.even()) else {
            return Size::INFINITE;
        };
        let whole = stiffness + frame.axial_force().unwrap_or_else(S::zero);
        if !(whole.low() > 0.0) {
            return Size::INFINITE;
        }
        let misfit = self.fields.residual.pieces[i].misfit[0];
        let slid = Size::of(stiffness.div(whole).high()) * rest + misfit;
        let slope = bounds.rotation + slid.over(stiffness.low());
        let kept = match span.touches {
            true => Size::of(1.0) + self.balanced.factor(i),
            false => Size::of(1.0),
        };
        let (stiffened, layer_size) = ((S::one() + layer.div(whole)).low(), Size::of(layer.high()));
        let mut most = Size::ZERO;
        for [theta, force] in edges.iter().flatten() {
            if !(theta.value() < 0.49 * span.h.low()) {
                return Size::INFINITE;
            }
            let missed = (*force + layer_size * slope).over(stiffened);
            most = most.worst(kept * (missed + bounds.pressure * *theta));
        }
        let share = kept * Size::of(layer.div(whole + layer).high());
        (steady + most).over((1.0 - share.value()).next_down())
    }
}
