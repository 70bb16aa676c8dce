//! The two periods of a tumbling body, as observers of asteroids and comets give them.

use crate::math::number::PI;
use crate::motion::solve::free::FreeMotion;

/// The axis of the body whose motion about L is described.
///
/// The literature of small bodies names axes by length, and a body's longest axis is that of its *least* moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisConvention {
    /// The axis of least moment: Samarasinha & A'Hearn 1991, and most on comets.
    LongAxis,
    /// The axis of greatest moment: Kaasalainen 2001, and most on light curves of asteroids.
    ShortAxis,
}

/// P_φ and P_ψ: how long a tumbling body's axis takes about L on average, and how long the body takes about that axis.
///
/// φ is the azimuth about L, in space, of the axis that the [`AxisConvention`] names; ψ is the angle of the body about that
/// axis, from the plane that the axis makes with L. ψ and the nutation angle between L and the axis repeat with ω, so P_ψ
/// is [`FreeMotion::period`]. φ advances by the same angle in each P_ψ, on average once in P_φ:
///
/// | L circles | long-axis convention | short-axis convention |
/// |---|---|---|
/// | the axis of least moment (long-axis mode) | P_φ = 2π/Ω; ψ **rotates**, once round in P_ψ | P_φ = 2π/(Ω + 2π/P_ψ); ψ **oscillates** with the period P_ψ |
/// | the axis of greatest moment (short-axis mode) | P_φ = 2π/(Ω − 2π/P_ψ); ψ oscillates | P_φ = 2π/Ω; ψ rotates |
///
/// with Ω of [`FreeMotion::precession_rate`]. While L goes round one extreme axis in the body, the azimuths of the two
/// extreme axes fall apart by one turn; this is the whole difference between the conventions. Both azimuths always
/// grow. The intermediate axis goes with the one that L does not circle.
///
/// The same light curve may show P_φ, P_ψ, their halves, or any 1/(n/P_φ + k/P_ψ).
///
/// # Accuracy
/// A few ε of P_φ and P_ψ each, for moments and ω exactly as given. Near the separatrix both are ill-conditioned in ω.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::observe::{AxisConvention, TumblingPeriods};
/// // Toutatis: long axis along z, moments relative to the least, deg/day (Takahashi, Busch & Scheeres 2013)
/// let unit = std::f64::consts::PI / 180.0 / 86_400.0;
/// let omega = AngularVelocity::new(14.51, 33.529, -98.709) * unit;
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega };
/// let motion = FreeMotion::of_moments([3.0836, 3.235, 1.0], start)?;
/// let periods = TumblingPeriods::of(&motion, AxisConvention::LongAxis).ok_or("it does not tumble")?;
/// assert!((periods.precession / 86_400.0 - 7.41).abs() < 0.005);
/// assert!((periods.rotation / 86_400.0 - 5.37).abs() < 0.005);
/// assert!(periods.ratio() < 1.0); // so it is in long-axis mode
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Samarasinha & A'Hearn, Icarus 93 (1991) 194; Kaasalainen, Astron. Astrophys. 376 (2001) 302. The relation between the
/// conventions is derived above and tested by following the axes through whole motions (`tests/all/tumbling.rs`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TumblingPeriods {
    /// P_φ: the mean time of one turn of the axis about L, in space, s.
    pub precession: f64,
    /// P_ψ: the period of the rotation or oscillation about the axis, which is that of ω in the body, s.
    pub rotation: f64,
}

impl TumblingPeriods {
    /// The periods of a motion.
    ///
    /// `None` where ω does not circle: at rest, in permanent rotation (which has one period only, 2π/|ω|; [`Self::ratio`] says
    /// where the two end there), of a body with three equal moments, and on the separatrix, where P_ψ is infinite.
    ///
    /// A symmetric body has one determined axis, which L circles. The convention that does not mean this axis means
    /// any axis across it: they all go round L with the same mean rate.
    pub fn of(motion: &FreeMotion, convention: AxisConvention) -> Option<Self> {
        let rotation = motion.period()?;
        let turns = f64::from(convention.turns_ahead(motion.circles_least()));
        let rate = motion.precession_rate() + turns * (2.0 * PI / rotation);
        Some(Self { precession: 2.0 * PI / rate, rotation })
    }

    /// P_ψ/P_φ: turns of the axis about L, on average, in one period of ω.
    ///
    /// For given principal moments it tells the state of spin up to its scale: within each mode it grows steadily from
    /// the permanent rotation to the separatrix, where it is infinite. In the long-axis convention it is
    /// above 1/√((i3/i1 − 1)(i3/i2 − 1)) ≥ 1 in short-axis mode, and above 1/√((1 − i1/i2)(1 − i1/i3)) − 1 > 0 in long-axis
    /// mode: below 1 the mode is the long-axis mode for certain. In the short-axis convention both are greater by 1.
    pub fn ratio(&self) -> f64 {
        self.rotation / self.precession
    }
}

impl AxisConvention {
    /// By how many turns in a period of ω the convention's axis gets ahead of the one that L circles.
    pub(super) const fn turns_ahead(self, circles_least: bool) -> i8 {
        match (self, circles_least) {
            (Self::LongAxis, true) | (Self::ShortAxis, false) => 0,
            (Self::ShortAxis, true) => 1,
            (Self::LongAxis, false) => -1,
        }
    }
}
