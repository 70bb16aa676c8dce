//! Errors of the solutions by Lagrange and Hamilton.

use core::fmt;

use polhode::motion::MotionError;
use polhode_algebra::SymbolError;
use polhode_document::number::error;

/// Reason why a scenario has no solution by Lagrange's or Hamilton's equations.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum LagrangianError {
    /// The motion cannot be computed.
    Motion(MotionError),
    /// The scenario is none of the supported systems.
    NoSystem {
        /// Property of the scenario that excludes it.
        why: String,
    },
    /// An equation does not hold along the computed motion, so that the solution would be wrong.
    NotVerified {
        /// Name of the equation.
        equation: String,
        /// Largest relative residual.
        residual: f64,
        /// Time of the largest residual, s.
        time: f64,
    },
    /// Values of an equation are not finite.
    OutOfRange,
    /// Two symbols have the same name.
    Symbol(SymbolError),
}

impl LagrangianError {
    /// Returns the error of a scenario that does not fit.
    pub(super) fn because(why: impl Into<String>) -> Self {
        Self::NoSystem { why: why.into() }
    }

    /// Returns advice; empty if there is none.
    pub const fn hint(&self) -> &'static str {
        match self {
            Self::NoSystem { .. } => {
                "there is one for: a pendulum (a fixed axis under gravity); a heavy symmetric top, held at a point of its axis; a torsion pendulum; a ball, disk or cylinder that rolls along a line; \
                 a body without torque. Without this option, explain solves the other motions"
            }
            _ => "",
        }
    }
}

impl fmt::Display for LagrangianError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Motion(error) => error.fmt(f),
            Self::NoSystem { why } => write!(f, "no Lagrangian is known for this scenario: {why}"),
            Self::NotVerified { equation, residual, time } => write!(
                f,
                "{equation} does not hold along the computed motion: relative residual {} at t = {time} s",
                error(*residual)
            ),
            Self::OutOfRange => f.write_str("the numbers of the equations leave the range of f64"),
            Self::Symbol(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for LagrangianError {}

impl From<MotionError> for LagrangianError {
    fn from(error: MotionError) -> Self {
        Self::Motion(error)
    }
}

impl From<SymbolError> for LagrangianError {
    fn from(error: SymbolError) -> Self {
        Self::Symbol(error)
    }
}
