//! Herpolhode: the path of ω on the invariable plane.

use crate::math::frame::Space;
use crate::math::vector::{AngularVelocity, Direction, Vector, quantity};
use crate::motion::model::state::State;
use crate::motion::solve::free::FreeMotion;

use super::curve::{Curve, CurveError};
use super::sampling::{Span, allowed, largest_rate};

/// Path of ω in space. It lies in a plane perpendicular to L: the invariable plane, on which
/// Poinsot's ellipsoid rolls.
///
/// ω = `height` · `normal` + a point of the curve. The distance ρ of these points from the line
/// along L varies between the radii of the annulus, from the largest to the smallest and back,
/// twice in a period of ω. In general the curve never closes. For a symmetric top it is a circle.
/// For a permanent rotation it is one point, on the line along L. For the separatrix it is a spiral
/// from that point outward and back, in infinite time with infinitely many turns; both ends are cut
/// off where ρ is within the tolerance.
///
/// # Equations
/// ρ = |ω × L| / |L|; with ω = (a1 cn, a2 sn, a3 dn)(λt), along the labelled axes of
/// [`FreeMotion::labelled_moments`],
///
/// ρ_max = λ i2 a2 / |L|,  ρ_min = √(1 − m) λ i1 a1 / |L|,  height = 2T / |L|
///
/// # Accuracy
/// The relative error of the radii and of the height is a few ε. The points have the error of ω in
/// space, about 1e-15 |ω|. The chords are within the tolerance relative to ρ_max, except for this
/// error.
///
/// ```
/// use polhode::math::{AngularVelocity, Attitude};
/// use polhode::motion::{FreeMotion, State};
/// use polhode::observe::Herpolhode;
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.5, 0.0, 1.0) };
/// let motion = FreeMotion::of_moments([1.0, 2.0, 3.0], start)?;
/// let herpolhode = Herpolhode::of(&motion, 3.0, 1e-3)?;
/// let [least, greatest] = herpolhode.annulus;
/// for [x, y] in herpolhode.in_plane() {
///     assert!(x.hypot(y) > least - 1e-14 && x.hypot(y) < greatest + 1e-14);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Poinsot's construction: Goldstein, Classical Mechanics, §5.6. The radii follow from I
/// ω̇ = −ω × L at cn = 1 and sn = 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Herpolhode {
    /// Component of ω perpendicular to L, rad/s.
    pub curve: Curve<quantity::AngularVelocity, Space>,
    /// Smallest and largest ρ, rad/s, whether or not the curve is long enough to reach both.
    pub annulus: [f64; 2],
    /// Component of ω along L, ω · L/|L|, rad/s, constant.
    pub height: f64,
    /// Unit vector L/|L|; zero at rest.
    pub normal: Direction<Space>,
}

impl Herpolhode {
    /// Computes the herpolhode over `periods` periods of ω from the start. The tolerance of its
    /// chords is relative to ρ_max, 1e-10 … 0.1.
    ///
    /// The number of periods is not used for a separatrix or a permanent rotation.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] for a tolerance outside its range, and for periods that are not
    /// positive and finite. [`CurveError::TooManyPoints`] for more than 10⁶ points: too many
    /// periods, or ω circles L much more often in space than in the body.
    /// [`CurveError::StepTooSmall`] if the start time is so large that rounded times cannot
    /// distinguish the points.
    pub fn of(motion: &FreeMotion, periods: f64, tolerance: f64) -> Result<Self, CurveError> {
        let normal = motion.momentum().direction().unwrap_or(Direction::ZERO);
        let height = height(motion);
        let Some(span) = Span::of(motion, periods, motion.precession_rate().abs(), tolerance)? else {
            let curve = Curve::point(motion.start().time, Vector::ZERO, tolerance);
            return Ok(Self { curve, annulus: [0.0; 2], height, normal });
        };
        let across = |state: &State| -> AngularVelocity<Space> {
            let omega = state.omega_space();
            omega - normal.as_quantity() * omega.dot(normal)
        };
        let annulus = annulus(motion);
        let largest = annulus[1];
        let path = |state: &State| [(across(state) / largest).to_array()];
        let allowed = allowed(tolerance, largest_rate(motion) / largest);
        let sampling = span.sample(|time| motion.at(time), path, [allowed])?;
        let sizes = [largest, tolerance, sampling.errors[0]];
        let curve = Curve::through(&sampling.states, false, sizes, across);
        Ok(Self { curve, annulus, height, normal })
    }

    /// Returns the points as two coordinates in the plane, rad/s, seen from the tip of L. The axes
    /// are right-handed about L; the first one passes through the point farthest from the line
    /// along L.
    pub fn in_plane(&self) -> Vec<[f64; 2]> {
        let farther =
            |a: AngularVelocity<Space>, b: &AngularVelocity<Space>| if b.norm() > a.norm() { *b } else { a };
        let farthest = self.curve.points().iter().fold(Vector::ZERO, farther);
        let first = farthest.direction().unwrap_or(Direction::ZERO);
        let second = self.normal.cross(first);
        self.curve.points().iter().map(|point| [point.dot(first), point.dot(second)]).collect()
    }
}

/// Returns the smallest and the largest ρ, rad/s.
fn annulus(motion: &FreeMotion) -> [f64; 2] {
    let ([i1, i2, _], [a1, a2, _]) = (motion.labelled_moments(), motion.amplitudes());
    let (rate, momentum) = (motion.polhode_rate(), motion.momentum().norm());
    [motion.complementary_modulus() * rate * (i1 * a1 / momentum), rate * (i2 * a2 / momentum)]
}

/// Returns (i1 a1² + i3 a3²) / |L| = 2T / |L|, evaluated where cn = 1.
fn height(motion: &FreeMotion) -> f64 {
    let ([i1, _, i3], [a1, _, a3]) = (motion.labelled_moments(), motion.amplitudes());
    let momentum = motion.momentum().norm();
    if momentum == 0.0 { 0.0 } else { a1 * (i1 * a1 / momentum) + a3 * (i3 * a3 / momentum) }
}
