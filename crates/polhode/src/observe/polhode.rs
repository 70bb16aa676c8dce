//! Polhode: the path of ω in the body.

use crate::math::frame::Body;
use crate::math::vector::quantity;
use crate::motion::model::state::State;
use crate::motion::solve::free::{FreeMotion, Regime};

use super::curve::{Curve, CurveError};
use super::sampling::{Span, allowed, largest_rate};

/// Path of ω on the inertia ellipsoid ω · Iω = 2T, body axes, rad/s.
///
/// It is closed after one period. For a permanent rotation it is one point. On the separatrix it is
/// half an ellipse, from one end of the intermediate axis to the other, in infinite time. Both ends
/// are cut off where they are within the tolerance of the axis, independent of the start.
///
/// # Accuracy
/// The points are states of [`FreeMotion::at`]. The chords are within the tolerance, relative to
/// the largest |ω| (see [`Curve`]). The number of points is proportional to 1/√tolerance.
///
/// ```
/// use polhode::math::{AngularVelocity, Attitude};
/// use polhode::motion::{FreeMotion, Regime, State};
/// use polhode::observe::Polhode;
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.01, 1.0, 0.02) };
/// let motion = FreeMotion::of_moments([1.0, 2.0, 3.0], start)?;
/// let polhode = Polhode::of(&motion, 1e-3)?;
/// assert_eq!(polhode.regime, Regime::ShortAxis);
/// let omega = polhode.curve.points()[20];
/// let twice_t = omega.x.powi(2) + 2.0 * omega.y.powi(2) + 3.0 * omega.z.powi(2);
/// assert!((twice_t - 2.0 * motion.kinetic_energy()).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Poinsot's construction: Landau & Lifshitz, Mechanics, §37; Goldstein, Classical Mechanics, §5.6.
#[derive(Clone, Debug, PartialEq)]
pub struct Polhode {
    /// Angular velocity ω, body axes, rad/s.
    pub curve: Curve<quantity::AngularVelocity, Body>,
    /// Kind of free motion.
    pub regime: Regime,
}

impl Polhode {
    /// Computes the polhode of a motion. The tolerance of its chords is relative to the largest
    /// |ω|, 1e-10 … 0.1.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] for a tolerance outside its range; [`CurveError::StepTooSmall`] if
    /// the start time is so large that rounded times cannot distinguish the points.
    pub fn of(motion: &FreeMotion, tolerance: f64) -> Result<Self, CurveError> {
        let regime = motion.regime();
        let curve = match Span::of(motion, 1.0, 0.0, tolerance)? {
            Some(span) => drawn(&span, |time| motion.at(time), largest_rate(motion), tolerance)?,
            None => Curve::point(motion.start().time, motion.start().omega, tolerance),
        };
        Ok(Self { curve, regime })
    }
}

/// Computes the curve of ω over a span of time.
pub(super) fn drawn(
    span: &Span,
    at: impl Fn(f64) -> State,
    largest: f64,
    tolerance: f64,
) -> Result<Curve<quantity::AngularVelocity, Body>, CurveError> {
    let path = |state: &State| [(state.omega / largest).to_array()];
    let sampling = span.sample(at, path, [allowed(tolerance, 1.0)])?;
    let sizes = [largest, tolerance, sampling.errors[0]];
    Ok(Curve::through(&sampling.states, span.closed, sizes, |state| state.omega))
}
