//! Fields, forces and contact zones of a solution, and the closed forms of the fields on a part of the beam.

use crate::contact::surface::SurfacePart;
use crate::ground::link;
use crate::mesh::cell::Cell;
use crate::mesh::deflection::pressure_under;
use crate::numeric::polynomial::{
    Coefficients, derivative, jet, product, rescale, value, with_slope,
};
use crate::numeric::real::Real;
use crate::solution::field::Field;

/// A contact zone between beam and ground. The ends of a point contact are equal.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ContactZone {
    /// Left end of the contact zone \[m\].
    pub from: f64,
    /// Right end of the contact zone \[m\].
    pub to: f64,
}

/// The concentrated contact forces p₀ and p_l at the ends of the beam \[N\], (2.6) of Kikuchi's paper. They push the
/// beam up and are not negative.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct EndForces {
    /// Contact force p₀ at x = 0 \[N\].
    pub left: f64,
    /// Contact force p_l at x = l \[N\].
    pub right: f64,
}

/// A concentrated contact force inside the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ConcentratedForce {
    /// Position of the force \[m\].
    pub at: f64,
    /// Force of the ground that pushes the beam up \[N\].
    pub force: f64,
}

/// The side of a position from which the value of a field is taken if the field jumps at this position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The limit from the left.
    Left,
    /// The limit from the right.
    Right,
}

/// All fields at one point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fields {
    /// Deflection w, positive downwards \[m\].
    pub deflection: f64,
    /// Slope w' \[rad\].
    pub slope: f64,
    /// Rotation φ of the cross-sections \[rad\]. It equals w' where the beam has no shear deformation.
    pub rotation: f64,
    /// Bending moment M = −EI (φ' − κ₀), positive in sagging \[N·m\], with the rotation φ and the imposed curvature κ₀.
    pub moment: f64,
    /// Shear force V = M' \[N\].
    pub shear_force: f64,
    /// Settlement u of the ground's surface, positive downwards \[m\].
    pub settlement: f64,
    /// Gap u + g₀ − w between beam and ground, not negative \[m\].
    pub gap: f64,
    /// Contact pressure p, which pushes the beam up and is not negative \[N/m\].
    pub pressure: f64,
}

impl Fields {
    /// The value of one field.
    pub fn get(&self, field: Field) -> f64 {
        match field {
            Field::Deflection => self.deflection,
            Field::Slope => self.slope,
            Field::Rotation => self.rotation,
            Field::Moment => self.moment,
            Field::ShearForce => self.shear_force,
            Field::Settlement => self.settlement,
            Field::Gap => self.gap,
            Field::Pressure => self.pressure,
        }
    }
}

/// The largest or the smallest value of a field, and its position.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Extreme {
    /// Position of the extreme \[m\]. If several extremes are equal, it is the leftmost position.
    pub x: f64,
    /// Largest or smallest value of the field.
    pub value: f64,
}

/// The smallest and the largest value of a field on the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Range {
    /// The smallest value of the field, and its position.
    pub min: Extreme,
    /// The largest value of the field, and its position.
    pub max: Extreme,
}

/// A part of the beam on which every field has one closed form.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SolutionPiece<R = f64> {
    /// Ends of the piece \[m\].
    pub x: [f64; 2],
    /// Half the length of the piece \[m\]. It is more accurate than half the difference of the rounded ends.
    pub half: f64,
    /// The part of the mesh cell between the ends of the piece, with the coefficients of ground, beam and loads.
    pub cell: Cell<R>,
    /// Coefficients of w(s).
    pub deflection: Coefficients<R>,
    /// Coefficients of φ(s); empty if the beam has no shear deformation.
    pub rotation: Coefficients<R>,
    /// Coefficients of M(s).
    pub moment: Coefficients<R>,
    /// Coefficients of p(s).
    pub pressure: Coefficients<R>,
    /// Settlements u − u₀ at both ends of a piece out of contact, with the free-field settlement u₀; `None` in contact.
    pub open: Option<[R; 2]>,
    /// Coefficients of the settlement minus the free-field settlement, on open ground with a shear layer where k or μ
    /// varies; else empty.
    pub settlement: Coefficients<R>,
}

impl<R: Real> SolutionPiece<R> {
    /// Creates a piece from the deflection and the rotation of its cell. `presses` is false if all contact forces are
    /// concentrated at nodes.
    pub fn of(
        cell: &Cell<R>,
        part: &SurfacePart<R>,
        deflection: &[R],
        rotation: Option<&[R]>,
        presses: bool,
    ) -> Self {
        let [from, to] = part.s;
        let (middle, quarter) = (0.5 * (from + to), 0.5 * (to - from));
        let half = 0.5 * cell.length() * quarter;
        let whole = part.s == [-1.0, 1.0];
        let own = |c: &[R]| if whole { c.into() } else { rescale(c, middle, quarter) };
        let cell = if whole { *cell } else { cell.part(part.s) };
        let (deflection, rotation) = (own(deflection), rotation.map(own).unwrap_or_default());
        let pressure = if part.open.is_none() && presses {
            pressure_under(&cell, half, &deflection)
        } else {
            Coefficients::default()
        };
        let settlement = match part.open {
            Some(ends) if cell.ground_varies() && cell.shear_layer.value() > 0.0 => {
                link::settled(&cell.subgrade_along(), &cell.shear_layer_along(), half, ends)
            }
            _ => Coefficients::default(),
        };
        let moment = bent(&cell, half, &deflection, &rotation);
        SolutionPiece {
            half,
            x: cell.x,
            cell,
            deflection,
            rotation,
            moment,
            pressure,
            open: part.open,
            settlement,
        }
    }

    /// Length of the piece divided by the decay length √(μ/k) of the ground.
    fn decay(&self) -> R {
        (self.cell.subgrade / self.cell.shear_layer).sqrt() * 2.0 * self.half
    }

    fn gap_at(&self, s: f64) -> R {
        let [left, right] = self.cell.gap;
        (left + right) * 0.5 + (right - left) * 0.5 * s
    }

    /// Value of one field at the local coordinate s of the piece, bitwise equal to the value in
    /// [`SolutionPiece::fields`].
    pub(crate) fn one(&self, field: Field, s: f64) -> R {
        let per_length = 1.0 / self.half;
        match field {
            Field::Deflection => value(&self.deflection, s),
            Field::Rotation if !self.rotation.is_empty() => value(&self.rotation, s),
            Field::Slope | Field::Rotation => with_slope(&self.deflection, s)[1] * per_length,
            Field::Moment => value(&self.moment, s),
            Field::ShearForce => with_slope(&self.moment, s)[1] * per_length,
            Field::Pressure => value(&self.pressure, s),
            Field::Gap if self.open.is_none() => R::ZERO,
            Field::Settlement | Field::Gap => {
                let [w, dw] = with_slope(&self.deflection, s);
                let [settlement, _] = self.settlement(s, w, dw * per_length);
                if field == Field::Gap { settlement + self.gap_at(s) - w } else { settlement }
            }
        }
    }

    /// Settlement u of the ground and its derivative u' with respect to x, at the local coordinate s of the piece.
    pub(crate) fn settlement(&self, s: f64, w: R, slope: R) -> [R; 2] {
        match self.open {
            None => [w - self.gap_at(s), slope - self.cell.gap_slope],
            Some(ends) => {
                let ([u, du], [own, sinks]) = (self.pressed(s, ends), self.cell.free_field_at(s));
                [u + own, du + sinks]
            }
        }
    }

    /// Settlement minus the free-field settlement, and its derivative with respect to x, at s on a piece out of
    /// contact.
    pub(crate) fn pressed(&self, s: f64, [left, right]: [R; 2]) -> [R; 2] {
        if [left, right] == [R::ZERO; 2] {
            return [R::ZERO; 2];
        }
        if !self.settlement.is_empty() {
            let [u, du, ..] = jet(&self.settlement, s);
            return [u, du / self.half];
        }
        let t = 0.5 * (1.0 + s);
        let bh = self.decay();
        let b = bh / (2.0 * self.half);
        let slope = link::slope_between(left, right, bh, t);
        [link::between(left, right, bh, t), b * slope]
    }

    pub(crate) fn local(&self, x: f64) -> f64 {
        let [from, to] = self.x;
        let s = if x - from <= to - x {
            (x - from) / self.half - 1.0
        } else {
            1.0 - (to - x) / self.half
        };
        s.clamp(-1.0, 1.0)
    }

    pub(crate) fn global(&self, s: f64) -> f64 {
        let [from, to] = self.x;
        if s <= 0.0 { from + self.half * (1.0 + s) } else { to - self.half * (1.0 - s) }
    }
}

impl SolutionPiece {
    pub(crate) fn fields(&self, s: f64) -> Fields {
        let per_length = 1.0 / self.half;
        let [w, dw, ..] = jet(&self.deflection, s);
        let slope = dw * per_length;
        let [moment, dm, ..] = jet(&self.moment, s);
        let [settlement, _] = self.settlement(s, w, slope);
        let gap = match self.open {
            None => 0.0,
            Some(_) => settlement + self.gap_at(s) - w,
        };
        Fields {
            deflection: w,
            slope,
            rotation: if self.rotation.is_empty() { slope } else { value(&self.rotation, s) },
            moment,
            shear_force: dm * per_length,
            settlement,
            gap,
            pressure: value(&self.pressure, s),
        }
    }
}

/// Coefficients of the bending moment M = −EI (φ' − κ₀). Where the beam has no shear deformation, φ = w'.
fn bent<R: Real>(cell: &Cell<R>, half: f64, deflection: &[R], rotation: &[R]) -> Coefficients<R> {
    let times = if cell.beam_varies() { R::ONE } else { cell.stiffness };
    let (factor, mut bend) = if rotation.is_empty() {
        (-times / (half * half), derivative(&derivative(deflection)))
    } else {
        (-times / half, derivative(rotation))
    };
    for c in bend.iter_mut() {
        *c *= factor;
    }
    let bent = if cell.beam_varies() { product(&cell.stiffness_along(), &bend) } else { bend };
    if !cell.has_imposed_curvature() {
        return bent;
    }
    let curling = cell.imposed_moment();
    let mut moment = bent.at_least(curling.len());
    for (moment, curling) in moment.iter_mut().zip(curling.iter()) {
        *moment += *curling;
    }
    moment
}
