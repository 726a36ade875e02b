//! Computes the contact forces at the ends of a short span of open ground from the pressure π that would close the span.
//!
//! A span of open ground extends from a to b. Its concentrated end forces are A = μψ'(a) − μu'(a) and B = μu'(b) −
//! μψ'(b), where μ is the stiffness of the shear layer, u the ground displacement and ψ the obstacle. If the span has
//! just opened, u and ψ differ only in the last digits, and so do their slopes. A and B are then small differences of
//! large numbers. The difference e = u − ψ is 0 at a and b, and −(μe')' + ke = −π between a and b, where k is the
//! subgrade modulus. Green's identity gives the forces without differences of slopes:
//!
//! > A = ∫ π φ_a dx, B = ∫ π φ_b dx,
//!
//! where φ_a is the surface of unloaded ground that is 1 at a and 0 at b, and φ_b is the surface that is 0 at a and 1
//! at b. The pressure π includes the point forces −\[μψ'\] of corners, where \[ \] denotes the jump at the corner. The
//! power series of ψ determines π, and the sign of π determines whether the span opens.
//!
//! For a span of length h and the machine precision ε, the rounding error of the differences of slopes is ε μψ/h, and
//! the rounding error of the integrals is ε h (kψ + μψ″). The functions use the formula with the smaller rounding
//! error.

use crate::ground::link::{Pair, TwoPort};
use crate::mesh::cell::Cell;
use crate::mesh::deflection::{BeamPoint, Deflection};
use crate::numeric::elementary::{cosh, sinh};
use crate::numeric::polynomial::{Coefficients, value};
use crate::numeric::real::Real;

/// Maximum number of cells from the cell of the left end of a short span to the cell of its right end, both
/// included. Up to two of these cells may lie beside the span and only touch its ends.
pub(crate) const MOST_CELLS: usize = 4;
/// Maximum length of a short span, in decay lengths √(μ/k) of the ground. In longer spans, contact forces computed
/// as differences of the slopes of beam and ground surface are accurate to twelve digits.
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
    /// Coefficients of the powers of s ∈ \[−1, 1\] in two settlement shapes of the ground surface. The first shape
    /// has the settlement 1 at the left end of the stretch and 0 at its right end. The second shape has the
    /// settlement 0 at the left end and 1 at the right end.
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

    /// Computes the settlement φ of the surface of unloaded ground, and the flux μφ', at the right end of this part
    /// of a cell from their values at the left end. If `turned` is true, computes φ and the flux −μφ' at the left
    /// end from their values at the right end. All terms are positive, so no digits cancel.
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

    /// Computes the integral ∫π φ ds over this part of a cell for two settlement shapes φ of unloaded ground, with
    /// the local coordinate s from −1 to 1 at the ends of the part. π, with the coefficients `pi`, is the pressure
    /// that the ground would have in contact. The first shape has the settlement 1 at the left end of the part and
    /// 0 at the right end, and the second shape 0 at the left end and 1 at the right end.
    fn under(&self, pi: &[R]) -> [R; 2] {
        let at = |t: f64| value(pi, self.from + t * (self.to - self.from));
        let mut under = [R::ZERO; 2];
        if let Some(ground) = &self.varying {
            for (x, weight) in GAUSS_16 {
                for s in [-x, x] {
                    let p = at(0.5 * (1.0 + s)) * weight;
                    for (under, surface) in under.iter_mut().zip(&ground.surfaces) {
                        *under += p * value(surface, s);
                    }
                }
            }
            return under;
        }
        // The settlement shape that is 1 at the right end is sinh(tz)/sinh(z). z is the length of the part times
        // √(k/μ), and t the distance from the left end divided by the length of the part.
        let square = self.length * self.length;
        for (x, weight) in GAUSS_16 {
            let t = 0.5 - 0.5 * x;
            let [near, far] = [t, 1.0 - t].map(|t| sinh_over(square * (t * t)) * t);
            let [p, q] = [t, 1.0 - t].map(at);
            under[0] += (p * far + q * near) * weight;
            under[1] += (p * near + q * far) * weight;
        }
        under.map(|under| under / sinh_over(square))
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

/// Computes the length of a part of a cell, times the decay rate b = √(k/μ) of the ground. `half` is half the length.
fn decay<R: Real>(cell: &Cell<R>, half: f64) -> R {
    (cell.subgrade / cell.shear_layer).sqrt() * 2.0 * half
}

/// Computes the forces on the ground at the left and the right end of a span of ground out of contact. `ends`
/// contains the contact edges at these ends, and `link` is the force–displacement relation of the span. If an entry
/// of `ends` is `None`, no contact zone adjoins this end, and the span includes the ground beyond this end of the
/// `GroundRun`.
pub(crate) fn fluxes<R: Real>(
    w: &Deflection<R>,
    ends: [Option<BeamPoint>; 2],
    link: &TwoPort<R>,
) -> [R; 2] {
    let of = |f: &dyn Fn(BeamPoint) -> R| ends.map(|end| end.map_or(R::ZERO, f));
    if let Some([a, b]) = end_forces(w, ends) {
        let [left, right] = of(&|point| w.flux(point));
        return [a - left, b + right];
    }
    let [left, right] = of(&|point| w.obstacle_at(point));
    [link.force_left(left, right), link.force_right(left, right)]
}

/// Computes the forces on open ground at both ends of a span between bonded contact zones. The forces include the
/// effect of the kinks that the concentrated forces at the edges of the zones cause in the beam.
pub(crate) fn bonded_fluxes<R: Real>(
    w: &Deflection<R>,
    ends: [Option<BeamPoint>; 2],
    link: &TwoPort<R>,
) -> [R; 2] {
    let kink = |end: Option<BeamPoint>| {
        end.map_or(R::ZERO, |point| w.flux(point) - w.flux(open_side(w, point)))
    };
    let [left, right] = fluxes(w, ends, link);
    match end_forces(w, ends) {
        Some(_) => [left + kink(ends[0]), right - kink(ends[1])],
        None => [left, right],
    }
}

/// If the concentrated force at the end `point` of a span kinks the beam, returns this end as a point of the
/// adjacent cell inside the span. Otherwise, returns `point` unchanged. At a corner of the obstacle, `point` is
/// also unchanged, because the forces of [`end_forces`] already contain the point force of the corner.
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

/// Computes the concentrated forces at the left and right end of a short span from integrals of the pressure π.
/// Returns `None` if the span is not short or if differences of slopes give the forces with a smaller rounding error.
pub(crate) fn end_forces<R: Real>(
    w: &Deflection<R>,
    ends: [Option<BeamPoint>; 2],
) -> Option<[R; 2]> {
    let [a, b] = [ends[0]?, ends[1]?];
    if b.cell < a.cell || b.cell - a.cell >= MOST_CELLS {
        return None;
    }
    let within = |i: usize| {
        let from = if i == a.cell { a.s } else { -1.0 };
        let to = if i == b.cell { b.s } else { 1.0 };
        [from, to]
    };
    let length =
        |i: usize| decay(&w.mesh.cells[i], half_length(&w.mesh.cells[i], within(i))).value();
    let whole: f64 = (a.cell..=b.cell).map(length).sum();
    if whole > LONGEST {
        return None;
    }
    let part = |i: usize| SpanPart::of(&w.mesh.cells[i], i, within(i));
    let parts: Vec<SpanPart<R>> = (a.cell..=b.cell).map(part).collect::<Option<_>>()?;
    if whole <= 0.0 {
        // A span of zero length lies at a node between two candidate contact intervals, at which the ground carries a
        // point force. Half of this force is assigned to each end of the span. If the force is tensile, the beam leaves
        // the ground at the node.
        let half_force = parts.iter().skip(1).map(|part| w.corner(part.cell) * 0.5).sum();
        return Some([half_force; 2]);
    }
    let noise: f64 = parts.iter().map(|part| 2.0 * part.half * pressure_size(w, part.cell)).sum();
    let soft: f64 = parts
        .iter()
        .map(|part| 2.0 * part.half / w.mesh.cells[part.cell].shear_layer.value())
        .sum();
    if noise * soft > w.obstacle_at(a).value().abs() + w.obstacle_at(b).value().abs() {
        return None;
    }
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
            let under = part.under(&w.pressure(part.cell));
            forces[0] += (phi_a[0] * under[0] + phi_a[1] * under[1]) * part.half;
            forces[1] += (phi_b[0] * under[0] + phi_b[1] * under[1]) * part.half;
        }
    }
    Some(forces)
}

/// Computes the initial open span around a node between two candidate contact intervals, at which the ground would
/// carry a tensile point force T. On uniform ground with constant pressure π, the forces at both ends of the span
/// vanish if the span extends by T/(2π) to each side. The initial span extends half as far, so both end forces are
/// still tensile. Returns `None` if the computed end forces are not tensile.
pub(crate) fn opened(w: &Deflection, ends: [BeamPoint; 2]) -> Option<[BeamPoint; 2]> {
    let [a, b] = ends;
    if a.cell + 1 != b.cell || a.s < 1.0 || b.s > -1.0 {
        return None;
    }
    let pressure = ends.map(|point| w.obstacle_and_pressure(point)[2]);
    let reach = -w.corner(b.cell) / (4.0 * pressure[0].max(pressure[1]));
    let [before, after] = [a.cell, b.cell].map(|i| 2.0 * reach / w.mesh.cells[i].length());
    if !(reach > 0.0 && before < 2.0 && after < 2.0) {
        return None;
    }
    let points = [BeamPoint { s: 1.0 - before, ..a }, BeamPoint { s: after - 1.0, ..b }];
    let forces = end_forces(w, points.map(Some))?;
    (forces[0] < 0.0 && forces[1] < 0.0).then_some(points)
}

/// Computes the sum of the magnitudes of all terms of the pressure π in a cell.
fn pressure_size<R: Real>(w: &Deflection<R>, i: usize) -> f64 {
    let cell = &w.mesh.cells[i];
    let subgrade = cell.subgrade.value();
    let bend = 4.0 * cell.shear_layer.value() / (cell.length() * cell.length());
    let terms = w.obstacle(i);
    let terms = terms.iter().enumerate();
    terms.map(|(j, c)| c.value().abs() * (subgrade + bend * (j * j.saturating_sub(1)) as f64)).sum()
}

/// Computes the displacement of unloaded ground under consecutive parts of the span, each in one cell. The displacement
/// is 0 at the start of the first part and 1 at the end of the last part. Returns its values at the ends of all parts.
fn shape<'a, R: Real + 'a>(parts: impl Iterator<Item = &'a SpanPart<R>>, turned: bool) -> Vec<R> {
    let mut values = vec![R::ZERO];
    let (mut phi, mut flux) = (R::ZERO, R::ONE);
    for part in parts {
        [phi, flux] = part.cross(phi, flux, turned);
        values.push(phi);
    }
    values.iter().map(|value| *value / phi).collect()
}

/// Points and weights of Gauss quadrature with sixteen points on \[−1, 1\] (Abramowitz and Stegun, 1964, table 25.4).
/// The rule is exact to degree 31. The product of the power series of a cell and the shape function of the ground
/// needs this degree.
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
