//! Parts of the beam that rest without load on level ground, between two clamps or between a clamp and an end of the beam.
//!
//! Such a part is in equilibrium at the height of its clamps without pressure, because loads on the ground act
//! downward. See *Parts that rest* in section 5 of `docs/proof.md`.

use crate::contact_set::Contact;
use crate::frame::{Frame, Node};
use crate::model::Acts;
use crate::polynomial::Line;
use crate::scalar::Scalar;
use crate::size::Size;

impl<S: Scalar> Contact<'_, S> {
    /// Whether it is proven for the whole piece that the exact deflection equals the settlement of a clamp, and that
    /// the beam touches the ground there without pressure.
    pub(crate) fn rests(&self, piece: usize) -> bool {
        self.resting_part(piece).is_some()
    }

    /// Returns the first and the last node of the resting part that contains a piece.
    fn resting_part(&self, piece: usize) -> Option<[usize; 2]> {
        let frame = self.fields.frame;
        let last = frame.spans.len();
        let parts = |node: &usize| *node == 0 || *node == last || frame.nodes[*node].clamped;
        let from = (0..=piece).rev().find(parts)?;
        let to = (piece + 1..=last).find(parts)?;
        let clamp = [from, to].into_iter().find(|node| frame.nodes[*node].clamped)?;
        let height = frame.nodes[clamp].rigid?;
        let rests = (from..to).all(|i| is_bare(frame, i, height))
            && [from, to].into_iter().all(|node| ends(&frame.nodes[node], height))
            && (from + 1..to).all(|node| is_free(&frame.nodes[node]));
        rests.then_some([from, to])
    }

    /// Returns the first piece with a wrong claim of contact on a part that rests on Winkler ground. Pieces with a load
    /// on the ground must be open, and the other pieces of the part all in contact or all open. They must be open if the
    /// part crosses a shear layer, where it is open.
    pub(crate) fn divided_rest(&self, first: usize, end: usize) -> Option<usize> {
        let spans = &self.fields.frame.spans;
        let mut next = first;
        while next < end {
            let Some([from, to]) = self.resting_part(next) else {
                next += 1;
                continue;
            };
            let mut part = next..to.min(end);
            next = part.end;
            let crosses_layer = spans[from..to].iter().any(|span| span.layered);
            let bears = |i: &usize| !crosses_layer && spans[*i].ground_load.is_none();
            let listed = part.clone().find(bears).is_some_and(|i| spans[i].touches);
            if let Some(wrong) = part.find(|i| spans[*i].touches != (listed && bears(i))) {
                return Some(wrong);
            }
        }
        None
    }
}

/// Whether a piece has no loads and lies over level ground with the initial gap `height`.
fn is_bare<S: Scalar>(frame: &Frame<S>, piece: usize, height: S) -> bool {
    let span = &frame.spans[piece];
    let none = |line: &Line<S>| line.size(span.tau) == Size::ZERO;
    let level = span.gap.tail(span.tau) == Size::ZERO && span.gap.coefficient(0) == height;
    level && none(&span.force) && none(&span.moment) && none(&span.curvature)
}

/// Whether a resting part at the deflection `height` may end at a node: at a two-way clamp with this settlement, or at
/// a node without load, support and hinge.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact_set::Shown;
    use crate::given_claim::with_fields;
    use crate::pointwise::PieceBounds;
    use serde_json::json;

    /// Two pieces have the claimed deflection w = ¼. A part rests if it has no load, no hinge and no other support, and
    /// if the ground below it is level at the height of its clamps.
    #[test]
    fn a_part_rests_without_load_on_level_ground_of_the_height_of_its_clamps() {
        let level = "[[gap]]\nat = 0\nvalue = 0.25\n";
        let clamp = |at: f64, height: f64| {
            format!("[[support]]\nat = {at}\ntype = 'fixed'\nsettlement = {height}\n")
        };
        let other = |text: &str| clamp(0.0, 0.25) + level + text;
        for (text, resting) in [
            (clamp(0.0, 0.25) + level, [true, true]),
            (clamp(1.0, 0.25) + level, [true, true]),
            (clamp(0.0, 0.25) + &clamp(1.0, 0.25) + level, [true, true]),
            (clamp(0.0, 0.25) + &clamp(1.0, 0.5) + level, [false, false]),
            (clamp(0.0, 0.5) + &clamp(0.5, 0.25) + level, [false, true]),
            (level.to_owned(), [false, false]),
            (clamp(0.0, 0.25), [false, false]),
            (clamp(0.0, 0.25) + "[[gap]]\nat = 0\nvalue = 0.5\n", [false, false]),
            // The initial gap is linear on each of the two pieces. It equals the settlement of the clamp only in the
            // middle of each piece.
            (
                clamp(0.0, 0.25)
                    + "[[gap]]\nat = 0\nvalue = 0\n[[gap]]\nat = 0.5\nvalue = 0.5\n[[gap]]\nat = 1\nvalue = 0\n",
                [false, false],
            ),
            (other("[[load]]\npoint = 1\nat = 1\n"), [false, false]),
            (other("[[load]]\nmoment = 1\nat = 0.5\n"), [false, false]),
            (other("[[load]]\ndistributed = 1\nfrom = 0.5\nto = 1\n"), [false, false]),
            (
                other("[[load]]\ndistributed = 1\nfrom = 0\nto = 0.5\n") + &clamp(0.5, 0.25),
                [false, true],
            ),
            (other("[[support]]\nat = 1\nspring = 1\n"), [false, false]),
            (other("[[support]]\nat = 1\ntype = 'pinned'\nsettlement = 0.25\n"), [false, false]),
            (other("[[hinge]]\nat = 0.5\n"), [false, false]),
        ] {
            let model = format!("[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n{text}");
            let piece = |i: usize| {
                let from = 0.5 * i as f64;
                json!({"x": [from, from + 0.5], "half": 0.25, "touches": true, "deflection": [0.25]})
            };
            with_fields(&model, &json!({"pieces": [piece(0), piece(1)]}), |fields| {
                let bounds = [PieceBounds::EXACT; 2];
                let contact = Contact { fields, bounds: &bounds };
                assert_eq!([0, 1].map(|i| contact.rests(i)), resting, "{text}");
            });
        }
    }

    /// Four pieces lie over level ground at the height of the clamp at x = ½. Each part beside the clamp may be listed
    /// as contact only as a whole. The load on the ground opens a gap below the last piece.
    #[test]
    fn a_resting_part_is_listed_as_a_whole() {
        let model = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\n[[gap]]\nat = 0\nvalue = 0.25\n\
                     [[support]]\nat = 0.5\ntype = 'fixed'\nsettlement = 0.25\n";
        let load = "[[ground_load]]\ndistributed = 1\nfrom = 0.75\nto = 1\n";
        // The last two pieces belong to the part from the clamp to the end, which crosses a shear layer.
        let layer = "[[foundation.segment]]\nfrom = 0.75\nto = 1\nk = 1\nmu = 1\n";
        for touches in 0..16 {
            let touches = [0, 1, 2, 3].map(|i| touches >> i & 1 == 1);
            let [a, b, c, d] = touches;
            for (added, end, accepted) in
                [("", 4, a == b && c == d), (load, 4, a == b && !d), (layer, 3, a == b && !c)]
            {
                let piece = |i: usize| {
                    let from = 0.25 * i as f64;
                    json!({"x": [from, from + 0.25], "half": 0.125, "touches": touches[i], "deflection": [0.25]})
                };
                let pieces = [0, 1, 2, 3].map(piece);
                let document = json!({ "pieces": pieces });
                with_fields(&(model.to_owned() + added), &document, |fields| {
                    let bounds = [PieceBounds::EXACT; 4];
                    let mut shown = Shown::nothing(5);
                    let found = Contact { fields, bounds: &bounds }.springs(0, end, &mut shown);
                    assert_eq!(found.is_ok(), accepted, "{added}{touches:?}");
                });
            }
        }
    }
}
