//! One answer: its label, its result, and the ground that was solved.

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
    /// The combination of load cases on one ground of a band. A file without either is one combination without a name.
    pub combination: Arc<Combination>,
    /// The train on the beam and its position.
    pub train: Option<Placed>,
    /// Name of the method.
    pub method: &'static str,
}

/// A train at one position.
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

    /// The model with all its loads, including those of the train.
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
    /// The model that was solved.
    pub label: Label,
    /// The result.
    pub found: Found,
    /// The source of the ground's constants; `None` if the file gives them per length of beam.
    pub ground: Option<Ground>,
    /// Load factors; `None` if they were not requested.
    pub factors: Option<Factors>,
    /// Time of the solve \[s\]; NaN without a clock.
    pub seconds: f64,
}

/// The result for one model.
#[derive(Debug, Clone)]
pub enum Found {
    /// An equilibrium, solved.
    Equilibrium(Arc<Solution>),
    /// An equilibrium exists; it was not computed.
    Exists(Existence),
    /// No equilibrium exists.
    NoEquilibrium(Existence),
    /// The method did not reach its tolerance.
    NotConverged(Stopped),
    /// The method cannot solve this model. Only [`Run::compare`](crate::Run::compare) gives such an answer.
    Unsolved(Error),
}

/// Combined status of several answers. The variants are ordered from the best to the worst.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Overall {
    /// All answers are solved, or all models are known to have an equilibrium.
    Solved,
    /// All models have an equilibrium, but at least one answer was not certified.
    NotConverged,
    /// At least one model has no equilibrium.
    NoEquilibrium,
}

impl Overall {
    /// Name in results.
    pub fn name(self) -> &'static str {
        match self {
            Overall::Solved => "solved",
            Overall::NotConverged => "not-converged",
            Overall::NoEquilibrium => "no-equilibrium",
        }
    }
}

impl Found {
    /// The result of a solve. Failed convergence is a result; other errors concern the model.
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

    /// The result of an existence check.
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

    /// The existence check, if the solve made one.
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
    /// The name of the combination; empty for a model as written.
    pub fn name(&self) -> &str {
        &self.label.combination.name
    }

    /// Whether its combination belongs to a limit state.
    pub fn is_of(&self, state: LimitState) -> bool {
        self.label.combination.limit_states.contains(state)
    }

    /// The model of its combination, without a train.
    pub fn model(&self) -> &Model {
        &self.label.combination.model
    }

    /// The solution, if the model is solved.
    pub fn solution(&self) -> Option<&Solution> {
        self.found.solution()
    }

    /// The existence check, if the solve made one.
    pub fn existence(&self) -> Option<&Existence> {
        self.found.existence()
    }
}

/// Ground whose constants follow from values per area and a bearing width, or from soil data.
#[derive(Debug, Clone, PartialEq)]
pub struct Ground {
    /// Bearing width of the beam \[m\].
    pub width: f64,
    /// k and μ.
    pub constants: GroundConstants,
    /// The soil data and the method.
    pub soil: Option<SoilModel>,
    /// The iterations that computed the constants from the soil data.
    pub rounds: Option<SoilRounds>,
}

impl Ground {
    /// Whether k and μ depend on the solution.
    pub fn follows_solution(&self) -> bool {
        self.soil.as_ref().is_some_and(SoilModel::follows_solution)
    }

    /// The ground of a model after a solve; `None` for a solve that did not converge.
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

    /// The ground of a model before the solve; `None` if it is not uniform or its width is unknown.
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
