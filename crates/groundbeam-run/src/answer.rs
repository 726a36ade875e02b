//! One answer: its label, its result, and the ground that was solved.

use crate::growing::Factors;
use groundbeam::soil::{GroundConstants, SoilModel, SoilRounds};
use groundbeam::{Error, Existence, Foundation, Method, Model, Outcome, Solution, Stopped};
use groundbeam_file::{Combination, MovingTrain};
use std::borrow::Cow;
use std::sync::Arc;

/// Which of a file's models an answer belongs to.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// The combination of load cases on one ground of a band. A file without either is one combination without a name.
    pub combination: Arc<Combination>,
    /// The train on the beam, and where it stands.
    pub train: Option<Placed>,
    /// The method by name.
    pub method: &'static str,
}

/// A train at one of its positions.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// The train.
    pub train: Arc<MovingTrain>,
    /// Position of its first axle \[m\].
    pub first_axle: f64,
}

impl Label {
    /// The label of a combination without a train.
    pub(crate) fn of(combination: &Arc<Combination>, method: Method) -> Self {
        Label { combination: combination.clone(), train: None, method: method.name() }
    }

    /// The model under all of its loads, those of the train too.
    pub fn model(&self) -> Cow<'_, Model> {
        let model = &self.combination.model;
        match &self.train {
            None => Cow::Borrowed(model),
            Some(Placed { train, first_axle }) => Cow::Owned(train.train.on(model, *first_axle)),
        }
    }
}

/// The answer to one model.
#[derive(Debug, Clone)]
pub struct Answer {
    /// Which model it is.
    pub label: Label,
    /// What was found.
    pub found: Found,
    /// Where the ground's constants come from; none where they were given per length of beam.
    pub ground: Option<Ground>,
    /// How far the loads may grow; none where nobody asked.
    pub factors: Option<Factors>,
    /// How long it took \[s\]; NaN without a clock.
    pub seconds: f64,
}

/// What was found for one model.
#[derive(Debug, Clone)]
pub enum Found {
    /// An equilibrium, solved.
    Equilibrium(Arc<Solution>),
    /// An equilibrium exists. It was not solved for.
    Exists(Existence),
    /// No equilibrium exists.
    NoEquilibrium(Existence),
    /// The method did not reach its tolerance.
    NotConverged(Stopped),
    /// The method cannot solve this model. Only [`Run::compare`](crate::Run::compare) gives such an answer.
    Unsolved(Error),
}

/// The result of several answers together, from the best to the worst.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Overall {
    /// All are solved, or all are known to have an equilibrium.
    Solved,
    /// All have an equilibrium, but at least one answer was not certified.
    NotConverged,
    /// At least one has no equilibrium.
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

impl Found {
    /// What a solve found. Any other error than one of convergence concerns the model.
    ///
    /// # Errors
    ///
    /// [`Error::Invalid`], [`Error::Unsupported`] and [`Error::TooLarge`], unchanged.
    pub fn of(solved: Result<Outcome, Error>) -> Result<Self, Error> {
        match solved {
            Ok(Outcome::Equilibrium(solution)) => Ok(Found::Equilibrium(Arc::from(solution))),
            Ok(Outcome::NoEquilibrium(existence)) => Ok(Found::NoEquilibrium(existence)),
            Err(Error::NotConverged(reached)) => Ok(Found::NotConverged(reached)),
            Err(other) => Err(other),
        }
    }

    /// What a decision of existence alone found.
    pub(crate) fn checked(existence: Existence) -> Self {
        match existence.verdict.stands() {
            true => Found::Exists(existence),
            false => Found::NoEquilibrium(existence),
        }
    }

    /// The solution, if there is one.
    pub fn solution(&self) -> Option<&Solution> {
        match self {
            Found::Equilibrium(solution) => Some(solution),
            _ => None,
        }
    }

    /// The decision of existence, if the solve came so far.
    pub fn existence(&self) -> Option<&Existence> {
        match self {
            Found::Equilibrium(solution) => Some(solution.existence()),
            Found::Exists(existence) | Found::NoEquilibrium(existence) => Some(existence),
            Found::NotConverged(_) | Found::Unsolved(_) => None,
        }
    }

    /// The result in one word.
    pub fn overall(&self) -> Overall {
        match self {
            Found::Equilibrium(_) | Found::Exists(_) | Found::Unsolved(_) => Overall::Solved,
            Found::NotConverged(_) => Overall::NotConverged,
            Found::NoEquilibrium(_) => Overall::NoEquilibrium,
        }
    }
}

impl Answer {
    /// The name of its combination; empty for a model as it is written.
    pub fn name(&self) -> &str {
        &self.label.combination.name
    }

    /// The model of its combination, without a train.
    pub fn model(&self) -> &Model {
        &self.label.combination.model
    }

    /// The solution, if there is one.
    pub fn solution(&self) -> Option<&Solution> {
        self.found.solution()
    }

    /// The decision of existence, if the solve came so far.
    pub fn existence(&self) -> Option<&Existence> {
        self.found.existence()
    }
}

/// A ground whose constants are those of an area times a width, or were made of soil.
#[derive(Debug, Clone, PartialEq)]
pub struct Ground {
    /// The width on which the beam bears \[m\].
    pub width: f64,
    /// k and μ.
    pub constants: GroundConstants,
    /// The soil, and the method.
    pub soil: Option<SoilModel>,
    /// How the soil made them.
    pub rounds: Option<SoilRounds>,
}

impl Ground {
    /// Whether k and μ depend on the solution.
    pub fn follows_solution(&self) -> bool {
        self.soil.as_ref().is_some_and(SoilModel::follows_solution)
    }

    /// The ground of a model after a solve. A solve that did not converge tells nothing of it.
    pub(crate) fn solved(model: &Model, width: Option<f64>, found: &Found) -> Option<Self> {
        let before = Ground::before(model, width)?;
        let gamma = before.soil.as_ref().and_then(SoilModel::gamma);
        Some(match found {
            Found::NotConverged(_) => return None,
            Found::Equilibrium(solution) => {
                let after = Ground::before(solution.model(), Some(before.width))?;
                Ground { soil: before.soil, rounds: solution.soil(), ..after }
            }
            _ => Ground { rounds: gamma.map(|_| SoilRounds { gamma, rounds: 1 }), ..before },
        })
    }

    /// The ground of a model before anything is solved; `None` where it is not the same everywhere, or its width is
    /// not known.
    pub(crate) fn before(model: &Model, width: Option<f64>) -> Option<Self> {
        let &Foundation { subgrade, shear_layer, ref segments, ref soil, .. } = &model.foundation;
        let width = soil.as_ref().map(|soil| soil.width).or(width)?;
        let constants = match soil {
            Some(soil) => soil.subgrade(&model.beam),
            None => GroundConstants { subgrade, shear_layer },
        };
        let ground = Ground { width, constants, soil: soil.clone(), rounds: None };
        segments.is_empty().then_some(ground)
    }
}
