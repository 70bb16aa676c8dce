//! The solver that found a trajectory.

use crate::motion::inverse::prescribed::Prescribed;
use crate::motion::solve::closed_form::ClosedForm;
use crate::motion::solve::method::Method;
use crate::motion::solve::propagate::splitting::SplittingOrder;
use crate::motion::solve::propagate::step_statistics::StepStatistics;

/// The solver that found a trajectory; a [`Method`] is the request.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Solution {
    /// A closed form.
    ClosedForm(ClosedForm),
    /// None: the motion was given.
    Prescribed(Prescribed),
    /// Steps by Taylor's method.
    Taylor(Steps),
    /// The Runge–Kutta method of Dormand and Prince, order 8.
    Dop853(Steps),
    /// Steps of one length: the exact free motion, with kicks by the torques between.
    Splitting {
        /// The order of accuracy.
        order: SplittingOrder,
        /// The length of a step, s.
        step: f64,
        /// Cost of the steps.
        statistics: StepStatistics,
    },
    /// Collocation at Gauss's nodes, of a body on the ground.
    Collocation(Steps),
    /// Collocation in some phases of a motion on the ground, Taylor's method in others.
    CollocationAndTaylor(Steps),
}

/// Steps whose length follows from a tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    /// Bound on the error of each step: attitude in rad, ω relative.
    pub tolerance: f64,
    /// Cost of the steps.
    pub statistics: StepStatistics,
}

impl Solution {
    /// The name of the solver in summaries: `exact`, `prescribed`, `taylor`, `dop853`, `splitting`,
    /// `collocation` or `collocation+taylor`.
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

    /// The name of the solver in a text for people.
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

    /// Returns the cost of the steps; `None` of a motion that was not integrated.
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

    /// Bound on the error of each step; `None` of a motion that was not integrated, and where steps have a given length.
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
