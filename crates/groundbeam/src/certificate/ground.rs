//! The ground's part of the proof: its equation, its clearance, its energies.

use super::{Claim, ClaimedPiece, gauss};
use crate::model::Model;
use crate::polynomial::{jet, rescale, value};

/// Sums over the ground, piece by piece from the left.
#[derive(Debug)]
pub(super) struct GroundSums<'a> {
    forces: &'a [(f64, f64)],
    /// Concentrated forces used so far.
    used: usize,
    near: f64,
    /// μu' just left of the position reached; u, g₀ and the clearance there.
    flux: f64,
    surface: f64,
    initial_gap: f64,
    gap: f64,
    /// b(u, u).
    pub energy: f64,
    /// ⟨p, g₀⟩.
    pub work_on_gap: f64,
    /// ⟨p, u + g₀ − w⟩ of concentrated forces; the pressure along contact has none by construction.
    pub on_gap: f64,
    pub worst_product: f64,
    pub largest_force: f64,
    pub penetration: f64,
    /// A bound of g(x, x), the ground's give under a unit force.
    pub flexibility: f64,
    /// Concentrated forces that the ground's equation demands but nobody claims.
    unclaimed: Unclaimed,
    total_pressure: f64,
    lift_stiffness: f64,
    largest_pressure: f64,
    smallest_pressure: f64,
    smallest_force: f64,
    length: f64,
}

impl<'a> GroundSums<'a> {
    pub fn new(model: &Model, claim: &'a Claim) -> Self {
        let l = model.beam.length;
        let (k, mu) = model.foundation.constants_at(claim.pieces[0].x[1].min(l) * 0.5);
        let surface = Under::new(model, &claim.pieces[0]).surface(-1.0)[0];
        let outside = (k * mu).sqrt();
        GroundSums {
            forces: &claim.forces,
            used: 0,
            near: 16.0 * f64::EPSILON * l,
            flux: outside * surface,
            surface,
            initial_gap: 0.0,
            gap: 0.0,
            energy: outside * surface * surface,
            work_on_gap: 0.0,
            on_gap: 0.0,
            worst_product: 0.0,
            largest_force: claim.forces.iter().map(|f| f.1.abs()).fold(0.0, f64::max),
            penetration: 0.0,
            flexibility: flexibility(model),
            unclaimed: Unclaimed::new(model),
            total_pressure: 0.0,
            lift_stiffness: outside,
            largest_pressure: 0.0,
            smallest_pressure: 0.0,
            smallest_force: 0.0,
            length: l,
        }
    }

    /// One piece more.
    pub fn add(&mut self, model: &Model, piece: &ClaimedPiece, largest_deflection: f64) {
        let under = Under::new(model, piece);
        let (mu, half) = (under.shear, under.half);
        self.unclaimed.enter(mu > 0.0, piece.x[0]);
        let [u, du] = under.surface(-1.0);
        let gap = u + under.gap(-1.0) - value(piece.deflection, -1.0);
        self.balance(piece.x[0], mu * du, gap, under.gap(-1.0));
        self.energy += under.energy();
        for (s, weight) in gauss() {
            let p = value(piece.pressure, s);
            self.total_pressure += weight * half * p.max(0.0);
            self.work_on_gap += weight * half * p * under.gap(s);
        }
        self.lift_stiffness += under.spring * 2.0 * half;
        if piece.open.is_none() {
            let [low, high] = bounds(piece.pressure, 8);
            self.smallest_pressure = self.smallest_pressure.min(low);
            self.largest_pressure = self.largest_pressure.max(high);
        }
        let tolerance = 1e-14 * largest_deflection;
        self.penetration = self.penetration.max(under.penetration(tolerance));
        let [u, du] = under.surface(1.0);
        (self.flux, self.surface) = (mu * du, u);
        self.initial_gap = under.gap(1.0);
        self.gap = u + self.initial_gap - value(piece.deflection, 1.0);
    }

    /// The ground beyond the right end.
    pub fn finish(&mut self, model: &Model) {
        let l = self.length;
        let (k, mu) = model.foundation.constants_at(l * (1.0 - f64::EPSILON));
        let outside = (k * mu).sqrt();
        self.energy += outside * self.surface * self.surface;
        self.lift_stiffness += outside;
        self.balance(l, -outside * self.surface, self.gap, self.initial_gap);
    }

    /// At a joint the flux may fall by the concentrated force claimed there, and by nothing else.
    fn balance(&mut self, x: f64, flux_right: f64, gap: f64, initial_gap: f64) {
        let mut claimed = 0.0;
        while let Some(&(at, force)) = self.forces.get(self.used) {
            if at > x + self.near {
                break;
            }
            claimed += force;
            self.used += 1;
            self.on_gap += (force * gap).max(0.0);
            self.worst_product = self.worst_product.max((force * gap).abs());
            self.work_on_gap += force * initial_gap;
            self.total_pressure += force.max(0.0);
            self.smallest_force = self.smallest_force.min(force);
        }
        self.unclaimed.add(x, self.flux - flux_right - claimed);
    }

    /// ½ b(u − Gp, u − Gp).
    pub fn misfit(&self) -> f64 {
        self.unclaimed.energy()
    }

    /// A surface that the beam pierces by δ is lifted by δ everywhere: admissible again, at this cost.
    pub fn lifting(&self) -> f64 {
        let lift = self.penetration;
        lift * self.total_pressure + 0.5 * lift * lift * self.lift_stiffness
    }

    /// The smallest pressure or concentrated force, relative to the largest or to all forces' sizes.
    pub fn smallest_pressure(&self, forces: f64) -> f64 {
        let relative = |x: f64, scale: f64| if x == 0.0 { 0.0 } else { x / scale };
        let spread =
            relative(self.smallest_pressure, self.largest_pressure.max(forces / self.length));
        spread.min(relative(self.smallest_force, self.total_pressure.max(forces)))
    }
}

/// ½⟨r, Gr⟩ for concentrated forces r that stand on the ground unclaimed: ½ b(u − Gp, u − Gp).
///
/// Softer ground gives more, so it is bounded on ground with the smallest k and the smallest μ > 0 of the
/// model, where G is the exponential (2.4). A shear layer of length L that stops under the beam gives at
/// most coth(bL)/√(kμ) to a unit force, which bounds it by (Σ|r|)².
#[derive(Debug)]
struct Unclaimed {
    spring: f64,
    shear: f64,
    length: f64,
    finished: f64,
    /// The layer now passed over: Σ|r|, Σ rᵢ e^(−b(x − xᵢ)), ⟨r, Gr⟩·2√(kμ), and whether it began at the
    /// beam's end.
    sum: f64,
    carried: f64,
    square: f64,
    x: f64,
    start: f64,
    endless: bool,
    inside: bool,
}

impl Unclaimed {
    fn new(model: &Model) -> Self {
        let ground = &model.foundation;
        let segments = ground.segments.iter().map(|s| (s.spring, s.shear));
        let (mut spring, mut shear) = (ground.spring, f64::INFINITY);
        for (k, mu) in segments.chain([(ground.spring, ground.shear)]) {
            spring = spring.min(k);
            if mu > 0.0 {
                shear = shear.min(mu);
            }
        }
        Unclaimed {
            spring,
            shear,
            length: model.beam.length,
            finished: 0.0,
            sum: 0.0,
            carried: 0.0,
            square: 0.0,
            x: 0.0,
            start: 0.0,
            endless: true,
            inside: true,
        }
    }

    /// The next piece lies on a shear layer or not.
    fn enter(&mut self, layer: bool, x: f64) {
        if layer != self.inside {
            self.close(x, false);
            (self.start, self.endless, self.inside) = (x, x == 0.0, layer);
        }
    }

    fn add(&mut self, x: f64, force: f64) {
        if force == 0.0 {
            return;
        }
        let b = (self.spring / self.shear).sqrt();
        self.carried = self.carried * (-b * (x - self.x)).exp() + force;
        self.x = x;
        self.square += force * (2.0 * self.carried - force);
        self.sum += force.abs();
    }

    fn close(&mut self, end: f64, endless: bool) {
        if self.sum > 0.0 {
            let give = 1.0 / (self.spring * self.shear).sqrt();
            self.finished += if endless && self.endless {
                // A sum of squares in exact arithmetic.
                0.25 * give * self.square.max(0.0)
            } else {
                let b = (self.spring / self.shear).sqrt();
                0.5 * give * self.sum * self.sum / (b * (end - self.start)).tanh()
            };
        }
        (self.sum, self.carried, self.square) = (0.0, 0.0, 0.0);
    }

    fn energy(&self) -> f64 {
        let mut all = Unclaimed { ..*self };
        all.close(self.length, true);
        all.finished
    }
}

/// Bounds of a polynomial on \[−1, 1\] from its coefficients on `parts` equal parts; the lower one is
/// taken at points, which is where a result could be refused.
fn bounds(c: &[f64], parts: usize) -> [f64; 2] {
    let at = |i: usize| value(c, 2.0 * i as f64 / parts as f64 - 1.0);
    (0..=parts).map(at).fold([0.0, 0.0], |[low, high], p| [low.min(p), high.max(p)])
}

/// A bound of g(x, x) for the whole ground; infinite where there is no shear layer.
///
/// Less stiff ground gives more (the energy is monotone in k and μ), so the softest constants bound it. A
/// shear layer that stops under the beam is held from one side only.
fn flexibility(model: &Model) -> f64 {
    let ground = &model.foundation;
    let all = ground.segments.iter().map(|s| (s.spring, s.shear));
    let (k, mu) = all.fold((ground.spring, ground.shear), |(k, mu), (other_k, other_mu)| {
        (k.min(other_k), mu.min(other_mu))
    });
    if mu > 0.0 { 0.5 / (k * mu).sqrt() } else { f64::INFINITY }
}

/// The ground under one piece, from the model's own constants.
struct Under<'a> {
    piece: &'a ClaimedPiece<'a>,
    half: f64,
    spring: f64,
    shear: f64,
    gap: [f64; 2],
    /// Half of what g₀ rises by.
    rise: f64,
}

impl<'a> Under<'a> {
    fn new(model: &Model, piece: &'a ClaimedPiece) -> Self {
        let [from, to] = piece.x;
        let (spring, shear) = model.foundation.constants_at(0.5 * (from + to));
        let gap = piece.x.map(|x| initial_gap(model, x));
        let rise = initial_slope(model, 0.5 * (from + to)) * piece.half;
        Under { piece, half: piece.half, spring, shear, gap, rise }
    }

    fn gap(&self, s: f64) -> f64 {
        0.5 * ((1.0 - s) * self.gap[0] + (1.0 + s) * self.gap[1])
    }

    /// u and u'.
    fn surface(&self, s: f64) -> [f64; 2] {
        let Some([left, right]) = self.piece.open else {
            let [w, dw, ..] = jet(self.piece.deflection, s);
            return [w - self.gap(s), (dw - self.rise) / self.half];
        };
        if self.shear == 0.0 {
            return [0.0, 0.0];
        }
        // u = (left sinh(b(h − ξ)) + right sinh(bξ))/sinh(bh) about the middle:
        // even part cosh, odd part sinh, each scaled by its value at the ends.
        let b = (self.spring / self.shear).sqrt();
        let z = b * self.half;
        let (mean, rise) = (0.5 * (left + right), 0.5 * (right - left));
        let even = cosh_ratio(z, s);
        let odd = sinh_ratio(z, s);
        let slope_even = z.tanh() * odd;
        let slope_odd = if z < 1e-8 { 1.0 / z } else { even / z.tanh() };
        [mean * even + rise * odd, b * (mean * slope_even + rise * slope_odd)]
    }

    /// ∫(k u² + μ u'²): of open ground what its ends do, u μu' at the right less the same at the left.
    fn energy(&self) -> f64 {
        if self.piece.open.is_some() {
            let [left, right] = [-1.0, 1.0].map(|s| self.surface(s));
            return self.shear * (right[0] * right[1] - left[0] * left[1]);
        }
        let density = |s: f64| {
            let [u, du] = self.surface(s);
            self.spring * u * u + self.shear * du * du
        };
        gauss().map(|(s, weight)| weight * self.half * density(s)).sum()
    }

    /// A bound of how deep the beam pierces the ground's surface; what is below `tolerance` counts as
    /// nothing found worth halving on.
    fn penetration(&self, tolerance: f64) -> f64 {
        if self.piece.open.is_none() {
            return 0.0;
        }
        let mut beam = self.piece.deflection.to_vec();
        beam.resize(beam.len().max(3), 0.0);
        beam[0] -= 0.5 * (self.gap[0] + self.gap[1]);
        beam[1] -= self.rise;
        self.pierced(&beam, -1.0, 1.0, tolerance, 0)
    }

    /// On a part: u lies above its tangent at the middle (it is convex where not negative) by at least
    /// its least curvature, the beam below its parabola by at most the size of the higher terms.
    fn pierced(&self, beam: &[f64], low: f64, high: f64, tolerance: f64, depth: u32) -> f64 {
        let (middle, quarter) = (0.5 * (low + high), 0.5 * (high - low));
        let c = rescale(beam, middle, quarter);
        let [u, du] = self.surface(middle);
        let bend = if self.shear > 0.0 {
            let ends = [low, high].map(|s| self.surface(s)[0]);
            let width = quarter * self.half;
            // A convex function may dip between its ends, but not below zero here.
            let least = (u - (du * width).abs()).min(ends[0]).min(ends[1]).max(0.0);
            0.5 * self.spring / self.shear * least * width * width
        } else {
            0.0
        };
        // clearance ≥ a − tilt·|t| + open·t² − rest on |t| ≤ 1.
        let tilt = (c[1] - du * quarter * self.half).abs();
        let open = bend - c[2];
        let dip =
            if open > 0.0 && tilt < 2.0 * open { 0.25 * tilt * (tilt / open) } else { tilt - open };
        let rest: f64 = c[3..].iter().map(|a| a.abs()).sum();
        let bound = (c[0] - u) + dip + rest;
        if bound <= tolerance {
            return bound.max(0.0);
        }
        let found = (c[0] - u).max(0.0);
        if depth >= DEEPEST || bound - found <= tolerance + 0.5 * found {
            return bound.max(0.0);
        }
        let left = self.pierced(beam, low, middle, tolerance, depth + 1);
        left.max(self.pierced(beam, middle, high, tolerance.max(left), depth + 1))
    }
}

/// Halvings of a piece: next to an edge of contact the clearance falls like the cube of the distance.
const DEEPEST: u32 = 30;

/// cosh(z s)/cosh(z) for |s| ≤ 1.
fn cosh_ratio(z: f64, s: f64) -> f64 {
    let a = (z * s).abs();
    (a - z).exp() * (1.0 + (-2.0 * a).exp()) / (1.0 + (-2.0 * z).exp())
}

/// sinh(z s)/sinh(z) for |s| ≤ 1.
fn sinh_ratio(z: f64, s: f64) -> f64 {
    if z < 1e-8 {
        return s;
    }
    let a = (z * s).abs();
    ((a - z).exp() * (-2.0 * a).exp_m1() / (-2.0 * z).exp_m1()).copysign(s)
}

/// g₀(x): linear between corners, constant beyond them.
fn initial_gap(model: &Model, x: f64) -> f64 {
    let corners = &model.gap;
    let (Some(first), Some(last)) = (corners.first(), corners.last()) else { return 0.0 };
    if x <= first.at {
        return first.value;
    }
    let between = corners.windows(2).find(|pair| x <= pair[1].at);
    between.map_or(last.value, |pair| {
        let t = (x - pair[0].at) / (pair[1].at - pair[0].at);
        pair[0].value * (1.0 - t) + pair[1].value * t
    })
}

/// g₀'(x) between corners, 0 beyond them.
fn initial_slope(model: &Model, x: f64) -> f64 {
    let between = model.gap.windows(2).find(|pair| pair[0].at < x && x < pair[1].at);
    between.map_or(0.0, |pair| (pair[1].value - pair[0].value) / (pair[1].at - pair[0].at))
}
