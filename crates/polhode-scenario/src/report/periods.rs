//! The two periods of a free motion, each in the convention of its own mode.

use std::f64::consts::TAU;

use polhode::motion::{FreeMotion, Regime};
use polhode::observe::{AxisConvention, Cones, SymmetricTop, TumblingPeriods};

/// How long the axis that L circles takes about L, on average, and how long the body takes about that axis, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Periods {
    /// Of the axis about L; of a motion that has one.
    pub precession: Option<f64>,
    /// Of the body about the axis; of a permanent rotation, of the body.
    pub rotation: Option<f64>,
}

impl Periods {
    /// Those of a motion; a permanent rotation has no precession, the separatrix and a body at rest have neither.
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
