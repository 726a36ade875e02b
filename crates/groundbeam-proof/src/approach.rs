//! Proves that pieces without claimed contact have no contact in the exact solution, on ground with a shear layer.

use crate::clearance::OpenPiece;
use crate::contact_set::{Contact, Zone, more};
use crate::polynomial::half_width;
use crate::scalar::Scalar;
use crate::size::Size;

/// Maximum numbers of intervals in two proofs: that the clearance exceeds a limit, and that the clearance decreases
/// towards a node.
const INTERVALS: [usize; 2] = [4002, 122];

/// Proven bounds of the contact at one end of a piece. In the claimed solution, beam and ground touch at this end and
/// nowhere inside the piece.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Approach {
    /// Beam and ground touch at one end of the piece in the claimed solution. In the exact solution, the piece has no
    /// contact at distances greater than θ from this end.
    pub theta: Size,
    /// Error bound of the force in the shear layer at the touching end, if the exact solution has no contact on the
    /// piece.
    pub flux: Size,
    /// μ|C′| at that end of the piece at which beam and ground touch, where C is the clearance.
    pub steep: Size,
    /// Local coordinate from −1 to 1. From the touching end to this coordinate, the proof bounds the slope of the
    /// clearance; beyond it, the clearance.
    pub reach: f64,
}

impl<S: Scalar> Contact<'_, S> {
    /// Proves that a piece without claimed contact has no contact in the exact solution (section 5 of docs/proof.md).
    ///
    /// Returns an [`Approach`] for each end with claimed contact. Adds zones beside rigid supports to `zones`.
    pub(crate) fn shown_open(
        &self,
        i: usize,
        zones: &mut Vec<Zone>,
    ) -> Option<[Option<Approach>; 2]> {
        let mut found = [None; 2];
        // A piece that rests on the ground without load has no pressure and needs no proof.
        if self.rests(i) {
            return Some(found);
        }
        let piece = self.open_piece(i)?;
        let mut interval = piece.interval;
        let touches = [0, 1].map(|side| self.fields.surface.touches[i + side]);
        for side in [0, 1] {
            if touches[side] {
                let approach = self.approach(&piece, i, side, touches[1 - side])?;
                interval[side] = approach.reach;
                found[side] = Some(approach);
            } else if let Some((theta, to)) = self.leaves_support(i, side) {
                interval[side] = to;
                zones.push(Zone { piece: i, side, theta });
            }
        }
        let bounds = &self.bounds[i];
        clear(&piece, interval, more(bounds.settlement + bounds.deflection)).then_some(found)
    }

    pub(crate) fn open_piece(&self, i: usize) -> Option<OpenPiece<S::Coarse>> {
        let open = self.fields.surface.pieces[i].open?;
        let span = &self.fields.frame.spans[i];
        let along = self.fields.surface.pieces[i].along.as_deref();
        Some(OpenPiece::of(span, open, along, [Size::ZERO; 3]))
    }

    /// Returns the [`Approach`] for the end `side` of a piece; `None` if its bounds cannot be proven. Beam and ground
    /// touch at this end in the claimed solution.
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
        // The exact solution has no contact from `far` to `reach`. The error bound of the force in the shear layer
        // depends on their distance.
        let far = end + inward * wide * if both { 0.75 } else { 1.0 - 1e-9 };
        let mut part = if both { 0.25 } else { 0.5 };
        for _ in 0..40 {
            let reach = end + inward * wide * part;
            let length = ((far - reach).abs().next_down() * span.half.low()).next_down();
            let flux = self.settlement_flux(i, length);
            let limit = more(flux.over(span.shear.low()) + self.bounds[i].slope);
            if let Some(theta) = self.theta(i, side, piece, reach, limit) {
                let steep = Size::of(span.shear.high()) * Size::of(fall(piece, side, end).size());
                return Some(Approach { theta, flux, steep, reach });
            }
            part *= 0.7;
        }
        None
    }

    /// Returns an error bound of the force in the shear layer at the end of ground without contact of this `length`:
    /// (13) of docs/proof.md, or (13a) for varying k or μ.
    fn settlement_flux(&self, i: usize, length: f64) -> Size {
        if !(length > 0.0) {
            return Size::INFINITE;
        }
        let span = &self.fields.frame.spans[i];
        let error = self.bounds[i].settlement;
        let shear = Size::of(span.shear.high());
        if self.fields.surface.pieces[i].along.is_some() {
            let load = Size::of(span.spring.high()) * error + self.fields.surface.pieces[i].missed;
            return varying_flux(shear * error, load, length);
        }
        let decay = span.spring.least().div(span.shear.least()).sqrt();
        let fallen = (-(decay * S::of(length))).expm1();
        let factor = decay * (fallen + S::of(2.0)).div(-fallen);
        shear * Size::of(factor.high()) * error
    }

    /// Whether (μC′)′ exceeds its error bound on an interval of an open piece, with the clearance C. `m` and `r` are
    /// the middle and the half length of the interval in the local coordinate.
    fn presses(&self, i: usize, piece: &OpenPiece<S::Coarse>, m: f64, r: f64) -> bool {
        let (span, error) = (&self.fields.frame.spans[i], more(self.bounds[i].pressure));
        match &self.fields.surface.pieces[i].along {
            None => {
                let bent = piece.curvature(m, r, piece.settlement(m));
                bent > more(self.bounds[i].pressure.over(span.shear.low())).value()
            }
            Some(along) => {
                let pressure = span.pressure_under(along).coarse().shifted(m);
                let lost = pressure.tail(r) + error;
                (pressure.coefficient(0).low() - lost.value()).next_down() > 0.0
            }
        }
    }

    /// Returns a distance θ from the node at the end `side`. From `reach` to θ, the clearance C decreases towards the
    /// node faster than `limit`.
    ///
    /// A positive θ requires a smooth node (`Frame::smooth`), and that (μC′)′ exceeds its error bound up to θ.
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
            if self.presses(i, piece, m, r) && falls(piece, side, [reach, near], limit) {
                let far = Size::of((end - near).abs().next_up());
                return Some(far * Size::of(span.half.high()));
            }
            theta *= 2.0;
        }
        None
    }
}

/// Returns the bound (13a) of docs/proof.md. `stiff` is μ times the error bound of the ground displacement, and `load`
/// bounds the derivative of the flux error.
fn varying_flux(stiff: Size, load: Size, length: f64) -> Size {
    let best = (2.0 * stiff.value() / load.value()).sqrt();
    let h = if best < length { best } else { length };
    (2.0 * stiff).over(h) + Size::of(h) * load
}

/// Returns the slope of the clearance at the local coordinate t of the piece. The slope is positive if the clearance
/// increases towards the touching end.
fn fall<C: Scalar>(piece: &OpenPiece<C>, side: usize, t: f64) -> C {
    // Because of rounding, the stored end of the piece may lie outside the piece. The exact end is used instead.
    let t = if t == piece.interval[side] { piece.ends[side] } else { C::of(t) };
    let [_, settling] = piece.arc.at((t - piece.ends[0]) * piece.half);
    let slope = settling - piece.obstacle[1].value(t);
    if side == 0 { -slope } else { slope }
}

/// Whether the clearance C is proven to decrease faster than `limit` from the position `far` to the position `near`,
/// which is closer to the touching end.
fn falls<C: Scalar>(piece: &OpenPiece<C>, side: usize, [far, near]: [f64; 2], limit: Size) -> bool {
    let mut open = vec![[far, near]];
    for _ in 0..INTERVALS[1] {
        let Some([far, near]) = open.pop() else { return true };
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
        // Halving the interval helps the proof only if the clearance decreases faster than `limit` at the end `near`.
        if !(fall(piece, side, near).high() < -limit.value()) {
            return false;
        }
        open.extend([[far, m], [m, near]]);
    }
    false
}

/// Whether the clearance is proven to be at least `limit` between the coordinates `from` and `to` of the piece.
pub(crate) fn clear<C: Scalar>(piece: &OpenPiece<C>, [from, to]: [f64; 2], limit: Size) -> bool {
    let mut open = vec![[from, to]];
    for _ in 0..INTERVALS[0] {
        let Some([a, b]) = open.pop() else { return true };
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
        if !(value.low() >= limit.value()) {
            return false;
        }
        open.extend([[a, m], [m, b]]);
    }
    false
}

mod tests;
