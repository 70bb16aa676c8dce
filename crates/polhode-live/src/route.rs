//! Routes: requests and their answers.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use bytes::Bytes;
use hyper::{Method, StatusCode};
use polhode_source::files::Disk;
use polhode_web::{DocumentContent, DroppedSet, MeshInspection, RefusalKind, Watch as _, read_request};
use serde::Deserialize;

use crate::answer::{Answer, Refusal, bytes, json, json_and_rows};
use crate::asset::asset;
use crate::limits;
use crate::session::Session;
use crate::watch::{Within, is_wanted};

/// Route of a request, known before its body has arrived.
#[derive(Debug)]
pub(crate) enum Route {
    Asset(&'static str, &'static [u8]),
    Documents,
    Document(u32),
    Mesh(u32),
    Lessons,
    Lesson(String),
    Motion,
    Complete,
    Drop { set: u64, name: String },
    Open,
}

/// Cost of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Cost {
    /// Answered immediately.
    Nothing,
    /// A few milliseconds.
    Light,
    /// Up to [`limits::ANSWER`].
    Heavy,
    /// Known only by trying.
    Unknown,
}

impl Route {
    /// Returns the route of a path after the token.
    pub(crate) fn of(method: &Method, path: &str, query: Option<&str>) -> Result<Self, Refusal> {
        let is_post = *method == Method::POST;
        match (is_post, path) {
            (false, "documents") => Ok(Self::Documents),
            (false, "lessons") => Ok(Self::Lessons),
            (true, "motion") => Ok(Self::Motion),
            (true, "complete") => Ok(Self::Complete),
            (true, "open") => Ok(Self::Open),
            (true, "drop") => Self::drop(query.unwrap_or_default()),
            (false, path) => Self::named(path).ok_or_else(Refusal::not_found),
            _ => Err(Refusal::not_found()),
        }
    }

    /// Parses a path such as `document/3`, `mesh/3`, `lesson/cube` or `live.js`.
    fn named(path: &str) -> Option<Self> {
        match path.split_once('/') {
            Some(("document", id)) => id.parse().ok().map(Self::Document),
            Some(("mesh", id)) => id.parse().ok().map(Self::Mesh),
            Some(("lesson", id)) => decoded(id).map(Self::Lesson),
            _ => asset(path).map(|(kind, bytes)| Self::Asset(kind, bytes)),
        }
    }

    /// Parses the query of a dropped file, such as `set=7&name=meshes%2Fpart.stl`.
    fn drop(query: &str) -> Result<Self, Refusal> {
        let bad = || {
            Refusal::new(StatusCode::BAD_REQUEST, "the query of a dropped file must be set=NUMBER&name=NAME")
        };
        let value = |wanted: &str| {
            let mut pairs = query.split('&').filter_map(|pair| pair.split_once('='));
            pairs.find(|(key, _)| *key == wanted).map(|(_, value)| value)
        };
        let (set, name) = (value("set").ok_or_else(bad)?, value("name").ok_or_else(bad)?);
        Ok(Self::Drop { set: set.parse().map_err(|_| bad())?, name: decoded(name).ok_or_else(bad)? })
    }

    /// Returns the maximum size of its body, bytes.
    pub(crate) const fn most(&self) -> usize {
        match self {
            Self::Asset(..)
            | Self::Documents
            | Self::Document(_)
            | Self::Mesh(_)
            | Self::Lessons
            | Self::Lesson(_) => 0,
            Self::Drop { .. } => limits::FILE,
            _ => limits::JSON,
        }
    }

    /// Returns the cost of its answer.
    pub(crate) fn cost(&self, session: &Session) -> Cost {
        match self {
            Self::Asset(..) | Self::Documents | Self::Lessons | Self::Drop { .. } => Cost::Nothing,
            Self::Complete | Self::Lesson(_) => Cost::Light,
            Self::Motion => Cost::Unknown,
            Self::Document(id) if session.engine.is_inspected(*id) => Cost::Heavy,
            Self::Document(_) => Cost::Light,
            Self::Mesh(_) | Self::Open => Cost::Heavy,
        }
    }

    /// Computes the answer, or returns `None` if a motion takes longer than `most`; `stop` is set
    /// when nobody waits for it.
    pub(crate) fn answer_within(
        &self,
        most: Duration,
        body: &[u8],
        session: &Arc<Session>,
        stop: &AtomicBool,
    ) -> Result<Option<Answer>, Refusal> {
        is_wanted(stop)?;
        let Self::Motion = self else { return self.answer(body, session, stop).map(Some) };
        let request = read_request(body)?;
        let begun = Instant::now();
        let within = Within::new(most, stop);
        let is_first_try = most < limits::MOTION;
        // Nothing is kept of a first try that takes too long.
        let answer = match is_first_try {
            true => session.engine.motion(&request, &Disk, &|| within.goes_on()),
            false => session.engine.motion(&request, &Disk, &within),
        };
        let mut answer = match answer {
            Err(refusal) if refusal.kind == RefusalKind::Ended && is_first_try => return Ok(None),
            answer => answer?,
        };
        answer.took = begun.elapsed().as_secs_f64() * 1e3;
        let rows = answer.motion.as_mut().map(|motion| std::mem::take(&mut motion.rows));
        json_and_rows(&answer, rows.unwrap_or_default().into()).map(Some)
    }

    /// Computes the answer; `stop` is set when nobody waits for it.
    pub(crate) fn answer(
        &self,
        body: &[u8],
        session: &Arc<Session>,
        stop: &AtomicBool,
    ) -> Result<Answer, Refusal> {
        is_wanted(stop)?;
        let engine = &session.engine;
        let inspected = Within::new(limits::INSPECTION, stop);
        match self {
            Self::Asset(kind, body) => Ok(bytes(StatusCode::OK, kind, *body)),
            Self::Documents => json(&engine.documents(&Disk)),
            Self::Document(id) => content(&engine.document(*id, &Disk, &inspected)?),
            Self::Mesh(id) => content(&DocumentContent::Mesh { mesh: engine.mesh(*id, &Disk, &inspected)? }),
            Self::Lessons => json(&serde_json::json!({ "lessons": engine.lessons(&Disk) })),
            Self::Lesson(id) => json(&engine.lesson(id, &Disk, &Within::new(limits::MOTION, stop))?),
            Self::Motion => {
                let answer = self.answer_within(limits::MOTION, body, session, stop)?;
                answer.ok_or_else(Refusal::not_found)
            }
            Self::Complete => json(&engine.complete(&read_request(body)?)?),
            // The body has been saved while it arrived.
            Self::Drop { .. } => json(&serde_json::json!({})),
            Self::Open => {
                let OpenRequest { set, name } = read_request(body)?;
                let path = session.dropped.path(set, &name)?;
                let set = DroppedSet { folder: session.dropped.set(set), files: session.dropped.files(set) };
                json(&engine.open(&path, Some(&set), &Disk, &inspected)?)
            }
        }
    }
}

/// Request to open a dropped file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct OpenRequest {
    set: u64,
    name: String,
}

/// Answers with the contents of a document. Rows of a mesh are not copied.
fn content(content: &DocumentContent) -> Result<Answer, Refusal> {
    struct RowsOf(Arc<MeshInspection>);
    impl AsRef<[u8]> for RowsOf {
        fn as_ref(&self) -> &[u8] {
            self.0.rows()
        }
    }
    match content {
        DocumentContent::Mesh { mesh } => json_and_rows(content, Bytes::from_owner(RowsOf(mesh.clone()))),
        _ => json(content),
    }
}

/// Decodes a percent-encoded part of a query.
fn decoded(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, after @ ..] = rest {
        rest = after;
        match first {
            b'%' => {
                let (digits, further) = after.split_at_checked(2)?;
                bytes.push(u8::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok()?);
                rest = further;
            }
            b'+' => bytes.push(b' '),
            other => bytes.push(*other),
        }
    }
    String::from_utf8(bytes).ok()
}
