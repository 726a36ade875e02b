//! Chooses the initial positions of a train, and extracts the field values at one train position for the envelope.

use crate::answer::Answer;
use groundbeam::model::Train;
use groundbeam::{
    Field, Model,
    model::Action,
    solution::{ByField, Fields, Range},
};
use std::borrow::Borrow;

/// A position of the train, with its answer and the values that envelopes compare.
#[derive(Debug, Clone)]
pub(crate) struct Position {
    pub answer: Answer,
    pub section: Section,
    /// Values of all fields on the left and right sides of the stations; empty without a solution.
    pub samples: Vec<ByField<f64>>,
}

impl Borrow<Section> for Position {
    fn borrow(&self) -> &Section {
        &self.section
    }
}

/// Data of a train position for the envelope, in addition to the solution at this position.
#[derive(Debug, Clone)]
pub(crate) struct Section {
    /// Position of the first axle of the train \[m\].
    pub first_axle: f64,
    /// The fields on both sides of each axle; `None` for an axle off the beam.
    pub under: Vec<Option<Under>>,
    /// The range of each field along the beam; `None` without a solution.
    pub ranges: Option<ByField<Range>>,
}

/// Values of all fields, in the order of [`Field::ALL`].
pub(crate) fn values(fields: Fields) -> ByField<f64> {
    Field::ALL.map(|field| fields.get(field))
}

const SLOPE: usize = Field::Slope.index();
const SHEAR_FORCE: usize = Field::ShearForce.index();

/// The values of each field just left and just right of an axle that passes a section.
pub(crate) type Beside = [ByField<f64>; 2];

/// Fields on both sides of an axle on the beam, and the jumps of the fields due to the axle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Under {
    pub beside: Beside,
    jump: ByField<f64>,
}

impl Under {
    /// Computes the jumps of the fields due to an axle at `x`. Without shear deformation, only the shear force jumps,
    /// by the axle load. With shear deformation, the slope jumps too, and the ground may carry a part of the axle load.
    pub fn of(beside: Beside, model: &Model, train: &Train, axle: usize, x: f64) -> Self {
        let mut jump = [0.0; Field::ALL.len()];
        let own = force(train, axle);
        jump[SHEAR_FORCE] = own;
        if model.beam.shears() {
            let near = train.same_place(model.beam.length);
            let here = |at: f64| (at - x).abs() <= near;
            let fixed = model.loads.iter().map(|load| match load.at_point(Action::Force) {
                Some((at, force)) if here(at) => force,
                _ => 0.0,
            });
            let all = own + fixed.sum::<f64>();
            let share = if all == 0.0 { 0.0 } else { own / all };
            for field in [SLOPE, SHEAR_FORCE] {
                jump[field] = share * (beside[0][field] - beside[1][field]);
            }
        }
        Under { beside, jump }
    }

    /// Fields on both sides of an axle that leaves this position to the right. They include the jumps due to
    /// the axle, but not the jumps due to a fixed load at this position.
    pub(crate) fn leaving(&self) -> Beside {
        let [_, right] = self.beside;
        [std::array::from_fn(|field| right[field] + self.jump[field]), right]
    }

    /// Fields on both sides of an axle that arrives at this position from the left.
    pub(crate) fn arriving(&self) -> Beside {
        let [left, _] = self.beside;
        [left, std::array::from_fn(|field| left[field] - self.jump[field])]
    }
}

/// Number of equal steps into which the range of train positions is divided in the first round.
pub(crate) const EVEN_STEPS: usize = 32;

/// Initial positions of the first axle: equal steps, and positions with an axle or an end of a distributed load at one
/// of the [`Model::marks`] or just off the beam.
pub(crate) fn first_positions(model: &Model, train: &Train, [from, to]: [f64; 2]) -> Vec<f64> {
    let l = model.beam.length;
    let step = |i: usize| from + (to - from) * (i as f64 / EVEN_STEPS as f64);
    let mut at: Vec<f64> = (0..EVEN_STEPS).map(step).collect();
    at.push(to);
    let ends = train.uniform.iter().flat_map(|part| [part.from, part.to]);
    let behind = train.axles.iter().map(|axle| axle.behind).chain(ends);
    for behind in behind.filter(|behind| behind.is_finite()) {
        at.extend(model.marks().iter().map(|mark| mark + behind));
        at.extend([behind - JUST_OFF * l, l + behind + JUST_OFF * l]);
    }
    at.retain(|x| (from..=to).contains(x));
    at.sort_by(f64::total_cmp);
    at.dedup_by(|a, b| *a - *b <= 0.1 * JUST_OFF * l);
    at
}

/// Sum of the loads of all axles that share the position of one axle.
pub(crate) fn force(train: &Train, axle: usize) -> f64 {
    let behind = train.axles[axle].behind;
    train.axles.iter().filter(|other| other.behind == behind).map(|other| other.force).sum()
}

/// Distance between an axle and an end of the beam, relative to the length of the beam, just before the axle
/// arrives or just after it has left.
pub(crate) const JUST_OFF: f64 = 1e-8;
