//! Computation methods, and their names.

use super::propagate::splitting::SplittingOrder;

/// Method of computing a motion.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[non_exhaustive]
pub enum Method {
    /// Closed form if there is one, Taylor's method otherwise. The choice does not depend on the
    /// requested times, so a state does not depend on what else is computed.
    ///
    /// Preparation of a closed form takes 3 µs (free motion), 5 µs (pendulum) or 33 µs (top). A
    /// single short step from each new start, as in control, takes 1 µs with [`Method::Taylor`].
    #[default]
    Auto,
    /// Closed form; an error if there is none.
    Exact,
    /// Numerical integration by Taylor's method, order 24 at the tightest tolerance.
    Taylor,
    /// Numerical integration by the Runge–Kutta method of Dormand and Prince, order 8 (DOP853).
    Dop853,
    /// Splitting with constant step: exact free motions alternate with impulses by the torques.
    ///
    /// The torques must depend on attitude and time only. If they have a potential, the error of
    /// T + U stays bounded.
    Splitting {
        /// Order of the scheme.
        order: SplittingOrder,
        /// Step length, s.
        step: f64,
    },
}

impl Method {
    /// Returns the name of the method for people.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Auto => "the method that suits",
            Self::Exact => "closed form",
            Self::Taylor => "Taylor's method",
            Self::Dop853 => "DOP853",
            Self::Splitting { .. } => "splitting",
        }
    }

    /// Returns the name used in scenario files and summaries.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Exact => "exact",
            Self::Taylor => "taylor",
            Self::Dop853 => "dop853",
            Self::Splitting { .. } => "splitting",
        }
    }
}
