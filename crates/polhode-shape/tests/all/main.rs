//! Integration tests of `polhode-shape`, combined in one program, because each program links the
//! whole library.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may")]

mod cad;
mod cad_geometry;
mod collada;
mod gltf;
mod molecule;
mod obj;
mod off;
mod particles;
mod ply;
mod points;
mod primitive;
mod request;
#[path = "../../../polhode-robot/tests/all/common/schema.rs"]
mod schema;
mod stl;
mod threemf;
mod voxel;
