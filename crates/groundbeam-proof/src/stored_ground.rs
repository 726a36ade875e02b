//! Open ground whose k or μ varies: the stored settlement, and its residual in the ground's equation.

use crate::frame::Span;
use crate::ground::{Layer, Surface};
use crate::polynomial::{Line, Polynomial};
use crate::scalar::Scalar;
use crate::size::Size;
use std::ops::Range;

impl<S: Scalar> Span<S> {
    /// Residual ρ = ku − (μu′)′ − q of a settlement u of open ground in the ground's equation.
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
    /// Sets the settlement ū on pieces where k or μ varies: the stored settlement plus a linear function that
    /// corrects the values at the nodes. The residual of ū in the ground's equation consists of ρ = kū − (μū′)′ − q
    /// along the pieces and of the jump r of the flux at open nodes. With the flexibility g of the ground at a node,
    /// it adds at most (Σ∫ρ²/k)^½ + Σ|r|√g to the bound Ḡ in (11) of docs/proof.md.
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

    /// Settlement of the ground at a node. At a node in contact, it is the deflection minus the initial gap. At an
    /// open node, it is the stored settlement of the piece on the left, or else of the piece on the right.
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
