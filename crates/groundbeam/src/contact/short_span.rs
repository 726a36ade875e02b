//! Computes the end forces of a short span of open ground from the pressure π that would close it, and its two-port.
//!
//! In a span that has just opened, differences of slopes lose digits. Green's identity gives the end forces A = ∫ π φ_a
//! dx and B = ∫ π φ_b dx. φ_a is the settlement of unloaded ground that is 1 at the left end and 0 at the right end,
//! and φ_b the reverse. See *Short open spans* in `docs/methods.md`.

use crate::ground::link::{Pair, TwoPort};
use crate::mesh::cell::Cell;
use crate::mesh::deflection::{BeamPoint, Deflection};
use crate::numeric::elementary::{cosh, sinh};
use crate::numeric::polynomial::{Coefficients, trimmed, values_at};
use crate::numeric::real::Real;

/// Maximum number of cells of a short span, including cells that only touch an end of the span.
pub(crate) const MOST_CELLS: usize = 4;
/// Maximum length of a short span, in decay lengths √(μ/k). Above it, differences of slopes give twelve accurate
/// digits.
const LONGEST: f64 = 0.03;

/// A part of a cell within a short span, and the data of its ground.
struct SpanPart<R> {
    cell: usize,
    from: f64,
    to: f64,
    /// Half the length of the part of the cell that lies in the span \[m\].
    half: f64,
    /// Length of this part of the cell, times the decay rate b = √(k/μ) of the ground.
    length: R,
    stiffness: R,
    /// Unloaded ground of this part of the cell, if the ground varies; otherwise `None`.
    varying: Option<Box<VaryingGround<R>>>,
}

/// A stretch of unloaded ground with varying subgrade modulus k or shear-layer stiffness μ.
struct VaryingGround<R> {
    /// Relation between the settlements and the forces at the left and the right end of this stretch of ground.
    link: TwoPort<R>,
    /// Coefficients in s ∈ \[−1, 1\] of two settlement shapes: 1 at the left end and 0 at the right end, and the
    /// reverse.
    surfaces: [Coefficients<R>; 2],
}

impl<R: Real> SpanPart<R> {
    fn of(cell: &Cell<R>, i: usize, [from, to]: [f64; 2]) -> Option<Self> {
        let half = half_length(cell, [from, to]);
        let length = decay(cell, half);
        let stiffness = (cell.subgrade * cell.shear_layer).sqrt();
        let mut part = SpanPart { cell: i, from, to, half, length, stiffness, varying: None };
        if cell.ground_varies() && to > from {
            let ground = cell.ground().part([from, to]);
            if !ground.is_smooth() || !ground.is_short(half) {
                return None;
            }
            let shear = ground.shear_layer;
            let pair = Pair::new(&ground.subgrade, &shear, half);
            part.varying = Some(Box::new(VaryingGround {
                link: pair.link(&shear, half),
                // Fewer terms make the integrals of [`Self::under`] cheaper.
                surfaces: [[R::ONE, R::ZERO], [R::ZERO, R::ONE]]
                    .map(|ends| pair.between(ends).without_zeros()),
            }));
        }
        Some(part)
    }

    /// Transfers the settlement φ and the flux μφ' of unloaded ground from the left to the right end of this part, or φ
    /// and −μφ' back if `turned` is true. All terms are positive, so no digits cancel.
    fn cross(&self, phi: R, flux: R, turned: bool) -> [R; 2] {
        if let Some(ground) = &self.varying {
            let link = &ground.link;
            let (behind, ahead) = if turned {
                (link.shunt_right, link.shunt_left)
            } else {
                (link.shunt_left, link.shunt_right)
            };
            let held = behind * phi + flux;
            let next = phi + held / link.series;
            return [next, ahead * next + held];
        }
        let (sinh, cosh) = (sinh(self.length), cosh(self.length));
        let stiffness = self.stiffness;
        [cosh * phi + sinh / stiffness * flux, stiffness * sinh * phi + cosh * flux]
    }

    /// Returns the two-port of this part of the ground out of contact.
    fn link(&self) -> TwoPort<R> {
        let uniform = || TwoPort::of_decay(self.stiffness, self.length);
        self.varying.as_ref().map_or_else(uniform, |ground| ground.link)
    }

    /// Computes ∫π φ ds, −1 ≤ s ≤ 1, for two settlement shapes φ of this part. The first is 1 at the left end and 0 at
    /// the right end; the second is the reverse. `pi` has the coefficients of the pressure π.
    fn under(&self, pi: &[R]) -> [R; 2] {
        let place = POINTS.map(|s| self.from + 0.5 * (1.0 + s) * (self.to - self.from));
        let pressure = values_at(pi, &place);
        let surfaces = match &self.varying {
            Some(ground) => [0, 1].map(|end| values_at(&ground.surfaces[end], &POINTS)),
            None => self.uniform_surfaces(),
        };
        surfaces.map(|surface| {
            let points = surface.into_iter().zip(pressure).zip(WEIGHTS);
            points.map(|((phi, p), weight)| p * phi * weight).sum()
        })
    }

    /// Returns the values of the two settlement shapes of uniform ground at the points of the quadrature. The shape
    /// that is 1 at the right end is sinh(tz)/sinh(z): z is the length times √(k/μ), and t the relative position.
    fn uniform_surfaces(&self) -> [[R; POINTS.len()]; 2] {
        let square = self.length * self.length;
        let whole = sinh_over(square);
        let rising = POINTS.map(|s| {
            let t = 0.5 * (1.0 + s);
            sinh_over(square * (t * t)) * t / whole
        });
        // The points are symmetric, so the other shape has the same values in reverse order.
        let mut falling = rising;
        falling.reverse();
        [falling, rising]
    }
}

/// Computes sinh(z)/z from z², for z up to [`LONGEST`]. The first omitted term of the power series is below 1e-17.
fn sinh_over<R: Real>(square: R) -> R {
    R::ONE + square * (R::ONE + square * (R::ONE + square / 42.0) / 20.0) / 6.0
}

/// Half the length of a part of a cell.
fn half_length<R: Real>(cell: &Cell<R>, [from, to]: [f64; 2]) -> f64 {
    0.25 * (to - from) * cell.length()
}

/// Computes the product of the decay rate b = √(k/μ) of the ground and the length 2 `half` of a part of a cell.
fn decay<R: Real>(cell: &Cell<R>, half: f64) -> R {
    (cell.subgrade / cell.shear_layer).sqrt() * 2.0 * half
}

/// Computes the forces on the ground at both ends of an open span with the two-port `link`. At an end `None`, the span
/// includes the ground beyond this end of the `GroundRun`.
pub(crate) fn fluxes<R: Real>(
    w: &Deflection<R>,
    ends: [Option<BeamPoint>; 2],
    link: &TwoPort<R>,
) -> [R; 2] {
    fluxes_of(w, ends, link, ShortSpan::of(w, ends, |i| w.pressure(i)).as_ref())
}

/// Computes the forces at both ends of an open span, from the forces of `short` if the span is short.
fn fluxes_of<R: Real>(
    w: &Deflection<R>,
    ends: [Option<BeamPoint>; 2],
    link: &TwoPort<R>,
    short: Option<&ShortSpan<R>>,
) -> [R; 2] {
    let of = |f: &dyn Fn(BeamPoint) -> R| ends.map(|end| end.map_or(R::ZERO, f));
    if let Some(ShortSpan { forces: [a, b], .. }) = short {
        let [left, right] = of(&|point| w.flux(point));
        return [*a - left, *b + right];
    }
    let [left, right] = of(&|point| w.obstacle_at(point));
    [link.force_left(left, right), link.force_right(left, right)]
}

/// Computes the forces at both ends of an open span of the bonded beam, with the effect of kinks in the beam at the
/// edges.
pub(crate) fn bonded_fluxes<R: Real>(
    w: &Deflection<R>,
    ends: [Option<BeamPoint>; 2],
    link: &TwoPort<R>,
) -> [R; 2] {
    let kink = |end: Option<BeamPoint>| {
        end.map_or(R::ZERO, |point| w.flux(point) - w.flux(open_side(w, point)))
    };
    let short = ShortSpan::of(w, ends, |i| w.pressure(i));
    let [left, right] = fluxes_of(w, ends, link, short.as_ref());
    match short {
        Some(_) => [left + kink(ends[0]), right - kink(ends[1])],
        None => [left, right],
    }
}

/// If a concentrated force kinks the beam at the end `point` of a span, returns this end in the cell inside the span.
/// Forces of corners are already part of [`ShortSpan::forces`], so `point` is kept there.
fn open_side<R: Real>(w: &Deflection<R>, point: BeamPoint) -> BeamPoint {
    let BeamPoint { cell, s } = point;
    let other = match s {
        1.0 if cell + 1 < w.mesh.cells.len() => BeamPoint { cell: cell + 1, s: -1.0 },
        -1.0 if cell > 0 => BeamPoint { cell: cell - 1, s: 1.0 },
        _ => return point,
    };
    let shears = w.mesh.cells[other.cell].beam_shear.is_some();
    if shears && w.corner(cell.max(other.cell)) == 0.0 { other } else { point }
}

/// A short open span of ground.
pub(crate) struct ShortSpan<R = f64> {
    /// Forces at the left and the right end of the span, from the pressure that would close it \[N\].
    pub forces: [R; 2],
    parts: Vec<SpanPart<R>>,
}

impl<R: Real> ShortSpan<R> {
    /// Computes the forces at both ends of a short span. Returns `None` for a longer span, or if differences of slopes
    /// are more accurate. `pressure` returns the pressure coefficients of a cell ([`Deflection::pressure`]).
    pub fn of(
        w: &Deflection<R>,
        ends: [Option<BeamPoint>; 2],
        pressure: impl Fn(usize) -> Coefficients<R>,
    ) -> Option<Self> {
        let [a, b] = [ends[0]?, ends[1]?];
        if b.cell < a.cell || b.cell - a.cell >= MOST_CELLS {
            return None;
        }
        let within = |i: usize| {
            let from = if i == a.cell { a.s } else { -1.0 };
            let to = if i == b.cell { b.s } else { 1.0 };
            [from, to]
        };
        let cells = a.cell..=b.cell;
        let half = |i: usize| half_length(&w.mesh.cells[i], within(i));
        let length = |i: usize| decay(&w.mesh.cells[i], half(i)).value();
        let whole: f64 = cells.clone().map(length).sum();
        if whole > LONGEST {
            return None;
        }
        if whole <= 0.0 {
            // A span of zero length carries the point force at its node, half at each end. If this force is tensile,
            // the span opens.
            let half_force = cells.skip(1).map(|i| w.corner(i) * 0.5).sum();
            return Some(ShortSpan { forces: [half_force; 2], parts: Vec::new() });
        }
        let size = |i: usize| 2.0 * half(i) * pressure_size(w, i);
        let softness = |i: usize| 2.0 * half(i) / w.mesh.cells[i].shear_layer.value();
        let noise: f64 = cells.clone().map(size).sum();
        let soft: f64 = cells.clone().map(softness).sum();
        if noise * soft > w.obstacle_at(a).value().abs() + w.obstacle_at(b).value().abs() {
            return None;
        }
        let part = |i: usize| SpanPart::of(&w.mesh.cells[i], i, within(i));
        let parts: Vec<SpanPart<R>> = cells.map(part).collect::<Option<_>>()?;
        Some(ShortSpan { forces: end_forces(w, &parts, pressure), parts })
    }

    /// Returns the two-port of the ground in the span.
    pub fn link(&self) -> TwoPort<R> {
        let longer = self.parts.iter().filter(|part| part.to > part.from);
        longer.map(SpanPart::link).reduce(TwoPort::then).unwrap_or_else(TwoPort::rigid)
    }
}

/// Computes the forces at both ends of the consecutive parts of a short span.
fn end_forces<R: Real>(
    w: &Deflection<R>,
    parts: &[SpanPart<R>],
    pressure: impl Fn(usize) -> Coefficients<R>,
) -> [R; 2] {
    let from_right = shape(parts.iter().rev(), true);
    let from_left = shape(parts.iter(), false);
    let count = parts.len();
    let mut forces = [R::ZERO; 2];
    for (i, part) in parts.iter().enumerate() {
        let phi_a = [from_right[count - i], from_right[count - i - 1]];
        let phi_b = [from_left[i], from_left[i + 1]];
        if i > 0 {
            let point_force = w.corner(part.cell);
            forces[0] += point_force * phi_a[0];
            forces[1] += point_force * phi_b[0];
        }
        if part.to > part.from {
            let under = part.under(trimmed(&pressure(part.cell)));
            forces[0] += (phi_a[0] * under[0] + phi_a[1] * under[1]) * part.half;
            forces[1] += (phi_b[0] * under[0] + phi_b[1] * under[1]) * part.half;
        }
    }
    forces
}

/// Returns an initial open span around a node with a tensile point force, or `None` if its end forces are not tensile.
pub(crate) fn opened(w: &Deflection, ends: [BeamPoint; 2]) -> Option<[BeamPoint; 2]> {
    let [a, b] = ends;
    if a.cell + 1 != b.cell || a.s < 1.0 || b.s > -1.0 {
        return None;
    }
    let pressure = ends.map(|point| w.obstacle_and_pressure(point)[2]);
    // On uniform ground, both end forces are zero if the span reaches twice as far. At this reach they are tensile.
    let reach = -w.corner(b.cell) / (4.0 * pressure[0].max(pressure[1]));
    let [before, after] = [a.cell, b.cell].map(|i| 2.0 * reach / w.mesh.cells[i].length());
    if !(reach > 0.0 && before < 2.0 && after < 2.0) {
        return None;
    }
    let points = [BeamPoint { s: 1.0 - before, ..a }, BeamPoint { s: after - 1.0, ..b }];
    let forces = ShortSpan::of(w, points.map(Some), |i| w.pressure(i))?.forces;
    (forces[0] < 0.0 && forces[1] < 0.0).then_some(points)
}

/// Computes the sum of the magnitudes of all terms of the pressure π in a cell.
fn pressure_size<R: Real>(w: &Deflection<R>, i: usize) -> f64 {
    let cell = &w.mesh.cells[i];
    let subgrade = cell.subgrade.value();
    let bend = 4.0 * cell.shear_layer.value() / (cell.length() * cell.length());
    let terms = w.obstacle(i);
    let sizes = terms.iter().zip(0_u8..).map(|(c, j)| {
        let j = f64::from(j);
        c.value().abs() * (subgrade + bend * j * (j - 1.0))
    });
    sizes.sum()
}

/// Computes the displacement of unloaded ground at the ends of consecutive parts: 0 at the first end, 1 at the last
/// end.
fn shape<'a, R: Real + 'a>(
    parts: impl Iterator<Item = &'a SpanPart<R>>,
    turned: bool,
) -> [R; MOST_CELLS + 1] {
    let mut values = [R::ZERO; MOST_CELLS + 1];
    let (mut phi, mut flux) = (R::ZERO, R::ONE);
    for (part, value) in parts.zip(&mut values[1..]) {
        [phi, flux] = part.cross(phi, flux, turned);
        *value = phi;
    }
    values.map(|value| value / phi)
}

/// Positive points and weights of Gauss quadrature with sixteen points on \[−1, 1\] (Abramowitz and Stegun, 1964, table
/// 25.4). A pressure series times a settlement shape needs its degree of 31.
const GAUSS_16: [(f64, f64); 8] = [
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_58),
    (0.458_016_777_657_227_37, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_8, 0.149_595_988_816_576_74),
    (0.755_404_408_355_003, 0.124_628_971_255_533_88),
    (0.865_631_202_387_831_8, 0.095_158_511_682_492_79),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_894),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_096),
];

/// All points and weights of [`GAUSS_16`], from left to right. Each point s has its mirror image −s.
const QUADRATURE: ([f64; 16], [f64; 16]) = {
    let (mut points, mut weights) = ([0.0; 16], [0.0; 16]);
    let mut i = 0;
    while i < 8 {
        let (s, weight) = GAUSS_16[i];
        (points[7 - i], points[8 + i]) = (-s, s);
        (weights[7 - i], weights[8 + i]) = (weight, weight);
        i += 1;
    }
    (points, weights)
};
const POINTS: [f64; 16] = QUADRATURE.0;
const WEIGHTS: [f64; 16] = QUADRATURE.1;
