//! Writes the document of passages: each train, the solved positions, and the envelope.

use super::enveloped::Enveloped;
use super::{Along, ByName, Extremes, FreeSpan, Head, Lines, checks, text};
use crate::context::Context;
use crate::text::train::positions_of;
use groundbeam::model::{Axle, UniformPart};
use groundbeam::{Field, design::LimitState, solution::ByField};
use groundbeam_file::MovingTrain;
use groundbeam_run::{InPassage, Located, Opened, Overall, Passage, Passages, Uplift};
use serde::Serialize;

/// Returns the document of all passages, or of the only passage. `None` for `stations` selects the default sections.
pub fn trains(passages: &Passages, stations: Option<&[f64]>, context: &Context) -> String {
    if let [passage] = passages.all[..] {
        let head = Head::new(passage.overall().name(), context);
        let one = One::of(passage, stations);
        let checks = checks::of(&positions_of(&passages.all, context), context);
        return text(&Document { head, one, checks, seconds: context.seconds });
    }
    let sections = || stations.map_or_else(|| passages.default_stations(), <[f64]>::to_vec);
    let of_state = |state: Option<LimitState>| {
        let of_state =
            state.map_or_else(|| passages.clone(), |state| passages.of_limit_state(state));
        let extremes = |field| of_state.range(field).map(Extremes::of);
        let any = of_state.at(0.0).is_some();
        any.then(|| {
            let envelope = envelope_of_all(&of_state, sections());
            (envelope, ByName::of(passages.fields(), extremes))
        })
    };
    let checks = checks::of(&positions_of(&passages.all, context), context);
    text(&Several {
        head: Head::new(passages.overall().name(), context),
        passages: passages.all.iter().map(|&passage| Each::of(passage, stations)).collect(),
        enveloped: Enveloped::new(passages.limit_states(), of_state, checks),
        seconds: context.seconds,
    })
}

/// Returns the document that states, for each train, the ranges of train positions without equilibrium.
pub fn checked_trains(passages: &Passages, context: &Context) -> String {
    let status = match passages.overall() {
        Overall::NoEquilibrium => "no-equilibrium",
        _ => "equilibrium-exists",
    };
    let of = |passage: &Passage| CheckedOne {
        combination: passage.combination().map(str::to_owned),
        name: passage.moving().name.clone(),
        range: Stretch::of(passage.moving().range),
        without_equilibrium: without_equilibrium(passage),
    };
    text(&CheckedAll {
        head: Head::new(status, context),
        trains: passages.all.iter().map(of).collect(),
        seconds: context.seconds,
    })
}

#[derive(Serialize)]
struct CheckedAll<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    trains: Vec<CheckedOne>,
    seconds: Option<f64>,
}

#[derive(Serialize)]
struct CheckedOne {
    #[serde(skip_serializing_if = "Option::is_none")]
    combination: Option<String>,
    name: String,
    range: Stretch,
    without_equilibrium: Vec<Stretch>,
}

#[derive(Serialize)]
struct Several<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    passages: Vec<Each<'a>>,
    #[serde(flatten)]
    enveloped: Enveloped<f64, Option<Extremes<InPassage>>>,
    seconds: Option<f64>,
}

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    #[serde(flatten)]
    one: One<'a>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    checks: Vec<checks::Checked>,
    seconds: Option<f64>,
}

/// One of several passages.
#[derive(Serialize)]
struct Each<'a> {
    status: &'static str,
    #[serde(flatten)]
    one: One<'a>,
}

impl<'a> Each<'a> {
    fn of(passage: Passage<'a>, stations: Option<&[f64]>) -> Self {
        Each { status: passage.overall().name(), one: One::of(passage, stations) }
    }
}

/// One passage.
#[derive(Serialize)]
struct One<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    combination: Option<&'a str>,
    train: Train<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    envelope: Option<Along<Lines<f64>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    extremes: Option<ByName<Option<Extremes<Located>>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    uplift: Option<Uplift>,
    /// Longest free span, and free span with the largest gap; omitted if no train position has a solution.
    #[serde(skip_serializing_if = "Option::is_none")]
    free_spans: Option<FreeSpans>,
}

impl<'a> One<'a> {
    fn of(passage: Passage<'a>, stations: Option<&[f64]>) -> Self {
        let any = passage.solved().next().is_some();
        let stations = || stations.map_or_else(|| passage.default_stations(), <[f64]>::to_vec);
        One {
            combination: passage.combination(),
            train: Train::of(passage),
            envelope: any.then(|| envelope_of(passage, stations())),
            extremes: any.then(|| {
                ByName::of(passage.fields(), |field| passage.range(field).map(Extremes::of))
            }),
            uplift: any.then(|| passage.uplift()),
            free_spans: any.then(|| {
                let found = passage.free_spans();
                FreeSpans {
                    longest: found.map(|found| Span::of(found.longest)),
                    largest_gap: found.map(|found| Span::of(found.highest)),
                }
            }),
        }
    }
}

#[derive(Serialize)]
struct Train<'a> {
    name: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    set: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    case: Option<&'a str>,
    factor: f64,
    dynamic: f64,
    /// Where the loads of infinite length act: everywhere, only ahead of the train, only behind it, on one half
    /// of the beam, or nowhere.
    spread: &'static str,
    axles: &'a [Axle],
    /// Uniform loads of the train. An end at infinity is written as `null`.
    uniform: &'a [UniformPart],
    range: Stretch,
    /// Number of train positions with a solution.
    positions: usize,
    error: Error,
    without_equilibrium: Vec<Stretch>,
    not_converged: Vec<f64>,
}

#[derive(Serialize)]
struct Stretch {
    from: f64,
    to: f64,
}

impl Stretch {
    fn of([from, to]: [f64; 2]) -> Self {
        Stretch { from, to }
    }
}

/// Requested and achieved errors of the envelope, relative to the largest value of each field.
#[derive(Serialize)]
struct Error {
    stated: f64,
    reached: f64,
    reached_by_field: ByName<f64>,
}

impl<'a> Train<'a> {
    fn of(passage: Passage<'a>) -> Self {
        let moving = passage.moving();
        let MovingTrain { name, set, case, factor, dynamic, spread, range, train } = moving;
        let reach = passage.reach();
        Train {
            name,
            set: set.as_deref(),
            case: case.as_deref(),
            factor: *factor,
            dynamic: *dynamic,
            spread: spread.name(),
            axles: &train.axles,
            uniform: &train.uniform,
            range: Stretch::of(*range),
            positions: passage.solved().count(),
            error: Error {
                stated: reach.asked,
                reached: reach.largest(),
                reached_by_field: ByName::of(passage.fields(), |field| reach.of(field)),
            },
            without_equilibrium: without_equilibrium(&passage),
            not_converged: passage.not_converged().collect(),
        }
    }
}

fn without_equilibrium(passage: &Passage) -> Vec<Stretch> {
    passage.without_equilibrium().iter().copied().map(Stretch::of).collect()
}

fn envelope_of(passage: Passage, x: Vec<f64>) -> Along<Lines<f64>> {
    let in_it = |located| InPassage { located, passage: 0 };
    let at = |x| Some(passage.at(x)?.map(|both| both.map(in_it)));
    envelope(x, passage.fields(), at, false)
}

fn envelope_of_all(passages: &Passages, x: Vec<f64>) -> Along<Lines<f64>> {
    envelope(x, passages.fields(), |x| passages.at(x), true)
}

/// Returns the envelope at the positions `x`: the smallest and the largest value of each field. Each value is
/// listed with the position of the first axle of the train.
fn envelope(
    x: Vec<f64>,
    fields: impl Iterator<Item = Field>,
    at: impl Fn(f64) -> Option<ByField<[InPassage; 2]>>,
    several: bool,
) -> Along<Lines<f64>> {
    let bounds: Vec<ByField<[InPassage; 2]>> = x.iter().filter_map(|&x| at(x)).collect();
    let lines = |field: Field| {
        let [min, max] = [0, 1].map(|bound| {
            bounds.iter().map(move |bounds| bounds[field.index()][bound]).collect::<Vec<_>>()
        });
        let value = |all: &[InPassage]| all.iter().map(|g| g.located.value).collect();
        let axle = |all: &[InPassage]| all.iter().map(|g| g.located.first_axle).collect();
        let which = |all: &[InPassage]| several.then(|| all.iter().map(|g| g.passage).collect());
        Lines {
            min: value(&min),
            max: value(&max),
            governs_min: axle(&min),
            governs_max: axle(&max),
            passage_min: which(&min),
            passage_max: which(&max),
        }
    };
    Along { fields: ByName::of(fields, lines), x }
}

/// Longest free span and free span with the largest gap; `null` without lift-off.
#[derive(Serialize)]
struct FreeSpans {
    longest: Option<Span>,
    largest_gap: Option<Span>,
}

#[derive(Serialize)]
struct Span {
    #[serde(flatten)]
    span: FreeSpan,
    /// Position of the first axle.
    first_axle: f64,
}

impl Span {
    fn of(Opened { first_axle, stretch }: Opened) -> Self {
        Span { span: FreeSpan::of(stretch), first_axle }
    }
}
