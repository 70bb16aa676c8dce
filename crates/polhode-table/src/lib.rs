//! Tables of motions, both ways.
//!
//! - [`output`]: trajectories as CSV and Parquet, curves as CSV
//! - [`log`]: motions that other programs logged, as CSV, Parquet and JSON lines
//!
//! The heavy formats are linked here and nowhere below.
#![forbid(unsafe_code)]

pub mod log;
pub mod output;
