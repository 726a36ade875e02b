//! The document of a train's passage: the train, the positions that were solved, and the envelope.

use super::combinations::ByField;
use super::text;
use crate::context::Context;
use crate::trains::Moving;
use groundbeam::Field;
use groundbeam::train::Located;
use serde::Serialize;

/// The document of a train's passage, with the envelope at the given sections; left out, at those that suit it.
pub fn train(moving: &Moving, stations: Option<&[f64]>, context: &Context) -> String {
    let passage = moving.passage;
    let any = passage.solved().next().is_some();
    let stations = || stations.map_or_else(|| moving.default_stations(), <[f64]>::to_vec);
    let uplift = passage.uplift();
    text(&Document {
        status: moving.status(),
        title: context.title,
        units: context.units.name(),
        train: Head::of(moving),
        envelope: any.then(|| Table::of(moving, stations())),
        extremes: any.then(|| ByField::of(|field| passage.range(field).map(Extremes::of))),
        uplift: any.then(|| Uplift {
            ahead: uplift.ahead.map(Place::of),
            between: uplift.between.map(Place::of),
            behind: uplift.behind.map(Place::of),
        }),
        seconds: context.seconds,
    })
}

#[derive(Serialize)]
struct Document<'a> {
    status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    title: Option<&'a str>,
    units: &'static str,
    train: Head<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    envelope: Option<Table>,
    #[serde(skip_serializing_if = "Option::is_none")]
    extremes: Option<ByField<Option<Extremes>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    uplift: Option<Uplift>,
    seconds: Option<f64>,
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

/// Relative to each field's largest value.
#[derive(Serialize)]
struct Error {
    stated: f64,
    reached: f64,
    reached_by_field: ByField<f64>,
}

impl<'a> Head<'a> {
    fn of(moving: &Moving<'a>) -> Self {
        let Moving { name, set, factor, range, passage } = *moving;
        let stretch = |[from, to]: [f64; 2]| Stretch { from, to };
        let (train, reach) = (passage.train(), passage.reach());
        Head {
            name,
            set,
            factor,
            axles: train.axles.iter().map(|a| Axle { at: a.behind, force: a.force }).collect(),
            uniform: train
                .uniform
                .iter()
                .map(|part| Part { from: part.from, to: part.to, load: part.intensity })
                .collect(),
            range: stretch(range),
            positions: passage.solved().count(),
            error: Error {
                stated: reach.asked,
                reached: reach.largest(),
                reached_by_field: ByField::of(|field| reach.of(field)),
            },
            without_equilibrium: passage
                .without_equilibrium()
                .iter()
                .copied()
                .map(stretch)
                .collect(),
            not_converged: passage.not_converged().collect(),
        }
    }
}

#[derive(Serialize)]
struct Table {
    x: Vec<f64>,
    #[serde(flatten)]
    fields: ByField<Lines>,
}

#[derive(Serialize)]
struct Lines {
    min: Vec<f64>,
    max: Vec<f64>,
    /// Positions of the first axle.
    governs_min: Vec<f64>,
    governs_max: Vec<f64>,
}

impl Table {
    fn of(moving: &Moving, x: Vec<f64>) -> Self {
        let bounds: Vec<[[Located; 2]; 7]> =
            x.iter().filter_map(|&x| moving.passage.at(x)).collect();
        let lines = |field: Field| {
            let list = |of: fn(&[Located; 2]) -> f64| {
                bounds.iter().map(|bounds| of(&bounds[field.index()])).collect()
            };
            Lines {
                min: list(|[min, _]| min.value),
                max: list(|[_, max]| max.value),
                governs_min: list(|[min, _]| min.first_axle),
                governs_max: list(|[_, max]| max.first_axle),
            }
        };
        Table { fields: ByField::of(lines), x }
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
}

#[derive(Serialize)]
struct Place {
    x: f64,
    value: f64,
    /// Position of the first axle.
    first_axle: f64,
}

impl Place {
    fn of(Located { x, value, first_axle }: Located) -> Self {
        Place { x, value, first_axle }
    }
}

/// The largest gaps; `null` where nothing lifts.
#[derive(Serialize)]
struct Uplift {
    ahead: Option<Place>,
    between: Option<Place>,
    behind: Option<Place>,
}
