//! What can be wrong with tanks and with what happens to a body over time.

use core::fmt;

use polhode::motion::MotionError;

use crate::error::BudgetError;

/// Why tanks, or what is to happen over time, cannot be.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum SequenceError {
    /// A number that cannot be.
    Value {
        /// What it is.
        what: &'static str,
        /// As it was given.
        value: f64,
        /// What it has to be.
        rule: &'static str,
    },
    /// A table of a liquid without rows, or with another number of levels.
    EmptyTable,
    /// A row that the list does not have.
    MissingRow {
        /// Where it is named.
        by: String,
        /// What is named.
        row: String,
    },
    /// A tank that there is not.
    MissingTank {
        /// What is named.
        tank: String,
    },
    /// Two tanks of one name.
    DuplicateTank {
        /// The name.
        tank: String,
    },
    /// More in a tank than it holds, or less than nothing.
    Fill {
        /// The tank.
        tank: String,
        /// What would be in it, kg.
        mass: f64,
        /// What it holds, kg.
        capacity: f64,
        /// When, s.
        time: f64,
    },
    /// A tank in a row of which there are several: which of them is filled is not known.
    Copies {
        /// The tank.
        tank: String,
        /// The row.
        row: String,
    },
    /// Something that happens to what has gone already, or a tank without the row that it stands in.
    Gone {
        /// What has gone.
        what: String,
        /// When, s.
        time: f64,
    },
    /// Two changes of the body at one time.
    Simultaneous {
        /// When, s.
        time: f64,
    },
    /// A deployment that changes the mass.
    MassChanges {
        /// When, s.
        time: f64,
        /// Before, kg.
        before: f64,
        /// After, kg.
        after: f64,
    },
    /// Everything has gone.
    Nothing {
        /// When, s.
        time: f64,
    },
    /// What is wrong with the parts list.
    Budget(BudgetError),
    /// What the motion of the body cannot take.
    Motion(MotionError),
}

impl SequenceError {
    /// What its reader may do.
    pub fn hint(&self) -> Option<&'static str> {
        match self {
            Self::Copies { .. } => Some("give each copy a row of its own, and a tank in it"),
            Self::Fill { .. } => Some("check the flow out of the tank, and what is in it at the start"),
            Self::MassChanges { .. } => {
                Some("what is dropped goes first, at a time of its own: then the rest can unfold")
            }
            Self::Budget(error) => error.hint(),
            Self::Motion(error) => error.hint(),
            _ => None,
        }
    }
}

impl fmt::Display for SequenceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Value { what, value, rule } => write!(f, "{what} is {value}, and has to be {rule}"),
            Self::EmptyTable => f.write_str("a table of a liquid has no rows, or not as many levels as rows"),
            Self::MissingRow { by, row } => {
                write!(f, "{by} names the row \"{row}\", which is not in the list")
            }
            Self::MissingTank { tank } => write!(f, "there is no tank \"{tank}\""),
            Self::DuplicateTank { tank } => write!(f, "there are two tanks \"{tank}\""),
            Self::Fill { tank, mass, capacity, time } => write!(
                f,
                "at t = {time} s there would be {mass} kg in the tank \"{tank}\", which holds {capacity} kg"
            ),
            Self::Copies { tank, row } => {
                write!(f, "the tank \"{tank}\" is in \"{row}\", of which there are several")
            }
            Self::Gone { what, time } => write!(f, "at t = {time} s \"{what}\" is not there any more"),
            Self::Simultaneous { time } => write!(f, "two changes of the body are at t = {time} s"),
            Self::MassChanges { time, before, after } => write!(
                f,
                "at t = {time} s the body takes another form, but its mass changes from {before} kg to {after} kg"
            ),
            Self::Nothing { time } => write!(f, "after t = {time} s nothing is left of the body"),
            Self::Budget(error) => error.fmt(f),
            Self::Motion(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for SequenceError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Budget(error) => Some(error),
            Self::Motion(error) => Some(error),
            _ => None,
        }
    }
}

impl From<BudgetError> for SequenceError {
    fn from(error: BudgetError) -> Self {
        Self::Budget(error)
    }
}
