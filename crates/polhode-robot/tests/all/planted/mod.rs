//! Models of six kinds, generated from solids, with and without faults.

mod clean;
mod faults;
mod language;
mod solid;

use crate::common::Folder;
use language::Language;
use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::{Inspection, inspect};
use polhode_robot::model::RobotModel;
use polhode_robot::read::{ReadOptions, read_model};

/// Reads and inspects a model in a language, next to the cube that its meshes refer to.
fn inspected(language: Language, text: &str, name: &str) -> (RobotModel, Inspection) {
    let file = format!("model.{}", language.ending());
    let folder = Folder::of(name, &[(&file, text), ("cube.stl", &solid::cube())]);
    let model = read_model(&folder.path(&file), &ReadOptions::default());
    let model = model.unwrap_or_else(|error| panic!("{name}: {error}\n{text}"));
    let inspection = inspect(&model, &Shapes::default());
    (model, inspection)
}
