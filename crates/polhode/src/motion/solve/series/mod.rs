//! Taylor series of autonomous systems: recorded once (`graph`), then evaluated coefficient by
//! coefficient (`expansion`).

mod expansion;
mod graph;

pub(in crate::motion) use expansion::Expansion;
pub(in crate::motion) use graph::System;
