//! What is found in a file that is no scenario: a mesh that bounds no solid, a robot.

mod mesh;
mod robot;

use std::sync::atomic::AtomicBool;

use serde::Serialize;

use crate::answer::Refusal;
use crate::documents::Document;

pub(crate) use mesh::MeshInspection;
pub(crate) use robot::RobotInspection;

/// What is found, as `GET document/ID` answers it.
#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub(crate) enum Inspection {
    Mesh { mesh: MeshInspection },
    Robot { robot: RobotInspection },
}

impl Inspection {
    /// Of a mesh; `stop` ends it.
    pub(crate) fn of_mesh(document: &Document, stop: &AtomicBool) -> Result<Self, Refusal> {
        Ok(Self::Mesh { mesh: MeshInspection::of(document, stop)? })
    }

    /// Of a robot.
    pub(crate) fn of_robot(document: &Document) -> Result<Self, Refusal> {
        Ok(Self::Robot { robot: RobotInspection::of(document)? })
    }
}
