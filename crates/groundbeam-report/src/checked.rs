//! Evaluates each design check in the limit states to which it applies, with the error bounds of the compared values.

use crate::bound::Around;
use crate::context::Context;
use crate::quantity::Units;
use crate::verified::Named;
use groundbeam::{
    Field, Solution,
    design::{Check, Checked, LimitState, LimitStates, Limits},
};
use groundbeam_run::{Answer, Answers, Found, Placed};
use std::borrow::Cow;

/// A check, with the error bound of its value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Judged {
    pub check: Check,
    /// Error bound of the checked value. It is infinite if no bound is proven, and `None` if no proof is
    /// requested.
    pub error: Option<f64>,
}

/// Result of the comparison of a value with its limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Judgement {
    /// The computed value is compared with the limit, without an error bound; `true` if the check passes.
    Passes(bool),
    /// All values within the error bound lie on the same side of the limit; `true` if the check passes.
    Proven(bool),
    /// The limit lies within the error bound of the value.
    Undecided,
}

impl Judgement {
    /// Name by which the result document states this outcome of a design check, such as `passes`.
    pub fn name(self) -> &'static str {
        match self {
            Judgement::Passes(true) => "passes",
            Judgement::Passes(false) => "fails",
            Judgement::Proven(true) => "proven-to-pass",
            Judgement::Proven(false) => "proven-to-fail",
            Judgement::Undecided => "undecided",
        }
    }
}

/// Returns the requested design checks of a solution, each with its error bound.
pub(crate) fn judged(
    limits: Option<&Limits>,
    solution: &Solution,
    proof: Option<&Named>,
) -> Vec<Judged> {
    let checks = limits.map(|limits| limits.check(solution)).unwrap_or_default();
    let of = |check: Check| Judged {
        check,
        error: proof.map(|named| error(&check, solution, named, limits)),
    };
    checks.into_iter().map(of).collect()
}

/// Error bound of the value of a check. It is infinite for values from statics, which the proof does not cover.
fn error(check: &Check, solution: &Solution, named: &Named, limits: Option<&Limits>) -> f64 {
    match check.what {
        Checked::BearingPressure => {
            let width = limits.and_then(|limits| limits.bearing_pressure).map_or(0.0, |(_, b)| b);
            // The foundation width and the quotient of pressure and width each have one rounding error.
            let rounding = 4.0 * f64::EPSILON * check.found.abs();
            let error = named.error_of(Field::Pressure) / width * (1.0 + 4.0 * f64::EPSILON);
            (error + rounding).next_up()
        }
        Checked::Settlement => named.error_of(Field::Deflection),
        Checked::LiftedShare => named.error_of_lifted_share(solution),
        Checked::BearingResistance | Checked::Eccentricity | Checked::Overturning => f64::INFINITY,
    }
}

/// Result of one combination or train position, with the data that its design checks need.
#[derive(Debug, Clone)]
pub(crate) struct Row<'a> {
    pub name: Cow<'a, str>,
    /// Limit states of the combination. The set is empty if the loads are not combined, or if the combination
    /// names no limit state.
    pub states: LimitStates,
    /// Whether the combination comes from a Eurocode set of combinations.
    pub eurocode: bool,
    pub solution: Option<&'a Solution>,
    /// Whether the model has no equilibrium.
    pub falls: bool,
    /// Whether the loads act as given, without factors.
    pub as_given: bool,
    /// Proof of the result; `None` if no proof is requested.
    pub proof: Option<&'a Named>,
}

impl<'a> Row<'a> {
    /// Returns the row of one result. If a train is on the beam, the name of the row contains the train's
    /// position.
    pub fn of(answer: &'a Answer, proof: Option<&'a Named>, units: Units) -> Self {
        let combination = &answer.label.combination;
        let mut name = Cow::Borrowed(&*combination.name);
        if let Some(Placed { train, first_axle }) = &answer.label.train {
            let at = units.position(*first_axle);
            let mut place = train.placed_name();
            if !train.train.axles.is_empty() {
                place += &format!(", first axle at {at}");
            }
            name = match &*name {
                "" => place,
                of => format!("{of}; {place}"),
            }
            .into();
        }
        Row {
            name,
            states: combination.limit_states,
            eurocode: combination.eurocode,
            solution: answer.solution(),
            falls: matches!(answer.found, Found::NoEquilibrium(_)),
            as_given: combination.as_written,
            proof,
        }
    }

    /// Returns the row of a single solution. The context contains its combination and its proof.
    pub fn alone(solution: &'a Solution, context: &Context<'a>) -> Self {
        Row {
            name: Cow::Borrowed(""),
            states: context.combination.map_or(LimitStates::NONE, |one| one.limit_states),
            eurocode: context.combination.is_some_and(|one| one.eurocode),
            solution: Some(solution),
            falls: false,
            as_given: context.combination.is_none(),
            proof: context.proofs.first(),
        }
    }
}

/// Verdict on a design check in one limit state, over all results of this limit state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Verdict {
    pub what: Checked,
    /// The limit state; `None` for results without a limit state.
    pub state: Option<LimitState>,
    pub of: Governing,
}

/// Reason for a verdict.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Governing {
    /// Index of the result with the largest utilization of the limit, and its check. The error bound of the check holds
    /// for the largest exact value of all results.
    Judged(usize, Judged),
    /// Index of a result without equilibrium.
    Falls(usize),
    /// Index of a combination or train position that is not solved.
    Unsolved(usize),
    /// Index of a result whose loads have no resultant and therefore no eccentricity.
    NoResultant(usize),
    /// No result belongs to these limit states.
    NoCombination(LimitStates),
}

impl Verdict {
    /// Whether the limit is satisfied; `None` if the check is not judged.
    pub fn passes(&self) -> Option<bool> {
        match self.of {
            Governing::Judged(_, judged) => Some(judged.check.passes()),
            Governing::Falls(_) => Some(false),
            Governing::Unsolved(_) | Governing::NoResultant(_) | Governing::NoCombination(_) => {
                None
            }
        }
    }

    /// Index of the governing result; `None` if no result belongs to the limit states.
    pub fn by(&self) -> Option<usize> {
        match self.of {
            Governing::Judged(by, _)
            | Governing::Falls(by)
            | Governing::Unsolved(by)
            | Governing::NoResultant(by) => Some(by),
            Governing::NoCombination(_) => None,
        }
    }

    /// Clause of the design code that requires the check; `None` if the governing combination does not come
    /// from this code.
    pub fn clause(&self, rows: &[Row]) -> Option<&'static str> {
        let eurocode = self.by().is_some_and(|by| rows[by].eurocode);
        self.what.clause().filter(|_| eurocode)
    }

    /// Whether the limit lies within the error bound of the value.
    pub fn is_undecided(&self) -> bool {
        matches!(self.of, Governing::Judged(_, judged) if judged.is_undecided())
    }
}

/// Returns one verdict for each requested design check and each limit state with results. Results without a limit state
/// count as one more state. A check without any results has one verdict.
pub(crate) fn verdicts(limits: Option<&Limits>, rows: &[Row]) -> Vec<Verdict> {
    let Some(limits) = limits else { return Vec::new() };
    let judged: Vec<Vec<Judged>> = rows
        .iter()
        .map(|row| row.solution.map_or_else(Vec::new, |s| judged(Some(limits), s, row.proof)))
        .collect();
    let mut verdicts = Vec::new();
    for what in limits.asked() {
        let before = verdicts.len();
        let states = limits.limit_states(what);
        let named = states.iter().map(Some).chain([None]);
        let mut any = false;
        for state in named {
            let is_of = |row: &Row| match state {
                Some(state) => row.states.contains(state),
                None => row.states.is_empty(),
            };
            let of_state: Vec<usize> = (0..rows.len()).filter(|&i| is_of(&rows[i])).collect();
            any |= !of_state.is_empty();
            let of = governing(what, &of_state, rows, &judged);
            verdicts.extend(of.map(|of| Verdict { what, state, of }));
        }
        if !any && verdicts.len() == before {
            verdicts.push(Verdict { what, state: None, of: Governing::NoCombination(states) });
        }
    }
    verdicts
}

/// Returns the result that governs a check among the results of one limit state; `None` if the limit state
/// has no results.
fn governing(
    what: Checked,
    of_state: &[usize],
    rows: &[Row],
    judged: &[Vec<Judged>],
) -> Option<Governing> {
    if let Some(&falls) = of_state.iter().find(|&&i| rows[i].falls) {
        return Some(Governing::Falls(falls));
    }
    let of_kind = |i: usize| judged[i].iter().find(|judged| judged.check.what == what).copied();
    let found: Vec<_> = of_state.iter().filter_map(|&i| Some((i, of_kind(i)?))).collect();
    let worst = worst(&found);
    if worst.is_some_and(|(_, judged)| !judged.check.passes()) {
        return worst.map(|(i, judged)| Governing::Judged(i, judged));
    }
    if let Some(&unsolved) = of_state.iter().find(|&&i| rows[i].solution.is_none()) {
        return Some(Governing::Unsolved(unsolved));
    }
    // A result without loads is ignored if another result has a value for the check.
    let is_loaded =
        |i: usize| rows[i].solution.is_some_and(|of| of.existence().static_reactions != [0.0; 2]);
    let lacks = |&&i: &&usize| of_kind(i).is_none() && (worst.is_none() || is_loaded(i));
    if let Some(&without) = of_state.iter().find(lacks) {
        return Some(Governing::NoResultant(without));
    }
    worst.map(|(i, judged)| Governing::Judged(i, judged))
}

/// Returns the check with the largest computed utilization. The returned error bound applies to the largest
/// exact value of all checks in `found`.
fn worst(found: &[(usize, Judged)]) -> Option<(usize, Judged)> {
    // If several checks have the same utilization, the first of them is returned.
    let most = |a: &&(usize, Judged), b: &&(usize, Judged)| {
        a.1.check.utilisation().total_cmp(&b.1.check.utilisation())
    };
    let (i, worst) = *found.iter().rev().max_by(most)?;
    let around = |(_, judged): &(usize, Judged)| {
        let error = judged.error.unwrap_or(f64::INFINITY);
        Around::of(worst.check.found, judged.check.found, error)
    };
    let largest = Around::extreme(found.iter().map(around), true).map(Around::error);
    Some((i, Judged { error: worst.error.and(largest), ..worst }))
}

impl Judged {
    pub fn judgement(&self) -> Judgement {
        let Check { found, limit, .. } = self.check;
        let Some(error) = self.error.filter(|error| error.is_finite()) else {
            return Judgement::Passes(self.check.passes());
        };
        // The limit has the rounding error of one operation, so the exact limit lies between the two
        // neighbouring doubles. A limit of zero is exact.
        let [least, most] =
            if limit == 0.0 { [0.0; 2] } else { [limit.next_down(), limit.next_up()] };
        let [low, high] = match error {
            0.0 => [found; 2],
            _ => [(found - error).next_down(), (found + error).next_up()],
        };
        if high <= least {
            Judgement::Proven(true)
        } else if low > most {
            Judgement::Proven(false)
        } else {
            Judgement::Undecided
        }
    }

    /// Whether the limit lies within the error bound of the value.
    pub fn is_undecided(&self) -> bool {
        self.judgement() == Judgement::Undecided
    }
}

/// Returns the data that the design checks need, with one row for each result.
pub(crate) fn rows_of<'a>(answers: &'a Answers, context: &Context<'a>) -> Vec<Row<'a>> {
    let proofs = context.proofs;
    let each = answers.list.iter().enumerate();
    each.map(|(i, answer)| Row::of(answer, proofs.get(i), context.units)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use groundbeam::design::Beside;

    fn check(what: Checked, found: f64, limit: f64) -> Check {
        Check { what, found, limit, at: None, beside: Beside::Nothing }
    }

    fn settles(found: f64, error: Option<f64>) -> Judged {
        Judged { check: check(Checked::Settlement, found, 0.5), error }
    }

    #[test]
    fn a_check_is_proven_if_the_interval_lies_on_one_side_of_the_limit() {
        for (found, error, expected) in [
            (0.25, None, Judgement::Passes(true)),
            (0.75, None, Judgement::Passes(false)),
            (0.25, Some(f64::INFINITY), Judgement::Passes(true)),
            (0.25, Some(0.125), Judgement::Proven(true)),
            (0.75, Some(0.125), Judgement::Proven(false)),
            (0.25, Some(0.25), Judgement::Undecided),
            (0.75, Some(0.25), Judgement::Undecided),
            // The limit is a rounded number, so a value equal to the limit is undecided.
            (0.5, Some(0.0), Judgement::Undecided),
        ] {
            assert_eq!(settles(found, error).judgement(), expected, "{found} {error:?}");
        }
        let check = check(Checked::LiftedShare, 0.0, 0.0);
        assert_eq!(Judged { check, error: Some(0.0) }.judgement(), Judgement::Proven(true));
    }

    fn row(states: &[LimitState], falls: bool) -> Row<'static> {
        let states = LimitStates::of(states);
        let name = Cow::Borrowed("a");
        let (solution, proof) = (None, None);
        Row { name, states, eurocode: false, solution, falls, as_given: false, proof }
    }

    /// A combination with a smaller value can have a larger upper bound than the governing combination.
    #[test]
    fn the_governing_check_covers_the_bounds_of_all_combinations() {
        let all = [vec![settles(0.375, Some(0.0))], vec![settles(0.25, Some(0.5))]];
        let of = |all: &[Vec<Judged>]| {
            let found = (0..all.len()).map(|i| (i, all[i][0])).collect::<Vec<_>>();
            worst(&found)
        };
        let (i, found) = of(&all).unwrap();
        assert_eq!((i, found.check.found), (0, 0.375));
        assert!((found.error.unwrap() - 0.375).abs() < 1e-15, "{found:?}");
        assert!(found.is_undecided() && !all[0][0].is_undecided());
        assert_eq!(of(&[vec![settles(0.25, None)]]), Some((0, settles(0.25, None))));
    }

    #[test]
    fn a_check_without_a_result_of_its_limit_state_is_not_judged() {
        let limits = Limits { settlement: Some(0.1), ..Limits::default() };
        let of = |rows: &[Row]| verdicts(Some(&limits), rows)[0];
        let strength = of(&[row(&[LimitState::StrGeo], false)]);
        let states = Checked::Settlement.limit_states();
        assert_eq!((strength.of, strength.passes()), (Governing::NoCombination(states), None));
        let falls = of(&[row(&[LimitState::StrGeo], false), row(&[LimitState::Frequent], true)]);
        assert_eq!((falls.of, falls.state), (Governing::Falls(1), Some(LimitState::Frequent)));
        assert_eq!(falls.passes(), Some(false));
        let unsolved = of(&[row(&[LimitState::Frequent], false)]);
        assert_eq!((unsolved.of, unsolved.passes()), (Governing::Unsolved(0), None));
    }

    #[test]
    fn a_zero_value_with_a_zero_limit_has_the_lowest_utilisation() {
        let lifted = |found| check(Checked::LiftedShare, found, 0.0);
        assert!(lifted(0.0).utilisation() < lifted(1e-9).utilisation());
        assert!(!lifted(1e-9).passes());
    }
}
