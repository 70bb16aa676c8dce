//! Checks the inertias of robot and simulation models (URDF, SDF, MJCF, USD, OpenSim).
//!
//! [`run`] answers a [`Request`]: it reads models, checks them and reports findings.
//!
//! - [`model`]: contents of a file: links, inertials, geometry, joints, and the text position of
//!   each number
//! - [`read`]: readers; files in, models out
//! - [`geometry`]: volume, centroid and tensor of a link's shapes
//! - [`mod@check`]: the checks
//! - [`mod@rule`]: table of all rules, each with its reason, its remedy and an example
//! - [`finding`]: findings: the error, its likely cause and its repair
//! - [`inspect`]: a model with measured shapes and checked rules
//! - [`program`]: programs that read models, and their rejections
//! - [`policy`]: severity overrides, allowances and baselines
//! - [`repair`]: repaired text and its diff; all other bytes are unchanged
//! - [`report`]: reports for people and for programs
//! - [`at_rest`]: poses of all links with all joints at zero
//! - [`body`]: a link's mass properties in its own frame
//! - [`mod@lump`]: links joined to one body, with joint values given by name
//! - [`mod@inertia`]: reports of these bodies
//! - [`mod@inertials`]: inertials of all links from their geometry, written into the model
//! - [`link_table`]: table of all links and of the whole model
//! - [`compare`]: two models of one robot, link by link
//! - [`mod@remarks`]: the reader's notes about a link's mass properties
//! - [`moments`]: eigenvalues and axes of tensors that may be unphysical
//! - [`line_index`]: lines and columns of text positions

pub mod at_rest;
pub mod body;
pub mod check;
mod checked;
pub mod compare;
mod coordinate;
mod diff;
pub mod finding;
mod format;
mod found;
pub mod geometry;
pub mod inertia;
pub mod inertials;
mod inline_mesh;
pub mod inspect;
mod json;
pub mod line_index;
mod link_choice;
mod link_error;
mod link_host;
pub mod link_table;
mod link_tables;
pub mod lump;
pub mod model;
pub mod moments;
mod parallel;
mod placement;
pub mod policy;
mod pose;
pub mod program;
pub mod read;
pub mod remarks;
pub mod repair;
pub mod report;
mod request;
pub mod rule;
mod run;
mod span;
mod table;
mod text;
mod trace;

pub use checked::{Checked, FileChecked, Fix, Format};
pub use link_choice::{JointValue, LinkChoice, Which};
pub use link_error::LinkError;
pub use link_host::LinkHost;
pub use link_tables::LinkTables;
pub use request::Request;
pub use run::{Inputs, Progress, run};

/// JSON schema of a [`Request`].
pub const REQUEST_SCHEMA: &str = include_str!("../schema/request.json");

/// JSON schema of a [`LinkChoice`] without its table.
pub const LINK_CHOICE_SCHEMA: &str = include_str!("../schema/link-choice.json");

/// JSON schema of the report of a [`Checked`].
pub const REPORT_SCHEMA: &str = include_str!("../schema/report.json");

/// JSON schema of an [`inertials::InertialsRequest`].
pub const INERTIALS_REQUEST_SCHEMA: &str = include_str!("../schema/inertials-request.json");

/// JSON schema of the report of [`inertials::Inertials`].
pub const INERTIALS_REPORT_SCHEMA: &str = include_str!("../schema/inertials-report.json");
