//! Undefined values and derivatives of measures.

use core::fmt;

/// Reason why a measure has no value, or no derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Undefined {
    /// Two principal moments are equal. Their axes can have any direction in a plane, and the
    /// greater and the lesser moment have no derivative.
    EqualMoments,
    /// A distance or an angle is zero, or two axes are equally near. The measure has a kink there.
    Corner,
    /// A moment in a denominator is zero.
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
