//! Bounds the penetration of the beam into ground out of contact, and the energy of the surface correction that removes it.
//!
//! C̄ = ū + g₀ − w̄ is the clearance between beam and ground. The ground displacement ū and the deflection w̄ are
//! constructed from the answer, and g₀ is the initial gap. A negative clearance is a penetration.
//!
//! On a shear layer, a stretch is a run of pieces out of contact. Each of its ends is a touching node, at which the
//! beam touches the ground, or an end of the layer. At touching nodes C̄ = 0 by construction. Let x be the distance
//! from a touching node. For x ≤ d, the penetration is at most τx with a slope τ. Elsewhere it is at most `deepest`.
//! The correction lowers the ground surface by v = D min(x/d, 1) with D = max(τd, `deepest`). v is zero at every
//! touching node, so the contact pressures do no work on v. The energy of v satisfies
//!
//! ```text
//! ‖v‖_b² ≤ D²(Σ kh + Σ μ/d + Σ K).
//! ```
//!
//! The sums extend over the pieces of length h of the stretch, over its touching nodes, and over the ends of the beam
//! that the stretch reaches without contact. k is the subgrade modulus, μ the stiffness of the shear layer, and K the
//! stiffness of the ground outside an end of the beam.
//!
//! On Winkler ground, the correction lowers the surface to max(w̄ − g₀, q/k), where q is the load on the ground. The
//! norm of this correction is at most (Σ kη²ω)^½, summed over the pieces out of contact. η bounds the penetration
//! w̄ − g₀ − q/k on a piece, and ω is the length on which the penetration is positive.

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
    /// Norm (Σ‖v‖_b²)^½ of the corrections v that lower the surface of shear layers without contact, where ‖v‖_b² =
    /// ∫(kv² + μv′²) is twice the energy of the ground. The energies of separate stretches can be summed, because v is
    /// zero at every touching node.
    pub lifted: Size,
    /// Bound of the norm of the corrections that lower the surface of Winkler ground to remove penetrations. The
    /// bound is (Σ kη²ω)^½, summed over the pieces out of contact. k is the subgrade modulus, η bounds the
    /// penetration on a piece, and ω bounds the length on which the beam penetrates the ground.
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

/// Bounds the depth and the length of the penetration w̄ − g₀ − q/k on a piece out of contact on Winkler ground. w̄
/// is the constructed deflection, g₀ the initial gap, q the load on the ground, and k the subgrade modulus.
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
    // If k varies, the clearance q/k + g₀ − w is not a polynomial. The polynomial q − k(w − g₀), which is k times the
    // clearance, is used instead. q is the load on the ground, k the subgrade modulus, g₀ the initial gap, and w the
    // claimed deflection.
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
    /// Upper bound τd of the penetration in the neighbourhood of the touching node. d is the length of the
    /// neighbourhood, and the penetration at the distance x from the node is at most τx.
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

    /// Returns the slope of the clearance C̄ = ū + g₀ − w̄ at a touching node, on the side of the piece without
    /// contact. ū is the constructed ground displacement, g₀ the initial gap, and w̄ the constructed deflection.
    fn slope_at(&self, i: usize, side: usize) -> S {
        let span = &self.frame.spans[i];
        let settling = self.surface.pieces[i].flux[side].div(span.shear.at_end(side));
        let gap = span.gap_slope();
        let bent = self.deflection.claimed[i].slope[side] + self.deflection.pieces[i].slope[side];
        settling + gap - bent
    }
}

/// A piece out of contact on a shear layer, in numbers of low precision. If a load q acts on the ground, u − q/k is
/// stored in place of the ground displacement u, and ψ − q/k in place of the obstacle ψ = w − g₀. The clearance u − ψ
/// is unchanged. k is the subgrade modulus, w the deflection, and g₀ the initial gap.
pub(crate) struct OpenPiece<C> {
    pub arc: Arc<C>,
    /// ψ = w − g₀ and its derivatives ψ′ and ψ″ with respect to x, as polynomials of the local coordinate t of the
    /// piece.
    pub obstacle: [Polynomial<C>; 3],
    pub half: C,
    /// Local coordinate t at both ends of the piece.
    pub ends: [C; 2],
    pub interval: [f64; 2],
    closed: [Size; 3],
}

impl<C: Scalar> OpenPiece<C> {
    /// Returns an open piece with the obstacle ψ = w − g₀. If k or μ varies along the piece, `along` contains the
    /// ground displacement u as a polynomial. The piece then has the obstacle ψ − u and the ground displacement 0, so
    /// that the clearance u − ψ is unchanged.
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

    /// Returns a lower bound of the second derivative C̄″ = d²C̄/dx² of the clearance for |t − m| ≤ r, where t is the
    /// local coordinate of the piece. `u` and `slope` are the ground displacement and its slope at t = m.
    ///
    /// C̄ = u − ψ − c with the ground displacement u, the obstacle ψ (deflection minus initial gap) and the
    /// correction c of the deflection. So C̄″ is at least b²u − ψ″ − |c″|, where b² = k/μ. In this formula, u is
    /// replaced by a lower bound of u for |t − m| ≤ r.
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

    /// Finds a length d and a slope τ such that the penetration is at most τx at each distance x ≤ d from the end
    /// `side` of the piece, where the beam touches the ground. `slope` is the slope of the clearance at this end. If
    /// `alone` is true, the beam does not touch the ground at the other end of the piece, and d is at most the length
    /// of the piece. Otherwise, d is at most half of this length.
    fn ramp<S: Scalar>(&self, side: usize, slope: S, alone: bool, budget: &mut Budget) -> Ramp {
        let slope = if side == 0 { slope } else { -slope };
        let steep = Size::below_zero(slope.low());
        let [from, to] = self.interval;
        let end = self.interval[side];
        let mut reach = if alone { self.interval[1 - side] } else { 0.5 * (from + to) };
        // `blurred` is the rounding error of computed values of the clearance. If the bound of the penetration is at
        // most `blurred`, it is accepted, because a bound from computed values of the clearance would be larger.
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
            // If the penetration at `reach`, the far end of the interval, is at least half of its bound `depth`, the
            // interval is not shortened. No bound of the penetration can be smaller than half of `depth`.
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
        // A penetration smaller than the rounding error of the clearance C̄ is accepted. Without this tolerance, the
        // search at a double zero of C̄, for example beside a clamp, would use up the interval halvings that are
        // allowed for all pieces together.
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
            // `depth` is a bound of the penetration on the interval. It is accepted if it is at most `deepest`, the
            // largest bound of the previous intervals, or if it is negligible or at most the rounding error of the
            // clearance. It is also accepted if halving the interval would reduce it only slightly.
            let found = depth <= deepest || depth <= negligible || depth <= rounding;
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
