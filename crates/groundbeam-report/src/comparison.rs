//! Answers of several methods to one model, side by side.

use groundbeam::{Error, Field, Side, Solution};

/// Answers of several methods to one model; errors are those against `exact`.
#[derive(Debug, Clone)]
pub struct Comparison<'a> {
    /// The answer that the others are held against.
    pub exact: &'a Solution,
    /// How long it took \[s\].
    pub seconds: f64,
    /// The others, in the order in which they are shown.
    pub others: Vec<Compared<'a>>,
}

/// The answer of one method.
#[derive(Debug, Clone, Copy)]
pub struct Compared<'a> {
    /// The method, and the form of pressure where it has several: `active-set, dirac`.
    pub name: &'a str,
    /// What came out; or that the method stopped early, or that it is not for this model.
    pub answer: Result<&'a Solution, &'a Error>,
    /// How long it took \[s\].
    pub seconds: f64,
}

/// How far an answer is from another: the largest difference anywhere along the beam over the largest value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Errors {
    /// Of the deflection.
    pub deflection: f64,
    /// Of the moment.
    pub moment: f64,
    /// Of the settlement of the ground under the beam.
    pub settlement: f64,
    /// Of the larger end force over all loads that act down; the pressure itself jumps at edges of contact.
    pub end_forces: f64,
}

/// Even steps along the beam at which answers are compared.
const EVEN_STEPS: usize = 1000;

impl Errors {
    /// Those of an answer against the one that is taken for right.
    pub fn of(found: &Solution, exact: &Solution) -> Self {
        let stations = exact.stations(EVEN_STEPS);
        let relative = |field: Field| {
            let range = exact.range(field);
            let size = range.min.value.abs().max(range.max.value.abs());
            let apart = stations.iter().flat_map(|&x| {
                [Side::Left, Side::Right]
                    .map(|side| (found.at(x, side).get(field) - exact.at(x, side).get(field)).abs())
            });
            ratio(apart.fold(0.0, f64::max), size)
        };
        let (ends, right) = (found.end_forces(), exact.end_forces());
        let apart = (ends.left - right.left).abs().max((ends.right - right.right).abs());
        Errors {
            deflection: relative(Field::Deflection),
            moment: relative(Field::Moment),
            settlement: relative(Field::Settlement),
            end_forces: ratio(apart, exact.existence().resultant().abs()),
        }
    }
}

/// Nothing of nothing is nothing.
fn ratio(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole }
}
