//! A torque that is a polynomial in time.

use super::model::Model;
use crate::math::frame::{Body, Space};
use crate::math::vector::{Direction, Torque};
use crate::motion::model::law::{Law, LawInput};
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// Axes of the components of a torque.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TorqueAxes {
    /// Body axes.
    Body,
    /// Space axes.
    Space,
}

/// A torque whose components are polynomials in time, N = Σ cₖ (t − t₀)ᵏ, N·m.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::torque::{TimePolynomial, TorqueAxes};
/// # let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2])?;
/// # let rotor = Rotor::free(&MassProperties::new(2.0, Position::ZERO, inertia)?);
/// // 2 N·m about z at t = 1 s, and 0.5 N·m more each second
/// let coefficients = vec![[0.0, 0.0, 2.0], [0.0, 0.0, 0.5]];
/// let ramp = TorqueModel::Polynomial(TimePolynomial { axes: TorqueAxes::Body, epoch: 1.0, coefficients });
/// let state = State { time: 5.0, attitude: Attitude::identity(), omega: AngularVelocity::ZERO };
/// assert_eq!(ramp.torque(&rotor, &state).to_array(), [0.0, 0.0, 4.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TimePolynomial {
    /// Axes of the components.
    pub axes: TorqueAxes,
    /// Epoch t₀, s.
    pub epoch: f64,
    /// Coefficients cₖ, starting with k = 0, N·m/sᵏ.
    pub coefficients: Vec<[f64; 3]>,
}

impl TimePolynomial {
    /// Returns the components at a time, along `axes`, N·m.
    pub fn components(&self, time: f64) -> [f64; 3] {
        let t = time - self.epoch;
        let next = |sum: [f64; 3], c: &[f64; 3]| core::array::from_fn(|k| sum[k] * t + c[k]);
        self.coefficients.iter().rev().fold([0.0; 3], next)
    }
}

impl Law for TimePolynomial {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        let along = |(k, c): (usize, &[f64; 3])| match self.axes {
            TorqueAxes::Body => at.body_parameters(3 * k, Direction::from_array(*c)),
            TorqueAxes::Space => at.space_parameters(3 * k, Direction::from_array(*c)),
        };
        // Horner's scheme; a constant torque does not use the time.
        let mut falling = self.coefficients.iter().enumerate().rev();
        let Some(highest) = falling.next() else { return along((0, &[0.0; 3])) };
        falling.fold(along(highest), |sum, c| sum * (at.time() - at.number(self.epoch)) + along(c))
    }

    /// Only the coefficients up to degree three have names.
    fn parameters(&self) -> &'static [&'static str] {
        const NAMES: [&str; 12] =
            ["c0.x", "c0.y", "c0.z", "c1.x", "c1.y", "c1.z", "c2.x", "c2.y", "c2.z", "c3.x", "c3.y", "c3.z"];
        &NAMES[..NAMES.len().min(3 * self.coefficients.len())]
    }

    fn at(&self, _: &Rotor, state: &State) -> Torque<Body> {
        let components = self.components(state.time);
        match self.axes {
            TorqueAxes::Body => Torque::from_array(components),
            TorqueAxes::Space => state.attitude.inverse() * Torque::<Space>::from_array(components),
        }
    }
}

/// A time-dependent torque has no potential.
impl Model for TimePolynomial {
    fn name(&self) -> &'static str {
        "polynomial"
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::rotation::Attitude;
    use crate::math::vector::AngularVelocity;
    use crate::motion::model::law::{Values, generic_rotor};

    #[test]
    fn the_law_is_what_is_evaluated() {
        let rotor = generic_rotor();
        let attitude = Attitude::from_quaternion([0.3, -0.5, 0.7, 0.2]).unwrap();
        let state = State { time: 2.75, attitude, omega: AngularVelocity::new(0.1, -0.2, 0.3) };
        let coefficients = vec![[0.5, -1.5, 2.0], [0.25, 1.0, -0.75], [-2.0, 0.125, 0.5], [0.1, 0.2, -0.3]];
        // Σ cₖ 1.5ᵏ by hand
        let want = [0.5 + 0.375 - 4.5 + 0.3375, -1.5 + 1.5 + 0.28125 + 0.675, 2.0 - 1.125 + 1.125 - 1.0125];
        for axes in [TorqueAxes::Body, TorqueAxes::Space] {
            let law = TimePolynomial { axes, epoch: 1.25, coefficients: coefficients.clone() };
            let value = law.at(&rotor, &state);
            let along_body = match axes {
                TorqueAxes::Body => Torque::from_array(want),
                TorqueAxes::Space => attitude.inverse() * Torque::<Space>::from_array(want),
            };
            assert!((value - along_body).norm() < 1e-14, "{value:?}");
            let recorded: Torque<Body> =
                law.torque(&Values { rotor: &rotor, state: &state, near: None }).as_quantity();
            assert!((value - recorded).norm() < 1e-14, "{recorded:?}");
        }
    }
}
