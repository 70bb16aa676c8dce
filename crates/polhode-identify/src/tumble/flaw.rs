//! What may be wrong with readings of flights, though a body is found from the rest.

use core::fmt;

use super::range::Reached;

/// Something that is wrong with the readings of flights.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Flaw {
    /// The gyro's range ended: the readings there were not used.
    Saturated(Reached),
    /// No readings for three times as long as usual, or more.
    Gap {
        /// In which flight.
        flight: String,
        /// The last reading before, s.
        from: f64,
        /// The first one after, s.
        to: f64,
    },
    /// A hand turns the body at the beginning or the end of a flight: it was thrown later, or caught before.
    Hand {
        /// In which flight.
        flight: String,
        /// From when to when nothing turns it, s.
        free: [f64; 2],
        /// The first and the last reading, s.
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
                    "the gyro's {axis} is at its limit, {limit:.4} rad/s ({:.1} deg/s), in {count} readings, the first at {time:.3} s ({flight}): they were not used",
                    limit.to_degrees()
                )
            }
            Self::Gap { flight, from, to } => {
                write!(f, "{flight} has no readings between {from:.3} and {to:.3} s")
            }
            Self::Hand { flight, free, given } => {
                let [begins, ends] = [free[0] > given[0], free[1] < given[1]];
                write!(f, "{flight} is no free motion ")?;
                match (begins, ends) {
                    (true, true) => write!(f, "before {:.3} and after {:.3} s", free[0], free[1])?,
                    (true, false) => write!(f, "before {:.3} s", free[0])?,
                    _ => write!(f, "after {:.3} s", free[1])?,
                }
                write!(f, ": something else turns the body there, as a hand does; end the flight before")
            }
        }
    }
}
