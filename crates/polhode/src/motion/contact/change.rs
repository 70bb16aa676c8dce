//! Changes of a contact.

use core::convert::Infallible;
use core::fmt;

/// State of contact of a body with the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ContactPhase {
    /// The point of contact has the velocity of the ground.
    Rolling,
    /// The point of contact slips.
    Sliding,
    /// The body does not touch the ground.
    Flying,
}

/// Change of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ContactChange {
    /// Friction cannot hold the point of contact: the body begins to slip.
    Slips,
    /// Slip has vanished and friction holds the point of contact.
    Grips,
    /// Slip vanishes and continues in another direction, as friction cannot hold the body.
    SlipsAnew,
    /// The normal force has vanished: the body leaves the ground.
    LiftsOff,
    /// A flying body reaches the ground again. The motion ends, as impacts are not modelled.
    Lands,
    /// Friction stops the pivoting about the normal.
    PivotingStops,
    /// Friction cannot prevent pivoting about the normal.
    Pivots,
    /// Rolling has stopped, where rolling friction has no direction. The motion ends.
    RollingStops,
    /// A thick disk touches with both rims. The motion ends, as the impact of the second rim is not
    /// modelled.
    OtherRim,
    /// A disk lies flat and touches along its whole rim. The motion ends.
    LiesFlat,
    /// The support of a lying cylinder would have to be beyond its ends: it tips over. The motion
    /// ends.
    TipsOver,
    /// The curvatures of body and ground agree, so that the contact is no longer a point. The
    /// motion ends.
    Osculates,
}

impl ContactPhase {
    /// Returns the name in tables: `rolling`, `sliding` or `flying`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rolling => "rolling",
            Self::Sliding => "sliding",
            Self::Flying => "flying",
        }
    }
}

impl ContactChange {
    /// Returns true if the motion after the change is not modelled.
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

    /// Returns the name in summaries.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Slips => "slips",
            Self::Grips => "grips",
            Self::SlipsAnew => "slips again",
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
    /// Returns a sentence that describes the change.
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

/// Change of a contact, with its time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactEvent {
    /// Time, s.
    pub time: f64,
    /// Kind of change.
    pub change: ContactChange,
}
