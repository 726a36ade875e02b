//! Open ground of a layer in the exact solution: where the exact clearance is positive next to open pieces of the answer.

use crate::clearance::OpenPiece;
use crate::contact_set::{Contact, more};
use crate::polynomial::half_width;
use crate::scalar::Scalar;
use crate::size::Size;

/// Halvings on one piece.
const HALVINGS: usize = 2000;

/// The end of an open piece that touches.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Approach {
    /// The exact solution has no contact on the piece farther than this from the touching node.
    pub theta: Size,
    /// A bound of the error of μu′ at the node, if the exact beam is open on the piece.
    pub flux: Size,
    /// μ|C′| at the node.
    pub steep: Size,
    /// t of the place up to which the clearance itself has to be shown.
    reach: f64,
}

impl<S: Scalar> Contact<'_, S> {
    /// Shows that a stretch of open pieces is open in the exact solution; the approaches to its touching ends.
    ///
    /// Between the reaches C > ε_u + ε_w. From a reach to the touching node, less θ, C falls faster than its slope is off.
    pub(crate) fn stretch(&self, first: usize, end: usize) -> Option<[Option<Approach>; 2]> {
        let touches = &self.fields.surface.touches;
        let ends = [touches[first], touches[end]];
        let mut found = [None; 2];
        for i in first..end {
            let piece = self.open_piece(i)?;
            let mut interval = piece.interval;
            let here = [i == first && ends[0], i + 1 == end && ends[1]];
            for side in [0, 1] {
                if here[side] {
                    let approach = self.approach(&piece, i, side, here[1 - side])?;
                    interval[side] = approach.reach;
                    found[side] = Some(approach);
                }
            }
            let bounds = &self.bounds[i];
            if !clear(&piece, interval, more(bounds.settlement + bounds.deflection)) {
                return None;
            }
        }
        Some(found)
    }

    pub(crate) fn open_piece(&self, i: usize) -> Option<OpenPiece<S::Coarse>> {
        let open = self.fields.surface.open[i]?;
        let span = &self.fields.frame.spans[i];
        let along = self.fields.surface.along[i].as_deref();
        Some(OpenPiece::of(span, open, along, [Size::ZERO; 3]))
    }

    /// The approach to the touching end of a piece.
    fn approach(
        &self,
        piece: &OpenPiece<S::Coarse>,
        i: usize,
        side: usize,
        both: bool,
    ) -> Option<Approach> {
        let span = &self.fields.frame.spans[i];
        let [from, to] = piece.interval;
        let (end, wide) = (piece.interval[side], to - from);
        let inward = if side == 0 { 1.0 } else { -1.0 };
        // The exact beam is open from `far` to the reach, which bounds the error of u′.
        let far = end + inward * wide * if both { 0.75 } else { 1.0 - 1e-9 };
        let mut part = if both { 0.25 } else { 0.5 };
        for _ in 0..40 {
            let reach = end + inward * wide * part;
            let length = ((far - reach).abs().next_down() * span.half.low()).next_down();
            let steep = self.settlement_slope(i, length);
            let limit = more(steep + self.bounds[i].slope);
            if let Some(theta) = self.theta(i, side, piece, reach, limit) {
                let layer = Size::of(span.shear.high());
                let at_node = Size::of(fall(piece, side, end).size());
                let (flux, steep) = (layer * steep, layer * at_node);
                return Some(Approach { theta, flux, steep, reach });
            }
            part *= 0.7;
        }
        None
    }

    /// ε_u′ = b coth(bL/2) ε_u: u − u* is a sum of exponentials on the length L and at most ε_u.
    fn settlement_slope(&self, i: usize, length: f64) -> Size {
        if !(length > 0.0) {
            return Size::INFINITE;
        }
        let span = &self.fields.frame.spans[i];
        let decay = span.spring.least().div(span.shear.least()).sqrt();
        let fallen = (-(decay * S::of(length))).expm1();
        let factor = decay * (fallen + S::of(2.0)).div(-fallen);
        Size::of(factor.high()) * self.bounds[i].settlement
    }

    /// The least θ found for which C falls faster than `limit` from the reach to the node, less θ. Where θ > 0 the node
    /// is smooth and μC″ > ε_p on the last θ.
    fn theta(
        &self,
        i: usize,
        side: usize,
        piece: &OpenPiece<S::Coarse>,
        reach: f64,
        limit: Size,
    ) -> Option<Size> {
        let end = piece.interval[side];
        if falls(piece, side, [reach, end], limit) {
            return Some(Size::ZERO);
        }
        if !self.fields.frame.smooth(i + side) {
            return None;
        }
        let span = &self.fields.frame.spans[i];
        let curved = self.bounds[i].pressure.over(span.shear.low());
        let slope = Size::of(fall(piece, side, end).size()) + limit;
        let bent = piece.curvature(end, 0.0, piece.settlement(end));
        let mut theta = (1.05 * slope.over(bent).over(span.half.low())).value();
        for _ in 0..12 {
            let near = if side == 0 { end + theta } else { end - theta };
            let inside = if side == 0 { near < reach } else { near > reach };
            if !inside {
                return None;
            }
            let m = 0.5 * (near + end);
            let r = if side == 0 { half_width(end, m, near) } else { half_width(near, m, end) };
            let bends = piece.curvature(m, r, piece.settlement(m)) > more(curved).value();
            if bends && falls(piece, side, [reach, near], limit) {
                let far = Size::of((end - near).abs().next_up());
                return Some(far * Size::of(span.half.high()));
            }
            theta *= 2.0;
        }
        None
    }
}

/// C′ at t, positive where C grows towards the touching end.
fn fall<C: Scalar>(piece: &OpenPiece<C>, side: usize, t: f64) -> C {
    // The end of the interval stands for the exact end of the piece, which it may exceed by its rounding.
    let t = if t == piece.interval[side] { piece.ends[side] } else { C::of(t) };
    let [_, settling] = piece.arc.at((t - piece.ends[0]) * piece.half);
    let slope = settling - piece.obstacle[1].value(t);
    if side == 0 { -slope } else { slope }
}

/// Whether C falls towards the touching end faster than the limit, between a far place and a near one.
fn falls<C: Scalar>(piece: &OpenPiece<C>, side: usize, [far, near]: [f64; 2], limit: Size) -> bool {
    let mut open = vec![[far, near]];
    let mut left = 60;
    while let Some([far, near]) = open.pop() {
        let [a, b] = if side == 0 { [near, far] } else { [far, near] };
        if !(a < b) {
            return false;
        }
        let m = 0.5 * (a + b);
        let curvature = piece.curvature(m, half_width(a, m, b), piece.settlement(m));
        let length = Size::of((b - a).next_up()) * Size::of(piece.half.high());
        let gained = Size::below_zero(curvature) * length + limit;
        if fall(piece, side, near).high() < -gained.value() {
            continue;
        }
        // At the near end itself halving does not help.
        if left == 0 || !(fall(piece, side, near).high() < -limit.value()) || !(a < m && m < b) {
            return false;
        }
        left -= 1;
        open.extend([[far, m], [m, near]]);
    }
    true
}

/// Whether C > limit on an interval of t.
pub(crate) fn clear<C: Scalar>(piece: &OpenPiece<C>, [from, to]: [f64; 2], limit: Size) -> bool {
    let mut open = vec![[from, to]];
    let mut left = HALVINGS;
    while let Some([a, b]) = open.pop() {
        if !(a < b) {
            return false;
        }
        let m = 0.5 * (a + b);
        let r = half_width(a, m, b);
        let [u, slope] = piece.settlement(m);
        let t = C::of(m);
        let value = u - piece.obstacle[0].value(t);
        let steep = Size::of((slope - piece.obstacle[1].value(t)).size());
        let bent = Size::below_zero(piece.curvature(m, r, [u, slope]));
        let reach = Size::of(r) * Size::of(piece.half.high());
        let lost = steep * reach + 0.5 * (bent * reach.square()) + limit;
        if value.low() >= lost.value() {
            continue;
        }
        if left == 0 || !(value.low() >= limit.value()) || !(a < m && m < b) {
            return false;
        }
        left -= 1;
        open.extend([[a, m], [m, b]]);
    }
    true
}
