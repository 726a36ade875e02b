//! Bounds of the contact on each piece of a layer before the slope has a bound. On a beam with shear
//! deformation, the slope needs the shear force, and the shear force needs the lengths where only one of the
//! two solutions is in contact.
//!
//! With |C − C*| ≤ ε_C = ε_u + ε_w the exact beam is in contact on an open piece only where C ≤ ε_C, near its touching
//! ends. On a touching piece with p > ε_p the exact clearance is convex wherever it is positive, μC*″ ≥ m = min(p − ε_p),
//! and at most ε_C. So the exact beam is open only within (2ε_Cμ/m)^½ of the ends of the piece.

use crate::approach::clear;
use crate::clearance::OpenPiece;
use crate::contact_set::{Contact, EdgeShift, Shown, more};
use crate::polynomial::{Budget, below};
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;

/// The shortest length, in units of t, on which contact or clearance is decided.
const SHORTEST: f64 = 4e-12;

impl<S: Scalar> Contact<'_, S> {
    /// Bounds of the edges of every piece of a layer. Concentrated forces have bounds only at smooth nodes, where they are
    /// zero.
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
                // The left end of an open piece is the right end of a region.
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

    /// The lengths at both ends of a touching piece on which the exact beam may be open.
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

    /// (2ε_Cμ/m)^½, with m the smallest p − ε_p on a part of the piece of this length; `None` if no such part
    /// is found. It requires p > ε_p on the whole piece.
    pub(crate) fn opened_at(&self, i: usize, side: usize) -> Option<Size> {
        let span = &self.fields.frame.spans[i];
        let (field, error) = (self.fields.pressures[i].field.coarse(), self.bounds[i].pressure);
        let end = span.interval()[side];
        let deep = 2.0 * (self.rough_clearance(i) * Size::of(span.shear.high()));
        let mut part = SHORTEST;
        while part < 1.0 {
            let m = if side == 0 { end + 0.5 * part } else { end - 0.5 * part };
            let about = field.shifted(m);
            let lost = about.tail((0.5 * part).next_up() + 4.0 * f64::EPSILON) + error;
            let least = (about.coefficient(0).low() - lost.value()).next_down();
            let opened = deep.over(least).root();
            if opened.value() <= ((part - 1e-12).next_down() * span.half.low()).next_down() {
                return Some(opened);
            }
            part *= 4.0;
        }
        None
    }

    /// The lengths at both ends of an open piece on which the exact beam may be in contact.
    fn touched(&self, i: usize) -> Result<[Size; 2], NotProven> {
        let too_small = || self.failed("the clearance of open ground is too small", i);
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
            let mut part = SHORTEST;
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

    /// A lower bound of C at t.
    fn clearance_at(&self, piece: &OpenPiece<S::Coarse>, t: f64) -> f64 {
        let [u, _] = piece.settlement(t);
        (u - piece.obstacle[0].value(S::Coarse::of(t))).low()
    }
}
