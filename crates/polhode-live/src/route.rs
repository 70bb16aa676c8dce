//! Routes: requests and their answers.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use bytes::Bytes;
use polhode_source::json_value;
use serde::de::DeserializeOwned;

use crate::answer::{Answer, Refusal, bytes, json, json_and_rows};
use crate::asset::asset;
use crate::documents::Content;
use crate::inspect::{Inspection, MeshInspection, RobotInspection};
use crate::protocol::{
    Choice, CompleteAnswer, CompleteRequest, Documents, MotionAnswer, MotionRequest, OpenRequest,
};
use crate::session::Session;
use crate::{limits, motion, utf16, watch};
use hyper::{Method, StatusCode};

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
            Self::Document(id) => match session.documents.get(*id) {
                Ok(document) if !matches!(document.content, Content::Scenario { .. }) => Cost::Heavy,
                _ => Cost::Light,
            },
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
        watch::is_wanted(stop)?;
        let Self::Motion = self else { return self.answer(body, session, stop).map(Some) };
        let request: MotionRequest = read(body)?;
        let document = session.documents.get(request.document)?;
        let answer = motion::answer(document.draft()?, &request, most, stop)?;
        let with_rows = |answer: MotionAnswer| {
            let rows = answer.motion.as_ref().map_or_else(Bytes::new, |motion| motion.rows.clone());
            json_and_rows(&answer, rows)
        };
        answer.map(with_rows).transpose()
    }

    /// Computes the answer; `stop` is set when nobody waits for it.
    pub(crate) fn answer(
        &self,
        body: &[u8],
        session: &Arc<Session>,
        stop: &AtomicBool,
    ) -> Result<Answer, Refusal> {
        watch::is_wanted(stop)?;
        match self {
            Self::Asset(kind, body) => Ok(bytes(StatusCode::OK, kind, *body)),
            Self::Documents => {
                let documents: Vec<_> = session.documents.all().iter().map(|one| one.info()).collect();
                json(&Documents { first: documents.first().map(|one| one.id), documents })
            }
            Self::Document(id) => {
                let document = session.documents.get(*id)?;
                match document.content {
                    Content::Scenario { .. } => {
                        json(&serde_json::json!({ "kind": "scenario", "text": document.text()? }))
                    }
                    Content::Mesh(_) => inspection(&*document.looked_at(stop)?),
                    Content::Robot => {
                        let (name, path, roots) = (&document.name, &document.path, document.roots.clone());
                        json(&Inspection::Robot { robot: RobotInspection::of(name, path, roots, stop)? })
                    }
                }
            }
            Self::Mesh(id) => inspection(&*session.documents.get(*id)?.looked_at(stop)?),
            Self::Lessons => json(&serde_json::json!({ "lessons": session.lessons.list() })),
            Self::Lesson(id) => json(&session.lessons.open(id, &session.documents)?),
            Self::Motion => {
                let answer = self.answer_within(limits::MOTION, body, session, stop)?;
                answer.ok_or_else(Refusal::not_found)
            }
            Self::Complete => {
                let request: CompleteRequest = read(body)?;
                let document = session.documents.get(request.document)?;
                json(&complete(
                    &request,
                    &document.draft()?.lock().unwrap_or_else(std::sync::PoisonError::into_inner).clone(),
                ))
            }
            // The body has been saved while it arrived.
            Self::Drop { .. } => json(&serde_json::json!({})),
            Self::Open => {
                let OpenRequest { set, name } = read(body)?;
                let path = session.dropped.path(set, &name)?;
                let files = (session.dropped.set(set), session.dropped.files(set));
                json(&session.documents.open(&path, Some(files), stop)?.info())
            }
        }
    }
}

fn inspection(mesh: &MeshInspection) -> Result<Answer, Refusal> {
    json_and_rows(&Inspection::Mesh { mesh }, mesh.rows.clone())
}

fn complete(request: &CompleteRequest, draft: &polhode_scenario::read::Draft) -> CompleteAnswer {
    let text = &request.text;
    let found = draft.complete(text, utf16::to_byte(text, request.at));
    let place =
        found.as_ref().map(|found| [found.place.start, found.place.end].map(|at| utf16::of_byte(text, at)));
    let [from, to] = place.unwrap_or([request.at; 2]);
    let options = found.into_iter().flat_map(|found| found.suggested);
    let options = options.map(|one| Choice { label: one.text, detail: one.detail }).collect();
    CompleteAnswer { from, to, options }
}

fn read<T: DeserializeOwned>(body: &[u8]) -> Result<T, Refusal> {
    json_value(body)
        .and_then(serde_json::from_value)
        .map_err(|error| Refusal::new(StatusCode::BAD_REQUEST, format!("the request is invalid: {error}")))
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
