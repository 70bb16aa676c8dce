//! Functions of the npm package `polhode`: a request and files in memory in, JSON and numbers out.
//!
//! [`answer`] has no state, and reads no clock and no files except the given ones.
//!
//! ```
//! use polhode_source::files::Memory;
//! let model = r#"<robot name="r"><link name="arm"><inertial><mass value="1.7"/>
//!     <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="3"/></inertial></link></robot>"#;
//! let answer = polhode_npm::answer(br#"{"check": {"files": ["arm.urdf"]}}"#, &Memory::from([("arm.urdf", model)]));
//! assert!(answer.json.starts_with(br#"{"value":{"failed":true,"reports":[{"#));
//! ```
#![forbid(unsafe_code)]

mod answer;
mod check;
mod failed;
mod free_motion;
#[cfg(feature = "full")]
mod inertia;
mod message;
mod outcome;
#[cfg(feature = "full")]
mod scenario;

pub use answer::{Answer, answer};
pub use free_motion::{
    REPORT_SCHEMA as FREE_MOTION_REPORT_SCHEMA, REQUEST_SCHEMA as FREE_MOTION_REQUEST_SCHEMA,
};
