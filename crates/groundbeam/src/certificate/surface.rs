//! The ground under one piece of the beam, from the model's own constants.

use super::ClaimedPiece;
use super::curve::{Curve, Point, ROUNDING, fourth, rounding};
use crate::model::Model;
use crate::polynomial::jet;

#[derive(Debug, Clone, Copy)]
pub(super) struct Under<'a> {
    pub piece: &'a ClaimedPiece<'a>,
    pub half: f64,
    pub spring: f64,
    pub shear: f64,
    gap: [f64; 2],
    /// Half of what g₀ rises by.
    rise: f64,
    open: Option<Open>,
}

/// u = (left sinh(b(h − ξ)) + right sinh(bξ))/sinh(bh) about the middle: an even part cosh and an odd
/// part sinh, each scaled by its value at the ends.
#[derive(Debug, Clone, Copy)]
struct Open {
    mean: f64,
    rise: f64,
    /// b, b h/2 and its tanh; e^(−bh).
    b: f64,
    z: f64,
    tanh: f64,
    faded: f64,
    /// u is nowhere less.
    floor: f64,
}

impl<'a> Under<'a> {
    pub fn new(model: &Model, piece: &'a ClaimedPiece) -> Self {
        let [from, to] = piece.x;
        let (spring, shear) = model.foundation.constants_at(0.5 * (from + to));
        let (gap, rise) = if model.gap.is_empty() {
            ([0.0; 2], 0.0)
        } else {
            let slope = initial_slope(model, 0.5 * (from + to));
            (piece.x.map(|x| initial_gap(model, x)), slope * piece.half)
        };
        let open = piece.open.map(|[left, right]| {
            if shear == 0.0 {
                return Open {
                    mean: 0.0,
                    rise: 0.0,
                    b: 0.0,
                    z: 0.0,
                    tanh: 0.0,
                    faded: 1.0,
                    floor: 0.0,
                };
            }
            let b = (spring / shear).sqrt();
            let z = b * piece.half;
            Open {
                mean: 0.5 * (left + right),
                rise: 0.5 * (right - left),
                b,
                z,
                tanh: z.tanh(),
                faded: (-2.0 * z).exp(),
                floor: left.min(right).min(0.0),
            }
        });
        Under { piece, half: piece.half, spring, shear, gap, rise, open }
    }

    /// Whether the ground is free here.
    pub fn is_open(&self) -> bool {
        self.open.is_some()
    }

    pub fn from(&self) -> f64 {
        self.piece.x[0]
    }

    pub fn gap(&self, s: f64) -> f64 {
        0.5 * ((1.0 - s) * self.gap[0] + (1.0 + s) * self.gap[1])
    }

    /// u and u' where the beam has w and dw/ds.
    pub fn surface(&self, s: f64, w: f64, dw: f64) -> [f64; 2] {
        self.open
            .map_or_else(|| [w - self.gap(s), (dw - self.rise) / self.half], |open| open.surface(s))
    }

    /// ∫(k u² + μ u'²) of open ground: what its ends do, u μu' at the right less the same at the left.
    pub fn energy(&self) -> f64 {
        let [left, right] = [-1.0, 1.0].map(|s| self.open.map_or([0.0; 2], |open| open.surface(s)));
        self.shear * (right[0] * right[1] - left[0] * left[1])
    }

    /// u, u' and the clearance at an end.
    pub fn end(&self, s: f64) -> [f64; 3] {
        let [w, dw, ..] = jet(self.piece.deflection, s);
        let [u, du] = self.surface(s, w, dw);
        [u, du, if self.is_open() { u + self.gap(s) - w } else { 0.0 }]
    }
}

impl Open {
    fn surface(&self, s: f64) -> [f64; 2] {
        if self.b == 0.0 {
            return [0.0; 2];
        }
        let a = (self.z * s).abs();
        let near = (a - self.z).exp();
        let less = (-2.0 * a).exp_m1();
        let even = near * (2.0 + less) / (1.0 + self.faded);
        if self.z < 1e-8 {
            return [self.mean * even + self.rise * s, self.b * (self.rise / self.z)];
        }
        let odd = (-near * less / (1.0 - self.faded)).copysign(s);
        let slope = self.mean * self.tanh * odd + self.rise * (even / self.tanh);
        [self.mean * even + self.rise * odd, self.b * slope]
    }
}

/// u + g₀ − w over open ground.
pub(super) struct Clearance<'a> {
    under: &'a Under<'a>,
    open: Open,
    /// (b h/2)²: the ground's curvature for its deflection.
    curvature: f64,
    rest: f64,
    noise: [f64; 2],
}

impl<'a> Clearance<'a> {
    pub fn of(under: &'a Under<'a>) -> Option<Self> {
        let open = under.open?;
        let [value, slope] = rounding(under.piece.deflection);
        let ground = open.mean.abs() + open.rise.abs();
        let gap = under.gap[0].abs().max(under.gap[1].abs());
        let steep = if open.z > 0.0 {
            open.z * open.mean.abs() + open.rise.abs() * (1.0 + open.z)
        } else {
            0.0
        };
        Some(Clearance {
            under,
            open,
            curvature: open.z * open.z,
            rest: 0.5 * fourth(under.piece.deflection),
            noise: [
                value + ROUNDING * (ground + gap),
                slope + ROUNDING * (steep + under.rise.abs()),
            ],
        })
    }
}

impl Curve for Clearance<'_> {
    fn at(&self, s: f64) -> Point {
        let under = self.under;
        let [w, dw, bend, third] = jet(under.piece.deflection, s);
        let [u, du] = self.open.surface(s);
        let du = du * under.half;
        // The ground is convex where it is not negative: it lies above its tangent.
        let (least, turn) =
            if self.open.floor < 0.0 { (self.open.floor, 0.0) } else { (u, du.abs()) };
        Point {
            s,
            value: u + under.gap(s) - w,
            slope: du + under.rise - dw,
            bend: self.curvature * least - bend,
            turn: self.curvature * turn + third.abs(),
        }
    }

    fn rest(&self) -> f64 {
        self.rest
    }

    fn noise(&self) -> [f64; 2] {
        self.noise
    }
}

/// g₀(x): linear between corners, constant beyond them.
fn initial_gap(model: &Model, x: f64) -> f64 {
    let corners = &model.gap;
    let right = corners.partition_point(|corner| corner.at < x);
    match (right.checked_sub(1).map(|i| corners[i]), corners.get(right)) {
        (Some(a), Some(b)) => {
            let t = (x - a.at) / (b.at - a.at);
            a.value * (1.0 - t) + b.value * t
        }
        (Some(only), None) => only.value,
        (None, Some(only)) => only.value,
        (None, None) => 0.0,
    }
}

/// g₀'(x) between corners, 0 beyond them.
fn initial_slope(model: &Model, x: f64) -> f64 {
    let right = model.gap.partition_point(|corner| corner.at < x);
    match (right.checked_sub(1).map(|i| model.gap[i]), model.gap.get(right)) {
        (Some(a), Some(b)) => (b.value - a.value) / (b.at - a.at),
        _ => 0.0,
    }
}
