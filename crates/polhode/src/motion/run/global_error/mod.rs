//! The global error of a computed motion: an estimate of how far its states are from the true ones.
//!
//! Balances of energy and momentum cannot see it: a motion that amplifies small errors keeps them
//! and still diverges from the exact solution. So the motion is computed again, and the distance
//! between the runs is the estimate ([`comparison`]). One run is made at the tightest tolerance, by
//! Taylor's method where the torques have power series: its own truncation error is below rounding,
//! so that its distance is the truncation error of the motion, whatever set the length of its steps.
//! Others start from body and start changed by more than their rounding, and add noise larger than
//! rounding after each step. Each error is amplified from where it arises to the end by the full
//! equations: with events, schedules and friction, and beyond linearity.
//!
//! Rounding is amplified so much that a sample that is small by chance is still no smaller than the
//! error; there remains the chance that all samples of an effort are small. [`ErrorEffort`] states
//! what that costs.
//!
//! A closed form has no steps. Its error is that of its formulas, which are measured: `book/accuracy.md`.
//!
//! What the last bit of the inputs is worth is found in the same way, with the inputs alone made different: it is no error of the
//! computation, but nobody knows a body better than that.
//!
//! # Sources
//! Kenney, Laub, SIAM J. Sci. Comput. 15 (1994) 36 (condition from few random samples); Vignes, Math. Comput. Simul. 35 (1993) 233
//! (rounding by random perturbation); Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, II.4 (global error).

mod compared_samples;
mod comparison;
mod distance;
mod estimation;
mod finding;
mod free;
mod inputs;
mod repeatable;

/// How much work an estimate is worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum ErrorEffort {
    /// [`ErrorEffort::Thorough`] where that takes a few hundredths of a second at most, [`ErrorEffort::Cheap`] elsewhere.
    #[default]
    Auto,
    /// Two comparison runs: one at the tightest tolerance, and one with larger rounding than in
    /// thorough runs, as it is a single sample.
    Cheap,
    /// Thirteen comparison runs: one at the tightest tolerance, eight with larger rounding, and four
    /// from other inputs.
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
