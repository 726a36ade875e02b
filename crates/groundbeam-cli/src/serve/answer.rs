//! A model file comes in, an answer goes out.

use super::query::{Asked, Trains, WrongQuery};
use super::view::View;
use super::wrong::{document, refusal, wrong_model};
use crate::failure::Failure;
use crate::input::Input;
use crate::request::Solve;
use crate::solve::{answered, solved_one};
use axum::http::StatusCode;
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};
use groundbeam::{Error, Options, Outcome};
use groundbeam_file::Combination;
use groundbeam_report::{Context, Found, html};

/// What a model file without a name is called.
const NAME: &str = "model.toml";

/// The form of a file to keep.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    Svg,
    Png,
    Csv,
    Json,
    Text,
    Html,
}

impl Form {
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

/// The result document.
pub fn result(model: &[u8], asked: &Asked) -> Response {
    reply(found(model, asked, |_, found, context| {
        Ok(document(StatusCode::OK, found.json(None, context)))
    }))
}

/// A file to keep.
pub fn file(model: &[u8], asked: &Asked, form: Form) -> Response {
    reply(found(model, asked, |input, found, context| {
        if !found.has_fields() && matches!(form, Form::Svg | Form::Png | Form::Csv) {
            let words = "there is no equilibrium to draw or to list";
            return Ok(refusal(StatusCode::CONFLICT, words));
        }
        let bytes = match form {
            Form::Svg => found.svg(context).into_bytes(),
            Form::Png => found.png(context).map_err(|error| Failure::usage(error.to_string()))?,
            Form::Csv => found.csv(None, context).into_bytes(),
            Form::Json => found.json(None, context).into_bytes(),
            Form::Text => found.text(context, false).into_bytes(),
            Form::Html => html::report(&found.calculation(context, &input.source()), None)
                .map_err(|error| Failure::usage(error.to_string()))?
                .into_bytes(),
        };
        Ok(([(CONTENT_TYPE, form.kind())], bytes).into_response())
    }))
}

/// What the page shows.
pub fn view(model: &[u8], asked: &Asked) -> Response {
    let read = Input::of(model, NAME.to_owned(), None);
    reply(read.map_err(Refused::Model).and_then(|input| {
        let mut asked = asked.clone();
        if !input.document.trains.is_empty() && asked.first_axle.is_none() {
            // All positions take long: a page begins with one.
            asked.train = asked.train.or(Some(Trains::One(0)));
        }
        let view = seen(&input, &asked, |found, scene, context| {
            Ok(View::of(&input, found, scene, &asked, context))
        })?;
        Ok(document(StatusCode::OK, serde_json::to_string(&view).unwrap_or_default()))
    }))
}

/// Why a question has no answer.
enum Refused {
    Query(WrongQuery),
    Model(Failure),
}

impl From<Failure> for Refused {
    fn from(failure: Failure) -> Self {
        Refused::Model(failure)
    }
}

fn reply(answer: Result<Response, Refused>) -> Response {
    answer.unwrap_or_else(|refused| match refused {
        Refused::Query(wrong) => wrong.into_response(),
        Refused::Model(failure) => wrong_model(&failure),
    })
}

fn found(
    model: &[u8],
    asked: &Asked,
    deliver: impl FnOnce(&Input, &Found, &Context) -> Result<Response, Failure>,
) -> Result<Response, Refused> {
    let input = Input::of(model, NAME.to_owned(), None)?;
    seen(&input, asked, |found, _, context| deliver(&input, found, context))
}

/// One model of a file: a combination, perhaps with a train on it; none where several are seen together.
pub type Scene<'a> = Option<&'a Combination>;

/// Finds what is asked for: one model, or what the file makes of all.
fn seen<T>(
    input: &Input,
    asked: &Asked,
    deliver: impl FnOnce(&Found, Scene, &Context) -> Result<T, Failure>,
) -> Result<T, Refused> {
    let document = &input.document;
    asked.check(document).map_err(Refused::Query)?;
    let Some(Trains::One(train)) = asked.train else {
        let request = Solve::for_page(asked.combination.clone());
        let alone = match &asked.combination {
            Some(name) => document.combination(name).ok(),
            None => (!document.has_combinations()).then(|| document.as_written()),
        };
        let alone = alone.filter(|_| document.trains.is_empty());
        let deliver = |found: &Found, context: &Context| deliver(found, alone.as_ref(), context);
        return Ok(answered(input, &request, deliver)?);
    };
    let train = &document.trains[train];
    let mut alone = match &asked.combination {
        Some(name) => document
            .combination(name)
            .map_err(|found| Failure::diagnostics(&found, "combination", name))?,
        None => document.as_written(),
    };
    let first_axle = asked.first_axle.unwrap_or(0.5 * (train.range[0] + train.range[1]));
    alone.model = train.train.on(&alone.model, first_axle);
    let context = input.context();
    let outcome = solved_one(input, &alone, &Options::default());
    let given = match outcome {
        Ok((Outcome::Equilibrium(solution), ground)) => {
            let context = Context { ground, ..context };
            deliver(&Found::Equilibrium(&solution), Some(&alone), &context)
        }
        Ok((Outcome::NoEquilibrium(existence), _)) => {
            deliver(&Found::NoEquilibrium(&alone.model, &existence), Some(&alone), &context)
        }
        Err(Error::NotConverged(reached)) => {
            deliver(&Found::NotConverged(&alone.model, &reached), Some(&alone), &context)
        }
        Err(error) => Err(input.refused(&error)),
    };
    Ok(given?)
}
