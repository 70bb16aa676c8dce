//! Gravity-gradient torque on an orbiting body.
//!
//! The reference point of the rotor follows the orbit of a freely falling particle; for a free body
//! it is the centre of mass. With r from the attracting mass to this point, and x from it to a mass
//! point,
//!
//! N = Σ x × m (g(r + x) − g(r)),  g(r) = −µ r/r³
//!
//! The difference is evaluated without cancellation, however small the body is compared with r.
//!
//! This is, to first order in x/r, N = 3 (µ/r³) r̂ × I r̂.
//!
//! Source of the first-order formula: P. C. Hughes, Spacecraft Attitude Dynamics (1986), ch. 8.1.

use super::model::Model;
use crate::body::particles::Particle;
use crate::math::algebra::{Scalar, VectorAlgebra};
use crate::math::frame::Body;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::{Direction, Position};
use crate::motion::model::law::{Law, LawInput, OrbitPosition};
use crate::motion::model::orbit::Orbit;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::wheel::Motor;

/// Torque of the gravity of a point mass that the body orbits.
///
/// It changes with time along the orbit, so
/// [`TorqueModel::potential`](crate::motion::torque::TorqueModel::potential) is `None`. The
/// potential energy of the attitude at one time is [`GravityGradient::potential`].
#[derive(Clone, Debug, PartialEq)]
pub struct GravityGradient {
    /// Orbit of the centre of mass.
    pub orbit: Orbit,
    /// Mass distribution on which gravity acts.
    pub attracted: Attracted,
}

/// Mass distribution on which gravity acts.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Attracted {
    /// Inertia tensor, to first order in size over distance: N = 3 µ/r³ r̂ × I r̂.
    Tensor,
    /// Mass points, exactly, with positions in the body. They should represent the whole body.
    Points(Vec<Particle<Body>>),
}

/// The error of N is a few ε of 3 (µ/r³) i3.
impl Law for GravityGradient {
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
        let OrbitPosition { direction: rho, square, inverse_cube, distance, strength } =
            at.orbit(&self.orbit);
        match &self.attracted {
            Attracted::Tensor => {
                // N = 3 (µ/r₀³) |ρ|⁻⁵ ρ × I ρ
                let mut product = at.inertia(rho);
                if let Some(wheels) = of_wheels(at.rotor()) {
                    product = product + at.symmetric(wheels.elements(), rho);
                }
                rho.cross(product) * (inverse_cube / square * strength).scaled(3.0)
            }
            Attracted::Points(points) => {
                // N = (µ/r₀³) r₀² Σ m f ξ × ρ, f = |ρ|⁻³ − |ρ + ξ|⁻³ = |ρ|⁻³ − (|ρ|² + δ)^(−3/2)
                let per_distance = at.number(1.0) / distance;
                let sum = points.iter().fold(at.in_body(Direction::ZERO), |sum, point| {
                    let x: Direction<Body> = (point.position() - at.rotor().point()).as_quantity();
                    let xi = at.in_body(x) * per_distance;
                    let delta = rho.dot(xi).scaled(2.0) + xi.dot(xi);
                    sum + xi * square.power_difference(delta, -1.5).scaled(point.mass())
                });
                sum.cross(rho) * (strength * distance * distance)
            }
        }
    }
}

impl GravityGradient {
    /// Returns the potential energy of the attitude at one time, J:
    /// U = −½ (µ/r³)(tr I − 3 r̂·I r̂).
    ///
    /// Mass points have the exact energy relative to a single point of the same mass at the
    /// centre. N = −∂U/∂θ at constant r. On a circular orbit of rate n about ẑ, T + U − n L·ẑ is
    /// constant.
    pub fn potential(&self, rotor: &Rotor, state: &State) -> f64 {
        let r = state.attitude.inverse() * self.orbit.position(state.time);
        let distance = r.norm();
        let r: Direction<Body> = (r / distance).as_quantity();
        let strength = self.orbit.strength(distance);
        match &self.attracted {
            Attracted::Tensor => {
                let inertia = whole(rotor);
                let trace = inertia.xx + inertia.yy + inertia.zz;
                -0.5 * strength * (trace - 3.0 * r.dot(times(&inertia, r)))
            }
            Attracted::Points(points) => points.iter().fold(0.0, |sum, point| {
                // 1/|r + x| − 1/r + r·x/r³ = ((w − 1)²(w + 2)/2w − ½ x²/r²)/r
                let x = (point.position() - rotor.point()) / distance;
                let (w, less) = root(x, r);
                let beyond = less * less * (w + 2.0) / (2.0 * w) - 0.5 * x.dot(x);
                sum - strength * distance * distance * point.mass() * beyond
            }),
        }
    }
}

impl Model for GravityGradient {
    fn name(&self) -> &'static str {
        "gravity_gradient"
    }

    fn scale(&self, rotor: &Rotor, _: &State) -> f64 {
        // |r̂ × I r̂| ≤ ½ (i3 − i1), but rounding is relative to i3, which is at most half the trace.
        let inertia = whole(rotor);
        0.75 * self.orbit.strength(self.orbit.periapsis()) * (inertia.xx + inertia.yy + inertia.zz)
    }
}

/// Returns the inertia tensor of the body with its wheels: gravity acts on both.
fn whole(rotor: &Rotor) -> Symmetric3 {
    of_wheels(rotor).map_or(*rotor.inertia().symmetric(), |wheels| *rotor.inertia().symmetric() + wheels)
}

/// Returns the contribution of the wheels to the tensor; `None` if it includes all wheels.
fn of_wheels(rotor: &Rotor) -> Option<Symmetric3> {
    let inertias = rotor.wheels().iter().filter_map(|wheel| match wheel.motor() {
        Motor::Torque { inertia, .. } => Some(Symmetric3::outer(wheel.axis().to_array()) * inertia),
        Motor::HeldSpeed => None,
    });
    inertias.reduce(|sum, wheel| sum + wheel)
}

fn times(inertia: &Symmetric3, v: Direction<Body>) -> Direction<Body> {
    Direction::from_array(inertia.apply(v.to_array()))
}

/// Returns w = |r + x|/r and w − 1; lengths in units of r.
fn root(x: Position<Body>, r: Direction<Body>) -> (f64, f64) {
    let u = 2.0 * r.dot(x) + x.dot(x);
    let w = (1.0 + u).sqrt();
    (w, u / (1.0 + w))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{MassProperties, mass_properties_of_particles};
    use crate::math::Torque;
    use crate::math::rotation::{Attitude, Rotation};
    use crate::math::vector::AngularVelocity;
    use crate::motion::State;

    fn points(size: f64) -> Vec<Particle<Body>> {
        [(1.5, [0.9, -0.2, 0.4]), (0.7, [-0.6, 1.1, 0.3]), (2.2, [0.1, 0.5, -1.3]), (1.1, [-0.8, -0.9, 0.2])]
            .map(|(m, p)| Particle::new(m, Position::from_array(p) * size).unwrap())
            .to_vec()
    }

    fn gradients(size: f64) -> (Rotor, [GravityGradient; 2], State) {
        let points = points(size);
        let body: MassProperties<Body> = mass_properties_of_particles(&points).unwrap();
        let orbit = Orbit::through(
            2.3,
            Position::new(3.0, -4.0, 1.0),
            crate::math::Velocity::new(0.4, 0.3, -0.5),
            0.7,
        )
        .unwrap();
        let of = |attracted| GravityGradient { orbit: orbit.clone(), attracted };
        let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
        let state = State { time: 1.9, attitude, omega: AngularVelocity::ZERO };
        (Rotor::free(&body), [of(Attracted::Tensor), of(Attracted::Points(points))], state)
    }

    #[test]
    fn the_torque_is_minus_the_gradient_of_the_potential() {
        let (rotor, gradients, state) = gradients(1.0);
        for gradient in gradients {
            let h = 1e-5;
            let slope = |n: Direction<Body>| {
                let at = |angle: f64| {
                    let attitude = state.attitude * Rotation::<Body, Body>::turn(n, angle);
                    gradient.potential(&rotor, &State { attitude, ..state })
                };
                (at(h) - at(-h)) / (2.0 * h)
            };
            let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            let want = Torque::from_array(unit.map(|axis| -slope(Direction::from_array(axis))));
            let torque = gradient.at(&rotor, &state);
            assert!((torque - want).norm() < 1e-9 && torque.norm() > 1e-3, "{torque:?} {want:?}");
            assert!(torque.norm() <= gradient.scale(&rotor, &state));
        }
    }

    #[test]
    fn points_become_the_tensor_as_the_body_shrinks() {
        // The next term is of order (x/r)³ for a body without symmetry. Relative to the torque it
        // decreases in proportion to the size.
        let difference = |size: f64| {
            let (rotor, [tensor, points], state) = gradients(size);
            let want = tensor.at(&rotor, &state);
            let potential = tensor.potential(&rotor, &state);
            (
                (points.at(&rotor, &state) - want).norm() / want.norm(),
                (points.potential(&rotor, &state) / potential - 1.0).abs(),
            )
        };
        let (one, two) = (difference(1e-3), difference(1e-4));
        assert!((one.0 / two.0 - 10.0).abs() < 0.1 && (one.1 / two.1 - 10.0).abs() < 0.1, "{one:?} {two:?}");
        // the sum is accurate even if r + x contains no digit of x
        let small = difference(1e-12);
        assert!(small.0 < 1e-11 && small.1 < 1e-11, "{small:?}");
    }

    #[test]
    fn gravity_acts_on_the_wheels_too() {
        use crate::motion::{Motor, Wheel};
        let (rotor, [tensor, _], state) = gradients(1.0);
        let axis = Direction::new(0.5, -0.3, 0.9);
        let motor = Motor::Torque { inertia: 0.2, torque: 0.0, schedule: None };
        let wheeled = rotor.clone().with_wheels(&[Wheel::new(axis, 3.0, motor).unwrap()]).unwrap();
        let (with, without) = (tensor.at(&wheeled, &state), tensor.at(&rotor, &state));
        assert!((with - without).norm() < 4e-16 * tensor.scale(&rotor, &state));
    }
}
