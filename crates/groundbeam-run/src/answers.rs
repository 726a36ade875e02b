//! All results of a model file as a labelled list, and joint results such as envelopes.

use crate::answer::{Answer, Ground, Overall};
use crate::trains::{Located, Passage, Swept};
use groundbeam::{
    Existence, Field, Solution,
    design::{LimitState, LimitStates},
    envelope::Envelope,
    solution::ByField,
};
use groundbeam_file::LoadCase;

/// The kind of request. It determines the layout of the results.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Asked {
    /// One model.
    One,
    /// All combinations of load cases, each with all requested values of k and μ.
    Combinations,
    /// All positions of every train under every combination.
    Trains,
    /// One model, solved by every method.
    Methods,
}

/// The results of all models that a model file defines.
#[derive(Debug, Clone)]
pub struct Answers {
    /// The kind of request.
    pub asked: Asked,
    /// Answers in the order of the combinations, then of the trains, then of the train positions from left to right.
    pub list: Vec<Answer>,
    /// Results for each load case alone, which may have no equilibrium.
    pub alone: Vec<Alone>,
    /// Ground constants of the first combination before the solve, which may adapt them; `None` if the ground
    /// is not uniform or the bearing width is unknown.
    pub ground: Option<Ground>,
    pub(crate) swept: Vec<Swept>,
}

/// The result of one load case without the others, and the check whether its equilibrium exists.
#[derive(Debug, Clone)]
pub struct Alone {
    /// The load case, and the model under the loads of this case alone.
    pub case: LoadCase,
    /// Result of the existence check.
    pub existence: Existence,
}

impl Alone {
    /// Whether the load case alone has an equilibrium.
    pub fn stands(&self) -> bool {
        self.existence.verdict.stands()
    }
}

impl Answers {
    /// The answers that contain a solution, each paired with its solution.
    pub fn solved(&self) -> impl Iterator<Item = (&Answer, &Solution)> {
        self.list.iter().filter_map(|answer| Some((answer, answer.solution()?)))
    }

    /// The envelope over all answers that contain a solution. It names the governing answer by its index in
    /// [`Answers::solved`].
    pub fn envelope(&self) -> Envelope<'_> {
        Envelope::of(self.solved().map(|(_, solution)| solution))
    }

    /// Limit states of the answers that contain a solution; empty if no combination names a limit state.
    pub fn limit_states(&self) -> LimitStates {
        let each = self.solved().map(|(answer, _)| answer.label.combination.limit_states);
        each.fold(LimitStates::NONE, LimitStates::and)
    }

    /// The answers of a limit state that contain a solution, each paired with its solution.
    pub fn of_limit_state(&self, state: LimitState) -> impl Iterator<Item = (&Answer, &Solution)> {
        self.solved().filter(move |(answer, _)| answer.is_of(state))
    }

    /// The passages of all trains.
    pub fn passages(&self) -> Passages<'_> {
        let all = self.swept.iter().map(|swept| swept.passage(&self.list)).collect();
        Passages { all, state: None }
    }

    /// The worst status of all answers. The status "no equilibrium" is worse than "not converged".
    pub fn overall(&self) -> Overall {
        let each = self.list.iter().map(|answer| answer.found.overall());
        each.chain([self.passages().overall()]).max().unwrap_or(Overall::Solved)
    }
}

/// Number of equal steps along the beam for envelopes in documents and tables.
const EVEN_STEPS: usize = 100;

/// The passages of each train under each combination.
#[derive(Debug, Clone, Default)]
pub struct Passages<'a> {
    /// Passages in the order of the combinations. The passages under one combination are in the order of the
    /// trains.
    pub all: Vec<Passage<'a>>,
    /// Limit state of the passages that ranges and envelopes include; `None` includes all passages.
    pub state: Option<LimitState>,
}

/// A governing value, with the passage in which it occurs.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct InPassage {
    /// The value, its position on the beam, and the position of the train.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub located: Located,
    /// Index of the passage.
    pub passage: usize,
}

impl<'a> Passages<'a> {
    /// A copy of these passages whose ranges and envelopes include only one limit state.
    pub fn of_limit_state(&self, state: LimitState) -> Self {
        Passages { state: Some(state), ..self.clone() }
    }

    /// The selected passages with their indices.
    fn counted(&self) -> impl Iterator<Item = (usize, &Passage<'a>)> {
        let counts = |passage: &Passage| {
            self.state.is_none_or(|state| passage.limit_states().contains(state))
        };
        self.all.iter().enumerate().filter(move |(_, passage)| counts(passage))
    }

    /// Limit states of the passages; empty if no combination names a limit state.
    pub fn limit_states(&self) -> LimitStates {
        let each = self.all.iter().map(Passage::limit_states);
        each.fold(LimitStates::NONE, LimitStates::and)
    }

    /// The fields that results contain, in the order of [`Field::ALL`]. The rotation is omitted for a beam without shear
    /// deformation.
    pub fn fields(&self) -> impl Iterator<Item = Field> + Clone + use<> {
        self.all.first().map(Passage::fields).into_iter().flatten()
    }

    /// The smallest and the largest value of every field over all passages at the position `x` of the beam. `None` if
    /// no train position has a solution.
    pub fn at(&self, x: f64) -> Option<ByField<[InPassage; 2]>> {
        let each = self.counted().filter_map(|(passage, one)| {
            let bounds = one.at(x)?;
            Some(bounds.map(|both| both.map(|located| InPassage { located, passage })))
        });
        each.reduce(|mut all, bounds| {
            all.iter_mut().zip(bounds).for_each(|(both, new)| widen(both, new));
            all
        })
    }

    /// The smallest and the largest value of a field on the whole beam over all passages. `None` if no train position
    /// has a solution.
    pub fn range(&self, field: Field) -> Option<[InPassage; 2]> {
        let each = self.counted().filter_map(|(passage, one)| {
            let range = one.range(field)?;
            Some(range.map(|located| InPassage { located, passage }))
        });
        each.reduce(|mut all, range| {
            widen(&mut all, range);
            all
        })
    }

    /// Default positions along the beam at which the envelopes of all train passages are evaluated.
    pub fn default_stations(&self) -> Vec<f64> {
        self.stations(EVEN_STEPS)
    }

    /// Positions along the beam at which the envelopes of all train passages are evaluated. They include the ends of
    /// `even` equal steps.
    pub fn stations(&self, even: usize) -> Vec<f64> {
        let mut x: Vec<f64> = self.all.iter().flat_map(|passage| passage.stations(even)).collect();
        x.sort_by(f64::total_cmp);
        x.dedup();
        x
    }

    /// The bending moment with the largest absolute value, and the passage and the train position in which it occurs.
    pub fn largest_moment(&self) -> Option<InPassage> {
        let [min, max] = self.range(Field::Moment)?;
        Some(if max.located.value >= -min.located.value { max } else { min })
    }

    /// The worst status of all passages.
    pub fn overall(&self) -> Overall {
        self.all.iter().map(Passage::overall).max().unwrap_or(Overall::Solved)
    }

    /// Whether at least one train position has a solution.
    pub fn any_solved(&self) -> bool {
        self.all.iter().any(|passage| passage.solved().next().is_some())
    }
}

/// Widens a range to include another range. The first of two equal values is kept.
fn widen(both: &mut [InPassage; 2], [min, max]: [InPassage; 2]) {
    if min.located.value < both[0].located.value {
        both[0] = min;
    }
    if max.located.value > both[1].located.value {
        both[1] = max;
    }
}
