//! Proves which one-way supports are active, and which are separated from the beam in the exact solution.
//!
//! A support without reaction is inactive if its distance from the claimed deflection exceeds the error bound of the
//! deflection. Otherwise a node is added at the support, and the bounds hold whether the support is active or inactive.
//! See *One-way supports* in section 3 of docs/proof.md.

use crate::frame::{Frame, Held};
use crate::model::Acts;
use crate::pointwise::PieceBounds;
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;

/// Returns the indices of those supports that the exact deflection may reach although they have no node.
pub(crate) fn close<S: Scalar>(frame: &Frame<S>, bounds: &[PieceBounds]) -> Vec<usize> {
    let within = |piece: usize| bounds[piece].deflection.value();
    let supports = frame.supports.iter().enumerate();
    let idle = supports.filter(|(_, support)| support.node.is_none());
    idle.filter(|(_, support)| !is_clear(frame, &within, support)).map(|(i, _)| i).collect()
}

/// Returns an error at the first one-way support whose state is not proven. Either the reaction must exceed its error
/// bound, or the exact solution must be separated from the support.
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
    NotProven::new(
        "the beam is too close to a one-way support to decide whether the support is active",
    )
}

/// Returns an error at the first inactive support that the claimed deflection penetrates by more than rounding error.
/// Only the estimate without proof uses it.
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

/// Rounding error of a deflection, relative to the largest deflection.
const ROUNDING: f64 = 1e-9;

/// Whether the distance between the claimed deflection and a support exceeds `wanted` on every piece that contains
/// the support.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::given_claim::with_fields;
    use crate::wide::Wide;
    use serde_json::json;

    /// Passes the problem for four pieces of length 0.25 with the deflections `heights` to `of`. `supports` contains
    /// tables of a model file, and `reactions` the forces of these supports.
    fn with_frame(
        heights: [f64; 4],
        supports: &str,
        reactions: &[f64],
        of: impl FnOnce(&Frame<Wide>),
    ) {
        let model = format!("[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n{supports}");
        let piece = |(i, w): (usize, &f64)| {
            let from = 0.25 * i as f64;
            json!({"x": [from, from + 0.25], "half": 0.125, "touches": false, "deflection": [w]})
        };
        let pieces: Vec<_> = heights.iter().enumerate().map(piece).collect();
        let reactions: Vec<_> = reactions.iter().map(|force| json!({"force": force})).collect();
        let document = json!({"pieces": pieces, "reactions": reactions});
        with_fields(&model, &document, |fields| of(fields.frame));
    }

    fn support(x: f64, acts: Acts, settlement: f64) -> Held<Wide> {
        let [x, settlement] = [x, settlement].map(Wide::of);
        Held { x, acts, node: None, springs: None, settlement, claimed: [Wide::zero(); 2] }
    }

    /// Checks supports with the settlement 2. The deflection 1 is clear of a support that pushes up, and the deflection
    /// 3 of a support that pulls down.
    #[test]
    fn a_support_must_be_clear_of_every_piece_at_its_position() {
        let heights = [1.0, 3.0, 1.0, 3.0];
        with_frame(heights, "", &[], |frame| {
            for step in 0..=16 {
                let x = f64::from(step) / 16.0;
                let over = |i: &usize| 0.25 * *i as f64 <= x && x <= 0.25 * (i + 1) as f64;
                let pieces: Vec<usize> = (0..4).filter(over).collect();
                for (acts, height) in [(Acts::Up, 1.0), (Acts::Down, 3.0)] {
                    let support = support(x, acts, 2.0);
                    let clear = is_clear(frame, &|_| 0.0, &support);
                    let exact = pieces.iter().all(|i| heights[*i] == height);
                    assert_eq!(clear, exact, "{x} {acts:?}");
                }
            }
            for x in [-0.01, 1.01] {
                assert!(!is_clear(frame, &|_| 0.0, &support(x, Acts::Up, 9.0)));
            }
        });
    }

    #[test]
    fn the_clearance_of_a_support_exceeds_the_bound_on_each_piece() {
        with_frame([1.0, 1.5, 1.5, 1.5], "", &[], |frame| {
            for (x, wanted, clear) in [
                (0.125, [0.9, 9.0], true),
                (0.125, [1.1, 0.0], false),
                (0.25, [0.9, 0.4], true),
                (0.25, [1.1, 0.4], false),
                (0.25, [0.9, 0.6], false),
            ] {
                let wanted = |piece: usize| wanted[piece.min(1)];
                assert_eq!(is_clear(frame, &wanted, &support(x, Acts::Up, 2.0)), clear, "{x}");
            }
        });
    }

    fn up(settlement: f64) -> String {
        format!(
            "[[support]]\nat = 0.125\ntype = 'pinned'\nacts = 'up'\nsettlement = {settlement:?}\n"
        )
    }

    /// Checks two one-way supports without reaction beside a beam with the deflection 1. Their distances from the beam
    /// are 1 and 0.5.
    #[test]
    fn supports_without_reactions_must_be_separated() {
        let both = "[[support]]\nat = 0.25\ntype = 'pinned'\nsettlement = 1\n";
        let down = "[[support]]\nat = 0.625\ntype = 'pinned'\nacts = 'down'\nsettlement = 0.5\n";
        let all = both.to_owned() + &up(2.0) + down;
        with_frame([1.0; 4], &all, &[], |frame| {
            for (error, wanted) in [(0.4, &[][..]), (0.6, &[2]), (1.1, &[1, 2])] {
                let error = Size::of(error);
                let bounds = [PieceBounds { deflection: error, ..PieceBounds::EXACT }; 4];
                assert_eq!(close(frame, &bounds), wanted, "{error:?}");
                let decided = decided(frame, &bounds, &[[Size::ZERO; 2]; 3]);
                assert_eq!(decided.is_ok(), wanted.is_empty(), "{error:?}");
            }
        });
    }

    #[test]
    fn the_reaction_of_an_active_support_exceeds_its_error() {
        for (acts, force) in [("up", 6.0), ("down", -6.0)] {
            let support = format!(
                "[[support]]\nat = 0.25\ntype = 'pinned'\nacts = '{acts}'\nsettlement = 1\n"
            );
            with_frame([1.0; 4], &support, &[force], |frame| {
                let bounds = [PieceBounds::EXACT; 4];
                assert!(close(frame, &bounds).is_empty());
                for (error, decides) in [(5.9, true), (6.0, false), (6.1, false)] {
                    let found = decided(frame, &bounds, &[[Size::of(error), Size::ZERO]]);
                    assert_eq!(found.is_ok(), decides, "{acts} {error}");
                }
            });
        }
    }

    /// Checks that the permitted penetration is 10⁻⁹ of the largest deflection.
    #[test]
    fn an_estimate_permits_a_penetration_by_rounding() {
        for (most, depth, permitted) in [
            (1.0, -1e-3, true),
            (1.0, 0.9e-9, true),
            (1.0, 1.1e-9, false),
            (1000.0, 0.9e-6, true),
            (1000.0, 1.1e-6, false),
        ] {
            with_frame([1.0, 1.0, most, 1.0], &up(1.0 - depth), &[], |frame| {
                assert_eq!(nearly_clear(frame).is_ok(), permitted, "{most} {depth}");
            });
        }
    }
}
