//! Protocol between page and engine; `schema/protocol.json` describes it for TypeScript.

use serde::{Deserialize, Serialize};
use serde_json::Value;

/// Documents of a session, in the order in which they were opened.
#[derive(Clone, Debug, Serialize)]
pub struct DocumentList {
    pub documents: Vec<DocumentInfo>,
    /// Number of the document to begin with.
    pub first: Option<u32>,
}

/// Entry of a document in a list.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct DocumentInfo {
    /// Number used in requests.
    pub id: u32,
    /// Name of the file.
    pub name: String,
    /// Kind: `scenario`, `mesh`, `robot` or `table`.
    pub kind: &'static str,
    /// True if the file is a single mesh, which can be inspected.
    #[serde(rename = "mesh")]
    pub is_mesh: bool,
    /// Hash of the state of its files: it changes when one is written to.
    pub stamp: String,
}

/// Request to change a text and to compute its motion.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct MotionRequest {
    /// Document to whose files the text may refer.
    pub document: u32,
    /// Text of the scenario.
    pub text: String,
    /// Edits, applied one after the other; at most [`EDITS`](crate::limits::EDITS).
    pub edits: Vec<Edit>,
    /// True to estimate the error of the motion.
    pub error: bool,
    /// True to write the worked solution.
    pub working: bool,
    /// [`Motion::body`] of the last answer: data of that body are not repeated.
    pub body: Option<String>,
}

/// Change of a text.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(untagged, deny_unknown_fields)]
pub enum Edit {
    /// Sets or removes the value of a key.
    Set {
        /// Key, such as `body.part[0].radius`.
        set: String,
        /// New value as TOML; `None` removes the key.
        value: Option<String>,
    },
    /// Sets attitude and angular velocity at the start.
    Start {
        /// Attitude as a quaternion (w, x, y, z).
        attitude: [f64; 4],
        /// Angular velocity in body axes, rad/s.
        omega: [f64; 3],
    },
    /// Sets the angular velocity at the start.
    Omega {
        /// Angular velocity in body axes, rad/s.
        omega: [f64; 3],
    },
    /// Sets the principal moments.
    Moments {
        /// Principal moments, ascending, kg·m².
        moments: [f64; 3],
    },
}

/// Changed text, and its motion or its errors.
#[derive(Debug, Serialize)]
pub struct MotionAnswer {
    /// Text with the edits.
    pub text: String,
    /// Motion; `None` if the text is not a scenario or its motion cannot be computed.
    pub motion: Option<Motion>,
    /// Numbers of the text that can be changed.
    pub knobs: Vec<Knob>,
    /// Switch of each torque.
    pub switches: Vec<Switch>,
    /// Errors of the edits, the text and the motion.
    pub errors: Vec<TextError>,
    /// Computation time, ms; 0 until a caller with a clock sets it.
    pub took: f64,
}

/// Motion as data of the page.
#[derive(Debug, Serialize)]
pub struct Motion {
    /// `PageData` of `viewer/src/data.ts`.
    pub page: Value,
    /// Rows of numbers that follow the JSON, little-endian f64.
    #[serde(skip)]
    pub rows: Vec<u8>,
    /// Fingerprint of the body, for the next request.
    pub body: String,
}

/// Error in a text.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct TextError {
    /// Description of the error, and the rule.
    pub message: String,
    /// Advice for a fix, if there is any.
    pub hint: Option<String>,
    /// Start of the place in the text, in UTF-16 units.
    pub from: Option<usize>,
    /// End of the place in the text, in UTF-16 units.
    pub to: Option<usize>,
    /// Line of the place, from 1.
    pub line: Option<usize>,
    /// Character of the place in its line, from 1.
    pub column: Option<usize>,
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

/// Switch of a torque.
#[derive(Debug, Serialize)]
pub struct Switch {
    /// Key, such as `torque[0].on`.
    pub key: String,
    /// Name or model of the torque.
    pub label: String,
    /// True if the torque acts.
    pub on: bool,
}

/// Request to complete a text.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct CompleteRequest {
    /// Document to which the text belongs.
    pub document: u32,
    /// Text of the scenario.
    pub text: String,
    /// Position of the cursor, in UTF-16 units.
    pub at: usize,
}

/// Completions, and the place in the text that they replace.
#[derive(Debug, Serialize)]
pub struct CompleteAnswer {
    /// Start of the place, in UTF-16 units.
    pub from: usize,
    /// End of the place, in UTF-16 units.
    pub to: usize,
    /// Completions that the reader accepts there.
    pub options: Vec<Choice>,
}

/// Completion of a key, a name or a unit.
#[derive(Debug, Serialize)]
pub struct Choice {
    /// Text to insert.
    pub label: String,
    /// Description, such as the unit.
    pub detail: String,
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

/// Lesson whose scenario is a document.
#[derive(Debug, Serialize)]
pub struct Lesson {
    /// Entry of the lesson in a list.
    #[serde(flatten)]
    pub info: LessonInfo,
    /// Number of the document with its scenario.
    pub document: u32,
    /// Steps, at least one.
    pub steps: Vec<LessonStep>,
}

/// Step of a lesson.
#[derive(Debug, Serialize)]
pub struct LessonStep {
    /// Text to read.
    pub text: String,
    /// Question to answer before the motion is shown.
    pub question: Option<Question>,
    /// Keys of the knobs that are shown.
    pub knobs: Vec<String>,
    /// Text of the scenario with the values of this step.
    pub scenario: String,
    /// Start of a heading of the worked solution.
    pub working: Option<String>,
}

/// Question of a step, with its answers.
#[derive(Debug, Serialize)]
pub struct Question {
    /// Text of the question.
    pub text: String,
    /// Two to five answers.
    pub answers: Vec<String>,
    /// Index of the right answer, from 0.
    pub right: usize,
    /// Explanation of the right answer.
    pub why: String,
}
