//! The document of passages: each train, the positions that were solved, and the envelope.

use super::{ByName, FreeSpan, text};
use crate::context::Context;
use groundbeam::{ByField, Field};
use groundbeam_file::MovingTrain;
use groundbeam_run::{InPassage, Located, Opened, Overall, Passage, Passages};
use serde::Serialize;

/// The document of passages, with the envelopes at the given sections; left out, at those that suit them. Of a single
/// passage it is that one's own.
pub fn trains(passages: &Passages, stations: Option<&[f64]>, context: &Context) -> String {
    let (title, units) = (context.title, context.units.name());
    let trough_chords = context.chords;
    if let [passage] = passages.all[..] {
        let one = One::of(passage, stations);
        return text(&Document { title, units, trough_chords, one, seconds: context.seconds });
    }
    let any = passages.any_solved();
    let sections = || stations.map_or_else(|| passages.default_stations(), <[f64]>::to_vec);
    text(&Several {
        status: passages.overall().name(),
        title,
        units,
        trough_chords,
        passages: passages.all.iter().map(|&passage| One::of(passage, stations)).collect(),
        envelope: any.then(|| Table::of_all(passages, sections())),
        extremes: any.then(|| {
            ByName::of(passages.fields(), |field| passages.range(field).map(Extremes::of_all))
        }),
        seconds: context.seconds,
    })
}

/// The document of trains that were not solved for: where along their ways there is no equilibrium.
pub fn checked_trains(passages: &Passages, context: &Context) -> String {
    let falls = passages.overall() == Overall::NoEquilibrium;
    let of = |passage: &Passage| CheckedOne {
        combination: passage.combination().map(str::to_owned),
        name: passage.moving().name.clone(),
        range: Stretch::of(passage.moving().range),
        without_equilibrium: passage
            .without_equilibrium()
            .iter()
            .copied()
            .map(Stretch::of)
            .collect(),
    };
    text(&CheckedAll {
        status: if falls { "no-equilibrium" } else { "equilibrium-exists" },
        title: context.title,
        units: context.units.name(),
        trough_chords: context.chords,
        trains: passages.all.iter().map(of).collect(),
        seconds: context.seconds,
    })
}

#[derive(Serialize)]
struct CheckedAll<'a> {
    status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    title: Option<&'a str>,
    units: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    trough_chords: Option<usize>,
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
    status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    title: Option<&'a str>,
    units: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    trough_chords: Option<usize>,
    passages: Vec<One<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    envelope: Option<Table>,
    #[serde(skip_serializing_if = "Option::is_none")]
    extremes: Option<ByName<Option<Extremes>>>,
    seconds: Option<f64>,
}

#[derive(Serialize)]
struct Document<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    title: Option<&'a str>,
    units: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    trough_chords: Option<usize>,
    #[serde(flatten)]
    one: One<'a>,
    seconds: Option<f64>,
}

/// One passage.
#[derive(Serialize)]
struct One<'a> {
    status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    combination: Option<&'a str>,
    train: Head<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    envelope: Option<Table>,
    #[serde(skip_serializing_if = "Option::is_none")]
    extremes: Option<ByName<Option<Extremes>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    uplift: Option<Uplift>,
    /// Left out where nothing was solved.
    #[serde(skip_serializing_if = "Option::is_none")]
    free_spans: Option<FreeSpans>,
}

impl<'a> One<'a> {
    fn of(passage: Passage<'a>, stations: Option<&[f64]>) -> Self {
        let any = passage.solved().next().is_some();
        let stations = || stations.map_or_else(|| passage.default_stations(), <[f64]>::to_vec);
        let uplift = passage.uplift();
        One {
            status: passage.overall().name(),
            combination: passage.combination(),
            train: Head::of(passage),
            envelope: any.then(|| Table::of(passage, stations())),
            extremes: any.then(|| {
                ByName::of(passage.fields(), |field| passage.range(field).map(Extremes::of))
            }),
            uplift: any.then(|| Uplift {
                ahead: uplift.ahead.map(Place::of),
                between: uplift.between.map(Place::of),
                behind: uplift.behind.map(Place::of),
            }),
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
struct Head<'a> {
    name: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    set: Option<&'a str>,
    factor: f64,
    axles: Vec<Axle>,
    uniform: Vec<Part>,
    range: Stretch,
    /// Positions that were solved.
    positions: usize,
    error: Error,
    without_equilibrium: Vec<Stretch>,
    not_converged: Vec<f64>,
}

#[derive(Serialize)]
struct Axle {
    at: f64,
    force: f64,
}

/// What has no end is `null` there.
#[derive(Serialize)]
struct Part {
    from: f64,
    to: f64,
    load: f64,
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

/// Relative to each field's largest value.
#[derive(Serialize)]
struct Error {
    stated: f64,
    reached: f64,
    reached_by_field: ByName<f64>,
}

impl<'a> Head<'a> {
    fn of(passage: Passage<'a>) -> Self {
        let MovingTrain { name, set, factor, range, train } = passage.moving();
        let reach = passage.reach();
        Head {
            name,
            set: set.as_deref(),
            factor: *factor,
            axles: train.axles.iter().map(|a| Axle { at: a.behind, force: a.force }).collect(),
            uniform: train
                .uniform
                .iter()
                .map(|part| Part { from: part.from, to: part.to, load: part.intensity })
                .collect(),
            range: Stretch::of(*range),
            positions: passage.solved().count(),
            error: Error {
                stated: reach.asked,
                reached: reach.largest(),
                reached_by_field: ByName::of(passage.fields(), |field| reach.of(field)),
            },
            without_equilibrium: passage
                .without_equilibrium()
                .iter()
                .copied()
                .map(Stretch::of)
                .collect(),
            not_converged: passage.not_converged().collect(),
        }
    }
}

#[derive(Serialize)]
struct Table {
    x: Vec<f64>,
    #[serde(flatten)]
    fields: ByName<Lines>,
}

#[derive(Serialize)]
struct Lines {
    min: Vec<f64>,
    max: Vec<f64>,
    /// Positions of the first axle.
    governs_min: Vec<f64>,
    governs_max: Vec<f64>,
    /// Of several passages which ones, counted from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    passage_min: Option<Vec<usize>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    passage_max: Option<Vec<usize>>,
}

impl Table {
    fn of(passage: Passage, x: Vec<f64>) -> Self {
        let in_it = |located| InPassage { located, passage: 0 };
        let at = |x| Some(passage.at(x)?.map(|both| both.map(in_it)));
        Table::by(x, passage.fields(), at, false)
    }

    fn of_all(passages: &Passages, x: Vec<f64>) -> Self {
        Table::by(x, passages.fields(), |x| passages.at(x), true)
    }

    fn by(
        x: Vec<f64>,
        fields: impl Iterator<Item = Field>,
        at: impl Fn(f64) -> Option<ByField<[InPassage; 2]>>,
        several: bool,
    ) -> Self {
        let bounds: Vec<ByField<[InPassage; 2]>> = x.iter().filter_map(|&x| at(x)).collect();
        let lines = |field: Field| {
            let [min, max] = [0, 1].map(|bound| {
                bounds.iter().map(move |bounds| bounds[field.index()][bound]).collect::<Vec<_>>()
            });
            let value = |all: &[InPassage]| all.iter().map(|g| g.located.value).collect();
            let axle = |all: &[InPassage]| all.iter().map(|g| g.located.first_axle).collect();
            let which =
                |all: &[InPassage]| several.then(|| all.iter().map(|g| g.passage).collect());
            Lines {
                min: value(&min),
                max: value(&max),
                governs_min: axle(&min),
                governs_max: axle(&max),
                passage_min: which(&min),
                passage_max: which(&max),
            }
        };
        Table { fields: ByName::of(fields, lines), x }
    }
}

#[derive(Serialize)]
struct Extremes {
    min: Place,
    max: Place,
}

impl Extremes {
    fn of([min, max]: [Located; 2]) -> Self {
        Extremes { min: Place::of(min), max: Place::of(max) }
    }

    fn of_all(both: [InPassage; 2]) -> Self {
        let [min, max] = both.map(|governing| Place {
            passage: Some(governing.passage),
            ..Place::of(governing.located)
        });
        Extremes { min, max }
    }
}

#[derive(Serialize)]
struct Place {
    x: f64,
    value: f64,
    /// Position of the first axle.
    first_axle: f64,
    /// Of several passages which one, counted from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    passage: Option<usize>,
}

impl Place {
    fn of(Located { x, value, first_axle }: Located) -> Self {
        Place { x, value, first_axle, passage: None }
    }
}

/// The longest stretch in the air and the one with the largest gap; `null` where nothing lifts.
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
        Span { span: FreeSpan::of(&stretch), first_axle }
    }
}

/// The largest gaps; `null` where nothing lifts.
#[derive(Serialize)]
struct Uplift {
    ahead: Option<Place>,
    between: Option<Place>,
    behind: Option<Place>,
}
