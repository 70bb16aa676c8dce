//! Balls that roll in a bowl or on another ball: equivalent to a heavy top.

use super::{ROUNDING_OF_SIZE, even_ball};
use crate::body::inertia::InertiaTensor;
use crate::body::mass_properties::MassProperties;
use crate::math::frame::{Body, Space};
use crate::math::rotation::Rotation;
use crate::math::vector::{Acceleration, AngularVelocity, Direction, Position};
use crate::motion::contact::{Contact, ContactState, GroundShape, GroundSide};
use crate::motion::error::MotionError;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::UniformGravity;
use crate::motion::solve::heavy_top::HeavyTop;

/// Ball with its centre of mass at its centre and three equal moments I that rolls without slip
/// inside or on a sphere at rest.
///
/// Let e be the unit vector from the centre of the sphere to that of the ball, and l the distance.
/// The relations v = l ė and I ω̇ = r × F make ω · n constant, and with k = I/(m a²):
///
/// (1 + k) m l² e × ë + k m l a (ω · n) ė = l e × m g
///
/// This is the equation of a symmetric top with A = (1 + k) m l² and C ω₃ = k m l a (ω · n) whose
/// pivot is the centre of the sphere. The ball is therefore a spherical pendulum with the factor
/// 1 + k in the inertia, and the spin about the normal acts like the spin of a top. Small swings
/// have ω₀² = g/((1 + k) l), and their plane precesses.
///
/// Source: E. J. Routh, Dynamics of a System of Rigid Bodies, Advanced Part (1905), art. 222;
/// derived here as above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallInBowl {
    /// Mass m, kg.
    pub mass: f64,
    /// Radius a, m.
    pub radius: f64,
    /// Moment of inertia I about the centre, kg·m².
    pub moment: f64,
    /// Distance l from the centre of the sphere to that of the ball, m.
    pub distance: f64,
    /// Gravitational acceleration g, space axes, m/s².
    pub gravity: Acceleration<Space>,
    /// Side of the sphere: inside or outside.
    pub side: GroundSide,
}

impl BallInBowl {
    /// Returns the ball that a body on the ground is; `None` if it is not such a ball.
    pub fn of(body: &MassProperties<Body>, contact: &Contact) -> Option<Self> {
        let (radius, moment) = even_ball(body, contact)?;
        let GroundShape::Sphere { radius: bowl, side } = *contact.ground.shape() else { return None };
        let distance = if side == GroundSide::Inside { bowl - radius } else { bowl + radius };
        (contact.ground.turning() == 0.0 && distance > ROUNDING_OF_SIZE * bowl).then(|| Self {
            mass: body.mass(),
            radius,
            moment,
            distance,
            gravity: contact.gravity,
            side,
        })
    }

    /// Returns k = I/(m a²).
    pub fn ratio(&self) -> f64 {
        self.moment / (self.mass * self.radius * self.radius)
    }

    /// Returns ω₀ of small swings without spin about the normal, rad/s.
    pub fn small_frequency(&self) -> f64 {
        (self.gravity.norm() / ((1.0 + self.ratio()) * self.distance)).sqrt()
    }

    /// Returns the heavy top whose axis moves like the centre of the rolling ball.
    ///
    /// # Errors
    /// The errors of [`HeavyTop::of`].
    pub fn top(&self, sample: &ContactState) -> Result<HeavyTop, MotionError> {
        let size = self.distance;
        let axis: Direction<Space> =
            sample.center.direction().ok_or(MotionError::NotFinite { time: sample.state.time })?;
        let velocity: Direction<Space> = (sample.velocity * (1.0 / size)).as_quantity();
        let normal = sample.state.attitude * sample.state.omega;
        let spin = sample.normal.dot(normal) * self.radius / size;
        let omega: AngularVelocity<Space> = (axis.cross(velocity) + axis * spin).as_quantity();
        let attitude = along(axis);
        // Three equal moments k m l² about its own centre give C = k m l² and A = C + m l².
        let moment = self.ratio() * self.mass * size * size;
        let inertia = InertiaTensor::diagonal([moment; 3])
            .map_err(|_| MotionError::NotFinite { time: sample.state.time })?;
        let body = MassProperties::new(self.mass, Position::new(0.0, 0.0, size), inertia)
            .map_err(|_| MotionError::NotFinite { time: sample.state.time })?;
        let state = State { time: sample.state.time, attitude, omega: attitude.inverse() * omega };
        HeavyTop::of(
            &Rotor::pivoted(&body, Position::ZERO),
            &UniformGravity { acceleration: self.gravity },
            state,
        )
    }
}

/// Returns an attitude whose third axis is this one.
fn along(axis: Direction<Space>) -> Rotation<Space, Body> {
    let first =
        if axis.x.abs() < 0.6 { Direction::new(1.0, 0.0, 0.0) } else { Direction::new(0.0, 1.0, 0.0) };
    let x = axis.cross(first).direction().unwrap_or(first);
    Rotation::from_axes([x, axis.cross(x), axis])
}
