//! A state that moves along a tangent, with the derivatives of the inputs of a law.

use crate::math::algebra::{Components, Scalar};
use crate::math::frame::{Body, Space};
use crate::math::jet::Jet;
use crate::math::rotation::Attitude;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::{AngularVelocity, Direction};
use crate::motion::model::law::{LawInput, OrbitPosition, Values};
use crate::motion::model::orbit::Orbit;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// State that moves as R exp(ε t), ω + ε w at ε = 0, with a rotation t and a change w along body
/// axes. The time may advance or stand still.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct Tangent<'a> {
    pub(in crate::motion) rotor: &'a Rotor,
    pub(in crate::motion) state: &'a State,
    /// Rotation t, body axes.
    pub(in crate::motion) turn: Direction<Body>,
    /// Change w of ω, body axes.
    pub(in crate::motion) faster: AngularVelocity<Body>,
    /// Rate of the time. Orbits do not move.
    pub(in crate::motion) later: f64,
    /// Element of the inertia tensor that grows at the rate 1.
    pub(in crate::motion) element: Option<usize>,
}

/// Moving vector along the body axes.
pub(in crate::motion) type MovingVector = Components<Jet>;

impl<'a> Tangent<'a> {
    /// Returns a state that does not move.
    pub(in crate::motion) const fn still(rotor: &'a Rotor, state: &'a State) -> Self {
        Self { rotor, state, turn: Direction::ZERO, faster: AngularVelocity::ZERO, later: 0.0, element: None }
    }
}

impl Tangent<'_> {
    pub(super) const fn time(&self) -> f64 {
        self.state.time
    }

    /// Returns a vector v that is fixed in space: v′ = v × t, v″ = v′ × t.
    fn fixed_in_space(&self, v: Direction<Body>) -> MovingVector {
        let first = v.cross(self.turn);
        moving([v, first, first.cross(self.turn)])
    }

    /// Returns q ∘ exp(½ ε t): q′ = ½ q ∘ t, q″ = −¼ t² q.
    fn quaternion(&self, [w, x, y, z]: [f64; 4]) -> (Jet, MovingVector) {
        let (v, t) = (Direction::<Body>::new(x, y, z), self.turn);
        let back = -0.25 * t.dot(t);
        let scalar = Jet { value: w, first: -0.5 * v.dot(t), second: back * w };
        (scalar, moving([v, (t * w + v.cross(t)) * 0.5, v * back]))
    }
}

/// Returns a moving vector from v, v′ and v″.
fn moving(derivatives: [Direction<Body>; 3]) -> MovingVector {
    let [value, first, second] = derivatives.map(Direction::to_array);
    Components([0, 1, 2].map(|k| Jet { value: value[k], first: first[k], second: second[k] }))
}

impl LawInput for Tangent<'_> {
    type Scalar = Jet;
    type Vector = MovingVector;

    fn rotor(&self) -> &Rotor {
        self.rotor
    }

    fn number(&self, x: f64) -> Jet {
        Jet::constant(x)
    }

    fn in_body(&self, v: Direction<Body>) -> MovingVector {
        moving([v, Direction::ZERO, Direction::ZERO])
    }

    fn in_space(&self, v: Direction<Space>) -> MovingVector {
        self.fixed_in_space(self.state.attitude.inverse() * v)
    }

    fn time(&self) -> Jet {
        Jet { value: self.state.time, first: self.later, second: 0.0 }
    }

    fn omega(&self) -> MovingVector {
        moving([self.state.omega.as_quantity(), self.faster.as_quantity(), Direction::ZERO])
    }

    fn attitude(&self) -> (Jet, MovingVector) {
        self.quaternion(self.state.attitude.quaternion())
    }

    fn turn_from(&self, rest: Attitude) -> (Jet, MovingVector) {
        self.quaternion((rest.inverse() * self.state.attitude).canonical_quaternion())
    }

    fn wheel_momentum(&self) -> MovingVector {
        let time = self.state.time;
        let rate: Direction<Body> = self.rotor.motor_torque(time).as_quantity();
        moving([self.rotor.wheel_momentum(time).as_quantity(), rate * self.later, Direction::ZERO])
    }

    fn orbit(&self, orbit: &Orbit) -> OrbitPosition<Jet, MovingVector> {
        let at = Values { rotor: self.rotor, state: self.state, near: None }.orbit(orbit);
        OrbitPosition {
            direction: self.fixed_in_space(at.direction),
            square: self.number(at.square),
            inverse_cube: self.number(at.inverse_cube),
            distance: self.number(at.distance),
            strength: self.number(at.strength),
        }
    }

    fn inertia(&self, v: MovingVector) -> MovingVector {
        let image = self.symmetric(self.rotor.inertia().symmetric().elements(), v);
        let growth = |element: usize| {
            let unit = core::array::from_fn(|k| f64::from(u8::from(k == element)));
            self.symmetric(unit, v) * Jet { value: 0.0, first: 1.0, second: 0.0 }
        };
        self.element.map_or(image, |element| image + growth(element))
    }

    fn symmetric(&self, elements: [f64; 6], v: MovingVector) -> MovingVector {
        let [x, y, z] = v.0;
        let rows = Symmetric3::from_elements(elements).rows();
        Components(rows.map(|[a, b, c]| x.scaled(a) + y.scaled(b) + z.scaled(c)))
    }

    fn components(&self, v: MovingVector) -> [Jet; 3] {
        v.0
    }

    fn vector(&self, components: [Jet; 3]) -> MovingVector {
        Components(components)
    }
}
