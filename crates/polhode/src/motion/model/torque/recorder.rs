//! Recorder of a law: its numbers and vectors store each operation in a graph.

use core::cell::RefCell;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::graph::{Graph, INERTIA, ScalarOperation, TO_BODY, TO_PRINCIPAL, VectorOperation, index};
use crate::math::algebra::{Scalar, VectorAlgebra};
use crate::math::formula::{Binary, Unary};
use crate::math::frame::{Body, Principal, Space};
use crate::math::rotation::{Attitude, Rotation};
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Direction;
use crate::motion::model::law::{LawInput, OrbitPosition};
use crate::motion::model::mass_history::changing_body::ChangingBody;
use crate::motion::model::orbit::Orbit;
use crate::motion::model::rotor::Rotor;

impl Graph {
    /// Records the sum of the torques of a body.
    pub(in crate::motion) fn of<'t>(
        torques: impl IntoIterator<Item = &'t super::TorqueModel>,
        rotor: &Rotor,
    ) -> Self {
        let (graph, torque) = Self::recorded(rotor, |recorder| {
            let all =
                torques.into_iter().map(|torque| torque.model().record(recorder)).reduce(|sum, n| sum + n);
            all.unwrap_or_else(|| recorder.in_body(Direction::ZERO)).place
        });
        Self { torque, ..graph }
    }

    /// Records a function that returns places of values.
    pub(super) fn recorded<T>(rotor: &Rotor, record: impl FnOnce(&Recorder<'_>) -> T) -> (Self, T) {
        let to_principal = rotor.principal().rotation().inverse();
        let inertia = Symmetric3::diagonal(rotor.principal().moments()).rows();
        // Fixed places: equal matrices of one body must not change the recorded operations.
        let matrices = vec![to_principal.matrix(), to_principal.inverse().matrix(), inertia];
        let graph = RefCell::new(Self { matrices, ..Self::default() });
        let recorded = record(&Recorder { rotor, to_principal, graph: &graph, changing: None });
        (graph.into_inner(), recorded)
    }
}

/// Input of a law that records its operations on the state of a body.
#[derive(Debug)]
pub(in crate::motion) struct Recorder<'r> {
    rotor: &'r Rotor,
    to_principal: Rotation<Principal, Body>,
    graph: &'r RefCell<Graph>,
    /// Changing body that the rotor replaces.
    changing: Option<&'r ChangingBody>,
}

/// Number in a graph.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct NumberNode<'r> {
    graph: &'r RefCell<Graph>,
    place: usize,
}

/// Vector in a graph.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct VectorNode<'r> {
    graph: &'r RefCell<Graph>,
    pub(super) place: usize,
}

impl NumberNode<'_> {
    /// Returns a constant of the same graph.
    pub(super) fn constant(self, x: f64) -> Self {
        self.make(|graph| graph.constant(x))
    }

    /// Returns the value if it is a constant.
    pub(super) fn value(self) -> Option<f64> {
        self.graph.borrow().value(self.place)
    }

    /// Returns the derivative of [`Scalar::half_angle_over_sine`].
    pub(super) fn half_angle_slope(self) -> Self {
        self.make(|graph| graph.number(ScalarOperation::HalfAngleSlope(self.place)))
    }

    fn make(self, place: impl FnOnce(&mut Graph) -> usize) -> Self {
        Self { place: place(&mut self.graph.borrow_mut()), ..self }
    }
}

impl VectorNode<'_> {
    fn make(self, operation: VectorOperation) -> Self {
        Self { place: self.graph.borrow_mut().vector(operation), ..self }
    }

    /// Returns the components if it is a constant.
    fn value(self) -> Option<[f64; 3]> {
        self.graph.borrow().vector_value(self.place)
    }

    /// Returns M v.
    fn image(self, rows: [[f64; 3]; 3]) -> Self {
        let k = {
            let matrices = &mut self.graph.borrow_mut().matrices;
            let known = matrices.iter().skip(INERTIA + 1).position(|known| *known == rows);
            known.map_or_else(
                || {
                    matrices.push(rows);
                    matrices.len() - 1
                },
                |k| INERTIA + 1 + k,
            )
        };
        self.image_by(k)
    }

    /// Returns the product with a matrix, by its place.
    fn image_by(self, matrix: usize) -> Self {
        self.make(VectorOperation::Image(matrix, self.place))
    }
}

impl Neg for NumberNode<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        self.unary(Unary::Negate)
    }
}

impl Add for NumberNode<'_> {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        self.binary(Binary::Add, b)
    }
}

impl Sub for NumberNode<'_> {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self.binary(Binary::Subtract, b)
    }
}

impl Mul for NumberNode<'_> {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        self.binary(Binary::Multiply, b)
    }
}

impl Div for NumberNode<'_> {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        self.binary(Binary::Divide, b)
    }
}

impl Scalar for NumberNode<'_> {
    fn scaled(self, by: f64) -> Self {
        self.make(|graph| graph.scaled(self.place, by))
    }

    fn unary(self, function: Unary) -> Self {
        self.make(|graph| graph.unary(function, self.place))
    }

    fn binary(self, function: Binary, b: Self) -> Self {
        self.make(|graph| graph.binary(function, self.place, b.place))
    }

    fn power(self, p: f64) -> Self {
        self.make(|graph| match graph.value(self.place) {
            Some(x) => graph.constant(x.power(p)),
            None => graph.number(ScalarOperation::Power(self.place, p.to_bits())),
        })
    }

    fn power_difference(self, delta: Self, p: f64) -> Self {
        let (power, sum) = (self.power(p), self + delta);
        self.make(|graph| {
            let of = [self, delta, power, sum].map(|node| node.place);
            graph.number(ScalarOperation::PowerDifference(of, p.to_bits()))
        })
    }

    fn over_or_zero(self, d: Self) -> Self {
        self.make(|graph| graph.number(ScalarOperation::DivideOrZero(self.place, d.place)))
    }

    fn wrapped(self) -> Self {
        self.make(|graph| graph.number(ScalarOperation::Wrapped(self.place)))
    }

    fn half_angle_over_sine(self) -> Self {
        self.make(|graph| graph.number(ScalarOperation::HalfAngleOverSine(self.place)))
    }
}

impl Neg for VectorNode<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        self.make(VectorOperation::Negate(self.place))
    }
}

impl Add for VectorNode<'_> {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        self.make(VectorOperation::Add(self.place, b.place))
    }
}

impl Sub for VectorNode<'_> {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self.make(VectorOperation::Subtract(self.place, b.place))
    }
}

impl<'r> Mul<NumberNode<'r>> for VectorNode<'r> {
    type Output = Self;
    fn mul(self, b: NumberNode<'r>) -> Self {
        let value = self.graph.borrow().value(b.place);
        match value {
            Some(by) => self.scaled(by),
            None => self.make(VectorOperation::Times(self.place, b.place)),
        }
    }
}

impl<'r> VectorAlgebra<NumberNode<'r>> for VectorNode<'r> {
    fn scaled(self, by: f64) -> Self {
        if by == 1.0 {
            return self;
        }
        let k = index(&mut self.graph.borrow_mut().constants, by, |a, b| a.to_bits() == b.to_bits());
        self.make(VectorOperation::Scale(self.place, k))
    }

    fn dot(self, b: Self) -> NumberNode<'r> {
        let operation = match [self, b].map(VectorNode::value) {
            [Some(a), _] => ScalarOperation::Component(b.image([a, [0.0; 3], [0.0; 3]]).place, 0),
            [_, Some(b)] => ScalarOperation::Component(self.image([b, [0.0; 3], [0.0; 3]]).place, 0),
            _ => ScalarOperation::Dot(self.place, b.place),
        };
        number(self.graph, operation)
    }

    fn cross(self, b: Self) -> Self {
        // The matrix of v ↦ a × v
        let matrix = |[x, y, z]: [f64; 3]| [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
        match [self, b].map(VectorNode::value) {
            [Some(a), _] => b.image(matrix(a)),
            [_, Some(b)] => self.image(matrix(b.map(|x| -x))),
            _ => self.make(VectorOperation::Cross(self.place, b.place)),
        }
    }

    fn norm(self) -> NumberNode<'r> {
        number(self.graph, ScalarOperation::Norm(self.place))
    }
}

fn number(graph: &RefCell<Graph>, operation: ScalarOperation) -> NumberNode<'_> {
    let place = graph.borrow_mut().number(operation);
    NumberNode { graph, place }
}

impl<'r> Recorder<'r> {
    fn vector_node(&self, operation: VectorOperation) -> VectorNode<'r> {
        let place = self.graph.borrow_mut().vector(operation);
        VectorNode { graph: self.graph, place }
    }

    /// Records a function of a changing body, which the rotor does not describe.
    pub(super) fn of_changing(
        &self,
        body: &ChangingBody,
        record: impl for<'s> FnOnce(&Recorder<'s>) -> VectorNode<'s>,
    ) -> VectorNode<'r> {
        let Self { rotor, to_principal, graph, .. } = *self;
        let place = record(&Recorder { rotor, to_principal, graph, changing: Some(body) }).place;
        VectorNode { graph, place }
    }

    pub(super) fn constant(&self, v: Direction<Principal>) -> VectorNode<'r> {
        let k = index(&mut self.graph.borrow_mut().vectors, v.to_array(), PartialEq::eq);
        self.vector_node(VectorOperation::Constant(k))
    }

    /// Returns a vector without power series.
    pub(super) fn rough(&self) -> VectorNode<'r> {
        let rough = number(self.graph, ScalarOperation::Rough);
        self.vector_node(VectorOperation::Of([rough.place; 3]))
    }

    fn turn(&self, rest: Attitude, is_canonical: bool) -> (NumberNode<'r>, VectorNode<'r>) {
        let k = index(&mut self.graph.borrow_mut().turns, (rest, is_canonical), PartialEq::eq);
        let w = number(self.graph, ScalarOperation::TurnScalar(k));
        (w, self.vector_node(VectorOperation::Turn(k)))
    }
}

impl<'r> LawInput for Recorder<'r> {
    type Scalar = NumberNode<'r>;
    type Vector = VectorNode<'r>;

    fn rotor(&self) -> &Rotor {
        self.graph.borrow_mut().asks_for_rotor = true;
        self.rotor
    }

    fn number(&self, x: f64) -> NumberNode<'r> {
        NumberNode { graph: self.graph, place: self.graph.borrow_mut().constant(x) }
    }

    fn in_body(&self, v: Direction<Body>) -> VectorNode<'r> {
        self.constant(self.to_principal * v)
    }

    fn in_space(&self, v: Direction<Space>) -> VectorNode<'r> {
        let k = index(&mut self.graph.borrow_mut().fixed, v, PartialEq::eq);
        self.vector_node(VectorOperation::Fixed(k))
    }

    fn time(&self) -> NumberNode<'r> {
        number(self.graph, ScalarOperation::Time)
    }

    fn omega(&self) -> VectorNode<'r> {
        self.vector_node(VectorOperation::Omega)
    }

    fn attitude(&self) -> (NumberNode<'r>, VectorNode<'r>) {
        self.turn(Attitude::identity(), false)
    }

    fn turn_from(&self, rest: Attitude) -> (NumberNode<'r>, VectorNode<'r>) {
        self.turn(rest, true)
    }

    fn wheel_momentum(&self) -> VectorNode<'r> {
        self.vector_node(VectorOperation::Wheels)
    }

    fn orbit(&self, orbit: &Orbit) -> OrbitPosition<NumberNode<'r>, VectorNode<'r>> {
        let k = index(&mut self.graph.borrow_mut().orbits, orbit.clone(), PartialEq::eq);
        let direction = self.vector_node(VectorOperation::Orbit(k));
        if orbit.is_circular() {
            let (one, distance) = (self.number(1.0), self.number(orbit.periapsis()));
            let strength = self.number(orbit.strength(orbit.periapsis()));
            return OrbitPosition { direction, square: one, inverse_cube: one, distance, strength };
        }
        OrbitPosition {
            direction,
            square: number(self.graph, ScalarOperation::OrbitSquare(k)),
            inverse_cube: number(self.graph, ScalarOperation::OrbitInverseCube(k)),
            distance: number(self.graph, ScalarOperation::OrbitDistance(k)),
            strength: number(self.graph, ScalarOperation::OrbitStrength(k)),
        }
    }

    fn inertia(&self, v: VectorNode<'r>) -> VectorNode<'r> {
        self.changing.map_or_else(|| v.image_by(INERTIA), |body| body.inertia(self, v))
    }

    fn moving_point(&self) -> Option<VectorNode<'r>> {
        self.changing.map(|body| body.point(self))
    }

    fn moving_moment(&self) -> Option<VectorNode<'r>> {
        self.changing.map(|body| body.first_moment(self))
    }

    fn symmetric(&self, elements: [f64; 6], v: VectorNode<'r>) -> VectorNode<'r> {
        v.image(Symmetric3::from_elements(elements).rotated(&self.to_principal.matrix()).rows())
    }

    fn components(&self, v: VectorNode<'r>) -> [NumberNode<'r>; 3] {
        let along_body = v.image_by(TO_BODY);
        [0, 1, 2].map(|k| number(self.graph, ScalarOperation::Component(along_body.place, k)))
    }

    fn vector(&self, components: [NumberNode<'r>; 3]) -> VectorNode<'r> {
        let given = self.vector_node(VectorOperation::Of(components.map(|x| x.place)));
        given.image_by(TO_PRINCIPAL)
    }
}
