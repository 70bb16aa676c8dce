//! Inspection of files that are not scenarios: a mesh that is not closed, or a robot.

mod links;
mod mesh;
mod robot;

use serde::Serialize;

pub(crate) use mesh::{MARKS, MeshInspection};
pub(crate) use robot::RobotInspection;

/// Inspection of a file, as `GET document/ID` returns it.
#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub(crate) enum Inspection<'a> {
    Mesh { mesh: &'a MeshInspection },
    Robot { robot: RobotInspection },
}
