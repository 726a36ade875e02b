//! Bounds the error of the shear force next to an edge of contact in closed form, on a beam with shear deformation.
//!
//! The claimed and the exact edge of contact are at most the length θ apart. On this length, only one of the two
//! solutions is in contact. The difference of their contact forces there depends on the error e_s of the slope at
//! the edge. This error depends on the error e_V of the shear force V, and e_V depends on the error bound ε_T of
//! the transverse force T = V + Pw′. Section 6 of docs/proof.md derives the bounds
//!
//! ```text
//! |∫(p̄ − p*)| ≤ (1 + γ)[(Φ₀ + μe_s)/(1 + α) + ε_pθ],   e_s ≤ ε_φ + (e_V + |η|)/S,   e_V(1 + P/S) ≤ ε_T + rest.
//! ```
//!
//! Here p̄ is the redistributed claimed pressure, p* the exact pressure, and α = μ/(S + P) with the stiffness μ of
//! the shear layer, the shear stiffness S of the beam and the axial tension P. ε_p and ε_φ are the error bounds of
//! the pressure and of the rotation φ. γ is the largest relative change of the pressure by the redistribution, and
//! η = S(w′ − φ) − V is the residual of the shear force. Φ₀ bounds the jump of the shear-layer force μu′ at the
//! edge without the effect of the slope error, and `rest` bounds the other errors of V.
//!
//! Together these bounds have the form ε_T ≤ A + χε_T with χ = (1 + γ)μ/(S + P + μ). A contains the terms without
//! ε_T. If χ < 1, then ε_T ≤ A/(1 − χ).

use crate::contact_set::EdgeShift;
use crate::pointwise::{PieceBounds, Pointwise};
use crate::scalar::Scalar;
use crate::size::Size;

/// Contact edges at the left and right end of a piece. For each edge: the length on which only one of the claimed and
/// exact solutions is in contact, and the bound Φ₀ of the jump of the shear-layer force.
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
    /// Returns the error bound of the transverse force beside contact edges, by the formula at the top of this file.
    /// `steady` is the part without the edges. The bound is infinite if an edge is uncertain by about half of the
    /// piece.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::given_claim::{balanced, with_fields};
    use crate::wide::Wide;
    use serde_json::json;

    /// Checks the contact edges at the ends of each piece: first for edges at the nodes 1, 2 and 3, then for edges at
    /// both ends of the beam.
    #[test]
    fn an_edge_lies_at_the_ends_of_its_two_pieces() {
        let edge = |node: usize, side: usize, lengths: [f64; 2]| {
            let [outside, inside] = lengths.map(Size::of);
            let beyond = lengths.map(|length| Size::of(10.0 * length));
            EdgeShift { node, side, outside, inside, beyond }
        };
        let place = |length: f64| Some([length, 10.0 * length].map(Size::of));
        let edges = [edge(1, 0, [1.0, 2.0]), edge(2, 1, [3.0, 4.0]), edge(3, 0, [0.0, 5.0])];
        let found = edges_of_pieces(&edges, 5);
        let expected =
            [[None, place(1.0)], [place(2.0), place(4.0)], [place(3.0), None], [place(5.0), None]];
        assert_eq!(found[..4], expected);
        assert_eq!(found[4], [None; 2]);
        let ends = [edge(0, 0, [1.0, 2.0]), edge(2, 1, [3.0, 4.0])];
        assert_eq!(edges_of_pieces(&ends, 2), [[place(2.0), None], [None, place(4.0)]]);
    }

    /// Compares the error bound of the transverse force with A/(1 − χ) at the top of this file, where χ = (1 + γ)/3.
    /// The relative change γ of the pressure is 1/4 in contact.
    #[test]
    fn the_force_beside_an_edge_is_that_of_the_closed_form() {
        let model = "[beam]\nlength = 1.5\nEI = 1\nshear_stiffness = 3\naxial_force = 1\n\
                     [foundation]\nk = 1\nmu = 2\n[[load]]\npoint = 1\nat = 0\n";
        for touches in [true, false] {
            let piece = json!({"x": [0, 1.5], "half": 0.75, "touches": touches, "deflection": [1], "rotation": [0]});
            with_fields(model, &json!({"pieces": [piece]}), |fields| {
                fields.residual.pieces[0].misfit[0] = Size::of(0.3);
                let mut balanced = balanced(1);
                balanced.factors[1] = Wide::of(0.25);
                let pointwise = Pointwise { fields, balanced: &balanced, energy: Size::ZERO };
                let [rotation, pressure] = [0.1, 0.2].map(Size::of);
                let bounds = PieceBounds { rotation, pressure, ..PieceBounds::EXACT };
                let found = |edges: [Option<[f64; 2]>; 2]| {
                    let edges = edges.map(|edge| edge.map(|edge| edge.map(Size::of)));
                    let steady = [0.4, 0.8].map(Size::of);
                    pointwise.beside_edges(0, &bounds, &edges, steady).value()
                };
                let exact = |[theta, force]: [f64; 2]| {
                    let slope = 0.1 + (0.8 / (1.0 + 1.0 / 3.0) + 0.3) / 3.0;
                    let kept = if touches { 1.25 } else { 1.0 };
                    let edge = kept * ((force + 2.0 * slope) / 1.5 + 0.2 * theta);
                    (0.4 + edge) / (1.0 - kept * 2.0 / (3.0 + 1.0 + 2.0))
                };
                let [small, large] = [[0.25, 0.05], [0.125, 0.5]];
                for (edges, exact) in [
                    ([Some(small), None], exact(small)),
                    ([None, Some(large)], exact(large)),
                    ([Some(small), Some(large)], exact(large)),
                    ([Some(large), Some(small)], exact(large)),
                    ([Some([0.73, 0.0]), None], exact([0.73, 0.0])),
                    ([Some([0.74, 0.0]), None], f64::INFINITY),
                ] {
                    let found = found(edges);
                    let near = (found / exact - 1.0).abs() < 1e-12;
                    assert!(found >= exact && near || found == exact, "{edges:?}: {found} {exact}");
                }
            });
        }
    }
}
