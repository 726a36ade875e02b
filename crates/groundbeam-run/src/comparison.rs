//! Solves one model by several methods, and computes their errors relative to the exact method.

use crate::answer::{Answer, Found, Label};
use crate::answers::{Answers, Asked};
use crate::host::Host;
use crate::run::Run;
use crate::single::answered;
use groundbeam::{Error, Field, Method, Options, Solution, solution::Side};

/// The methods that are compared with `exact`.
const OTHERS: [Method; 3] = [Method::ActiveSet, Method::Psor, Method::Uzawa];

/// The options of a comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Compare {
    /// Number of elements of the mesh.
    pub elements: usize,
    /// Maximum number of sweeps of an iterative method.
    pub most_sweeps: usize,
    /// Memory limit of a solve, in bytes.
    pub memory_limit: u64,
}

impl Default for Compare {
    fn default() -> Self {
        let Options { elements, most_sweeps, memory_limit, .. } = Options::default();
        Compare { elements, most_sweeps, memory_limit }
    }
}

impl Compare {
    /// Number of calls of [`Host::done`] in one comparison.
    pub const PIECES: usize = 1 + OTHERS.len();
}

impl Run {
    /// Solves the model of the first combination by the method `exact`. If this gives an equilibrium, all other methods
    /// solve the model too. A method that cannot solve it has the result [`Found::Unsolved`].
    ///
    /// # Errors
    ///
    /// Returns the errors of the method `exact`, and [`Error::Invalid`] of every method.
    pub fn compare(&self, compare: Compare, host: &impl Host) -> Result<Answers, Error> {
        let Compare { elements, most_sweeps, memory_limit } = compare;
        let mut answers = Answers { asked: Asked::Methods, ..self.nothing() };
        let Some(combination) = self.combinations.first() else { return Ok(answers) };
        let solved = |method: &'static str, options: Options| {
            let label = Label { method, ..Label::of(combination, options.method) };
            let started = host.seconds();
            let answer = answered(label.clone(), self.width, &options, None, host);
            host.done();
            (answer, label, host.seconds() - started)
        };
        let (exact, ..) = solved("exact", Options { memory_limit, ..Options::default() });
        let exact = exact?;
        let stands = exact.solution().is_some();
        answers.list.push(exact);
        for method in OTHERS.into_iter().filter(|_| stands) {
            let options =
                Options { method, elements, most_sweeps, memory_limit, ..Options::default() };
            answers.list.push(match solved(method.name(), options) {
                (Ok(answer), ..) => answer,
                (Err(error @ Error::Invalid(_)), ..) => return Err(error),
                (Err(error), label, seconds) => {
                    let found = Found::Unsolved(error);
                    Answer { label, found, ground: None, factors: None, seconds }
                }
            });
        }
        Ok(answers)
    }
}

/// Errors of an answer: the largest differences from the exact method along the beam, relative to the field's largest
/// absolute value. The pressure is not compared, because it jumps at contact edges.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Errors {
    /// Error of the deflection.
    pub deflection: f64,
    /// Error of the moment.
    pub moment: f64,
    /// Error of the settlement of the ground under the beam.
    pub settlement: f64,
    /// Larger error of the two concentrated forces at the ends of the beam, relative to the resultant of the loads.
    pub end_forces: f64,
}

/// Number of equal steps into which the beam is divided. Answers are compared at the ends of all steps.
const EVEN_STEPS: usize = 1000;

impl Errors {
    /// Errors of an answer relative to the reference `exact`.
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

/// Ratio of two magnitudes; 0 if the first magnitude is 0.
fn ratio(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole }
}
