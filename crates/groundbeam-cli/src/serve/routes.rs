//! The addresses of the page, and what is answered there.

use super::Start;
use super::answer::{Asked, Form, file, result, view};
use super::assets::{ASSETS, examples};
use super::guard::guard;
use super::wrong::{document, refusal};
use axum::Router;
use axum::body::Bytes;
use axum::extract::rejection::BytesRejection;
use axum::extract::{DefaultBodyLimit, Path, Query, State};
use axum::http::StatusCode;
use axum::http::header::CONTENT_TYPE;
use axum::middleware::from_fn_with_state;
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use serde_json::json;
use std::sync::Arc;
use tokio::sync::Semaphore;

/// A longer model file nobody has written \[bytes\].
pub const LONGEST: usize = 4 << 20;

/// What all answers share: no more of them are worked on at a time than there are processors.
#[derive(Clone)]
struct Desk {
    start: Option<Arc<Start>>,
    seats: Arc<Semaphore>,
}

/// All addresses, behind the guard.
pub fn all(start: Option<Start>, port: u16) -> Router {
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    let desk = Desk { start: start.map(Arc::new), seats: Arc::new(Semaphore::new(processors)) };
    let mut router = Router::new()
        .route("/api/start", get(begin))
        .route("/api/solve", post(solve))
        .route("/api/view", post(look))
        .route("/api/file/{form}", post(download));
    for asset in &ASSETS {
        let answer = || async { ([(CONTENT_TYPE, asset.kind)], asset.bytes) };
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
async fn begin(State(desk): State<Desk>) -> Response {
    let start = desk.start.as_ref().map(|s| json!({ "name": s.name, "text": s.text }));
    let examples: Vec<_> =
        examples().map(|(name, text)| json!({ "name": name, "text": text })).collect();
    let text = json!({ "start": start, "examples": examples }).to_string();
    document(StatusCode::OK, text)
}

type Body = Result<Bytes, BytesRejection>;

async fn solve(State(desk): State<Desk>, Query(asked): Query<Asked>, body: Body) -> Response {
    desk.answer(body, move |model| result(model, &asked)).await
}

async fn look(State(desk): State<Desk>, Query(asked): Query<Asked>, body: Body) -> Response {
    desk.answer(body, move |model| view(model, &asked)).await
}

async fn download(
    State(desk): State<Desk>,
    Path(form): Path<String>,
    Query(asked): Query<Asked>,
    body: Body,
) -> Response {
    let Some(form) = Form::named(&form) else {
        return refusal(StatusCode::NOT_FOUND, "a file is svg, png, csv, json, txt or html");
    };
    desk.answer(body, move |model| file(model, &asked, form)).await
}

impl Desk {
    /// Works on a model away from the threads that listen.
    async fn answer(
        &self,
        body: Body,
        work: impl FnOnce(&[u8]) -> Response + Send + 'static,
    ) -> Response {
        let model = match body {
            Ok(model) => model,
            Err(rejection) => return refusal(rejection.status(), &rejection.body_text()),
        };
        let Ok(_seat) = self.seats.acquire().await else {
            return StatusCode::SERVICE_UNAVAILABLE.into_response();
        };
        let done = tokio::task::spawn_blocking(move || work(&model)).await;
        done.unwrap_or_else(|_| {
            refusal(
                StatusCode::INTERNAL_SERVER_ERROR,
                "this model broke the program: a fault of it",
            )
        })
    }
}
