//! Bounds the penetration of beam and open ground, and the energy of the surface correction that removes the penetration.
//!
//! C̄ = ū + g₀ − w̄ is the clearance between the ground surface ū and the deflection w̄ that are constructed from
//! the answer. A negative clearance is a penetration.
//!
//! Each end of an open stretch of a layer is a touching node or an end of the layer. At touching nodes C̄ = 0 by
//! construction. Let x be the distance from a touching node. For x ≤ d, the penetration is at most τx with a slope
//! τ. Elsewhere it is at most `deepest`. The correction raises the ground by v = D min(x/d, 1) with D = max(τd,
//! `deepest`). v is zero at every touching node, so the pressures do no work on v. The energy of v satisfies
//!
//! ```text
//! ‖v‖_b² ≤ D²(Σ kh + Σ μ/d + Σ K).
//! ```
//!
//! The sums extend over the pieces of length h of the stretch, over its touching ends, and over the ends of the
//! beam that the stretch reaches without contact. K is the stiffness of the ground outside an end of the beam.
//!
//! On Winkler ground, the correction raises the surface to max(w̄ − g₀, q/k). The norm of this correction is at
//! most (Σ kη²ω)^½. η bounds the penetration w̄ − g₀ − q/k on an open piece, and ω is the length on which the
//! penetration is positive.

use crate::arc::Arc;
use crate::deflection::Deflection;
use crate::frame::{Frame, Span};
use crate::ground::Surface;
use crate::polynomial::{Below, Budget, Polynomial, below, half_width};
use crate::scalar::Scalar;
use crate::size::Size;

/// The heights by which open ground is raised to remove the penetration, and the norms of these corrections.
#[derive(Debug)]
pub(crate) struct Clearance {
    /// (Σ‖v‖_b²)^½, the norm of the correction v of all open layers. The energies of the stretches of open layer
    /// add, because each v is zero at touching nodes.
    pub lifted: Size,
    /// (Σ kη²ω)^½, the norm of the correction of open Winkler ground. η is the penetration depth on the length ω.
    pub risen: Size,
    /// The height by which the correction raises the ground of each piece.
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

/// Bounds the depth and the length of the penetration w̄ − g₀ − q/k on an open piece of Winkler ground.
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
    // If k varies, q/k is not a polynomial. The polynomial q − k(w̄ − g₀) is used instead. It is negative exactly
    // where the beam penetrates the ground.
    let stiff = Size::of(span.spring.high());
    let clear = (span.spring.times(span.obstacle()).times(-S::one()) + load).coarse();
    let found = below(&clear, stiff * closed, stiff * negligible, span.interval(), budget);
    Below { depth: found.depth.over(span.spring.low()), ..found }
}

/// Consecutive open pieces of a layer. Each end of the stretch is a touching node or an end of the layer.
struct Stretch<'a, S> {
    frame: &'a Frame<S>,
    deflection: &'a Deflection<S>,
    surface: &'a Surface<S>,
    first: usize,
    end: usize,
    negligible: Size,
}

/// Neighbourhood of a touching node. At the distance x from the node, the penetration is proven to be at most τx,
/// with a constant slope τ.
struct Ramp {
    /// The value of t at the end of the neighbourhood away from the node.
    reach: f64,
    /// A lower bound of the length d of the neighbourhood.
    distance: f64,
    /// Bound τd of the penetration in the neighbourhood, where τ is the slope and d the length.
    depth: Size,
}

impl<S: Scalar> Stretch<'_, S> {
    /// Returns D and ‖v‖_b.
    fn lift(&self, budget: &mut Budget) -> (Size, Size) {
        let mut deepest = Size::ZERO;
        // Σ kh + Σ μ/d + K.
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

    /// Returns the slope of the clearance C̄ = ū + g₀ − w̄ at a touching node, on the side of the open piece.
    fn slope_at(&self, i: usize, side: usize) -> S {
        let span = &self.frame.spans[i];
        let settling = self.surface.pieces[i].flux[side].div(span.shear.at_end(side));
        let gap = span.gap_slope();
        let bent = self.deflection.claimed[i].slope[side] + self.deflection.pieces[i].slope[side];
        settling + gap - bent
    }
}

/// An open piece of a layer in numbers of low precision. Under a load on the ground, v = u − q/k replaces u, and
/// ψ − q/k replaces ψ = w − g₀.
pub(crate) struct OpenPiece<C> {
    pub arc: Arc<C>,
    /// ψ = w − g₀ and its derivatives ψ′ and ψ″ with respect to x, as polynomials of t.
    pub obstacle: [Polynomial<C>; 3],
    pub half: C,
    /// t at both ends.
    pub ends: [C; 2],
    pub interval: [f64; 2],
    closed: [Size; 3],
}

impl<C: Scalar> OpenPiece<C> {
    /// Returns an open piece with the obstacle ψ = w − g₀. `along` is the settlement u on ground whose k or μ
    /// varies. On such ground, ψ − u replaces ψ, and 0 replaces u.
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

    /// u and u′ at t.
    pub fn settlement(&self, t: f64) -> [C; 2] {
        self.arc.at((C::of(t) - self.ends[0]) * self.half)
    }

    /// Returns a lower bound of the second derivative C̄″ of the clearance on |t − m| ≤ r, computed from C̄″ ≥ b²u
    /// − ψ″ − |c″|. Here b² = k/μ, and c is the correction of the deflection. u is bounded below by its tangent at
    /// m and its smallest curvature.
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

    /// Finds a length d at a touching end of a piece, and a slope τ. The penetration is at most τx at each
    /// distance x ≤ d from the end. `slope` is the slope of the clearance at the end. `alone` states that the
    /// other end does not touch. The whole piece is then the first trial.
    fn ramp<S: Scalar>(&self, side: usize, slope: S, alone: bool, budget: &mut Budget) -> Ramp {
        let slope = if side == 0 { slope } else { -slope };
        let steep = Size::below_zero(slope.low());
        let [from, to] = self.interval;
        let end = self.interval[side];
        let mut reach = if alone { self.interval[1 - side] } else { 0.5 * (from + to) };
        // `blurred` is the rounding error of the clearance C̄. A depth τd of at most this error is accepted. On a
        // short piece, a bound from values of C̄ would be larger.
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
            // If the penetration at the far end of the neighbourhood is at least half of `depth`, a shorter
            // neighbourhood would at most halve the bound of the penetration.
            let at_reach = self.settlement(reach)[0] - self.obstacle[0].value(C::of(reach));
            let deep = depth.value() <= 2.0 * Size::below_zero(at_reach.high()).value();
            if deep || depth <= blurred || !(b - a > 1e-12) || !budget.take() {
                return ramp(depth);
            }
            reach = m;
        }
    }

    /// Returns an upper bound of the penetration −C̄ on an interval of t.
    fn deepest(&self, [from, to]: [f64; 2], negligible: Size, budget: &mut Budget) -> Size {
        // A depth below the rounding error of C̄ is accepted. Otherwise, at a double zero of C̄, for example
        // beside a clamp, the search would use up the permitted halvings of all pieces.
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
            // A depth is accepted if it is at most the largest depth so far, negligible, or below the rounding
            // error of C̄. It is also accepted if halving would not change it much.
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

#[cfg(test)]
mod tests {
    use super::{OpenPiece, Stretch, above_springs};
    use crate::answer::Piece;
    use crate::coefficient::Coefficient;
    use crate::fields::Fields;
    use crate::frame::Span;
    use crate::given_claim::with_fields;
    use crate::model::Course;
    use crate::polynomial::{Budget, Line};
    use crate::random::numbers;
    use crate::scalar::Scalar;
    use crate::size::Size;
    use crate::units::Units;
    use crate::wide::Wide;
    use serde_json::json;

    /// Checks the bound of the depth by which a beam penetrates loaded Winkler ground, with constant and varying k.
    #[test]
    fn the_depth_of_a_beam_in_loaded_springs_is_bounded() {
        let mut random = numbers();
        let mut deep = 0;
        for i in 0..300 {
            let units = Units { length: 0, force: 0 };
            let w = [0; 4].map(|_| random());
            let piece =
                Piece { x: [0.0, 2.0], half: 1.0, deflection: w.to_vec(), ..Piece::default() };
            let mut span = Span::of(&piece, [0.0, 2.0].map(Wide::of), units).expect("a piece");
            let k = [0; 2].map(|_| if i % 3 == 0 { 1.5 } else { 1.5 + random() });
            let line = Line::from_coefficients([0.5, 0.5].map(Wide::of));
            let course = Course::Varying(k.map(Wide::of).to_vec());
            span.spring = Coefficient::of(&course, &line, [Wide::zero(), Wide::one()], |x| x);
            let q = [1.0 + 0.5 * random(), 0.4 * random()];
            span.ground_load = Some(Line::from_coefficients(q.map(Wide::of)));
            let closed = 0.1 * random().abs();
            let above = |t: f64| {
                let spring = 0.5 * (k[0] + k[1]) + 0.5 * (k[1] - k[0]) * t;
                w[0] + t * (w[1] + t * (w[2] + t * w[3])) - (q[0] + q[1] * t) / spring + closed
            };
            let places = (0..=4000).map(|j| f64::from(j) / 2000.0 - 1.0);
            let most = places.clone().map(above).fold(0.0, f64::max);
            let width = places.filter(|t| above(*t) > 0.0).count() as f64 / 2000.0;
            let found = above_springs(&span, Size::of(closed), Size::ZERO, &mut Budget::new(1));
            let [low, high] = [k[0].min(k[1]), k[0].max(k[1])];
            let most_found = 1.3 * high / low * (most + if most > 0.0 { closed } else { 0.0 });
            let depth = found.depth.value();
            assert!(
                most - 1e-9 <= depth && (depth <= most_found + 1e-9 || most < 0.1),
                "{most} {depth}"
            );
            assert!(width - 2e-3 <= found.width.value(), "{width} {found:?}");
            deep += i32::from(most > 0.0);
        }
        assert!((50..290).contains(&deep), "{deep}");
    }

    /// The claimed slope jumps at x = 1, where an open piece begins. The slope of the corrected beam at x = 1 is
    /// that of the left piece, −0.2, for every size of the jump.
    #[test]
    fn the_slope_of_the_clearance_is_that_of_the_corrected_beam() {
        let text = "[beam]\nlength = 2\nEI = 1\n[foundation]\nk = 1\nmu = 1\n\
            [[gap]]\nat = 1\nvalue = 0\n[[gap]]\nat = 2\nvalue = 0.5\n";
        for jump in [0.0, 0.5, -0.5] {
            let document = json!({"pieces": [
                {"x": [0, 1], "half": 0.5, "touches": true, "deflection": [1.1, -0.1]},
                {"x": [1, 2], "half": 0.5, "touches": false, "deflection": [0.9 + 0.5 * jump, -0.1 + 0.5 * jump]},
            ]});
            with_fields(text, &document, |fields| {
                let Fields { frame, deflection, surface, .. } = fields;
                let stretch = Stretch {
                    frame,
                    deflection,
                    surface,
                    first: 1,
                    end: 2,
                    negligible: Size::ZERO,
                };
                // The surface is u = exp(1 − x), so u′ = −1 at x = 1. The gap has g₀′ = 0.5, and the beam
                // w′ = −0.2.
                let exact = Wide::of(-1.0 + 0.5 + 0.2);
                let found = stretch.slope_at(1, 0);
                assert!((found - exact).size() < 1e-14, "{jump}: {found:?}");
            });
        }
    }

    /// Checks an open piece between two contact regions, where the claimed deflection jumps at both ends. The flux
    /// μu′ at the ends follows from the corrected deflections of the ends. The layer begins at x = 1 beside
    /// Winkler ground. The surface of the layer is horizontal at x = 1, so the flux has no jump there.
    #[test]
    fn the_surface_joins_the_corrected_beam() {
        let text = "[beam]\nlength = 4\nEI = 1e6\n[foundation]\nk = 1\nmu = 1\n\
            [[foundation.segment]]\nfrom = 0\nto = 1\nk = 1\nmu = 0\n";
        for jump in [0.0, 0.25, -0.25] {
            let w = [vec![1.0], vec![1.0], vec![1.0 + jump, 0.125 * jump], vec![1.0 - jump]];
            let piece = |i: usize| json!({"x": [i, i + 1], "half": 0.5, "touches": i != 2, "deflection": w[i]});
            let pieces = [0, 1, 2, 3].map(piece);
            let document = json!({ "pieces": pieces });
            with_fields(text, &document, |fields| {
                let Fields { frame, deflection, surface, .. } = fields;
                let [left, right] = [2, 3].map(|node: usize| deflection.values[node].middle());
                let z = frame.spans[2].h.middle()
                    * (frame.spans[2].spring.middle() / frame.spans[2].shear.middle()).sqrt();
                let factor = (frame.spans[2].spring.middle() * frame.spans[2].shear.middle())
                    .sqrt()
                    / z.sinh();
                let exact =
                    [factor * (right - left * z.cosh()), factor * (right * z.cosh() - left)];
                for (flux, exact) in surface.pieces[2].flux.iter().zip(exact) {
                    assert!(
                        (flux.middle() - exact).abs() < 1e-12 * factor,
                        "{jump}: {flux:?} {exact}"
                    );
                }
                assert!(surface.nodes[1].jump.size() < 1e-12 * factor, "{:?}", surface.nodes[1]);
            });
        }
    }

    /// The open beam w = t/10 is deeper than the surface of the springs on a length of ¾, by at most 1/10.
    #[test]
    fn the_correction_of_open_springs_has_the_norm_of_depth_and_length() {
        let text =
            "[beam]\nlength = 1.5\nEI = 1\n[foundation]\nk = 2\n[[load]]\npoint = 1\nat = 0\n";
        let piece = json!({"x": [0, 1.5], "half": 0.75, "touches": false, "deflection": [0, 0.1]});
        with_fields(text, &json!({"pieces": [piece]}), |fields| {
            let exact = (2.0_f64 * 0.01 * 0.75).sqrt();
            let found = fields.clearance.risen.value();
            assert!((1.0..1.03).contains(&(found / exact)), "{found} {exact}");
        });
    }

    /// u = −sinh(2t)/sinh 2 solves u″ = 16u in x. Checks the bound of the curvature from the tangent and the least u.
    #[test]
    fn the_curvature_of_open_ground_is_bounded_by_a_tangent() {
        let text = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 16\nmu = 1\n";
        let piece = json!({"x": [0, 1], "half": 0.5, "touches": false, "deflection": [0]});
        with_fields(text, &json!({"pieces": [piece]}), |fields| {
            let span = &fields.frame.spans[0];
            let open = OpenPiece::of(span, [1.0, -1.0].map(Wide::of), None, [Size::ZERO; 3]);
            let u = |t: f64| -(2.0 * t).sinh() / 2.0_f64.sinh();
            for (m, r) in [(-0.5, 0.25), (-0.75, 0.25), (0.0, 0.125), (-0.25, 0.5), (0.5, 0.5)] {
                let slope = 4.0 * (2.0_f64 * m).cosh() / 2.0_f64.sinh();
                let tangent = u(m) - slope * 0.5 * r - 8.0 * (0.5 * r).powi(2);
                let found = open.curvature(m, r, open.settlement(m));
                let exact = 16.0 * tangent.max(-1.0);
                assert!(
                    (found - exact).abs() < 1e-12 && found <= 16.0 * u(m + r),
                    "{m} {r}: {found} {exact}"
                );
            }
        });
    }

    /// The straight beam w = 5/4 − x/2 penetrates the open ground beside its contact region. C̄ ≥ −τx on the length d,
    /// which is the whole open piece, or half of it if the beam also touches at its other end. k = μ = K_l = 1.
    #[test]
    fn the_correction_of_an_open_layer_has_the_norm_of_its_ramps() {
        let text = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\nmu = 1\n";
        let piece = |i: usize, mirrored: bool| {
            let from = 0.5 * i as f64;
            let touches = (i == 0) != mirrored;
            let slope = if mirrored { 0.125 } else { -0.125 };
            let middle = if touches { 1.125 } else { 0.875 };
            json!({"x": [from, from + 0.5], "half": 0.25, "touches": touches, "deflection": [middle, slope]})
        };
        for mirrored in [false, true] {
            for (pressed, stiffness) in [(false, 0.5 + 1.0 / 0.5 + 1.0), (true, 0.5 + 2.0 / 0.25)] {
                let at = if mirrored { 0.0 } else { 1.0 };
                let forces = if pressed { json!([{"x": at, "force": 1}]) } else { json!([]) };
                let document =
                    json!({"pieces": [piece(0, mirrored), piece(1, mirrored)], "forces": forces});
                with_fields(text, &document, |fields| {
                    let Fields { frame, deflection, surface, .. } = fields;
                    let first = usize::from(!mirrored);
                    let negligible = Size::ZERO;
                    let stretch =
                        Stretch { frame, deflection, surface, first, end: first + 1, negligible };
                    let mut budget = Budget::new(2);
                    budget.begin();
                    let (depth, norm) = stretch.lift(&mut budget);
                    let ratio = (norm.value() / depth.value()).powi(2) / stiffness;
                    assert!((ratio - 1.0).abs() < 1e-9, "{mirrored} {pressed}: {ratio} {depth:?}");
                });
            }
        }
    }
}
