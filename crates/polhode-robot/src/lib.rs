//! Robot and simulation models (URDF, SDF, MJCF, USD, OpenSim): are these inertias right?
//!
//! [`run`] answers a [`Request`]: it checks models, and says what is wrong with them.
//!
//! - [`model`]: what a file says: links, inertials, geometry, joints, and where each number stands
//! - [`read`]: files in, models out
//! - [`geometry`]: what the shapes of a link enclose
//! - [`mod@check`]: the checks
//! - [`mod@rule`]: all rules in one table, each with its reason, its remedy and an example
//! - [`finding`]: what is wrong with a model, why, and what would repair it
//! - [`inspect`]: a model with its shapes measured and its rules checked
//! - [`program`]: programs that read models, and refuse some
//! - [`policy`]: what of the findings counts: severities of one's own, allowances, baselines
//! - [`repair`]: the text with repairs made, every other byte as it was, and the diff to it
//! - [`report`]: all that for people and for programs
//! - [`body`]: a link's mass properties in its own frame
//! - [`mod@lump`]: links joined to one body, joints at values by name
//! - [`mod@inertia`]: reports of these bodies
//! - [`link_table`]: all links in one table, and the whole
//! - [`mod@remarks`]: what a reader noticed, beside a link's mass properties
//! - [`moments`]: tensors that may be impossible, taken apart
//! - [`line_index`]: lines and columns of places

pub mod body;
pub mod check;
mod checked;
mod coordinate;
mod diff;
pub mod finding;
mod format;
mod found;
pub mod geometry;
pub mod inertia;
pub mod inspect;
mod json;
pub mod line_index;
mod link_choice;
mod link_error;
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

pub use checked::{Checked, FileChecked, Fix, Format};
pub use link_choice::{JointValue, LinkChoice, Which};
pub use link_error::LinkError;
pub use link_tables::LinkTables;
pub use request::Request;
pub use run::{Inputs, Progress, run};

/// JSON schema of [`Request`].
pub const REQUEST_SCHEMA: &str = include_str!("../schema/request.json");

/// JSON schema of the report of [`Checked`].
pub const REPORT_SCHEMA: &str = include_str!("../schema/report.json");
