//! Requests to the engine as JSON.

use std::path::PathBuf;

use polhode_source::json_value;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::exercise::ExerciseRequest;
use crate::protocol::{CompleteRequest, MotionRequest};
use crate::refusal::{Refusal, RefusalKind};
use crate::table::ReportRequest;

/// Request of the page, as [`Engine::answer`](crate::Engine::answer) reads it from JSON.
///
/// ```
/// use polhode_web::{Message, read_request};
/// let message: Message = read_request(br#"{"document": {"id": 3}}"#)?;
/// assert_eq!(message, Message::Document { id: 3 });
/// let message: Message = read_request(br#""documents""#)?;
/// assert_eq!(message, Message::Documents);
/// # Ok::<(), polhode_web::Refusal>(())
/// ```
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Message {
    /// Lists the documents.
    Documents,
    /// Returns the text of a scenario, the inspection of a mesh or robot, or the kinds of a table.
    Document {
        /// Number of the document.
        id: u32,
    },
    /// Returns the inspection of a mesh that may also be a scenario's body.
    Mesh {
        /// Number of the document.
        id: u32,
    },
    /// Lists the lessons.
    Lessons,
    /// Opens a lesson.
    Lesson {
        /// Identifier of the lesson.
        id: String,
    },
    /// Lists the topics of exercises.
    Exercises,
    /// Makes an exercise, and grades answers to it.
    Exercise(ExerciseRequest),
    /// Changes a text and computes the motion.
    Motion(MotionRequest),
    /// Returns the report on a table.
    Report(ReportRequest),
    /// Completes a text.
    Complete(CompleteRequest),
    /// Begins with a teacher's own lesson, and returns its id.
    LessonFile {
        /// Path of the file in the source of files.
        path: PathBuf,
    },
    /// Opens a file.
    Open {
        /// Path of the file in the source of files.
        path: PathBuf,
        /// Folder of a set of dropped files: a file of the set may refer only to files in it.
        #[serde(default)]
        set: Option<PathBuf>,
    },
    /// Opens the file of a table that may be of several kinds again, as particles.
    Particles {
        /// Number of the document.
        id: u32,
    },
    /// Opens the default scenario.
    OpenExample,
}

/// Reads a request from JSON. A key that is unknown, or that an object has twice, is refused.
///
/// # Errors
/// [`RefusalKind::BadRequest`]
pub fn read_request<T: DeserializeOwned>(json: &[u8]) -> Result<T, Refusal> {
    json_value(json)
        .and_then(serde_json::from_value)
        .map_err(|error| Refusal::new(RefusalKind::BadRequest, format!("the request is invalid: {error}")))
}
