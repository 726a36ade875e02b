//! The answers to all combinations of a file, seen together.

use crate::context::Ground;
use crate::size::Sizes;
use groundbeam::{Envelope, Existence, Model, Solution, Stopped};

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
    NotConverged(&'a Stopped),
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

/// What is to be said of several answers at once, from the best to the worst.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Overall {
    /// All are solved, or where nothing was solved all have an equilibrium.
    Solved,
    /// All have an equilibrium, but for at least one no answer was certified.
    NotConverged,
    /// At least one has no equilibrium, whatever else there is.
    NoEquilibrium,
}

impl Overall {
    /// The name that results use.
    pub fn name(self) -> &'static str {
        match self {
            Overall::Solved => "solved",
            Overall::NotConverged => "not-converged",
            Overall::NoEquilibrium => "no-equilibrium",
        }
    }
}

/// A solution with the number its combination has in the report, counted from 1.
pub(crate) struct Numbered<'a> {
    pub number: usize,
    pub solution: &'a Solution,
    pub sizes: Sizes,
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

    /// The same with their numbers.
    pub(crate) fn numbered(&self) -> impl Iterator<Item = Numbered<'a>> {
        self.combined.iter().enumerate().filter_map(|(i, combined)| match combined.answer {
            Answer::Equilibrium(solution) => {
                Some(Numbered { number: i + 1, solution, sizes: Sizes::of(solution) })
            }
            _ => None,
        })
    }

    /// What is to be said of all of them at once. That one has no equilibrium says more than that another was not solved.
    pub fn overall(&self) -> Overall {
        let of = |combined: &Combined| match combined.answer {
            Answer::Equilibrium(_) | Answer::Exists(_) => Overall::Solved,
            Answer::NotConverged(_) => Overall::NotConverged,
            Answer::NoEquilibrium(_) => Overall::NoEquilibrium,
        };
        self.combined.iter().map(of).max().unwrap_or(Overall::Solved)
    }
}
