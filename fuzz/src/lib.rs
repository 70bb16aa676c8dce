//! Fuzz targets: one function for each reader, which panics if a required property does not hold.
//!
//! The functions are run by libFuzzer (`fuzz_targets/all.rs`), and by a test on the stored inputs
//! (`crates/polhode-cli/tests/all/corpus.rs`). A reader may refuse any input; only accepted inputs
//! are checked.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a broken property ends the run")]
#![allow(unreachable_pub, reason = "the test includes this file as a module")]

pub mod live;
pub mod mesh;
pub mod motion;
mod physical;
pub mod robot;
pub mod table;
pub mod text;

/// Function that takes any input, and panics if a property does not hold.
pub type Target = fn(&[u8]);

/// All targets by name; the name is also that of the corpus folder.
pub const TARGETS: [(&str, Target); 35] = [
    ("stl", mesh::stl),
    ("obj", mesh::obj),
    ("ply", mesh::ply),
    ("off", mesh::off),
    ("gltf", mesh::gltf),
    ("threemf", mesh::threemf),
    ("collada", mesh::collada),
    ("xyz", table::xyz),
    ("mol", table::mol),
    ("pdb", table::pdb),
    ("particles", table::particles),
    ("voxel", table::voxel),
    ("times", table::times),
    ("budget", table::budget),
    ("motion_table", motion::motion_table),
    ("run_log", motion::run_log),
    ("cad", text::cad),
    ("unit", text::unit),
    ("expression", text::expression),
    ("formula", text::formula),
    ("urdf", robot::urdf),
    ("sdf", robot::sdf),
    ("mjcf", robot::mjcf),
    ("usd", robot::usd),
    ("osim", robot::osim),
    ("torque_table", motion::torque_table),
    ("mass_table", motion::mass_table),
    ("parquet", motion::parquet),
    ("judge", motion::judge),
    ("identify", text::identify),
    ("config", robot::config),
    ("baseline", robot::baseline),
    ("live", live::live),
    ("scenario", motion::scenario),
    ("plan", motion::plan),
];

/// Returns the target of this name.
pub fn target(name: &str) -> Option<Target> {
    TARGETS.iter().find(|(own, _)| *own == name).map(|(_, target)| *target)
}
