//! Result for a model: its links, the new text, and the diff.

use std::path::PathBuf;

use polhode::body::MassProperties;
use polhode::math::Body;

use crate::model::{RobotModel, Role};
use crate::repair::Repaired;

/// Links of a model with their new inertials.
#[derive(Clone, Debug)]
pub struct Inertials {
    /// Model as read.
    pub model: RobotModel,
    /// Chosen links, in file order.
    pub links: Vec<LinkOutcome>,
    /// Path of the output, if it is written.
    pub out: Option<PathBuf>,
    /// New text of the model, with its edits.
    pub(super) edited: Repaired,
    /// Model with the new inertials.
    pub(super) after: RobotModel,
    /// True if a total mass was distributed.
    pub(super) has_total: bool,
}

/// Link and its outcome.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkOutcome {
    /// Name of the link.
    pub link: String,
    /// Line of its element, from 1.
    pub line: usize,
    pub outcome: Outcome,
}

/// Outcome for a link.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// The inertial is written.
    Written(Box<Written>),
    /// The link has no geometry of the requested kind; a frame needs no inertial.
    NoGeometry {
        /// True if the link was chosen by its name and has no usable inertial.
        is_missed: bool,
    },
    /// The inertial is not written.
    NotWritten {
        /// Reason in words.
        why: String,
        /// True if the link had a usable inertial before, which is kept.
        had_inertial: bool,
    },
}

/// New inertial of a link.
#[derive(Clone, Debug, PartialEq)]
pub struct Written {
    /// Mass properties in the link's frame, before rounding.
    pub properties: MassProperties<Body>,
    /// Volume of the link's solid, m³.
    pub volume: f64,
    /// Geometry that was used.
    pub role: Role,
    /// Reason for the geometry, in words.
    pub reason: String,
    /// Origin of the mass, in words: `kept`, `2700 kg/m³`.
    pub mass_by: String,
    /// Bound on the error of the moments, relative to the tensor.
    pub error: f64,
    /// True if the link states the same inertial already, so that its text is unchanged.
    pub is_unchanged: bool,
}

impl Inertials {
    /// Returns the new text. All bytes outside of the inertials are unchanged.
    pub fn text(&self) -> &str {
        &self.edited.text
    }

    /// Returns the model with the new inertials.
    pub const fn after(&self) -> &RobotModel {
        &self.after
    }

    /// Returns the numbers of links with a new inertial, and with one that was right.
    pub fn counts(&self) -> [usize; 2] {
        let written = self.links.iter().filter_map(|link| match &link.outcome {
            Outcome::Written(written) => Some(written.is_unchanged),
            Outcome::NoGeometry { .. } | Outcome::NotWritten { .. } => None,
        });
        written
            .fold([0, 0], |[new, unchanged], is| if is { [new, unchanged + 1] } else { [new + 1, unchanged] })
    }

    /// Sets the path of the output.
    #[must_use]
    pub fn written_to(self, out: PathBuf) -> Self {
        Self { out: Some(out), ..self }
    }

    /// Returns true if a chosen link is without an inertial now, or if a distributed total is
    /// incomplete.
    pub(super) fn is_incomplete(&self) -> bool {
        self.links.iter().any(|link| match &link.outcome {
            Outcome::Written(_) => false,
            Outcome::NoGeometry { is_missed } => *is_missed,
            Outcome::NotWritten { had_inertial, .. } => !had_inertial || self.has_total,
        })
    }
}
