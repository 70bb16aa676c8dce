//! Jacobian of a torque with respect to the state, for small oscillations and for controllers.

use super::TorqueModel;
use super::tangent::Tangent;
use crate::math::derivative::{Slope, derivative};
use crate::math::frame::Body;
use crate::math::rotation::Rotation;
use crate::math::vector::{Direction, Torque};
use crate::motion::error::MotionError;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// Jacobian ∂N/∂θ and ∂N/∂ω of a torque in a state, body axes: δN = ∂N/∂θ δθ + ∂N/∂ω δω. δθ is a
/// small rotation about body axes.
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
    /// Columns of ∂N/∂θ, N·m/rad.
    pub by_attitude: [Torque<Body>; 3],
    /// Columns of ∂N/∂ω, N·m·s/rad.
    pub by_omega: [Torque<Body>; 3],
}

/// First step of the difference quotient for a torque that can only be evaluated, rad.
const STEP: f64 = 0.1;

/// Relative difference of one-sided derivatives above which the torque has a corner.
const CORNER: f64 = 1e-9;

impl TorqueModel {
    /// Computes ∂N/∂θ and ∂N/∂ω.
    ///
    /// They are exact except for rounding if the torque is a law. For a function, or a formula with
    /// `abs`, `min` or `if`, extrapolated differences give about 11 digits.
    ///
    /// # Errors
    /// [`MotionError::NoDerivative`] if the torque has a corner or a jump in this state, or is not
    /// finite.
    pub fn jacobian(&self, rotor: &Rotor, state: &State) -> Result<TorqueJacobian, MotionError> {
        let is_law = self.model().roughness().is_none();
        let jacobian = if is_law { self.derived(rotor, state) } else { self.differenced(rotor, state) };
        jacobian.ok_or_else(|| MotionError::NoDerivative { torque: self.name(), time: state.time })
    }

    /// Differentiates the law.
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

    /// Extrapolates differences of values.
    fn differenced(&self, rotor: &Rotor, state: &State) -> Option<TorqueJacobian> {
        // Scale of the rate: |ω|, or √(N/I)
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
        // Rounding is relative to the torques that cancel; these are visible in some direction.
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

/// Unit vectors of the body axes.
const AXES: [Direction<Body>; 3] =
    [Direction::new(1.0, 0.0, 0.0), Direction::new(0.0, 1.0, 0.0), Direction::new(0.0, 0.0, 1.0)];
