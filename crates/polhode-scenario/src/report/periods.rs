//! Periods of precession and rotation of a free motion, in the convention of its own mode.

use std::f64::consts::TAU;

use polhode::motion::{FreeMotion, Regime};
use polhode::observe::{AxisConvention, Cones, SymmetricTop, TumblingPeriods};

/// Mean period of precession about L of the axis that L circles, and period of rotation of the body
/// about that axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Periods {
    /// Period of the axis about L, s; `None` if the motion has no precession.
    pub precession: Option<f64>,
    /// Period of the body about the axis, s; in a permanent rotation, period of the body.
    pub rotation: Option<f64>,
}

impl Periods {
    /// Returns the periods of a motion. A permanent rotation has no precession; the separatrix and
    /// a body at rest have neither period.
    pub fn of(motion: &FreeMotion) -> Self {
        let turn = |rate: f64| (rate != 0.0).then(|| TAU / rate.abs());
        let (precession, rotation) = match motion.regime() {
            Regime::Permanent(_) => (None, turn(motion.start().omega.norm())),
            Regime::Symmetric => {
                let cones = SymmetricTop::of_motion(motion).map(|top| Cones::of(&top));
                (cones.and_then(|c| turn(c.space_rate)), cones.and_then(|c| turn(c.body_rate)))
            }
            Regime::LongAxis => tumbling(motion, AxisConvention::LongAxis),
            Regime::ShortAxis => tumbling(motion, AxisConvention::ShortAxis),
            Regime::AtRest | Regime::Separatrix => (None, None),
        };
        Self { precession, rotation }
    }
}

fn tumbling(motion: &FreeMotion, convention: AxisConvention) -> (Option<f64>, Option<f64>) {
    let periods = TumblingPeriods::of(motion, convention);
    (periods.map(|p| p.precession), periods.map(|p| p.rotation))
}
