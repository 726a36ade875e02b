//! Computes the envelope of the passage of a train over all its positions.

use super::interval::passing;
use super::position::Section;
use crate::answer::{Answer, Found, Overall};
use groundbeam::model::Train;
use groundbeam::{
    Field, Model, Solution,
    design::LimitStates,
    solution::{ByField, Side},
};
use groundbeam_file::{Combination, MovingTrain};
use std::ops::Range;
use std::sync::Arc;

/// A value, its position on the beam, and the position of the train.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Located {
    /// Position on the beam \[m\].
    pub x: f64,
    /// The value.
    pub value: f64,
    /// Position of the first axle of the train \[m\].
    pub first_axle: f64,
}

/// Requested and achieved error of an envelope, relative to the largest value of each field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reach {
    /// Requested error of the envelope of each field, relative to the largest value of the field.
    pub asked: f64,
    /// Achieved error of the envelope of each field, relative to its largest value, in the order of [`Field::ALL`]. It
    /// is the largest error of the last bisections. If a field jumps, its error remains as large as the jump.
    pub reached: ByField<f64>,
}

impl Reach {
    /// The largest error of all fields.
    pub fn largest(&self) -> f64 {
        self.reached.iter().copied().fold(0.0, f64::max)
    }

    /// The error of one field.
    pub fn of(&self, field: Field) -> f64 {
        self.reached[field.index()]
    }
}

/// Largest gaps between beam and ground during the passage of a train; `None` where the beam does not lift off.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Uplift {
    /// The largest gap between beam and ground ahead of the first axle.
    pub ahead: Option<Located>,
    /// The largest gap between beam and ground at positions between the first and the last axle.
    pub between: Option<Located>,
    /// The largest gap between beam and ground behind the last axle.
    pub behind: Option<Located>,
}

/// Result of moving a train over the beam, without the solutions at the individual positions of the train.
#[derive(Debug, Clone)]
pub(crate) struct Swept {
    pub combination: Arc<Combination>,
    pub train: Arc<MovingTrain>,
    /// Indices of the answers for this train's positions in the list of all answers.
    pub answers: Range<usize>,
    /// Data for the envelope at each train position: the range of each field along the beam, and the values of the
    /// fields immediately left and right of each axle.
    pub sections: Vec<Section>,
    pub reach: Reach,
    /// Ranges of first-axle positions at which the beam has no equilibrium.
    pub none: Vec<[f64; 2]>,
}

impl Swept {
    pub fn passage<'a>(&'a self, all: &'a [Answer]) -> Passage<'a> {
        Passage { swept: self, answers: all.get(self.answers.clone()).unwrap_or_default() }
    }
}

/// The passage of a train over a beam: the answers at its positions, and their envelope.
#[derive(Debug, Clone, Copy)]
pub struct Passage<'a> {
    swept: &'a Swept,
    answers: &'a [Answer],
}

/// Number of equal steps along the beam for envelopes in documents and tables.
const EVEN_STEPS: usize = 100;

impl<'a> Passage<'a> {
    /// The model without the train.
    pub fn model(&self) -> &'a Model {
        &self.swept.combination.model
    }

    /// The limit states of the combination.
    pub fn limit_states(&self) -> LimitStates {
        self.swept.combination.limit_states
    }

    /// The name of the combination; `None` if the loads act as written.
    pub fn combination(&self) -> Option<&'a str> {
        Some(&*self.swept.combination.name).filter(|name| !name.is_empty())
    }

    /// The train and its range of positions.
    pub fn moving(&self) -> &'a MovingTrain {
        &self.swept.train
    }

    /// The loads of the train.
    pub fn train(&self) -> &'a Train {
        &self.moving().train
    }

    /// Names of the train and of the combination.
    pub fn label(&self) -> String {
        let train = self.moving().placed_name();
        match self.combination() {
            Some(combination) => format!("{combination}; {train}"),
            None => train,
        }
    }

    /// Whether the train has no axles and no uniform load.
    pub fn is_without_train(&self) -> bool {
        self.train().axles.is_empty() && self.train().uniform.is_empty()
    }

    /// The answers at all positions, from left to right.
    pub fn answers(&self) -> &'a [Answer] {
        self.answers
    }

    /// Requested and achieved error of the envelope.
    pub fn reach(&self) -> Reach {
        self.swept.reach
    }

    /// Ranges of first-axle positions at which the beam has no equilibrium.
    pub fn without_equilibrium(&self) -> &'a [[f64; 2]] {
        &self.swept.none
    }

    fn each(&self) -> impl Iterator<Item = (f64, &'a Found)> {
        let axles = self.swept.sections.iter().map(|section| section.first_axle);
        axles.zip(self.answers.iter().map(|answer| &answer.found))
    }

    /// Positions of the first axle at which the solution method did not converge.
    pub fn not_converged(&self) -> impl Iterator<Item = f64> {
        let failed = |(_, found): &(f64, &Found)| matches!(found, Found::NotConverged(_));
        self.each().filter(failed).map(|(first_axle, _)| first_axle)
    }

    /// The positions of the first axle for which a solution exists, each paired with its solution.
    pub fn solved(&self) -> impl Iterator<Item = (f64, &'a Solution)> {
        self.each().filter_map(|(first_axle, found)| Some((first_axle, found.solution()?)))
    }

    /// The worst status of all positions.
    pub fn overall(&self) -> Overall {
        if !self.without_equilibrium().is_empty() {
            Overall::NoEquilibrium
        } else if self.not_converged().next().is_some() {
            Overall::NotConverged
        } else {
            Overall::Solved
        }
    }

    /// The fields that results contain, in the order of [`Field::ALL`]. The rotation is omitted for a beam without shear
    /// deformation.
    pub fn fields(&self) -> impl Iterator<Item = Field> + Clone + use<> {
        Field::of(&self.model().beam)
    }

    /// Smallest and largest value of every field at the position `x`, in the order of [`Field::ALL`]; `None` if no
    /// train position has a solution.
    ///
    /// The values beside each axle that passes `x` are included, interpolated between the neighbouring solved
    /// positions.
    pub fn at(&self, x: f64) -> Option<ByField<[Located; 2]>> {
        let mut bounds: Option<ByField<[Located; 2]>> = None;
        let mut note = |first_axle: f64, values: ByField<f64>| {
            let here = values.map(|value| [Located { x, value, first_axle }; 2]);
            let bounds = bounds.get_or_insert(here);
            for (bounds, [new, _]) in bounds.iter_mut().zip(here) {
                widen(bounds, [new, new]);
            }
        };
        for (first_axle, solution) in self.solved() {
            for side in [Side::Left, Side::Right] {
                let fields = solution.at(x, side);
                note(first_axle, Field::ALL.map(|field| fields.get(field)));
            }
        }
        for axle in 0..self.train().axles.len() {
            if let Some((first_axle, both)) = passing(&self.swept.sections, self.train(), axle, x) {
                both.into_iter().for_each(|values| note(first_axle, values));
            }
        }
        bounds
    }

    /// The smallest and the largest value of a field on the whole beam over all train positions; `None` if no train
    /// position has a solution.
    pub fn range(&self, field: Field) -> Option<[Located; 2]> {
        let mut bounds: Option<[Located; 2]> = None;
        for section in &self.swept.sections {
            let Some(ranges) = &section.ranges else { continue };
            let first_axle = section.first_axle;
            let new = [ranges[field.index()].min, ranges[field.index()].max]
                .map(|extreme| Located { x: extreme.x, value: extreme.value, first_axle });
            widen(bounds.get_or_insert(new), new);
        }
        bounds
    }

    /// The solved train position that is nearest to the given position of the first axle, with its solution.
    pub fn nearest(&self, first_axle: f64) -> Option<(f64, &'a Solution)> {
        let away = |at: f64| (at - first_axle).abs();
        self.solved().min_by(|a, b| away(a.0).total_cmp(&away(b.0)))
    }

    /// The largest gaps ahead of, between and behind the axles.
    pub fn uplift(&self) -> Uplift {
        let mut uplift = Uplift::default();
        if self.is_without_train() {
            return uplift;
        }
        for (first_axle, solution) in self.solved() {
            for open in solution.lift_off() {
                let x = open.largest_gap.x;
                let place = if x > first_axle {
                    &mut uplift.ahead
                } else if x < first_axle - self.train().length() {
                    &mut uplift.behind
                } else {
                    &mut uplift.between
                };
                let here = Located { x, value: open.largest_gap.value, first_axle };
                if place.is_none_or(|most| here.value > most.value) {
                    *place = Some(here);
                }
            }
        }
        uplift
    }

    /// Default positions along the beam at which the envelope is evaluated.
    pub fn default_stations(&self) -> Vec<f64> {
        self.stations(EVEN_STEPS)
    }

    /// Positions on the beam for the envelope: ends of `even` equal steps, corners and jumps of the fields, and
    /// extremes.
    pub fn stations(&self, even: usize) -> Vec<f64> {
        let l = self.model().beam.length;
        let mut x: Vec<f64> = (0..=even).map(|i| l * (i as f64 / even.max(1) as f64)).collect();
        x.extend(self.model().marks());
        x.extend(
            Field::ALL.into_iter().filter_map(|field| self.range(field)).flatten().map(|e| e.x),
        );
        x.sort_by(f64::total_cmp);
        x.dedup();
        x
    }
}

/// Widens a range to include another range. The first of two equal values is kept.
fn widen(bounds: &mut [Located; 2], [low, high]: [Located; 2]) {
    if low.value < bounds[0].value {
        bounds[0] = low;
    }
    if high.value > bounds[1].value {
        bounds[1] = high;
    }
}
