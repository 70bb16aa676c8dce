//! Answers, with HTTP headers that isolate the page.

use bytes::buf::Chain;
use bytes::{Buf as _, Bytes};
use http_body_util::Full;
use hyper::header::{CONTENT_TYPE, HeaderValue};
use hyper::{Response, StatusCode};
use polhode_web::RefusalKind;
use serde::Serialize;

/// A complete answer. Rows of numbers are chained to the bytes before them, without a copy.
pub(crate) type Answer = Response<Full<Chain<Bytes, Bytes>>>;

/// Refusal of a request, with its HTTP status.
#[derive(Debug)]
pub(crate) struct Refusal {
    pub(crate) status: StatusCode,
    pub(crate) message: String,
    pub(crate) hint: Option<String>,
}

impl Refusal {
    pub(crate) fn new(status: StatusCode, message: impl Into<String>) -> Self {
        Self { status, message: message.into(), hint: None }
    }

    pub(crate) fn hint(self, hint: impl Into<String>) -> Self {
        Self { hint: Some(hint.into()), ..self }
    }

    /// Refusal for a path that does not exist or may not be read. The answer does not say which.
    pub(crate) fn not_found() -> Self {
        Self::new(StatusCode::NOT_FOUND, "this address does not exist")
            .hint("open the address that polhode live printed")
    }
}

impl From<polhode_web::Refusal> for Refusal {
    fn from(refusal: polhode_web::Refusal) -> Self {
        let polhode_web::Refusal { kind, message, hint } = refusal;
        let status = match kind {
            RefusalKind::BadRequest => StatusCode::BAD_REQUEST,
            RefusalKind::NotFound => StatusCode::NOT_FOUND,
            RefusalKind::Unprocessable => StatusCode::UNPROCESSABLE_ENTITY,
            RefusalKind::Full => return Self::new(StatusCode::INSUFFICIENT_STORAGE, message).hint(RESTART),
            RefusalKind::Ended => StatusCode::REQUEST_TIMEOUT,
            _ => StatusCode::INTERNAL_SERVER_ERROR,
        };
        Self { status, message, hint }
    }
}

/// Hint for a session that is full.
pub(crate) const RESTART: &str = "stop polhode live and start it again";

/// Body of a refusal.
#[derive(Serialize)]
struct RefusalBody {
    message: String,
    hint: Option<String>,
}

/// Content security policy: the page may load and request only resources of this server.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; font-src data:; \
                      connect-src 'self'; worker-src blob:; media-src blob:; frame-ancestors 'none'; base-uri 'none'; form-action 'none'";

const HEADERS: [(&str, &str); 8] = [
    ("content-security-policy", POLICY),
    ("x-content-type-options", "nosniff"),
    ("x-frame-options", "DENY"),
    ("referrer-policy", "no-referrer"),
    ("cross-origin-resource-policy", "same-origin"),
    ("cross-origin-opener-policy", "same-origin"),
    ("permissions-policy", "camera=(), microphone=(), geolocation=()"),
    ("cache-control", "no-store"),
];

pub(crate) fn bytes(status: StatusCode, kind: &'static str, body: impl Into<Bytes>) -> Answer {
    parts(status, kind, body.into(), Bytes::new())
}

fn parts(status: StatusCode, kind: &'static str, head: Bytes, rows: Bytes) -> Answer {
    let mut answer = Response::new(Full::new(head.chain(rows)));
    *answer.status_mut() = status;
    let headers = answer.headers_mut();
    headers.insert(CONTENT_TYPE, HeaderValue::from_static(kind));
    for (name, value) in HEADERS {
        headers.insert(name, HeaderValue::from_static(value));
    }
    answer
}

pub(crate) fn json(value: &impl Serialize) -> Result<Answer, Refusal> {
    Ok(bytes(StatusCode::OK, "application/json", polhode_web::json(value)?))
}

/// Encodes JSON followed by rows of numbers, as [`polhode_web::json_before_rows`] describes.
pub(crate) fn json_and_rows(value: &impl Serialize, rows: Bytes) -> Result<Answer, Refusal> {
    let head = polhode_web::json_before_rows(value)?;
    Ok(parts(StatusCode::OK, "application/octet-stream", head.into(), rows))
}

pub(crate) fn refusal(Refusal { status, message, hint }: Refusal) -> Answer {
    let body = serde_json::to_vec(&RefusalBody { message, hint }).unwrap_or_default();
    bytes(status, "application/json", body)
}
