//! Passages of trains over a beam, as they are reported.

use crate::combinations::Overall;
use groundbeam::Field;
use groundbeam::train::{Located, Passage};

/// A train that passed over a beam.
#[derive(Debug, Clone, Copy)]
pub struct Moving<'a> {
    /// The combination of load cases under which it passed; none where the loads are as they are written.
    pub combination: Option<&'a str>,
    /// What it is called.
    pub name: &'a str,
    /// The set of a code of practice it is of.
    pub set: Option<&'a str>,
    /// What its loads were multiplied by.
    pub factor: f64,
    /// From where to where its first axle went.
    pub range: [f64; 2],
    /// What came out.
    pub passage: &'a Passage,
}

/// Even steps of the envelope in documents and tables.
const EVEN_STEPS: usize = 100;

/// What is known of a train's way without solving.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckedTrain<'a> {
    /// The combination of load cases under which it passes; none where the loads are as they are written.
    pub combination: Option<&'a str>,
    /// What it is called.
    pub name: &'a str,
    /// From where to where its first axle goes.
    pub range: [f64; 2],
    /// Ranges of the first axle's position in which there is no equilibrium.
    pub without_equilibrium: Vec<[f64; 2]>,
}

/// Several passages: of each train under each combination.
#[derive(Debug, Clone, Default)]
pub struct Passages<'a> {
    /// In the order of the combinations, of each in that of the trains.
    pub all: Vec<Moving<'a>>,
}

/// A value that governs, and in which of the passages.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InPassage {
    /// The value, its section, and where the train stands.
    pub located: Located,
    /// Which passage, counted from 0.
    pub passage: usize,
}

impl Passages<'_> {
    /// The smallest and the largest value of every field at a section over all passages; none if nothing was solved.
    pub fn at(&self, x: f64) -> Option<[[InPassage; 2]; 7]> {
        let each = self.all.iter().enumerate().filter_map(|(passage, moving)| {
            let bounds = moving.passage.at(x)?;
            Some(bounds.map(|both| both.map(|located| InPassage { located, passage })))
        });
        each.reduce(|mut all, bounds| {
            all.iter_mut().zip(bounds).for_each(|(both, new)| widen(both, new));
            all
        })
    }

    /// The smallest and the largest value of a field on the whole beam over all passages; none if nothing was solved.
    pub fn range(&self, field: Field) -> Option<[InPassage; 2]> {
        let each = self.all.iter().enumerate().filter_map(|(passage, moving)| {
            let range = moving.passage.range(field)?;
            Some(range.map(|located| InPassage { located, passage }))
        });
        each.reduce(|mut all, range| {
            widen(&mut all, range);
            all
        })
    }

    /// Sections at which the envelope of all is listed if nobody says.
    pub fn default_stations(&self) -> Vec<f64> {
        self.stations(EVEN_STEPS)
    }

    /// Even steps of the beam, and the sections that any passage names.
    pub(crate) fn stations(&self, even: usize) -> Vec<f64> {
        let mut x: Vec<f64> =
            self.all.iter().flat_map(|moving| moving.passage.stations(even)).collect();
        x.sort_by(f64::total_cmp);
        x.dedup();
        x
    }

    /// The passage in which the moment is largest in size, and where the train then stands.
    pub(crate) fn largest_moment(&self) -> Option<InPassage> {
        let [min, max] = self.range(Field::Moment)?;
        Some(if max.located.value >= -min.located.value { max } else { min })
    }

    /// What is to be said of all of them at once.
    pub fn overall(&self) -> Overall {
        self.all.iter().map(Moving::overall).max().unwrap_or(Overall::Solved)
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

impl Moving<'_> {
    /// The train, and the combination under which it passed.
    pub fn label(&self) -> String {
        match self.combination {
            Some(combination) => format!("{combination}; {}", self.name),
            None => self.name.to_owned(),
        }
    }

    /// Sections at which the envelope is listed if nobody says.
    pub fn default_stations(&self) -> Vec<f64> {
        self.passage.stations(EVEN_STEPS)
    }

    /// What is to be said of all positions at once.
    pub fn overall(&self) -> Overall {
        if !self.passage.without_equilibrium().is_empty() {
            Overall::NoEquilibrium
        } else if self.passage.not_converged().next().is_some() {
            Overall::NotConverged
        } else {
            Overall::Solved
        }
    }
}
