//! Path of L in the body.

use crate::math::frame::Body;
use crate::math::vector::{AngularMomentum, quantity};
use crate::motion::model::state::State;
use crate::motion::solve::free::FreeMotion;

use super::curve::{Curve, CurveError};
use super::sampling::{Span, allowed};

/// Path of L = Iω on the sphere |L| = constant, body axes, kg·m²/s. It is closed, a point, or half
/// of a circle, like the polhode ([`crate::observe::Polhode`]).
///
/// ```
/// use polhode::math::{AngularVelocity, Attitude};
/// use polhode::motion::{FreeMotion, State};
/// use polhode::observe::MomentumTrace;
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.5, 1.0, -0.7) };
/// let motion = FreeMotion::of_moments([1.0, 2.0, 3.0], start)?;
/// let trace = MomentumTrace::of(&motion, 1e-3)?.curve;
/// assert!(trace.points().iter().all(|l| (l.norm() - motion.momentum().norm()).abs() < 1e-14));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MomentumTrace {
    /// Angular momentum L, body axes, kg·m²/s.
    pub curve: Curve<quantity::AngularMomentum, Body>,
}

impl MomentumTrace {
    /// Computes the path of L in the body. The tolerance of its chords is relative to |L|, 1e-10 …
    /// 0.1.
    ///
    /// # Errors
    /// The errors of [`crate::observe::Polhode::of`].
    pub fn of(motion: &FreeMotion, tolerance: f64) -> Result<Self, CurveError> {
        let largest = motion.momentum().norm();
        let momentum = |state: &State| -> AngularMomentum<Body> { motion.angular_momentum(state) };
        let Some(span) = Span::of(motion, 1.0, 0.0, tolerance)? else {
            let start = motion.start();
            return Ok(Self { curve: Curve::point(start.time, momentum(&start), tolerance) });
        };
        let path = |state: &State| [(momentum(state) / largest).to_array()];
        let sampling = span.sample(|time| motion.at(time), path, [allowed(tolerance, 1.0)])?;
        let sizes = [largest, tolerance, sampling.errors[0]];
        Ok(Self { curve: Curve::through(&sampling.states, span.closed, sizes, momentum) })
    }
}
