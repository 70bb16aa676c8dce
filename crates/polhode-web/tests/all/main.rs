//! Integration tests of `polhode-web`, combined in one program, because each program links the
//! whole library.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may")]

#[path = "../../../polhode-source/tests/common/chance.rs"]
mod chance;
mod exercise;
mod ground_lessons;
mod hostile;
mod inspect;
mod known;
mod lesson;
mod lesson_files;
mod lessons;
mod meshes;
mod motion;
mod page;
mod protocol;
mod refused;
mod robot_shapes;
mod robots;
#[path = "../../../polhode-robot/tests/all/common/schema.rs"]
mod schema;
mod session;
mod stopped;
mod tables;
mod text;
