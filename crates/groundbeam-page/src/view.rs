//! Collects the view of a model for the page: verdict, picture with handles, and all numbers of the model file.

use crate::question::Asked;
use crate::written::Number;
use groundbeam::model::Part;
use groundbeam::model::{Action, Extent};
use groundbeam_file::{Combination, Document, UnitSystem};
use groundbeam_report::svg::{self, Grip, Handle};
use groundbeam_report::{Kind, Results, load_name, sentence, text};
use groundbeam_run::{Answer, Found, Overall, Passage};
use serde::Serialize;

/// All data that the page shows for a model.
#[derive(Debug, Serialize)]
pub struct View {
    status: &'static str,
    /// Verdict on the equilibrium, as a sentence.
    sentence: String,
    title: Option<String>,
    /// Rows beside the picture, each with a label and a text.
    rows: Vec<(String, String)>,
    picture: Option<Picture>,
    /// Result document as JSON, without the values at stations.
    document: String,
    /// The whole report as text.
    report: String,
    numbers: Vec<Number>,
    combinations: Vec<String>,
    trains: Vec<Train>,
    length: f64,
    /// Whether the file has units.
    has_units: bool,
    /// Unit of the positions that the page shows.
    shown_in: Shown,
    /// Unit of the forces that the page writes into the file.
    force: &'static str,
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

/// A handle of the picture, which the user drags to change numbers of the model file. The fields `position` and `size`
/// are the indices of these numbers.
#[derive(Debug, Serialize)]
struct Held {
    name: String,
    x: f64,
    y: f64,
    at: f64,
    /// Smallest and largest position to which the user can drag the handle.
    range: [f64; 2],
    /// Index of the number that gives the position of the handle. The index refers to the list of all numbers of the
    /// model file.
    position: usize,
    /// Index of the number that gives the magnitude of the load; `None` if the handle changes no magnitude. The index
    /// refers to the list of all numbers of the model file.
    size: Option<usize>,
}

/// A unit of length with its name and its size in metres.
#[derive(Debug, Serialize)]
struct Shown {
    name: &'static str,
    size: f64,
}

#[derive(Debug, Serialize)]
struct Train {
    name: String,
    from: f64,
    to: f64,
}

impl View {
    pub fn of(document: &Document, results: &Results, asked: &Asked) -> View {
        let trains = document.trains.iter().map(|train| Train {
            name: train.name.clone(),
            from: train.range[0],
            to: train.range[1],
        });
        let (sentence, rows) = said(results);
        let length = document.model.beam.length;
        let shown = results.context().units.unit(Kind::Position, length);
        View {
            status: results.answers().overall().name(),
            sentence,
            title: document.title.clone(),
            rows,
            picture: picture(document, results, asked),
            document: results.json(Some(&[])),
            report: results.text(false),
            numbers: Number::all(document),
            combinations: document.combination_names(),
            trains: trains.collect(),
            length,
            has_units: document.units == UnitSystem::Si,
            shown_in: Shown { name: shown.name, size: shown.size },
            force: document.printed.unit(Kind::Force, 0.0).name,
        }
    }
}

/// Returns the verdict as a sentence, and the rows of the table beside the picture, each with a label and a text.
fn said(results: &Results) -> (String, Vec<(String, String)>) {
    let (answers, context) = (results.answers(), results.context());
    if let Some(one) = results.one() {
        return match &one.found {
            Found::Equilibrium(solution) => {
                let said = sentence(solution.model(), solution.existence(), context.units);
                (said, text::summary(solution, context))
            }
            Found::Exists(existence) | Found::NoEquilibrium(existence) => {
                let model = one.label.model();
                let rows = text::failing(&model, existence, context);
                (sentence(&model, existence, context.units), rows)
            }
            Found::NotConverged(reached) => (reached.to_string(), Vec::new()),
            Found::Unsolved(error) => (error.to_string(), Vec::new()),
        };
    }
    let passages = answers.passages();
    if !passages.all.is_empty() {
        let said = match passages.overall() {
            Overall::NoEquilibrium => "at some train positions there is no equilibrium",
            Overall::NotConverged => "the result at some train positions could not be certified",
            Overall::Solved => "the beam is in equilibrium at every train position",
        };
        let row = |passage: &Passage| {
            let count = passage.solved().count();
            (passage.label(), format!("{count} positions: {}", passage.overall().name()))
        };
        let rows = results.check_rows().into_iter().chain(passages.all.iter().map(row));
        return (said.to_owned(), rows.collect());
    }
    let said = match answers.overall() {
        Overall::Solved => "each combination has an equilibrium",
        Overall::NoEquilibrium => "at least one combination has no equilibrium",
        Overall::NotConverged => "at least one result could not be certified",
    };
    let said = format!("{} combinations: {said}", answers.list.len());
    let row = |answer: &Answer| {
        let words = match answer.existence() {
            Some(existence) => sentence(answer.model(), existence, context.units),
            None => "no answer could be certified".to_owned(),
        };
        (answer.name().to_owned(), words)
    };
    let rows = results.check_rows().into_iter().chain(answers.list.iter().map(row));
    (said, rows.collect())
}

fn picture(document: &Document, results: &Results, asked: &Asked) -> Option<Picture> {
    let (width, context) = (asked.width.unwrap_or(960.0), results.context());
    let Some(one) = results.one() else {
        return Some(Picture {
            svg: results.picture()?.to_string(),
            width: 960.0,
            height: 0.0,
            left: 0.0,
            scale: 0.0,
            handles: Vec::new(),
        });
    };
    let drawn = match &one.found {
        Found::Equilibrium(solution) => svg::view(solution, context, width),
        Found::NoEquilibrium(existence) => {
            svg::tipping(&one.label.model(), existence, context, width)
        }
        Found::Exists(_) | Found::NotConverged(_) | Found::Unsolved(_) => return None,
    };
    let held = |handle: &Handle| held(document, &one.label.combination, handle);
    Some(Picture {
        handles: drawn.handles.iter().filter_map(held).collect(),
        width: drawn.size[0],
        height: drawn.size[1],
        left: drawn.left,
        scale: drawn.scale,
        svg: drawn.svg,
    })
}

/// Returns the handle with the numbers that it changes; `None` if no number gives its position, as for the self-weight.
fn held(document: &Document, combination: &Combination, handle: &Handle) -> Option<Held> {
    let (part, field, size, name) = match handle.grip {
        Grip::Load(i) | Grip::From(i) | Grip::To(i) => {
            let i = *combination.loads.get(i)?;
            let load = &document.model.loads[i];
            let size = match (load.extent(), load.action()) {
                (Extent::Distributed { .. }, _) => "start",
                (_, Action::Moment) => "moment",
                _ => "force",
            };
            let kind = load_name(load);
            let (field, end) = match handle.grip {
                Grip::From(_) => ("from", ", its start"),
                Grip::To(_) => ("to", ", its end"),
                _ => ("at", ""),
            };
            (Part::Load(i), field, Some(size), format!("load {}: {kind}{end}", i + 1))
        }
        Grip::Hinge(i) => (Part::Hinge(i), "at", None, format!("hinge {}", i + 1)),
        Grip::Support(i) => (Part::Support(i), "at", None, format!("support {}", i + 1)),
    };
    // A position without a number in the file gets no handle. For example, the ends of the self-weight follow from the
    // length of the beam.
    let position = Number::behind(document, part, field)?;
    document.quantities[position].place?;
    let [x, y] = handle.place;
    Some(Held {
        name,
        x,
        y,
        at: handle.at,
        range: handle.range,
        position,
        size: size.and_then(|size| Number::behind(document, part, size)),
    })
}
