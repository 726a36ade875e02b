//! The answer to one model: its label, its result, and its ground constants.

use crate::growing::Factors;
use groundbeam::soil::{GroundConstants, SoilModel, SoilRounds};
use groundbeam::{
    Error, Existence, Foundation, Method, Model, Outcome, Solution, Stopped, design::LimitState,
};
use groundbeam_file::{Combination, MovingTrain};
use std::borrow::Cow;
use std::sync::Arc;

/// Identifies the model of an answer: combination, ground, train and method.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// The combination of load cases, with one pair of values of k and μ. A file without combinations and without
    /// factors on k and μ has one combination without a name.
    pub combination: Arc<Combination>,
    /// The train on the beam and its position; `None` without a train.
    pub train: Option<Placed>,
    /// Name of the method.
    pub method: &'static str,
}

/// A train at one position.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// The train.
    pub train: Arc<MovingTrain>,
    /// Position of the first axle of the train \[m\].
    pub first_axle: f64,
}

impl Label {
    /// The label of a combination without a train.
    pub(crate) fn of(combination: &Arc<Combination>, method: Method) -> Self {
        Label { combination: combination.clone(), train: None, method: method.name() }
    }

    /// The model with all loads, including the loads of the train.
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
    /// Label of the model that was solved.
    pub label: Label,
    /// The result.
    pub found: Found,
    /// The source of the ground's constants; `None` if the file gives them per length of beam.
    pub ground: Option<Ground>,
    /// Load factors; `None` if they were not requested.
    pub factors: Option<Factors>,
    /// Computing time of the answer \[s\]; NaN if the host has no clock.
    pub seconds: f64,
}

/// The result for one model.
#[derive(Debug, Clone)]
pub enum Found {
    /// An equilibrium, solved.
    Equilibrium(Arc<Solution>),
    /// An equilibrium exists, but it was not computed.
    Exists(Existence),
    /// No equilibrium exists.
    NoEquilibrium(Existence),
    /// The method did not reach its tolerance.
    NotConverged(Stopped),
    /// The method cannot solve this model. Only [`Run::compare`](crate::Run::compare) returns such an answer.
    Unsolved(Error),
}

/// Combined status of several answers. The variants are ordered from the best to the worst.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Overall {
    /// All models are solved, or an existence check shows that all have an equilibrium. Models that the method
    /// cannot solve ([`Found::Unsolved`]) are disregarded.
    Solved,
    /// All models have an equilibrium, but at least one answer was not certified.
    NotConverged,
    /// At least one model has no equilibrium.
    NoEquilibrium,
}

impl Overall {
    /// Name of the status in results.
    pub fn name(self) -> &'static str {
        match self {
            Overall::Solved => "solved",
            Overall::NotConverged => "not-converged",
            Overall::NoEquilibrium => "no-equilibrium",
        }
    }
}

impl Found {
    /// Converts the outcome of a solve. [`Error::NotConverged`] becomes [`Found::NotConverged`].
    ///
    /// # Errors
    ///
    /// Returns all other errors unchanged.
    pub fn of(solved: Result<Outcome, Error>) -> Result<Self, Error> {
        match solved {
            Ok(Outcome::Equilibrium(solution)) => Ok(Found::Equilibrium(Arc::from(solution))),
            Ok(Outcome::NoEquilibrium(existence)) => Ok(Found::NoEquilibrium(existence)),
            Err(Error::NotConverged(reached)) => Ok(Found::NotConverged(reached)),
            Err(other) => Err(other),
        }
    }

    /// Converts the result of an existence check.
    pub(crate) fn checked(existence: Existence) -> Self {
        match existence.verdict.stands() {
            true => Found::Exists(existence),
            false => Found::NoEquilibrium(existence),
        }
    }

    /// The solution, if the model is solved.
    pub fn solution(&self) -> Option<&Solution> {
        match self {
            Found::Equilibrium(solution) => Some(solution),
            _ => None,
        }
    }

    /// The existence check; `None` if the method did not converge or cannot solve the model.
    pub fn existence(&self) -> Option<&Existence> {
        match self {
            Found::Equilibrium(solution) => Some(solution.existence()),
            Found::Exists(existence) | Found::NoEquilibrium(existence) => Some(existence),
            Found::NotConverged(_) | Found::Unsolved(_) => None,
        }
    }

    /// The result as a status.
    pub fn overall(&self) -> Overall {
        match self {
            Found::Equilibrium(_) | Found::Exists(_) | Found::Unsolved(_) => Overall::Solved,
            Found::NotConverged(_) => Overall::NotConverged,
            Found::NoEquilibrium(_) => Overall::NoEquilibrium,
        }
    }
}

impl Answer {
    /// The name of the combination; empty if the file has neither combinations nor factors on k and μ.
    pub fn name(&self) -> &str {
        &self.label.combination.name
    }

    /// Whether the combination of this answer belongs to a limit state.
    pub fn is_of(&self, state: LimitState) -> bool {
        self.label.combination.limit_states.contains(state)
    }

    /// The model of the combination, without the loads of a train.
    pub fn model(&self) -> &Model {
        &self.label.combination.model
    }

    /// The solution, if the model is solved.
    pub fn solution(&self) -> Option<&Solution> {
        self.found.solution()
    }

    /// The existence check; `None` if the method did not converge or cannot solve the model.
    pub fn existence(&self) -> Option<&Existence> {
        self.found.existence()
    }
}

/// Ground whose constants follow from values per area and a bearing width, or from soil data.
#[derive(Debug, Clone, PartialEq)]
pub struct Ground {
    /// Bearing width of the beam \[m\].
    pub width: f64,
    /// Constants k and μ of the ground.
    pub constants: GroundConstants,
    /// The soil data, and the method that converts them to constants of the ground.
    pub soil: Option<SoilModel>,
    /// Data of the iteration that computed the ground constants k and μ from the soil data.
    pub rounds: Option<SoilRounds>,
}

impl Ground {
    /// Whether k and μ depend on the solution.
    pub fn follows_solution(&self) -> bool {
        self.soil.as_ref().is_some_and(SoilModel::follows_solution)
    }

    /// The ground of a model after a solve; `None` if the solve did not converge or [`Ground::before`] is
    /// `None`.
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

    /// The bearing width and the ground constants k and μ that follow from the model without a solve. `None` if the
    /// ground is not uniform or the bearing width is unknown.
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
