//! Finds the smallest and largest value of each field from the values at the ends of the pieces and the turning points.
//!
//! The roots and bounds of polynomials are computed from their coefficients, without sampling. Roots are computed only
//! where a field may exceed the values found before.

use crate::solution::candidate::Candidate;
use crate::solution::field::Field;
use crate::solution::field_bounds::FieldBounds;
use crate::solution::fields::{Extreme, Range};

impl Candidate {
    /// The smallest and largest value of a field, located by the roots of its derivative.
    pub fn range(&self, field: Field) -> Range {
        let bounds_of: Vec<FieldBounds> =
            self.pieces.iter().map(|piece| piece.field_bounds(field)).collect();
        let ends = bounds_of.iter().flat_map(|of_piece| of_piece.ends);
        let [least, most] = ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], end| {
            [least.min(end), most.max(end)]
        });
        let rounding = bounds_of.iter().map(|of_piece| of_piece.rounding).fold(0.0, f64::max);
        let mut found: Option<[ValueAt; 2]> = None;
        for (i, (of_piece, piece)) in bounds_of.iter().zip(&self.pieces).enumerate() {
            for (s, end) in [-1.0, 1.0].into_iter().zip(of_piece.ends) {
                // If the value at an end of a piece may be the extreme within rounding error, it is recomputed with
                // the function `one`, which gives exactly the value in the results.
                if end <= least + 2.0 * rounding || end >= most - 2.0 * rounding {
                    widen(&mut found, ValueAt { piece: i, s, value: piece.one(field, s) });
                }
            }
        }
        let mut inside = Vec::new();
        for (i, (of_piece, piece)) in bounds_of.iter().zip(&self.pieces).enumerate() {
            let [low, high] = of_piece.bounds;
            if found.is_some_and(|[min, max]| min.value <= low && high <= max.value) {
                continue;
            }
            inside.clear();
            piece.turning_points(field, &mut inside);
            for &s in &inside {
                widen(&mut found, ValueAt { piece: i, s, value: piece.one(field, s) });
            }
        }
        self.between(found)
    }

    fn between(&self, found: Option<[ValueAt; 2]>) -> Range {
        let extreme = |ValueAt { piece, s, value }: ValueAt| {
            let x = self.pieces[piece].global(s);
            Extreme { x, value }
        };
        found.map_or(NOTHING, |[min, max]| Range { min: extreme(min), max: extreme(max) })
    }
}

/// Range of a field if the list of pieces is empty: both extremes are zero.
const NOTHING: Range =
    Range { min: Extreme { x: 0.0, value: 0.0 }, max: Extreme { x: 0.0, value: 0.0 } };

/// A value and its position.
#[derive(Clone, Copy)]
struct ValueAt {
    piece: usize,
    s: f64,
    value: f64,
}

/// Includes another value in the range. Of several equal values, the range keeps the leftmost.
fn widen(found: &mut Option<[ValueAt; 2]>, here: ValueAt) {
    let [min, max] = found.get_or_insert([here; 2]);
    let is_left = |of: &ValueAt| here.value == of.value && (here.piece, here.s) < (of.piece, of.s);
    if here.value < min.value || is_left(min) {
        *min = here;
    }
    if here.value > max.value || is_left(max) {
        *max = here;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::elementary::pow;
    use crate::solution::field_bounds::tests::{candidate, near, piece};
    use crate::solution::fields::SolutionPiece;
    use crate::{Answer, Beam, Foundation, Load, Model, Solver};

    /// Compares the ranges of all fields with values at a thousand points of each piece, for beams of different
    /// stiffness under two point forces and a uniform load.
    #[test]
    fn ranges_are_bounds_and_are_attained() {
        let (mut solver, mut solved) = (Solver::new(), 0);
        for i in 0..60 {
            let part = |j: u32| f64::from((i * (2 * j + 7) + 3 * j) % 23) / 23.0;
            let stiffness = pow(10.0, -1.0 + 3.0 * part(1));
            let ground = Foundation::pasternak(1.0, part(2));
            let model = Model::new(Beam::uniform(10.0, stiffness), ground)
                .with_load(Load::point_force(1.0 + part(3), 10.0 * part(4)))
                .with_load(Load::point_force(2.0, 4.0 + part(5)))
                .with_load(Load::uniform_force(0.0, 10.0, 0.2 * part(6) + 0.01));
            let Ok(Answer::Equilibrium(solution)) = solver.solve(&model) else { continue };
            solved += 1;
            for field in Field::ALL {
                let Range { min, max } = solution.range(field);
                let size = min.value.abs().max(max.value.abs());
                let mut seen = [f64::INFINITY, f64::NEG_INFINITY];
                for piece in solution.pieces() {
                    for at in 0..=1000 {
                        let s = f64::from(at) / 500.0 - 1.0;
                        let value = piece.fields(s).get(field);
                        assert_eq!(value.to_bits(), piece.one(field, s).to_bits());
                        seen = [seen[0].min(value), seen[1].max(value)];
                    }
                }
                let reached = 1e-4 * (seen[1] - seen[0]);
                assert!(seen[0] >= min.value - 1e-14 * size && seen[1] <= max.value + 1e-14 * size);
                assert!(seen[0] - reached <= min.value && max.value <= seen[1] + reached);
                for extreme in [min, max] {
                    let at = |side| solution.at(extreme.x, side).get(field);
                    let near = [crate::solution::Side::Left, crate::solution::Side::Right]
                        .map(|side| (at(side) - extreme.value).abs());
                    assert!(near[0].min(near[1]) <= 1e-12 * size, "{field:?} at {}", extreme.x);
                }
            }
        }
        assert!(solved > 30, "{solved}");
    }

    /// The range keeps the leftmost of several equal values, in whatever order the values are included.
    #[test]
    fn the_leftmost_of_equal_values_counts() {
        let places = [
            (0, 1.0, 2.0),
            (1, -1.0, 2.0),
            (1, 0.5, 1.0),
            (2, -0.5, 1.0),
            (2, 0.0, 2.0),
            (2, 0.5, 1.5),
        ]
        .map(|(piece, s, value)| ValueAt { piece, s, value });
        for first in 0..places.len() {
            for step in [1, 5] {
                let mut found = None;
                (0..places.len()).for_each(|i| widen(&mut found, places[(first + i * step) % 6]));
                let [min, max] =
                    found.expect("places").map(|place| (place.piece, place.s, place.value));
                assert_eq!((min, max), ((1, 0.5, 1.0), (0, 1.0, 2.0)));
            }
        }
        // If all values in a piece are equal, both the smallest and the largest value are reported at the leftmost
        // position.
        let mut found = None;
        for s in [0.5, -0.5, 0.0] {
            widen(&mut found, ValueAt { piece: 0, s, value: 1.0 });
        }
        assert_eq!(found.expect("places").map(|place| place.s), [-0.5; 2]);
    }

    /// Compares a range with the field's values at all ends and turning points of all pieces.
    #[test]
    fn a_range_is_the_least_and_the_largest_of_all_candidates() {
        let mut seed = 7_u64;
        // This closure returns an integer from −4 to 4 from a linear congruential generator: x′ = 16807 x mod
        // (2³¹ − 1).
        let mut digit = move || {
            seed = seed * 16807 % 2_147_483_647;
            (seed % 9) as f64 - 4.0
        };
        for round in 0..400 {
            let mut all: Vec<SolutionPiece> =
                (0..1 + round % 5).map(|i| piece([i as f64, i as f64 + 1.0])).collect();
            for of in &mut all {
                // Some pieces have much smaller values than the others. They usually cannot contain an extreme, so
                // `range` need not compute the roots of their derivatives.
                let size = if digit() > 1.0 { 1.0 } else { 0.0625 };
                let mut some = |least: usize| -> crate::numeric::polynomial::Coefficients {
                    let count = least + (digit() + 4.0) as usize / 2;
                    (0..count).map(|_| size * digit()).collect()
                };
                (of.deflection, of.moment, of.pressure) = (some(2), some(1), some(0));
                (of.cell.gap, of.cell.gap_slope) = ([digit(), digit()], 0.0);
                of.cell.gap_slope = of.cell.gap[1] - of.cell.gap[0];
                if digit() > 2.0 {
                    of.open = Some([digit().abs(), digit().abs()]);
                }
            }
            let solution = candidate(all);
            for field in Field::ALL {
                let Range { min, max } = solution.range(field);
                let values = solution.pieces.iter().flat_map(|of| {
                    let value = |s: f64| of.fields(s).get(field);
                    of.candidates(field).into_iter().map(value)
                });
                let [least, most] = values
                    .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(v), b.max(v)]);
                assert_eq!([min.value, max.value], [least, most], "{field:?} {round}");
            }
        }
    }

    /// If a field's values at the ends of the pieces differ only in their last bits, the reported minimum and maximum
    /// equal the smallest and the largest of these values exactly.
    #[test]
    fn ends_within_rounding_error_are_compared_exactly() {
        // The sums 0.1 + 0.2 + 0.3 and 0.3 + 0.2 + 0.1 have different rounding errors.
        let of = |from: f64, c: &[f64]| {
            let mut of = piece([from, from + 1.0]);
            of.deflection = c.into();
            of
        };
        let tenths = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7];
        let mut turned = tenths;
        turned.reverse();
        let mut mixed = tenths;
        mixed.swap(0, 3);
        mixed.swap(2, 5);
        for sign in [1.0, -1.0] {
            for order in [[tenths, turned, mixed], [mixed, tenths, turned], [turned, mixed, tenths]]
            {
                let all = order.iter().enumerate().map(|(i, c)| of(i as f64, &c.map(|a| sign * a)));
                let solution = candidate(all.collect());
                let Range { min, max } = solution.range(Field::Deflection);
                let ends = solution.pieces.iter().flat_map(|of| {
                    [(of.x[0], of.fields(-1.0).deflection), (of.x[1], of.fields(1.0).deflection)]
                });
                let ends: Vec<(f64, f64)> = ends.collect();
                let most = ends.iter().map(|(_, w)| sign * w).fold(0.0, f64::max);
                let leftmost = ends.iter().find(|(_, w)| sign * w == most).expect("an end");
                let found = if sign > 0.0 { max } else { min };
                assert_eq!((found.x, found.value), *leftmost);
            }
        }
    }

    #[test]
    fn a_timoshenko_beam_has_the_range_of_its_own_rotation() {
        let mut bends = piece([0.0, 4.0]);
        // With w = s² + ⅔ s³ and x = 2 + 2 s, the slope dw/dx = s + s² has its minimum −1/4 at s = −1/2 and its
        // maximum 2 at the right end s = 1.
        bends.deflection = [0.0, 0.0, 1.0, 2.0 / 3.0][..].into();
        let Range { min, max } = candidate(vec![bends.clone()]).range(Field::Rotation);
        near(&[min.x, min.value, max.x, max.value], &[1.0, -0.25, 4.0, 2.0]);
        let mut shears = piece([4.0, 6.0]);
        // The rotation φ = 3 − 12 s² has its maximum 3 at the middle and its minimum −9 at both ends.
        shears.rotation = [3.0, 0.0, -12.0][..].into();
        shears.deflection = [0.0, 100.0][..].into();
        let Range { min, max } = candidate(vec![bends, shears]).range(Field::Rotation);
        near(&[min.x, min.value, max.x, max.value], &[4.0, -9.0, 5.0, 3.0]);
    }

    #[test]
    fn a_beam_without_pieces_has_ranges_of_zero() {
        let none = Extreme { x: 0.0, value: 0.0 };
        assert_eq!(candidate(vec![]).range(Field::Moment), Range { min: none, max: none });
    }
}
