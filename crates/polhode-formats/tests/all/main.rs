//! The integration tests of `polhode-formats`, as one program: each links the whole library.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may")]

mod book;
mod budget;
mod cad;
mod cad_geometry;
mod collada;
mod contact;
mod contact_examples;
mod examples;
mod expression;
mod files;
mod formula;
mod gimbal_examples;
mod gimbals;
mod gltf;
mod identify;
mod identify_swing;
mod mass_history;
mod mistakes;
mod molecule;
mod motion_errors;
mod obj;
mod off;
mod particles;
mod ply;
mod points;
mod prescribed;
mod run_log;
mod scenario;
mod stl;
mod table;
mod threemf;
mod torque_formula;
mod torque_table;
mod unit;
mod voxel;
