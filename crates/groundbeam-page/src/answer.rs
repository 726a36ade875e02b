//! Computes the responses to a model file: the view, the result document, and downloaded files.

use crate::question::{Asked, Trains, WrongQuery};
use crate::reply::{Reply, WrongModel};
use crate::view::View;
use groundbeam::Options;
use groundbeam_file::Document;
use groundbeam_report::calculation::Source;
use groundbeam_report::{Context, Results, html, model_digest};
use groundbeam_run::{Failed, Host, Run};
use std::convert::Infallible;
use std::fmt::Display;

/// Default file name of a model.
const NAME: &str = "model.toml";

/// The format of a downloaded file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// The picture as SVG.
    Svg,
    /// The picture as PNG.
    Png,
    /// The table of fields as CSV.
    Csv,
    /// The result document as JSON.
    Json,
    /// The report as text.
    Text,
    /// The calculation report as HTML.
    Html,
}

impl Form {
    /// Returns the format that belongs to this extension of a file name.
    pub fn named(name: &str) -> Option<Self> {
        let all = [
            ("svg", Form::Svg),
            ("png", Form::Png),
            ("csv", Form::Csv),
            ("json", Form::Json),
            ("txt", Form::Text),
            ("html", Form::Html),
        ];
        all.into_iter().find(|(known, _)| *known == name).map(|(_, form)| form)
    }

    fn kind(self) -> &'static str {
        match self {
            Form::Svg => "image/svg+xml",
            Form::Png => "image/png",
            Form::Csv => "text/csv; charset=utf-8",
            Form::Json => "application/json",
            Form::Text => "text/plain; charset=utf-8",
            Form::Html => "text/html; charset=utf-8",
        }
    }
}

/// Returns the result document of a model.
pub fn result(model: &[u8], asked: &Asked, host: &impl Host<Stop = Infallible>) -> Reply {
    reply(found(model, asked, host, |_, results| Ok(Reply::document(200, results.json(None)))))
}

/// Returns results of a model as a file in the format `form`.
pub fn file(model: &[u8], asked: &Asked, form: Form, host: &impl Host<Stop = Infallible>) -> Reply {
    reply(found(model, asked, host, |read, results| {
        if !results.has_fields() && matches!(form, Form::Svg | Form::Png | Form::Csv) {
            return Ok(Reply::refusal(
                409,
                "there is no equilibrium, so there is nothing to draw or to list",
            ));
        }
        let bytes = match form {
            Form::Svg => {
                results.picture().map(|it| it.to_string()).unwrap_or_default().into_bytes()
            }
            Form::Png => {
                let pixels = results.picture().map(|it| it.png()).transpose();
                pixels.map_err(Refused::said)?.unwrap_or_default()
            }
            Form::Csv => results.csv(None).into_bytes(),
            Form::Json => results.json(None).into_bytes(),
            Form::Text => results.text(false).into_bytes(),
            Form::Html => {
                let source = Source::of(&read.document, NAME, &read.text);
                let report = html::report(&results.calculation(&source), None);
                report.map_err(Refused::said)?.into_bytes()
            }
        };
        Ok(Reply { status: 200, kind: form.kind(), bytes })
    }))
}

/// Returns the data that the page shows for a model.
pub fn view(model: &[u8], asked: &Asked, host: &impl Host<Stop = Infallible>) -> Reply {
    reply(Read::of(model).and_then(|read| {
        let mut asked = asked.clone();
        if !read.document.trains.is_empty() && asked.first_axle.is_none() {
            // Solving all positions of all trains takes a long time, so the page first shows one train.
            asked.train = asked.train.or(Some(Trains::One(0)));
        }
        seen(&read, &asked, host, |results| {
            let view = View::of(&read.document, results, &asked);
            Ok(Reply::document(200, serde_json::to_string(&view).unwrap_or_default()))
        })
    }))
}

/// Reason why a request is refused: an invalid query or a faulty model.
enum Refused {
    Query(WrongQuery),
    Model(WrongModel),
}

impl Refused {
    /// Returns the refusal for an error that has no location in the file.
    fn said(error: impl Display) -> Self {
        Refused::Model(WrongModel { message: error.to_string(), found: Vec::new() })
    }
}

fn reply(answer: Result<Reply, Refused>) -> Reply {
    answer.unwrap_or_else(|refused| match refused {
        Refused::Query(wrong) => wrong.into(),
        Refused::Model(wrong) => wrong.into(),
    })
}

/// Contents of a model file that has been read.
struct Read {
    document: Document,
    text: String,
}

impl Read {
    /// Reads a model file. References to other files are refused.
    fn of(bytes: &[u8]) -> Result<Self, Refused> {
        let text = groundbeam_file::text_of(bytes);
        let read = text.and_then(|text| Ok((groundbeam_file::parse(text)?, text.to_owned())));
        match read {
            Ok((document, text)) => Ok(Read { document, text }),
            Err(found) => Err(Refused::Model(found.into_iter().collect::<Vec<_>>().into())),
        }
    }
}

fn found(
    model: &[u8],
    asked: &Asked,
    host: &impl Host<Stop = Infallible>,
    deliver: impl FnOnce(&Read, &Results) -> Result<Reply, Refused>,
) -> Result<Reply, Refused> {
    let read = Read::of(model)?;
    seen(&read, asked, host, |results| deliver(&read, results))
}

/// Solves the requested part of the file: one model, or all models of the file.
fn seen(
    read: &Read,
    asked: &Asked,
    host: &impl Host<Stop = Infallible>,
    deliver: impl FnOnce(&Results) -> Result<Reply, Refused>,
) -> Result<Reply, Refused> {
    let document = &read.document;
    asked.check(document).map_err(Refused::Query)?;
    let combination = match &asked.combination {
        None => None,
        Some(name) => match document.combination(name) {
            Ok(combination) => Some(combination),
            Err(found) => {
                return Err(Refused::Model(found.into_iter().collect::<Vec<_>>().into()));
            }
        },
    };
    let mut title = document.title.clone();
    let run = match (asked.train, combination) {
        (Some(Trains::One(train)), combination) => {
            let train = &document.trains[train];
            let middle = 0.5 * (train.range[0] + train.range[1]);
            let combination = combination.unwrap_or_else(|| document.as_written());
            let first_axle = asked.first_axle.unwrap_or(middle);
            Run::at_position(document, combination, train, first_axle)
        }
        (_, Some(combination)) => {
            title = Some(document.title_of(&combination));
            Run::of_one(document, combination)
        }
        _ => Run::of(document),
    };
    let options = Options { cancel: asked.cancel.clone(), ..Options::default() };
    let run = run.with_options(options);
    let started = host.seconds();
    let answers = run.solve(host).map_err(Failed::refusal).map_err(|error| {
        match &document.diagnostics_for(&error)[..] {
            [] => Refused::said(error),
            found => Refused::Model(found.to_vec().into()),
        }
    })?;
    let seconds = Some(host.seconds() - started).filter(|seconds| seconds.is_finite());
    let digest = model_digest(document);
    let context = Context {
        title: title.as_deref(),
        seconds,
        digest: Some(&digest),
        units: asked.printed(document).unwrap_or(document.printed),
        selected: asked.combination.is_some(),
        ..Context::of(document)
    };
    deliver(&Results::new(&answers, context))
}
