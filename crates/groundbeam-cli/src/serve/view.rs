//! Everything the page shows of a model, in one answer.

use super::answer::Scene;
use super::query::Asked;
use super::written::Number;
use crate::input::Input;
use groundbeam::Load;
use groundbeam::model::Part;
use groundbeam_file::Combination;
use groundbeam_report::svg::{self, Grip, Handle};
use groundbeam_report::{Context, Found, Overall, load_name, sentence, text};
use serde::Serialize;

/// Everything the page shows of a model.
#[derive(Debug, Serialize)]
pub struct View {
    status: &'static str,
    /// The verdict in words.
    sentence: String,
    title: Option<String>,
    /// Labels and words beside the picture.
    rows: Vec<(String, String)>,
    picture: Option<Picture>,
    /// The result document without stations, itself JSON.
    document: String,
    /// The whole report as text.
    report: String,
    numbers: Vec<Number>,
    combinations: Vec<String>,
    trains: Vec<Train>,
    length: f64,
    /// Whether positions are in metres.
    has_units: bool,
}

#[derive(Debug, Serialize)]
struct Picture {
    svg: String,
    width: f64,
    height: f64,
    left: f64,
    scale: f64,
    handles: Vec<Held>,
}

/// A place to take hold of, and the numbers of the text that it moves.
#[derive(Debug, Serialize)]
struct Held {
    name: String,
    x: f64,
    y: f64,
    at: f64,
    /// Between which positions it may be moved.
    range: [f64; 2],
    /// Which of the numbers is its position.
    position: usize,
    /// Which of the numbers is its size.
    size: Option<usize>,
}

#[derive(Debug, Serialize)]
struct Train {
    name: String,
    from: f64,
    to: f64,
}

impl View {
    pub fn of(
        input: &Input,
        found: &Found,
        scene: Scene,
        asked: &Asked,
        context: &Context,
    ) -> View {
        let document = &input.document;
        let trains = document.trains.iter().map(|train| Train {
            name: train.name.clone(),
            from: train.range[0],
            to: train.range[1],
        });
        let (sentence, rows) = said(found, context);
        View {
            status: found.overall().name(),
            sentence,
            title: document.title.clone(),
            rows,
            picture: picture(input, found, scene, asked, context),
            document: found.json(Some(&[]), context),
            report: found.text(context, false),
            numbers: Number::all(document),
            combinations: document.combination_names(),
            trains: trains.collect(),
            length: document.model.beam.length,
            has_units: document.units == groundbeam_file::UnitSystem::Si,
        }
    }
}

/// The verdict in words, and what stands beside the picture.
fn said(found: &Found, context: &Context) -> (String, Vec<(String, String)>) {
    match found {
        Found::Equilibrium(solution) => {
            let said = sentence(solution.model(), solution.existence(), context.units);
            (said, text::summary(solution, context))
        }
        Found::NoEquilibrium(model, existence) => {
            (sentence(model, existence, context.units), text::failing(model, existence, context))
        }
        Found::NotConverged(_, reached) => (reached.to_string(), Vec::new()),
        Found::Combinations(all) => {
            let said = match all.overall() {
                Overall::Solved => "all of them are in equilibrium",
                Overall::NoEquilibrium => "at least one of them has no equilibrium",
                Overall::NotConverged => "at least one of them could not be certified",
            };
            let said = format!("{} combinations: {said}", all.combined.len());
            let rows = all.combined.iter().map(|combined| {
                let words = match combined.answer.existence() {
                    Some(existence) => sentence(combined.model, existence, context.units),
                    None => "no answer could be certified".to_owned(),
                };
                (combined.name.to_owned(), words)
            });
            (said, rows.collect())
        }
        Found::Trains(passages) => {
            let said = match passages.overall() {
                Overall::NoEquilibrium => "there are positions without an equilibrium",
                Overall::NotConverged => "there are positions that could not be certified",
                Overall::Solved => "every position is in equilibrium",
            };
            let row = |moving: &groundbeam_report::Moving| {
                let count = moving.passage.solved().count();
                (moving.label(), format!("{count} positions: {}", moving.overall().name()))
            };
            (said.to_owned(), passages.all.iter().map(row).collect())
        }
    }
}

fn picture(
    input: &Input,
    found: &Found,
    scene: Scene,
    asked: &Asked,
    context: &Context,
) -> Option<Picture> {
    let width = asked.width.unwrap_or(960.0);
    let drawn = match found {
        Found::Equilibrium(solution) => svg::view(solution, context, width),
        Found::NoEquilibrium(model, existence) => svg::tipping(model, existence, context, width),
        Found::NotConverged(..) => return None,
        Found::Combinations(_) | Found::Trains(_) => {
            let svg = found.svg(context);
            return Some(Picture {
                svg,
                width: 960.0,
                height: 0.0,
                left: 0.0,
                scale: 0.0,
                handles: Vec::new(),
            });
        }
    };
    let held = |handle: &Handle| held(input, scene?, handle);
    Some(Picture {
        handles: drawn.handles.iter().filter_map(held).collect(),
        width: drawn.size[0],
        height: drawn.size[1],
        left: drawn.left,
        scale: drawn.scale,
        svg: drawn.svg,
    })
}

/// None where the text has no number of its own for the position, as for a train's axle.
fn held(input: &Input, scene: &Combination, handle: &Handle) -> Option<Held> {
    let document = &input.document;
    let (part, field, size, name) = match handle.grip {
        Grip::Load(i) | Grip::From(i) | Grip::To(i) => {
            let i = *scene.loads.get(i)?;
            let load = &document.model.loads[i];
            let size = match load {
                Load::PointForce { .. } | Load::GroundForce { .. } => "force",
                Load::PointMoment { .. } => "moment",
                _ => "start",
            };
            let kind = load_name(load);
            let (field, end) = match handle.grip {
                Grip::From(_) => ("from", ", its beginning"),
                Grip::To(_) => ("to", ", its end"),
                _ => ("at", ""),
            };
            (Part::Load(i), field, Some(size), format!("load {}: {kind}{end}", i + 1))
        }
        Grip::Hinge(i) => (Part::Hinge(i), "at", None, format!("hinge {}", i + 1)),
        Grip::Support(i) => (Part::Support(i), "at", None, format!("support {}", i + 1)),
    };
    let [x, y] = handle.place;
    Some(Held {
        name,
        x,
        y,
        at: handle.at,
        range: handle.range,
        position: Number::behind(document, part, field)?,
        size: size.and_then(|size| Number::behind(document, part, size)),
    })
}
