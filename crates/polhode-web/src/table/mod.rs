//! Tables and plans that a slice answers with a report: parts lists, measurements, logs of motions.

mod field;
mod kind;
mod report;
mod seen;
#[allow(clippy::module_inception, reason = "the noun of the folder")]
mod table;

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::protocol::TextError;

pub use field::Field;
pub use kind::TableKind;
pub(crate) use seen::OpenScenario;
pub(crate) use table::Table;

/// Content of a table or a plan: `TableContent` of `viewer/src/live/protocol.ts`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct TableContent {
    /// Possible kinds; the reader chooses if there are several.
    pub kinds: Vec<KnownKind>,
    /// Text of a plan in TOML, which can be edited; `None` for a table.
    pub text: Option<String>,
    /// True if the log names a scenario that was dropped with it.
    pub has_scenario: bool,
}

/// Kind of a table, with its meaning and the options of its command.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct KnownKind {
    pub kind: TableKind,
    /// Meaning of the kind, in a sentence.
    pub what: &'static str,
    pub fields: Vec<Field>,
}

/// Request for the report on a table.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct ReportRequest {
    /// Document with the table or the plan.
    pub document: u32,
    pub kind: TableKind,
    /// Text of the plan, if it was edited.
    #[serde(default)]
    pub text: Option<String>,
    /// Scenario that is open, with its text: runs are judged by it.
    #[serde(default)]
    pub scenario: Option<ScenarioText>,
    /// Options of the command: fields of the slice's `Request`.
    #[serde(default)]
    pub options: Map<String, Value>,
}

/// Scenario document and its text, which may have been edited.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct ScenarioText {
    pub document: u32,
    pub text: String,
}

/// Report on a table, or its error.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReportAnswer {
    pub report: Option<ShownReport>,
    pub error: Option<ReportError>,
}

/// Report, as the command prints it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ShownReport {
    pub title: String,
    /// Self-contained page: title, answer, sections.
    pub html: String,
    /// Complete result as JSON.
    pub json: String,
    /// True if the command would exit with status 1.
    pub has_failed: bool,
}

/// Error of a table, a plan or the options.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ReportError {
    /// Description with the rule, advice, and the place if it is in the document's own text.
    #[serde(flatten)]
    pub error: TextError,
    /// Places with their lines, as the command prints them; empty if there is none.
    pub places: String,
}
