//! Parameter sweeps: a plan varies a scenario from member to member, and a dataset stores the
//! outcome of each member.
//!
//! - [`Plan`]: scenario and varied inputs; member k is a pure function of the plan and k
//! - [`Batch`]: table of members in columns
//! - [`inputs`] and [`simulate`]: input rows of members, and the same rows with outcomes
//! - [`Dataset`]: all rows in a folder, resumable after any interruption and shareable between
//!   processes
//! - [`run`] executes a [`Request`] in memory: the plan, all members, and their statistics

mod batch;
mod dataset;
mod error;
mod figures;
mod outcome;
mod parquet;
mod plan;
mod report;
mod request;
mod rows;
mod run;
mod sampling;
mod statistics;
mod swept;
mod threads;

pub use batch::{Batch, BatchError, Column, Values};
pub use dataset::{Dataset, Progress};
pub use error::SweepError;
pub use figures::SweepFigures;
pub use plan::{Plan, Sampling, Variable};
pub use report::{
    SweepAttitude, SweepCorrelation, SweepHistogram, SweepIntervals, SweepQuantile, SweepQuestion,
    SweepSample, SweepShare, SweepStatistic, SweepStep, SweepSummary,
};
pub use request::{REQUEST_SCHEMA, Request};
pub use rows::{inputs, simulate, trajectories};
pub use run::{REPORT_SCHEMA, run};
pub use swept::Swept;
