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
    /// Left end \[m\].
    pub from: f64,
    /// Right end \[m\].
    pub to: f64,
}

/// The concentrated contact forces p₀ and p_l of (2.6), not negative, pushing the beam up \[N\].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct EndForces {
    /// p₀, at x = 0.
    pub left: f64,
    /// p_l, at x = l.
    pub right: f64,
}

/// A concentrated contact force inside the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ConcentratedForce {
    /// Position \[m\].
    pub at: f64,
    /// Force, pushing the beam up \[N\].
    pub force: f64,
}

/// The force and the moment of a support on the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Reaction {
    /// Position \[m\].
    pub at: f64,
    /// Force, positive where it pushes the beam up \[N\].
    pub force: f64,
    /// Moment, positive where it rotates the right side down \[N·m\].
    pub moment: f64,
}

/// The side from which a value is taken where a field jumps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Just left of the position.
    Left,
    /// Just right of the position.
    Right,
}

/// All fields at one point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fields {
    /// w, down positive \[m\].
    pub deflection: f64,
    /// w' \[rad\].
    pub slope: f64,
    /// φ, the rotation of the sections: w' where the beam has no shear deformation \[rad\].
    pub rotation: f64,
    /// M = −EI (φ' − κ₀), sagging positive, κ₀ the imposed curvature; φ' = w″ where the beam has no shear
    /// deformation \[N·m\].
    pub moment: f64,
    /// V = M' \[N\].
    pub shear_force: f64,
    /// u, the ground's surface, down positive \[m\].
    pub settlement: f64,
    /// u + g₀ − w, not negative \[m\].
    pub gap: f64,
    /// p, not negative, pushing the beam up \[N/m\].
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
    /// Position \[m\]; the leftmost one of several equal extremes.
    pub x: f64,
    /// Value of the field there.
    pub value: f64,
}

/// The smallest and the largest value of a field on the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Range {
    /// The smallest value.
    pub min: Extreme,
    /// The largest value.
    pub max: Extreme,
}

/// A part of the beam on which every field has one closed form.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SolutionPiece<R = f64> {
    /// Ends of the piece \[m\].
    pub x: [f64; 2],
    /// Half the length \[m\]. It is more accurate than the difference of the rounded ends.
    pub half: f64,
    /// The cell that contains the piece, cut to the ends of the piece: coefficients of ground, beam and
    /// loads.
    pub cell: Cell<R>,
    /// Coefficients of w(s).
    pub deflection: Coefficients<R>,
    /// Coefficients of φ(s); empty if the beam has no shear deformation.
    pub rotation: Coefficients<R>,
    /// Coefficients of M(s).
    pub moment: Coefficients<R>,
    /// Coefficients of p(s).
    pub pressure: Coefficients<R>,
    /// On open ground: u − u₀ at both ends, with the free-field settlement u₀.
    pub open: Option<[R; 2]>,
    /// On open varying ground: coefficients of u(s).
    pub settlement: Coefficients<R>,
}

impl<R: Real> SolutionPiece<R> {
    /// A part of a cell, from the coefficients of w and of φ in this cell. `presses` means that the contact
    /// pressure is distributed.
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

    /// The length of the open ground in decay lengths, b·h.
    fn decay(&self) -> R {
        (self.cell.subgrade / self.cell.shear_layer).sqrt() * 2.0 * self.half
    }

    fn gap_at(&self, s: f64) -> R {
        let [left, right] = self.cell.gap;
        (left + right) * 0.5 + (right - left) * 0.5 * s
    }

    /// One field, with the same bits as in [`SolutionPiece::fields`].
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

    /// u and u'.
    pub(crate) fn settlement(&self, s: f64, w: R, slope: R) -> [R; 2] {
        match self.open {
            None => [w - self.gap_at(s), slope - self.cell.gap_slope],
            Some(ends) => {
                let ([u, du], [own, sinks]) = (self.pressed(s, ends), self.cell.free_field_at(s));
                [u + own, du + sinks]
            }
        }
    }

    /// u and u' of open ground due to the contact pressure outside the open part, without the free field.
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

/// The coefficients of M = −EI (φ' − κ₀), with φ = w' where the beam has no shear deformation.
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
