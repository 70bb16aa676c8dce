//! Taylor series of autonomous systems: recorded once (`graph`), worked out coefficient by coefficient (`expansion`).

mod expansion;
mod graph;

pub(super) use expansion::Expansion;
pub(super) use graph::System;
