//! Reports on scenarios, for people and for programs.
//!
//! - [`MotionReport`]: how the body moves, and the evidence that the numbers are good;
//! - [`SpinReport`]: a free motion in closed form, at any time;
//! - [`StabilityReport`]: which spins and rests are stable;
//! - [`RequiredReport`]: the torque and the forces that a prescribed motion needs;
//! - [`explain()`]: the worked solution, step by step, as a [`Document`](polhode_document::Document);
//! - [`MotionFigures`]: plots, as SVG and PNG;
//! - [`page()`]: all of it to look at, as one file for a browser.
//!
//! A report reads no files. What it knows of physics it asks the core.

mod answer;
mod balance;
pub mod display;
mod explain;
mod facts;
mod forces;
mod free_facts;
mod global_error;
mod history;
mod motion;
mod page;
mod periods;
mod plot;
mod required;
mod sampling;
mod spin;
mod stability;
mod torque;

pub use explain::{explain, explain_motion};

pub use motion::MotionReport;
pub use page::{
    PageInput, PageSubject, has_triangles, page, page_data, page_data_within, page_of, page_rows,
};
pub use periods::Periods;
pub use plot::{Figure, MotionFigures, PlotError};
pub use required::RequiredReport;
pub use spin::{SpinReport, TumblerReport};
pub use stability::{GroundStabilityReport, StabilityReport};

/// The version that reports carry.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
