//! What was found of a body by measuring it, for people and for programs.

mod estimate;
mod motion;
mod next;
mod payload;
mod picture;
mod scenario;
mod swing;
mod tumble;

use serde_json::Value;

use crate::explain::document::Document;

pub use payload::PayloadReport;
pub use scenario::{BodySize, NoBody};
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

    /// The body as a part of a scenario file. Of a tumble that shows only ratios its size and its mass have to be said.
    ///
    /// # Errors
    /// If not all of it is known, or what was found is said as well.
    pub fn to_scenario(&self, size: &BodySize) -> Result<String, NoBody> {
        match self {
            Self::Tumble(report) => report.to_scenario(size),
            Self::Payload(_) | Self::Swing(_) if size.mass.is_some() => Err(NoBody::Found { what: "mass" }),
            Self::Payload(_) | Self::Swing(_) if size.greatest_moment.is_some() => {
                Err(NoBody::Found { what: "greatest-moment" })
            }
            Self::Payload(report) => report.to_scenario(),
            Self::Swing(report) => report.to_scenario(),
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
