//! Converts replies of the crate `groundbeam_page` to HTTP responses.

use axum::http::StatusCode;
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};
use groundbeam_page::Reply;

/// Returns the HTTP response for a reply of the crate `groundbeam_page`.
pub fn sent(reply: impl Into<Reply>) -> Response {
    let Reply { status, kind, bytes } = reply.into();
    let status = StatusCode::from_u16(status).unwrap_or(StatusCode::INTERNAL_SERVER_ERROR);
    (status, [(CONTENT_TYPE, kind)], bytes).into_response()
}

/// Returns an HTTP error response with this message.
pub fn refusal(status: StatusCode, message: &str) -> Response {
    sent(Reply::refusal(status.as_u16(), message))
}
