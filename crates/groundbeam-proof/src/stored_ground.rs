//! Open ground whose k or μ varies: the stored settlement, and its residual in the ground's equation.

use crate::frame::Span;
use crate::ground::{Layer, Surface};
use crate::polynomial::{Line, Polynomial};
use crate::scalar::Scalar;
use crate::size::Size;
use std::ops::Range;

impl<S: Scalar> Span<S> {
    /// Returns the residual ρ = ku − (μu′)′ − q if the settlement u is inserted in the equation of the ground out of
    /// contact under the load q.
    pub fn missed_by(&self, settlement: &Polynomial<S>) -> Polynomial<S> {
        let flux = self.shear.times(self.derivative(settlement));
        let missed = self.spring.times(*settlement) - &self.derivative(&flux);
        match &self.ground_load {
            None => missed,
            Some(load) => missed - load,
        }
    }
}

impl<S: Scalar> Layer<'_, S> {
    /// Sets the settlement on pieces where k or μ varies: the stored settlement plus a linear function that corrects
    /// the values at the nodes. The residuals of this settlement increase Ḡ in (11) of `docs/proof.md` by (4a).
    pub(crate) fn as_stored(&self, pieces: Range<usize>, surface: &mut Surface<S>) {
        let mut missed = Size::ZERO;
        for i in pieces.clone() {
            let ends = [i, i + 1].map(|node| self.stored_at(node, surface));
            surface.pieces[i].open = Some(ends);
            let span = &self.frame.spans[i];
            if span.has_even_ground() {
                surface.pieces[i].flux = self.links[i - self.first].fluxes(ends);
                continue;
            }
            let along = with_ends(span, ends);
            let flux = span.shear.times(span.derivative(&along));
            surface.pieces[i].flux = span.t.map(|t| flux.value(t));
            let rest = span.missed_by(&along).size(span.tau);
            missed += (span.length() * rest.square()).over(span.spring.low());
            surface.pieces[i].missed = rest;
            surface.pieces[i].along = Some(Box::new(along));
        }
        surface.unclaimed += missed.root();
        for node in pieces.start..=pieces.end {
            if !surface.touches[node] {
                let jump = self.jump_at(node, surface);
                surface.unclaimed += Size::of(jump.size()) * surface.flexibility_at(node);
            }
        }
    }

    /// Returns the settlement of the ground at a node: the deflection minus the initial gap at a node in contact,
    /// otherwise the stored settlement of the piece on the left or else on the right.
    pub(crate) fn stored_at(&self, node: usize, surface: &Surface<S>) -> S {
        if surface.touches[node] {
            return self.held(node);
        }
        let spans = &self.frame.spans;
        let left = (node > self.first).then(|| spans[node - 1].stored).flatten();
        let right = (node < self.end()).then(|| spans[node].stored).flatten();
        left.map(|ends| ends[1]).or(right.map(|ends| ends[0])).unwrap_or_else(S::zero)
    }
}

/// Adds a linear function to the stored settlement of a piece, so that the sum has the given values at the ends.
fn with_ends<S: Scalar>(span: &Span<S>, ends: [S; 2]) -> Polynomial<S> {
    let stored = span.settlement.as_deref().copied().unwrap_or_else(Polynomial::zero);
    let missed = [0, 1].map(|side| ends[side] - stored.value(span.t[side]));
    let slope = (missed[1] - missed[0]).div(span.t[1] - span.t[0]);
    stored + &Line::from_coefficients([missed[0] - slope * span.t[0], slope])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::given_claim::with_fields;
    use crate::wide::Wide;
    use serde_json::json;

    /// The shear layer begins at the second piece and is out of contact. On its pieces with constant k and μ, the
    /// settlement u at both ends determines the flux μu′.
    #[test]
    fn a_piece_of_constant_ground_has_the_flux_of_its_ends() {
        let model = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\nmu = 0\n\
                     [[foundation.segment]]\nfrom = 0.25\nto = 0.5\nk = 1\nmu = 1\n\
                     [[foundation.segment]]\nfrom = 0.5\nto = 0.75\nk = 1\nmu = [1, 2]\n\
                     [[foundation.segment]]\nfrom = 0.75\nto = 1\nk = 4\nmu = 3\n";
        let ends = [[0.0, 0.0], [0.5, 0.75], [0.75, 0.25], [0.25, 0.375]];
        let piece = |i: usize| {
            let from = 0.25 * i as f64;
            let mut piece = json!({"x": [from, from + 0.25], "half": 0.125, "touches": false, "deflection": [-1]});
            if i > 0 {
                let [left, right] = ends[i];
                piece["settlement"] = json!([0.5 * (left + right), 0.5 * (right - left)]);
                piece["open"] = json!(ends[i]);
            }
            piece
        };
        let pieces: Vec<_> = (0..4).map(piece).collect();
        with_fields(model, &json!({"pieces": pieces}), |fields| {
            for (i, k, mu) in [(1, 1.0, 1.0), (3, 4.0, 3.0)] {
                let (stiffness, z) = (f64::sqrt(k * mu), 0.25 * f64::sqrt(k / mu));
                let [left, right] = ends[i];
                let exact = [right - left * z.cosh(), right * z.cosh() - left]
                    .map(|flux: f64| stiffness * flux / z.sinh());
                for (flux, exact) in fields.surface.pieces[i].flux.iter().zip(exact) {
                    assert!((flux.middle() - exact).abs() < 1e-12, "{i}: {flux:?} {exact}");
                }
            }
            // On the third piece, the stored settlement u is linear and μ increases from 1 to 2. So the flux μu′
            // doubles from the left end to the right end.
            let flux = fields.surface.pieces[2].flux.map(Wide::middle);
            assert!((flux[0] + 2.0).abs() < 1e-12 && (flux[1] + 4.0).abs() < 1e-12, "{flux:?}");
            let span = &fields.frame.spans[2];
            for ends in [[0.75, 0.25], [1.0, 0.25], [0.5, 0.5], [-1.0, 2.0]] {
                let along = with_ends(span, ends.map(Wide::of));
                for (t, end) in span.t.iter().zip(ends) {
                    assert!((along.value(*t).middle() - end).abs() < 1e-14, "{ends:?}");
                }
            }
        });
    }
}
