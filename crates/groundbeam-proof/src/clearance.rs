//! Bounds the penetration of the beam into ground out of contact, and the energy of the surface correction that removes it.
//!
//! The clearance C̄ = ū + g₀ − w̄ follows from the constructed ground displacement ū, the initial gap g₀ and the
//! constructed deflection w̄. A negative clearance is a penetration. See *Clearance* in section 3 of docs/proof.md.
//!
//! A stretch is a run of pieces out of contact on a shear layer. On a stretch, the correction lowers the ground surface
//! by D min(x/d, 1) at the distance x from a touching node, at which the beam touches the ground. The penetration is at
//! most Dx/d for x ≤ d, and at most D elsewhere. The correction is zero at touching nodes, so the contact pressures do
//! no work on it. (10) of docs/proof.md bounds its energy.
//!
//! On Winkler ground out of contact, the correction lowers the ground surface to the beam where the beam penetrates it.

use crate::arc::Arc;
use crate::deflection::Deflection;
use crate::frame::{Frame, Span};
use crate::ground::Surface;
use crate::polynomial::{Below, Budget, Polynomial, below, half_width};
use crate::scalar::Scalar;
use crate::size::Size;

/// The distances by which ground out of contact is lowered to remove the penetration, and the norms of these
/// corrections.
#[derive(Debug)]
pub(crate) struct Clearance {
    /// Bound of (Σ‖v‖_b²)^½ for the corrections v of shear layers, by (10) of docs/proof.md. The energies of the
    /// stretches can be summed, because v is zero at every touching node.
    pub lifted: Size,
    /// Bound of the norm of the corrections that lower Winkler ground, (Σkη_o²ω_o)^½ in section 3 of docs/proof.md.
    pub risen: Size,
    /// For each piece, an upper bound of the distance by which the correction lowers the ground surface.
    pub raised: Vec<Size>,
}

pub(crate) fn clearance<S: Scalar>(
    frame: &Frame<S>,
    deflection: &Deflection<S>,
    surface: &Surface<S>,
    budget: &mut Budget,
) -> Clearance {
    let count = frame.spans.len();
    let mut found =
        Clearance { lifted: Size::ZERO, risen: Size::ZERO, raised: vec![Size::ZERO; count] };
    let (mut lifted, mut risen) = (Size::ZERO, Size::ZERO);
    let negligible = frame.negligible();
    let mut i = 0;
    while i < count {
        let span = &frame.spans[i];
        let first = i;
        i += 1;
        if span.touches {
            continue;
        }
        if !span.layered {
            let above = above_springs(span, deflection.pieces[first].bounds[0], negligible, budget);
            let width = (above.width * Size::of(span.half.high())).least(span.length());
            risen += Size::of(span.spring.high()) * above.depth.square() * width;
            found.raised[first] = above.depth;
            continue;
        }
        while i < count && surface.pieces[i].open.is_some() && !surface.touches[i] {
            i += 1;
        }
        let stretch = Stretch { frame, deflection, surface, first, end: i, negligible };
        let (depth, cost) = stretch.lift(budget);
        lifted += cost.square();
        found.raised[first..i].fill(depth);
    }
    found.lifted = lifted.root();
    found.risen = risen.root();
    found
}

/// Bounds the depth and the length of the penetration on a piece out of contact on Winkler ground. `closed` bounds the
/// correction of the deflection. The length is in units of the local coordinate t.
fn above_springs<S: Scalar>(
    span: &Span<S>,
    closed: Size,
    negligible: Size,
    budget: &mut Budget,
) -> Below {
    let Some(load) = span.ground_load.as_ref().filter(|_| span.spring.even().is_none()) else {
        let clear = span.above_free_field().times(-S::one()).coarse();
        return below(&clear, closed, negligible, span.interval(), budget);
    };
    // If k varies, the clearance q/k + g₀ − w under the ground load q is not a polynomial. `clear` is k times the
    // clearance.
    let stiff = Size::of(span.spring.high());
    let clear = (span.spring.times(span.obstacle()).times(-S::one()) + load).coarse();
    let found = below(&clear, stiff * closed, stiff * negligible, span.interval(), budget);
    Below { depth: found.depth.over(span.spring.low()), ..found }
}

/// Consecutive pieces out of contact on a shear layer. Each end of the stretch is a node at which the beam touches
/// the ground, or an end of the layer.
struct Stretch<'a, S> {
    frame: &'a Frame<S>,
    deflection: &'a Deflection<S>,
    surface: &'a Surface<S>,
    first: usize,
    end: usize,
    negligible: Size,
}

/// Neighbourhood of a touching node, at which the beam touches the ground. At the distance x from the node, the
/// penetration is proven to be at most τx, with a constant slope τ.
struct Ramp {
    /// Local coordinate t of the far end of an interval that begins at a node where the beam touches the ground.
    reach: f64,
    /// Lower bound of the length d of the neighbourhood of a touching node. At each distance x ≤ d from the node, the
    /// penetration is at most τx, with a constant slope τ.
    distance: f64,
    /// Upper bound of the penetration at all distances up to `distance` from the touching node.
    depth: Size,
}

impl<S: Scalar> Stretch<'_, S> {
    /// Returns D, the largest distance by which the correction v lowers the ground surface, and a bound of the norm
    /// ‖v‖_b.
    fn lift(&self, budget: &mut Budget) -> (Size, Size) {
        let mut deepest = Size::ZERO;
        // The sum Σ kh + Σ μ/d + Σ K, which bounds ‖v‖_b²/D².
        let mut stiffness = Size::ZERO;
        let ends = [self.first, self.end];
        for i in self.first..self.end {
            let Some(open) = self.surface.pieces[i].open else {
                return (Size::INFINITE, Size::INFINITE);
            };
            budget.begin();
            let span = &self.frame.spans[i];
            let along = self.surface.pieces[i].along.as_deref();
            let piece = OpenPiece::of(span, open, along, self.deflection.pieces[i].bounds);
            let [mut from, mut to] = span.interval();
            stiffness += Size::of(span.spring.high()) * span.length();
            for side in [0, 1] {
                let node = i + side;
                if node != ends[side] || !self.surface.touches[node] {
                    continue;
                }
                let alone = i + 1 - side != ends[1 - side] || !self.surface.touches[ends[1 - side]];
                let ramp = piece.ramp(side, self.slope_at(i, side), alone, budget);
                if side == 0 {
                    from = ramp.reach;
                } else {
                    to = ramp.reach;
                }
                deepest = deepest.worst(ramp.depth);
                stiffness += Size::of(span.shear.high()).over(ramp.distance);
            }
            deepest = deepest.worst(piece.deepest([from, to], self.negligible, budget));
        }
        for side in [0, 1] {
            let at_end = [0, self.frame.spans.len()][side] == ends[side];
            if at_end && !self.surface.touches[ends[side]] {
                stiffness += Size::of(self.frame.outside[side].high());
            }
        }
        (deepest, if deepest.value() == 0.0 { deepest } else { deepest * stiffness.root() })
    }

    /// Returns the slope of the clearance of the constructed fields at the end `side` of the piece `i` out of contact.
    fn slope_at(&self, i: usize, side: usize) -> S {
        let span = &self.frame.spans[i];
        let settling = self.surface.pieces[i].flux[side].div(span.shear.at_end(side));
        let gap = span.gap_slope();
        let bent = self.deflection.claimed[i].slope[side] + self.deflection.pieces[i].slope[side];
        settling + gap - bent
    }
}

/// A piece out of contact on a shear layer, in numbers of low precision. Its clearance is the ground displacement `arc`
/// minus `obstacle`. The same settlement may be subtracted from both.
pub(crate) struct OpenPiece<C> {
    pub arc: Arc<C>,
    /// The obstacle and its first and second derivatives with respect to x, as polynomials in the local coordinate t.
    pub obstacle: [Polynomial<C>; 3],
    pub half: C,
    /// Local coordinate t at both ends of the piece.
    pub ends: [C; 2],
    pub interval: [f64; 2],
    closed: [Size; 3],
}

impl<C: Scalar> OpenPiece<C> {
    /// Returns a piece with the ground displacements `ends` at its ends. The free-field settlement, or the stored
    /// displacement `along` if k or μ varies, is subtracted from ground displacement and obstacle.
    pub fn of<S: Scalar<Coarse = C>>(
        span: &Span<S>,
        ends: [S; 2],
        along: Option<&Polynomial<S>>,
        closed: [Size; 3],
    ) -> Self {
        let (obstacle, arc) = match along {
            Some(u) => (span.obstacle() - u, Arc::of(span, [S::zero(); 2])),
            None => (span.above_free_field(), Arc::of(span, span.above_free_ends(ends))),
        };
        let slope = span.derivative(&obstacle);
        let bent = span.derivative(&slope);
        OpenPiece {
            arc,
            obstacle: [obstacle.coarse(), slope.coarse(), bent.coarse()],
            half: span.half.coarse(),
            ends: span.t.map(|t| t.coarse()),
            interval: span.interval(),
            closed,
        }
    }

    /// Returns the ground displacement u and its slope u′ = du/dx at the local coordinate t of the piece.
    pub fn settlement(&self, t: f64) -> [C; 2] {
        self.arc.at((C::of(t) - self.ends[0]) * self.half)
    }

    /// Returns a lower bound of the second derivative of the clearance with respect to x, for |t − m| ≤ r. `u` and
    /// `slope` are the ground displacement and its slope at t = m.
    pub fn curvature(&self, m: f64, r: f64, [u, slope]: [C; 2]) -> f64 {
        let reach = C::of(r) * self.half;
        let least = self.arc.least();
        let bent = self.arc.curvature_factor();
        let bow = (bent * C::of(least) * reach * reach).scaled(-1);
        let steep = C::of(slope.size()) * reach;
        let tangent = (u - steep + bow).low();
        let least = if tangent > least { tangent } else { least };
        let about = self.obstacle[2].shifted(m);
        let lost = C::of((about.tail(r) + self.closed[2]).value());
        (bent * C::of(least) - about.coefficient(0) - lost).low()
    }

    /// Returns the [`Ramp`] at the end `side` of the piece, where the clearance has the slope `slope`. It covers at
    /// most half of the piece if the beam touches the ground at both ends (`alone` is false).
    fn ramp<S: Scalar>(&self, side: usize, slope: S, alone: bool, budget: &mut Budget) -> Ramp {
        let slope = if side == 0 { slope } else { -slope };
        let steep = Size::below_zero(slope.low());
        let [from, to] = self.interval;
        let end = self.interval[side];
        let mut reach = if alone { self.interval[1 - side] } else { 0.5 * (from + to) };
        // A bound of at most `blurred`, the rounding error of a computed clearance, is accepted.
        let blurred = Size::of(f64::EPSILON * self.arc.size());
        loop {
            let [a, b] = if side == 0 { [end, reach] } else { [reach, end] };
            let m = 0.5 * (a + b);
            let r = half_width(a, m, b);
            let curvature = self.curvature(m, r, self.settlement(m));
            let long = Size::of((b - a).next_up()) * Size::of(self.half.high());
            let inward = C::of(reach) - self.ends[side];
            let distance = (if side == 0 { inward } else { -inward } * self.half).low();
            let ramp = |depth: Size| Ramp { reach, distance, depth };
            if curvature >= 0.0 {
                return ramp(steep * long);
            }
            let fall = Size::below_zero(curvature) * long;
            if slope.low() >= fall.value() {
                return ramp(Size::ZERO);
            }
            let depth = (steep + fall) * long;
            // A shorter interval could gain at most a factor of 2 if the penetration at `reach` is at least half of
            // `depth`.
            let at_reach = self.settlement(reach)[0] - self.obstacle[0].value(C::of(reach));
            let deep = depth.value() <= 2.0 * Size::below_zero(at_reach.high()).value();
            if deep || depth <= blurred || !(b - a > 1e-12) || !budget.take() {
                return ramp(depth);
            }
            reach = m;
        }
    }

    /// Returns an upper bound of the penetration of the beam into the ground on an interval of the local coordinate
    /// t.
    fn deepest(&self, [from, to]: [f64; 2], negligible: Size, budget: &mut Budget) -> Size {
        // A penetration below the rounding error of the clearance is accepted. Otherwise a double zero of the
        // clearance, for example beside a clamp, would use up `budget`.
        let rounding = f64::EPSILON * (Size::of(self.arc.size()) + self.obstacle[0].size(1.0));
        let mut deepest = Size::ZERO;
        let mut open = Vec::new();
        let mut next = Some([from, to]);
        while let Some([a, b]) = next.take().or_else(|| open.pop()) {
            if !(a < b) {
                continue;
            }
            let m = 0.5 * (a + b);
            let r = half_width(a, m, b);
            let [u, slope] = self.settlement(m);
            let t = C::of(m);
            let value = u - self.obstacle[0].value(t);
            let slope_here = slope - self.obstacle[1].value(t);
            let curvature = Size::below_zero(self.curvature(m, r, [u, slope]));
            let reach = Size::of(r) * Size::of(self.half.high());
            let lost = Size::of(slope_here.size()) * reach
                + 0.5 * (curvature * reach.square())
                + self.closed[0];
            if value.low() >= lost.value() {
                continue;
            }
            let here = Size::below_zero(value.low());
            let depth = here + lost;
            let found = depth <= deepest || depth <= negligible || depth <= rounding;
            // The interval is not halved if this would reduce the depth only slightly.
            let blurred = Size::of(0.25 * (value.high() - value.low()));
            let enough = found || depth <= blurred + 1.25 * (here + self.closed[0]);
            if !enough && a < m && m < b && budget.take() {
                open.extend([[a, m], [m, b]]);
            } else {
                deepest = deepest.worst(depth);
            }
        }
        deepest
    }
}

mod tests;
