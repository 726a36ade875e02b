//! One-way supports: proves which are active, and from which the exact beam is separated.
//!
//! Let ς = 1 for a support that pushes up, and −1 for a support that pulls down. A support without reaction
//! must satisfy −ς(w − δ) > ε_w. Then the corrected deflection w̄ is admissible, and the exact reaction is
//! zero, because |w̄ − w| and |w − w*| are at most ε_w. A closer support has its own node: a rigid support
//! with w̄ = δ and R̄ = 0, a spring with R̄ = κv̄⁺. Then all bounds hold for both states of the support.

use crate::frame::{Frame, Held};
use crate::model::Acts;
use crate::pointwise::PieceBounds;
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;

/// The supports without a node that the exact beam may touch, as indices of the model.
pub(crate) fn close<S: Scalar>(frame: &Frame<S>, bounds: &[PieceBounds]) -> Vec<usize> {
    let within = |piece: usize| bounds[piece].deflection.value();
    let supports = frame.supports.iter().enumerate();
    let idle = supports.filter(|(_, support)| support.node.is_none());
    idle.filter(|(_, support)| !is_clear(frame, &within, support)).map(|(i, _)| i).collect()
}

/// Fails at the first one-way support whose state is not proven. The state is proven if the reaction exceeds
/// its error bound, or if the beam is separated from the support.
pub(crate) fn decided<S: Scalar>(
    frame: &Frame<S>,
    bounds: &[PieceBounds],
    reactions: &[[Size; 2]],
) -> Result<(), NotProven> {
    let within = |piece: usize| bounds[piece].deflection.value();
    let undecided = |(support, [error, _]): &(&Held<S>, &[Size; 2])| {
        let acts = support.acts.towards(support.claimed[0]).low() > error.value();
        support.acts != Acts::Both && !acts && !is_clear(frame, &within, support)
    };
    match frame.supports.iter().zip(reactions).find(undecided) {
        None => Ok(()),
        Some((support, _)) => Err(too_close().at(frame.units.restored(support.x.middle(), 0, 1))),
    }
}

pub(crate) fn too_close() -> NotProven {
    NotProven::new("the beam is too close to a one-way support to decide whether it is active")
}

/// Fails at the first inactive support that the claimed deflection penetrates by more than rounding error. An
/// estimate uses this check.
pub(crate) fn nearly_clear<S: Scalar>(frame: &Frame<S>) -> Result<(), NotProven> {
    let sizes = frame.spans.iter().map(|span| Size::of(span.deflection.coefficient(0).size()));
    let rounding = ROUNDING * sizes.fold(Size::ZERO, Size::worst).value();
    let mut idle = frame.supports.iter().filter(|support| support.node.is_none());
    match idle.find(|support| !is_clear(frame, &|_| -rounding, support)) {
        None => Ok(()),
        Some(support) => {
            Err(NotProven::new("the beam penetrates a support that is claimed to be inactive")
                .at(frame.units.restored(support.x.middle(), 0, 1)))
        }
    }
}

/// Rounding error of a deflection, relative to the largest one.
const ROUNDING: f64 = 1e-9;

/// Whether the distance between the claimed deflection and a support exceeds the required distance on every
/// piece that contains the support.
fn is_clear<S: Scalar>(
    frame: &Frame<S>,
    wanted: &impl Fn(usize) -> f64,
    support: &Held<S>,
) -> bool {
    let x = support.x;
    let inside = x.high() >= 0.0 && (frame.length - x).high() >= 0.0;
    let after = frame.nodes.partition_point(|node| node.x.middle() < x.middle());
    // A position within rounding error of a node is checked on both adjacent pieces.
    let near = after.saturating_sub(2)..(after + 1).min(frame.spans.len());
    let holds = |i: usize| {
        let [from, to] = frame.spans[i].x;
        !((from - x).low() > 0.0) && !((x - to).low() > 0.0)
    };
    let clear = |i: usize| {
        let span = &frame.spans[i];
        let t = (x - span.middle).div(span.half);
        let distance = support.acts.towards(support.settlement - span.deflection.value(t));
        distance.low() > wanted(i)
    };
    inside && near.filter(|i| holds(*i)).all(clear)
}
