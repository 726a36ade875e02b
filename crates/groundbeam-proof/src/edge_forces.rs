//! Bound of the error of the shear force next to an edge of contact, on a beam with shear deformation, in
//! closed form instead of an iteration with the slope.
//!
//! Where only one of the two solutions is in contact, the difference of their forces follows from the error e_θ of the
//! slope at the edge. With g = μ/(S + P), and Φ₀ the part of the flux jump that does not depend on the slope,
//!
//! ```text
//! |∫(p̄ − p*)| ≤ (1 + γ)[(Φ₀ + μe_θ)/(1 + g) + ε_pθ],   e_θ ≤ ε_φ + (e_V + |η|)/S,   e_V(1 + P/S) ≤ ε_T + rest.
//! ```
//!
//! So ε_T ≤ A + χε_T with χ = (1 + γ)μ/(S + P + μ), and ε_T ≤ A/(1 − χ) if χ < 1.

use crate::contact_set::EdgeShift;
use crate::pointwise::{PieceBounds, Pointwise};
use crate::scalar::Scalar;
use crate::size::Size;

/// For the edges at the left and right end of one piece: the length on which only one solution is in contact, and Φ₀.
pub(crate) type EdgesOfPiece = [Option<[Size; 2]>; 2];

/// The edges at the ends of every piece.
pub(crate) fn edges_of_pieces(edges: &[EdgeShift], count: usize) -> Vec<EdgesOfPiece> {
    let mut all = vec![[None; 2]; count];
    for edge in edges {
        let (outer, inner) = match edge.side {
            0 => (edge.node.checked_sub(1), Some(edge.node)),
            _ => (Some(edge.node), edge.node.checked_sub(1)),
        };
        // The left end of a region is the right end of the piece outside it, and vice versa.
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
    /// ε_T on a piece with edges at its ends. `steady` bounds all other contributions to ε_T on half of the
    /// piece, and `rest` those to ε_V(1 + P/S). Each edge lies within one half.
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
