//! The contact set of the exact solution on Winkler ground: the closure of the set where the beam presses on the springs.

use crate::contact_set::{Contact, ContactRegion, Shown, Zone, more};
use crate::model::Acts;
use crate::polynomial::{Budget, Polynomial, below};
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;

impl<S: Scalar> Contact<'_, S> {
    /// Proves the contact set on Winkler ground between two nodes, except in a short zone on each side of every edge
    /// of contact.
    pub(crate) fn springs(
        &self,
        first: usize,
        end: usize,
        shown: &mut Shown,
    ) -> Result<(), NotProven> {
        let spans = &self.fields.frame.spans;
        let differs = |i: usize, j: usize| spans[i].touches != spans[j].touches;
        let reopens = |i: &usize| differs(*i - 1, *i) && self.reopens(*i);
        if let Some(node) = (first + 1..end).find(reopens) {
            return Err(self.failed(
                "the load on the ground or the subgrade modulus jumps at a contact edge",
                node,
            ));
        }
        if let Some(piece) = self.divided_rest(first, end) {
            return Err(self.failed(
                "a part of the beam that rests on the ground without pressure is claimed to be in contact only in part",
                piece,
            ));
        }
        let mut zones = vec![[Size::ZERO; 2]; end - first];
        // Pieces for which `rests` is true need no check of the claimed fields: in the exact solution, the beam lies
        // on the ground there without pressure.
        for i in (first..end).filter(|i| !self.rests(*i)) {
            let field = self.signed(i);
            let edges = [i > first && differs(i - 1, i), i + 1 < end && differs(i, i + 1)];
            let mut interval = spans[i].interval();
            for side in [0, 1] {
                // A rigid support at the height of the unloaded ground makes the exact clearance zero. A load on the
                // ground lowers the ground, so the clearance at the support is then positive.
                let stands = self.stands(i, side) && spans[i].ground_load.is_none();
                // At a jump of the initial gap or of a load on the ground, the clearance may change its sign without
                // a zero.
                let steps = self.is_clear_at(i, side, &field);
                if (!edges[side] || steps) && !stands {
                    continue;
                }
                let (theta, to) = self
                    .zone(i, side, &field, more(self.bounds[i].deflection))
                    .ok_or_else(|| {
                        self.failed(
                            "no error bound is proven for the position of a contact edge",
                            i + side,
                        )
                    })?;
                interval[side] = to;
                shown.zones.push(Zone { piece: i, side, theta });
                // The position of an edge of contact is uncertain by `theta`. At a rigid support on the surface of the
                // ground it is certain: the edge is at the support.
                if !stands {
                    zones[i - first][side] = theta;
                }
            }
            let error = more(self.bounds[i].deflection);
            let clear = interval[0] < interval[1]
                && below(&field, error, Size::ZERO, interval, &mut Budget::new(1)).depth
                    == Size::ZERO;
            if !clear {
                return Err(self.failed(
                    "the difference between deflection and initial gap is too small to decide contact on Winkler ground",
                    i,
                ));
            }
        }
        let mut i = first;
        while i < end {
            let from = i;
            i += 1;
            if !spans[from].touches {
                continue;
            }
            while i < end && spans[i].touches {
                i += 1;
            }
            let before = if from > first { zones[from - 1 - first][1] } else { Size::ZERO };
            let after = if i < end { zones[i - first][0] } else { Size::ZERO };
            shown.set.regions.push(ContactRegion {
                from: self.interval(from, [before, zones[from - first][0]]),
                to: self.interval(i, [zones[i - 1 - first][1], after]),
            });
        }
        Ok(())
    }

    /// Whether there may be two contact edges near a claimed one. This requires a jump of the free-field settlement q/k at
    /// the edge: w* − g₀ − q/k may then be negative on the claimed contact side of the edge and positive on the other.
    fn reopens(&self, node: usize) -> bool {
        let frame = self.fields.frame;
        let spans = [&frame.spans[node - 1], &frame.spans[node]];
        if !frame.nodes[node].uneven || spans.iter().all(|span| span.ground_load.is_none()) {
            return false;
        }
        let [left, right] = [0, 1].map(|i| {
            let (span, side) = (spans[i], 1 - i);
            span.ground_load
                .as_ref()
                .map_or(S::zero(), |load| load.value(span.t[side]).div(span.spring.at_end(side)))
        });
        let [touching, open] = if spans[0].touches { [left, right] } else { [right, left] };
        let sinks = (open - touching).low() >= 0.0;
        let is_clear = |i: usize| self.is_clear_at(i, node - i, &self.signed(i));
        !sinks && !is_clear(node - 1) && !is_clear(node)
    }

    /// Whether the claimed sign of w − g₀ − q/k is proven at an end of a piece. `signed` is [`Self::signed`] of the piece.
    fn is_clear_at(&self, i: usize, side: usize, signed: &Polynomial<S::Coarse>) -> bool {
        let end = S::Coarse::of(self.fields.frame.spans[i].interval()[side]);
        signed.value(end).low() > more(self.bounds[i].deflection).value()
    }

    /// Returns w − g₀ − q/k on a piece in contact and its negative on an open piece, with the initial gap g₀ and the
    /// free-field settlement q/k.
    fn signed(&self, i: usize) -> Polynomial<S::Coarse> {
        let span = &self.fields.frame.spans[i];
        let field = span.above_free_field();
        if span.touches { field } else { field.times(-S::one()) }.coarse()
    }

    /// Whether there is a rigid two-way support at this end of the piece whose settlement equals the initial gap there.
    pub(crate) fn stands(&self, i: usize, side: usize) -> bool {
        let (span, node) = (&self.fields.frame.spans[i], &self.fields.frame.nodes[i + side]);
        let gap = span.gap.value(span.t[side]);
        node.rigid == Some(gap) && node.acts == Acts::Both
    }

    /// Whether the exact deflection and slope at an end of a piece equal those of the ground surface: at a clamp at the
    /// height of level ground, without shear deformation.
    fn lies(&self, i: usize, side: usize) -> bool {
        let (span, node) = (&self.fields.frame.spans[i], &self.fields.frame.nodes[i + side]);
        let shears = span.stiffness.is_some();
        self.stands(i, side) && node.clamped && !shears && span.gap.tail(1.0) == Size::ZERO
    }

    /// Finds a short zone without exact contact on an open piece of a shear layer, beside a rigid support at the
    /// initial surface of the ground. Loads on the ground act downward, so the beam lies above the ground in the zone.
    pub(crate) fn leaves_support(&self, i: usize, side: usize) -> Option<(Size, f64)> {
        let bounds = &self.bounds[i];
        let field = self.fields.frame.spans[i].obstacle().times(-S::one()).coarse();
        let limit = more(bounds.settlement + bounds.deflection);
        self.stands(i, side).then(|| self.zone(i, side, &field, limit)).flatten()
    }

    /// Finds a short zone at an end of a piece in which the inward slope of `field` exceeds its error bound. At the
    /// inner end, `field` exceeds `limit`. Returns the length of the zone and the coordinate t of its inner end.
    fn zone(
        &self,
        i: usize,
        side: usize,
        field: &Polynomial<S::Coarse>,
        limit: Size,
    ) -> Option<(Size, f64)> {
        let (span, bounds) = (&self.fields.frame.spans[i], &self.bounds[i]);
        let half = Size::of(span.half.high());
        let end = span.interval()[side];
        let inward = if side == 0 { 1.0 } else { -1.0 };
        // If the exact slope at the end is zero, the second derivative takes the place of the slope.
        let lies = self.lies(i, side);
        // A first derivative with respect to t is `half` times that with respect to x, and a second derivative
        // `half`² times.
        let (growth, error) = if lies {
            let bent = bounds.moment.over(span.bending.low());
            (field.derivative().derivative(), more(bent) * half.square())
        } else {
            (field.derivative().times(S::Coarse::of(inward)), more(bounds.slope) * half)
        };
        let at_end = growth.value(S::Coarse::of(end)).low();
        let far = (2.0 * limit.over(at_end)).value();
        let long = if lies { (2.0 * far).sqrt() } else { far };
        // The length of the zone, in the local coordinate t of the piece, is at least twice the machine precision,
        // so that rounding does not reduce the zone to a point.
        let mut long = long.max(2.0 * f64::EPSILON);
        for _ in 0..12 {
            let to = end + inward * long;
            if !(long < 0.75) {
                return None;
            }
            let m = end + 0.5 * (to - end);
            let about = growth.shifted(m);
            let r = (0.5 * long).next_up() + 4.0 * f64::EPSILON;
            let least = (about.coefficient(0).low() - about.tail(r).value()).next_down();
            if least > error.value() && field.value(S::Coarse::of(to)).low() > limit.value() {
                return Some((Size::of((to - end).abs().next_up()) * half, to));
            }
            long *= 2.0;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ball::Ball;
    use crate::fields::Fields;
    use crate::given_claim::with_fields;
    use crate::pointwise::PieceBounds;
    use crate::random::numbers;
    use crate::wide::Wide;
    use serde_json::json;

    /// A piece of the claimed solution, of length ¼: whether it is in contact, and the coefficients of its deflection as
    /// a polynomial in the coordinate t of the piece.
    type Claimed = (bool, [f64; 3]);

    fn with_pieces<T>(
        pieces: &[Claimed],
        supports: &str,
        of: impl FnOnce(&mut Fields<Wide>) -> T,
    ) -> T {
        let length = 0.25 * pieces.len() as f64;
        let model = format!("[beam]\nlength = {length:?}\nEI = 1\n[foundation]\nk = 1\n{supports}");
        let piece = |(i, (touches, deflection)): (usize, &Claimed)| {
            let from = 0.25 * i as f64;
            json!({"x": [from, from + 0.25], "half": 0.125, "touches": touches, "deflection": deflection})
        };
        let pieces: Vec<_> = pieces.iter().enumerate().map(piece).collect();
        with_fields(&model, &json!({"pieces": pieces}), of)
    }

    fn errors(count: usize, [deflection, slope]: [f64; 2]) -> Vec<PieceBounds> {
        let [deflection, slope] = [deflection, slope].map(Size::of);
        vec![PieceBounds { deflection, slope, ..PieceBounds::EXACT }; count]
    }

    fn found(
        fields: &Fields<Wide>,
        first: usize,
        errors: &[PieceBounds],
    ) -> (Shown, Option<NotProven>) {
        let end = errors.len();
        let mut shown = Shown::nothing(end + 1);
        let contact = Contact { fields, bounds: errors };
        let refused = contact.springs(first, end, &mut shown).err();
        (shown, refused)
    }

    const FALLING: Claimed = (true, [0.5, -0.5, 0.0]);
    const RISING: Claimed = (true, [0.5, 0.5, 0.0]);
    /// w = −¼(1 − t²).
    const HOLLOW: Claimed = (false, [-0.25, 0.0, 0.25]);

    /// w crosses the ground surface at x = ½ and x = ¾ with the slopes −4 and 4. At the distance 0.005, |w| exceeds its
    /// error bound 0.01, so each edge is known to within 0.005. The examined pieces begin at x = ¼.
    #[test]
    fn edges_lie_where_the_beam_crosses_the_ground() {
        with_pieces(&[RISING, FALLING, HOLLOW, RISING], "", |fields| {
            let (shown, refused) = found(fields, 1, &errors(4, [0.01, 1.0]));
            assert_eq!(refused, None);
            let [left, right] = &shown.set.regions[..] else { panic!("{:?}", shown.set) };
            for (found, exact) in [
                (left.from, [0.25, 0.25]),
                (left.to, [0.495, 0.505]),
                (right.from, [0.745, 0.755]),
                (right.to, [1.0, 1.0]),
            ] {
                let near = [0, 1].map(|i: usize| (found[i] - exact[i]).abs() < 1e-5);
                assert!(near == [true; 2] && found[0] <= exact[0], "{found:?} {exact:?}");
            }
            // If the error bound of the slope is 4.5, more than the slope 4 itself, no error bound is proven for the
            // position of the first edge.
            let (_, refused) = found(fields, 1, &errors(4, [0.01, 4.5]));
            assert_eq!(refused.and_then(|why| why.at), Some(0.5));
        });
    }

    /// The beam crosses the ground at x = ¼ with the slope −4. A load on the ground under the contact zone, or a larger
    /// subgrade modulus beside it, lowers w − g₀ − q/k there: the beam may then be open at the left of the edge and in
    /// contact at its right. In the mirrored cases the jump only widens the gap.
    #[test]
    fn an_edge_at_a_jump_of_the_free_field_settlement_is_proven_only_if_the_gap_widens() {
        let load = |from: f64, to: f64| {
            format!("[[ground_load]]\ndistributed = 1e-3\nfrom = {from}\nto = {to}\n")
        };
        let stiff = |from: f64, to: f64| {
            format!("[[foundation.segment]]\nfrom = {from}\nto = {to}\nk = 2\n")
        };
        let falls = (false, [-0.5, -0.5, 0.0]);
        for (added, proven) in [
            (load(0.0, 0.5), true),
            (load(0.0, 0.25), false),
            (load(0.25, 0.5), true),
            (stiff(0.0, 0.25), true),
            (load(0.0, 0.5) + &stiff(0.0, 0.25), true),
            (load(0.0, 0.5) + &stiff(0.25, 0.5), false),
        ] {
            with_pieces(&[FALLING, falls], &added, |fields| {
                let error = 0.01 * (fields.frame.spans[0].h.middle() / 0.25);
                let (_, refused) = found(fields, 0, &errors(2, [error, 1.0]));
                assert_eq!(refused.is_none(), proven, "{added}");
            });
        }
    }

    /// A piece is proven to be in or out of contact only if |w − g₀| exceeds the error bound of w on the whole piece,
    /// with the deflection w and the initial gap g₀.
    #[test]
    fn a_beam_near_the_surface_has_no_contact_set() {
        for (pieces, proven) in [
            (&[(true, [0.02, 0.0, 0.0])][..], true),
            (&[(true, [0.005, 0.0, 0.0])], false),
            (&[(true, [0.015, 0.0, 0.01])], true),
            (&[(true, [0.005, 0.0, 0.02])], false),
            (&[(false, [-0.02, 0.0, 0.0])], true),
            (&[(false, [-0.005, 0.0, -0.02])], false),
            (&[FALLING, RISING], false),
            (&[(true, [0.52, -0.5, 0.0]), (true, [0.52, 0.5, 0.0])], true),
        ] {
            with_pieces(pieces, "", |fields| {
                let error = 0.01 * (fields.frame.spans[0].h.middle() / 0.25);
                let (_, refused) = found(fields, 0, &errors(pieces.len(), [error, 1.0]));
                assert_eq!(refused.is_none(), proven, "{pieces:?}");
            });
        }
    }

    #[test]
    fn a_rigid_support_on_the_surface_is_an_end_of_its_two_pieces() {
        let still = (true, [0.0; 3]);
        for (kind, level, lies) in
            [("pinned", 0.0, false), ("fixed", 0.0, true), ("fixed", 0.5, false)]
        {
            let support = format!(
                "[[support]]\nat = 0.75\ntype = '{kind}'\nsettlement = {level:?}\n\
                 [[gap]]\nat = 0\nvalue = 0\n"
            );
            with_pieces(&[still; 4], &support, |fields| {
                let bounds = errors(4, [0.0; 2]);
                let contact = Contact { fields, bounds: &bounds };
                for (i, side) in [(0, 0), (0, 1), (1, 0), (1, 1), (2, 0), (2, 1), (3, 0), (3, 1)] {
                    let here = i + side == 3;
                    assert_eq!(contact.stands(i, side), here && level == 0.0, "{kind} {i} {side}");
                    assert_eq!(contact.lies(i, side), here && lies, "{kind} {i} {side}");
                }
            });
        }
    }

    /// Checks the zones for random polynomials `field`: the inward slope, or the second derivative at a clamp, exceeds
    /// its error bound. At the inner end of the zone, `field` exceeds the limit.
    #[test]
    fn a_field_grows_to_the_limit_within_its_zone() {
        let clamps =
            "[[support]]\nat = 0\ntype = 'fixed'\n[[support]]\nat = 0.25\ntype = 'fixed'\n";
        let mut random = numbers();
        let mut all = [0; 2];
        for case in 0..2000 {
            let (side, clamped) = (case % 2, case % 4 < 2);
            let inward = [1.0, -1.0][side];
            // `c` contains the coefficients of a polynomial in the distance |t − t₀| from an end t₀ = ±1 of the piece,
            // where t is the coordinate on the piece.
            let mut random = || random();
            let [a, b, c] = match case % 8 < 4 {
                true => [0.25 + 0.5 * random().abs(), 0.0, 0.0],
                false => [0, 1, 2].map(|_| random()),
            };
            let c = if clamped { [0.0, 0.0, 0.5 * a.abs(), b] } else { [0.0, a.abs(), b, c] };
            let growth = |s: f64| match clamped {
                true => 2.0 * c[2] + 6.0 * c[3] * s,
                false => c[1] + s * (2.0 * c[2] + 3.0 * c[3] * s),
            };
            let value = |s: f64| s * (c[1] + s * (c[2] + s * c[3]));
            let least = 0.5 * random().abs();
            let limit = if b == 0.0 { 1e-3 } else { 0.2 * random().abs() };
            let powers =
                c.iter().zip([1.0, inward, 1.0, inward]).map(|(c, sign)| Ball::of(c * sign));
            let field: Polynomial<Ball> = Polynomial::from_coefficients(powers);
            let field = field.shifted([1.0, -1.0][side]);
            with_pieces(&[(true, [0.0; 3])], if clamped { clamps } else { "" }, |fields| {
                let half = fields.frame.spans[0].half.middle();
                let mut bounds = errors(1, [0.0, least / half]);
                bounds[0].moment =
                    Size::of(least / (half * half) * fields.frame.spans[0].bending.middle());
                let contact = Contact { fields, bounds: &bounds };
                let zone = contact.zone(0, side, &field, Size::of(limit));
                if b == 0.0 && c[3] == 0.0 {
                    assert_eq!(zone.is_some(), a.abs() > least, "{a} {least}");
                }
                let Some((theta, to)) = zone else { return };
                all[usize::from(clamped)] += 1;
                let s = (to + inward).abs();
                assert!(
                    (theta.value() / (s * half) - 1.0).abs() < 1e-9 && s < 0.75,
                    "{theta:?} {to}"
                );
                assert!(value(s) >= limit - 1e-14, "{c:?} {s} {limit}");
                for j in 0..=20 {
                    assert!(growth(0.05 * s * f64::from(j)) >= least - 1e-14, "{c:?} {s} {least}");
                }
            });
        }
        assert!(all.iter().all(|count| *count > 100), "{all:?}");
    }
}
