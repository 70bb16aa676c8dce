//! Methods: by name, and as people call them.

use super::propagate::splitting::SplittingOrder;

/// How to compute a motion.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[non_exhaustive]
pub enum Method {
    /// A closed form where there is one, Taylor's method elsewhere, whatever times are asked for: a state does not depend on what else is
    /// computed. A closed form takes 3 µs to prepare (free), 5 (a pendulum) or 33 (a top); for one short step from every new start, as in
    /// control, [`Method::Taylor`] takes 1 µs.
    #[default]
    Auto,
    /// A closed form, or an error.
    Exact,
    /// Numerical integration by Taylor's method, order 24 at the tightest tolerance.
    Taylor,
    /// Numerical integration by the Runge–Kutta method of Dormand and Prince, order 8.
    Dop853,
    /// Steps of one length: the exact free motion, with kicks by the torques between. For torques that depend on attitude and time
    /// alone; where they have a potential, the error of T + U stays bounded.
    Splitting {
        /// How fast the error falls with the step.
        order: SplittingOrder,
        /// The length of a step, s.
        step: f64,
    },
}

impl Method {
    /// The name in a text for people.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Auto => "the method that suits",
            Self::Exact => "closed form",
            Self::Taylor => "Taylor's method",
            Self::Dop853 => "DOP853",
            Self::Splitting { .. } => "splitting",
        }
    }

    /// The name in scenario files and summaries.
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
