//! Finds the turning points of a field inside a piece, which are the sign changes of its derivative.

use crate::numeric::polynomial::{derivative, jet};
use crate::numeric::roots::sign_changes;
use crate::solution::field::Field;
use crate::solution::fields::SolutionPiece;

impl SolutionPiece {
    /// Positions at which the field may have its extremes on this piece: the two ends and the turning points.
    pub(crate) fn candidates(&self, field: Field) -> Vec<f64> {
        let mut s = vec![-1.0];
        self.turning_points(field, &mut s);
        s.push(1.0);
        s
    }

    /// Appends to `found` the positions inside the piece at which the derivative of a field changes its sign,
    /// from left to right.
    pub(super) fn turning_points(&self, field: Field, found: &mut Vec<f64>) {
        match field {
            Field::Deflection => sign_changes(&derivative(&self.deflection), found),
            Field::Rotation if !self.rotation.is_empty() => {
                sign_changes(&derivative(&self.rotation), found);
            }
            Field::Slope | Field::Rotation => {
                sign_changes(&derivative(&derivative(&self.deflection)), found);
            }
            Field::Moment => sign_changes(&derivative(&self.moment), found),
            Field::ShearForce => sign_changes(&derivative(&derivative(&self.moment)), found),
            Field::Pressure => sign_changes(&derivative(&self.pressure), found),
            Field::Settlement if self.open.is_none() => {
                let mut c = derivative(&self.deflection);
                c[0] -= self.cell.gap_slope * self.half;
                sign_changes(&c, found);
            }
            // On a piece out of contact, the settlement of the ground is convex where it is positive. It therefore has
            // at most one minimum on the piece.
            Field::Settlement => self.turns(|at| self.settlement(at, 0.0, 0.0)[1], found),
            Field::Gap if self.open.is_some() => {
                let slope = |at: f64| {
                    let [_, dw, ..] = jet(&self.deflection, at);
                    self.settlement(at, 0.0, 0.0)[1] + self.cell.gap_slope - dw / self.half
                };
                self.turns(slope, found);
            }
            Field::Gap => {}
        }
    }

    /// Appends the local coordinates at which the function `slope` changes its sign. At most one change may lie between
    /// two neighbouring points of comparison.
    fn turns(&self, slope: impl Fn(f64) -> f64, found: &mut Vec<f64>) {
        const CUTS: usize = 16;
        // `sign` returns the sign −1, 0 or 1 of the slope at s. Signs are multiplied because the product of two slopes
        // could underflow.
        let sign = |s: f64| {
            let slope = slope(s);
            i8::from(slope > 0.0) - i8::from(slope < 0.0)
        };
        let (mut from, mut before) = (-1.0, sign(-1.0));
        for i in 1..=CUTS {
            let to = 2.0 * i as f64 / CUTS as f64 - 1.0;
            let after = sign(to);
            if before * after < 0 {
                let (mut low, mut high) = (from, to);
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    if sign(middle) == before {
                        low = middle;
                    } else {
                        high = middle;
                    }
                }
                found.push(0.5 * (low + high));
            }
            if after != 0 {
                (from, before) = (to, after);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::elementary::{asinh, cosh, exp};
    use crate::solution::field_bounds::tests::{candidate, near, piece};
    use crate::{Answer, Beam, Foundation, Load, Model, Solver};

    fn turning_points(of: &SolutionPiece, field: Field) -> Vec<f64> {
        let mut found = Vec::new();
        of.turning_points(field, &mut found);
        found
    }

    /// The test uses polynomials whose derivatives have known roots, on a piece of length 4.
    #[test]
    fn fields_turn_where_their_derivatives_vanish() {
        let mut of = piece([1.0, 5.0]);
        // For w = s³ − 3/16 s, w′ vanishes at s = ±1/4, and w″ vanishes at s = 0.
        of.deflection = [0.0, -0.1875, 0.0, 1.0][..].into();
        // The test uses first M = (s − 1/2)², then M = (s − 1/2)³. The shear force V = M′ has a turning point where
        // M″ changes its sign.
        of.moment = [0.25, -1.0, 1.0][..].into();
        of.pressure = [0.0, 1.0, 1.0][..].into();
        near(&turning_points(&of, Field::Deflection), &[-0.25, 0.25]);
        near(&turning_points(&of, Field::Slope), &[0.0]);
        near(&turning_points(&of, Field::Moment), &[0.5]);
        near(&turning_points(&of, Field::ShearForce), &[]);
        near(&turning_points(&of, Field::Pressure), &[-0.5]);
        near(&of.candidates(Field::Pressure), &[-1.0, -0.5, 1.0]);
        of.moment = [-0.125, 0.75, -1.5, 1.0][..].into();
        near(&turning_points(&of, Field::ShearForce), &[0.5]);
        // In contact, the settlement w − g₀ turns at s = ±1/2, where dw/ds = 3/4 − 3/16. The slope of the gap is dg₀/dx
        // = (dg₀/ds)/2.
        of.cell.gap_slope = (3.0 * 0.25 - 0.1875) / 2.0;
        near(&turning_points(&of, Field::Settlement), &[-0.5, 0.5]);
        // The gap is zero everywhere, so it has no turning point.
        near(&turning_points(&of, Field::Gap), &[]);
        near(&of.candidates(Field::Gap), &[-1.0, 1.0]);
    }

    /// The settlement u = cosh(x − a) of open ground with k = μ = 1 is smallest at x = a. The gap u + g₀ − w under a beam
    /// with the deflection w is smallest where sinh(x − a) = w′ − g₀′.
    #[test]
    fn open_ground_turns_where_it_is_lowest() {
        for a in [0.7_f64, 1.3, 3.9] {
            let mut of = piece([0.0, 4.0]);
            of.open = Some([cosh(a), cosh(4.0 - a)]);
            near(&turning_points(&of, Field::Settlement), &[0.5 * a - 1.0]);
            // The beam has w = s and w′ = 1/2, and the initial gap has the slope g₀′ = 3/4.
            of.deflection = [0.0, 1.0][..].into();
            (of.cell.gap, of.cell.gap_slope) = ([0.0, 3.0], 0.75);
            near(&turning_points(&of, Field::Gap), &[0.5 * (a + asinh(-0.25)) - 1.0]);
            near(&turning_points(&of, Field::Settlement), &[0.5 * a - 1.0]);
            let lowest = candidate(vec![of]).range(Field::Settlement).min;
            near(&[lowest.x, lowest.value], &[a, 1.0]);
        }
        // On a piece out of contact, a monotone settlement u of the ground has no turning point.
        let mut falling = piece([0.0, 4.0]);
        falling.open = Some([1.0, exp(-4.0)]);
        near(&turning_points(&falling, Field::Settlement), &[]);
    }

    /// Open ground with equal settlements at both ends is lowest in the middle, where its computed slope is exactly
    /// zero.
    #[test]
    fn symmetric_open_ground_is_lowest_in_its_middle() {
        let mut of = piece([0.0, 4.0]);
        of.open = Some([1.0; 2]);
        near(&turning_points(&of, Field::Settlement), &[0.0]);
        let model = Model::new(Beam::uniform(5.0, 1.0), Foundation::pasternak(4.0, 1.0))
            .with_load(Load::point_force(0.0, 1.0))
            .with_load(Load::point_force(5.0, 1.0))
            .with_load(Load::uniform_force(0.0, 5.0, 0.01));
        let mut solver = Solver::new();
        let Ok(Answer::Equilibrium(solution)) = solver.solve(&model) else { panic!("it stands") };
        let middle = solution.value(Field::Settlement, 2.5);
        let least = solution.range(Field::Settlement).min;
        assert!((least.value - middle).abs() < 1e-12 * middle, "{least:?} {middle}");
        assert!((least.x - 2.5).abs() < 1e-6, "{least:?}");
    }

    #[test]
    fn sign_changes_of_any_function_are_bisected() {
        let turns = |slope: &dyn Fn(f64) -> f64| {
            let mut found = Vec::new();
            piece([0.0, 1.0]).turns(slope, &mut found);
            found
        };
        near(&turns(&|s| (s - 0.3) * (s + 0.77)), &[-0.77, 0.3]);
        near(&turns(&|s| (0.3 - s) * (s + 0.99)), &[-0.99, 0.3]);
        near(&turns(&|s| (s - 0.3) * (s - 0.99)), &[0.3, 0.99]);
        // The signs are compared at the multiples of 1/8. The zeros −1/2 and 1/4 of this function, and the zero of
        // the next one, are such points.
        near(&turns(&|s| (s - 0.25) * (s + 0.5)), &[-0.5, 0.25]);
        near(&turns(&|s| s), &[0.0]);
        near(&turns(&|s| 1e-200 * (s - 0.3)), &[0.3]);
        // The settlement of ground far from any pressure underflows to zero. If it is zero on an interval, the left
        // end of this interval is its turning point.
        near(&turns(&|s| if s.abs() < 0.3 { 0.0 } else { s }), &[-0.3]);
        near(&turns(&|s| -s), &[0.0]);
        near(&turns(&|s| 1.0 - s * s), &[]);
        near(&turns(&|s| s * s), &[]);
        near(&turns(&|s| -s * s), &[]);
        near(&turns(&|_| 1.0), &[]);
        near(&turns(&|_| -1.0), &[]);
        near(&turns(&|_| 0.0), &[]);
    }
}
