//! The two periods of a tumbling body, as used for asteroids and comets.

use crate::math::number::PI;
use crate::motion::solve::free::FreeMotion;

/// Axis convention: the body axis whose motion about L is described.
///
/// The literature of small bodies names axes by their length; the longest axis is that of the
/// *smallest* moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisConvention {
    /// Axis of smallest moment: Samarasinha & A'Hearn 1991, and most work on comets.
    LongAxis,
    /// Axis of largest moment: Kaasalainen 2001, and most work on light curves of asteroids.
    ShortAxis,
}

/// Periods P_φ and P_ψ of a tumbling body: the mean period of its axis about L, and the period of
/// the body about that axis.
///
/// φ is the azimuth about L, in space, of the axis of the [`AxisConvention`]. ψ is the angle of the
/// body about that axis, from the plane of the axis and L. ψ and the nutation angle between L and
/// the axis are periodic with ω, so P_ψ is [`FreeMotion::period`]. φ advances by the same angle in
/// each P_ψ, and on average by one turn in P_φ:
///
/// | L circles the axis of | long-axis convention | short-axis convention |
/// |---|---|---|
/// | smallest moment (long-axis mode) | P_φ = 2π/Ω; ψ rotates | P_φ = 2π/(Ω + 2π/P_ψ); ψ oscillates |
/// | largest moment (short-axis mode) | P_φ = 2π/(Ω − 2π/P_ψ); ψ oscillates | P_φ = 2π/Ω; ψ rotates |
///
/// with Ω of [`FreeMotion::precession_rate`]. While L circles one extreme axis once in the body,
/// the azimuths of the two extreme axes diverge by one turn; this is the only difference between
/// the conventions. Both azimuths always increase. The intermediate axis moves with the extreme
/// axis that L does not circle.
///
/// The same light curve may show P_φ, P_ψ, their halves, or any 1/(n/P_φ + k/P_ψ).
///
/// # Accuracy
/// The relative error of P_φ and P_ψ is a few ε for exact moments and ω. Near the separatrix both
/// are ill-conditioned in ω.
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
/// Samarasinha & A'Hearn, Icarus 93 (1991) 194; Kaasalainen, Astron. Astrophys. 376 (2001) 302. The
/// relation between the conventions is derived above and tested by following the axes through whole
/// motions (`tests/all/tumbling.rs`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TumblingPeriods {
    /// P_φ: mean period of the axis about L, in space, s.
    pub precession: f64,
    /// P_ψ: period of the rotation or oscillation about the axis, which is that of ω in the body,
    /// s.
    pub rotation: f64,
}

impl TumblingPeriods {
    /// Computes the periods of a motion.
    ///
    /// Returns `None` if ω does not circle an axis:
    ///
    /// - at rest;
    /// - in permanent rotation, which has only the period 2π/|ω| ([`Self::ratio`] gives the limit
    ///   of the ratio);
    /// - for a body with three equal moments;
    /// - on the separatrix, where P_ψ is infinite.
    ///
    /// A symmetric body has one determined axis, which L circles. In the other convention, any axis
    /// perpendicular to it may be used: they all have the same mean rate about L.
    pub fn of(motion: &FreeMotion, convention: AxisConvention) -> Option<Self> {
        let rotation = motion.period()?;
        let turns = f64::from(convention.turns_ahead(motion.circles_least()));
        let rate = motion.precession_rate() + turns * (2.0 * PI / rotation);
        Some(Self { precession: 2.0 * PI / rate, rotation })
    }

    /// Returns P_ψ/P_φ, the mean number of turns of the axis about L in one period of ω.
    ///
    /// It determines, for given principal moments, the state of rotation up to its scale: within
    /// each mode it increases monotonically from the permanent rotation to the separatrix, where it
    /// is infinite. In the long-axis convention it exceeds 1/√((i3/i1 − 1)(i3/i2 − 1)) ≥ 1 in
    /// short-axis mode, and 1/√((1 − i1/i2)(1 − i1/i3)) − 1 > 0 in long-axis mode. A ratio below 1
    /// therefore means long-axis mode. In the short-axis convention both bounds are larger by 1.
    pub fn ratio(&self) -> f64 {
        self.rotation / self.precession
    }
}

impl AxisConvention {
    /// Returns the number of turns per period of ω by which the convention's axis advances relative
    /// to the axis that L circles.
    pub(super) const fn turns_ahead(self, circles_least: bool) -> i8 {
        match (self, circles_least) {
            (Self::LongAxis, true) | (Self::ShortAxis, false) => 0,
            (Self::ShortAxis, true) => 1,
            (Self::LongAxis, false) => -1,
        }
    }
}
