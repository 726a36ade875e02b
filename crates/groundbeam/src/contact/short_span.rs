//! The contact forces at the ends of a short open span, from the pressure that would close it.
//!
//! In a gap that has just opened, u and ψ differ only in the last digits, and so do their slopes. The concentrated
//! forces A = μψ'(a) − μu'(a) and B = μu'(b) − μψ'(b) are then small differences of large numbers. With e = u − ψ,
//! −(μe')' + ke = −π between a and b, and e = 0 at both ends, Green's identity avoids these differences:
//!
//! > A = ∫ π φ_a dx,  B = ∫ π φ_b dx,
//!
//! where φ_a is the surface of unloaded ground that is 1 at a and 0 at b, φ_b the same with a and b exchanged, and π
//! includes the point forces −\[μψ'\] of corners. π is computed from the coefficients of ψ, and its sign determines
//! whether the span opens. The rounding error is ε μψ/h in the differences and ε h (kψ + μψ″) in the integrals. The
//! formula with the smaller one is used.

use crate::ground::link::{TwoPort, between, settled};
use crate::mesh::cell::Cell;
use crate::mesh::deflection::{BeamPoint, Deflection};
use crate::numeric::elementary::{cosh, sinh};
use crate::numeric::polynomial::value;
use crate::numeric::real::Real;

/// Maximum number of cells of a short span; three are a gap and the cells beside it.
pub(crate) const MOST_CELLS: usize = 4;
/// Maximum length of a short span in decay lengths √(μ/k) of the ground. In longer spans the differences keep twelve
/// digits.
const LONGEST: f64 = 0.03;

/// A part of a cell within a short span, and the data of its ground.
struct SpanPart<R> {
    cell: usize,
    from: f64,
    to: f64,
    /// Half the length of the part \[m\].
    half: f64,
    /// b times the length of the part.
    length: R,
    stiffness: R,
    /// If the ground varies: the part as a cell, and its two-port.
    varying: Option<(Cell<R>, TwoPort<R>)>,
}

impl<R: Real> SpanPart<R> {
    fn of(cell: &Cell<R>, i: usize, [from, to]: [f64; 2]) -> Option<Self> {
        let half = half_length(cell, [from, to]);
        let length = decay(cell, half);
        let stiffness = (cell.subgrade * cell.shear_layer).sqrt();
        let mut part = SpanPart { cell: i, from, to, half, length, stiffness, varying: None };
        if cell.ground_varies() && to > from {
            let own = cell.part([from, to]);
            if !own.is_smooth() || !own.is_short_for_open_ground(half) {
                return None;
            }
            let link = TwoPort::varying(&own.subgrade_along(), &own.shear_layer_along(), half);
            part.varying = Some((own, link));
        }
        Some(part)
    }

    /// Value and flux of unloaded ground at the right end of the part, from those at the left end. With `turned`, from
    /// right to left. Each step adds positive numbers only.
    fn cross(&self, phi: R, flux: R, turned: bool) -> [R; 2] {
        if let Some((_, link)) = &self.varying {
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

    /// ∫π φ over the part, in units of its half length, for the two φ that are 1 at its left or right end and 0 at the
    /// other.
    fn under(&self, pi: &[R]) -> [R; 2] {
        let at = |t: f64| value(pi, self.from + t * (self.to - self.from));
        let mut under = [R::ZERO; 2];
        if let Some((cell, _)) = &self.varying {
            let (spring, shear) = (cell.subgrade_along(), cell.shear_layer_along());
            let shapes = [[R::ONE, R::ZERO], [R::ZERO, R::ONE]]
                .map(|ends| settled(&spring, &shear, self.half, ends));
            for (x, weight) in GAUSS_16 {
                for s in [-x, x] {
                    let p = at(0.5 * (1.0 + s)) * weight;
                    under[0] += p * value(&shapes[0], s);
                    under[1] += p * value(&shapes[1], s);
                }
            }
            return under;
        }
        for (x, weight) in GAUSS_16 {
            let t = 0.5 - 0.5 * x;
            let near = between(R::ZERO, R::ONE, self.length, t);
            let far = between(R::ONE, R::ZERO, self.length, t);
            let [p, q] = [t, 1.0 - t].map(at);
            under[0] += (p * far + q * near) * weight;
            under[1] += (p * near + q * far) * weight;
        }
        under
    }
}

/// Half the length of a part of a cell.
fn half_length<R: Real>(cell: &Cell<R>, [from, to]: [f64; 2]) -> f64 {
    0.25 * (to - from) * cell.length()
}

/// b times the length of a part, for b² = k/μ.
fn decay<R: Real>(cell: &Cell<R>, half: f64) -> R {
    (cell.subgrade / cell.shear_layer).sqrt() * 2.0 * half
}

/// Forces on open ground at both ends of a span, where its surface is at ψ. `link` is the two-port of the span. A
/// missing end means that the span includes the ground beyond the run.
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

/// The forces on open ground between edges at which the beam is bonded, with the kinks of the beam that the
/// concentrated forces cause there.
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

/// The end of a span as a point of the open cell beside it, if the beam has a kink there due to the concentrated force
/// at its bonded edge. Other kinks are corners, which are contained in A and B.
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

/// A and B of a span; `None` if the span is not short.
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
        // Two candidate intervals meet at a corner of ψ. Each side takes half of the corner's force; the beam leaves the
        // ground at the corner if this force is tensile.
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

/// The initial span at a corner in tension between two candidate intervals. On uniform ground with constant π, both forces
/// vanish where the span reaches |c|/2π to each side of a corner with the tension c. Half of this length still has
/// tension at both ends, and the tangent points are two or three steps away. `None` if the computed forces are not in
/// tension.
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

/// Sum of the magnitudes of the terms of π in a cell.
fn pressure_size<R: Real>(w: &Deflection<R>, i: usize) -> f64 {
    let cell = &w.mesh.cells[i];
    let subgrade = cell.subgrade.value();
    let bend = 4.0 * cell.shear_layer.value() / (cell.length() * cell.length());
    let terms = w.obstacle(i);
    let terms = terms.iter().enumerate();
    terms.map(|(j, c)| c.value().abs() * (subgrade + bend * (j * j.saturating_sub(1)) as f64)).sum()
}

/// The surface of unloaded ground over consecutive parts, 0 at the start of the first part and 1 at the end of the
/// last: its values at all ends of parts.
fn shape<'a, R: Real + 'a>(parts: impl Iterator<Item = &'a SpanPart<R>>, turned: bool) -> Vec<R> {
    let mut values = vec![R::ZERO];
    let (mut phi, mut flux) = (R::ZERO, R::ONE);
    for part in parts {
        [phi, flux] = part.cross(phi, flux, turned);
        values.push(phi);
    }
    values.iter().map(|value| *value / phi).collect()
}

/// Gauss's rule with sixteen points on \[−1, 1\], exact to degree 31: the power series of a cell times the ground's
/// shape function. Abramowitz and Stegun (1964), table 25.4.
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
