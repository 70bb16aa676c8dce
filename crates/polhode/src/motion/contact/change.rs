//! What changes about a contact.

use core::convert::Infallible;
use core::fmt;

/// How a body moves on the ground, or that it has left it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ContactPhase {
    /// Its point of contact has the velocity of the ground.
    Rolling,
    /// It slips.
    Sliding,
    /// It does not touch the ground.
    Flying,
}

/// Something that changes about a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ContactChange {
    /// Friction is too small to hold the point of contact: it slips.
    Slips,
    /// The point of contact has come to rest, and friction holds it.
    Grips,
    /// Slipping stops, and goes on in another direction, as friction is too small to hold the body.
    SlipsAnew,
    /// The normal force has vanished: the body leaves the ground.
    LiftsOff,
    /// A body that has left the ground comes back: its motion ends, as the impact is not known.
    Lands,
    /// Friction stops the pivoting about the normal.
    PivotingStops,
    /// Friction is too small to hold the body from pivoting.
    Pivots,
    /// The rolling has come to rest, where rolling friction has no direction: the motion ends here.
    RollingStops,
    /// A thick disk stands on both of its rims: its motion ends, as the impact of the other one is not known.
    OtherRim,
    /// A disk lies flat, and touches with all of its rim: its motion ends.
    LiesFlat,
    /// A cylinder that lies would have to be held beyond its ends: it tips over, and its motion as one that lies ends.
    TipsOver,
    /// The body fits the ground so closely that the contact is no longer one point: its motion ends.
    Osculates,
}

impl ContactPhase {
    /// Its name in tables: `rolling`, `sliding` or `flying`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rolling => "rolling",
            Self::Sliding => "sliding",
            Self::Flying => "flying",
        }
    }
}

impl ContactChange {
    /// True if the motion is not known after it.
    pub const fn ends(self) -> bool {
        matches!(
            self,
            Self::Lands
                | Self::RollingStops
                | Self::OtherRim
                | Self::LiesFlat
                | Self::TipsOver
                | Self::Osculates
        )
    }

    /// Its name in summaries.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Slips => "slips",
            Self::Grips => "grips",
            Self::SlipsAnew => "slips anew",
            Self::LiftsOff => "lifts off",
            Self::Lands => "lands",
            Self::PivotingStops => "pivoting stops",
            Self::Pivots => "pivots",
            Self::RollingStops => "rolling stops",
            Self::OtherRim => "other rim",
            Self::LiesFlat => "lies flat",
            Self::TipsOver => "tips over",
            Self::Osculates => "osculates",
        }
    }
}

impl From<Infallible> for ContactChange {
    fn from(never: Infallible) -> Self {
        match never {}
    }
}

impl fmt::Display for ContactChange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.description())
    }
}

impl ContactChange {
    /// The change, in a sentence.
    pub const fn description(self) -> &'static str {
        match self {
            Self::Slips => "friction is too small to hold the point of contact: it slips",
            Self::Grips => "the point of contact has come to rest, and friction holds it",
            Self::SlipsAnew => "slipping stops, and goes on in another direction",
            Self::LiftsOff => "the normal force has vanished: the body leaves the ground",
            Self::Lands => "the body comes back to the ground; what an impact does is not known",
            Self::PivotingStops => "friction has stopped the pivoting about the normal",
            Self::Pivots => "friction is too small to hold the body from pivoting",
            Self::RollingStops => {
                "the rolling has come to rest; whether rolling friction holds it, or it rolls back, is not known here"
            }
            Self::OtherRim => {
                "the disk stands on both of its rims; what the impact of the other one does is not known here"
            }
            Self::LiesFlat => "the disk lies flat, and touches with all of its rim",
            Self::TipsOver => "the cylinder tips over: it would have to be held beyond its ends",
            Self::Osculates => "the body fits the ground so closely that it touches in more than a point",
        }
    }
}

/// A change of a contact, and when.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactEvent {
    /// s
    pub time: f64,
    /// What happened.
    pub change: ContactChange,
}
