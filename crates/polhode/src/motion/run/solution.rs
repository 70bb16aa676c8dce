//! How a trajectory was found.

use crate::motion::inverse::prescribed::Prescribed;
use crate::motion::solve::closed_form::ClosedForm;
use crate::motion::solve::method::Method;
use crate::motion::solve::propagate::step_statistics::StepStatistics;
use crate::motion::solve::solver::Solver;

/// How a trajectory was found.
#[derive(Clone, Debug, PartialEq)]
pub enum Solution {
    /// In closed form.
    Exact(ClosedForm),
    /// It was given.
    Prescribed(Prescribed),
    /// By numerical integration.
    Integrated {
        /// The solver that ran.
        solver: Solver,
        /// Bound on the error of each step: attitude in rad, ω relative; `None` where steps have a given length.
        tolerance: Option<f64>,
        /// What it cost.
        statistics: StepStatistics,
    },
}

impl Solution {
    /// The name of the solver in summaries: `exact`, `prescribed`, `taylor`, `dop853`, `splitting`,
    /// `collocation` or `collocation+taylor`.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Exact(_) => Method::Exact.name(),
            Self::Prescribed(_) => "prescribed",
            Self::Integrated { solver, .. } => solver.name(),
        }
    }
}
