//! Uniform gravity on a body held at a pivot.

use super::model::Model;
use crate::math::algebra::VectorAlgebra;
use crate::math::frame::Space;
use crate::math::rotation::Attitude;
use crate::math::vector::Acceleration;
use crate::motion::model::law::{Law, LawInput};
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// Uniform gravity: N = l × M g, with l from the pivot to the centre of mass; U = −M g · l.
///
/// The lever of a free body is zero, and so is the torque.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UniformGravity {
    /// g in space axes, m/s²; downward is usually −z.
    pub acceleration: Acceleration<Space>,
}

impl Law for UniformGravity {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        if let Some(moment) = at.moving_moment() {
            return moment.cross(at.in_space(self.acceleration.as_quantity()));
        }
        let weight = at.space_parameters(0, self.acceleration.as_quantity()).scaled(at.rotor().mass());
        at.body_parameters(3, at.rotor().lever().as_quantity()).cross(weight)
    }

    fn parameters(&self) -> &'static [&'static str] {
        &["x", "y", "z", "lever.x", "lever.y", "lever.z"]
    }
}

impl UniformGravity {
    /// Standard gravity 9.80665 m/s² along −z (3rd CGPM, 1901).
    pub const STANDARD: Self = Self { acceleration: Acceleration::new(0.0, 0.0, -9.80665) };

    /// Returns U = −M g · l, J. It is zero when the centre of mass is level with the pivot.
    pub fn potential(&self, rotor: &Rotor, attitude: Attitude) -> f64 {
        -rotor.mass() * self.acceleration.dot(attitude * rotor.lever())
    }
}

impl Model for UniformGravity {
    fn name(&self) -> &'static str {
        "gravity"
    }

    fn potential(&self, rotor: &Rotor, state: &State) -> Option<f64> {
        Some(self.potential(rotor, state.attitude))
    }

    fn scale(&self, rotor: &Rotor, _: &State) -> f64 {
        rotor.mass() * self.acceleration.norm() * rotor.lever().norm()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{InertiaTensor, MassProperties};
    use crate::math::Position;
    use crate::math::frame::Body;
    use crate::math::rotation::Rotation;
    use crate::math::vector::{Direction, Vector};

    #[test]
    fn the_torque_is_minus_the_gradient_of_the_potential() {
        let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
        let body = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap();
        let rotor = Rotor::pivoted(&body, Position::new(-0.4, 0.9, 0.2));
        let gravity = UniformGravity { acceleration: Acceleration::new(1.1, -2.2, -8.7) };
        let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
        // dU = −N · dθ for a rotation dθ about each body axis
        let h = 1e-5;
        let slope = |n: Direction<Body>| {
            let turned = |angle: f64| attitude * Rotation::<Body, Body>::turn(n, angle);
            (gravity.potential(&rotor, turned(h)) - gravity.potential(&rotor, turned(-h))) / (2.0 * h)
        };
        let x = slope(Vector::new(1.0, 0.0, 0.0));
        let y = slope(Vector::new(0.0, 1.0, 0.0));
        let z = slope(Vector::new(0.0, 0.0, 1.0));
        let state = State { time: 0.0, attitude, omega: Vector::ZERO };
        assert!((gravity.at(&rotor, &state) + Vector::new(x, y, z)).norm() < 1e-8);
    }
}
