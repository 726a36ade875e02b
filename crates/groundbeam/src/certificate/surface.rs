//! The ground under one piece of the beam, from the model's own constants.

use super::ClaimedPiece;
use super::curve::{Curve, Point, ROUNDING, fourth, rounding};
use super::neighbours;
use crate::model::{CellPolynomial, Model};
use crate::numeric::polynomial::{Coefficients, jet};

#[derive(Debug, Clone, Copy)]
pub(super) struct Under<'a> {
    pub piece: &'a ClaimedPiece<'a>,
    pub half: f64,
    /// w and dw/ds at both ends.
    deflection: [[f64; 2]; 2],
    /// k and μ, where they vary at the middle.
    pub spring: f64,
    pub shear: f64,
    ground: [CellPolynomial; 2],
    gap: [f64; 2],
    /// A load on the ground, q at both ends.
    load: [f64; 2],
    /// Half of what g₀ rises by.
    rise: f64,
    open: Option<Open>,
}

/// The surface of open ground.
#[derive(Debug, Clone, Copy)]
enum Open {
    Even(Even),
    /// Where k or μ varies, a polynomial that solves (2.2) as far as its degree goes; what it misses
    /// counts as a pressure that nobody claims.
    Varying([f64; TERMS]),
}

/// Coefficients of u where the ground varies.
const TERMS: usize = 22;

/// u = (left sinh(b(h − ξ)) + right sinh(bξ))/sinh(bh) about the middle: an even part cosh and an odd
/// part sinh, each scaled by its value at the ends.
#[derive(Debug, Clone, Copy)]
struct Even {
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
    pub fn new(model: &Model, piece: &'a ClaimedPiece, deflection: [[f64; 2]; 2]) -> Self {
        let [from, to] = piece.x;
        let ground = model.foundation.constants_on(piece.x);
        let [spring, shear] = ground.map(|course| course.coefficients[0]);
        let (gap, rise) = if model.gap.is_empty() {
            ([0.0; 2], 0.0)
        } else {
            let slope = initial_slope(model, 0.5 * (from + to));
            (piece.x.map(|x| initial_gap(model, x)), slope * piece.half)
        };
        let load = neighbours::spread(model, piece.x);
        let open = piece.open.map(|[left, right]| {
            // What q alone does to even ground, u = q/k, is taken off.
            let [left, right] = [left - load[0] / spring, right - load[1] / spring];
            if shear == 0.0 {
                return Open::Even(Even {
                    mean: 0.0,
                    rise: 0.0,
                    b: 0.0,
                    z: 0.0,
                    tanh: 0.0,
                    faded: 1.0,
                    floor: 0.0,
                });
            }
            if ground.iter().any(|course| !course.is_constant()) {
                return Open::Varying(varying(&ground, piece.half, [left, right]));
            }
            let b = (spring / shear).sqrt();
            let z = b * piece.half;
            Open::Even(Even {
                mean: 0.5 * (left + right),
                rise: 0.5 * (right - left),
                b,
                z,
                tanh: z.tanh(),
                faded: (-2.0 * z).exp(),
                floor: left.min(right).min(0.0),
            })
        });
        Under { piece, half: piece.half, deflection, spring, shear, ground, gap, load, rise, open }
    }

    /// Whether the ground is free here.
    pub fn is_open(&self) -> bool {
        self.open.is_some()
    }

    pub fn from(&self) -> f64 {
        self.piece.x[0]
    }

    pub fn gap(&self, s: f64) -> f64 {
        if self.gap == [0.0; 2] {
            return 0.0;
        }
        0.5 * ((1.0 - s) * self.gap[0] + (1.0 + s) * self.gap[1])
    }

    /// k, μ and μ' at s.
    pub fn constants(&self, s: f64) -> [f64; 3] {
        let [spring, shear] = &self.ground;
        let [mu, rise] = if shear.is_constant() { [self.shear, 0.0] } else { shear.rising_at(s) };
        [spring.at(s), mu, rise / self.half]
    }

    /// Bounds: the least k, the largest k and μ.
    pub fn bounds(&self) -> [f64; 3] {
        let [spring, shear] = &self.ground;
        [spring.bounds[0], spring.bounds[1], shear.bounds[1]]
    }

    /// k and μ at the left or the right end.
    fn ends(&self, s: f64) -> [f64; 2] {
        self.ground.map(|course| course.ends[usize::from(s > 0.0)])
    }

    /// μu' at an end where the surface has the slope u'.
    pub fn flux(&self, s: f64, slope: f64) -> f64 {
        self.ends(s)[1] * slope
    }

    /// u and u' where the beam has w and dw/ds.
    pub fn surface(&self, s: f64, w: f64, dw: f64) -> [f64; 2] {
        match &self.open {
            None => [w - self.gap(s), (dw - self.rise) / self.half],
            Some(Open::Even(even)) => {
                let ([e, de], [m, dm]) = (even.surface(s), self.own(s));
                [e + m, de + dm]
            }
            Some(Open::Varying(c)) => {
                let [u, du, ..] = jet(c, s);
                [u, du / self.half]
            }
        }
    }

    /// q/k and its slope.
    fn own(&self, s: f64) -> [f64; 2] {
        if self.load == [0.0; 2] {
            return [0.0; 2];
        }
        let [a, b] = self.load.map(|q| q / self.spring);
        [0.5 * ((1.0 - s) * a + (1.0 + s) * b), (b - a) / (2.0 * self.half)]
    }

    /// Whether anything acts on the ground here besides the beam.
    pub fn is_loaded(&self) -> bool {
        self.load != [0.0; 2]
    }

    /// q at s.
    pub fn load(&self, s: f64) -> f64 {
        0.5 * ((1.0 - s) * self.load[0] + (1.0 + s) * self.load[1])
    }

    /// ∫(k u² + μ u'²) of open even ground: what its ends do, u μu' at the right less the same at the left.
    /// None for ground that touches or varies.
    pub fn energy(&self) -> Option<f64> {
        let Some(Open::Even(even)) = &self.open else { return None };
        // u = e + m: e is the ground without load, m = q/k, and ∫(k e m + μ e'm') is what e does on m.
        let ends = [-1.0, 1.0].map(|s| (even.surface(s), self.own(s)));
        let [left, right] = ends.map(|([e, de], [m, _])| de * (e + 2.0 * m));
        let [(_, [a, rise]), (_, [b, _])] = ends;
        let length = 2.0 * self.half;
        let own = self.spring * length / 3.0 * (a * a + a * b + b * b)
            + self.shear * length * rise * rise;
        Some(self.shear * (right - left) + own)
    }

    /// ku − (μu')' of open ground.
    pub fn residual(&self, s: f64) -> f64 {
        let Some(Open::Varying(c)) = &self.open else { return 0.0 };
        let [u, du, bend, _] = jet(c, s);
        let [k, mu, rise] = self.constants(s);
        k * u - (mu * bend / self.half + rise * du) / self.half
    }

    /// u, u' and the clearance at an end.
    pub fn end(&self, s: f64) -> [f64; 3] {
        let [w, dw] = self.deflection[usize::from(s > 0.0)];
        let [u, du] = self.surface(s, w, dw);
        [u, du, if self.is_open() { u + self.gap(s) - w } else { 0.0 }]
    }
}

/// −(μu')' + ku = 0 on a stretch that is held at both ends: the coefficients follow one another,
/// (j+2)(j+1) μ₀ c_{j+2} = a² \[ku\]_j − (j+1) Σ_{i≥1} μᵢ (j+2−i) c_{j+2−i}.
fn varying(ground: &[CellPolynomial; 2], half: f64, [left, right]: [f64; 2]) -> [f64; TERMS] {
    let [spring, shear] = ground.map(|course| course.coefficients);
    let solution = |level: f64, slope: f64| {
        let mut c = [0.0; TERMS];
        (c[0], c[1]) = (level, slope);
        for j in 0..TERMS - 2 {
            let [mut held, mut carried] = [0.0; 2];
            for (i, k) in spring.iter().enumerate().take(j + 1) {
                held += k * c[j - i];
            }
            for (i, mu) in shear.iter().enumerate().take(j + 2).skip(1) {
                carried += mu * (j + 2 - i) as f64 * c[j + 2 - i];
            }
            let next = half * half * held / (j + 1) as f64 - carried;
            c[j + 2] = next / ((j + 2) as f64 * shear[0]);
        }
        c
    };
    let (one, rising) = (solution(1.0, 0.0), solution(0.0, 1.0));
    // The parts of each that have the same and the opposite sign at both ends.
    let [[same, other], [lift, tilt]] = [&one, &rising].map(|c| {
        let sum = |first: usize| c.iter().skip(first).step_by(2).sum::<f64>();
        [sum(0), sum(1)]
    });
    let (mean, rise) = (0.5 * (left + right), 0.5 * (right - left));
    let determinant = same * tilt - other * lift;
    let level = (tilt * mean - lift * rise) / determinant;
    let slope = (same * rise - other * mean) / determinant;
    std::array::from_fn(|j| level * one[j] + slope * rising[j])
}

impl Even {
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
    shape: Shape,
    /// (b h/2)²: the ground's curvature for its deflection.
    curvature: f64,
    rest: f64,
    noise: [f64; 2],
}

enum Shape {
    Even(Even),
    /// Where the ground varies, all of it is one polynomial.
    Polynomial(Coefficients),
}

impl<'a> Clearance<'a> {
    pub fn of(under: &'a Under<'a>) -> Option<Self> {
        match &under.open {
            None => None,
            Some(Open::Even(even)) => Some(Self::over_even_ground(under, *even)),
            Some(Open::Varying(c)) => Some(Self::over_varying_ground(under, c)),
        }
    }

    fn over_varying_ground(under: &'a Under<'a>, u: &[f64]) -> Self {
        let mut difference = Coefficients::from(u).at_least(under.piece.deflection.len());
        for (c, w) in difference.iter_mut().zip(under.piece.deflection) {
            *c -= w;
        }
        difference[0] += under.gap(0.0);
        difference[1] += under.rise;
        let parts = [rounding(under.piece.deflection), rounding(u)];
        let gap = under.gap[0].abs().max(under.gap[1].abs());
        let noise = [
            parts[0][0] + parts[1][0] + ROUNDING * gap,
            parts[0][1] + parts[1][1] + ROUNDING * under.rise.abs(),
        ];
        let rest = 0.5 * fourth(&difference);
        Clearance { under, shape: Shape::Polynomial(difference), curvature: 0.0, rest, noise }
    }

    fn over_even_ground(under: &'a Under<'a>, open: Even) -> Self {
        let [value, slope] = rounding(under.piece.deflection);
        let own = under.load[0].abs().max(under.load[1].abs()) / under.spring;
        let ground = open.mean.abs() + open.rise.abs() + own;
        let gap = under.gap[0].abs().max(under.gap[1].abs());
        let steep = if open.z > 0.0 {
            open.z * open.mean.abs() + open.rise.abs() * (1.0 + open.z)
        } else {
            0.0
        };
        Clearance {
            under,
            shape: Shape::Even(open),
            curvature: open.z * open.z,
            rest: 0.5 * fourth(under.piece.deflection),
            noise: [
                value + ROUNDING * (ground + gap),
                slope + ROUNDING * (steep + own + under.rise.abs()),
            ],
        }
    }
}

impl Curve for Clearance<'_> {
    fn at(&self, s: f64) -> Point {
        let under = self.under;
        let open = match &self.shape {
            Shape::Even(open) => open,
            Shape::Polynomial(c) => {
                let [value, slope, bend, third] = jet(c, s);
                return Point { s, value, slope, bend, turn: third.abs() };
            }
        };
        let [w, dw, bend, third] = jet(under.piece.deflection, s);
        let [u, du] = open.surface(s);
        let du = du * under.half;
        let [own, sinks] = under.own(s);
        let sinks = sinks * under.half;
        // The ground is convex where it is not negative: it lies above its tangent.
        let (least, turn) = if open.floor < 0.0 { (open.floor, 0.0) } else { (u, du.abs()) };
        Point {
            s,
            value: u + own + under.gap(s) - w,
            slope: du + sinks + under.rise - dw,
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
