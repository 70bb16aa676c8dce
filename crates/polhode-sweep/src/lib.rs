//! Many bodies: a plan says what differs from member to member, and a dataset holds what becomes of each.
//!
//! - [`Plan`]: a scenario and what is varied; member k is a pure function of the plan and k
//! - [`Batch`]: rows of members, column by column
//! - [`inputs`] and [`simulate`]: from members to rows, and from rows to rows with what becomes of them
//! - [`Dataset`]: all rows in a folder, whoever computes them and however often they are interrupted
//! - [`run`] answers a [`Request`] in memory: the plan, all members, and what they come to

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
pub use run::{REPORT_SCHEMA, Swept, run};
