//! Answers, with HTTP headers that isolate the page.

use std::io::{self, Write};
use std::sync::Arc;

/// Refusal of a request, with its HTTP status.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Refusal {
    pub(crate) status: u16,
    pub(crate) message: &'static str,
}

/// Refusal for a path that does not exist or may not be read. The answer does not say which.
pub(crate) const NOT_FOUND: Refusal = Refusal {
    status: 404,
    message: "this address does not exist: open the address that polhode live printed",
};

/// Answer to a request.
#[derive(Debug)]
pub(crate) struct Answer {
    status: u16,
    kind: &'static str,
    /// Content security policy. The page has one of its own; what a page cannot say is here.
    policy: &'static str,
    etag: Option<String>,
    body: Arc<Vec<u8>>,
}

impl Answer {
    pub(crate) fn page(html: Arc<Vec<u8>>) -> Self {
        let policy = "frame-ancestors 'none'";
        Self { status: 200, kind: "text/html; charset=utf-16le", policy, etag: None, body: html }
    }

    pub(crate) fn pack(bytes: Arc<Vec<u8>>, etag: String) -> Self {
        Self { status: 200, kind: "application/octet-stream", policy: NOTHING, etag: Some(etag), body: bytes }
    }

    /// Answer for a client that has this version already.
    pub(crate) fn unchanged(etag: String) -> Self {
        Self { status: 304, body: Arc::default(), ..Self::pack(Arc::default(), etag) }
    }

    /// Writes the answer, or only its head.
    pub(crate) fn write(&self, is_head: bool, out: &mut impl Write) -> io::Result<()> {
        let Self { status, kind, policy, etag, body } = self;
        let mut head = format!("HTTP/1.1 {status} {}\r\nconnection: close\r\n", reason(*status));
        let mut put = |name: &str, value: &str| head += &format!("{name}: {value}\r\n");
        HEADERS.into_iter().for_each(|(name, value)| put(name, value));
        put("content-security-policy", policy);
        etag.iter().for_each(|etag| put("etag", etag));
        if *status != 304 {
            put("content-type", kind);
            put("content-length", &body.len().to_string());
        }
        if *status == 405 {
            put("allow", "GET, HEAD");
        }
        out.write_all((head + "\r\n").as_bytes())?;
        if is_head { Ok(()) } else { out.write_all(body) }
    }
}

impl From<Refusal> for Answer {
    fn from(Refusal { status, message }: Refusal) -> Self {
        let body = Arc::new(format!("{message}\n").into_bytes());
        Self { status, kind: "text/plain; charset=utf-8", policy: NOTHING, etag: None, body }
    }
}

const NOTHING: &str = "default-src 'none'; frame-ancestors 'none'";

const HEADERS: [(&str, &str); 7] = [
    ("x-content-type-options", "nosniff"),
    ("x-frame-options", "DENY"),
    ("referrer-policy", "no-referrer"),
    ("cross-origin-resource-policy", "same-origin"),
    ("cross-origin-opener-policy", "same-origin"),
    ("permissions-policy", "camera=(), microphone=(), geolocation=()"),
    ("cache-control", "no-store"),
];

const fn reason(status: u16) -> &'static str {
    match status {
        200 => "OK",
        304 => "Not Modified",
        403 => "Forbidden",
        404 => "Not Found",
        405 => "Method Not Allowed",
        413 => "Content Too Large",
        431 => "Request Header Fields Too Large",
        _ => "Bad Request",
    }
}
