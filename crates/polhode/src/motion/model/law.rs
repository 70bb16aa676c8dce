//! What a torque law is: N as a function of the time, the attitude and ω, stated once.
//!
//! A [`Law`] is written over any [`LawInput`], which gives it the components of a body's state, and whose
//! numbers and vectors know only their operations. So one statement is evaluated in a state
//! ([`LawInput`] of f64), is recognised as linear or quadratic (`torque/polynomial.rs`), is recorded as a
//! graph (`torque/graph.rs`), from which Taylor's method has its series, of one body or of several, and
//! is differentiated (`torque/jacobian.rs`).

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
/// Vectors are along the body's axes, in SI units. A law has no branches on what the input gives: it is the same expression everywhere.
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
/// # let run = polhode::motion::Trajectory::compute(&rotor, &torques, state, &[1.0], polhode::motion::Method::Auto, 1e-12)?;
/// # assert!(run.samples()[0].state.omega.norm() < 3.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Law {
    /// N about the point that the body turns about, N·m.
    fn torque<I: LawInput>(&self, at: &I) -> I::Vector;

    /// The names of the numbers that motions can be differentiated by, in the order of their places: those that the law takes by
    /// [`LawInput::parameter`] and its like.
    fn parameters(&self) -> &'static [&'static str] {
        &[]
    }

    /// N in a state, N·m.
    fn at(&self, rotor: &Rotor, state: &State) -> Torque<Body> {
        self.torque(&Values { rotor, state, near: None }).as_quantity()
    }
}

/// The state of a body and what follows from it, along the axes of the body: what a [`Law`] is a function of.
pub trait LawInput {
    /// A number.
    type Scalar: Scalar;
    /// A vector.
    type Vector: VectorAlgebra<Self::Scalar>;

    /// The body, and the point that it turns about. Of a body whose mass properties change it is known in states only, so that a law that asks for it
    /// has no power series then; [`LawInput::inertia`], [`LawInput::moving_point`] and [`LawInput::moving_moment`] have one.
    fn rotor(&self) -> &Rotor;

    /// A constant.
    fn number(&self, x: f64) -> Self::Scalar;

    /// A vector that is fixed in the body.
    fn in_body(&self, v: Direction<Body>) -> Self::Vector;

    /// A vector that is fixed in space.
    fn in_space(&self, v: Direction<Space>) -> Self::Vector;

    /// t, s.
    fn time(&self) -> Self::Scalar;

    /// ω, rad/s.
    fn omega(&self) -> Self::Vector;

    /// The quaternion (w, v) of R_space_body: that of the start, continued, of either sign.
    fn attitude(&self) -> (Self::Scalar, Self::Vector);

    /// The quaternion (w, v) of the turn from another attitude, w ≥ 0; v is along the axes of the body at either attitude.
    fn turn_from(&self, rest: Attitude) -> (Self::Scalar, Self::Vector);

    /// Σ h a of the wheels, kg·m²/s.
    fn wheel_momentum(&self) -> Self::Vector;

    /// Where the body is on an orbit.
    fn orbit(&self, orbit: &Orbit) -> OrbitPosition<Self::Scalar, Self::Vector>;

    /// I v, of the tensor about the point that the body turns about.
    fn inertia(&self, v: Self::Vector) -> Self::Vector;

    /// M v, of a symmetric matrix along body axes by its elements xx, yy, zz, xy, xz, yz.
    fn symmetric(&self, elements: [f64; 6], v: Self::Vector) -> Self::Vector;

    /// The components of a vector along the body's axes.
    fn components(&self, v: Self::Vector) -> [Self::Scalar; 3];

    /// The vector with these components.
    fn vector(&self, components: [Self::Scalar; 3]) -> Self::Vector;

    /// Where the point that the body turns about is in the body, if its mass properties change and the rotor does not know.
    fn moving_point(&self) -> Option<Self::Vector> {
        None
    }

    /// M l, l from that point to the centre of mass, if they change.
    fn moving_moment(&self) -> Option<Self::Vector> {
        None
    }

    /// A constant that is the law's parameter at this place.
    fn parameter(&self, _which: usize, value: f64) -> Self::Scalar {
        self.number(value)
    }

    /// A vector that is fixed in the body, whose components along its axes are three parameters from one on.
    fn body_parameters(&self, _first: usize, v: Direction<Body>) -> Self::Vector {
        self.in_body(v)
    }

    /// A vector that is fixed in space, in the same way.
    fn space_parameters(&self, _first: usize, v: Direction<Space>) -> Self::Vector {
        self.in_space(v)
    }

    /// r × F of a place and a force that are fixed in the body, whose components are six parameters from one on.
    fn moment_parameters(&self, _first: usize, [r, force]: [Direction<Body>; 2]) -> Self::Vector {
        self.in_body(r.cross(force))
    }

    /// M v, of a symmetric matrix whose elements are six parameters from one on.
    fn symmetric_parameters(&self, _first: usize, elements: [f64; 6], v: Self::Vector) -> Self::Vector {
        self.symmetric(elements, v)
    }
}

/// A position on an orbit, from the attracting mass: r = r₀ ρ with r₀ near |r|.
#[derive(Clone, Copy, Debug)]
pub struct OrbitPosition<S, V> {
    /// ρ, along the body's axes.
    pub direction: V,
    /// |ρ|²
    pub square: S,
    /// |ρ|⁻³
    pub inverse_cube: S,
    /// r₀, m.
    pub distance: S,
    /// µ/r₀³, 1/s².
    pub strength: S,
}

/// A state in numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Values<'a> {
    pub(super) rotor: &'a Rotor,
    pub(super) state: &'a State,
    /// An attitude near that of the state, with which the quaternions of turns are continuous; without it their
    /// scalar part is not negative.
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

/// A body without symmetry, for tests.
#[cfg(test)]
pub(super) fn generic_rotor() -> Rotor {
    use crate::body::{InertiaTensor, MassProperties};
    use crate::math::Position;
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    Rotor::free(&MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap())
}
