//! Global error of a computed motion: an estimate of the distance of its states from the true ones.
//!
//! The balances of energy and momentum cannot show this error. A motion that amplifies small errors
//! can satisfy them and still diverge from the exact solution. Therefore the motion is computed
//! again, and the distance between the runs is the estimate ([`comparison`]).
//!
//! One run has the tightest tolerance and uses Taylor's method if the torques have power series.
//! Its truncation error is below rounding. Its distance is therefore the truncation error of the
//! motion, however the step length was chosen.
//!
//! Other runs start from a body and a start that are changed by more than their rounding. After
//! each step they add noise larger than rounding. Each error is propagated to the end by the full
//! nonlinear equations, with events, schedules and friction.
//!
//! Rounding is amplified by a factor such that even a sample that is small by chance is not below
//! the true error. A small probability remains that all samples are too small. [`ErrorEffort`]
//! states the cost.
//!
//! A closed form has no steps. Its error is that of its formulas, which is measured:
//! `book/accuracy.md`.
//!
//! The effect of input rounding is estimated in the same way, with changes of the inputs only. It
//! is not an error of the computation, but it limits the accuracy of any prediction.
//!
//! # Sources
//! Kenney, Laub, SIAM J. Sci. Comput. 15 (1994) 36 (condition from few random samples); Vignes,
//! Math. Comput. Simul. 35 (1993) 233 (rounding by random perturbation); Hairer, Nørsett, Wanner,
//! Solving Ordinary Differential Equations I, II.4 (global error).

mod compared_samples;
mod comparison;
mod distance;
mod estimation;
mod finding;
mod free;
mod inputs;
mod repeatable;

/// Effort of an error estimate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum ErrorEffort {
    /// [`ErrorEffort::Thorough`] if that takes at most a few hundredths of a second,
    /// [`ErrorEffort::Cheap`] otherwise.
    #[default]
    Auto,
    /// Two comparison runs: one at the tightest tolerance, and one with amplified rounding. As the
    /// latter is a single sample, its amplification is larger than in thorough estimates.
    Cheap,
    /// Thirteen comparison runs: one at the tightest tolerance, eight with amplified rounding, and
    /// four from other inputs.
    Thorough,
}

impl ErrorEffort {
    const fn is_thorough(self, work: u64, few: u64) -> bool {
        match self {
            Self::Thorough => true,
            Self::Cheap => false,
            Self::Auto => work <= few,
        }
    }
}
