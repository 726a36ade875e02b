//! Which positions of a train are solved: where axles meet what the model has, an even grid, and more where it matters.

use super::bounds::{Passage, Reach};
use super::interval::{Table, sticks_out};
use super::{Train, edges, marks};
use crate::error::Error;
use crate::model::Model;
use crate::outcome::Outcome;
use crate::solution::fields::{Field, Side};
use crate::solution::solution::Solution;
use crate::train::position::Under;
use crate::train::position::first_positions;
use crate::train::position::{Answer, Position, values};

/// Equal steps of the beam at whose ends envelopes are compared; marks of the model are added.
const EVEN_STATIONS: usize = 96;
/// Intervals shorter than this part of the beam's length are not halved.
const SHORTEST: f64 = 1e-5;
/// The same where at one end there is no equilibrium: close to where the beam tips, fields may grow beyond all bounds.
const SHORTEST_AT_EDGE: f64 = 1e-3;
/// More positions are not solved.
const MOST: usize = 20_000;

/// An interval between two neighbouring positions.
#[derive(Debug, Clone, Copy)]
struct Between {
    /// By how much its middle, or that of the interval it is a half of, stuck out of the envelope of each field.
    error: [f64; 7],
    open: bool,
}

/// A sweep of a train over a model, in rounds: [`wanted`](Sweep::wanted) names positions,
/// [`give`](Sweep::give) takes what was solved there, until none is wanted any more.
///
/// At a section of the beam a field changes smoothly while the train moves, except when an axle passes. Between two
/// solved positions the fields beside each axle are therefore interpolated; elsewhere the envelope is that of the
/// solved positions. The middle of an interval is solved, too, and the interval is halved for as long as its middle,
/// or the crest of the parabola through it and its ends, sticks out of the envelope by more than the error.
pub struct Sweep<'a> {
    model: &'a Model,
    train: &'a Train,
    error: f64,
    stations: Vec<f64>,
    found: Vec<Position>,
    between: Vec<Between>,
    wanted: Vec<f64>,
}

impl<'a> Sweep<'a> {
    /// A sweep of the first axle from one position to another, to an error relative to each field's largest value.
    pub fn new(model: &'a Model, train: &'a Train, range: [f64; 2], error: f64) -> Self {
        let l = model.beam.length;
        let mut stations: Vec<f64> =
            (0..=EVEN_STATIONS).map(|i| l * (i as f64 / EVEN_STATIONS as f64)).collect();
        stations.extend(marks(model));
        stations.sort_by(f64::total_cmp);
        stations.dedup();
        let wanted = first_positions(model, train, range);
        Sweep { model, train, error, stations, found: Vec::new(), between: Vec::new(), wanted }
    }

    /// The positions of the first axle to be solved next, from left to right; none when all is done.
    pub fn wanted(&self) -> &[f64] {
        &self.wanted
    }

    /// Takes the answers at the positions that were wanted, in their order.
    pub fn give(&mut self, answers: impl IntoIterator<Item = Answer>) {
        let wanted = std::mem::take(&mut self.wanted);
        let new: Vec<Position> =
            wanted.into_iter().zip(answers).map(|(at, answer)| self.sampled(at, answer)).collect();
        if self.found.is_empty() {
            let untested = Between { error: [f64::INFINITY; 7], open: true };
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

    /// The solution of a given position next to one that is wanted, of two the one on the left: where to begin there.
    pub fn near(&self, wanted: f64) -> Option<&Solution> {
        let next = self.found.partition_point(|position| position.first_axle <= wanted);
        let sides = [next.checked_sub(1), Some(next)];
        sides.into_iter().flatten().find_map(|i| match &self.found.get(i)?.answer {
            Answer::Equilibrium(solution) => Some(&**solution),
            _ => None,
        })
    }

    /// Solves all that is wanted, one position after the other; `solve` is given the loaded model and the solution of a
    /// position near by, as [`solve_near`](crate::solve_near) wants them.
    ///
    /// # Errors
    ///
    /// The first that is not about one position alone.
    pub fn run(
        mut self,
        solve: impl Fn(&Model, Option<&Solution>) -> Result<Outcome, Error>,
    ) -> Result<Passage, Error> {
        while !self.wanted.is_empty() {
            let solved = self
                .wanted
                .iter()
                .map(|&at| Answer::of(solve(&self.train.on(self.model, at), self.near(at))));
            let answers: Result<Vec<Answer>, Error> = solved.collect();
            self.give(answers?);
        }
        Ok(self.finish())
    }

    /// What is known now.
    pub fn finish(self) -> Passage {
        let each = self.between.iter().map(|between| between.error);
        let reached = each.fold([0.0_f64; 7], |most, error| {
            std::array::from_fn(|field| most[field].max(error[field]))
        });
        let stands = |position: &Position| {
            (position.first_axle, !matches!(position.answer, Answer::NoEquilibrium(_)))
        };
        let found = self.found.iter().map(stands);
        let none = edges::without_equilibrium(self.model, self.train, found);
        Passage {
            model: self.model.clone(),
            train: self.train.clone(),
            positions: self.found,
            reach: Reach { asked: self.error, reached },
            none,
        }
    }

    /// Puts the middles of all open intervals in their places and judges each.
    fn halve(&mut self, new: Vec<Position>) {
        let table = Table::of(&self.found, self.train, &self.stations);
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
            let error = match ends.iter().chain(&[&middle]).all(|end| end.ranges.is_some()) {
                true => sticks_out(&middle, ends, self.train, &self.stations, &table, &scale),
                false => [0.0; 7],
            };
            let is_edge = is_edge(ends[0], &middle) || is_edge(&middle, ends[1]);
            let open = is_edge || error.iter().any(|error| *error > self.error);
            found.push(middle);
            between.extend([Between { error, open }; 2]);
        }
        (self.found, self.between) = (found, between);
    }

    /// Closes what is short, and what has no equilibrium at either end.
    fn close(&mut self) {
        let l = self.model.beam.length;
        for (between, ends) in self.between.iter_mut().zip(self.found.windows(2)) {
            let length = ends[1].first_axle - ends[0].first_axle;
            let solved = ends.iter().filter(|end| end.ranges.is_some()).count();
            let shortest = if solved == 2 { SHORTEST } else { SHORTEST_AT_EDGE };
            if length <= shortest * l || solved == 0 {
                between.open = false;
                // A jump as an axle comes or leaves has both its sides solved.
                if between.error.contains(&f64::INFINITY) {
                    between.error = [0.0; 7];
                }
            }
        }
    }

    fn sampled(&self, first_axle: f64, answer: Answer) -> Position {
        let Answer::Equilibrium(solution) = &answer else {
            return Position { first_axle, answer, samples: vec![], under: vec![], ranges: None };
        };
        let both = |x: f64| [Side::Left, Side::Right].map(|side| values(solution.at(x, side)));
        let samples = self.stations.iter().flat_map(|&x| both(x)).collect();
        let axles = 0..self.train.axles.len();
        let of = |i: usize, x: f64| Under::of(both(x), self.model, self.train, i, x);
        let under = axles
            .map(|i| self.train.axle_at(i, first_axle, self.model).map(|x| of(i, x)))
            .collect();
        let ranges = Some(Field::ALL.map(|field| solution.range(field)));
        Position { first_axle, answer, samples, under, ranges }
    }
}

/// The middle of an interval.
fn middle(ends: &[Position]) -> f64 {
    0.5 * (ends[0].first_axle + ends[1].first_axle)
}

/// Whether one of two positions is an equilibrium and the other is none.
fn is_edge(a: &Position, b: &Position) -> bool {
    a.ranges.is_some() != b.ranges.is_some()
}

/// The largest absolute value of each field. Uplift and settlement are seen beside the deflection.
fn scale<'p>(positions: impl Iterator<Item = &'p Position>) -> [f64; 7] {
    /// A field that is smaller than this part of the deflection is as good as zero.
    const NOTHING: f64 = 1e-6;
    let mut scale = [0.0_f64; 7];
    for ranges in positions.filter_map(|position| position.ranges.as_ref()) {
        for (scale, range) in scale.iter_mut().zip(ranges) {
            *scale = scale.max(range.min.value.abs()).max(range.max.value.abs());
        }
    }
    let deflection = scale[0];
    for (field, scale) in Field::ALL.iter().zip(&mut scale) {
        if matches!(field, Field::Settlement | Field::Gap) {
            *scale = scale.max(NOTHING * deflection);
        }
    }
    scale
}
