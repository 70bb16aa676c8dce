//! Many bodies: a plan says what differs from member to member, and a dataset holds what becomes of each.
//!
//! - [`Plan`]: a scenario and what is varied; member k is a pure function of the plan and k
//! - [`Batch`]: rows of members, column by column

mod batch;
mod plan;

pub use batch::{Batch, BatchError, Column, Values};
pub use plan::{Plan, Sampling, Variable};
