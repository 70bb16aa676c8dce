//! Taylor series of autonomous systems: recorded once (`graph`), worked out coefficient by coefficient (`expansion`).

mod expansion;
mod graph;

pub(in crate::motion) use expansion::Expansion;
pub(in crate::motion) use graph::System;
