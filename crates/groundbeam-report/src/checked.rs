//! Judges design checks in their limit states, using the error bounds of the compared values.

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
    /// Error bound of the value; infinite if there is none, `None` if no proof is requested.
    pub error: Option<f64>,
}

/// Whether a limit is satisfied.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Judgement {
    /// Judged by the computed value only.
    Passes(bool),
    /// All values within the error bound lie on the same side of the limit.
    Proven(bool),
    /// The limit lies within the bound.
    Undecided,
}

impl Judgement {
    /// Name in results.
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

/// The requested checks of a solution.
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

/// Error bound of the value of a check. The proof does not cover values that follow from statics:
/// eccentricity, overturning, force on the effective area.
fn error(check: &Check, solution: &Solution, named: &Named, limits: Option<&Limits>) -> f64 {
    match check.what {
        Checked::BearingPressure => {
            let width = limits.and_then(|limits| limits.bearing_pressure).map_or(0.0, |(_, b)| b);
            // The width and the quotient are each rounded once.
            let rounding = 4.0 * f64::EPSILON * check.found.abs();
            let error = named.error_of(Field::Pressure) / width * (1.0 + 4.0 * f64::EPSILON);
            (error + rounding).next_up()
        }
        Checked::Settlement => named.error_of(Field::Deflection),
        Checked::LiftedShare => named.error_of_lifted_share(solution),
        Checked::BearingResistance | Checked::Eccentricity | Checked::Overturning => f64::INFINITY,
    }
}

/// An answer with the data that checks need.
#[derive(Debug, Clone)]
pub(crate) struct Row<'a> {
    pub name: Cow<'a, str>,
    /// The limit states of the answer; empty if the loads act as given.
    pub states: LimitStates,
    /// Whether its combination comes from a set of the Eurocodes.
    pub eurocode: bool,
    pub solution: Option<&'a Solution>,
    /// Whether no equilibrium exists.
    pub falls: bool,
    /// Whether the loads act as given, without factors.
    pub as_given: bool,
    /// The proof of the answer; `None` if no proof is requested.
    pub proof: Option<&'a Named>,
}

impl<'a> Row<'a> {
    /// The row of one answer. The name of an answer with a train contains the train's position.
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

    /// The row of a single solution.
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

/// Verdict on a check in one limit state, over all its answers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Verdict {
    pub what: Checked,
    /// The limit state; `None` for answers without a limit state.
    pub state: Option<LimitState>,
    pub of: Governing,
}

/// Reason for a verdict.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Governing {
    /// Index of the answer with the largest utilization of the limit. The error belongs to the largest of all
    /// values.
    Judged(usize, Judged),
    /// An answer without equilibrium.
    Falls(usize),
    /// An answer that is not solved.
    Unsolved(usize),
    /// The loads of an answer have no resultant, and so no eccentricity.
    NoResultant(usize),
    /// No answer belongs to these limit states.
    NoCombination(LimitStates),
}

impl Verdict {
    /// Whether the limit is satisfied; `None` if it is not judged.
    pub fn passes(&self) -> Option<bool> {
        match self.of {
            Governing::Judged(_, judged) => Some(judged.check.passes()),
            Governing::Falls(_) => Some(false),
            Governing::Unsolved(_) | Governing::NoResultant(_) | Governing::NoCombination(_) => {
                None
            }
        }
    }

    /// Index of the answer that decides; `None` without an answer.
    pub fn by(&self) -> Option<usize> {
        match self.of {
            Governing::Judged(by, _)
            | Governing::Falls(by)
            | Governing::Unsolved(by)
            | Governing::NoResultant(by) => Some(by),
            Governing::NoCombination(_) => None,
        }
    }

    /// The clause that requires the check, if the combination that decides comes from the same code.
    pub fn clause(&self, rows: &[Row]) -> Option<&'static str> {
        let eurocode = self.by().is_some_and(|by| rows[by].eurocode);
        self.what.clause().filter(|_| eurocode)
    }

    /// Whether the limit lies within the error bound of the value.
    pub fn is_undecided(&self) -> bool {
        matches!(self.of, Governing::Judged(_, judged) if judged.is_undecided())
    }
}

/// The verdicts on all requested checks: one for each limit state of a check that has an answer. Every check
/// also judges the answers without a limit state.
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

/// The answer that decides a check, among the answers of one limit state; `None` if no answer has a value.
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
    // An answer without loads does not take part in a check if another answer has a value.
    let is_loaded =
        |i: usize| rows[i].solution.is_some_and(|of| of.existence().static_reactions != [0.0; 2]);
    let lacks = |&&i: &&usize| of_kind(i).is_none() && (worst.is_none() || is_loaded(i));
    if let Some(&without) = of_state.iter().find(lacks) {
        return Some(Governing::NoResultant(without));
    }
    worst.map(|(i, judged)| Governing::Judged(i, judged))
}

/// The value with the largest utilization, with the error of the largest of all values.
fn worst(found: &[(usize, Judged)]) -> Option<(usize, Judged)> {
    // Of equal values, the first one is kept.
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
        // The limit is rounded once, unless it is zero.
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

/// All answers as rows for the checks.
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
            // The limit itself is a rounded number.
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

    /// A combination whose value does not govern may govern by its bound.
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
