//! Restricts access to the server to programs on this machine and to the server's own page.
//!
//! The header `Origin` names the server of the requesting page. The header `Host` has a foreign name after DNS
//! rebinding.

use super::reply::refusal;
use super::routes::LONGEST;
use axum::extract::{Request, State};
use axum::http::header::{
    CACHE_CONTROL, CONTENT_LENGTH, CONTENT_SECURITY_POLICY, CONTENT_TYPE, HOST, HeaderName, ORIGIN,
    REFERRER_POLICY, X_CONTENT_TYPE_OPTIONS,
};
use axum::http::{HeaderValue, Method, StatusCode};
use axum::middleware::Next;
use axum::response::Response;

/// Content security policy. The page loads only files of this server, and other pages must not embed the page.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; font-src 'self'; \
    connect-src 'self'; img-src 'self' data: blob:; base-uri 'none'; form-action 'none'; \
    frame-ancestors 'none'";

/// Accepted content types of a model file. Clients use the last two types for bytes of unknown type.
const TYPES: [&str; 4] = [
    "application/toml",
    "text/plain",
    "application/octet-stream",
    "application/x-www-form-urlencoded",
];

/// Accepts a request if it is addressed to this machine and was not sent by a page of another server.
pub async fn guard(State(port): State<u16>, request: Request, next: Next) -> Response {
    let mut response = match fault(&request, port) {
        Some((status, message)) => refusal(status, &message),
        None => next.run(request).await,
    };
    let headers = response.headers_mut();
    for (name, value) in [
        (CONTENT_SECURITY_POLICY, POLICY),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (REFERRER_POLICY, "no-referrer"),
        (CACHE_CONTROL, "no-store"),
        (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    response
}

fn fault(request: &Request, port: u16) -> Option<(StatusCode, String)> {
    let header = |name| request.headers().get(name).and_then(|value| value.to_str().ok());
    let names = [format!("127.0.0.1:{port}"), format!("localhost:{port}")];
    let is_here = |host: &str| names.iter().any(|name| name.eq_ignore_ascii_case(host));
    let host = request.uri().authority().map(|a| a.as_str()).or(header(HOST)).unwrap_or_default();
    // The request line may also name a host, and a header may be repeated, so all values are checked.
    let all = |name| request.headers().get_all(name).iter().map(|v| v.to_str().unwrap_or_default());
    let foreign = all(HOST).find(|host| !is_here(host));
    if let Some(host) = foreign.or((!is_here(host)).then_some(host)) {
        let message = format!("this is {}, not `{host}`", names[0]);
        return Some((StatusCode::MISDIRECTED_REQUEST, message));
    }
    let is_own = |origin: &str| origin.strip_prefix("http://").is_some_and(is_here);
    if let Some(origin) = all(ORIGIN).find(|origin| !is_own(origin)) {
        let message = format!("requests from pages of `{origin}` are not allowed");
        return Some((StatusCode::FORBIDDEN, message));
    }
    // If the announced length of the body is too large, the request is refused before the body arrives.
    let announced = header(CONTENT_LENGTH).and_then(|length| length.parse::<u64>().ok());
    if announced.is_some_and(|length| length > LONGEST as u64) {
        let message = format!("a model file must have at most {LONGEST} bytes");
        return Some((StatusCode::PAYLOAD_TOO_LARGE, message));
    }
    let sent = header(CONTENT_TYPE).map(|value| value.split(';').next().unwrap_or_default().trim());
    if request.method() == Method::POST
        && let Some(sent) = sent
        && !TYPES.iter().any(|known| known.eq_ignore_ascii_case(sent))
    {
        let message = format!("send a model file as application/toml, not as `{sent}`");
        return Some((StatusCode::UNSUPPORTED_MEDIA_TYPE, message));
    }
    None
}
