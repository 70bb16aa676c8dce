//! Solvers: the numerical methods that have integrated a motion.

use super::method::Method;
use super::propagate::splitting::SplittingOrder;

/// The numerical method, or methods, that integrated a motion; a [`Method`] is the request.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Solver {
    /// Taylor's method.
    Taylor,
    /// The Runge–Kutta method of Dormand and Prince, order 8.
    Dop853,
    /// Steps of one length: the exact free motion, with kicks by the torques between.
    Splitting {
        /// The order of accuracy.
        order: SplittingOrder,
        /// The length of a step, s.
        step: f64,
    },
    /// Collocation at Gauss's nodes, of a body on the ground.
    Collocation,
    /// Collocation in some phases of a motion on the ground, Taylor's method in others.
    CollocationAndTaylor,
}

impl Solver {
    /// The name in summaries.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Taylor => Method::Taylor.name(),
            Self::Dop853 => Method::Dop853.name(),
            Self::Splitting { order, step } => Method::Splitting { order, step }.name(),
            Self::Collocation => "collocation",
            Self::CollocationAndTaylor => "collocation+taylor",
        }
    }

    /// The name in a text for people.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Taylor => Method::Taylor.title(),
            Self::Dop853 => Method::Dop853.title(),
            Self::Splitting { order, step } => Method::Splitting { order, step }.title(),
            Self::Collocation => "collocation",
            Self::CollocationAndTaylor => "collocation and Taylor's method",
        }
    }
}
