//! Contents of documents: the text of a scenario, or the inspection of a mesh or a robot.

mod links;
mod mesh;
mod robot;

use std::sync::Arc;

use serde::{Serialize, Serializer};

pub(crate) use mesh::MARKS;
pub use mesh::MeshInspection;
pub use robot::RobotInspection;

/// Contents of a document: `DocumentContent` of `viewer/src/live/protocol.ts`.
#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum DocumentContent {
    /// Text of a scenario.
    Scenario {
        /// Text as in the file, or as made from the file of a body.
        text: String,
    },
    /// Inspection of a mesh; its rows follow the JSON.
    Mesh {
        /// Surface and findings.
        #[serde(serialize_with = "shared")]
        mesh: Arc<MeshInspection>,
    },
    /// Inspection of a robot.
    Robot {
        /// Links and findings.
        robot: RobotInspection,
    },
}

fn shared<T: Serialize, S: Serializer>(value: &Arc<T>, serializer: S) -> Result<S::Ok, S::Error> {
    value.as_ref().serialize(serializer)
}
