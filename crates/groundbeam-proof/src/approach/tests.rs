//! Compares bounds of clearance and ground displacement on pieces without contact with sampled values and closed forms.

#![cfg(test)]

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

/// A stretch of varying ground. Its k, μ and load are parabolas, given by Bernstein coefficients.
struct Ground {
    length: f64,
    k: [f64; 3],
    mu: [f64; 3],
    load: [f64; 3],
}

/// Returns the value at s of the parabola with these Bernstein coefficients.
fn parabola([a, b, c]: [f64; 3], s: f64) -> f64 {
    (1.0 - s) * ((1.0 - s) * a + s * b) + s * ((1.0 - s) * b + s * c)
}

impl Ground {
    fn random(random: &mut impl FnMut() -> f64) -> Self {
        let mut three =
            |least: f64| [0; 3].map(|_| if least > 0.0 { least.powf(random()) } else { random() });
        let (k, mu, load) = (three(20.0), three(20.0), three(0.0));
        Ground { length: 3.0_f64.powf(random()), k, mu, load }
    }

    /// Returns the largest (`sign` = 1) or smallest (`sign` = −1) value of the parabola `of` on the stretch.
    fn most(&self, of: [f64; 3], sign: f64) -> f64 {
        let at = |i: usize| sign * parabola(of, i as f64 / COUNT as f64);
        sign * (0..=COUNT).map(at).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Solves −(μy′)′ + ky = `load` with linear elements. `ends` prescribes y at both ends; without `ends`, both ends
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

/// Checks the bound (13a) of docs/proof.md for the force μy′ in the shear layer at the end of a stretch with varying k
/// and μ. Here y is the error of the ground displacement.
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

/// Checks the bound (4a) of docs/proof.md for the energy of the ground under a residual pressure.
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

/// Open ground with constant k and μ under a beam. The deflection w is a cubic polynomial of the coordinate t, which is
/// −1 and 1 at the ends.
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

    /// Returns the clearance C at the local coordinate t of the piece, and its derivative dC/dx, where x is the
    /// position along the beam.
    fn clearance(&self, t: f64) -> [f64; 2] {
        let b = (self.ground[0] / self.ground[1]).sqrt();
        let (half, whole) = (0.5 * self.length, (b * self.length).sinh());
        let [far, near] = [b * half * (1.0 - t), b * half * (1.0 + t)];
        let [left, right] = self.ends;
        let [c0, c1, c2, c3] = self.w;
        [
            (left * far.sinh() + right * near.sinh()) / whole - (c0 + t * (c1 + t * (c2 + t * c3))),
            b * (right * near.cosh() - left * far.cosh()) / whole
                - (c1 + t * (2.0 * c2 + t * 3.0 * c3)) / half,
        ]
    }

    /// Returns the smallest value of a function of t on an interval.
    fn least([from, to]: [f64; 2], of: impl Fn(f64) -> f64) -> f64 {
        (0..=2000)
            .map(|i| of(from + (to - from) * f64::from(i) / 2000.0))
            .fold(f64::INFINITY, f64::min)
    }
}

/// Checks on random pieces: if `clear` returns true, the clearance is at least the limit. If it returns false, the
/// clearance is below the limit or exceeds the limit by less than 10⁻⁴.
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

/// Checks on random pieces that `falls` agrees with the smallest rate of decrease, except for rates slightly above
/// `limit`.
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

/// Checks the lower bound of the curvature of the clearance on random pieces. The bound must be sharp on short
/// intervals.
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
        // The ground displacement satisfies u″ = (k/μ)u, so a change of u causes a change of u″ that is k/μ times as
        // large.
        let change = rate * (open.clearance(m + r)[0] - open.clearance(m - r)[0]).abs();
        let most =
            least - 8.0 * r * (rate * rate + rate + 1.0) * (5.0 + 1.0 / half.powi(2)) - change;
        assert!(bound <= least + 1e-12 && bound >= most, "{bound} {least} {most}");
    }
}

/// Returns `theta`, `flux` and `steep` of the `Approach` at x = 1, the left end of the second piece.
///
/// `errors` are bounds for all pieces: of deflection and ground displacement, of the slope, and of the pressure.
fn approach_at_one(model: &str, document: &Value, errors: [f64; 3]) -> Option<[f64; 3]> {
    with_fields(model, document, |fields| {
        let units = fields.frame.units;
        let [u, slope, p] = errors;
        let size = |x: f64, force: i32, length: i32| Size::of(units.scaled(x, force, length));
        let (settlement, slope, pressure) = (size(u, 0, 1), Size::of(slope), size(p, 1, -1));
        let deflection = settlement;
        let bounds = PieceBounds { settlement, deflection, slope, pressure, ..PieceBounds::EXACT };
        let bounds = vec![bounds; fields.frame.spans.len()];
        let contact = Contact { fields, bounds: &bounds };
        let found = contact.shown_open(1, &mut Vec::new())?[0].expect("an approach");
        let restored =
            |size: Size, force: i32, length: i32| units.restored(size.value(), force, length);
        Some([restored(found.theta, 0, 1), restored(found.flux, 1, 0), restored(found.steep, 1, 0)])
    })
}

fn piece(ends: [f64; 2], touches: bool, w: &[f64]) -> Value {
    json!({"x": ends, "half": 0.5 * (ends[1] - ends[0]), "touches": touches, "deflection": w})
}

/// For w = 3 − 2x with contact up to x = 1, and the ground displacement u = exp(2 − 2x) beyond, μ(u − w)″ = 2 at x = 1.
/// The error bound of the force is (13) of docs/proof.md with L = ½.
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

/// Checks an open piece of length 1 between two regions of contact. The error bound of the flux is (13) of
/// docs/proof.md with half of this length.
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

/// On the open piece from x = 1, the ground displacement u = 2 − x + ¼(x − 1)² has a residual of at most 1 for k = 1
/// and μ = 1 + x. With w = 2 − x, the pressure ku − (μw′)′ at x = 1 is 2.
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
