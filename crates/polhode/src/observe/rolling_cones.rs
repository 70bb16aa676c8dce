//! Rolling cones: the two cones that ω sweeps, for any body.

use crate::math::frame::{Body, Space};
use crate::math::vector::quantity;
use crate::motion::model::state::State;
use crate::motion::solve::free::FreeMotion;

use super::curve::{Curve, CurveError};
use super::sampling::{Span, allowed, largest_rate};

/// Body cone and space cone as rulings at common times: ω along body axes and along space axes.
///
/// Both cones have their apex at the fixed point of the body. At the time of ruling k, the body
/// cone, rotated by the attitude, touches the space cone along ruling k of both:
/// attitude · body\[k\] = space\[k\]. It rolls without slipping, because dω/dt is the same vector
/// in the body and in space: ω × ω = 0. [`Curve::fan`] returns the triangles.
///
/// The rim of the body cone is the polhode, closed after a period; that of the space cone is the
/// herpolhode at its height. The cones of a symmetric top are circular; [`crate::observe::Cones`]
/// has their angles. A permanent rotation has one ruling. On the separatrix both are cut off near
/// the intermediate axis and near L, like [`crate::observe::Polhode`].
///
/// # Accuracy
/// The rulings are states of [`FreeMotion::at`]. The chords of both rims are within the tolerance,
/// relative to the largest |ω|.
///
/// ```
/// use polhode::math::{AngularVelocity, Attitude};
/// use polhode::motion::{FreeMotion, State};
/// use polhode::observe::RollingCones;
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.5, 1.0, -0.7) };
/// let motion = FreeMotion::of_moments([1.0, 2.0, 3.0], start)?;
/// let cones = RollingCones::of(&motion, 2.0, 1e-3)?;
/// let k = 50;
/// let state = motion.at(cones.body.times()[k]);
/// assert!((state.attitude * cones.body.points()[k] - cones.space.points()[k]).norm() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Poinsot's construction: Goldstein, Classical Mechanics, §5.6; Klein & Sommerfeld, Über die
/// Theorie des Kreisels, ch. I.
#[derive(Clone, Debug, PartialEq)]
pub struct RollingCones {
    /// Angular velocity ω along body axes, rad/s.
    pub body: Curve<quantity::AngularVelocity, Body>,
    /// Angular velocity ω along space axes, rad/s, at the same times.
    pub space: Curve<quantity::AngularVelocity, Space>,
}

impl RollingCones {
    /// Computes the cones over `periods` periods of ω from the start; `tolerance` is 1e-10 … 0.1.
    ///
    /// The number of periods is not used for a separatrix or a permanent rotation.
    ///
    /// # Errors
    /// The errors of [`crate::observe::Herpolhode::of`].
    pub fn of(motion: &FreeMotion, periods: f64, tolerance: f64) -> Result<Self, CurveError> {
        let Some(span) = Span::of(motion, periods, motion.precession_rate().abs(), tolerance)? else {
            let start = motion.start();
            let body = Curve::point(start.time, start.omega, tolerance);
            return Ok(Self { body, space: Curve::point(start.time, start.omega_space(), tolerance) });
        };
        let largest = largest_rate(motion);
        let paths =
            |state: &State| [(state.omega / largest).to_array(), (state.omega_space() / largest).to_array()];
        let sampling = span.sample(|time| motion.at(time), paths, [allowed(tolerance, 1.0); 2])?;
        let [in_body, in_space] = sampling.errors.map(|error| [largest, tolerance, error]);
        Ok(Self {
            body: Curve::through(&sampling.states, span.closed, in_body, |state| state.omega),
            space: Curve::through(&sampling.states, false, in_space, State::omega_space),
        })
    }
}
