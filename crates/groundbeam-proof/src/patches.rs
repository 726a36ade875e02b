//! The fields of a claimed solution as polynomials on short stretches, for comparison with the numbers in a document.
//!
//! On each stretch, every field is a polynomial in the distance from the middle of the stretch. The settlement of a
//! shear layer out of contact is a Taylor polynomial. The radius of its constant coefficient includes the remainder.

use crate::fields::Fields;
use crate::frame::Span;
use crate::polynomial::Polynomial;
use crate::scalar::Scalar;
use crate::size::Size;

/// Name of each field in a result document, with the exponents of force and length in its unit.
pub(crate) const FIELDS: [(&str, i32, i32); 8] = [
    ("deflection", 0, 1),
    ("slope", 0, 0),
    ("rotation", 0, 0),
    ("moment", 1, 1),
    ("shear_force", 1, 0),
    ("settlement", 0, 1),
    ("gap", 0, 1),
    ("pressure", 1, -1),
];

/// The indices of some fields in [`FIELDS`].
pub(crate) const ROTATION: usize = 2;
pub(crate) const MOMENT: usize = 3;
pub(crate) const GAP: usize = 6;
pub(crate) const PRESSURE: usize = 7;

/// The index in [`FIELDS`] of the field with this name.
pub(crate) fn field_named(name: &str) -> Option<usize> {
    FIELDS.iter().position(|(known, ..)| *known == name)
}

/// Maximum number of stretches on one piece out of contact. If a fast decay of the settlement needs more, the remainder
/// of the Taylor series is large and nothing is proven.
const MOST: usize = 2000;
/// Maximum number of stretches out of contact on the whole beam. Each piece has at least one.
const MOST_OF_ALL: usize = 20_000;
/// Maximum length of a stretch out of contact, in decay lengths √(μ/k).
const LONGEST: f64 = 4.0;
/// Number of coefficients of the Taylor polynomial of the settlement out of contact.
const TERMS: usize = 26;

/// Polynomials of all fields on one stretch of a piece.
#[derive(Debug)]
pub(crate) struct Patch<S> {
    /// The middle m of the stretch, in the coordinate t of the piece.
    pub middle: f64,
    /// An interval that contains s = t − m at every point of the stretch. Here t is the coordinate of the piece, and
    /// m is its value at the middle of the stretch.
    pub interval: [f64; 2],
    /// The fields in the order of [`FIELDS`], as polynomials of s = t − m. Here t is the coordinate of the piece, and
    /// m is its value at the middle of the stretch.
    pub fields: [Polynomial<S>; 8],
}

/// The fields of all pieces.
#[derive(Debug)]
pub(crate) struct Patches<S> {
    /// The stretches of each piece, from left to right.
    pub pieces: Vec<Vec<Patch<S>>>,
}

impl<S: Scalar> Patches<S> {
    pub fn of(fields: &Fields<S>) -> Self {
        Patches { pieces: (0..fields.frame.spans.len()).map(|i| patches(fields, i)).collect() }
    }

    /// The value of a field at the coordinate t of a piece.
    pub fn value(&self, field: usize, piece: usize, t: S) -> S {
        let patches = &self.pieces[piece];
        let after = patches.partition_point(|patch| patch.middle <= t.middle());
        let distance = |i: usize| (t.middle() - patches[i].middle).abs();
        let nearest = match after {
            0 => 0,
            _ if after == patches.len() || distance(after - 1) <= distance(after) => after - 1,
            _ => after,
        };
        let patch = &patches[nearest];
        patch.fields[field].value(t - S::of(patch.middle))
    }
}

fn patches<S: Scalar>(fields: &Fields<S>, i: usize) -> Vec<Patch<S>> {
    let span = &fields.frame.spans[i];
    let [from, to] = span.interval();
    let Some(ends) = fields.surface.pieces[i].open else {
        let own = match span.free_field() {
            _ if span.touches => span.obstacle(),
            Some(free) => Polynomial::zero() + &free,
            None => Polynomial::zero(),
        };
        return vec![patch(fields, i, 0.0, [from, to], &own)];
    };
    if let Some(own) = &fields.surface.pieces[i].along {
        return vec![patch(fields, i, 0.0, [from, to], own)];
    }
    let surface = Surface::of(span, span.above_free_ends(ends));
    let count = stretches(surface.decay.high() * (to - from), fields.frame.spans.len());
    let last = count as usize - 1;
    let end = |n: usize| from + (to - from) * (n as f64 / count);
    let on_stretch = |n: usize| {
        let ends = [end(n), if n == last { to } else { end(n + 1) }];
        let middle = 0.5 * (ends[0] + ends[1]);
        let interval = [(ends[0] - middle).next_down(), (ends[1] - middle).next_up()];
        // A position that is outside the stretch only by rounding error counts as inside.
        let r = interval[1] * (1.0 + 1e-9);
        let above = surface.taylor(middle, r);
        let own = span.free_field().map_or(above, |free| above + &free.shifted(middle));
        patch(fields, i, middle, interval, &own)
    };
    (0..=last).map(on_stretch).collect()
}

/// Returns the number of stretches of a piece out of contact. `length` is its length in decay lengths, and `pieces` is
/// the number of pieces of the beam.
fn stretches(length: f64, pieces: usize) -> f64 {
    let count = (length / LONGEST).ceil();
    let most = (MOST_OF_ALL / pieces).clamp(1, MOST) as f64;
    if (1.0..=most).contains(&count) { count } else { most }
}

/// Returns all fields on a stretch as polynomials in s = t − `middle`, where t is the coordinate of the piece. `own` is the
/// settlement of the ground as a polynomial in s.
fn patch<S: Scalar>(
    fields: &Fields<S>,
    i: usize,
    middle: f64,
    interval: [f64; 2],
    own: &Polynomial<S>,
) -> Patch<S> {
    let span = &fields.frame.spans[i];
    let deflection = span.deflection.shifted(middle);
    let slope = span.derivative(&span.deflection);
    let rotation = span.rotation.as_deref().unwrap_or(&slope);
    let moment = span.bending_moment(rotation);
    // In result documents the shear force is V = M′, also under distributed moments.
    let shear_force = span.derivative(&moment);
    let gap = match span.touches {
        true => Polynomial::zero(),
        false => *own + &span.gap.shifted(middle) - &deflection,
    };
    let pressure = fields.pressures[i].field.shifted(middle);
    let [slope, rotation, moment, shear_force] =
        [slope, *rotation, moment, shear_force].map(|field| field.shifted(middle));
    let fields = [deflection, slope, rotation, moment, shear_force, *own, gap, pressure];
    Patch { middle, interval, fields }
}

/// Settlement v of the ground below a piece out of contact, minus the free-field settlement. k and μ are constant, so
/// μv″ = kv.
struct Surface<'a, S> {
    span: &'a Span<S>,
    ends: [S; 2],
    /// √(k/μ).
    rate: S,
    /// Decay rate of the settlement with respect to the coordinate t of the piece: √(k/μ) times half the length of the piece.
    decay: S,
}

impl<'a, S: Scalar> Surface<'a, S> {
    fn of(span: &'a Span<S>, ends: [S; 2]) -> Self {
        let rate = span.spring.least().div(span.shear.least()).sqrt();
        Surface { span, ends, rate, decay: rate * span.half }
    }

    /// The Taylor polynomial of the settlement v about t = m, for |t − m| ≤ r. The radius of the constant coefficient
    /// includes the bound max|v|(qr)ⁿ/n! of the remainder, with the decay rate q and the number n of terms.
    fn taylor(&self, m: f64, r: f64) -> Polynomial<S> {
        let span = self.span;
        let at = span.middle + span.half * S::of(m);
        let [near, far] = [at - span.x[0], span.x[1] - at].map(|d| self.rate * d);
        let two = |x: S| (-x.scaled(1)).expm1();
        let whole = two(self.rate * span.h);
        // `sinh` computes sinh(a)/sinh(z), and `cosh` computes cosh(a)/sinh(z), with z = a + b.
        let sinh = |a: S, b: S| ((-b).expm1() + S::one()) * two(a).div(whole);
        let cosh = |a: S, b: S| -(((-b).expm1() + S::one()) * (two(a) + S::of(2.0)).div(whole));
        let [left, right] = self.ends;
        let value = left * sinh(far, near) + right * sinh(near, far);
        let slope = right * cosh(near, far) - left * cosh(far, near);
        let mut terms = [value, slope];
        let mut coefficients = Vec::with_capacity(TERMS);
        let mut power = S::one();
        for n in 0..TERMS {
            coefficients.push(terms[n % 2] * power);
            power = (power * self.decay).div(S::of((n + 1) as f64));
        }
        // |v| is largest at an end. `TERMS` is even, so the derivative of this order is a multiple of v.
        terms = self.ends;
        let largest = Size::of(terms[0].size()).worst(Size::of(terms[1].size()));
        let mut reach = Size::of(power.size());
        for _ in 0..TERMS {
            reach = Size::of(r) * reach;
        }
        let rest = largest * reach;
        coefficients[0] = coefficients[0].widened(rest.value());
        Polynomial::from_coefficients(coefficients)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::given_claim::with_fields;
    use crate::wide::Wide;
    use serde_json::json;

    /// Checks that the interval of `x` contains zero and has at most the given width.
    fn is_zero(what: &str, x: impl Scalar, width: f64) {
        let [low, high] = [x.low(), x.high()];
        assert!(low <= 0.0 && 0.0 <= high && high - low <= width, "{what}: {low:e} {high:e}");
    }

    /// The Taylor polynomial of v = (3 sinh(b(1 − x)) + 2 sinh(bx))/sinh(b) must contain v at other positions. Its
    /// radius must be at most twice the bound of the remainder.
    #[test]
    fn the_taylor_polynomial_of_open_ground_contains_it() {
        for b in [0.5_f64, 2.0, 32.0] {
            let model =
                format!("[beam]\nlength = 1\nEI = 1\n[foundation]\nk = {}\nmu = 2\n", 2.0 * b * b);
            let piece = json!({"x": [0, 1], "half": 0.5, "touches": false, "deflection": [0]});
            with_fields(&model, &json!({"pieces": [piece]}), |fields| {
                let ends = [3.0, 2.0].map(Wide::of);
                let surface = Surface::of(&fields.frame.spans[0], ends);
                let at = |t: f64| surface.taylor(t, 0.0).coefficient(0);
                is_zero("left end", at(-1.0) - ends[0], 1e-27);
                is_zero("right end", at(1.0) - ends[1], 1e-27);
                let middle = 5.0 / (2.0 * (0.5 * b).cosh());
                assert!((at(0.0).middle() / middle - 1.0).abs() < 1e-14, "{b}");
                let r = if b > 4.0 { LONGEST / b } else { 1.0 };
                let rest = (1..=TERMS).fold(3.0, |rest, n| rest * 0.5 * b * r / n as f64);
                for m in [-1.0 + r, 1.0 - r, 0.3 * (1.0 - r)] {
                    let near = surface.taylor(m, r);
                    for s in [-r, -0.5 * r, 0.5 * r, r] {
                        let off = near.value(Wide::of(s)) - at(m + s);
                        is_zero(&format!("{b} {m} {s}"), off, 4.0 * rest + 1e-27);
                    }
                }
            });
        }
    }

    /// A stretch is at most four decay lengths long, unless this would exceed the maximum number of stretches of a
    /// piece or of the whole beam.
    #[test]
    fn a_piece_has_as_many_stretches_as_its_decay_needs() {
        for (length, pieces, count) in [
            (0.1, 1, 1.0),
            (4.0, 1, 1.0),
            (4.1, 1, 2.0),
            (18.0, 1, 5.0),
            (8000.0, 10, 2000.0),
            (8001.0, 10, 2000.0),
            (8000.0, 16, 1250.0),
            (1e9, 16, 1250.0),
            (1e9, 20_000, 1.0),
            (1e9, 50_000, 1.0),
            (f64::NAN, 16, 1250.0),
        ] {
            assert_eq!(stretches(length, pieces), count, "{length} {pieces}");
        }
    }

    /// Checks that the stretches cover the piece, and that their settlement polynomials contain the exact settlement of
    /// loaded ground.
    #[test]
    fn all_stretches_contain_the_surface_of_loaded_ground() {
        for (b, count) in [(1.0_f64, 1), (31.0, 8)] {
            let model = format!(
                "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = {}\nmu = 1\n\
                 [[ground_load]]\ndistributed = [1, 2]\nfrom = 0\nto = 1\n",
                b * b
            );
            let piece = json!({"x": [0, 1], "half": 0.5, "touches": false, "deflection": [0]});
            with_fields(&model, &json!({"pieces": [piece]}), |fields| {
                let span = &fields.frame.spans[0];
                let ends = fields.surface.pieces[0].open.expect("open ground");
                let surface = Surface::of(span, span.above_free_ends(ends));
                let free = span.free_field().expect("a load on the ground");
                let all = patches(fields, 0);
                assert_eq!(all.len(), count);
                let mut to = -1.0;
                for patch in &all {
                    let [low, high] = patch.interval;
                    assert!(patch.middle + low <= to && patch.middle + high > to, "{b}");
                    to = patch.middle + high;
                    for s in [low, 0.0, high] {
                        let t = patch.middle + s;
                        let above = surface.taylor(t, 0.0).coefficient(0);
                        let exact = above + free.value(Wide::of(t));
                        let found = patch.fields[5].value(Wide::of(t - patch.middle));
                        is_zero(&format!("{b} {t}"), found - exact, 1e-17);
                    }
                }
                assert!(to >= 1.0);
                let all = Patches { pieces: vec![all] };
                for step in -50..=50 {
                    let t = Wide::of(0.02 * f64::from(step));
                    let above = surface.taylor(t.middle(), 0.0).coefficient(0);
                    let off = all.value(5, 0, t) - above - free.value(t);
                    is_zero(&format!("{b} {step}"), off, 1e-17);
                }
            });
        }
    }
}
