//! What was found of a body by measuring it, for people and for programs.

mod estimate;
mod payload;
mod swing;
mod tumble;

use serde_json::Value;

use crate::explain::document::Document;

pub use payload::PayloadReport;
pub use swing::SwingReport;
pub use tumble::TumbleReport;

/// What was found of a body, whatever was measured.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum IdentifyReport {
    /// By its free motion.
    Tumble(TumbleReport),
    /// By wrenches at a wrist that carries it.
    Payload(PayloadReport),
    /// By its swings.
    Swing(SwingReport),
}

impl IdentifyReport {
    /// The report as data.
    pub fn to_json(&self) -> Value {
        match self {
            Self::Tumble(report) => report.to_json(),
            Self::Payload(report) => report.to_json(),
            Self::Swing(report) => report.to_json(),
        }
    }

    /// The report as a document: text, Markdown, a page.
    pub fn to_document(&self) -> Document {
        match self {
            Self::Tumble(report) => report.to_document(),
            Self::Payload(report) => report.to_document(),
            Self::Swing(report) => report.to_document(),
        }
    }

    /// True if what is left is more than noise: the model is not all that moves the body.
    pub fn has_model_error(&self) -> bool {
        match self {
            Self::Tumble(report) => report.has_model_error(),
            Self::Payload(report) => report.has_model_error(),
            Self::Swing(report) => report.has_model_error(),
        }
    }
}
