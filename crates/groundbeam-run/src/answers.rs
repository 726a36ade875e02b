//! All answers to a file: one list with labels, and what the answers give together.

use crate::answer::{Answer, Ground, Overall};
use crate::trains::{Located, Passage, Swept};
use groundbeam::{ByField, Envelope, Existence, Field, Solution};
use groundbeam_file::LoadCase;

/// What a file or its user asks for. Results are laid out accordingly.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Asked {
    /// One model.
    One,
    /// All combinations of load cases on all grounds of a band.
    Combinations,
    /// All positions of every train over every combination.
    Trains,
    /// One model by every method.
    Methods,
}

/// The answers to a file.
#[derive(Debug, Clone)]
pub struct Answers {
    /// What was asked for.
    pub asked: Asked,
    /// In the order of the combinations. With trains: for each combination in the order of the trains, each train from
    /// left to right.
    pub list: Vec<Answer>,
    /// Every load case by itself, which need not be in equilibrium.
    pub alone: Vec<Alone>,
    /// The ground of the first combination before anything is solved; none where its constants were given per length
    /// of beam.
    pub ground: Option<Ground>,
    pub(crate) swept: Vec<Swept>,
}

/// A load case by itself.
#[derive(Debug, Clone)]
pub struct Alone {
    /// The case, and the model under its loads alone.
    pub case: LoadCase,
    /// Whether the loads of the case can be in equilibrium without those of others.
    pub existence: Existence,
}

impl Alone {
    /// Whether the loads of the case can be in equilibrium without those of others.
    pub fn stands(&self) -> bool {
        self.existence.verdict.stands()
    }
}

impl Answers {
    /// The answers that are solved, with their solutions.
    pub fn solved(&self) -> impl Iterator<Item = (&Answer, &Solution)> {
        self.list.iter().filter_map(|answer| Some((answer, answer.solution()?)))
    }

    /// The envelope of those that are solved; it numbers them in the order of [`Answers::solved`].
    pub fn envelope(&self) -> Envelope<'_> {
        Envelope::of(self.solved().map(|(_, solution)| solution))
    }

    /// The passages of all trains.
    pub fn passages(&self) -> Passages<'_> {
        Passages { all: self.swept.iter().map(|swept| swept.passage(&self.list)).collect() }
    }

    /// The result of all together. No equilibrium counts more than no convergence.
    pub fn overall(&self) -> Overall {
        let each = self.list.iter().map(|answer| answer.found.overall());
        each.chain([self.passages().overall()]).max().unwrap_or(Overall::Solved)
    }
}

/// Even steps of the envelope in documents and tables.
const EVEN_STEPS: usize = 100;

/// Several passages: of each train under each combination.
#[derive(Debug, Clone, Default)]
pub struct Passages<'a> {
    /// In the order of the combinations, of each in that of the trains.
    pub all: Vec<Passage<'a>>,
}

/// A value that governs, and in which of the passages.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct InPassage {
    /// The value, its section, and where the train stands.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub located: Located,
    /// Which passage, counted from 0.
    pub passage: usize,
}

impl Passages<'_> {
    /// The fields to list, in the order of [`Field::ALL`]: without the rotation if the beam does not shear.
    pub fn fields(&self) -> impl Iterator<Item = Field> + Clone + use<> {
        self.all.first().map(Passage::fields).into_iter().flatten()
    }

    /// The smallest and the largest value of every field at a section over all passages; none if nothing was solved.
    pub fn at(&self, x: f64) -> Option<ByField<[InPassage; 2]>> {
        let each = self.all.iter().enumerate().filter_map(|(passage, one)| {
            let bounds = one.at(x)?;
            Some(bounds.map(|both| both.map(|located| InPassage { located, passage })))
        });
        each.reduce(|mut all, bounds| {
            all.iter_mut().zip(bounds).for_each(|(both, new)| widen(both, new));
            all
        })
    }

    /// The smallest and the largest value of a field on the whole beam over all passages; none if nothing was solved.
    pub fn range(&self, field: Field) -> Option<[InPassage; 2]> {
        let each = self.all.iter().enumerate().filter_map(|(passage, one)| {
            let range = one.range(field)?;
            Some(range.map(|located| InPassage { located, passage }))
        });
        each.reduce(|mut all, range| {
            widen(&mut all, range);
            all
        })
    }

    /// Sections at which the envelope of all is listed by default.
    pub fn default_stations(&self) -> Vec<f64> {
        self.stations(EVEN_STEPS)
    }

    /// Even steps of the beam, and the sections that any passage names.
    pub fn stations(&self, even: usize) -> Vec<f64> {
        let mut x: Vec<f64> = self.all.iter().flat_map(|passage| passage.stations(even)).collect();
        x.sort_by(f64::total_cmp);
        x.dedup();
        x
    }

    /// The passage in which the moment is largest in size, and where the train then stands.
    pub fn largest_moment(&self) -> Option<InPassage> {
        let [min, max] = self.range(Field::Moment)?;
        Some(if max.located.value >= -min.located.value { max } else { min })
    }

    /// The result of all together.
    pub fn overall(&self) -> Overall {
        self.all.iter().map(Passage::overall).max().unwrap_or(Overall::Solved)
    }

    /// Whether any position was solved.
    pub fn any_solved(&self) -> bool {
        self.all.iter().any(|passage| passage.solved().next().is_some())
    }
}

/// Takes the smaller of the smallest and the larger of the largest; of equals the first.
fn widen(both: &mut [InPassage; 2], [min, max]: [InPassage; 2]) {
    if min.located.value < both[0].located.value {
        both[0] = min;
    }
    if max.located.value > both[1].located.value {
        both[1] = max;
    }
}
