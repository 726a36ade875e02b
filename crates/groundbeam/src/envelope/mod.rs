//! Computes the envelope of several solutions: the smallest and largest values at every point and over the beam.

mod forms;
mod upper;

use crate::solution::field::{ByField, Field};
use crate::solution::fields::{Extreme, Fields, Range, Side};
use crate::solution::solution::Solution;
use forms::Forms;

/// Largest difference of two solutions that counts as rounding error, as a fraction of the largest value of the field.
/// If solutions differ by less, the first of them in the list of solutions governs.
const ROUNDING_DIFFERENCE: f64 = 1e-12;

/// The shortest part of the beam on which a solution governs, as a fraction of the length. On shorter parts
/// the difference of the solutions may be rounding error.
const SHORTEST_RANGE: f64 = 1e-6;
/// The two lines of an envelope in the order of their computation. The smallest values of a field are computed from the
/// largest values of the field with the opposite sign.
const BOUNDS: [Bound; 2] = [Bound::Max, Bound::Min];

/// The envelope of several solutions of one beam, which are identified by their index in the given order. With
/// lift-off, each combination of loads needs its own solution, because superposition is not valid.
///
/// ```
/// use groundbeam::{Beam, Field, Foundation, Load, Model, Outcome, solve, envelope::Envelope};
///
/// let footing = || Model::new(Beam::uniform(12.0, 1.28e9), Foundation::pasternak(40e6, 9e6));
/// let mut solutions = Vec::new();
/// for at in [2.0, 10.0] {
///     let model = footing().with_load(Load::point_force(6.0, 900e3)).with_load(Load::point_force(at, 300e3));
///     let Outcome::Equilibrium(solution) = solve(&model)? else { unreachable!("it stands") };
///     solutions.push(*solution);
/// }
/// let envelope = Envelope::of(&solutions);
/// // Each solution is the mirror image of the other, so the governing one changes in the middle.
/// assert_eq!(envelope.at(Field::Deflection, 1.0).max.by, 0);
/// assert_eq!(envelope.at(Field::Deflection, 11.0).max.by, 1);
/// let changes = envelope.changes(Field::Deflection);
/// assert!(changes.iter().any(|change| (change.x - 6.0).abs() < 1e-9));
/// # Ok::<(), groundbeam::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Envelope<'a> {
    solutions: Vec<&'a Solution>,
    /// For each solution, the smallest and largest value of each field, in the order of [`Field::ALL`].
    ranges: Vec<ByField<Range>>,
    /// The rounding error of each field.
    rounding: ByField<f64>,
}

/// A value and the solution that attains it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Governing {
    /// The smallest or largest value, and its position \[m\].
    pub extreme: Extreme,
    /// Index of the solution that attains the extreme, the first one if several attain it up to rounding error.
    pub by: usize,
}

/// The smallest and the largest value of a field over several solutions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// The smallest value.
    pub min: Governing,
    /// The largest value.
    pub max: Governing,
}

/// The lines of an envelope: smallest values or largest values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum Bound {
    /// The line of smallest values.
    Min,
    /// The line of largest values.
    Max,
}

/// A position at which the governing solution changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// Position at which the governing solution changes \[m\]. There, the solutions that govern to the left and to the
    /// right have equal values, or the field jumps in one of them.
    pub x: f64,
    /// The bound of the envelope on which the governing solution changes: the smallest or the largest values.
    pub bound: Bound,
    /// Index of the solution that governs to the left of this position.
    pub from: usize,
    /// Index of the solution that governs to the right of this position.
    pub to: usize,
}

/// A part of the beam on which one solution governs.
struct GovernedPart {
    from: f64,
    to: f64,
    by: usize,
}

impl<'a> Envelope<'a> {
    /// Returns the envelope of several solutions. Beyond the end of a shorter beam, its end values count. Without
    /// solutions every value is zero.
    pub fn of(solutions: impl IntoIterator<Item = &'a Solution>) -> Self {
        let solutions: Vec<&Solution> = solutions.into_iter().collect();
        let ranges: Vec<ByField<Range>> = solutions.iter().map(|s| s.ranges()).collect();
        let mut rounding = [0.0_f64; Field::ALL.len()];
        for range in &ranges {
            for (rounding, Range { min, max }) in rounding.iter_mut().zip(range) {
                *rounding =
                    rounding.max(ROUNDING_DIFFERENCE * min.value.abs().max(max.value.abs()));
            }
        }
        Envelope { solutions, ranges, rounding }
    }

    /// Returns the fields to list, in the order of [`Field::ALL`]. The rotation is omitted if no beam has shear
    /// deformation.
    pub fn fields(&self) -> impl Iterator<Item = Field> + Clone + use<> {
        Field::listed(self.solutions.iter().any(|solution| solution.model().beam.shears()))
    }

    /// The solutions, in the order in which they were given.
    pub fn solutions(&self) -> &[&'a Solution] {
        &self.solutions
    }

    /// Returns the smallest and largest value of a field at a position. If the field jumps, the values on both
    /// sides count.
    pub fn at(&self, field: Field, x: f64) -> Bounds {
        self.all_at(x)[field.index()]
    }

    /// Returns the smallest and largest value of each field at a position, in the order of [`Field::ALL`].
    pub fn all_at(&self, x: f64) -> ByField<Bounds> {
        self.bounds(x, [Side::Left, Side::Right])
    }

    /// Returns the smallest and the largest value of each field at a position, in the order of [`Field::ALL`]. If a
    /// field jumps, only the value on the given side counts.
    pub fn all_beside(&self, x: f64, side: Side) -> ByField<Bounds> {
        self.bounds(x, [side, side])
    }

    fn bounds(&self, x: f64, sides: [Side; 2]) -> ByField<Bounds> {
        let evaluated = |solution: &&Solution| {
            let first = solution.at(x, sides[0]);
            [first, if sides[0] == sides[1] { first } else { solution.at(x, sides[1]) }]
        };
        let fields: Vec<[Fields; 2]> = self.solutions.iter().map(evaluated).collect();
        Field::ALL.map(|field| {
            let each = fields.iter().map(|sides| {
                let [a, b] = [sides[0].get(field), sides[1].get(field)];
                [a.min(b), a.max(b)].map(|value| Extreme { x, value })
            });
            governing(each, self.rounding(field))
        })
    }

    /// The smallest and largest value of a field on the whole beam, located by the roots of its derivative.
    pub fn range(&self, field: Field) -> Bounds {
        let each = self.ranges.iter().map(|ranges| {
            let range = ranges[field.index()];
            [range.min, range.max]
        });
        governing(each, self.rounding(field))
    }

    /// Positions at which the governing solution changes, from left to right. They are roots of differences between
    /// closed forms, or jumps of the field.
    pub fn changes(&self, field: Field) -> Vec<Change> {
        let forms = Forms::of(&self.solutions, field);
        let rounding = self.rounding(field);
        let mut runs = [Vec::new(), Vec::new()];
        forms.each_interval(|interval, curves| {
            for (bound, runs) in BOUNDS.into_iter().zip(&mut runs) {
                if bound == Bound::Min {
                    curves.iter_mut().flat_map(|c| c.iter_mut()).for_each(|c| *c = -*c);
                }
                for upper::Part { from, to, by } in upper::parts(curves, rounding) {
                    let [from, to] = [from, to].map(|s| forms::position(interval, s));
                    self.lengthen(runs, GovernedPart { from, to, by }, field);
                }
            }
        });
        let mut changes = Vec::new();
        for (bound, runs) in BOUNDS.into_iter().zip(&runs) {
            changes.extend(runs.windows(2).map(|pair| Change {
                x: pair[1].from,
                bound,
                from: pair[0].by,
                to: pair[1].by,
            }));
        }
        changes.sort_by(|a, b| a.x.total_cmp(&b.x));
        changes
    }

    /// Appends a part. A short part is merged with its neighbour if their solutions differ only by rounding error
    /// there, as the zero moments at a free end do.
    fn lengthen(&self, runs: &mut Vec<GovernedPart>, next: GovernedPart, field: Field) {
        let Some(last) = runs.last_mut() else { return runs.push(next) };
        let is_nothing = |run: &GovernedPart, other: usize| {
            let length = self.solutions[run.by].model().beam.length;
            let middle = 0.5 * (run.from + run.to);
            let value = |by: usize| self.solutions[by].at(middle, Side::Right).get(field);
            run.to - run.from <= SHORTEST_RANGE * length
                && (value(run.by) - value(other)).abs() <= self.rounding(field)
        };
        if next.by == last.by || is_nothing(&next, last.by) {
            last.to = next.to;
        } else if is_nothing(last, next.by) {
            let from = last.from;
            runs.pop();
            self.lengthen(runs, GovernedPart { from, ..next }, field);
        } else {
            runs.push(next);
        }
    }

    /// Returns the positions at which the envelope is listed: the ends of `even` equal steps, the stations of every
    /// solution, and the changes of the governing solution.
    pub fn stations(&self, even: usize) -> Vec<f64> {
        let Some(first) = self.solutions.first() else { return Vec::new() };
        let mut x = first.stations(even);
        x.extend(self.solutions.iter().skip(1).flat_map(|solution| solution.stations(0)));
        x.extend(self.fields().flat_map(|field| self.changes(field)).map(|change| change.x));
        x.sort_by(f64::total_cmp);
        x.dedup();
        x
    }

    /// The rounding error of a field.
    fn rounding(&self, field: Field) -> f64 {
        self.rounding[field.index()]
    }
}

/// Returns the smallest and the largest value of a field over all solutions, with the governing solutions.
/// `each` contains the smallest and the largest value in each solution.
fn governing(each: impl Iterator<Item = [Extreme; 2]>, rounding: f64) -> Bounds {
    let nothing = Governing { extreme: Extreme { x: 0.0, value: 0.0 }, by: 0 };
    let mut found: Option<Bounds> = None;
    for (by, [low, high]) in each.enumerate() {
        let [min, max] = [low, high].map(|extreme| Governing { extreme, by });
        let found = found.get_or_insert(Bounds { min, max });
        // A more extreme value is always adopted. The governing solution changes only if the value changes by
        // more than rounding error.
        if low.value < found.min.extreme.value - rounding {
            found.min = min;
        } else if low.value < found.min.extreme.value {
            found.min.extreme.value = low.value;
        }
        if high.value > found.max.extreme.value + rounding {
            found.max = max;
        } else if high.value > found.max.extreme.value {
            found.max.extreme.value = high.value;
        }
    }
    found.unwrap_or(Bounds { min: nothing, max: nothing })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Beam, Foundation, Load, Model, Outcome, solve};

    fn footing(loads: &[(f64, f64)]) -> Solution {
        let mut model = Model::new(Beam::uniform(12.0, 1.28e9), Foundation::pasternak(40e6, 9e6));
        for &(force, at) in loads {
            model = model.with_load(Load::point_force(at, force));
        }
        match solve(&model) {
            Ok(Outcome::Equilibrium(solution)) => *solution,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn the_envelope_of_one_solution_is_the_solution() {
        let one = footing(&[(900e3, 1.5)]);
        let envelope = Envelope::of([&one]);
        for field in Field::ALL {
            let range = one.range(field);
            let found = envelope.range(field);
            assert_eq!((found.min.extreme, found.max.extreme), (range.min, range.max));
            assert!(envelope.changes(field).is_empty());
        }
        assert_eq!(envelope.stations(10), one.stations(10));
    }

    #[test]
    fn the_envelope_of_no_solutions_is_zero() {
        let envelope = Envelope::of([]);
        assert!(envelope.stations(10).is_empty() && envelope.changes(Field::Moment).is_empty());
        assert_eq!(envelope.range(Field::Moment).max.extreme.value, 0.0);
    }

    #[test]
    fn between_equal_solutions_the_first_governs() {
        let solutions = [footing(&[(900e3, 1.5)]), footing(&[(900e3, 1.5)])];
        let envelope = Envelope::of(&solutions);
        for field in Field::ALL {
            assert!(envelope.changes(field).is_empty());
            assert_eq!(envelope.range(field).max.by, 0);
        }
    }

    #[test]
    fn both_sides_of_a_jump_count() {
        let solutions = [footing(&[(900e3, 6.0)])];
        let envelope = Envelope::of(&solutions);
        let here = envelope.at(Field::ShearForce, 6.0);
        let shear = Field::ShearForce.index();
        let side = |side| envelope.all_beside(6.0, side)[shear].max.extreme.value;
        assert_eq!(here.min.extreme.value, side(Side::Right));
        assert_eq!(here.max.extreme.value, side(Side::Left));
        assert!((side(Side::Left) - side(Side::Right) - 900e3).abs() < 1e-4);
    }

    #[test]
    fn at_a_change_the_solutions_are_equal_or_jump() {
        let solutions =
            [&[(900e3, 1.5)][..], &[(600e3, 6.0), (300e3, 11.0)], &[(200e3, 4.0), (700e3, 9.0)]]
                .map(footing);
        let envelope = Envelope::of(&solutions);
        let mut count = 0;
        for field in Field::ALL {
            let range = envelope.range(field);
            let size = range.max.extreme.value.abs().max(range.min.extreme.value.abs());
            for Change { x, from, to, .. } in envelope.changes(field) {
                count += 1;
                let gap = |side| {
                    let value = |i: usize| solutions[i].at(x, side).get(field);
                    (value(from) - value(to)) / size
                };
                let (left, right) = (gap(Side::Left), gap(Side::Right));
                let crosses = left.abs() < 1e-11 || right.abs() < 1e-11;
                assert!(crosses || left * right < 0.0, "{field:?} {x} {left} {right}");
            }
        }
        assert!(count > 10);
    }
}
