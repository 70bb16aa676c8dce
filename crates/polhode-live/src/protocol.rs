//! What the page and the server say to each other, as `viewer/src/live/protocol.ts` has it.

use bytes::Bytes;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// An answer that is not 200.
#[derive(Debug, Serialize)]
pub(crate) struct RefusalBody {
    pub(crate) message: String,
    pub(crate) hint: Option<String>,
}

#[derive(Debug, Serialize)]
pub(crate) struct Documents {
    pub(crate) documents: Vec<DocumentInfo>,
    pub(crate) first: Option<u32>,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct DocumentInfo {
    pub(crate) id: u32,
    pub(crate) name: String,
    pub(crate) kind: &'static str,
    #[serde(rename = "mesh")]
    pub(crate) is_mesh: bool,
    pub(crate) stamp: String,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct MotionRequest {
    pub(crate) document: u32,
    pub(crate) text: String,
    pub(crate) edits: Vec<Edit>,
    pub(crate) error: bool,
    pub(crate) working: bool,
    pub(crate) body: Option<String>,
}

/// A change of the text.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(untagged, deny_unknown_fields)]
pub(crate) enum Edit {
    /// A value by its key, as TOML; `None` takes the key away.
    Set { set: String, value: Option<String> },
    /// Attitude (w, x, y, z) and ω in body axes at the start, rad/s.
    Start { attitude: [f64; 4], omega: [f64; 3] },
    /// ω in body axes at the start, rad/s.
    Omega { omega: [f64; 3] },
    /// Principal moments, ascending, kg·m².
    Moments { moments: [f64; 3] },
}

#[derive(Debug, Serialize)]
pub(crate) struct MotionAnswer {
    pub(crate) text: String,
    pub(crate) motion: Option<Motion>,
    pub(crate) knobs: Vec<Knob>,
    pub(crate) switches: Vec<Switch>,
    pub(crate) errors: Vec<TextError>,
    pub(crate) took: f64,
}

#[derive(Debug, Serialize)]
pub(crate) struct Motion {
    pub(crate) page: Value,
    /// Of the page: what stands behind the JSON.
    #[serde(skip)]
    pub(crate) rows: Bytes,
    pub(crate) body: String,
}

/// What is wrong with a text; offsets count UTF-16 units.
#[derive(Debug, Default, Serialize)]
pub(crate) struct TextError {
    pub(crate) message: String,
    pub(crate) hint: Option<String>,
    pub(crate) from: Option<usize>,
    pub(crate) to: Option<usize>,
    pub(crate) line: Option<usize>,
    pub(crate) column: Option<usize>,
}

/// A number of a scenario that can be turned: `Knob` of `viewer/src/live/protocol.ts`.
#[derive(Debug, Serialize)]
pub struct Knob {
    /// `body.part[0].radius`
    pub key: String,
    /// `crossbar: radius`
    pub label: String,
    /// The table that it belongs to.
    pub group: &'static str,
    /// As it is written: 4 of `4 mm`.
    pub value: f64,
    /// As it is written; empty of a plain number in SI.
    pub unit: String,
    /// The unit of a plain number.
    pub si: String,
    /// What it is: `a length`.
    pub what: String,
    /// From here on, as the value is written.
    pub low: f64,
    /// Up to here.
    pub high: f64,
    /// `linear` or `log`.
    pub scale: &'static str,
    /// Its place among all, the most telling first.
    pub rank: usize,
}

#[derive(Debug, Serialize)]
pub(crate) struct Switch {
    pub(crate) key: String,
    pub(crate) label: String,
    pub(crate) on: bool,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct CompleteRequest {
    pub(crate) document: u32,
    pub(crate) text: String,
    pub(crate) at: usize,
}

#[derive(Debug, Serialize)]
pub(crate) struct CompleteAnswer {
    pub(crate) from: usize,
    pub(crate) to: usize,
    pub(crate) options: Vec<Choice>,
}

#[derive(Debug, Serialize)]
pub(crate) struct Choice {
    pub(crate) label: String,
    pub(crate) detail: String,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct OpenRequest {
    pub(crate) set: u64,
    pub(crate) name: String,
}
/// What a list says of a lesson.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct LessonInfo {
    /// What it is asked for by.
    pub id: String,
    /// Its title.
    pub title: String,
    /// What it is about, in a sentence.
    pub summary: String,
}

#[derive(Debug, Serialize)]
pub(crate) struct Lesson {
    #[serde(flatten)]
    pub(crate) info: LessonInfo,
    pub(crate) document: u32,
    pub(crate) steps: Vec<LessonStep>,
}

#[derive(Debug, Serialize)]
pub(crate) struct LessonStep {
    pub(crate) text: String,
    pub(crate) question: Option<Question>,
    pub(crate) knobs: Vec<String>,
    pub(crate) scenario: String,
    pub(crate) working: Option<String>,
}

#[derive(Debug, Serialize)]
pub(crate) struct Question {
    pub(crate) text: String,
    pub(crate) answers: Vec<String>,
    /// From 0.
    pub(crate) right: usize,
    pub(crate) why: String,
}
