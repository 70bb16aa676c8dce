//! What is not defined.

use core::fmt;

/// Why a measure has no value, or no derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Undefined {
    /// Two principal moments are equal: their axes are any in a plane, and the greater and the less have no derivative.
    EqualMoments,
    /// A distance or an angle is zero, or two axes are equally near: the measure has a corner.
    Corner,
    /// A moment that it is divided by is zero.
    ZeroMoment,
}

impl fmt::Display for Undefined {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::EqualMoments => "two principal moments are equal",
            Self::Corner => "a distance or an angle is zero, or two axes are equally near",
            Self::ZeroMoment => "a principal moment is zero",
        })
    }
}
