//! Integration tests of `polhode-robot`, combined in one program, because each program links the
//! whole library.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod armature;
mod auto_inertia;
mod bad_inertials;
mod check_alike;
mod check_center;
mod check_common;
mod check_geometry;
mod check_hostile;
mod check_languages;
mod check_mass;
mod check_pairs;
mod check_tree;
mod common;
mod compare;
mod coupling;
mod fix_cases;
mod geometry;
mod hostile;
mod inertials;
mod lump;
mod mimic;
mod mjcf;
mod mjcf_compiler;
mod mjcf_made;
mod osim;
mod packages;
mod planted;
mod policy;
mod reading;
mod refused;
mod repair;
mod request;
mod round_trip;
mod rules;
mod sdf;
mod sdf_include;
mod slips;
mod twins;
mod urdf;
mod usd;
mod usd_layers;
mod usd_stages;
mod usd_stated;
mod valid_models;
