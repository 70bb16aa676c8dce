//! The two cones that ω sweeps, of any body.

use crate::math::frame::{Body, Space};
use crate::math::vector::quantity;
use crate::motion::model::state::State;
use crate::motion::solve::free::FreeMotion;

use super::curve::{Curve, CurveError};
use super::sampling::{Span, allowed, largest_rate};

/// The body cone and the space cone as rulings at common times: ω in the body and in space.
///
/// Both have their apex in the point that the body turns about. At the time of ruling k the body cone, carried by the
/// attitude, touches the space cone along ruling k of both: attitude · body\[k\] = space\[k\]. It rolls there without slipping,
/// since dω/dt is the same vector in the body and in space: ω × ω = 0. [`Curve::fan`] has the triangles.
///
/// The rim of the body cone is the polhode, closed after a period; that of the space cone is the herpolhode at its
/// height. Cones of a symmetric top are circular, and [`crate::observe::Cones`] has their angles. A permanent rotation has one ruling.
/// On the separatrix both are cut off near the intermediate axis and near L, as [`crate::observe::Polhode`] is.
///
/// # Accuracy
/// Rulings are states of [`FreeMotion::at`]; chords of both rims keep within the tolerance, relative to the largest |ω|.
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
/// Poinsot's construction: Goldstein, Classical Mechanics, §5.6; Klein & Sommerfeld, Über die Theorie des Kreisels, ch. I.
#[derive(Clone, Debug, PartialEq)]
pub struct RollingCones {
    /// ω along body axes, rad/s.
    pub body: Curve<quantity::AngularVelocity, Body>,
    /// ω along space axes, rad/s, at the same times.
    pub space: Curve<quantity::AngularVelocity, Space>,
}

impl RollingCones {
    /// The cones as far as they roll in so many periods of ω from the start; tolerance 1e-10 … 0.1.
    ///
    /// The number of periods does not matter to a separatrix and to a permanent rotation.
    ///
    /// # Errors
    /// As [`crate::observe::Herpolhode::of`].
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
