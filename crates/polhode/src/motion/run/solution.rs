//! Solvers of trajectories.

use crate::motion::inverse::prescribed::Prescribed;
use crate::motion::solve::closed_form::ClosedForm;
use crate::motion::solve::method::Method;
use crate::motion::solve::propagate::splitting::SplittingOrder;
use crate::motion::solve::propagate::step_statistics::StepStatistics;

/// Solver that computed a trajectory. (A [`Method`] is the request.)
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Solution {
    /// Closed form of the motion.
    ClosedForm(ClosedForm),
    /// No solver: the motion is prescribed.
    Prescribed(Prescribed),
    /// Taylor's method, with adaptive steps.
    Taylor(Steps),
    /// Runge–Kutta method of Dormand and Prince, order 8 (DOP853).
    Dop853(Steps),
    /// Splitting with constant step: exact free motions alternate with impulses by the torques.
    Splitting {
        /// Order of accuracy.
        order: SplittingOrder,
        /// Step length, s.
        step: f64,
        /// Cost of the run.
        statistics: StepStatistics,
    },
    /// Collocation at Gauss nodes, for a body on the ground.
    Collocation(Steps),
    /// Collocation in some phases of a motion on the ground, Taylor's method in the others.
    CollocationAndTaylor(Steps),
}

/// Tolerance and cost of an integration with adaptive steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    /// Bound on the error of each step: attitude in rad, ω relative.
    pub tolerance: f64,
    /// Cost of the run.
    pub statistics: StepStatistics,
}

impl Solution {
    /// Returns the name of the solver used in summaries: `exact`, `prescribed`, `taylor`, `dop853`,
    /// `splitting`, `collocation` or `collocation+taylor`.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::ClosedForm(_) => Method::Exact.name(),
            Self::Prescribed(_) => "prescribed",
            Self::Taylor(_) => Method::Taylor.name(),
            Self::Dop853(_) => Method::Dop853.name(),
            Self::Splitting { order, step, .. } => Method::Splitting { order: *order, step: *step }.name(),
            Self::Collocation(_) => "collocation",
            Self::CollocationAndTaylor(_) => "collocation+taylor",
        }
    }

    /// Returns the name of the solver for people.
    pub const fn title(&self) -> &'static str {
        match self {
            Self::ClosedForm(_) => "a closed form",
            Self::Prescribed(_) => "a prescribed motion",
            Self::Taylor(_) => Method::Taylor.title(),
            Self::Dop853(_) => Method::Dop853.title(),
            Self::Splitting { order, step, .. } => Method::Splitting { order: *order, step: *step }.title(),
            Self::Collocation(_) => "collocation",
            Self::CollocationAndTaylor(_) => "collocation and Taylor's method",
        }
    }

    /// Returns the cost of the steps; `None` if the motion was not integrated.
    pub const fn statistics(&self) -> Option<StepStatistics> {
        match self {
            Self::ClosedForm(_) | Self::Prescribed(_) => None,
            Self::Splitting { statistics, .. } => Some(*statistics),
            Self::Taylor(steps)
            | Self::Dop853(steps)
            | Self::Collocation(steps)
            | Self::CollocationAndTaylor(steps) => Some(steps.statistics),
        }
    }

    /// Returns the bound on the error of each step; `None` if the motion was not integrated, or if
    /// the step is constant.
    pub const fn tolerance(&self) -> Option<f64> {
        match self {
            Self::ClosedForm(_) | Self::Prescribed(_) | Self::Splitting { .. } => None,
            Self::Taylor(steps)
            | Self::Dop853(steps)
            | Self::Collocation(steps)
            | Self::CollocationAndTaylor(steps) => Some(steps.tolerance),
        }
    }
}
