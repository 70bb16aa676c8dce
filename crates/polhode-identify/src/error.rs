//! Errors of the identification.

use core::fmt;

use polhode::body::BodyError;
use polhode::motion::MotionError;

/// Reason for a missing estimate.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum IdentifyError {
    /// Input value outside its range.
    Value {
        /// Name of the quantity.
        what: &'static str,
        /// Value as entered.
        value: f64,
        /// Requirement on the value, such as `above zero`.
        rule: &'static str,
    },
    /// Fewer measurements than unknown parameters require.
    TooFew {
        /// Name of the scarce measurements.
        what: &'static str,
        /// Number of measurements present.
        given: usize,
        /// Number of measurements required.
        needed: usize,
    },
    /// Required input that is absent.
    Missing {
        /// Name of the input.
        what: &'static str,
    },
    /// Input or estimated body that is not physically consistent.
    Body(BodyError),
    /// Failed integration of the motion model.
    Motion(MotionError),
    /// Computed quantity that is NaN or infinite.
    NotFinite {
        /// Name of the quantity.
        quantity: &'static str,
    },
    /// The same body is added in every flight, so free motion determines only ratios.
    OneBody {
        /// Number of flights, all of them with the added body.
        flights: usize,
    },
    /// Angular rates that fit free motion only in another unit.
    Unit {
        /// Factor that converts the readings to the other unit.
        factor: f64,
        /// Ratio of the residuals: unit as read to the other unit.
        better: f64,
    },
    /// Angular rates that fit only with an axis of the gyro reversed.
    LeftHanded {
        /// Reversed axes: `x`, `y`, `z`, `all of them`; or `one of them` if the data do not show
        /// which.
        axes: &'static str,
        /// Ratio of the residuals: axes as read to reversed axes.
        better: f64,
    },
    /// Flight with too few readings inside the gyro's range.
    Saturated {
        /// Name of the flight.
        flight: String,
        /// Number of readings inside the range.
        inside: usize,
        /// Number of all readings of the flight.
        given: usize,
    },
    /// No free motion fits, and an external torque acts during a flight.
    NotFree {
        /// Name of the flight.
        flight: String,
        /// Beginning and end of the torque-free interval, s.
        free: [f64; 2],
    },
    /// Constant rates in every flight, which determine neither moments nor bias.
    Steady {
        /// Standard deviation of the readings, rad/s; the changes of the rates are not larger.
        noise: f64,
    },
    /// Swing with growing amplitude: its damping is significantly negative.
    Growing {
        /// Name of the test.
        test: String,
        /// Kind of damping: `viscous damping` or `quadratic damping`.
        number: String,
        /// Estimated damping, in `unit`.
        value: f64,
        /// Standard deviation of the damping, in `unit`.
        sd: f64,
        /// Unit of the damping; `1` if dimensionless.
        unit: &'static str,
    },
    /// Log whose readings are all zero.
    AllZero {
        /// Measured quantity: `force`, `torque`.
        what: &'static str,
    },
    /// Least-squares iteration that did not converge.
    NoConvergence {
        /// Number of steps taken.
        steps: usize,
    },
}

impl IdentifyError {
    /// Returns a hint on how to fix the error, if there is one.
    pub fn hint(&self) -> Option<&'static str> {
        match self {
            Self::TooFew { .. } => Some("measure longer or more often, or estimate fewer parameters"),
            Self::Steady { .. } => {
                Some("throw the body so that it tumbles: about a direction that is not a principal axis")
            }
            Self::NoConvergence { .. } => Some(
                "the measurements may not determine all parameters, or noise may hide the motion: rotate faster and about more axes, or estimate fewer parameters, for example no drag and no gyro scale or skew",
            ),
            Self::NotFinite { .. } => Some("check for a wrong unit or an invalid reading"),
            Self::OneBody { .. } => Some(
                "add a flight without the added body, or with a different one; or remove `added` to get the ratios of both bodies together",
            ),
            Self::Unit { .. } => {
                Some("state the unit in the column names, or in columns = \"omega deg/s = wx wy wz\"")
            }
            Self::LeftHanded { .. } => {
                Some("reverse the sign of the axis in the log, so that the axes are right-handed")
            }
            Self::NotFree { .. } => Some(
                "state the times of each flight, [[tumble.flight]] with from and to; or write flights = \"find\"",
            ),
            Self::Saturated { .. } => Some("throw the body more slowly, or remove this flight from the plan"),
            Self::Missing { .. } => Some("state it in the plan: it has no default value"),
            Self::Body(error) => error.hint(),
            Self::Motion(error) => error.hint(),
            Self::Growing { .. } => Some(
                "write amplitudes in order of time, the largest first; instead of damping = \"both\" use \"viscous\" or \"quadratic\"",
            ),
            Self::AllZero { .. } => {
                Some("check that the sensor was connected, and that these are the right columns")
            }
            Self::Value { .. } => None,
        }
    }

    /// Checks that a number is above zero.
    pub(crate) fn above_zero(what: &'static str, value: f64) -> Result<(), Self> {
        Self::require(what, value, value > 0.0, "above zero")
    }

    /// Checks that a number is finite and satisfies a rule.
    pub(crate) fn require(
        what: &'static str,
        value: f64,
        holds: bool,
        rule: &'static str,
    ) -> Result<(), Self> {
        if holds && value.is_finite() { Ok(()) } else { Err(Self::Value { what, value, rule }) }
    }
}

impl fmt::Display for IdentifyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Value { what, value, rule } => write!(f, "{what} is {value}, but must be {rule}"),
            Self::TooFew { what, given, needed } => {
                write!(f, "too few {what}: {given}; at least {needed} are needed")
            }
            Self::Missing { what } => write!(f, "{what} is missing"),
            Self::Body(error) => error.fmt(f),
            Self::Motion(error) => error.fmt(f),
            Self::Unit { factor, better } => {
                let unit = match *factor {
                    ..0.05 => "deg/s",
                    ..1.0 => "rpm",
                    ..10.0 => "rev/s",
                    _ => "rad/s, not in deg/s",
                };
                write!(
                    f,
                    "the rates are probably in {unit}: the residuals of free motion are then {better:.0} times smaller"
                )
            }
            Self::LeftHanded { axes, better } => write!(
                f,
                "the gyro's axes are probably left-handed: with {axes} reversed, the residuals are {better:.0} times smaller"
            ),
            Self::Saturated { flight, inside, given } => write!(
                f,
                "the gyro is saturated in {flight}: only {inside} of {given} readings are inside its range"
            ),
            Self::NotFree { flight, free: [from, to] } => write!(
                f,
                "no free motion fits {flight}: an external torque, such as of a hand, acts on the body, except between {from:.3} and {to:.3} s"
            ),
            Self::Steady { noise } => write!(
                f,
                "the rates of every flight are constant within their noise, {noise:.2e} rad/s, as for a sphere or rotation about a principal axis. \
                 Constant rates determine neither the moments nor the gyro's bias"
            ),
            Self::Growing { test, number, value, sd, unit } => {
                let unit = if *unit == "1" { String::new() } else { format!("\u{a0}{unit}") };
                write!(
                    f,
                    "the {number} of “{test}” is {value:.3e} ± {sd:.1e}{unit}, {:.0} standard deviations below zero: an amplitude does not grow by itself",
                    -value / sd
                )
            }
            Self::AllZero { what } => write!(f, "every {what} in the log is zero"),
            Self::NotFinite { quantity } => write!(f, "{quantity} is NaN or infinite"),
            Self::OneBody { flights: 1 } => {
                write!(
                    f,
                    "one flight with an added body determines only the ratios of the moments of both together"
                )
            }
            Self::OneBody { flights } => write!(
                f,
                "{flights} flights with the same added body determine only the ratios of the moments of both together"
            ),
            Self::NoConvergence { steps } => {
                write!(f, "the least-squares fit did not converge in {steps} steps")
            }
        }
    }
}

impl std::error::Error for IdentifyError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Body(error) => Some(error),
            Self::Motion(error) => Some(error),
            _ => None,
        }
    }
}

impl From<BodyError> for IdentifyError {
    fn from(error: BodyError) -> Self {
        Self::Body(error)
    }
}

impl From<MotionError> for IdentifyError {
    fn from(error: MotionError) -> Self {
        Self::Motion(error)
    }
}
