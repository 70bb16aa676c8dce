//! What a free motion is: asked of the core once, said in many places.

use polhode::motion::{FreeMotion, Rotor, State};
use polhode::observe::{Cones, FreeRegime, SymmetricTop};

use crate::report::periods::Periods;

/// A free motion, its kind, its periods, and the constants of a symmetric top.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FreeFacts {
    pub motion: FreeMotion,
    pub regime: FreeRegime,
    pub periods: Periods,
    pub top: Option<(SymmetricTop, Cones)>,
}

impl FreeFacts {
    pub(crate) fn of(motion: FreeMotion) -> Self {
        let regime = FreeRegime::of_motion(&motion);
        let top = SymmetricTop::of_motion(&motion).map(|top| (top, Cones::of(&top)));
        Self { motion, regime, periods: Periods::of(&motion), top }
    }

    /// Of the free motion that a start would have without torque; `None` if it has none.
    pub(crate) fn from_start(rotor: &Rotor, start: State) -> Option<Self> {
        FreeMotion::of(rotor, start).ok().map(Self::of)
    }
}
