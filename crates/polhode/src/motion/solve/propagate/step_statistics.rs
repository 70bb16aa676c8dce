//! What a run cost.

/// What a run cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StepStatistics {
    /// Steps kept.
    pub accepted: u64,
    /// Steps whose error was too large.
    pub rejected: u64,
    /// Evaluations of the equations of motion for the steps, by DOP853, whose samples between steps cost eleven more; coefficients of
    /// all unknowns, by Taylor's method; of a body on the ground, where its motion is smooth, evaluations at the nodes of all trials.
    pub evaluations: u64,
}
