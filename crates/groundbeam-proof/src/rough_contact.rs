//! Bounds the positions of the contact edges on each piece with a shear layer, without a bound of the slope of the beam.
//!
//! On a Timoshenko beam, the bound of the slope depends on the lengths with contact in only one of the two solutions.
//! See *Timoshenko beams on a layer* in section 5 of `docs/proof.md`.

use crate::approach::clear;
use crate::clearance::OpenPiece;
use crate::contact::{SHORTEST_PART, balanced_on, growing_parts};
use crate::contact_set::{Contact, EdgeShift, Shown, more};
use crate::polynomial::{Budget, below};
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;

impl<S: Scalar> Contact<'_, S> {
    /// Returns bounds of the contact edges on every piece over a shear layer. The error bound of a contact force is
    /// infinite at a node in contact, and zero at any other node.
    pub fn roughly(&self) -> Shown {
        let frame = self.fields.frame;
        let mut shown = Shown::nothing(frame.nodes.len());
        let touches = &self.fields.surface.touches;
        for node in (0..frame.nodes.len()).filter(|node| touches[*node]) {
            shown.tolerances[node] = Size::INFINITE;
        }
        for i in (0..frame.spans.len()).filter(|i| frame.spans[*i].layered) {
            let edges = match frame.spans[i].touches {
                true => self.opened(i).map(|inside| {
                    [0, 1].map(|side| EdgeShift {
                        node: i + side,
                        side,
                        outside: Size::ZERO,
                        inside: inside[side],
                        beyond: [Size::INFINITE; 2],
                    })
                }),
                // The left end of a piece out of contact is the right end of a contact region.
                false => self.touched(i).map(|outside| {
                    [0, 1].map(|side| EdgeShift {
                        node: i + side,
                        side: 1 - side,
                        outside: outside[side],
                        inside: Size::ZERO,
                        beyond: [Size::INFINITE; 2],
                    })
                }),
            };
            match edges {
                Ok(edges) => shown.edges.extend(edges),
                Err(why) => drop(shown.failed[0].get_or_insert(why)),
            }
        }
        shown
    }

    fn rough_clearance(&self, i: usize) -> Size {
        more(self.bounds[i].settlement + self.bounds[i].deflection)
    }

    /// Returns for each end of a piece in contact the length on which the exact solution may be out of contact.
    fn opened(&self, i: usize) -> Result<[Size; 2], NotProven> {
        let field = self.fields.pressures[i].field.coarse();
        let error = more(self.bounds[i].pressure);
        let interval = self.fields.frame.spans[i].interval();
        if below(&field, error, Size::ZERO, interval, &mut Budget::new(1)).depth != Size::ZERO {
            return Err(self.failed("the pressure is smaller than its error bound", i));
        }
        let length = self.fields.frame.spans[i].length();
        Ok([0, 1].map(|side| self.opened_at(i, side).unwrap_or(length)))
    }

    /// Bounds the length at an end of a piece in contact on which the exact solution may be open: (2ε_Cμ/m_p)^½ in
    /// section 5 of `docs/proof.md`. Requires a pressure above its error bound on the whole piece.
    pub(crate) fn opened_at(&self, i: usize, side: usize) -> Option<Size> {
        let span = &self.fields.frame.spans[i];
        let (field, error) = (self.fields.pressures[i].field.coarse(), self.bounds[i].pressure);
        let piece = (span.interval()[side], span.half.low());
        let deep = 2.0 * (self.rough_clearance(i) * Size::of(span.shear.high()));
        let opened = |least: f64| deep.over(least).root();
        balanced_on(growing_parts(), &field, error, piece, side, opened)
    }

    /// Returns for each end of a piece out of contact the length on which the exact solution may be in contact.
    fn touched(&self, i: usize) -> Result<[Size; 2], NotProven> {
        let too_small = || {
            self.failed("the clearance between beam and ground is too small to exclude contact", i)
        };
        let span = &self.fields.frame.spans[i];
        let touches = &self.fields.surface.touches;
        let piece = self.open_piece(i).ok_or_else(too_small)?;
        let limit = self.rough_clearance(i);
        let ends = piece.interval;
        let mut reach = [0.0; 2];
        for side in [0, 1] {
            if !touches[i + side] {
                continue;
            }
            let inward = if side == 0 { 1.0 } else { -1.0 };
            let mut part = SHORTEST_PART;
            while !(self.clearance_at(&piece, ends[side] + inward * part) > limit.value()) {
                part *= 1.5;
                if !(part < 1.0) {
                    return Err(too_small());
                }
            }
            reach[side] = 1.5 * part;
        }
        let interval = [ends[0] + reach[0], ends[1] - reach[1]];
        if !clear(&piece, interval, limit) {
            return Err(too_small());
        }
        let far = |side: usize| match touches[i + side] {
            true => Size::of((interval[side] - ends[side]).abs().next_up() + 4.0 * f64::EPSILON),
            false => Size::ZERO,
        };
        Ok([0, 1].map(|side| far(side) * Size::of(span.half.high())))
    }

    /// Returns a lower bound of the clearance C at the coordinate t of the piece.
    fn clearance_at(&self, piece: &OpenPiece<S::Coarse>, t: f64) -> f64 {
        let [u, _] = piece.settlement(t);
        (u - piece.obstacle[0].value(S::Coarse::of(t))).low()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fields::Fields;
    use crate::given_claim::with_fields;
    use crate::pointwise::PieceBounds;
    use crate::wide::Wide;
    use serde_json::json;

    /// Returns error bounds of settlement, deflection and pressure; all other error bounds are zero.
    fn errors([settlement, deflection, pressure]: [f64; 3]) -> PieceBounds {
        let [settlement, deflection, pressure] = [settlement, deflection, pressure].map(Size::of);
        PieceBounds { settlement, deflection, pressure, ..PieceBounds::EXACT }
    }

    /// The bound x is (2ε_Cμ/m)^½ with the minimum m of p − ε_p on the tried length. The tried lengths grow by the
    /// factor 4, so x must lie between the values with the minima on the lengths x and 4x.
    #[test]
    fn the_open_length_follows_from_the_smallest_pressure_on_it() {
        let model = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 2\nmu = 3\n";
        for (ends, error) in [([1.0_f64, 1.0], 0.0), ([3.0, 0.5], 0.5), ([0.5, 3.0], 0.5)] {
            let deflection = [0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0])];
            let document = json!({
                "pieces": [{"x": [0, 1], "half": 0.5, "touches": true, "deflection": deflection}],
            });
            with_fields(model, &document, |fields| {
                for (side, exponent) in
                    [0, 1].into_iter().flat_map(|s| (4..60).map(move |n| (s, n)))
                {
                    let off = 2.0_f64.powi(-exponent);
                    let bounds = [errors([off, 2.0 * off, error])];
                    let contact = Contact { fields, bounds: &bounds };
                    let deep = 2.0 * 3.0 * 3.0 * off;
                    let pressed = |x: f64| {
                        let [near, far] = [ends[side], ends[1 - side]];
                        2.0 * near.min(near + (far - near) * x.min(1.0)) - error
                    };
                    let what = format!("{ends:?} {side} {off:e}");
                    let Some(open) = contact.opened_at(0, side) else {
                        assert!(deep > 0.018 * pressed(1.0), "{what}");
                        continue;
                    };
                    let open = open.value();
                    assert!(open * open * pressed(open) >= deep, "{what}: {open:e}");
                    let sharp = open * open * pressed(4.0 * open) <= 1.001 * deep;
                    assert!(open <= 1.0 && sharp, "{what}: {open:e}");
                }
            });
        }
    }

    /// Up to x = 1 there is contact with p = w = 2 − x. The clearance beyond is about ½(x − 1)², with the error bound
    /// ε_C. The exact contact may extend by (2ε_C)^½ beyond x = 1, or be absent on (2ε_C/p)^½ at an end of a piece.
    #[test]
    fn the_ends_of_all_pieces_have_bounds_of_the_contact() {
        let model = "[beam]\nlength = 1.5\nEI = 1\n[foundation]\nk = 1\nmu = 1\n";
        for mirrored in [false, true] {
            let piece = |x: [f64; 2], touches: bool| {
                let half = 0.5 * (x[1] - x[0]);
                let middle = 2.0 - 0.5 * (x[0] + x[1]);
                let (x, slope) = match mirrored {
                    false => (x, -half),
                    true => ([1.5 - x[1], 1.5 - x[0]], half),
                };
                json!({"x": x, "half": half, "touches": touches, "deflection": [middle, slope]})
            };
            let mut pieces =
                [piece([0.0, 0.5], true), piece([0.5, 1.0], true), piece([1.0, 1.5], false)];
            if mirrored {
                pieces.reverse();
            }
            with_fields(model, &json!({"pieces": pieces}), |fields| {
                for n in 0..200 {
                    are_edges(fields, mirrored, 0.01 * 0.9_f64.powi(n));
                }
            });
        }
    }

    /// Checks the bounds of the contact edges of a beam with the deflection w = 2 − x, or of its mirror image. `off` is
    /// the error bound of the clearance.
    fn are_edges(fields: &Fields<Wide>, mirrored: bool, off: f64) {
        let bounds = [errors([0.25 * off, 0.75 * off, 0.0]); 3];
        let shown = Contact { fields, bounds: &bounds }.roughly();
        assert_eq!(shown.failed, [None, None], "{off:e}");
        let length = (2.0 * off).sqrt();
        let inside = |p: f64| [0.0, length / p.sqrt()];
        let mut exact = vec![
            (0, 0, inside(2.0)),
            (1, 1, inside(1.5)),
            (1, 0, inside(1.5)),
            (2, 1, inside(1.0)),
            (2, 1, [length, 0.0]),
            (3, 0, [0.0; 2]),
        ];
        let mut tolerances = vec![Size::INFINITE, Size::INFINITE, Size::INFINITE, Size::ZERO];
        if mirrored {
            exact = exact.into_iter().rev().map(|(n, side, all)| (3 - n, 1 - side, all)).collect();
            tolerances.reverse();
        }
        assert_eq!(shown.tolerances, tolerances);
        assert_eq!(shown.edges.len(), exact.len());
        for (edge, (node, side, exact)) in shown.edges.iter().zip(exact) {
            assert_eq!((edge.node, edge.side), (node, side), "{edge:?}");
            for (found, exact) in [edge.outside, edge.inside].into_iter().zip(exact) {
                let found = found.value();
                // If no bound shorter than the piece is found, the bound is 0.5, the length of the piece.
                let sharp = found <= 2.6 * exact || (exact > 0.05 && found < 0.501);
                assert!(exact <= found && sharp, "{edge:?} {exact}");
            }
            // `outside` is 1.5 times `within`, the first tried distance at which the clearance exceeds `off`. The
            // distance tried before is `last`. For a very small `off`, the rounding error is too large for this check.
            let [within, last] = [1.5, 2.25].map(|part| edge.outside.value() / part);
            let clearance = |y: f64| (-y).exp() - 1.0 + y;
            let is_first = clearance(within) > off && clearance(last) < 1.001 * off;
            assert!(is_first || edge.outside == Size::ZERO || off < 1e-8, "{edge:?} {off:e}");
        }
    }

    /// The contact edges on a piece have bounds only if its pressure, or its clearance away from its ends, exceeds the
    /// error bound.
    #[test]
    fn contact_without_a_bound_is_told() {
        let model = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\nmu = 1\n";
        let document = |touches: bool| json!({"pieces": [{"x": [0, 1], "half": 0.5, "touches": touches, "deflection": [1]}]});
        let failed = |touches: bool, error: [f64; 3]| {
            with_fields(model, &document(touches), |fields| {
                let bounds = [errors(error)];
                let [failed, _] = Contact { fields, bounds: &bounds }.roughly().failed;
                failed.map(|why| why.what)
            })
        };
        assert_eq!(failed(true, [0.0, 0.0, 0.99]), None);
        assert!(failed(true, [0.0, 0.0, 1.0]).is_some_and(|what| what.contains("pressure")));
        assert!(failed(false, [0.0; 3]).is_some_and(|what| what.contains("clearance")));
    }
}
