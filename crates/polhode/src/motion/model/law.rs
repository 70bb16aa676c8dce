//! Torque laws: N as a function of time, attitude and ω, each written once.
//!
//! A [`Law`] is generic over [`LawInput`], which supplies the components of the state of a body.
//! The numbers and vectors of a `LawInput` have only arithmetic operations. The same expression
//! therefore serves four purposes: it is evaluated in a state ([`LawInput`] over f64), recognised
//! as linear or quadratic (`torque/polynomial.rs`), recorded as a graph for the power series of
//! Taylor's method, for one body or several (`torque/graph.rs`), and differentiated
//! (`torque/jacobian.rs`).

use crate::math::algebra::{Scalar, VectorAlgebra};
use crate::math::frame::{Body, Space};
use crate::math::rotation::Attitude;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::{Direction, Torque};
use crate::motion::model::orbit::Orbit;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// A torque as a function of the state.
///
/// Vectors are along the body axes, in SI units. A law has no branches that depend on the input: it
/// is the same expression everywhere.
///
/// ```
/// use polhode::math::{Scalar, VectorAlgebra};
/// use polhode::motion::torque::{Law, LawInput};
/// /// N = −c |ω|² ω
/// #[derive(Debug)]
/// struct CubicDrag {
///     c: f64,
/// }
///
/// impl Law for CubicDrag {
///     fn torque<I: LawInput>(&self, at: &I) -> I::Vector {
///         let omega = at.omega();
///         -(omega * omega.dot(omega).scaled(self.c))
///     }
/// }
/// # let inertia = polhode::body::InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2])?;
/// # let body = polhode::body::MassProperties::new(2.0, polhode::math::Position::ZERO, inertia)?;
/// # let rotor = polhode::motion::Rotor::free(&body);
/// # let omega = polhode::math::AngularVelocity::new(1.0, 2.0, -2.0);
/// # let state = polhode::motion::State { time: 0.0, attitude: polhode::math::Attitude::identity(), omega };
/// assert_eq!(CubicDrag { c: 0.5 }.at(&rotor, &state).to_array(), [-4.5, -9.0, 9.0]);
/// // Integrated by Taylor's method, with that of all others:
/// let torques = vec![polhode::motion::torque::TorqueModel::own("cubic drag", CubicDrag { c: 0.5 })];
/// # use polhode::motion::{Method, Trajectory};
/// # let run = Trajectory::compute(&rotor, &torques, state, &[1.0], Method::Auto, 1e-12)?;
/// # assert!(run.samples()[0].state.omega.norm() < 3.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Law {
    /// Returns the torque N about the body's reference point (centre of mass or pivot), N·m.
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector;

    /// Returns the names of the parameters with respect to which motions can be differentiated,
    /// ordered by index. The law reads them with [`LawInput::parameter`] and its variants.
    fn parameters(&self) -> &'static [&'static str] {
        &[]
    }

    /// Returns the torque N in a state, N·m.
    fn at(&self, rotor: &Rotor, state: &State) -> Torque<Body> {
        self.torque(&Values { rotor, state, near: None }).as_quantity()
    }
}

/// Input of a [`Law`]: the state of a body and derived quantities, along the body axes.
pub trait LawInput {
    /// Type of numbers.
    type Scalar: Scalar;
    /// Type of vectors.
    type Vector: VectorAlgebra<Self::Scalar>;

    /// Returns the body with its reference point.
    ///
    /// If the mass properties change with time, the body is known only in states, so a law that
    /// calls this function has no power series. [`LawInput::inertia`], [`LawInput::moving_point`]
    /// and [`LawInput::moving_moment`] have one.
    fn rotor(&self) -> &Rotor;

    /// Returns a constant.
    fn number(&self, x: f64) -> Self::Scalar;

    /// Returns a vector that is fixed in the body.
    fn in_body(&self, v: Direction<Body>) -> Self::Vector;

    /// Returns a vector that is fixed in space.
    fn in_space(&self, v: Direction<Space>) -> Self::Vector;

    /// Returns the time t, s.
    fn time(&self) -> Self::Scalar;

    /// Returns ω, rad/s.
    fn omega(&self) -> Self::Vector;

    /// Returns the quaternion (w, v) of `R_space_body`, continuous from the start; its sign is
    /// arbitrary.
    fn attitude(&self) -> (Self::Scalar, Self::Vector);

    /// Returns the quaternion (w, v), w ≥ 0, of the rotation from `rest` to the attitude. v has the
    /// same components along the body axes of both attitudes.
    fn turn_from(&self, rest: Attitude) -> (Self::Scalar, Self::Vector);

    /// Returns the angular momentum Σ h a of the wheels, kg·m²/s.
    fn wheel_momentum(&self) -> Self::Vector;

    /// Returns the position of the body on an orbit.
    fn orbit(&self, orbit: &Orbit) -> OrbitPosition<Self::Scalar, Self::Vector>;

    /// Returns I v, with I about the body's reference point.
    fn inertia(&self, v: Self::Vector) -> Self::Vector;

    /// Returns M v. The elements of the symmetric matrix M along body axes are xx, yy, zz, xy, xz,
    /// yz.
    fn symmetric(&self, elements: [f64; 6], v: Self::Vector) -> Self::Vector;

    /// Returns the components of a vector along the body axes.
    fn components(&self, v: Self::Vector) -> [Self::Scalar; 3];

    /// Returns the vector with these components.
    fn vector(&self, components: [Self::Scalar; 3]) -> Self::Vector;

    /// Returns the position of the reference point in the body, if the mass properties change and
    /// the rotor does not know it.
    fn moving_point(&self) -> Option<Self::Vector> {
        None
    }

    /// Returns the first moment M l if the mass properties change, with l from that point to the
    /// centre of mass.
    fn moving_moment(&self) -> Option<Self::Vector> {
        None
    }

    /// Returns a constant that is a parameter of the law. The arguments are the index of the
    /// parameter and its value.
    fn parameter(&self, _which: usize, value: f64) -> Self::Scalar {
        self.number(value)
    }

    /// Returns a vector fixed in the body whose components along the body axes are three
    /// consecutive parameters.
    fn body_parameters(&self, _first: usize, v: Direction<Body>) -> Self::Vector {
        self.in_body(v)
    }

    /// Returns a vector fixed in space whose components are three consecutive parameters.
    fn space_parameters(&self, _first: usize, v: Direction<Space>) -> Self::Vector {
        self.in_space(v)
    }

    /// Returns r × F of a position and a force fixed in the body, whose components are six
    /// consecutive parameters.
    fn moment_parameters(&self, _first: usize, [r, force]: [Direction<Body>; 2]) -> Self::Vector {
        self.in_body(r.cross(force))
    }

    /// Returns M v of a symmetric matrix whose elements are six consecutive parameters.
    fn symmetric_parameters(&self, _first: usize, elements: [f64; 6], v: Self::Vector) -> Self::Vector {
        self.symmetric(elements, v)
    }
}

/// Position on an orbit, from the attracting mass: r = r₀ ρ, with r₀ close to |r|.
#[derive(Clone, Copy, Debug)]
pub struct OrbitPosition<S, V> {
    /// ρ, along the body axes.
    pub direction: V,
    /// Square |ρ|².
    pub square: S,
    /// Inverse cube |ρ|⁻³.
    pub inverse_cube: S,
    /// Reference distance r₀, m.
    pub distance: S,
    /// Strength µ/r₀³ of gravity, 1/s².
    pub strength: S,
}

/// Input of a law that is a state with numeric values.
#[derive(Clone, Copy, Debug)]
pub(super) struct Values<'a> {
    pub(super) rotor: &'a Rotor,
    pub(super) state: &'a State,
    /// Attitude near that of the state. Quaternions of rotations are continuous relative to it. If
    /// `None`, their scalar part is not negative.
    pub(super) near: Option<Attitude>,
}

impl LawInput for Values<'_> {
    type Scalar = f64;
    type Vector = Direction<Body>;

    fn rotor(&self) -> &Rotor {
        self.rotor
    }

    fn number(&self, x: f64) -> f64 {
        x
    }

    fn in_body(&self, v: Direction<Body>) -> Direction<Body> {
        v
    }

    fn in_space(&self, v: Direction<Space>) -> Direction<Body> {
        self.state.attitude.inverse() * v
    }

    fn time(&self) -> f64 {
        self.state.time
    }

    fn omega(&self) -> Direction<Body> {
        self.state.omega.as_quantity()
    }

    fn attitude(&self) -> (f64, Direction<Body>) {
        let [w, x, y, z] = self.state.attitude.quaternion();
        (w, Direction::new(x, y, z))
    }

    fn turn_from(&self, rest: Attitude) -> (f64, Direction<Body>) {
        let turn = rest.inverse() * self.state.attitude;
        let [w, x, y, z] = match self.near {
            None => turn.canonical_quaternion(),
            Some(near) => {
                let [sign, ..] = (rest.inverse() * near).quaternion();
                turn.quaternion().map(|c| c * sign.signum())
            }
        };
        (w, Direction::new(x, y, z))
    }

    fn wheel_momentum(&self) -> Direction<Body> {
        self.rotor.wheel_momentum(self.state.time).as_quantity()
    }

    fn orbit(&self, orbit: &Orbit) -> OrbitPosition<f64, Direction<Body>> {
        let r = self.state.attitude.inverse() * orbit.position(self.state.time);
        let distance = r.norm();
        let direction = (r / distance).as_quantity();
        OrbitPosition {
            direction,
            square: 1.0,
            inverse_cube: 1.0,
            distance,
            strength: orbit.strength(distance),
        }
    }

    fn inertia(&self, v: Direction<Body>) -> Direction<Body> {
        Direction::from_array(self.rotor.inertia().symmetric().apply(v.to_array()))
    }

    fn symmetric(&self, elements: [f64; 6], v: Direction<Body>) -> Direction<Body> {
        Direction::from_array(Symmetric3::from_elements(elements).apply(v.to_array()))
    }

    fn components(&self, v: Direction<Body>) -> [f64; 3] {
        v.to_array()
    }

    fn vector(&self, components: [f64; 3]) -> Direction<Body> {
        Direction::from_array(components)
    }
}

/// Returns a body without symmetry, for tests.
#[cfg(test)]
pub(super) fn generic_rotor() -> Rotor {
    use crate::body::{InertiaTensor, MassProperties};
    use crate::math::Position;
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    Rotor::free(&MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap())
}
