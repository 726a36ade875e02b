//! Supports of one direction that have no reaction: the exact beam is shown to be clear of them.
//!
//! With ς = 1 for a support that pushes up and −1 for one that pulls down, −ς(w − δ) > ε_w is required. The corrected
//! deflection w̄ then is admissible, and the exact reaction is zero, because |w̄ − w| and |w − w*| are at most ε_w.

use crate::frame::{Frame, Held};
use crate::pointwise::PieceBounds;
use crate::refusal::NotProven;
use crate::scalar::Scalar;

/// Fails at the first support that the exact beam may reach.
pub(crate) fn clear<S: Scalar>(frame: &Frame<S>, bounds: &[PieceBounds]) -> Result<(), NotProven> {
    let mut idle = frame.supports.iter().filter(|support| support.node.is_none());
    match idle.find(|support| !is_clear(frame, bounds, support)) {
        None => Ok(()),
        Some(support) => {
            let what =
                "the beam is too close to a support of one direction to tell whether it acts";
            Err(NotProven::new(what).at(frame.units.restored(support.x.middle(), 0, 1)))
        }
    }
}

fn is_clear<S: Scalar>(frame: &Frame<S>, bounds: &[PieceBounds], support: &Held<S>) -> bool {
    let x = support.x;
    let inside = x.high() >= 0.0 && (frame.length - x).high() >= 0.0;
    let after = frame.nodes.partition_point(|node| node.x.middle() < x.middle());
    // A position within the rounding of a node counts for the pieces on both sides.
    let near = after.saturating_sub(2)..(after + 1).min(frame.spans.len());
    let holds = |i: usize| {
        let [from, to] = frame.spans[i].x;
        !((from - x).low() > 0.0) && !((x - to).low() > 0.0)
    };
    let clear = |i: usize| {
        let span = &frame.spans[i];
        let t = (x - span.middle).div(span.half);
        let distance = support.acts.towards(support.settlement - span.deflection.value(t));
        distance.low() > bounds[i].deflection.value()
    };
    inside && near.filter(|i| holds(*i)).all(clear)
}
