//! A force fixed to the body.

use super::model::Model;
use crate::math::algebra::VectorAlgebra;
use crate::math::frame::Body;
use crate::math::vector::{Force, Position};
use crate::motion::model::law::{Law, LawInput};

/// Thruster: a force along body axes at a point of the body, N = (r − c) × F. c is the point about
/// which the body turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thruster {
    /// Point r at which the force acts, body axes, m.
    pub position: Position<Body>,
    /// Force F, body axes, N.
    pub force: Force<Body>,
}

impl Law for Thruster {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        if let Some(point) = at.moving_point() {
            let arm = at.in_body(self.position.as_quantity()) - point;
            return arm.cross(at.in_body(self.force.as_quantity()));
        }
        let arm = self.position - at.rotor().point();
        at.moment_parameters(0, [arm.as_quantity(), self.force.as_quantity()])
    }

    fn parameters(&self) -> &'static [&'static str] {
        &["position.x", "position.y", "position.z", "force.x", "force.y", "force.z"]
    }
}

impl Model for Thruster {
    fn name(&self) -> &'static str {
        "thruster"
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{InertiaTensor, MassProperties};
    use crate::math::{AngularVelocity, Attitude, Torque};
    use crate::motion::model::rotor::Rotor;
    use crate::motion::model::state::State;

    #[test]
    fn a_force_turns_about_the_centre_of_mass_or_about_the_pivot() {
        let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
        let body = MassProperties::new(2.3, Position::new(0.5, -0.25, 1.0), inertia).unwrap();
        let thruster =
            Thruster { position: Position::new(1.5, 0.75, -1.0), force: Force::new(2.0, -3.0, 5.0) };
        // (1, 1, −2) × (2, −3, 5) and (2, −1, 3) × (2, −3, 5), by hand
        let pivot = Position::new(-0.5, 1.75, -4.0);
        let state = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::ZERO };
        assert_eq!(thruster.at(&Rotor::free(&body), &state), Torque::new(-1.0, -9.0, -5.0));
        assert_eq!(thruster.at(&Rotor::pivoted(&body, pivot), &state), Torque::new(4.0, -4.0, -4.0));
    }
}
