//! Steady motions of a body on level ground, and their stability.

mod ball_in_bowl;
mod ball_on_plane;
mod circling_disk;
mod rattleback;
mod search;
mod spinning_egg;
mod stable_spins;
mod tippe_top;
mod upright;
mod vertex;

pub use ball_in_bowl::BallInBowl;
pub use ball_on_plane::{BallOnPlane, SlipEnd};
pub use circling_disk::CirclingDisk;
pub use rattleback::{RattleMode, Rattleback};
pub use spinning_egg::SpinningEgg;
pub use stable_spins::{SpinInterval, StableSpins};
pub use tippe_top::{EndState, Place, TippeTop};
pub use upright::UprightWheel;
pub use vertex::VertexSpin;

use crate::body::mass_properties::MassProperties;
use crate::math::complex::Complex;
use crate::math::eigenvalues::{Matrix, eigenvalues};
use crate::math::frame::{Body, Space};
use crate::math::vector::{AngularVelocity, Direction};
use crate::motion::contact::reduced::{MOST, Reading, Reduced};
use crate::motion::contact::{Contact, ContactStart, Footing, GroundShape, SurfaceShape};
use crate::motion::error::MotionError;

/// Kind of steady motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SteadyPath {
    /// A symmetric body with a level axis rolls, or slides, straight on.
    RollingUpright(UprightWheel),
    /// A symmetric body with a level axis spins about the vertical.
    SpinningUpright(UprightWheel),
    /// A body spins about the vertical on a point below its centre of mass.
    OnVertex(VertexSpin),
    /// A symmetric ball rotates about the vertical at a tilt, without slip, with its centre of mass
    /// at rest.
    Tilted,
    /// A symmetric body moves in a circle at a constant tilt.
    Circling,
}

impl SteadyPath {
    /// Returns its name in JSON.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::RollingUpright(_) => "rolling_upright",
            Self::SpinningUpright(_) => "spinning_upright",
            Self::OnVertex(_) => "on_vertex",
            Self::Tilted => "tilted",
            Self::Circling => "circling",
        }
    }
}

/// Mode of small deviations: e^(σ t) cos ϖt.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SteadyMode {
    /// Frequency ϖ ≥ 0, rad/s, seen from the body, or for a symmetric body from axes that follow
    /// its tilt only.
    pub frequency: f64,
    /// Growth rate σ, 1/s.
    pub growth_rate: f64,
}

/// Steady motion of a body on level ground, and its modes of small deviations.
///
/// The equations are those that [`Simulation::on_ground`](crate::motion::Simulation::on_ground)
/// integrates, in the upward vertical n along the body's axes, ω, and, with viscous friction, the
/// velocity. Their derivatives are exact. Each rate that is zero belongs to a continuous change
/// from one steady motion to another.
///
/// ```
/// use polhode::motion::contact::{BodySurface, Contact, ContactStart, SurfaceShape};
/// use polhode::observe::{SteadyOnGround, SteadyPath};
/// use polhode::prelude::*;
/// // A thin disk that rolls upright: stable beyond ω² = g/(3 r).
/// let disk = MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([0.0025, 0.0025, 0.005])?)?;
/// let rim = SurfaceShape::Rim { radius: 0.1, tube: 0.0, thickness: 0.0 };
/// let contact = Contact::rolling(BodySurface::new(rim, Position::ZERO, Rotation::identity())?);
/// let attitude = Rotation::from_axis_angle(Direction::new(1.0, 0.0, 0.0), 1.55)?; // nearly upright
/// let start = State { time: 0.0, attitude, omega: AngularVelocity::new(0.0, 0.0, 6.0) };
/// let rolls = SteadyOnGround::near(&disk, &contact, &ContactStart::rolling(start))?;
/// assert!(matches!(rolls.path, SteadyPath::RollingUpright(_)) && rolls.is_stable());
/// let threshold = rolls.stable_spins.and_then(|spins| spins.nearest(6.0)).ok_or("none")?;
/// assert!((threshold - (9.80665 / 0.3_f64).sqrt()).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SteadyOnGround {
    /// Kind of steady motion.
    pub path: SteadyPath,
    /// Kind of force along the ground.
    pub footing: Footing,
    /// Upward vertical, body axes.
    pub normal: Direction<Body>,
    /// Angular velocity ω, body axes, rad/s.
    pub omega: AngularVelocity<Body>,
    /// Spin rate, rad/s: about the body's axis if it rolls upright or circles, otherwise about the
    /// vertical.
    pub spin: f64,
    /// Axis of a symmetric body, body axes; for a ball it points away from the centre of mass.
    pub axis: Option<Direction<Body>>,
    /// Rotation angle between the start and this motion, rad.
    pub turned_from_start: f64,
    /// Difference of ω between the start and this motion, rad/s.
    pub omega_from_start: f64,
    /// Slip speed of the point of contact at the start, m/s; zero without friction, where slip has
    /// no effect.
    pub slip_at_start: f64,
    /// Modes, those with the largest growth rate first, then by frequency.
    pub modes: Vec<SteadyMode>,
    /// Number of rates that are zero.
    pub neutral: usize,
    /// Spins at which this motion is stable, if a closed form is known.
    pub stable_spins: Option<StableSpins>,
    /// Tippe top, for a symmetric ball with an off-centre centre of mass.
    pub tippe_top: Option<TippeTop>,
    /// Jellett's constant of the start, kg·m³/s, for a tippe top.
    pub jellett: Option<f64>,
}

/// Threshold below which a rate, relative to that of the motion, counts as zero. It exceeds the
/// square root of the rounding, the error of a defective pair of eigenvalues.
const NEUTRAL: f64 = 1e-6;

/// Threshold below which a relative growth rate counts as rounding.
const ROUNDING: f64 = 1e-12;

/// Relative threshold below which a length or moment counts as rounding.
const ROUNDING_OF_SIZE: f64 = 1e-9;

/// Returns a · I b about the centre of mass.
fn moment(body: &MassProperties<Body>, a: Direction<Body>, b: Direction<Body>) -> f64 {
    let (rows, a, b) = (body.inertia().matrix(), a.to_array(), b.to_array());
    (0..3).map(|i| (0..3).map(|j| a[i] * rows[i][j] * b[j]).sum::<f64>()).sum()
}

/// Returns the moments of a symmetric body perpendicular to the axis and about it, kg·m².
fn moments(body: &MassProperties<Body>, axis: Direction<Body>) -> [f64; 2] {
    let about = moment(body, axis, axis);
    let trace: f64 = (0..3).map(|k| body.inertia().matrix()[k][k]).sum();
    [0.5 * (trace - about), about]
}

/// Returns the radius and the moment of a sphere centred at the centre of mass with three equal
/// moments; `None` for other bodies.
fn even_ball(body: &MassProperties<Body>, contact: &Contact) -> Option<(f64, f64)> {
    let SurfaceShape::Sphere { radius } = *contact.surface.shape() else { return None };
    let rows = body.inertia().matrix();
    let middle = rows[0][0];
    let off = (contact.surface.center() - body.center_of_mass()).norm();
    let is_even = (0..3).all(|i| {
        (0..3).all(|j| {
            let want = if i == j { middle } else { 0.0 };
            (rows[i][j] - want).abs() <= ROUNDING_OF_SIZE * middle
        })
    });
    (is_even && off <= ROUNDING_OF_SIZE * radius).then_some((radius, middle))
}

/// Returns the magnitude of gravity, m/s², if the ground is a plane at rest and gravity points down
/// its normal.
fn level(contact: &Contact) -> Option<f64> {
    let (g, up): (Direction<Space>, _) =
        (Direction::from_array(contact.gravity.to_array()), contact.ground.axis());
    let is_level = (g + up * g.norm()).norm() <= ROUNDING_OF_SIZE * g.norm();
    let is_plane = matches!(contact.ground.shape(), GroundShape::Plane) && contact.ground.turning() == 0.0;
    (is_plane && is_level && g.norm() > 0.0).then(|| g.norm())
}

impl SteadyOnGround {
    /// Finds the steady motion nearest to a start.
    ///
    /// # Errors
    /// [`MotionError::NoSteadyMotion`] if there is none, or if none is known for this ground and
    /// surface.
    pub fn near(
        body: &MassProperties<Body>,
        contact: &Contact,
        start: &ContactStart,
    ) -> Result<Self, MotionError> {
        search::near(&Reduced::new(body, contact)?, contact, start)
    }

    /// Returns true if no mode grows.
    pub fn is_stable(&self) -> bool {
        self.modes.iter().all(|mode| mode.growth_rate <= 0.0)
    }

    /// Returns descriptions of the continuous changes to other steady motions, to which the zero
    /// rates belong.
    pub const fn neutral_ways(&self) -> &'static [&'static str] {
        match self.path {
            SteadyPath::OnVertex(_) => &["another spin"],
            SteadyPath::RollingUpright(_) => &["another spin", "a wide circle", "a turn about the axis"],
            SteadyPath::SpinningUpright(_) => {
                &["another spin", "rolling on a small circle", "a turn about the axis"]
            }
            SteadyPath::Circling => &["another spin", "another circle", "a turn about the axis"],
            SteadyPath::Tilted if matches!(self.footing, Footing::Viscous) => {
                &["another spin", "a turn about the axis"]
            }
            SteadyPath::Tilted => &["another spin", "a circle", "a turn about the axis"],
        }
    }

    /// Returns the modes, and the number of rates that are zero.
    fn modes(reduced: &Reduced, at: &Reading) -> Result<(Vec<SteadyMode>, usize), MotionError> {
        let (matrix, count) = reduced.linearised(at);
        let values = if count == MOST {
            eigenvalues(&matrix).map(|values| values.to_vec())
        } else {
            let part: Matrix<5> = core::array::from_fn(|i| core::array::from_fn(|j| matrix[i][j]));
            eigenvalues(&part).map(|values| values.to_vec())
        };
        let values = values.ok_or(MotionError::NotFinite { time: 0.0 })?;
        let rate = reduced.rate(at);
        let moving = |value: &&Complex<f64>| value.im >= 0.0 && value.abs() >= NEUTRAL;
        let mode = |value: &Complex<f64>| SteadyMode {
            frequency: value.im * rate,
            growth_rate: if value.re.abs() < ROUNDING { 0.0 } else { value.re * rate },
        };
        let mut modes: Vec<SteadyMode> = values.iter().filter(moving).map(mode).collect();
        modes.sort_by(|a, b| {
            b.growth_rate.total_cmp(&a.growth_rate).then(a.frequency.total_cmp(&b.frequency))
        });
        Ok((modes, values.iter().filter(|value| value.abs() < NEUTRAL).count()))
    }
}
