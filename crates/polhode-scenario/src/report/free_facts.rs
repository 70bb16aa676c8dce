//! Kind, periods and constants of a free motion, computed once for every report.

use std::f64::consts::PI;

use polhode::motion::{FreeMotion, Rotor, State};
use polhode::observe::{Cones, FreeRegime, SymmetricTop};
use polhode_document::number::number;

use crate::report::periods::Periods;

/// Free motion with its kind, its periods, and the constants of a symmetric top.
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

    /// Returns the facts of the free motion from `start` without torque; `None` if it has none.
    pub(crate) fn from_start(rotor: &Rotor, start: State) -> Option<Self> {
        FreeMotion::of(rotor, start).ok().map(Self::of)
    }

    /// Returns the angle between ω at the start and the line of axis 2, in degrees.
    pub(crate) fn degrees_off(&self) -> String {
        let angle = self.motion.start().omega.angle_to(self.motion.principal().axis(1));
        number(angle.min(PI - angle).to_degrees(), 3)
    }
}
