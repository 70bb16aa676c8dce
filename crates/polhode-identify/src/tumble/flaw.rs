//! Flaws in the readings of flights that do not prevent an estimate.

use core::fmt;

use super::range::Reached;

/// Flaw in the readings of flights.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Flaw {
    /// Readings at the limit of the gyro's range, which were discarded.
    Saturated(Reached),
    /// Gap in the readings, more than three times the usual step.
    Gap {
        /// Name of the flight.
        flight: String,
        /// Time of the last reading before the gap, s.
        from: f64,
        /// Time of the first reading after the gap, s.
        to: f64,
    },
    /// External torque at the beginning or end of a flight: it was thrown later, or caught earlier.
    Hand {
        /// Name of the flight.
        flight: String,
        /// Beginning and end of the torque-free interval, s.
        free: [f64; 2],
        /// Times of the first and last reading, s.
        given: [f64; 2],
    },
}

impl fmt::Display for Flaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Saturated(Reached { axis, limit, count, flight, time }) => {
                let axis = ["x", "y", "z"].get(*axis).copied().unwrap_or_default();
                write!(
                    f,
                    "gyro axis {axis} is saturated at {limit:.4} rad/s ({:.1} deg/s) in {count} readings, the first at {time:.3} s ({flight}): these readings were not used",
                    limit.to_degrees()
                )
            }
            Self::Gap { flight, from, to } => {
                write!(f, "{flight} has no readings between {from:.3} and {to:.3} s")
            }
            Self::Hand { flight, free, given } => {
                let [begins, ends] = [free[0] > given[0], free[1] < given[1]];
                write!(f, "{flight} is not free motion ")?;
                match (begins, ends) {
                    (true, true) => write!(f, "before {:.3} and after {:.3} s", free[0], free[1])?,
                    (true, false) => write!(f, "before {:.3} s", free[0])?,
                    _ => write!(f, "after {:.3} s", free[1])?,
                }
                write!(
                    f,
                    ": an external torque, such as of a hand, acts on the body there; shorten the flight with from and to"
                )
            }
        }
    }
}
