//! The integration tests of `polhode-robot`, as one program: each links the whole library.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod bad_inertials;
mod check_alike;
mod check_common;
mod check_geometry;
mod check_hostile;
mod check_languages;
mod check_mass;
mod check_pairs;
mod check_tree;
mod common;
mod coupling;
mod geometry;
mod hostile;
mod lump;
mod mimic;
mod mjcf;
mod mjcf_compiler;
mod mjcf_composite;
mod mjcf_flexcomp;
mod mjcf_made;
mod osim;
mod planted;
mod policy;
mod reading;
mod repair;
mod round_trip;
mod rules;
mod sdf;
mod sdf_include;
mod urdf;
mod usd;
mod valid_models;
