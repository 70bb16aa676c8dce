//! Reading and writing of tables of motions.
//!
//! - [`output`]: trajectories as CSV and Parquet, curves as CSV
//! - [`log`]: motions that other programs logged, as CSV, Parquet and JSON lines
//!
//! Only this crate depends on the large libraries for these formats.
#![forbid(unsafe_code)]

#[cfg(feature = "parquet")]
pub mod log;
pub mod output;
