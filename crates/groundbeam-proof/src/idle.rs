//! Supports of one direction: which act, and from which the exact beam is shown to be clear.
//!
//! With ς = 1 for a support that pushes up and −1 for one that pulls down, −ς(w − δ) > ε_w is required of one that has no
//! reaction. The corrected deflection w̄ then is admissible, and the exact reaction is zero, because |w̄ − w| and |w − w*|
//! are at most ε_w. A support that is closer takes part at a node of its own: a rigid one with w̄ = δ and R̄ = 0, a spring
//! with R̄ = κv̄⁺. Then all bounds hold without knowing whether it acts.

use crate::frame::{Frame, Held};
use crate::model::Acts;
use crate::pointwise::PieceBounds;
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;

/// The supports without a node that the exact beam may reach, as indices of the model.
pub(crate) fn close<S: Scalar>(frame: &Frame<S>, bounds: &[PieceBounds]) -> Vec<usize> {
    let within = |piece: usize| bounds[piece].deflection.value();
    let supports = frame.supports.iter().enumerate();
    let idle = supports.filter(|(_, support)| support.node.is_none());
    idle.filter(|(_, support)| !is_clear(frame, &within, support)).map(|(i, _)| i).collect()
}

/// Fails at the first support of one direction of which it is not shown whether it acts: neither is its reaction larger
/// than the bound of its error nor the beam clear of it.
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
    NotProven::new("the beam is too close to a support of one direction to tell whether it acts")
}

/// Fails at the first idle support that the claimed deflection enters by more than rounding error: for an estimate.
pub(crate) fn nearly_clear<S: Scalar>(frame: &Frame<S>) -> Result<(), NotProven> {
    let sizes = frame.spans.iter().map(|span| Size::of(span.deflection.coefficient(0).size()));
    let rounding = ROUNDING * sizes.fold(Size::ZERO, Size::worst).value();
    let mut idle = frame.supports.iter().filter(|support| support.node.is_none());
    match idle.find(|support| !is_clear(frame, &|_| -rounding, support)) {
        None => Ok(()),
        Some(support) => {
            Err(NotProven::new("the beam enters a support that is claimed not to act")
                .at(frame.units.restored(support.x.middle(), 0, 1)))
        }
    }
}

/// Rounding error of a deflection, relative to the largest one.
const ROUNDING: f64 = 1e-9;

/// Whether the claimed deflection is farther from a support than the distance wanted on its piece.
fn is_clear<S: Scalar>(
    frame: &Frame<S>,
    wanted: &impl Fn(usize) -> f64,
    support: &Held<S>,
) -> bool {
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
        distance.low() > wanted(i)
    };
    inside && near.filter(|i| holds(*i)).all(clear)
}
