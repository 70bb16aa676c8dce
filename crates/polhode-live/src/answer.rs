//! Answers, with HTTP headers that isolate the page.

use bytes::buf::Chain;
use bytes::{Buf as _, Bytes};
use http_body_util::Full;
use hyper::header::{CONTENT_TYPE, HeaderValue};
use hyper::{Response, StatusCode};
use serde::Serialize;

use crate::protocol::RefusalBody;

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
    Ok(bytes(StatusCode::OK, "application/json", written(value)?))
}

/// Encodes JSON followed by rows of numbers: the length of the JSON as a u64, the JSON padded with
/// spaces to a multiple of eight bytes, and the rows. Everything is little-endian and aligned, so
/// that the page reads the numbers in place.
pub(crate) fn json_and_rows(value: &impl Serialize, rows: Bytes) -> Result<Answer, Refusal> {
    const WORD: usize = size_of::<u64>();
    let mut json = written(value)?;
    json.resize(json.len().next_multiple_of(WORD), b' ');
    let head = [&(json.len() as u64).to_le_bytes(), json.as_slice()].concat();
    Ok(parts(StatusCode::OK, "application/octet-stream", head.into(), rows))
}

fn written(value: &impl Serialize) -> Result<Vec<u8>, Refusal> {
    serde_json::to_vec(value)
        .map_err(|error| Refusal::new(StatusCode::INTERNAL_SERVER_ERROR, error.to_string()))
}

pub(crate) fn refusal(Refusal { status, message, hint }: Refusal) -> Answer {
    let body = serde_json::to_vec(&RefusalBody { message, hint }).unwrap_or_default();
    bytes(status, "application/json", body)
}
