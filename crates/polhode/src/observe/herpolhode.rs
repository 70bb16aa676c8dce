//! The herpolhode: what ω draws on the invariable plane.

use crate::math::frame::Space;
use crate::math::vector::{AngularVelocity, Direction, Vector, quantity};
use crate::motion::model::state::State;
use crate::motion::solve::free::FreeMotion;

use super::curve::{Curve, CurveError};
use super::sampling::{Span, allowed, largest_rate};

/// The path of ω in space, which lies in a plane across L: the invariable plane, on which Poinsot's ellipsoid rolls.
///
/// ω = `height` · `normal` + a point of the curve. The distance ρ of these points from L's line goes between the radii of
/// the annulus, from the largest to the smallest and back, twice in a period of ω. In general the curve never closes. That
/// of a symmetric top is a circle. A permanent rotation has one point, on L's line. The separatrix spirals from that
/// point outwards and back, in infinite time and infinitely many turns; both ends are cut off where ρ is within the tolerance.
///
/// # Equations
/// ρ = |ω × L| / |L|; with ω = (a1 cn, a2 sn, a3 dn)(λt), along the labelled axes of [`FreeMotion::labelled_moments`],
///
/// ρ_max = λ i2 a2 / |L|,  ρ_min = √(1 − m) λ i1 a1 / |L|,  height = 2T / |L|
///
/// # Accuracy
/// Radii and height to a few ε of themselves. Points as ω in space, some 1e-15 of |ω|; chords keep within the tolerance
/// relative to ρ_max, but no nearer than the points are right.
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
/// Poinsot's construction: Goldstein, Classical Mechanics, §5.6. The radii follow from I ω̇ = −ω × L at cn = 1 and sn = 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Herpolhode {
    /// The component of ω across L, rad/s.
    pub curve: Curve<quantity::AngularVelocity, Space>,
    /// The smallest and the largest ρ, rad/s, whether or not the curve is long enough to touch both.
    pub annulus: [f64; 2],
    /// ω · L/|L|, rad/s: constant.
    pub height: f64,
    /// L/|L|; zero at rest.
    pub normal: Direction<Space>,
}

impl Herpolhode {
    /// The herpolhode of so many periods of ω from the start; the tolerance of its chords is relative to ρ_max, 1e-10 … 0.1.
    ///
    /// The number of periods does not matter to a separatrix and to a permanent rotation.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] for a tolerance outside its range and for periods that are not positive and finite;
    /// [`CurveError::TooManyPoints`] for more than 10⁶, as where ω goes round L far oftener than in the body, or for too many
    /// periods; [`CurveError::StepTooSmall`] if the start is so late that times cannot tell the points apart.
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

    /// The points as two coordinates in the plane, rad/s, seen from the tip of L: right-handed axes about it, the first of them
    /// through the point farthest from L's line.
    pub fn in_plane(&self) -> Vec<[f64; 2]> {
        let farther =
            |a: AngularVelocity<Space>, b: &AngularVelocity<Space>| if b.norm() > a.norm() { *b } else { a };
        let farthest = self.curve.points().iter().fold(Vector::ZERO, farther);
        let first = farthest.direction().unwrap_or(Direction::ZERO);
        let second = self.normal.cross(first);
        self.curve.points().iter().map(|point| [point.dot(first), point.dot(second)]).collect()
    }
}

/// The smallest and the largest ρ.
fn annulus(motion: &FreeMotion) -> [f64; 2] {
    let ([i1, i2, _], [a1, a2, _]) = (motion.labelled_moments(), motion.amplitudes());
    let (rate, momentum) = (motion.polhode_rate(), motion.momentum().norm());
    [motion.complementary_modulus() * rate * (i1 * a1 / momentum), rate * (i2 * a2 / momentum)]
}

/// (i1 a1² + i3 a3²) / |L|: 2T where cn = 1.
fn height(motion: &FreeMotion) -> f64 {
    let ([i1, _, i3], [a1, _, a3]) = (motion.labelled_moments(), motion.amplitudes());
    let momentum = motion.momentum().norm();
    if momentum == 0.0 { 0.0 } else { a1 * (i1 * a1 / momentum) + a3 * (i3 * a3 / momentum) }
}
