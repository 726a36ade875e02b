//! Extremes of the fields, at the ends of pieces and where derivatives vanish.
//!
//! Nothing is sampled. The coefficients of a polynomial give its roots and bounds of its values. Roots are
//! computed only on pieces on which a field may exceed its end values.

use crate::numeric::polynomial::{derivative, jet};
use crate::numeric::roots::sign_changes;
use crate::solution::candidate::Candidate;
use crate::solution::field::Field;
use crate::solution::fields::{Extreme, Range, SolutionPiece};

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
                // Values that may be extreme within rounding error are evaluated again, as results evaluate
                // them.
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

/// The range of a beam without pieces.
const NOTHING: Range =
    Range { min: Extreme { x: 0.0, value: 0.0 }, max: Extreme { x: 0.0, value: 0.0 } };

/// A value and its position.
#[derive(Clone, Copy)]
struct ValueAt {
    piece: usize,
    s: f64,
    value: f64,
}

/// Includes another value in the range. Of equal values, the leftmost counts.
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

/// Approximate values of a field at the ends of a piece, and bounds of its values on the whole piece.
struct FieldBounds {
    ends: [f64; 2],
    bounds: [f64; 2],
    /// Bound of the rounding error of the values at the ends.
    rounding: f64,
}

impl FieldBounds {
    /// The difference between a polynomial and the line through its end values is the sum of cⱼ (sʲ − 1) for
    /// even j and cⱼ (sʲ − s) for odd j, from j = 2 on. These factors lie between −1 and 0, and between −1
    /// and 1.
    fn of(c: &[f64]) -> Self {
        let [first, second] = [0, 1].map(|j| c.get(j).copied().unwrap_or(0.0));
        let ([mut even, mut odd], [mut above, mut apart]) = ([0.0; 2], [0.0; 2]);
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
    fn field_bounds(&self, field: Field) -> FieldBounds {
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
            // Not a polynomial.
            Field::Settlement | Field::Gap => FieldBounds {
                ends: [-1.0, 1.0].map(|s| self.one(field, s)),
                bounds: [f64::NEG_INFINITY, f64::INFINITY],
                rounding: 0.0,
            },
        }
    }

    /// Candidates for the extremes of a field: its ends and the zeros of its derivative.
    pub(crate) fn candidates(&self, field: Field) -> Vec<f64> {
        let mut s = vec![-1.0];
        self.turning_points(field, &mut s);
        s.push(1.0);
        s
    }

    /// Appends to `found` the positions inside the piece at which the derivative of a field changes its sign,
    /// from left to right.
    fn turning_points(&self, field: Field, found: &mut Vec<f64>) {
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
            // Open ground is convex where it is positive, so it has at most one minimum.
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

    /// Appends the sign changes of a derivative that is not a polynomial. It compares signs at points so
    /// close that each interval has at most one sign change. A zero at such a point is a sign change if the
    /// signs on both sides differ.
    fn turns(&self, slope: impl Fn(f64) -> f64, found: &mut Vec<f64>) {
        const CUTS: usize = 16;
        // −1, 0 or 1. The product of two small slopes would underflow.
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
    use crate::numeric::elementary::{asinh, cosh, exp, pow};
    use crate::solution::candidate::Workspace;
    use crate::{Answer, Beam, Foundation, Load, Model, Solver};

    /// Compares the ranges of all fields with values at a thousand points of each piece, for a beam with
    /// loads, an open part and a stiff part.
    #[test]
    fn nothing_exceeds_a_range_and_ranges_are_reached() {
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

    /// A piece in contact with ground of k = μ = 1 without gap; all fields are zero.
    fn piece(x: [f64; 2]) -> SolutionPiece {
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

    fn candidate(pieces: Vec<SolutionPiece>) -> Candidate {
        let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0));
        Candidate { pieces, ..Workspace::default().blank(&model) }
    }

    fn turning_points(of: &SolutionPiece, field: Field) -> Vec<f64> {
        let mut found = Vec::new();
        of.turning_points(field, &mut found);
        found
    }

    #[track_caller]
    fn near(found: &[f64], wanted: &[f64]) {
        let all = found.len() == wanted.len();
        let close = found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-14);
        assert!(all && close, "{found:?} {wanted:?}");
    }

    /// The terms 3s² and −5s⁴ lower the line between the end values by at most 3 and raise it by at most 5.
    /// The terms −4s³ and 6s⁵ change it by at most 10.
    #[test]
    fn a_hull_is_the_line_between_the_ends_and_what_the_powers_add() {
        let FieldBounds { ends, bounds, rounding } =
            FieldBounds::of(&[1.0, 2.0, 3.0, -4.0, -5.0, 6.0]);
        assert_eq!((ends, bounds), ([-5.0, 3.0], [-18.0, 18.0]));
        assert_eq!(rounding, 6.0 * f64::EPSILON * 21.0);
        // Mirrored, with the other sign, and half as large.
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

    /// Slope and shear force are derivatives with respect to x: derivatives with respect to s divided by half
    /// the length. The settlement in contact is w − g₀.
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
        // w′ = (2s + 12s²)/2.
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

    /// Polynomials whose derivatives have known roots, on a piece of length 4.
    #[test]
    fn fields_turn_where_their_derivatives_vanish() {
        let mut of = piece([1.0, 5.0]);
        // w = s³ − 3/16 s: w′ vanishes at s = ±1/4, w″ at 0.
        of.deflection = [0.0, -0.1875, 0.0, 1.0][..].into();
        // M = (s − 1/2)² and (s − 1/2)³: V = M′ turns where M″ vanishes.
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
        // u = w − g₀ in contact: dw/ds = 3s² − 3/16 is half the length times the gap's slope.
        of.cell.gap_slope = (3.0 * 0.25 - 0.1875) / 2.0;
        near(&turning_points(&of, Field::Settlement), &[-0.5, 0.5]);
        // The gap is zero everywhere, so no place of it is a turning point.
        near(&turning_points(&of, Field::Gap), &[]);
        near(&of.candidates(Field::Gap), &[-1.0, 1.0]);
    }

    /// Open ground with k = μ = 1 is u = cosh(x − a) for the ends cosh(a) and cosh(4 − a), with the minimum
    /// at a. The gap u + g₀ − w has its minimum where sinh(x − a) = w′ − g₀′.
    #[test]
    fn open_ground_turns_where_it_is_lowest() {
        for a in [0.7_f64, 1.3, 3.9] {
            let mut of = piece([0.0, 4.0]);
            of.open = Some([cosh(a), cosh(4.0 - a)]);
            near(&turning_points(&of, Field::Settlement), &[0.5 * a - 1.0]);
            // w = s, w′ = 1/2; g₀′ = 3/4.
            of.deflection = [0.0, 1.0][..].into();
            (of.cell.gap, of.cell.gap_slope) = ([0.0, 3.0], 0.75);
            near(&turning_points(&of, Field::Gap), &[0.5 * (a + asinh(-0.25)) - 1.0]);
            near(&turning_points(&of, Field::Settlement), &[0.5 * a - 1.0]);
            let lowest = candidate(vec![of]).range(Field::Settlement).min;
            near(&[lowest.x, lowest.value], &[a, 1.0]);
        }
        // Open ground with a monotone u has no turning point.
        let mut falling = piece([0.0, 4.0]);
        falling.open = Some([1.0, exp(-4.0)]);
        near(&turning_points(&falling, Field::Settlement), &[]);
    }

    /// A beam in contact at its ends and open between them: u of the ground is smallest in the middle. There
    /// the derivative of u is exactly zero if both contact edges have the same bits.
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
        // Zeros at multiples of 1/8, the points between which signs are compared.
        near(&turns(&|s| (s - 0.25) * (s + 0.5)), &[-0.5, 0.25]);
        near(&turns(&|s| s), &[0.0]);
        near(&turns(&|s| 1e-200 * (s - 0.3)), &[0.3]);
        // Ground whose settlement underflows far from any pressure: the minimum is where the zeros begin.
        near(&turns(&|s| if s.abs() < 0.3 { 0.0 } else { s }), &[-0.3]);
        near(&turns(&|s| -s), &[0.0]);
        near(&turns(&|s| 1.0 - s * s), &[]);
        near(&turns(&|s| s * s), &[]);
        near(&turns(&|s| -s * s), &[]);
        near(&turns(&|_| 1.0), &[]);
        near(&turns(&|_| -1.0), &[]);
        near(&turns(&|_| 0.0), &[]);
    }

    /// Of equal values, the leftmost counts, for every order of the search.
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
        // The leftmost also counts within one piece.
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
        // An integer from −4 to 4, by a linear congruential generator: x′ = 16807 x mod 2³¹ − 1.
        let mut digit = move || {
            seed = seed * 16807 % 2_147_483_647;
            (seed % 9) as f64 - 4.0
        };
        for round in 0..400 {
            let mut all: Vec<SolutionPiece> =
                (0..1 + round % 5).map(|i| piece([i as f64, i as f64 + 1.0])).collect();
            for of in &mut all {
                // Some pieces have much smaller values than the others, so their roots are not needed.
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

    /// Ends whose values differ only in the last bits are compared by the values in results.
    #[test]
    fn ends_within_rounding_of_the_least_are_seen_exactly() {
        // 0.1 + 0.2 + 0.3 has another rounding than 0.3 + 0.2 + 0.1.
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
    fn rotations_of_a_beam_that_shears_are_its_own() {
        let mut bends = piece([0.0, 4.0]);
        // w′ = s + s² has its minimum −1/4 at s = −1/2 and its maximum 2 at the right end.
        bends.deflection = [0.0, 0.0, 1.0, 2.0 / 3.0][..].into();
        let Range { min, max } = candidate(vec![bends.clone()]).range(Field::Rotation);
        near(&[min.x, min.value, max.x, max.value], &[1.0, -0.25, 4.0, 2.0]);
        let mut shears = piece([4.0, 6.0]);
        // φ = 3 − 12 s² has its maximum 3 at the middle and its minimum −9 at both ends.
        shears.rotation = [3.0, 0.0, -12.0][..].into();
        shears.deflection = [0.0, 100.0][..].into();
        let Range { min, max } = candidate(vec![bends, shears]).range(Field::Rotation);
        near(&[min.x, min.value, max.x, max.value], &[4.0, -9.0, 5.0, 3.0]);
    }

    #[test]
    fn a_beam_without_stretches_has_ranges_of_zero() {
        let none = Extreme { x: 0.0, value: 0.0 };
        assert_eq!(candidate(vec![]).range(Field::Moment), Range { min: none, max: none });
    }
}
