//! The addresses of the page, and what is answered there.

use super::Start;
use super::assets::{ASSETS, examples};
use super::guard::guard;
use super::reply::{refusal, sent};
use crate::host::Threads;
use axum::Router;
use axum::body::Bytes;
use axum::extract::rejection::PathRejection;
use axum::extract::{
    DefaultBodyLimit, FromRef, FromRequest, FromRequestParts, Path, Query, Request, State,
};
use axum::http::StatusCode;
use axum::http::header::CONTENT_TYPE;
use axum::http::request::Parts;
use axum::middleware::from_fn_with_state;
use axum::response::Response;
use axum::routing::{get, post};
use groundbeam_page::{Asked, Form, REPORT, Reply, SOLVE, VIEW, WrongQuery, file, result, view};
use serde_json::json;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::Semaphore;

/// A longer model file nobody has written \[bytes\].
pub const LONGEST: usize = 4 << 20;

/// The time within which a model file must arrive.
pub const BODY: Duration = Duration::from_secs(30);

/// What all answers share.
#[derive(Clone)]
struct Desk {
    start: Option<Arc<Start>>,
    /// One permit for every processor: no more models are worked on at a time.
    permits: Arc<Semaphore>,
    /// The time within which a model file must arrive.
    body: Duration,
}

/// All addresses, behind the guard.
pub fn all(start: Option<Start>, port: u16, body: Duration) -> Router {
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    let permits = Arc::new(Semaphore::new(processors));
    let desk = Desk { start: start.map(Arc::new), permits, body };
    let mut router = Router::new()
        .route("/api/start", get(begin))
        .route("/api/solve", post(solve))
        .route("/api/view", post(look))
        .route("/api/file/{form}", post(download));
    for asset in &ASSETS {
        let answer = move |pairs: Pairs| async move {
            pairs.read(&[]).map(|_| ([(CONTENT_TYPE, asset.kind)], asset.bytes)).map_err(sent)
        };
        router = router.route(asset.path, get(answer));
    }
    router
        .fallback(|| async { refusal(StatusCode::NOT_FOUND, "nothing is here") })
        .method_not_allowed_fallback(|| async {
            refusal(StatusCode::METHOD_NOT_ALLOWED, "this is asked in another way")
        })
        .layer(DefaultBodyLimit::max(LONGEST))
        .layer(from_fn_with_state(port, guard))
        .with_state(desk)
}

/// The model to begin with, and the examples.
async fn begin(State(desk): State<Desk>, pairs: Pairs) -> Result<Response, Response> {
    pairs.read(&[]).map_err(sent)?;
    let start = desk.start.as_ref().map(|s| json!({ "name": s.name, "text": s.text }));
    let examples: Vec<_> =
        examples().map(|(name, text)| json!({ "name": name, "text": text })).collect();
    let text = json!({ "start": start, "examples": examples }).to_string();
    Ok(sent(Reply::document(200, text)))
}

async fn solve(State(desk): State<Desk>, pairs: Pairs, model: Model) -> Response {
    desk.answer(pairs.read(SOLVE), model, |model, asked| result(model, asked, &host())).await
}

async fn look(State(desk): State<Desk>, pairs: Pairs, model: Model) -> Response {
    desk.answer(pairs.read(VIEW), model, |model, asked| view(model, asked, &host())).await
}

async fn download(
    State(desk): State<Desk>,
    form: Result<Path<String>, PathRejection>,
    pairs: Pairs,
    model: Model,
) -> Response {
    let Some(form) = form.ok().and_then(|Path(form)| Form::named(&form)) else {
        return refusal(StatusCode::NOT_FOUND, "a file is svg, png, csv, json, txt or html");
    };
    // A report is about a whole file, in which no train stands at one position.
    let keys = if form == Form::Html { REPORT } else { SOLVE };
    desk.answer(pairs.read(keys), model, move |model, asked| file(model, asked, form, &host()))
        .await
}

/// All processors, without a display of progress: the page shows that it waits.
fn host() -> Threads<'static> {
    Threads::new(&|| ())
}

/// The keys and values of a query in their order.
struct Pairs(Vec<(String, String)>);

impl<S: Send + Sync> FromRequestParts<S> for Pairs {
    type Rejection = Response;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, Response> {
        match Query::from_request_parts(parts, state).await {
            Ok(Query(pairs)) => Ok(Pairs(pairs)),
            Err(rejection) => Err(refusal(rejection.status(), &rejection.body_text())),
        }
    }
}

impl Pairs {
    fn read(&self, keys: &[&str]) -> Result<Asked, WrongQuery> {
        Asked::read(&self.0, keys)
    }
}

/// The model file in the body of a request.
struct Model(Bytes);

impl<S: Send + Sync> FromRequest<S> for Model
where
    Desk: FromRef<S>,
{
    type Rejection = Response;

    async fn from_request(request: Request, state: &S) -> Result<Self, Response> {
        let limit = Desk::from_ref(state).body;
        match tokio::time::timeout(limit, Bytes::from_request(request, state)).await {
            Ok(Ok(model)) => Ok(Model(model)),
            Ok(Err(rejection)) => Err(refusal(rejection.status(), &rejection.body_text())),
            Err(_) => {
                let message = format!("the model file did not arrive within {limit:?}");
                Err(refusal(StatusCode::REQUEST_TIMEOUT, &message))
            }
        }
    }
}

impl Desk {
    /// Works on a model away from the threads that listen.
    async fn answer(
        &self,
        asked: Result<Asked, WrongQuery>,
        Model(model): Model,
        work: impl FnOnce(&[u8], &Asked) -> Reply + Send + 'static,
    ) -> Response {
        let asked = match asked {
            Ok(asked) => asked,
            Err(wrong) => return sent(wrong),
        };
        let Ok(permit) = Arc::clone(&self.permits).acquire_owned().await else {
            return refusal(StatusCode::SERVICE_UNAVAILABLE, "the program ends");
        };
        let done = tokio::task::spawn_blocking(move || {
            let answer = sent(work(&model, &asked));
            // Work goes on where a browser aborts the request, and keeps the permit for that long.
            drop(permit);
            answer
        });
        done.await.unwrap_or_else(|_| {
            let message = "the program broke down on this model: this is a fault of the program";
            refusal(StatusCode::INTERNAL_SERVER_ERROR, message)
        })
    }
}
