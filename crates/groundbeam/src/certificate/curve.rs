//! How far a smooth function may fall below zero on an interval: bounded, never sampled.

use crate::numeric::polynomial::jet;

/// A function of s ∈ \[−1, 1\] at one point, and what bounds it nearby.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    pub s: f64,
    pub value: f64,
    pub slope: f64,
    /// The second derivative is at least `bend − turn·|t| − rest·t²` at a distance t.
    pub bend: f64,
    pub turn: f64,
}

/// A function that is bounded from below by parabolas.
pub(super) trait Curve {
    fn at(&self, s: f64) -> Point;
    /// What the second derivative falls by beyond a point's own `turn`, over the distance squared.
    fn rest(&self) -> f64;
    /// Rounding of its values and of its slopes.
    fn noise(&self) -> [f64; 2];
}

/// Halvings of a piece.
const DEEPEST: u32 = 24;

/// How deep the function may lie below zero between two points.
pub(super) fn depth(curve: &impl Curve, a: &Point, b: &Point, halvings: u32) -> f64 {
    let [noise, tilt] = curve.noise();
    let middle = curve.at(0.5 * (a.s + b.s));
    let (width, half) = (b.s - a.s, 0.5 * (b.s - a.s));
    let bend = least_bend(curve, &middle, half);
    let from_left = lowest(a.value, a.slope - tilt, bend, width);
    let from_right = lowest(b.value, -b.slope - tilt, bend, width);
    let to_left = lowest(middle.value, -middle.slope - tilt, bend, half);
    let to_right = lowest(middle.value, middle.slope - tilt, bend, half);
    let bound = noise - from_left.max(from_right).max(to_left.min(to_right));
    // Below the noise nothing is worth halving on; and a depth that is found is no bound's fault.
    let found = -middle.value.min(a.value).min(b.value);
    if bound <= 4.0 * noise || bound <= 1.5 * found || halvings >= DEEPEST || bound.is_nan() {
        return if bound.is_nan() { f64::INFINITY } else { bound.max(0.0) };
    }
    depth(curve, a, &middle, halvings + 1).max(depth(curve, &middle, b, halvings + 1))
}

/// How deep it may lie below zero on all of \[−1, 1\].
pub(super) fn depth_of(curve: &impl Curve) -> f64 {
    depth(curve, &curve.at(-1.0), &curve.at(1.0), 0)
}

/// Next to a point where the function is zero.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Edge {
    /// It lies above −fall·t at a distance t up to `reach`,
    pub fall: f64,
    pub reach: f64,
    /// and above zero from here on.
    pub until: f64,
    /// How deep it may lie below zero beyond `reach`.
    pub depth: f64,
}

/// From an edge at `a` to `b`, on either side of it; near the edge the function is steeper than it is by
/// what it is off zero there over the reach.
pub(super) fn edge(curve: &impl Curve, a: &Point, b: &Point, halvings: u32) -> Edge {
    let [noise, tilt] = curve.noise();
    let middle = curve.at(0.5 * (a.s + b.s));
    let reach = (b.s - a.s).abs();
    let bend = least_bend(curve, &middle, 0.5 * reach);
    let inward = if b.s > a.s { a.slope } else { -a.slope };
    let off = (a.value.abs() + noise) / reach;
    let fall = -(inward - tilt - off + bend.min(0.0) * reach);
    // What rounding or the edge's own fault explains is not worth halving on.
    let explained = fall <= 4.0 * (off + tilt);
    if fall <= 0.0 || bend > 0.0 || explained || halvings >= DEEPEST {
        let fall = fall.max(0.0);
        let until = if bend > 0.0 { reach.min(2.0 * fall / bend) } else { reach };
        return Edge { fall, reach, until, depth: 0.0 };
    }
    let near = edge(curve, a, &middle, halvings + 1);
    let far = if b.s > a.s {
        depth(curve, &middle, b, halvings + 1)
    } else {
        depth(curve, b, &middle, halvings + 1)
    };
    Edge { depth: near.depth.max(far), ..near }
}

fn least_bend(curve: &impl Curve, middle: &Point, half: f64) -> f64 {
    middle.bend - half * (middle.turn + half * curve.rest())
}

/// The least of value + slope·t + ½ bend·t² for 0 ≤ t ≤ width.
fn lowest(value: f64, slope: f64, bend: f64, width: f64) -> f64 {
    if slope < 0.0 && -slope < bend * width {
        value - 0.5 * slope * (slope / bend)
    } else {
        value.min(value + width * (slope + 0.5 * bend * width))
    }
}

/// A polynomial.
pub(super) struct Polynomial<'a> {
    coefficients: &'a [f64],
    rest: f64,
    noise: [f64; 2],
}

impl<'a> Polynomial<'a> {
    /// How deep a polynomial may lie below zero: not at all where the constant exceeds all other terms.
    pub fn depth(coefficients: &'a [f64]) -> f64 {
        let [size, _] = sizes(coefficients);
        let constant = coefficients.first().copied().unwrap_or(0.0);
        if 2.0 * constant - size > ROUNDING * size {
            return 0.0;
        }
        depth_of(&Polynomial::new(coefficients))
    }

    pub fn new(coefficients: &'a [f64]) -> Self {
        Polynomial { coefficients, rest: 0.5 * fourth(coefficients), noise: rounding(coefficients) }
    }
}

impl Curve for Polynomial<'_> {
    fn at(&self, s: f64) -> Point {
        let [value, slope, bend, third] = jet(self.coefficients, s);
        Point { s, value, slope, bend, turn: third.abs() }
    }

    fn rest(&self) -> f64 {
        self.rest
    }

    fn noise(&self) -> [f64; 2] {
        self.noise
    }
}

/// A bound of the fourth derivative on \[−1, 1\].
pub(super) fn fourth(c: &[f64]) -> f64 {
    let falling = |j: usize| (j * (j - 1) * (j - 2) * (j - 3)) as f64;
    c.iter().enumerate().skip(4).map(|(j, c)| falling(j) * c.abs()).sum()
}

/// Rounding of a polynomial's values and of its slopes on \[−1, 1\].
pub(super) fn rounding(c: &[f64]) -> [f64; 2] {
    sizes(c).map(|sum| ROUNDING * sum)
}

/// What the terms of a polynomial and of its derivative add up to at most on \[−1, 1\].
fn sizes(c: &[f64]) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for (j, c) in c.iter().enumerate() {
        sums[0] += c.abs();
        sums[1] += j as f64 * c.abs();
    }
    sums
}

/// Rounding of a sum, relative to its terms' sizes.
pub(super) const ROUNDING: f64 = 2.0 * f64::EPSILON;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_double_root_is_no_depth() {
        // (s − 0.3)²: zero at one point, never below.
        assert!(depth_of(&Polynomial::new(&[0.09, -0.6, 1.0])) < 1e-14);
        let deep = depth_of(&Polynomial::new(&[0.09 - 1e-6, -0.6, 1.0]));
        assert!((1e-6..1.6e-6).contains(&deep), "{deep:e}");
    }

    #[test]
    fn an_edge_of_contact() {
        // t² − 2εt + t³ at t = s + 1.
        let tilt = 1e-12;
        let c = [2.0 - 2.0 * tilt, 5.0 - 2.0 * tilt, 4.0, 1.0];
        let curve = Polynomial::new(&c);
        let found = edge(&curve, &curve.at(-1.0), &curve.at(0.0), 0);
        assert!(found.fall < 1e-11 && found.until < 1e-11 && found.depth < 1e-20, "{found:?}");
        // The same edge seen in a mirror.
        let mirrored = [c[0], -c[1], c[2], -c[3]];
        let curve = Polynomial::new(&mirrored);
        let mirrored = edge(&curve, &curve.at(1.0), &curve.at(0.0), 0);
        assert_eq!(mirrored.fall, found.fall);
    }
}
