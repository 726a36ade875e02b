//! Finds the position of the largest or smallest value of a field, and the slope of the field there if it is not stationary.

use crate::numeric::elementary::power;
use crate::numeric::polynomial::{derivative, jet, value};
use crate::numeric::tolerance::{OTHER_EXTREME, TURNING_POINT};
use crate::solution::field::Field as Quantity;
use crate::solution::fields::Side;
use crate::solution::solution::Solution;

/// Position of the largest or smallest value of a field.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub x: f64,
    /// Side of the position x on which the field has the extreme value.
    pub side: Side,
    pub value: f64,
    /// Derivative of the field with respect to x at the extreme; 0 if the field is stationary.
    pub slope: f64,
    /// Whether the value is the same for all values of the parameters. Examples are the zero gap in contact and the
    /// zero pressure outside contact.
    pub always: bool,
    /// Another position at which the field has the same extreme value.
    pub rival: Option<f64>,
}

/// Two extreme values of a field count as equal if their relative difference is below this bound.
const EQUAL_EXTREME: f64 = 1e-7;

impl Solution {
    /// Finds the position of the largest or smallest value of a field.
    pub(super) fn extreme(&self, field: Quantity, largest: bool) -> Place {
        let sign = if largest { 1.0 } else { -1.0 };
        let mut best: Option<(usize, f64, f64)> = None;
        let mut all: Vec<(f64, f64)> = Vec::new();
        for (i, piece) in self.pieces().iter().enumerate() {
            for s in piece.candidates(field) {
                let value = piece.fields(s).get(field);
                all.push((piece.global(s), value));
                if best.is_none_or(|(_, _, best)| sign * value > sign * best) {
                    best = Some((i, s, value));
                }
            }
        }
        let Some((i, s, value)) = best else {
            let (x, side) = (0.0, Side::Right);
            return Place { x, side, value: 0.0, slope: 0.0, always: true, rival: None };
        };
        let (x, l) = (self.pieces()[i].global(s), self.model().beam.length);
        let size = all.iter().map(|(_, value)| value.abs()).fold(0.0, f64::max);
        // In contact the gap is zero for all parameters; outside contact the pressure is zero.
        let touches = self.contact().iter().any(|region| region.from <= x && x <= region.to);
        let closed = field == Quantity::Gap && !largest && touches;
        let always = closed || value == 0.0 && matches!(field, Quantity::Gap | Quantity::Pressure);
        let rival = all
            .iter()
            .filter(|_| !always)
            .filter(|(at, other)| {
                (at - x).abs() > OTHER_EXTREME * l && (other - value).abs() <= EQUAL_EXTREME * size
            })
            .map(|(at, _)| *at)
            .next();
        // A stationary point of the field that lies within rounding error of an end of its piece of the solution is
        // moved to this end.
        let end = self.pieces()[i].x[usize::from(s > 0.0)];
        let x = if (x - end).abs() <= TURNING_POINT * l { end } else { x };
        let side = if s > 0.0 { Side::Left } else { Side::Right };
        let slope = if s.abs() < 1.0 || always { 0.0 } else { self.rise(i, s, field) };
        Place { x, side, value, slope, always, rival }
    }

    /// Computes the derivative of a field with respect to x at the coordinate s of piece i of the solution.
    fn rise(&self, i: usize, s: f64, field: Quantity) -> f64 {
        let piece = &self.pieces()[i];
        let half = piece.half;
        let fields = piece.fields(s);
        let moments = |order: usize| {
            let c = (0..order).fold(piece.moment, |c, _| derivative(&c));
            value(&c, s) / power(half, order)
        };
        let settles = || piece.settlement(s, fields.deflection, fields.slope)[1];
        match field {
            Quantity::Deflection => fields.slope,
            Quantity::Rotation if !piece.rotation.is_empty() => jet(&piece.rotation, s)[1] / half,
            Quantity::Slope | Quantity::Rotation => jet(&piece.deflection, s)[2] / (half * half),
            Quantity::Moment => fields.shear_force,
            Quantity::ShearForce => moments(2),
            Quantity::Settlement => settles(),
            Quantity::Gap if piece.open.is_none() => 0.0,
            Quantity::Gap => settles() + piece.cell.gap_slope - fields.slope,
            Quantity::Pressure => jet(&piece.pressure, s)[1] / half,
        }
    }
}
