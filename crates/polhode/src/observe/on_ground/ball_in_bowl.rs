//! Balls that roll in a bowl, or on another ball: each is a heavy top.

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

/// A ball with its centre of mass in its middle and three equal moments I that rolls without slipping on a sphere at rest, in it or on it.
///
/// With e from the middle of the sphere to that of the ball, at the distance l, v = l ė and I ω̇ = r × F make ω · n constant, and, with k = I/(m a²),
///
/// (1 + k) m l² e × ë + k m l a (ω · n) ė = l e × m g:
///
/// the equation of a symmetric top with A = (1 + k) m l² and C ω₃ = k m l a (ω · n) that is held at the middle of the sphere. So it is a spherical pendulum but for k, and the spin about the
/// normal does what a top's spin does: small swings are at ω₀² = g/((1 + k) l), and turn.
///
/// Source: E. J. Routh, Dynamics of a System of Rigid Bodies, Advanced Part (1905), art. 222; derived here as above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallInBowl {
    /// m, kg
    pub mass: f64,
    /// a, m
    pub radius: f64,
    /// I, kg·m²
    pub moment: f64,
    /// l, m: from the middle of the sphere to that of the ball.
    pub distance: f64,
    /// g, m/s²
    pub gravity: Acceleration<Space>,
    /// Whether it is in the sphere or on it.
    pub side: GroundSide,
}

impl BallInBowl {
    /// The ball that a body on the ground is.
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

    /// k = I/(m a²)
    pub fn ratio(&self) -> f64 {
        self.moment / (self.mass * self.radius * self.radius)
    }

    /// ω₀ of small swings without spin about the normal, rad/s.
    pub fn small_frequency(&self) -> f64 {
        (self.gravity.norm() / ((1.0 + self.ratio()) * self.distance)).sqrt()
    }

    /// The top whose axis goes as the middle of the ball does, of what rolls so.
    ///
    /// # Errors
    /// As [`HeavyTop::of`].
    pub fn top(&self, sample: &ContactState) -> Result<HeavyTop, MotionError> {
        let size = self.distance;
        let axis: Direction<Space> =
            sample.center.direction().ok_or(MotionError::NotFinite { time: sample.state.time })?;
        let velocity: Direction<Space> = (sample.velocity * (1.0 / size)).as_quantity();
        let normal = sample.state.attitude * sample.state.omega;
        let spin = sample.normal.dot(normal) * self.radius / size;
        let omega: AngularVelocity<Space> = (axis.cross(velocity) + axis * spin).as_quantity();
        let attitude = along(axis);
        // About its own middle three equal moments k m l², so that C is that and A with m l² more.
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

/// An attitude whose third axis is this one.
fn along(axis: Direction<Space>) -> Rotation<Space, Body> {
    let first =
        if axis.x.abs() < 0.6 { Direction::new(1.0, 0.0, 0.0) } else { Direction::new(0.0, 1.0, 0.0) };
    let x = axis.cross(first).direction().unwrap_or(first);
    Rotation::from_axes([x, axis.cross(x), axis])
}
