//! Bounds of a field's values on a piece of the beam, from the coefficients of its polynomial.

use crate::numeric::polynomial::derivative;
use crate::solution::field::Field;
use crate::solution::fields::SolutionPiece;

/// Approximate values of a field at the ends of a piece, and lower and upper bounds of the field on the whole
/// piece.
pub(super) struct FieldBounds {
    pub ends: [f64; 2],
    pub bounds: [f64; 2],
    /// Bound of the rounding error of the values at the ends.
    pub rounding: f64,
}

impl FieldBounds {
    /// Computes bounds of the polynomial Σ cⱼ sʲ on −1 ≤ s ≤ 1: the line through its end values plus bounds of the
    /// difference.
    fn of(c: &[f64]) -> Self {
        let [first, second] = [0, 1].map(|j| c.get(j).copied().unwrap_or(0.0));
        let ([mut even, mut odd], [mut above, mut apart]) = ([0.0; 2], [0.0; 2]);
        // The difference consists of cⱼ (sʲ − 1) for even j, between −cⱼ and 0, and cⱼ (sʲ − s) for odd j, at most
        // |cⱼ|.
        for pair in c.get(2..).unwrap_or_default().chunks(2).rev() {
            let [a, b] = [pair[0], pair.get(1).copied().unwrap_or(0.0)];
            even += a;
            odd += b;
            above += a.max(0.0);
            apart += b.abs();
        }
        let below = above - even;
        let (even, odd) = (first + even, second + odd);
        let ends = [even - odd, even + odd];
        let bounds = [ends[0].min(ends[1]) - above - apart, ends[0].max(ends[1]) + below + apart];
        let size = first.abs() + second.abs() + above + below + apart;
        FieldBounds { ends, bounds, rounding: c.len() as f64 * f64::EPSILON * size }
    }

    fn times(self, factor: f64) -> Self {
        let [ends, bounds] = [self.ends, self.bounds].map(|pair| pair.map(|of| of * factor));
        FieldBounds { ends, bounds, rounding: self.rounding * factor }
    }
}

impl SolutionPiece {
    /// Approximate values of a field at the ends of this piece, and bounds of the field on the whole piece.
    pub(super) fn field_bounds(&self, field: Field) -> FieldBounds {
        let per_length = 1.0 / self.half;
        match field {
            Field::Deflection => FieldBounds::of(&self.deflection),
            Field::Rotation if !self.rotation.is_empty() => FieldBounds::of(&self.rotation),
            Field::Slope | Field::Rotation => {
                FieldBounds::of(&derivative(&self.deflection)).times(per_length)
            }
            Field::Moment => FieldBounds::of(&self.moment),
            Field::ShearForce => FieldBounds::of(&derivative(&self.moment)).times(per_length),
            Field::Pressure => FieldBounds::of(&self.pressure),
            Field::Settlement if self.open.is_none() => {
                let FieldBounds { ends, bounds: [least, most], rounding } =
                    FieldBounds::of(&self.deflection);
                let [a, b] = self.cell.gap;
                let bounds = [least - a.max(b), most - a.min(b)];
                let rounding = rounding + f64::EPSILON * (a.abs() + b.abs());
                FieldBounds { ends: [ends[0] - a, ends[1] - b], bounds, rounding }
            }
            Field::Gap if self.open.is_none() => FieldBounds::of(&[]),
            // Out of contact, the settlement and the gap are not polynomials, so they get infinite bounds.
            Field::Settlement | Field::Gap => FieldBounds {
                ends: [-1.0, 1.0].map(|s| self.one(field, s)),
                bounds: [f64::NEG_INFINITY, f64::INFINITY],
                rounding: 0.0,
            },
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::solution::candidate::{Candidate, Workspace};
    use crate::{Beam, Foundation, Model};

    /// A piece in contact with ground of k = μ = 1 without initial gap. All its fields are zero.
    pub fn piece(x: [f64; 2]) -> SolutionPiece {
        let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0));
        let mut cell = crate::mesh::mesh::Mesh::build(&model, &[], |_| 1).cells[0];
        cell.x = x;
        let none = crate::numeric::polynomial::Coefficients::default();
        let half = 0.5 * (x[1] - x[0]);
        let [deflection, rotation, moment, pressure, settlement] = [none; 5];
        SolutionPiece {
            x,
            half,
            cell,
            deflection,
            rotation,
            moment,
            pressure,
            open: None,
            settlement,
        }
    }

    pub fn candidate(pieces: Vec<SolutionPiece>) -> Candidate {
        let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0));
        Candidate { pieces, ..Workspace::default().blank(&model) }
    }

    #[track_caller]
    pub fn near(found: &[f64], wanted: &[f64]) {
        let all = found.len() == wanted.len();
        let close = found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-14);
        assert!(all && close, "{found:?} {wanted:?}");
    }

    /// The difference from the line through the ends is −3 to 5 from the terms 3s² − 5s⁴, and at most 10 from −4s³ +
    /// 6s⁵.
    #[test]
    fn a_hull_is_the_line_between_the_ends_and_what_the_powers_add() {
        let FieldBounds { ends, bounds, rounding } =
            FieldBounds::of(&[1.0, 2.0, 3.0, -4.0, -5.0, 6.0]);
        assert_eq!((ends, bounds), ([-5.0, 3.0], [-18.0, 18.0]));
        assert_eq!(rounding, 6.0 * f64::EPSILON * 21.0);
        // The next two polynomials are the first one mirrored, and the first one with the opposite sign.
        let mirrored = FieldBounds::of(&[1.0, -2.0, 3.0, 4.0, -5.0, -6.0]);
        assert_eq!((mirrored.ends, mirrored.bounds), ([3.0, -5.0], [-18.0, 18.0]));
        let below = FieldBounds::of(&[-1.0, -2.0, -3.0, 4.0, 5.0, -6.0]);
        assert_eq!((below.ends, below.bounds), ([5.0, -3.0], [-18.0, 18.0]));
        let short = FieldBounds::of(&[1.0, 2.0, 4.0]);
        assert_eq!((short.ends, short.bounds), ([3.0, 7.0], [-1.0, 7.0]));
        let half = short.times(0.5);
        assert_eq!((half.ends, half.bounds), ([1.5, 3.5], [-0.5, 3.5]));
        assert_eq!(half.rounding, 0.5 * 3.0 * f64::EPSILON * 7.0);
        let constant = FieldBounds::of(&[-7.0]);
        assert_eq!((constant.ends, constant.bounds), ([-7.0; 2], [-7.0; 2]));
        let zero = FieldBounds::of(&[]);
        assert_eq!((zero.ends, zero.bounds, zero.rounding), ([0.0; 2], [0.0; 2], 0.0));
    }

    /// Slope and shear force are derivatives with respect to s, divided by half the length. In contact the settlement
    /// is w − g₀.
    #[test]
    fn the_hull_of_each_field() {
        let mut of = piece([0.0, 4.0]);
        of.deflection = [2.0, 0.0, 1.0, 4.0][..].into();
        of.moment = [0.0, 3.0, 2.0][..].into();
        of.pressure = [5.0, 1.0][..].into();
        (of.cell.gap, of.cell.gap_slope) = ([0.5, -1.5], -0.5);
        let bounds_of = |field| {
            let FieldBounds { ends, bounds, rounding } = of.field_bounds(field);
            (ends, bounds, rounding / f64::EPSILON)
        };
        assert_eq!(bounds_of(Field::Deflection), ([-1.0, 7.0], [-6.0, 11.0], 4.0 * 7.0));
        // Half the length of the piece is 2, so the slope is dw/dx = (dw/ds)/2 = (2s + 12s²)/2.
        assert_eq!(bounds_of(Field::Slope), ([5.0, 7.0], [-1.0, 7.0], 0.5 * 3.0 * 14.0));
        assert_eq!(bounds_of(Field::Moment), ([-1.0, 5.0], [-3.0, 5.0], 3.0 * 5.0));
        assert_eq!(bounds_of(Field::ShearForce), ([-0.5, 3.5], [-0.5, 3.5], 0.5 * 2.0 * 7.0));
        assert_eq!(bounds_of(Field::Pressure), ([4.0, 6.0], [4.0, 6.0], 2.0 * 6.0));
        assert_eq!(bounds_of(Field::Settlement), ([-1.5, 8.5], [-6.5, 12.5], 28.0 + 2.0));
        assert_eq!(bounds_of(Field::Gap), ([0.0; 2], [0.0; 2], 0.0));
        of.open = Some([1.0, 2.0]);
        for (field, ends) in [(Field::Settlement, [1.0, 2.0]), (Field::Gap, [2.5, -6.5])] {
            let open = of.field_bounds(field);
            near(&open.ends, &ends);
            assert_eq!(open.bounds, [f64::NEG_INFINITY, f64::INFINITY]);
            assert_eq!(open.rounding, 0.0);
        }
    }
}
