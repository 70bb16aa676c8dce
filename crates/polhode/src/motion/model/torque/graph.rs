//! Laws as graphs: each value that occurs once, with the operation that makes it of others.
//!
//! A law that is run over [`Recorder`] leaves its operations here, those of numbers and those of vectors along the principal axes, in an
//! order in which each follows what it is of. `propagate/taylor/torque/tape.rs` works out their Taylor coefficients. What differs from one
//! body to another (constants, directions, orbits) is beside the operations, so that bodies with the same operations go side by side.

use core::cell::RefCell;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::law::{LawInput, OrbitPosition};
use crate::math::algebra::{Scalar, VectorAlgebra};
use crate::math::formula::{Binary, Unary};
use crate::math::frame::{Body, Principal, Space};
use crate::math::rotation::{Attitude, Rotation};
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Direction;
use crate::motion::model::orbit::Orbit;
use crate::motion::model::rotor::Rotor;

/// An operation: its result is the next number, or the next vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::motion) enum Operation {
    Scalar(ScalarOperation),
    Vector(VectorOperation),
}

/// How a number is made; numbers and vectors by their places among those of their kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::motion) enum ScalarOperation {
    /// One of the constants.
    Constant(usize),
    Time,
    Negate(usize),
    /// The product with one of the constants.
    Scale(usize, usize),
    Add(usize, usize),
    Subtract(usize, usize),
    Multiply(usize, usize),
    Divide(usize, usize),
    /// The quotient, zero where the divisor is at the start of a step.
    DivideOrZero(usize, usize),
    /// aᵖ, p by its bits.
    Power(usize, u64),
    /// aᵖ − (a + δ)ᵖ, of a, δ, aᵖ and a + δ.
    PowerDifference([usize; 4], u64),
    /// aᵇ = exp(b log a), the exponent last.
    GeneralPower(usize, usize, usize),
    Hypot(usize, usize),
    /// ∫ of' by, from the function of `of` at the start; `by` may come later.
    IntegralBy {
        start: Unary,
        of: usize,
        by: usize,
    },
    /// ∫ of'/over, from the function of `of` at the start.
    IntegralOver {
        start: Unary,
        of: usize,
        over: usize,
    },
    /// The angle of (b, a), and a² + b².
    Angle(usize, usize, usize),
    /// An angle brought between −π and π at the start.
    Wrapped(usize),
    /// arccos w/√(1 − w²)
    HalfAngleOverSine(usize),
    Dot(usize, usize),
    /// A component along a principal axis.
    Component(usize, usize),
    Norm(usize),
    /// w of one of the turns.
    TurnScalar(usize),
    /// |ρ|², |ρ|⁻³, r₀ and µ/r₀³ of one of the orbits.
    OrbitSquare(usize),
    OrbitInverseCube(usize),
    OrbitDistance(usize),
    OrbitStrength(usize),
    /// What has no series.
    Rough,
}

/// How a vector is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::motion) enum VectorOperation {
    /// One of the constant vectors.
    Constant(usize),
    Omega,
    /// Σ h a of the wheels.
    Wheels,
    /// One of the vectors that are fixed in space.
    Fixed(usize),
    /// ρ of one of the orbits.
    Orbit(usize),
    /// v of one of the turns.
    Turn(usize),
    Negate(usize),
    /// The product with one of the constants.
    Scale(usize, usize),
    Add(usize, usize),
    Subtract(usize, usize),
    /// A vector times a number.
    Times(usize, usize),
    Cross(usize, usize),
    /// The product with one of the matrices.
    Image(usize, usize),
    /// The vector of three numbers, along principal axes.
    Of([usize; 3]),
}

/// The operations of one law or of several, and what they need of a body.
#[derive(Clone, Debug, Default)]
pub(in crate::motion) struct Graph {
    pub(in crate::motion) operations: Vec<Operation>,
    pub(in crate::motion) constants: Vec<f64>,
    pub(in crate::motion) vectors: Vec<[f64; 3]>,
    /// Rows.
    pub(in crate::motion) matrices: Vec<[[f64; 3]; 3]>,
    pub(in crate::motion) fixed: Vec<Direction<Space>>,
    pub(in crate::motion) orbits: Vec<Orbit>,
    /// What turns are from, and whether their w is made positive.
    pub(in crate::motion) turns: Vec<(Attitude, bool)>,
    /// How many numbers and vectors there are.
    pub(in crate::motion) counts: [usize; 2],
    /// The place of the torque among the vectors.
    pub(in crate::motion) torque: usize,
    /// The place of each operation's result.
    places: Vec<usize>,
}

impl Graph {
    /// Records a sum of torques of a body.
    pub(in crate::motion) fn of<'t>(
        torques: impl IntoIterator<Item = &'t super::TorqueModel>,
        rotor: &Rotor,
    ) -> Self {
        Self::recorded(rotor, |recorder| {
            let all =
                torques.into_iter().map(|torque| torque.model().record(recorder)).reduce(|sum, n| sum + n);
            all.unwrap_or_else(|| recorder.in_body(Direction::ZERO)).place
        })
    }

    /// Records what gives the place of a torque.
    pub(super) fn recorded(rotor: &Rotor, torque: impl FnOnce(&Recorder<'_>) -> usize) -> Self {
        let to_principal = rotor.principal().rotation().inverse();
        let inertia = Symmetric3::diagonal(rotor.principal().moments()).rows();
        // By their places: that two are alike in one body must not change what is recorded.
        let matrices = vec![to_principal.matrix(), to_principal.inverse().matrix(), inertia];
        let graph = RefCell::new(Self { matrices, ..Self::default() });
        let torque = torque(&Recorder { rotor, to_principal, graph: &graph });
        Self { torque, ..graph.into_inner() }
    }

    /// True if no series follows from it.
    pub(super) fn is_rough(&self) -> bool {
        self.operations.contains(&Operation::Scalar(ScalarOperation::Rough))
    }

    fn place_of(&self, operation: Operation) -> Option<usize> {
        let at = self.operations.iter().position(|known| *known == operation)?;
        self.places.get(at).copied()
    }

    fn push(&mut self, operation: Operation) -> usize {
        let count = match operation {
            Operation::Scalar(_) => &mut self.counts[0],
            Operation::Vector(_) => &mut self.counts[1],
        };
        let place = *count;
        *count += 1;
        self.operations.push(operation);
        self.places.push(place);
        place
    }

    /// The place of a number, new or not.
    fn number(&mut self, operation: ScalarOperation) -> usize {
        let operation = Operation::Scalar(operation);
        self.place_of(operation).unwrap_or_else(|| self.push(operation))
    }

    /// The place of a vector, new or not.
    fn vector(&mut self, operation: VectorOperation) -> usize {
        let operation = Operation::Vector(operation);
        self.place_of(operation).unwrap_or_else(|| self.push(operation))
    }

    fn constant(&mut self, x: f64) -> usize {
        let k = index(&mut self.constants, x, |a, b| a.to_bits() == b.to_bits());
        self.number(ScalarOperation::Constant(k))
    }

    /// The value of a number, if it is a constant.
    fn value(&self, place: usize) -> Option<f64> {
        let mut numbers = self.operations.iter().filter_map(|operation| match operation {
            Operation::Scalar(operation) => Some(operation),
            Operation::Vector(_) => None,
        });
        match numbers.nth(place) {
            Some(&ScalarOperation::Constant(k)) => self.constants.get(k).copied(),
            _ => None,
        }
    }

    /// The components of a vector, if it is a constant.
    fn vector_value(&self, place: usize) -> Option<[f64; 3]> {
        let mut vectors = self.operations.iter().filter_map(|operation| match operation {
            Operation::Vector(operation) => Some(operation),
            Operation::Scalar(_) => None,
        });
        match vectors.nth(place) {
            Some(&VectorOperation::Constant(k)) => self.vectors.get(k).copied(),
            _ => None,
        }
    }

    fn scaled(&mut self, place: usize, by: f64) -> usize {
        match self.value(place) {
            Some(x) => self.constant(x * by),
            None if by == 1.0 => place,
            None => {
                let k = index(&mut self.constants, by, |a, b| a.to_bits() == b.to_bits());
                self.number(ScalarOperation::Scale(place, k))
            }
        }
    }

    fn unary(&mut self, function: Unary, a: usize) -> usize {
        use ScalarOperation::{Add, IntegralOver, Multiply, Negate, Power, Subtract};
        if let Some(value) = self.value(a) {
            return self.constant(function.of(value));
        }
        let next = self.counts[0];
        match function {
            Unary::Negate => self.number(Negate(a)),
            Unary::Sqrt => self.number(Power(a, 0.5_f64.to_bits())),
            Unary::Power(n) => self.whole_power(a, n),
            // exp' = exp: it is its own factor
            Unary::Exp => self.integral_by(function, a, next, |_, _| {}),
            Unary::Sin => self.sine_and_cosine(a),
            Unary::Cos => self.sine_and_cosine(a) + 1,
            Unary::Tan => {
                // 1 + tan² comes after it
                let one = self.constant(1.0);
                let by = self.counts[0] + 2;
                self.integral_by(function, a, by, |graph, tan| {
                    graph.push(Operation::Scalar(Multiply(tan, tan)));
                    graph.push(Operation::Scalar(Add(tan + 1, one)));
                })
            }
            Unary::Log => self.number(IntegralOver { start: function, of: a, over: a }),
            Unary::Atan => {
                let (one, square) = (self.constant(1.0), self.number(Multiply(a, a)));
                let over = self.number(Add(one, square));
                self.number(IntegralOver { start: function, of: a, over })
            }
            Unary::Asin | Unary::Acos => {
                // √((1 − a)(1 + a)) keeps its digits near 1
                let one = self.constant(1.0);
                let (less, more) = (self.number(Subtract(one, a)), self.number(Add(one, a)));
                let square = self.number(Multiply(less, more));
                let root = self.number(Power(square, 0.5_f64.to_bits()));
                let over = if function == Unary::Asin { root } else { self.number(Negate(root)) };
                self.number(IntegralOver { start: function, of: a, over })
            }
            Unary::Abs => self.number(ScalarOperation::Rough),
        }
    }

    fn binary(&mut self, function: Binary, a: usize, b: usize) -> usize {
        use ScalarOperation::{Add, Angle, Divide, GeneralPower, Hypot, Multiply, Power, Subtract};
        match (function, self.value(a), self.value(b)) {
            (_, Some(x), Some(y)) => self.constant(function.of(x, y)),
            (Binary::Add, ..) => self.number(Add(a, b)),
            (Binary::Subtract, ..) => self.number(Subtract(a, b)),
            (Binary::Multiply, Some(x), _) => self.scaled(b, x),
            (Binary::Multiply, _, Some(y)) => self.scaled(a, y),
            (Binary::Multiply, ..) => self.number(Multiply(a, b)),
            (Binary::Divide, ..) => self.number(Divide(a, b)),
            (Binary::Power, _, Some(p)) if p.fract() == 0.0 && p.abs() <= 1e6 => {
                self.whole_power(a, p as i32)
            }
            (Binary::Power, _, Some(p)) => self.number(Power(a, p.to_bits())),
            (Binary::Power, ..) => {
                let log = self.unary(Unary::Log, a);
                let exponent = self.binary(Binary::Multiply, b, log);
                self.number(GeneralPower(a, b, exponent))
            }
            (Binary::Hypot, ..) => self.number(Hypot(a, b)),
            (Binary::Atan2, ..) => {
                let [aa, bb] = [a, b].map(|a| self.number(Multiply(a, a)));
                let square = self.number(Add(aa, bb));
                self.number(Angle(a, b, square))
            }
            _ => self.number(ScalarOperation::Rough),
        }
    }

    /// aⁿ by squaring: a may pass through zero.
    fn whole_power(&mut self, a: usize, n: i32) -> usize {
        let (mut result, mut square, mut rest) = (None, a, n.unsigned_abs());
        while rest > 0 {
            if rest & 1 == 1 {
                result = Some(match result {
                    Some(known) => self.number(ScalarOperation::Multiply(known, square)),
                    None => square,
                });
            }
            rest >>= 1;
            if rest > 0 {
                square = self.number(ScalarOperation::Multiply(square, square));
            }
        }
        let one = self.constant(1.0);
        match result {
            None => one,
            Some(power) if n < 0 => self.number(ScalarOperation::Divide(one, power)),
            Some(power) => power,
        }
    }

    /// The place of the sine, which the cosine and its negative follow.
    fn sine_and_cosine(&mut self, a: usize) -> usize {
        let by = self.counts[0] + 1;
        self.integral_by(Unary::Sin, a, by, |graph, sine| {
            let cosine = ScalarOperation::IntegralBy { start: Unary::Cos, of: a, by: sine + 2 };
            graph.push(Operation::Scalar(cosine));
            graph.push(Operation::Scalar(ScalarOperation::Negate(sine)));
        })
    }

    /// The place of an integral whose factor follows it, as `after` adds it; of the same one, if it is there.
    fn integral_by(
        &mut self,
        start: Unary,
        of: usize,
        by: usize,
        after: impl FnOnce(&mut Self, usize),
    ) -> usize {
        let is_same = |known: &Operation| matches!(known, Operation::Scalar(ScalarOperation::IntegralBy { start: s, of: a, .. }) if (*s, *a) == (start, of));
        if let Some(at) = self.operations.iter().position(is_same) {
            return self.places.get(at).copied().unwrap_or_default();
        }
        let place = self.push(Operation::Scalar(ScalarOperation::IntegralBy { start, of, by }));
        after(self, place);
        place
    }
}

/// The places of R_principal_body, R_body_principal and the inertia tensor among the matrices.
const TO_PRINCIPAL: usize = 0;
const TO_BODY: usize = 1;
const INERTIA: usize = 2;

/// The place of a value in a list, which it joins if it is not there.
fn index<T>(list: &mut Vec<T>, value: T, is_same: impl Fn(&T, &T) -> bool) -> usize {
    list.iter().position(|known| is_same(known, &value)).unwrap_or_else(|| {
        list.push(value);
        list.len() - 1
    })
}

/// Records what a law does with the state of a body.
#[derive(Debug)]
pub(in crate::motion) struct Recorder<'r> {
    rotor: &'r Rotor,
    to_principal: Rotation<Principal, Body>,
    graph: &'r RefCell<Graph>,
}

/// A number of a graph.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct NumberNode<'r> {
    graph: &'r RefCell<Graph>,
    place: usize,
}

/// A vector of a graph.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct VectorNode<'r> {
    graph: &'r RefCell<Graph>,
    pub(super) place: usize,
}

impl NumberNode<'_> {
    fn make(self, place: impl FnOnce(&mut Graph) -> usize) -> Self {
        Self { place: place(&mut self.graph.borrow_mut()), ..self }
    }
}

impl VectorNode<'_> {
    fn make(self, operation: VectorOperation) -> Self {
        Self { place: self.graph.borrow_mut().vector(operation), ..self }
    }

    /// Its components, if it is a constant.
    fn value(self) -> Option<[f64; 3]> {
        self.graph.borrow().vector_value(self.place)
    }

    /// M v
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

    /// The product with a matrix by its place.
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
        // v ↦ a × v
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

    fn constant(&self, v: Direction<Principal>) -> VectorNode<'r> {
        let k = index(&mut self.graph.borrow_mut().vectors, v.to_array(), PartialEq::eq);
        self.vector_node(VectorOperation::Constant(k))
    }

    /// What has no series.
    pub(in crate::motion) fn rough(&self) -> VectorNode<'r> {
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
        v.image_by(INERTIA)
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
