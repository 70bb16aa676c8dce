//! Cost of a run.

/// Cost of a run, in steps and evaluations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StepStatistics {
    /// Number of accepted steps.
    pub accepted: u64,
    /// Number of rejected steps, whose error was too large.
    pub rejected: u64,
    /// Number of evaluations.
    ///
    /// - DOP853: evaluations of the equations of motion for the steps. A sample between steps costs
    ///   eleven more.
    /// - Taylor's method: coefficients of all unknowns.
    /// - Body on the ground, smooth parts of its motion: evaluations at the nodes of all trials.
    pub evaluations: u64,
}
