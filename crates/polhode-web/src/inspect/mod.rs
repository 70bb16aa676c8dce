//! Contents of documents: the text of a scenario, the inspection of a mesh or a robot, or a table.

mod links;
mod mesh;
mod robot;

use std::sync::Arc;

use serde::{Serialize, Serializer};

pub(crate) use mesh::MARKS;
pub use mesh::MeshInspection;
pub use robot::RobotInspection;

use crate::table::TableContent;

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
    /// Table or plan, whose report is another request.
    Table {
        /// Possible kinds, and the text of a plan.
        table: TableContent,
    },
}

fn shared<T: Serialize, S: Serializer>(value: &Arc<T>, serializer: S) -> Result<S::Ok, S::Error> {
    value.as_ref().serialize(serializer)
}
