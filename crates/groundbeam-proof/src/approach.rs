//! Open ground with a shear layer: shows that the clearance of the exact solution is positive next to open pieces of
//! the answer.

use crate::clearance::OpenPiece;
use crate::contact_set::{Contact, Zone, more};
use crate::polynomial::half_width;
use crate::scalar::Scalar;
use crate::size::Size;

/// Maximum numbers of intervals: for the sign of the clearance on a piece, and for its slope beside a node.
const INTERVALS: [usize; 2] = [4002, 122];

/// The neighbourhood of a touching end of an open piece.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Approach {
    /// θ: at larger distances from the touching node, the exact solution has no contact on the piece.
    pub theta: Size,
    /// A bound of the error of μu′ at the node, valid if the exact beam is open on the piece.
    pub flux: Size,
    /// μ|C′| at the node.
    pub steep: Size,
    /// t of the position up to which the clearance is proven to be positive by its value.
    reach: f64,
}

impl<S: Scalar> Contact<'_, S> {
    /// Proves that an open piece is open in the exact solution. Returns the [`Approach`] at each
    /// touching end.
    ///
    /// Between the reaches C > ε_u + ε_w. From a reach to the touching node, except on the last θ, C
    /// decreases faster than the bound of its slope's error. Next to a rigid support on the surface of the
    /// ground, g₀ − w increases from zero; the result lists such zones. No pressure acts where the beam rests
    /// without load.
    pub(crate) fn shown_open(
        &self,
        i: usize,
        zones: &mut Vec<Zone>,
    ) -> Option<[Option<Approach>; 2]> {
        let mut found = [None; 2];
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
        // The exact beam is open from `far` to the reach. The bound of the error of u′ follows from the
        // length of this open ground.
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

    /// A bound of μ|u − u*|′ at the end of a length L of open ground on which |u − u*| ≤ ε_u.
    ///
    /// If k and μ are constant, u − u* is a sum of exponentials: μb coth(bL/2) ε_u. Otherwise (μ(u − u*)′)′ =
    /// k(u − u*) − ρ, and by the mean value theorem |u − u*|′ ≤ 2ε_u/h at some point of a length h ≤ L. The
    /// bound is then 2με_u/h + h(kε_u + max|ρ|).
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

    /// A lower bound, on |t − m| ≤ r of an open piece, of (μC′)′ minus the bound of its error.
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

    /// The smallest θ found such that C decreases faster than `limit` from the reach to the distance θ from
    /// the node. If θ > 0, the node is smooth and (μC′)′ > ε_p over the last length θ, with (μC′)′ = ku − q −
    /// (μψ′)′ except for ρ.
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

/// The minimum of 2με/h + h·load over h ≤ length.
fn varying_flux(stiff: Size, load: Size, length: f64) -> Size {
    let best = (2.0 * stiff.value() / load.value()).sqrt();
    let h = if best < length { best } else { length };
    (2.0 * stiff).over(h) + Size::of(h) * load
}

/// C′ at t, positive where C grows towards the touching end.
fn fall<C: Scalar>(piece: &OpenPiece<C>, side: usize, t: f64) -> C {
    // The end of the interval may lie outside the piece by rounding error. The exact end takes its place.
    let t = if t == piece.interval[side] { piece.ends[side] } else { C::of(t) };
    let [_, settling] = piece.arc.at((t - piece.ends[0]) * piece.half);
    let slope = settling - piece.obstacle[1].value(t);
    if side == 0 { -slope } else { slope }
}

/// Whether C decreases towards the touching end faster than the limit, between a far position and a near one.
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
        // Halving cannot succeed at the near end itself.
        if !(fall(piece, side, near).high() < -limit.value()) {
            return false;
        }
        open.extend([[far, m], [m, near]]);
    }
    false
}

/// Whether C > limit on an interval of t.
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

#[cfg(test)]
mod tests {
    use super::{clear, falls, varying_flux};
    use crate::answer::Piece;
    use crate::ball::Ball;
    use crate::clearance::OpenPiece;
    use crate::coefficient::Coefficient;
    use crate::contact_set::Contact;
    use crate::frame::Span;
    use crate::given_claim::with_fields;
    use crate::pointwise::PieceBounds;
    use crate::random::numbers;
    use crate::scalar::Scalar;
    use crate::size::Size;
    use crate::units::Units;
    use crate::wide::Wide;
    use serde_json::{Value, json};

    const COUNT: usize = 2000;

    /// A length of varying ground: k, μ and a load as parabolas, given by Bernstein coefficients.
    struct Ground {
        length: f64,
        k: [f64; 3],
        mu: [f64; 3],
        load: [f64; 3],
    }

    /// Bernstein's formula.
    fn parabola([a, b, c]: [f64; 3], s: f64) -> f64 {
        (1.0 - s) * ((1.0 - s) * a + s * b) + s * ((1.0 - s) * b + s * c)
    }

    impl Ground {
        fn random(random: &mut impl FnMut() -> f64) -> Self {
            let mut three = |least: f64| {
                [0; 3].map(|_| if least > 0.0 { least.powf(random()) } else { random() })
            };
            let (k, mu, load) = (three(20.0), three(20.0), three(0.0));
            Ground { length: 3.0_f64.powf(random()), k, mu, load }
        }

        /// The largest (`sign` = 1) or smallest (`sign` = −1) value of the parabola `of` along the ground.
        fn most(&self, of: [f64; 3], sign: f64) -> f64 {
            let at = |i: usize| sign * parabola(of, i as f64 / COUNT as f64);
            sign * (0..=COUNT).map(at).fold(f64::NEG_INFINITY, f64::max)
        }

        /// Solves −(μy′)′ + ky = load with linear elements. `ends` has y at both ends; without it the ends
        /// are free. Returns y at the nodes and −μy′ at the left end.
        fn solve(&self, ends: Option<[f64; 2]>) -> (Vec<f64>, f64) {
            let h = self.length / COUNT as f64;
            let mut own = vec![0.0; COUNT + 1];
            let mut across = vec![0.0; COUNT];
            let mut load = vec![0.0; COUNT + 1];
            for i in 0..COUNT {
                let s = (i as f64 + 0.5) / COUNT as f64;
                let [k, mu, q] = [self.k, self.mu, self.load].map(|of| parabola(of, s));
                across[i] = k * h / 6.0 - mu / h;
                for node in [i, i + 1] {
                    own[node] += k * h / 3.0 + mu / h;
                    load[node] += 0.5 * q * h;
                }
            }
            let first = [own[0], across[0], load[0]];
            if let Some(ends) = ends {
                for (node, value) in [(0, ends[0]), (COUNT, ends[1])] {
                    own[node] = 1e30;
                    load[node] = 1e30 * value;
                }
            }
            for i in 0..COUNT {
                let factor = across[i] / own[i];
                own[i + 1] -= factor * across[i];
                load[i + 1] -= factor * load[i];
            }
            let mut y = vec![load[COUNT] / own[COUNT]; COUNT + 1];
            for i in (0..COUNT).rev() {
                y[i] = (load[i] - across[i] * y[i + 1]) / own[i];
            }
            let flux = first[0] * y[0] + first[1] * y[1] - first[2];
            (y, flux)
        }
    }

    /// Checks (13a) of docs/proof.md.
    #[test]
    fn the_flux_at_the_end_of_varying_ground_is_bounded() {
        let mut random = numbers();
        let mut largest: f64 = 0.0;
        for _ in 0..200 {
            let ground = Ground::random(&mut random);
            let (y, flux) = ground.solve(Some([random(), random()]));
            let most = y.iter().fold(0.0_f64, |most, y| most.max(y.abs()));
            let load = ground.most(ground.load, 1.0).max(-ground.most(ground.load, -1.0));
            let stiff = Size::of(ground.most(ground.mu, 1.0) * most);
            let load = Size::of(ground.most(ground.k, 1.0) * most + load);
            let bound = varying_flux(stiff, load, ground.length).value();
            assert!(flux.abs() <= bound, "{flux} {bound}");
            let along = |h: f64| 2.0 * stiff.value() / h + h * load.value();
            let lengths = (1..=1000).map(|i| ground.length * f64::from(i) / 1000.0);
            let least = lengths.map(along).fold(f64::INFINITY, f64::min);
            assert!((1.0 - 1e-4..1.0 + 1e-12).contains(&(bound / least)), "{bound} {least}");
            largest = largest.max(flux.abs() / bound);
        }
        assert!(largest > 0.3, "{largest}");
    }

    /// Checks (4a) of docs/proof.md: ‖Gρ‖_b² = ∫ρGρ.
    #[test]
    fn the_energy_of_a_residual_pressure_is_bounded_by_its_norm() {
        let mut random = numbers();
        let mut largest: f64 = 0.0;
        for _ in 0..200 {
            let ground = Ground::random(&mut random);
            let (y, _) = ground.solve(None);
            let h = ground.length / COUNT as f64;
            let at = |i: usize| parabola(ground.load, (i as f64 + 0.5) / COUNT as f64);
            let work: f64 = (0..COUNT).map(|i| 0.5 * h * at(i) * (y[i] + y[i + 1])).sum();
            let square: f64 = (0..COUNT).map(|i| h * at(i) * at(i)).sum();
            let bound = square / ground.most(ground.k, -1.0);
            assert!(work <= bound, "{work} {bound}");
            largest = largest.max(work / bound);
        }
        assert!(largest > 0.3, "{largest}");
    }

    /// Open ground with constant k and μ under a beam. C is the clearance, as a function of t.
    struct Open {
        length: f64,
        ground: [f64; 2],
        ends: [f64; 2],
        w: [f64; 4],
    }

    impl Open {
        fn random(random: &mut impl FnMut() -> f64) -> Self {
            let [length, k, mu] = [0; 3].map(|_| 10.0_f64.powf(random() - 0.3));
            let w = [0; 4].map(|_| random());
            let ends =
                [w[0] - w[1] + w[2] - w[3], w.iter().sum()].map(|w: f64| w + 1.5 * random().abs());
            Open { length, ground: [k, mu], ends, w }
        }

        fn piece(&self) -> OpenPiece<Ball> {
            let (x, w) = ([0.0, self.length], self.w.to_vec());
            let piece = Piece { x, half: 0.5 * self.length, deflection: w, ..Piece::default() };
            let units = Units { length: 0, force: 0 };
            let mut span = Span::of(&piece, x.map(Wide::of), units).expect("a piece");
            let [k, mu] = self.ground.map(|number| Coefficient::Even(Wide::of(number)));
            (span.spring, span.shear, span.layered) = (k, mu, true);
            OpenPiece::of(&span, self.ends.map(Wide::of), None, [Size::ZERO; 3])
        }

        /// C and C′, with C′ with respect to x.
        fn clearance(&self, t: f64) -> [f64; 2] {
            let b = (self.ground[0] / self.ground[1]).sqrt();
            let (half, whole) = (0.5 * self.length, (b * self.length).sinh());
            let [far, near] = [b * half * (1.0 - t), b * half * (1.0 + t)];
            let [left, right] = self.ends;
            let [c0, c1, c2, c3] = self.w;
            [
                (left * far.sinh() + right * near.sinh()) / whole
                    - (c0 + t * (c1 + t * (c2 + t * c3))),
                b * (right * near.cosh() - left * far.cosh()) / whole
                    - (c1 + t * (2.0 * c2 + t * 3.0 * c3)) / half,
            ]
        }

        /// The smallest value of a function of t on an interval.
        fn least([from, to]: [f64; 2], of: impl Fn(f64) -> f64) -> f64 {
            (0..=2000)
                .map(|i| of(from + (to - from) * f64::from(i) / 2000.0))
                .fold(f64::INFINITY, f64::min)
        }
    }

    /// The clearance of a random piece exceeds a limit, or it does not. The claim is right, and it is made unless the
    /// clearance is near the limit.
    #[test]
    fn a_clearance_above_a_limit_is_shown() {
        let mut random = numbers();
        let mut shown = 0;
        for _ in 0..400 {
            let (open, limit) = (Open::random(&mut random), 0.5 * random().abs());
            let interval = [-random().abs(), random().abs()];
            let least = Open::least(interval, |t| open.clearance(t)[0]);
            let clears = clear(&open.piece(), interval, Size::of(limit));
            assert!(
                if clears { least >= limit - 1e-12 } else { least < limit + 1e-4 },
                "{least} {limit}"
            );
            shown += i32::from(clears);
            assert!(!clear(&open.piece(), [interval[1], interval[0]], Size::ZERO));
        }
        assert!((50..350).contains(&shown), "{shown}");
    }

    /// The clearance of a random piece decreases towards one end faster than a limit, or it does not.
    #[test]
    fn a_fall_of_the_clearance_is_shown() {
        let mut random = numbers();
        let mut shown = 0;
        for i in 0..400 {
            let (open, limit, side) = (Open::random(&mut random), 0.5 * random().abs(), i % 2);
            let sign = if side == 0 { 1.0 } else { -1.0 };
            let interval = [-sign * random().abs(), -sign];
            let ordered = if side == 0 { [interval[1], interval[0]] } else { interval };
            let least = Open::least(ordered, |t| sign * open.clearance(t)[1]);
            let falling = falls(&open.piece(), side, interval, Size::of(limit));
            let right = if falling { least >= limit - 1e-12 } else { least < 1.05 * limit + 0.05 };
            assert!(right, "{least} {limit}");
            shown += i32::from(falling);
        }
        assert!((25..375).contains(&shown), "{shown}");
    }

    /// The curvature of the clearance of a random piece is at least its bound, which is sharp on short intervals.
    #[test]
    fn the_curvature_of_the_clearance_has_a_lower_bound() {
        let mut random = numbers();
        for _ in 0..400 {
            let open = Open::random(&mut random);
            let piece = open.piece();
            let (m, r) = (0.5 * random(), 0.5 * random().abs().powi(3));
            let (half, rate) = (0.5 * open.length, open.ground[0] / open.ground[1]);
            let curvature = |t: f64| {
                let w = open.w[0] + t * (open.w[1] + t * (open.w[2] + t * open.w[3]));
                let bent = (2.0 * open.w[2] + 6.0 * open.w[3] * t) / (half * half);
                rate * (open.clearance(t)[0] + w) - bent
            };
            let least = Open::least([m - r, m + r], curvature);
            let bound = piece.curvature(m, r, piece.settlement(m));
            // u″ changes by at most b² times the change of u.
            let change = rate * (open.clearance(m + r)[0] - open.clearance(m - r)[0]).abs();
            let most =
                least - 8.0 * r * (rate * rate + rate + 1.0) * (5.0 + 1.0 / half.powi(2)) - change;
            assert!(bound <= least + 1e-12 && bound >= most, "{bound} {least} {most}");
        }
    }

    /// The approach to x = 1 on the open piece from 1 to 2, with the same error bounds on all pieces: those of u and w, of the
    /// slope and of the pressure. Returns θ, the bound of the flux and μ|C′|.
    fn approach_at_one(model: &str, document: &Value, errors: [f64; 3]) -> Option<[f64; 3]> {
        with_fields(model, document, |fields| {
            let units = fields.frame.units;
            let [u, slope, p] = errors;
            let size = |x: f64, force: i32, length: i32| Size::of(units.scaled(x, force, length));
            let (settlement, slope, pressure) = (size(u, 0, 1), Size::of(slope), size(p, 1, -1));
            let deflection = settlement;
            let bounds =
                PieceBounds { settlement, deflection, slope, pressure, ..PieceBounds::EXACT };
            let bounds = vec![bounds; fields.frame.spans.len()];
            let contact = Contact { fields, bounds: &bounds };
            let found = contact.shown_open(1, &mut Vec::new())?[0].expect("an approach");
            let restored =
                |size: Size, force: i32, length: i32| units.restored(size.value(), force, length);
            Some([
                restored(found.theta, 0, 1),
                restored(found.flux, 1, 0),
                restored(found.steep, 1, 0),
            ])
        })
    }

    fn piece(ends: [f64; 2], touches: bool, w: &[f64]) -> Value {
        json!({"x": ends, "half": 0.5 * (ends[1] - ends[0]), "touches": touches, "deflection": w})
    }

    /// Endless ground with √(k/μ) = 2 and w = 3 − 2x: u = exp(2 − 2x), μ(u − w)″ = 2 at the edge. The error of the slope u′ is
    /// at most b coth(bL/2) ε_u at the end of the open length L = ½.
    #[test]
    fn the_error_of_an_edge_follows_from_the_errors_of_slope_and_settlement() {
        let model = "[beam]\nlength = 2\nEI = 1\n[foundation]\nk = 2\nmu = 0.5\nleft = { ends = 0, as = 'free' }\n";
        let document = json!({"pieces": [piece([0.0, 1.0], true, &[2.0, -1.0]), piece([1.0, 2.0], false, &[0.0, -1.0])]});
        for [error, slope] in [[1e-6, 1e-9], [1e-9, 1e-6], [1e-5, 1e-5], [0.02, 0.02]] {
            let found = approach_at_one(model, &document, [error, slope, 0.01]);
            let [theta, flux, steep] = found.expect("open ground");
            let exact = error / f64::tanh(0.5);
            assert!((1.0..1.0 + 1e-7).contains(&(flux / exact)), "{flux} {exact}");
            let ratio = theta / ((2.0 * exact + slope) / 4.0);
            assert!((1.0..2.3).contains(&ratio), "{error} {slope}: {ratio}");
            assert!(steep < 1e-14);
        }
        for (pressure, shown) in [(1.99, true), (2.01, false)] {
            let found = approach_at_one(model, &document, [1e-6, 1e-6, pressure]);
            assert_eq!(found.is_some(), shown, "{pressure}");
        }
    }

    /// The same with contact on both sides of the open piece, between hinges: L = ½.
    #[test]
    fn half_of_an_open_length_between_regions_is_open() {
        let model = "[beam]\nlength = 3\nEI = 1\n[foundation]\nk = 0.01\nmu = 1\n[[hinge]]\nat = 1\n[[hinge]]\nat = 2\n";
        let w = [
            piece([0.0, 1.0], true, &[0.75, 0.0]),
            piece([1.0, 2.0], false, &[0.5, 0.0, 0.25]),
            piece([2.0, 3.0], true, &[0.75]),
        ];
        let found = approach_at_one(model, &json!({"pieces": w}), [1e-6, 1e-9, 1e-6]);
        let [theta, flux, steep] = found.expect("open ground");
        let exact = 0.1 * 1e-6 / f64::tanh(0.1 * 0.25);
        assert!((1.0..1.0 + 1e-6).contains(&(flux / exact)), "{flux} {exact}");
        assert!(theta == 0.0 && (0.9..1.0).contains(&steep), "{theta} {steep}");
    }

    /// μ = 1 + x and the stored u = 2 − x + ¼(x − 1)², with w = 2 − x. Then ku − (μu′)′ is at most 1 on the open piece, and ku −
    /// (μw′)′ = 2 at the edge.
    #[test]
    fn the_error_of_an_edge_of_varying_ground_contains_its_residual() {
        let model = "[beam]\nlength = 2\nEI = 1\n[foundation]\nk = 1\nmu = 1\nleft = { ends = 0, as = 'free' }\n\
            [[foundation.segment]]\nfrom = 0\nto = 2\nk = 1\nmu = [1, 3]\n";
        let mut open = piece([1.0, 2.0], false, &[0.5, -0.5]);
        (open["open"], open["settlement"]) = (json!([1, 0.25]), json!([0.5625, -0.375, 0.0625]));
        let document = json!({"pieces": [piece([0.0, 1.0], true, &[1.5, -0.5]), open]});
        for error in [1e-4, 1e-6, 1e-3] {
            let found = approach_at_one(model, &document, [error, 1e-9, 0.01]);
            let ratio =
                found.expect("open ground")[1] / (2.0 * (2.0 * 3.0 * error * (1.0 + error)).sqrt());
            assert!((1.0..1.0 + 1e-7).contains(&ratio), "{error}: {ratio}");
        }
        for (pressure, shown) in [(1.99, true), (2.01, false)] {
            let found = approach_at_one(model, &document, [1e-9, 1e-9, pressure]);
            assert_eq!(found.is_some(), shown, "{pressure}");
        }
    }
}
