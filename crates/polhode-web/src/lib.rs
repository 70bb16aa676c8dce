//! Engine of the interactive page: pure, without clock, threads, network or file access.
//!
//! [`Engine`] answers the requests of the page: it changes the text of a scenario, computes its
//! motion, completes the text, opens lessons, grades exercises, inspects meshes and robots, and
//! reports on parts lists, measurements and logs. A caller passes the
//! [files](polhode_source::files::Files) that may be read, and a [`Watch`] that ends long
//! computations. `polhode live` calls the engine from its server; in a browser, a worker passes
//! [messages](Message) to [`Engine::answer`].
//!
//! ```
//! use polhode_source::files::Memory;
//! use polhode_web::Engine;
//! let files = Memory::from([("water.xyz", "3\n\nO 0 0 0.1173\nH 0 0.7572 -0.4692\nH 0 -0.7572 -0.4692\n")]);
//! let engine = Engine::default();
//! let answer = engine.answer(br#"{"open": {"path": "water.xyz"}}"#, &files, &|| true);
//! assert!(answer.starts_with(br#"{"id":0,"name":"water.xyz","kind":"scenario""#));
//! ```
#![forbid(unsafe_code)]

mod documents;
mod edit;
mod engine;
mod exercise;
mod framed;
mod inspect;
mod kind;
mod knob;
mod lesson;
pub mod limits;
mod mesh;
mod message;
mod motion;
mod opened;
mod part_names;
mod protocol;
mod refusal;
mod rows;
mod table;
mod text_error;
mod utf16;
mod watch;

pub use documents::DroppedSet;
pub use engine::Engine;
pub use exercise::{ExerciseAnswer, ExerciseRequest};
pub use framed::{json, json_before_rows};
pub use inspect::{DocumentContent, MeshInspection, RobotInspection};
pub use knob::knobs;
pub use lesson::{LessonError, lessons};
pub use message::{Message, read_request};
pub use protocol::{
    Choice, CompleteAnswer, CompleteRequest, DocumentInfo, DocumentList, Edit, Knob, Lesson, LessonInfo,
    LessonStep, Motion, MotionAnswer, MotionRequest, Question, Switch, TextError,
};
pub use refusal::{Refusal, RefusalKind};
pub use table::{
    Field, KnownKind, ReportAnswer, ReportError, ReportRequest, ScenarioText, ShownReport, TableContent,
    TableKind,
};
pub use watch::Watch;

/// JSON schema of the requests and answers, of which the types of `viewer/src/live/protocol.ts` are
/// made.
pub const PROTOCOL_SCHEMA: &str = include_str!("../schema/protocol.json");
