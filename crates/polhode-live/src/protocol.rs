//! Protocol between page and server, as in `viewer/src/live/protocol.ts`.

use bytes::Bytes;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// Body of an answer whose status is not 200.
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
    /// New value of a key, as TOML; `None` removes the key.
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
    /// Rows of numbers that follow the JSON.
    #[serde(skip)]
    pub(crate) rows: Bytes,
    pub(crate) body: String,
}

/// Error in a text. Offsets count UTF-16 units.
#[derive(Debug, Default, Serialize)]
pub(crate) struct TextError {
    pub(crate) message: String,
    pub(crate) hint: Option<String>,
    pub(crate) from: Option<usize>,
    pub(crate) to: Option<usize>,
    pub(crate) line: Option<usize>,
    pub(crate) column: Option<usize>,
}

/// A number of a scenario that can be changed: `Knob` of `viewer/src/live/protocol.ts`.
#[derive(Debug, Serialize)]
pub struct Knob {
    /// Key, such as `body.part[0].radius`.
    pub key: String,
    /// Label, such as `crossbar: radius`.
    pub label: String,
    /// Table of the scenario to which the number belongs.
    pub group: &'static str,
    /// Value in the unit of the text, such as 4 for `4 mm`.
    pub value: f64,
    /// Unit in the text; empty for a plain number in SI units.
    pub unit: String,
    /// SI unit of a plain number.
    pub si: String,
    /// Kind of quantity, such as `a length`.
    pub what: String,
    /// Lower end of the slider, in the unit of the text.
    pub low: f64,
    /// Upper end of the slider, in the unit of the text.
    pub high: f64,
    /// Scale of the slider: `linear` or `log`.
    pub scale: &'static str,
    /// Rank among all knobs, the most informative first.
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
/// Entry of a lesson in a list.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct LessonInfo {
    /// Identifier used in requests.
    pub id: String,
    /// Title of the lesson.
    pub title: String,
    /// Subject of the lesson, in a sentence.
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
    /// Index of the right answer, from 0.
    pub(crate) right: usize,
    pub(crate) why: String,
}
