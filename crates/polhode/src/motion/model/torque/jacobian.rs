//! How a torque changes with the state: what small oscillations and controllers are made of.

use super::TorqueModel;
use super::tangent::Tangent;
use crate::math::derivative::{Slope, derivative};
use crate::math::frame::Body;
use crate::math::rotation::Rotation;
use crate::math::vector::{Direction, Torque};
use crate::motion::error::MotionError;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// ∂N/∂θ and ∂N/∂ω of a torque in a state, body axes: δN = ∂N/∂θ δθ + ∂N/∂ω δω for a small turn δθ about axes of the body and a change δω.
///
/// ```
/// use polhode::prelude::*;
/// # let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2])?;
/// # let body = MassProperties::new(2.0, Position::new(0.0, 0.0, 0.5), inertia)?;
/// let rotor = Rotor::pivoted(&body, Position::ZERO);
/// let state = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::ZERO };
/// let gravity = TorqueModel::Gravity(UniformGravity::STANDARD);
/// // A body that stands on its pivot is pulled on in the direction of its fall: ∂N₁/∂θ₁ = M g l
/// let jacobian = gravity.jacobian(&rotor, &state)?;
/// assert!((jacobian.by_attitude[0].x - 2.0 * 9.80665 * 0.5).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct TorqueJacobian {
    /// ∂N/∂θ by columns, N·m/rad.
    pub by_attitude: [Torque<Body>; 3],
    /// ∂N/∂ω by columns, N·m·s/rad.
    pub by_omega: [Torque<Body>; 3],
}

/// The first difference of what can only be evaluated, rad.
const STEP: f64 = 0.1;

/// How far derivatives in opposite directions may differ, relative to themselves.
const CORNER: f64 = 1e-9;

impl TorqueModel {
    /// ∂N/∂θ and ∂N/∂ω: exact but for rounding where the torque is a law, by extrapolated differences (some 11 digits) where it is a function
    /// or a formula with `abs`, `min`, `if` or the like.
    ///
    /// # Errors
    /// [`MotionError::NoDerivative`] where the torque has a corner or a jump in this state, or is not finite.
    pub fn jacobian(&self, rotor: &Rotor, state: &State) -> Result<TorqueJacobian, MotionError> {
        let is_law = self.model().roughness().is_none();
        let jacobian = if is_law { self.derived(rotor, state) } else { self.differenced(rotor, state) };
        jacobian.ok_or_else(|| MotionError::NoDerivative { torque: self.name(), time: state.time })
    }

    /// From the law.
    fn derived(&self, rotor: &Rotor, state: &State) -> Option<TorqueJacobian> {
        let slope = |turn: Direction<Body>, faster: Direction<Body>| {
            let [forth, back] = [1.0, -1.0].map(|sign| {
                let (turn, faster) = (turn * sign, (faster * sign).as_quantity());
                self.model().derivative(&Tangent { turn, faster, ..Tangent::still(rotor, state) })
            });
            ((forth + back).norm() <= CORNER * forth.norm()).then_some(forth)
        };
        let [x, y, z] = AXES;
        let still = Direction::ZERO;
        Some(TorqueJacobian {
            by_attitude: [slope(x, still)?, slope(y, still)?, slope(z, still)?],
            by_omega: [slope(still, x)?, slope(still, y)?, slope(still, z)?],
        })
    }

    /// From values.
    fn differenced(&self, rotor: &Rotor, state: &State) -> Option<TorqueJacobian> {
        // A rate that belongs to the state: that of turning, or √(N/I)
        let [.., greatest] = rotor.principal().moments();
        let rate = state.omega.norm().max((self.torque(rotor, state).norm() / greatest).sqrt());
        let rate = if rate > 0.0 { rate } else { 1.0 };
        let torque = |attitude, omega| self.torque(rotor, &State { attitude, omega, ..*state }).to_array();
        let by_attitude = AXES.map(|axis| {
            let turned = |h: f64| state.attitude * Rotation::<Body, Body>::from_rotation_vector(axis * h);
            derivative(|h| torque(turned(h), state.omega), STEP)
        });
        let by_omega = AXES.map(|axis| {
            derivative(|h| torque(state.attitude, state.omega + (axis * h).as_quantity()), STEP * rate)
        });
        // Rounding is relative to the torques that cancel, and these show in some direction.
        let largest =
            |slopes: &[Slope; 3]| slopes.iter().fold(0.0, |most: f64, slope| most.max(slope.largest));
        let size = largest(&by_attitude) + self.torque(rotor, state).norm();
        let all = |slopes: [Slope; 3], scale: f64| {
            let [x, y, z] = slopes.map(|slope| slope.value(scale).map(Torque::from_array));
            Some([x?, y?, z?])
        };
        let by_omega = all(by_omega, largest(&by_omega) + size / rate)?;
        Some(TorqueJacobian { by_attitude: all(by_attitude, size)?, by_omega })
    }
}

/// The axes of the body.
const AXES: [Direction<Body>; 3] =
    [Direction::new(1.0, 0.0, 0.0), Direction::new(0.0, 1.0, 0.0), Direction::new(0.0, 0.0, 1.0)];
