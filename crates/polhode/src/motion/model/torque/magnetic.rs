//! A magnetic dipole moment in a magnetic field.

use super::model::Model;
use crate::math::algebra::{Scalar, VectorAlgebra};
use crate::math::frame::{Body, Space};
use crate::math::rotation::Attitude;
use crate::math::vector::Direction;
use crate::motion::model::law::{Law, LawInput, OrbitPosition};
use crate::motion::model::orbit::Orbit;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// Magnetic moment m fixed in the body: N = m × B.
///
/// The potential in a uniform field is U = −m·B. A body that is free to turn about one axis
/// perpendicular to B oscillates about the field at √(m B/I) rad/s for small amplitudes.
#[derive(Clone, Debug, PartialEq)]
pub struct Magnetic {
    /// Magnetic moment m, body axes, A·m².
    pub moment: Direction<Body>,
    /// Magnetic field B.
    pub field: MagneticField,
}

/// Magnetic field in space.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum MagneticField {
    /// Uniform and constant field, space axes, T.
    Uniform(Direction<Space>),
    /// Field of a dipole at the centre of the body's orbit: B = (µ₀/4π)(3 (M·r̂) r̂ − M)/r³.
    Dipole {
        /// Dipole moment M, space axes, A·m². That of the Earth is about 7.7e22, towards the south.
        dipole: Direction<Space>,
        /// Orbit of the body.
        orbit: Orbit,
    },
}

/// µ₀/4π, T·m/A. The value 1e-7 has a relative error of about 1e-10, as the SI of 2019 defines the
/// ampere by the elementary charge (CODATA 2022).
pub(crate) const MU_0_OVER_4_PI: f64 = 1e-7;

impl MagneticField {
    /// Returns B at a time (s), space axes, T.
    pub fn at(&self, time: f64) -> Direction<Space> {
        match self {
            Self::Uniform(field) => *field,
            Self::Dipole { dipole, orbit } => {
                let r = orbit.position(time);
                let distance = r.norm();
                let direction = (r / distance).as_quantity();
                field_of_dipole(
                    *dipole,
                    &OrbitPosition {
                        direction,
                        square: 1.0,
                        inverse_cube: 1.0,
                        distance,
                        strength: orbit.strength(distance),
                    },
                )
            }
        }
    }
}

impl Law for Magnetic {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        let field = match &self.field {
            MagneticField::Uniform(field) => at.space_parameters(3, *field),
            MagneticField::Dipole { dipole, orbit } => {
                field_of_dipole(at.space_parameters(3, *dipole), &at.orbit(orbit))
            }
        };
        at.body_parameters(0, self.moment).cross(field)
    }

    fn parameters(&self) -> &'static [&'static str] {
        match self.field {
            MagneticField::Uniform(_) => {
                &["moment.x", "moment.y", "moment.z", "field.x", "field.y", "field.z"]
            }
            MagneticField::Dipole { .. } => {
                &["moment.x", "moment.y", "moment.z", "dipole.x", "dipole.y", "dipole.z"]
            }
        }
    }
}

/// Returns B = (µ₀/4π r₀³)(3 (M·ρ) ρ/|ρ|² − M)/|ρ|³ at r = r₀ ρ.
fn field_of_dipole<S: Scalar, V: VectorAlgebra<S>>(dipole: V, at: &OrbitPosition<S, V>) -> V {
    let OrbitPosition { direction, square, inverse_cube, distance, .. } = *at;
    let pattern = direction * (dipole.dot(direction).scaled(3.0) / square) - dipole;
    pattern * (inverse_cube.scaled(MU_0_OVER_4_PI) / distance / distance / distance)
}

impl Magnetic {
    /// Returns U = −m · B, J; `None` if the field changes along an orbit.
    pub fn potential(&self, attitude: Attitude) -> Option<f64> {
        match self.field {
            MagneticField::Uniform(field) => Some(-(attitude * self.moment).dot(field)),
            MagneticField::Dipole { .. } => None,
        }
    }
}

impl Model for Magnetic {
    fn name(&self) -> &'static str {
        "magnetic"
    }

    fn potential(&self, _: &Rotor, state: &State) -> Option<f64> {
        self.potential(state.attitude)
    }

    fn scale(&self, _: &Rotor, _: &State) -> f64 {
        self.moment.norm()
            * match &self.field {
                MagneticField::Uniform(field) => field.norm(),
                MagneticField::Dipole { dipole, orbit } => {
                    let q = orbit.periapsis();
                    2.0 * dipole.norm() * (MU_0_OVER_4_PI / q / q / q)
                }
            }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Torque;
    use crate::math::rotation::Rotation;
    use crate::math::vector::{AngularVelocity, Position};
    use crate::motion::model::law::generic_rotor;

    #[test]
    fn the_torque_is_minus_the_gradient_of_the_potential() {
        let field = MagneticField::Uniform(Direction::new(2e-5, -1.1e-5, 4.3e-5));
        let magnet = Magnetic { moment: Direction::new(0.3, 1.2, -0.7), field };
        let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
        let h = 1e-5;
        let slope = |n: Direction<Body>| {
            let at = |angle| magnet.potential(attitude * Rotation::<Body, Body>::turn(n, angle)).unwrap();
            (at(h) - at(-h)) / (2.0 * h)
        };
        let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let want = Torque::from_array(unit.map(|axis| -slope(Direction::from_array(axis))));
        let state = State { time: 3.0, attitude, omega: AngularVelocity::ZERO };
        let torque = magnet.at(&generic_rotor(), &state);
        assert!(
            (torque - want).norm() < 1e-9 * magnet.scale(&generic_rotor(), &state)
                && torque.norm() < magnet.scale(&generic_rotor(), &state)
        );
    }

    #[test]
    fn the_dipole_is_two_poles_close_together() {
        // B = (µ₀/4π) Σ ± p d/d³ of poles ± p at ± ½ l, M = p l
        let dipole = Direction::new(-3e21, 2e21, -7.5e22);
        let velocity = crate::math::Velocity::new(0.4e3, 6.3e3, 4.5e3);
        let orbit =
            Orbit::through(crate::motion::MU_EARTH, Position::new(6.9e6, 1e5, -8e5), velocity, 0.0).unwrap();
        let time = 777.0;
        let r: Direction<Space> = orbit.position(time).as_quantity();
        let arm = dipole * (500.0 / dipole.norm());
        let pole = |d: Direction<Space>| d * (1e-7 * dipole.norm() / 1000.0 / d.norm().powi(3));
        let want = pole(r - arm) - pole(r + arm);
        let field = MagneticField::Dipole { dipole, orbit }.at(time);
        assert!((field - want).norm() < 1e-7 * want.norm(), "{field:?} {want:?}");
        // typical of low Earth orbit: 25 to 60 µT
        assert!((2e-5..6e-5).contains(&field.norm()));
    }
}
