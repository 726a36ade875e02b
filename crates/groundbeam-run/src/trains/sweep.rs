//! Solves a model at initial train positions, then bisects the intervals between them until the envelope is accurate enough.

use super::edges;
use super::interval::{Table, sticks_out};
use super::passage::{Reach, Swept};
use super::position::{Position, Section, Under, first_positions, values};
use crate::answer::{Answer, Found, Label, Placed};
use crate::host::{Failed, Host};
use crate::single::answered;
use groundbeam::model::Train;
use groundbeam::{
    Error, Field, Model, Options, Solution,
    solution::{ByField, Side},
};
use groundbeam_file::{Combination, MovingTrain};
use std::sync::Arc;

/// Number of equal steps along the beam. At the ends of these steps, the fields for different train positions
/// are compared.
const EVEN_STATIONS: usize = 96;
/// Intervals between train positions are not bisected if they are shorter than this fraction of the beam's
/// length.
const SHORTEST: f64 = 1e-5;
/// Replaces [`SHORTEST`] for intervals between train positions that have no solution at one end. Fields may
/// grow without limit near the train position at which the beam tips.
const SHORTEST_AT_EDGE: f64 = 1e-3;
/// Number of solved train positions above which no interval is bisected.
const MOST: usize = 20_000;

/// An interval between two neighbouring positions of the train.
#[derive(Debug, Clone, Copy)]
struct Between {
    /// Error of the envelope for each field, relative to its largest absolute value, from the bisection that formed
    /// this interval. It is infinite in the first round.
    error: ByField<f64>,
    open: bool,
}

/// Default error tolerance of an envelope, relative to the largest absolute value of each field.
pub(crate) const ERROR: f64 = 1e-3;

/// A sweep of a train over a beam under one combination, in rounds. The next round solves the first-axle positions
/// `wanted`, from left to right. The sweep ends when `wanted` is empty.
///
/// See *Which positions are solved* in docs/moving-loads.md.
pub(crate) struct Sweep {
    combination: Arc<Combination>,
    moving: Arc<MovingTrain>,
    error: f64,
    stations: Vec<f64>,
    found: Vec<Position>,
    between: Vec<Between>,
    wanted: Vec<f64>,
}

impl Sweep {
    /// A sweep with an error tolerance relative to the largest absolute value of each field.
    pub fn new(combination: Arc<Combination>, moving: Arc<MovingTrain>, error: f64) -> Self {
        let model = &combination.model;
        let l = model.beam.length;
        let mut stations: Vec<f64> =
            (0..=EVEN_STATIONS).map(|i| l * (i as f64 / EVEN_STATIONS as f64)).collect();
        stations.extend(model.marks());
        stations.sort_by(f64::total_cmp);
        stations.dedup();
        let wanted = first_positions(model, &moving.train, moving.range);
        let (found, between) = (Vec::new(), Vec::new());
        Sweep { combination, moving, error, stations, found, between, wanted }
    }

    fn model(&self) -> &Model {
        &self.combination.model
    }

    fn train(&self) -> &Train {
        &self.moving.train
    }

    /// Solves all positions of the sweep. Each solve starts from a solution of an earlier round, so the result does not
    /// depend on the number of threads.
    pub fn run<H: Host>(
        mut self,
        options: &Options,
        host: &H,
    ) -> Result<(Vec<Answer>, Swept), Failed<H::Stop>> {
        while !self.wanted.is_empty() {
            let answers = host.map(self.wanted.len(), |i| self.solved(i, options, host));
            let answers = answers.map_err(Failed::Stopped)?;
            self.give(answers.into_iter().collect::<Result<Vec<Answer>, Error>>()?);
        }
        host.done();
        Ok(self.finish())
    }

    fn solved(&self, wanted: usize, options: &Options, host: &impl Host) -> Result<Answer, Error> {
        let first_axle = self.wanted[wanted];
        let label = Label {
            train: Some(Placed { train: self.moving.clone(), first_axle }),
            ..Label::of(&self.combination, options.method)
        };
        answered(label, None, options, self.near(first_axle), host)
    }

    /// Stores the answers at the train positions in `wanted`, in the order of these positions, and chooses the train
    /// positions of the next round.
    fn give(&mut self, answers: Vec<Answer>) {
        let wanted = std::mem::take(&mut self.wanted);
        let new: Vec<Position> =
            wanted.into_iter().zip(answers).map(|(at, answer)| self.sampled(at, answer)).collect();
        if self.found.is_empty() {
            let untested = Between { error: [f64::INFINITY; Field::ALL.len()], open: true };
            self.between = vec![untested; new.len().saturating_sub(1)];
            self.found = new;
        } else {
            self.halve(new);
        }
        self.close();
        if self.found.len() < MOST {
            let open = self.between.iter().zip(self.found.windows(2)).filter(|(b, _)| b.open);
            self.wanted = open.map(|(_, ends)| middle(ends)).collect();
        }
    }

    /// The solution from which the iteration starts: the solution at the next position on the left, or, if that
    /// position has no solution, at the next position on the right.
    fn near(&self, wanted: f64) -> Option<&Solution> {
        let next = self.found.partition_point(|position| position.section.first_axle <= wanted);
        let sides = [next.checked_sub(1), Some(next)];
        sides.into_iter().flatten().find_map(|i| self.found.get(i)?.answer.solution())
    }

    /// Returns the answers at all train positions, and separately the data for the envelope, its error, and the
    /// ranges of positions without equilibrium.
    fn finish(self) -> (Vec<Answer>, Swept) {
        let each = self.between.iter().map(|between| between.error);
        let reached = each.fold([0.0_f64; Field::ALL.len()], |most, error| {
            std::array::from_fn(|field| most[field].max(error[field]))
        });
        let stands = |position: &Position| {
            let falls = matches!(position.answer.found, Found::NoEquilibrium(_));
            (position.section.first_axle, !falls)
        };
        let found = self.found.iter().map(stands);
        let none = edges::without_equilibrium(self.model(), self.train(), found);
        let found = self.found.into_iter().map(|position| (position.answer, position.section));
        let (answers, sections): (Vec<Answer>, Vec<Section>) = found.unzip();
        let swept = Swept {
            combination: self.combination,
            train: self.moving,
            answers: 0..answers.len(),
            sections,
            reach: Reach { asked: self.error, reached },
            none,
        };
        (answers, swept)
    }

    /// Bisects all intervals that are not yet finished, and computes the error of the envelope in each of them.
    /// `new` contains the answers at the middle positions of these intervals.
    fn halve(&mut self, new: Vec<Position>) {
        let table = Table::of(&self.found, self.train(), &self.stations);
        let scale = scale(self.found.iter().chain(&new));
        let mut middles = new.into_iter();
        let (mut found, mut between) = (Vec::new(), Vec::new());
        let old = std::mem::take(&mut self.found);
        let mut left = old.into_iter().peekable();
        let mut states = std::mem::take(&mut self.between).into_iter();
        while let Some(position) = left.next() {
            found.push(position);
            let (Some(state), Some(right)) = (states.next(), left.peek()) else { break };
            let middle = if state.open { middles.next() } else { None };
            let (Some(middle), Some(start)) = (middle, found.last()) else {
                between.push(state);
                continue;
            };
            let ends = [start, right];
            let error = match ends.iter().chain(&[&middle]).all(|end| end.section.ranges.is_some())
            {
                true => sticks_out(&middle, ends, self.train(), &self.stations, &table, &scale),
                false => [0.0; Field::ALL.len()],
            };
            let is_edge = is_edge(ends[0], &middle) || is_edge(&middle, ends[1]);
            let open = is_edge || error.iter().any(|error| *error > self.error);
            found.push(middle);
            between.extend([Between { error, open }; 2]);
        }
        (self.found, self.between) = (found, between);
    }

    /// Excludes short intervals, and intervals of which neither end has a solution, from further bisection.
    fn close(&mut self) {
        let l = self.model().beam.length;
        for (between, ends) in self.between.iter_mut().zip(self.found.windows(2)) {
            let length = ends[1].section.first_axle - ends[0].section.first_axle;
            let solved = ends.iter().filter(|end| end.section.ranges.is_some()).count();
            let shortest = if solved == 2 { SHORTEST } else { SHORTEST_AT_EDGE };
            if length <= shortest * l || solved == 0 {
                between.open = false;
                // An interval that is excluded in the first round has no error estimate. Its error counts as zero.
                if between.error.contains(&f64::INFINITY) {
                    between.error = [0.0; Field::ALL.len()];
                }
            }
        }
    }

    fn sampled(&self, first_axle: f64, answer: Answer) -> Position {
        let Some(solution) = answer.solution() else {
            let section = Section { first_axle, under: Vec::new(), ranges: None };
            return Position { answer, section, samples: Vec::new() };
        };
        let both = |x: f64| [Side::Left, Side::Right].map(|side| values(solution.at(x, side)));
        let samples = self.stations.iter().flat_map(|&x| both(x)).collect();
        let (model, train) = (self.model(), self.train());
        let of = |i: usize, x: f64| Under::of(both(x), model, train, i, x);
        let axles = 0..train.axles.len();
        let under = axles.map(|i| train.axle_at(i, first_axle, model).map(|x| of(i, x))).collect();
        let ranges = Some(solution.ranges());
        Position { section: Section { first_axle, under, ranges }, answer, samples }
    }
}

/// The position in the middle of an interval.
fn middle(ends: &[Position]) -> f64 {
    0.5 * (ends[0].section.first_axle + ends[1].section.first_axle)
}

/// Whether exactly one of two positions has a solution.
fn is_edge(a: &Position, b: &Position) -> bool {
    a.section.ranges.is_some() != b.section.ranges.is_some()
}

/// The largest absolute value of each field. For gap and settlement, returns at least `NOTHING` times the largest
/// absolute deflection.
fn scale<'p>(positions: impl Iterator<Item = &'p Position>) -> ByField<f64> {
    /// Errors of gap and settlement are measured relative to at least this fraction of the largest deflection.
    const NOTHING: f64 = 1e-6;
    let mut scale = [0.0_f64; Field::ALL.len()];
    for ranges in positions.filter_map(|position| position.section.ranges.as_ref()) {
        for (scale, range) in scale.iter_mut().zip(ranges) {
            *scale = scale.max(range.min.value.abs()).max(range.max.value.abs());
        }
    }
    let deflection = scale[Field::Deflection.index()];
    for (field, scale) in Field::ALL.iter().zip(&mut scale) {
        if matches!(field, Field::Settlement | Field::Gap) {
            *scale = scale.max(NOTHING * deflection);
        }
    }
    scale
}
