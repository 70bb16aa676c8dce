//! What is found in a file that is no scenario: a mesh that bounds no solid, a robot.

mod links;
mod mesh;
mod robot;

use serde::Serialize;

pub(crate) use mesh::{MARKS, MeshInspection};
pub(crate) use robot::RobotInspection;

/// What is found, as `GET document/ID` answers it.
#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub(crate) enum Inspection<'a> {
    Mesh { mesh: &'a MeshInspection },
    Robot { robot: RobotInspection },
}
