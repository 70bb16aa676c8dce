//! Results of polhode, for people and for programs.
//!
//! Eight reports, each with a face for either reader, and a page:
//!
//! - [`InertiaReport`]: how much mass, where, and how it resists being turned;
//! - [`MotionReport`]: how the body moves, and the evidence that the numbers are good;
//! - [`SpinReport`]: a free motion in closed form, at any time;
//! - [`RequiredReport`]: the torque and the forces that a prescribed motion needs;
//! - [`SweepSummary`]: what many members come to;
//! - [`IdentifyReport`]: what was found of a body by measuring it;
//! - [`BudgetReport`]: what a parts list comes to;
//! - [`explain()`]: the worked solution, step by step, as a [`Document`](polhode_document::Document);
//! - [`page()`]: all of it to look at, as one file for a browser.
//!
//! Text is plain Unicode for a terminal of 100 columns: the answer first, the convention in the heading, every number
//! with its unit. JSON is SI, its keys are stable, and its numbers read back bit for bit; what is not finite or does not
//! exist is `null`. This crate formats: it reads no files, and what it knows of physics it asks the core.
#![forbid(unsafe_code)]

mod balance;
mod block;
mod body_part;
mod budget;
mod contact;
pub mod display;
mod error_estimate;
mod event;
mod explain;
mod export;
mod forces;
mod free_facts;
mod gimbals;
mod global_error;
mod heavy_top;
mod history;
mod identify;
mod inertia;
mod intermediate;
mod judge;
mod molecule;
mod motion;
mod omega;
mod orbit;
mod page;
mod parts;
mod periods;
mod plot;
mod required;
mod sampling;
mod sign_proof;
mod spin;
mod stability;
mod sweep;
mod symmetric_top;
mod torque;

pub use budget::{
    BudgetDiff, BudgetOptions, BudgetReport, BudgetStatements, Cell as BudgetCell, HistoryOptions,
    NoConfiguration, NoPlan, PlanOptions, Sheet as BudgetSheet, StatedChange, StatedSequence, StatedTank,
    history_files,
};
pub use error_estimate::error_estimate;

pub use explain::{explain, explain_motion};
pub use export::{ExportBody, ExportError, ExportFormat, export};

pub use identify::{BodySize, IdentifyReport, NoBody, PayloadReport, SwingReport, TumbleReport};
pub use inertia::InertiaReport;

pub use judge::{Card, CardCase, CardRun, JudgeReport, JudgedRun, judge_hint};
pub use molecule::MoleculeReport;
pub use motion::MotionReport;
pub use page::{
    PageInput, PageSubject, has_triangles, page, page_data, page_data_within, page_of, page_rows,
};
pub use parts::{PartRow, parts};
pub use periods::Periods;
pub use plot::{Figure, MotionFigures, PlotError, SweepFigures};
pub use required::RequiredReport;
pub use sign_proof::sign_proof;

pub use spin::{SpinReport, TumblerReport};
pub use stability::{GroundStabilityReport, StabilityReport};

pub use sweep::{
    SweepAttitude, SweepCorrelation, SweepHistogram, SweepIntervals, SweepQuantile, SweepQuestion,
    SweepSample, SweepShare, SweepStatistic, SweepStep, SweepSummary,
};

/// The version that reports carry.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
