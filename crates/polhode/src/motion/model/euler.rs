//! Euler's equations.

use super::rotor::Rotor;
use crate::math::frame::{Body, Principal};
use crate::math::vector::{AngularAcceleration, AngularVelocity, Torque, Vector};

impl Rotor {
    /// Returns the torque that a motion requires, by Euler's equations: N = I ω̇ + ω × (I ω + h) +
    /// ḣ, in body axes.
    /// The body axes may have any direction. The wheel momentum h and the motor torque ḣ are those
    /// just after `time`, s.
    ///
    /// # Source
    /// Lecture notes, "Euler's equations for a rigid body". Their preliminary form N = I ω̇ lacks
    /// the second term. It holds only in axes that do not rotate, or if ω is along a principal
    /// axis.
    pub fn torque_for(
        &self,
        omega: AngularVelocity<Body>,
        acceleration: AngularAcceleration<Body>,
        time: f64,
    ) -> Torque<Body> {
        let momentum = self.angular_momentum(omega) + self.wheel_momentum(time);
        *self.inertia() * acceleration + omega.cross(momentum) + self.motor_torque(time)
    }

    /// Returns the angular acceleration due to a torque, by Euler's equations: ω̇ = I⁻¹ (N − ω × I
    /// ω), body axes.
    /// Wheels are not included; they add I⁻¹ (h × ω − ḣ).
    ///
    /// About an axis without inertia (the axis of a rod) the motion is undetermined; ω̇ = 0 is
    /// returned.
    pub fn acceleration(
        &self,
        omega: AngularVelocity<Body>,
        torque: Torque<Body>,
    ) -> AngularAcceleration<Body> {
        let r = self.principal().rotation();
        r * euler(self.principal().moments(), r.inverse() * omega, r.inverse() * torque)
    }
}

/// Evaluates Euler's equations in principal axes:
///
/// i1 ω̇1 = (i2 − i3) ω2 ω3 + N1,  i2 ω̇2 = (i3 − i1) ω3 ω1 + N2,  i3 ω̇3 = (i1 − i2) ω1 ω2 + N3
pub(in crate::motion) fn euler(
    [i1, i2, i3]: [f64; 3],
    w: AngularVelocity<Principal>,
    n: Torque<Principal>,
) -> AngularAcceleration<Principal> {
    let over = |numerator: f64, i: f64| if i == 0.0 { 0.0 } else { numerator / i };
    Vector::new(
        over((i2 - i3) * w.y * w.z + n.x, i1),
        over((i3 - i1) * w.z * w.x + n.y, i2),
        over((i1 - i2) * w.x * w.y + n.z, i3),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{InertiaTensor, MassProperties};
    use crate::math::{Direction, Position};
    use crate::motion::{Motor, Wheel};

    fn generic() -> Rotor {
        let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
        let body = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap();
        Rotor::pivoted(&body, Position::new(-0.4, 0.9, 0.2))
    }

    #[test]
    fn torque_and_acceleration_are_inverse_to_each_other() {
        let rotor = generic();
        let omega = Vector::new(0.7, -1.1, 0.4);
        let alpha = Vector::new(-0.3, 0.2, 0.9);
        let again = rotor.acceleration(omega, rotor.torque_for(omega, alpha, 0.0));
        assert!((again - alpha).norm() < 2e-15);
    }

    #[test]
    fn the_torque_is_the_rate_of_angular_momentum_in_space() {
        // N = dL/dt with L = R (I ω + h), by central differences along a motion with
        // ω(t) = ω0 + α t and two wheels
        let motor = Motor::Torque { inertia: 0.3, torque: 0.8, schedule: None };
        let wheels = [
            (Direction::new(0.3, -0.9, 0.4), 0.7, motor),
            (Direction::new(1.0, 0.2, -0.6), -1.1, Motor::HeldSpeed),
        ];
        let wheels = wheels.map(|(axis, momentum, motor)| Wheel::new(axis, momentum, motor).unwrap());
        let rotor = generic().with_wheels(&wheels).unwrap();
        let t = 2.5;
        let omega = AngularVelocity::new(0.7, -1.1, 0.4);
        let alpha = AngularAcceleration::new(-0.3, 0.2, 0.9);
        let h = 1e-4;
        // R(±h) to second order in h: rotation vector ±ω0 h + α h²/2
        let l = |h: f64| {
            let v = (omega * h).as_quantity() + (alpha * (0.5 * h * h)).as_quantity();
            let r = crate::math::Rotation::<crate::math::Space, Body>::from_rotation_vector(v.as_frame());
            r * (rotor.angular_momentum(omega + (alpha * h).as_quantity()) + rotor.wheel_momentum(t + h))
        };
        let rate = (l(h) - l(-h)) / (2.0 * h);
        let n = rotor.torque_for(omega, alpha, t);
        assert!((rate.as_quantity().as_frame() - n).norm() < 1e-7, "{rate:?} {n:?}");
    }
}
