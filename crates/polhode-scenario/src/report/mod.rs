//! Reports on scenarios, as text and as JSON.
//!
//! - [`MotionReport`]: motion of the body, with evidence for the accuracy of the numbers;
//! - [`SpinReport`]: a free motion in closed form, at any time;
//! - [`StabilityReport`]: stability of spins and equilibria;
//! - [`RequiredReport`]: the torque and the forces that a prescribed motion needs;
//! - [`explain()`]: the worked solution by steps, as a [`Document`](polhode_document::Document);
//! - [`lagrangian()`]: the same by Lagrange's or Hamilton's equations;
//! - [`MotionFigures`]: plots, as SVG and PNG;
//! - [`page()`]: interactive page of a motion, as one file for a browser.
//!
//! A report reads no files. The core computes all physics.

mod answer;
mod balance;
pub mod display;
mod explain;
mod facts;
mod forces;
mod free_facts;
mod global_error;
mod history;
mod lagrangian;
mod motion;
mod page;
mod periods;
mod plot;
mod required;
mod sampling;
mod spin;
mod stability;
mod torque;

pub use explain::{exact_tensor, explain, explain_exactly, explain_motion};
pub use lagrangian::{Formalism, LagrangianError, lagrangian};

pub use motion::MotionReport;
pub use page::{
    PageInput, PageSubject, has_triangles, page, page_blocks, page_data, page_data_within, page_of, page_rows,
};
pub use periods::Periods;
pub use plot::{Figure, MotionFigures, PlotError};
pub use required::RequiredReport;
pub use spin::{SpinReport, TumblerReport};
pub use stability::{GroundStabilityReport, StabilityReport};

/// Version that reports state.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
