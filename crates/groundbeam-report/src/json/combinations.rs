//! Writes the result document of a model file with combinations: the result of each combination, and the envelope.

use super::bounds::Together;
use super::enveloped::Enveloped;
use super::existence::Proven;
use super::{
    Along, ByName, Checked, EVEN_STEPS, Extremes, Head, Lines, Solved, Unsolved, checks,
    default_stations, text,
};
use crate::checked::rows_of;
use crate::context::Context;
use groundbeam::{
    Field,
    design::LimitState,
    envelope::{Bound, Bounds, Change, Envelope, Governing},
    solution::Extreme,
};
use groundbeam_run::{Alone, Answer, Answers, Banded, Found, Overall};
use serde::Serialize;
use std::collections::BTreeMap;

/// Returns the document of all combinations, solved or only checked. `None` for `stations` selects default positions.
pub fn combinations(answers: &Answers, stations: Option<&[f64]>, context: &Context) -> String {
    let envelope = answers.envelope();
    let listed = match stations {
        Some(stations) => stations.to_vec(),
        None => envelope.stations(EVEN_STEPS),
    };
    let exists = answers.list.iter().any(|answer| matches!(answer.found, Found::Exists(_)));
    let status = match answers.overall() {
        Overall::Solved if exists => "equilibrium-exists",
        overall => overall.name(),
    };
    let of_state = |state: Option<LimitState>| {
        let is_of = |(answer, _): &(&Answer, _)| state.is_none_or(|state| answer.is_of(state));
        let (of_it, solutions): (Vec<_>, Vec<_>) = answers.solved().filter(is_of).unzip();
        let names: Vec<&str> = of_it.into_iter().map(Answer::name).collect();
        let envelope = Envelope::of(solutions);
        let of = Named { envelope: &envelope, names: &names };
        let extremes = ByName::of(envelope.fields(), |field| of.extremes(field));
        (!names.is_empty()).then(|| (of.table(&listed), extremes))
    };
    let checks = checks::of(&rows_of(answers, context), context);
    let names: Vec<&str> = answers.solved().map(|(answer, _)| answer.name()).collect();
    let of = Named { envelope: &envelope, names: &names };
    text(&All {
        head: Head::new(status, context),
        combinations: each(answers, stations, context),
        cases: answers.alone.iter().map(|case| Case::of(case, context)).collect(),
        enveloped: Enveloped::new(answers.limit_states(), of_state, checks),
        band: answers
            .bands()
            .map(|bands| ByName::of(envelope.fields(), |field| Extremes::of(bands[field.index()]))),
        changes: (!names.is_empty())
            .then(|| ByName::of(envelope.fields(), |field| of.changes(field))),
        proof: Together::of(answers, &listed, context),
        seconds: context.seconds,
    })
}

/// Returns the default positions of an envelope: the default positions of all solutions, and the positions
/// where the governing combination changes.
pub fn envelope_stations(answers: &Answers) -> Vec<f64> {
    answers.envelope().stations(EVEN_STEPS)
}

#[derive(Serialize)]
struct All<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    combinations: Vec<One<'a>>,
    cases: Vec<Case<'a>>,
    #[serde(flatten)]
    enveloped: Enveloped<&'a str, Extremes<Governed<'a>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    band: Option<ByName<Extremes<Banded>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    changes: Option<ByName<Vec<Changed<'a>>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    proof: Option<Together>,
    seconds: Option<f64>,
}

#[derive(Serialize)]
struct One<'a> {
    name: &'a str,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    limit_states: Vec<&'static str>,
    factors: BTreeMap<&'a str, f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ground_factors: Option<GroundFactors>,
    #[serde(flatten)]
    result: Result<'a>,
}

/// Factors on k and μ.
#[derive(Serialize)]
struct GroundFactors {
    k: f64,
    mu: f64,
}

#[derive(Serialize)]
#[serde(untagged)]
enum Result<'a> {
    Solved(Box<Solved<'a>>),
    Checked(Box<Checked<'a>>),
    Stopped(Box<Unsolved<'a>>),
    Refused { status: &'static str, why: String },
}

fn each<'a>(answers: &'a Answers, stations: Option<&[f64]>, context: &Context<'a>) -> Vec<One<'a>> {
    let (pieces, model, proofs) = (context.pieces, context.model, context.proofs);
    let context = Context { pieces, model, ..Context::new(context.units) };
    let one = |(i, answer): (usize, &'a Answer)| {
        let combination = &answer.label.combination;
        let model = &combination.model;
        let proofs = proofs.get(i..=i).unwrap_or_default();
        let context = Context { ground: answer.ground.as_ref(), proofs, ..context };
        let result = match &answer.found {
            Found::Equilibrium(solution) => {
                let own = stations.map_or_else(|| default_stations(solution), <[f64]>::to_vec);
                Result::Solved(Box::new(Solved::of(solution, &own, &context)))
            }
            Found::Exists(existence) => Result::Checked(Box::new(Checked::of(
                "equilibrium-exists",
                model,
                existence,
                &context,
            ))),
            Found::NoEquilibrium(existence) => {
                Result::Checked(Box::new(Checked::of("no-equilibrium", model, existence, &context)))
            }
            Found::NotConverged(reached) => {
                Result::Stopped(Box::new(Unsolved::of(reached, &context)))
            }
            Found::Unsolved(error) => {
                Result::Refused { status: "not-solved", why: error.to_string() }
            }
        };
        let factors =
            combination.factors.iter().map(|(case, factor)| (case.as_str(), *factor)).collect();
        let ground_factors = combination.ground.map(|[k, mu]| GroundFactors { k, mu });
        let limit_states = combination.limit_states.iter().map(LimitState::name).collect();
        One { name: &combination.name, limit_states, factors, ground_factors, result }
    };
    answers.list.iter().enumerate().map(one).collect()
}

#[derive(Serialize)]
struct Case<'a> {
    name: &'a str,
    stands_alone: bool,
    /// State of the load case alone: `physical` or `not a physical state`.
    state: &'static str,
    existence: Proven,
}

impl<'a> Case<'a> {
    fn of(case: &'a Alone, context: &Context) -> Self {
        let stands = case.stands();
        Case {
            name: &case.case.name,
            stands_alone: stands,
            state: if stands { "physical" } else { "not a physical state" },
            existence: Proven::new(&case.case.model, &case.existence, context),
        }
    }
}

#[derive(Serialize)]
struct Governed<'a> {
    #[serde(flatten)]
    extreme: Extreme,
    combination: &'a str,
}

#[derive(Serialize)]
struct Changed<'a> {
    x: f64,
    bound: Bound,
    from: &'a str,
    to: &'a str,
}

/// An envelope with the names of its combinations.
struct Named<'e, 'a> {
    envelope: &'e Envelope<'e>,
    names: &'e [&'a str],
}

impl<'a> Named<'_, 'a> {
    fn name(&self, number: usize) -> &'a str {
        self.names.get(number).copied().unwrap_or_default()
    }

    fn table(&self, stations: &[f64]) -> Along<Lines<&'a str>> {
        let all: Vec<_> = stations.iter().map(|&x| self.envelope.all_at(x)).collect();
        let lines = |field: Field| {
            let bounds = || all.iter().map(|bounds| &bounds[field.index()]);
            Lines {
                min: bounds().map(|bounds| bounds.min.extreme.value).collect(),
                max: bounds().map(|bounds| bounds.max.extreme.value).collect(),
                governs_min: bounds().map(|bounds| self.name(bounds.min.by)).collect(),
                governs_max: bounds().map(|bounds| self.name(bounds.max.by)).collect(),
                passage_min: None,
                passage_max: None,
            }
        };
        Along { x: stations.to_vec(), fields: ByName::of(self.envelope.fields(), lines) }
    }

    fn extremes(&self, field: Field) -> Extremes<Governed<'a>> {
        let governed = |Governing { extreme, by }| Governed { extreme, combination: self.name(by) };
        let Bounds { min, max } = self.envelope.range(field);
        Extremes { min: governed(min), max: governed(max) }
    }

    fn changes(&self, field: Field) -> Vec<Changed<'a>> {
        let changed = |Change { x, bound, from, to }| {
            let [from, to] = [from, to].map(|number| self.name(number));
            Changed { x, bound, from, to }
        };
        self.envelope.changes(field).into_iter().map(changed).collect()
    }
}
