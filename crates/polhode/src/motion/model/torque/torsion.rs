//! A torsion spring or wire.

use super::model::Model;
use crate::math::algebra::{Scalar, VectorAlgebra};
use crate::math::frame::{Body, Space};
use crate::math::rotation::{Attitude, Rotation};
use crate::math::vector::{Direction, Torque};
use crate::motion::error::MotionError;
use crate::motion::model::law::{Law, LawInput, Values};
use crate::motion::model::require;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// A torsion spring or wire between the body and space.
///
/// Let (w, **v**) be the quaternion of the rotation from rest, w ≥ 0:
///
/// - A *spring* resists every rotation equally. θ n̂ is the rotation vector: U = ½ κ θ²,
///   N = −κ θ n̂.
/// - A *wire* along an axis ê of space resists the twist about it, ψ = 2 atan2(**v** · ê, w), and
///   no tilt: U = ½ κ ψ², N = −κ ψ **b**. Here ψ̇ = **b** · ω and
///   **b** = (w² ê + w ê × **v** + (**v** · ê) **v**)/(w² + (**v** · ê)²), with ê along the axes of
///   the body at rest.
///
/// Twists are limited to half a turn, w > 0. Beyond this, an attitude does not determine the number
/// of twists of a wire. A computed motion ends with [`MotionError::HalfTurn`] if a twist reaches
/// half a turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torsion {
    stiffness: f64,
    rest: Attitude,
    axis: Option<Direction<Space>>,
}

impl Law for Torsion {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        let (w, v) = at.turn_from(self.rest);
        let stiffness = at.parameter(0, self.stiffness);
        let Some(axis) = self.wire_at_rest() else {
            // θ n̂ = 2 (arccos w/√(1 − w²)) v
            return -(v * (w.half_angle_over_sine() * stiffness.scaled(2.0)));
        };
        // N = −κ ψ b, b = (w² ê + w ê × v + s v)/(w² + s²), s = v · ê
        let e = at.in_body(axis);
        let s = v.dot(e);
        // A body that is turned over across the axis has no twist.
        let twist_over_square = s.atan2(w).over_or_zero(w * w + s * s).scaled(2.0);
        let b = (e * w + e.cross(v)) * w + v * s;
        -(b * (twist_over_square * stiffness))
    }

    fn parameters(&self) -> &'static [&'static str] {
        &["stiffness"]
    }
}

impl Torsion {
    /// Creates a spring that resists every rotation equally. `stiffness` is in N·m/rad, and `rest`
    /// is the attitude without torque.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the stiffness is negative or not
    /// finite.
    pub fn spring(stiffness: f64, rest: Attitude) -> Result<Self, MotionError> {
        require::not_negative("the stiffness", stiffness)?;
        Ok(Self { stiffness, rest, axis: None })
    }

    /// Creates a wire along an axis of space. `stiffness` is in N·m/rad, and `rest` is an attitude
    /// without twist.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the stiffness is negative or not
    /// finite, or if the axis is zero or not finite.
    pub fn wire(stiffness: f64, rest: Attitude, axis: Direction<Space>) -> Result<Self, MotionError> {
        let spring = Self::spring(stiffness, rest)?;
        Ok(Self { axis: Some(require::direction("the length of the wire's axis", axis)?), ..spring })
    }

    /// Returns the stiffness κ, N·m/rad.
    pub const fn stiffness(&self) -> f64 {
        self.stiffness
    }

    /// Returns the attitude without twist.
    pub const fn rest(&self) -> Attitude {
        self.rest
    }

    /// Returns the unit vector of a wire's axis; `None` for a spring.
    pub const fn axis(&self) -> Option<Direction<Space>> {
        self.axis
    }

    /// Returns the twist, rad: θ of a spring, 0 … π; ψ of a wire, −π … π.
    pub fn twist(&self, attitude: Attitude) -> f64 {
        let (w, v) = self.turn(attitude);
        match self.wire_at_rest() {
            None => 2.0 * libm::atan2(v.norm(), w),
            Some(e) => 2.0 * libm::atan2(v.dot(e), w),
        }
    }

    /// Returns the potential energy U, J; zero at rest.
    pub fn potential(&self, attitude: Attitude) -> f64 {
        let twist = self.twist(attitude);
        0.5 * self.stiffness * twist * twist
    }

    /// Returns (w, v), w ≥ 0, of the rotation from rest. v has the same components along the body
    /// axes now and at rest.
    fn turn(&self, attitude: Attitude) -> (f64, Direction<Body>) {
        let turn: Rotation<Body, Body> = self.rest.inverse() * attitude;
        let [w, x, y, z] = turn.canonical_quaternion();
        (w, Direction::new(x, y, z))
    }

    /// Returns ê along the axes of the body at rest.
    fn wire_at_rest(&self) -> Option<Direction<Body>> {
        self.axis.map(|axis| self.rest.inverse() * axis)
    }
}

impl Model for Torsion {
    fn name(&self) -> &'static str {
        "torsion"
    }

    fn potential(&self, _: &Rotor, state: &State) -> Option<f64> {
        Some(self.potential(state.attitude))
    }

    /// The bound for a wire holds unless the body is tilted.
    fn scale(&self, _: &Rotor, _: &State) -> f64 {
        self.stiffness * core::f64::consts::PI
    }

    fn rest(&self) -> Option<Attitude> {
        Some(self.rest)
    }

    fn value_near(&self, rotor: &Rotor, state: &State, near: Attitude) -> Torque<Body> {
        self.torque(&Values { rotor, state, near: Some(near) }).as_quantity()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vector::{AngularVelocity, Vector};
    use crate::motion::model::law::generic_rotor;

    fn generic() -> [Torsion; 2] {
        let rest = Attitude::from_quaternion([0.8, 0.1, -0.4, 0.5]).unwrap();
        [Torsion::spring(1.7, rest), Torsion::wire(1.7, rest, Direction::new(0.3, -0.5, 0.9))]
            .map(Result::unwrap)
    }

    #[test]
    fn the_torque_is_minus_the_gradient_of_the_potential() {
        let attitudes =
            [[0.4, -0.7, 1.1, 0.3], [-0.9, 0.2, 0.1, -0.3], [0.1, 0.6, -0.4, 0.7], [0.8, 0.1, -0.4, 0.5]];
        for torsion in generic() {
            for attitude in attitudes.map(|q| Attitude::from_quaternion(q).unwrap()) {
                // dU = −N · dθ for a rotation dθ about each body axis
                let h = 1e-5;
                let slope = |n: Direction<Body>| {
                    let turned = |angle: f64| attitude * Rotation::<Body, Body>::turn(n, angle);
                    (torsion.potential(turned(h)) - torsion.potential(turned(-h))) / (2.0 * h)
                };
                let x = slope(Vector::new(1.0, 0.0, 0.0));
                let y = slope(Vector::new(0.0, 1.0, 0.0));
                let z = slope(Vector::new(0.0, 0.0, 1.0));
                let state = State { time: 0.0, attitude, omega: AngularVelocity::ZERO };
                let torque = torsion.at(&generic_rotor(), &state);
                assert!((torque + Vector::new(x, y, z)).norm() < 2e-9, "{torsion:?} {attitude:?}");
                let most = torsion.scale(&generic_rotor(), &state);
                assert!(torsion.axis().is_some() || torque.norm() <= most);
            }
        }
    }

    #[test]
    fn a_wire_has_the_twist_about_its_axis_and_no_other() {
        let [_, wire] = generic();
        let axis = wire.axis().unwrap();
        for angle in [-3.1, -1.0, 1e-9, 0.4, 3.1] {
            let turned = Rotation::<Space, Space>::turn(axis, angle) * wire.rest();
            assert!((wire.twist(turned) - angle).abs() < 1e-14, "{angle}");
            // A tilt about any axis perpendicular to the wire, before the twist, does not change
            // the twist.
            let across = axis.cross(Direction::new(1.0, 2.0, 0.3)).direction().unwrap();
            let tilted = Rotation::<Space, Space>::turn(axis, angle)
                * (Rotation::<Space, Space>::turn(across, 0.7) * wire.rest());
            assert!((wire.twist(tilted) - angle).abs() < 1e-14, "{angle}");
        }
    }

    #[test]
    fn both_quaternions_of_an_attitude_are_one() {
        for torsion in generic() {
            let q = [0.4, -0.7, 1.1, 0.3];
            let [a, b] = [q, q.map(|c| -c)].map(|q| Attitude::from_quaternion(q).unwrap());
            let [n, m] = [a, b].map(|attitude| {
                torsion.at(&generic_rotor(), &State { time: 0.0, attitude, omega: AngularVelocity::ZERO })
            });
            assert_eq!(n, m);
            assert_eq!(torsion.potential(a), torsion.potential(b));
        }
    }

    #[test]
    fn what_is_no_spring_is_refused() {
        let rest = Attitude::identity();
        for stiffness in [-1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(Torsion::spring(stiffness, rest), Err(MotionError::NegativeParameter { .. })));
        }
        for axis in [Direction::ZERO, Direction::new(f64::NAN, 0.0, 1.0)] {
            assert!(matches!(Torsion::wire(1.0, rest, axis), Err(MotionError::NoDirection { .. })));
        }
        // Turned over about an axis perpendicular to the wire: no twist, and no NaN.
        let wire = Torsion::wire(1.0, rest, Direction::new(0.0, 0.0, 1.0)).unwrap();
        let over = Attitude::from_quaternion([0.0, 1.0, 0.0, 0.0]).unwrap();
        let state = State { time: 0.0, attitude: over, omega: AngularVelocity::ZERO };
        assert_eq!(wire.at(&generic_rotor(), &state), Torque::ZERO);
    }
}
