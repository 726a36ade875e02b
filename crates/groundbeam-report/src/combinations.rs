//! The answers to all combinations of a file, seen together.

use crate::context::Ground;
use groundbeam::{Envelope, Existence, Model, NotConverged, Solution};

/// All combinations of a file with their answers, and every load case by itself.
#[derive(Debug, Clone, Default)]
pub struct Combinations<'a> {
    /// In the order of the file.
    pub combined: Vec<Combined<'a>>,
    /// Every load case by itself, which need not be in equilibrium.
    pub alone: Vec<Alone<'a>>,
}

/// One combination and its answer.
#[derive(Debug, Clone, Copy)]
pub struct Combined<'a> {
    /// Its name.
    pub name: &'a str,
    /// The factors of the load cases in it.
    pub factors: &'a [(String, f64)],
    /// The model under its loads.
    pub model: &'a Model,
    /// What the ground's k and μ are multiplied by, where a band of grounds is solved.
    pub band: Option<[f64; 2]>,
    /// Where its ground comes from; none where the constants were given.
    pub ground: Option<Ground<'a>>,
    /// What came out.
    pub answer: Answer<'a>,
}

/// What came out for a combination.
#[derive(Debug, Clone, Copy)]
pub enum Answer<'a> {
    /// An equilibrium, solved.
    Equilibrium(&'a Solution),
    /// There is an equilibrium, which was not solved for.
    Exists(&'a Existence),
    /// There is none.
    NoEquilibrium(&'a Existence),
    /// The method did not reach its tolerance.
    NotConverged(&'a NotConverged),
}

/// A load case by itself.
#[derive(Debug, Clone, Copy)]
pub struct Alone<'a> {
    /// Its name.
    pub name: &'a str,
    /// The model under its loads alone.
    pub model: &'a Model,
    /// Whether it could stand.
    pub existence: &'a Existence,
}

/// What is to be said of all combinations at once.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Overall {
    /// All are solved, or where nothing was solved all have an equilibrium.
    Solved,
    /// At least one has no equilibrium, whatever else there is.
    NoEquilibrium,
    /// All have an equilibrium, but for at least one no answer was certified.
    NotConverged,
}

impl Answer<'_> {
    /// What is known of existence, where the method came so far as to say it.
    pub fn existence(&self) -> Option<&Existence> {
        match self {
            Answer::Equilibrium(solution) => Some(solution.existence()),
            Answer::Exists(existence) | Answer::NoEquilibrium(existence) => Some(existence),
            Answer::NotConverged(_) => None,
        }
    }
}

impl Alone<'_> {
    /// Whether the loads of the case can be in equilibrium without those of others.
    pub fn stands(&self) -> bool {
        self.existence.verdict.stands()
    }
}

impl<'a> Combinations<'a> {
    /// What a list of them is headed by: a band of grounds need not have combinations of loads.
    pub(crate) fn noun(&self) -> &'static str {
        let loads = self.combined.iter().any(|combined| !combined.factors.is_empty());
        if self.combined.iter().any(|c| c.band.is_some()) && !loads {
            "Grounds"
        } else {
            "Combinations"
        }
    }

    /// The combinations that were solved.
    pub fn solved(&self) -> impl Iterator<Item = (&Combined<'a>, &'a Solution)> {
        self.combined.iter().filter_map(|combined| match combined.answer {
            Answer::Equilibrium(solution) => Some((combined, solution)),
            _ => None,
        })
    }

    /// The envelope of those that were solved; it numbers them in the order of [`Combinations::solved`].
    pub fn envelope(&self) -> Envelope<'a> {
        Envelope::of(self.solved().map(|(_, solution)| solution))
    }

    /// What is to be said of all of them at once. That one has no equilibrium says more than that another was not solved.
    pub fn overall(&self) -> Overall {
        let any = |is: fn(&Answer) -> bool| self.combined.iter().any(|c| is(&c.answer));
        if any(|answer| matches!(answer, Answer::NoEquilibrium(_))) {
            Overall::NoEquilibrium
        } else if any(|answer| matches!(answer, Answer::NotConverged(_))) {
            Overall::NotConverged
        } else {
            Overall::Solved
        }
    }
}
