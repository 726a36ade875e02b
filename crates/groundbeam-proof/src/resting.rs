//! Parts of the beam that rest without load on level ground, between two clamps or between a clamp and an end of the beam.
//!
//! A clamp separates the beam into two parts. Consider a part without loads and springs, over level ground at the
//! height of the clamp. Loads on the ground act downward, so they do not lift the ground. Therefore this part is in
//! equilibrium if it stays at the height of the clamp without pressure. The solution on this part is unique, so the
//! exact pressure on it is zero.

use crate::contact_set::Contact;
use crate::frame::{Frame, Node};
use crate::model::Acts;
use crate::polynomial::Line;
use crate::scalar::Scalar;
use crate::size::Size;

impl<S: Scalar> Contact<'_, S> {
    /// Whether a piece rests without load in the exact solution.
    pub(crate) fn rests(&self, piece: usize) -> bool {
        let frame = self.fields.frame;
        let last = frame.spans.len();
        let parts = |node: &usize| *node == 0 || *node == last || frame.nodes[*node].clamped;
        let Some(from) = (0..=piece).rev().find(parts) else { return false };
        let Some(to) = (piece + 1..=last).find(parts) else { return false };
        let clamped = [from, to].into_iter().find(|node| frame.nodes[*node].clamped);
        let Some(height) = clamped.and_then(|node| frame.nodes[node].rigid) else { return false };
        (from..to).all(|i| is_bare(frame, i, height))
            && [from, to].into_iter().all(|node| ends(&frame.nodes[node], height))
            && (from + 1..to).all(|node| is_free(&frame.nodes[node]))
    }
}

/// Whether a piece has no loads and lies over level ground with the initial gap `height`.
fn is_bare<S: Scalar>(frame: &Frame<S>, piece: usize, height: S) -> bool {
    let span = &frame.spans[piece];
    let none = |line: &Line<S>| line.size(span.tau) == Size::ZERO;
    let level = span.gap.tail(span.tau) == Size::ZERO && span.gap.coefficient(0) == height;
    level && none(&span.force) && none(&span.moment) && none(&span.curvature)
}

/// Whether a resting part with w = `height` may end at a node: at a two-way clamp with the settlement `height`, or
/// at a free end without load.
fn ends<S: Scalar>(node: &Node<S>, height: S) -> bool {
    match node.clamped {
        true => node.rigid == Some(height) && node.acts == Acts::Both,
        false => is_free(node),
    }
}

/// Whether a node has no load, support or hinge.
fn is_free<S: Scalar>(node: &Node<S>) -> bool {
    let held = node.rigid.is_some() || node.spring.is_some() || node.turning.is_some();
    !held && !node.is_hinged() && node.force == S::zero() && node.moment == S::zero()
}
