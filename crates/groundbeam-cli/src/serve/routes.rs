//! Defines the routes of the server and computes the responses.

use super::Start;
use super::assets::{Asset, assets, examples};
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
use groundbeam::Cancel;
use groundbeam_file::print;
use groundbeam_page::{
    Asked, FILE, Form, REPORT, Reply, SOLVE, VIEW, WrongQuery, file, result, view,
};
use serde_json::json;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::Semaphore;

/// Maximum size of a model file \[bytes\].
pub const LONGEST: usize = 4 << 20;

/// Time limit for the arrival of a model file.
pub const BODY: Duration = Duration::from_secs(30);

/// State that the responses to all requests share.
#[derive(Clone)]
struct Desk {
    start: Arc<Start>,
    /// Permits for the solves of requested results and files, one per processor. They limit the number of simultaneous
    /// solves.
    permits: Arc<Semaphore>,
    /// Permits for the solves that update the page after a keystroke, one per processor. They are separate from
    /// `permits`, so that an update does not wait for a long solve.
    quick: Arc<Semaphore>,
    /// Time limit for the arrival of a model file.
    body: Duration,
}

/// Returns the router of all routes. The function [`guard`] checks each request.
pub fn all(start: Start, port: u16, body: Duration) -> Router {
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    let [permits, quick] = [0, 1].map(|_| Arc::new(Semaphore::new(processors)));
    let desk = Desk { start: Arc::new(start), permits, quick, body };
    let mut router = Router::new()
        .route("/api/start", get(begin))
        .route("/api/solve", post(solve))
        .route("/api/view", post(look))
        .route("/api/file/{form}", post(download));
    for Asset { path, kind, bytes } in assets() {
        let answer = move |pairs: Pairs| async move {
            pairs.read(&[]).map(|_| ([(CONTENT_TYPE, kind)], bytes)).map_err(sent)
        };
        router = router.route(path, get(answer));
    }
    router
        .fallback(|| async { refusal(StatusCode::NOT_FOUND, "this address does not exist") })
        .method_not_allowed_fallback(|| async {
            refusal(
                StatusCode::METHOD_NOT_ALLOWED,
                "this address does not accept the HTTP method of the request",
            )
        })
        .layer(DefaultBodyLimit::max(LONGEST))
        .layer(from_fn_with_state(port, guard))
        .with_state(desk)
}

/// Returns the initial model and the example models, and the units and number of digits in which the page shows
/// results.
async fn begin(State(desk): State<Desk>, pairs: Pairs) -> Result<Response, Response> {
    pairs.read(&[]).map_err(sent)?;
    let Start { model, printed } = &*desk.start;
    let model = model.as_ref().map(|model| json!({ "name": model.name, "text": model.text }));
    let units = match printed.units {
        print::Asked::File => None,
        print::Asked::Si => Some("si"),
        print::Asked::Us => Some("us"),
    };
    let digits = Some(printed.digits).filter(|&digits| digits != print::RESULT_DIGITS);
    let examples: Vec<_> =
        examples().map(|(name, text)| json!({ "name": name, "text": text })).collect();
    let begin = json!({ "start": model, "examples": examples, "units": units, "digits": digits });
    let text = begin.to_string();
    Ok(sent(Reply::document(200, text)))
}

async fn solve(State(desk): State<Desk>, pairs: Pairs, model: Model) -> Response {
    let work = |model: &[u8], asked: &Asked| result(model, asked, &host());
    answer(&desk.permits, pairs.read(SOLVE), model, work).await
}

async fn look(State(desk): State<Desk>, pairs: Pairs, model: Model) -> Response {
    let work = |model: &[u8], asked: &Asked| view(model, asked, &host());
    answer(&desk.quick, pairs.read(VIEW), model, work).await
}

async fn download(
    State(desk): State<Desk>,
    form: Result<Path<String>, PathRejection>,
    pairs: Pairs,
    model: Model,
) -> Response {
    let Some(form) = form.ok().and_then(|Path(form)| Form::named(&form)) else {
        return refusal(
            StatusCode::NOT_FOUND,
            "the address must end in svg, png, csv, json, txt or html",
        );
    };
    // A report covers all positions of a train, so its query has no keys for a single position.
    let keys = if form == Form::Html { REPORT } else { FILE };
    let work = move |model: &[u8], asked: &Asked| file(model, asked, form, &host());
    answer(&desk.permits, pairs.read(keys), model, work).await
}

/// Returns the executor of a request. It uses all processors and shows no progress, because the page in the browser
/// shows the progress.
fn host() -> Threads<'static> {
    Threads::new(&|| ())
}

/// Keys and values of a query, in the order of the query.
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

/// Cancels the work of a request when this value is dropped. This happens after the response, or when the client
/// disconnects.
struct Client(Cancel);

impl Drop for Client {
    fn drop(&mut self) {
        self.0.cancel();
    }
}

/// Runs the work of a request on a separate thread. The work is cancelled if the client disconnects. The permit for
/// the work is released when the work ends.
async fn answer(
    permits: &Arc<Semaphore>,
    asked: Result<Asked, WrongQuery>,
    Model(model): Model,
    work: impl FnOnce(&[u8], &Asked) -> Reply + Send + 'static,
) -> Response {
    let mut asked = match asked {
        Ok(asked) => asked,
        Err(wrong) => return sent(wrong),
    };
    asked.cancel = Cancel::new();
    let client = Client(asked.cancel.clone());
    let Ok(permit) = Arc::clone(permits).acquire_owned().await else {
        return refusal(StatusCode::SERVICE_UNAVAILABLE, "the program is shutting down");
    };
    let done = tokio::task::spawn_blocking(move || {
        let answer = sent(work(&model, &asked));
        drop(permit);
        answer
    });
    let answer = done.await;
    drop(client);
    answer.unwrap_or_else(|_| {
        let message = "the program failed on this model because of a bug in the program";
        refusal(StatusCode::INTERNAL_SERVER_ERROR, message)
    })
}

#[cfg(test)]
mod tests {
    use super::super::connection::{LIMITS, accept};
    use super::*;
    use std::io::{Read, Write};
    use std::net::{Ipv4Addr, SocketAddr, TcpStream};
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::time::Instant;
    use tokio::runtime::Runtime;

    /// Counts of the requests to `/slow` whose work has started, and of those whose work has ended.
    #[derive(Default)]
    struct Works {
        begun: AtomicUsize,
        ended: AtomicUsize,
    }

    impl Works {
        /// Runs until the request is cancelled, and for 50 ms afterwards.
        fn slow(&self, asked: &Asked) -> Reply {
            self.begun.fetch_add(1, Ordering::SeqCst);
            while !asked.cancel.is_cancelled() {
                std::thread::sleep(Duration::from_millis(1));
            }
            std::thread::sleep(Duration::from_millis(50));
            self.ended.fetch_add(1, Ordering::SeqCst);
            Reply::refusal(409, "cancelled")
        }

        #[track_caller]
        fn wait(&self, count: impl Fn(&Self) -> &AtomicUsize, wanted: usize) {
            let start = Instant::now();
            while count(self).load(Ordering::SeqCst) < wanted {
                assert!(start.elapsed() < Duration::from_secs(60), "no work began or ended");
                std::thread::sleep(Duration::from_millis(1));
            }
        }
    }

    /// Starts a server with the routes of the page and with the route `/slow`. The work of `/slow` needs one permit and
    /// ends only when it is cancelled.
    fn server(works: &Arc<Works>) -> (Runtime, SocketAddr, Arc<Semaphore>) {
        let runtime = tokio::runtime::Builder::new_multi_thread()
            .worker_threads(2)
            .enable_all()
            .build()
            .unwrap();
        let listener = (Ipv4Addr::LOCALHOST, 0);
        let listener = runtime.block_on(tokio::net::TcpListener::bind(listener)).unwrap();
        let address = listener.local_addr().unwrap();
        let permits = Arc::new(Semaphore::new(1));
        let desk = Desk {
            start: Arc::new(Start::empty()),
            permits: Arc::clone(&permits),
            quick: Arc::new(Semaphore::new(1)),
            body: BODY,
        };
        let works = Arc::clone(works);
        let slow = move |State(desk): State<Desk>, pairs: Pairs, model: Model| async move {
            let work = move |_: &[u8], asked: &Asked| works.slow(asked);
            answer(&desk.permits, pairs.read(&[]), model, work).await
        };
        let router = Router::new()
            .route("/slow", post(slow))
            .route("/api/solve", post(solve))
            .route("/api/view", post(look))
            .with_state(desk);
        runtime.spawn(accept(listener, router, LIMITS));
        (runtime, address, permits)
    }

    /// Sends a model to the server in a POST request with this path.
    fn ask(address: SocketAddr, path: &str) -> TcpStream {
        let model = "[beam]\nlength = \"1 m\"\nEI = \"1 N m^2\"\n[foundation]\nk = \"1 N/m^2\"\n\
            [[load]]\npoint = \"1 N\"\nat = \"0.5 m\"\n";
        let mut stream = TcpStream::connect(address).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        let length = model.len();
        let head = format!("POST {path} HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n");
        let request = format!("{head}Content-Length: {length}\r\n\r\n{model}");
        stream.write_all(request.as_bytes()).unwrap();
        stream
    }

    fn reply(mut stream: TcpStream) -> String {
        let mut text = String::new();
        stream.read_to_string(&mut text).expect("the server closes the connection");
        text
    }

    #[test]
    fn a_closed_connection_cancels_its_request() {
        let works = Arc::new(Works::default());
        let (_runtime, address, permits) = server(&works);
        let aborted = ask(address, "/slow");
        works.wait(|works| &works.begun, 1);
        let waiting = ask(address, "/api/solve");
        assert_eq!((permits.available_permits(), works.ended.load(Ordering::SeqCst)), (0, 0));
        drop(aborted);
        // The server answers this request only after the slow request has released the single permit, that is, after
        // the slow work has ended.
        let reply = reply(waiting);
        assert!(reply.starts_with("HTTP/1.1 200 OK"), "{reply}");
        assert_eq!(works.ended.load(Ordering::SeqCst), 1);
    }

    #[test]
    fn a_request_cancelled_while_queued_is_not_started() {
        let works = Arc::new(Works::default());
        let (_runtime, address, permits) = server(&works);
        let first = ask(address, "/slow");
        works.wait(|works| &works.begun, 1);
        drop(ask(address, "/slow"));
        std::thread::sleep(Duration::from_millis(200));
        drop(first);
        works.wait(|works| &works.ended, 1);
        let reply = reply(ask(address, "/api/solve"));
        assert!(reply.starts_with("HTTP/1.1 200 OK"), "{reply}");
        assert_eq!(works.begun.load(Ordering::SeqCst), 1);
        assert_eq!(permits.available_permits(), 1);
    }

    #[test]
    fn a_view_does_not_wait_for_a_slow_solve() {
        let works = Arc::new(Works::default());
        let (_runtime, address, permits) = server(&works);
        let slow = ask(address, "/slow");
        works.wait(|works| &works.begun, 1);
        let reply = reply(ask(address, "/api/view"));
        assert!(reply.starts_with("HTTP/1.1 200 OK"), "{reply}");
        assert_eq!(permits.available_permits(), 0);
        drop(slow);
    }
}
