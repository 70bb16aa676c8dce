//! Separation of recorded laws: N = c + A u + B ω + f(t) + everything else.
//!
//! The linear terms join the recurrence of the motion. f(t) has a series that is known before that
//! of the motion. Only the rest must be evaluated together with it, coefficient by coefficient.

use super::condensed::Operand;
use super::graph::{Graph, Operation, ScalarOperation, VectorOperation};
use super::polynomial::QuadraticTorque;
use crate::math::frame::Space;
use crate::math::vector::Direction;

type Matrix = [[f64; 3]; 3];

/// Torques of a graph, by their dependence on the state.
#[derive(Clone, Debug)]
pub(in crate::motion) struct Separated {
    /// c + A u + B ω, if there are such terms.
    pub(in crate::motion) linear: Option<QuadraticTorque>,
    /// u, if it occurs there.
    pub(in crate::motion) joint: Option<Direction<Space>>,
    /// Functions of time alone.
    pub(in crate::motion) forcing: Option<Graph>,
    pub(in crate::motion) rest: Option<Graph>,
}

impl Graph {
    /// Separates the torque. u is the first vector for which `may_be_joint` holds.
    pub(in crate::motion) fn separated(self, may_be_joint: impl Fn(Direction<Space>) -> bool) -> Separated {
        let joint = self.fixed.iter().position(|v| may_be_joint(*v));
        let mut separator =
            Separator { graph: self.clone(), joint, numbers: Vec::new(), vectors: Vec::new() };
        self.operations.iter().for_each(|operation| separator.take(*operation));
        let Separator { graph, vectors, .. } = separator;
        let Parts { linear, timed, rest } = vectors.get(self.torque).copied().unwrap_or_default();
        let linear = linear.filter(|linear| !linear.is_zero());
        let is_one = linear.is_none() && timed.is_none();
        if is_one || linear.as_ref().is_some_and(|linear| !linear.is_finite()) {
            return Separated { linear: None, joint: None, forcing: None, rest: Some(self) };
        }
        let of = |place: usize| {
            let (graph, kept) = graph.with_what_is_needed(&[place]);
            Self { torque: kept.first().copied().unwrap_or_default(), ..graph }
        };
        let forcing =
            |graph: Self| Self { fixed: Vec::new(), orbits: Vec::new(), turns: Vec::new(), ..graph };
        let has_joint = linear.as_ref().is_some_and(|linear| linear.of_joint.is_some());
        Separated {
            linear: linear.map(|linear| linear.torque()),
            joint: joint.filter(|_| has_joint).and_then(|k| self.fixed.get(k).copied()),
            forcing: timed.map(of).map(forcing),
            rest: rest.map(of),
        }
    }
}

/// Summands of a value, if present: a linear function of the state, and the places of a function of
/// time and of the rest.
#[derive(Clone, Copy, Debug, Default)]
struct Parts {
    linear: Option<Linear>,
    timed: Option<usize>,
    rest: Option<usize>,
}

/// c + A u + B ω. A number is the first component; the others are zero.
#[derive(Clone, Copy, Debug)]
struct Linear {
    constant: [f64; 3],
    of_joint: Option<Matrix>,
    of_omega: Option<Matrix>,
}

impl Linear {
    const NONE: Self = Self { constant: [0.0; 3], of_joint: None, of_omega: None };

    fn is_constant(&self) -> bool {
        self.of_joint.is_none() && self.of_omega.is_none()
    }

    fn is_zero(&self) -> bool {
        self.is_constant() && self.constant == [0.0; 3]
    }

    fn is_finite(&self) -> bool {
        let all = [Some([self.constant; 3]), self.of_joint, self.of_omega];
        all.iter().flatten().flatten().flatten().all(|x| x.is_finite())
    }

    /// Returns M times the value.
    fn image(&self, by: &Matrix) -> Self {
        let row = |row: &[f64; 3], v: [f64; 3]| row[0] * v[0] + row[1] * v[1] + row[2] * v[2];
        let product = |m: Matrix| {
            let column = |k: usize| [m[0][k], m[1][k], m[2][k]];
            by.map(|of| [0, 1, 2].map(|k| row(&of, column(k))))
        };
        Self {
            constant: by.map(|of| row(&of, self.constant)),
            of_joint: self.of_joint.map(product),
            of_omega: self.of_omega.map(product),
        }
    }

    fn plus(&self, b: &Self) -> Self {
        let add = |a: [f64; 3], b: [f64; 3]| [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
        let both = |a: Option<Matrix>, b: Option<Matrix>| match (a, b) {
            (Some(a), Some(b)) => Some([add(a[0], b[0]), add(a[1], b[1]), add(a[2], b[2])]),
            (one, other) => one.or(other),
        };
        Self {
            constant: add(self.constant, b.constant),
            of_joint: both(self.of_joint, b.of_joint),
            of_omega: both(self.of_omega, b.of_omega),
        }
    }

    fn torque(&self) -> QuadraticTorque {
        let columns =
            |m: Option<Matrix>| m.map_or([[0.0; 3]; 3], |m| [0, 1, 2].map(|column| m.map(|row| row[column])));
        QuadraticTorque {
            constant: self.constant,
            of_joint: columns(self.of_joint),
            of_omega: columns(self.of_omega),
            has_omega: self.of_omega.is_some(),
            products: [0.0; 3],
        }
    }
}

impl Parts {
    fn linear(linear: Linear) -> Self {
        Self { linear: Some(linear), ..Self::default() }
    }

    /// Returns the constant that the value is, if it is one.
    fn constant(&self) -> Option<[f64; 3]> {
        let constant = self.linear.as_ref().filter(|linear| linear.is_constant());
        constant.filter(|_| self.timed.is_none() && self.rest.is_none()).map(|linear| linear.constant)
    }

    fn is_of_time(&self) -> bool {
        self.rest.is_none() && self.linear.as_ref().is_none_or(Linear::is_constant)
    }
}

/// Separates each value of a graph, and adds the operations of new summands to it.
struct Separator {
    graph: Graph,
    /// Index of u among the fixed vectors.
    joint: Option<usize>,
    /// Parts of the numbers and of the vectors so far.
    numbers: Vec<Parts>,
    vectors: Vec<Parts>,
}

impl Separator {
    fn take(&mut self, operation: Operation) {
        match operation {
            Operation::Scalar(scalar) => {
                let parts = self.number(scalar, self.numbers.len());
                self.numbers.push(parts);
            }
            Operation::Vector(vector) => {
                let parts = self.vector(vector, self.vectors.len());
                self.vectors.push(parts);
            }
        }
    }

    fn number(&mut self, operation: ScalarOperation, own: usize) -> Parts {
        use ScalarOperation as Op;
        let new = |of: fn(usize, usize) -> Op, by: usize| move |place| Operation::Scalar(of(place, by));
        let negate = &|a, _| Operation::Scalar(Op::Negate(a));
        match operation {
            Op::Constant(k) => {
                let x = self.graph.constants.get(k).copied().unwrap_or(f64::NAN);
                Parts::linear(Linear { constant: [x, 0.0, 0.0], ..Linear::NONE })
            }
            Op::Time => Parts { timed: Some(own), ..Parts::default() },
            Op::Negate(a) => self.image(self.numbers[a], own, &scale(-1.0), new(|a, _| Op::Negate(a), 0)),
            Op::Scale(a, k) => {
                let by = self.graph.constants.get(k).copied().unwrap_or(f64::NAN);
                self.image(self.numbers[a], own, &scale(by), new(Op::Scale, k))
            }
            Op::Component(v, k) => {
                let mut row = [[0.0; 3]; 3];
                row[0][k] = 1.0;
                self.image(self.vectors[v], own, &row, new(Op::Component, k))
            }
            Op::Add(a, b) => {
                let of = [a, b].map(|a| self.numbers[a]);
                self.sum(of, own, 1.0, [&|a, b| Operation::Scalar(Op::Add(a, b)), negate])
            }
            Op::Subtract(a, b) => {
                let of = [a, b].map(|a| self.numbers[a]);
                self.sum(of, own, -1.0, [&|a, b| Operation::Scalar(Op::Subtract(a, b)), negate])
            }
            Op::Divide(a, b) => match self.numbers[b].constant() {
                Some([by, ..]) => self.image(self.numbers[a], own, &scale(1.0 / by), new(Op::Divide, b)),
                None => self.whole(Operation::Scalar(operation), own),
            },
            _ => self.whole(Operation::Scalar(operation), own),
        }
    }

    fn vector(&mut self, operation: VectorOperation, own: usize) -> Parts {
        use VectorOperation as Op;
        let new = |of: fn(usize, usize) -> Op, by: usize| move |place| Operation::Vector(of(place, by));
        let negate = &|a, _| Operation::Vector(Op::Negate(a));
        match operation {
            Op::Constant(k) => {
                let constant = self.graph.vectors.get(k).copied().unwrap_or([f64::NAN; 3]);
                Parts::linear(Linear { constant, ..Linear::NONE })
            }
            Op::Omega => Parts::linear(Linear { of_omega: Some(scale(1.0)), ..Linear::NONE }),
            Op::Fixed(k) if self.joint == Some(k) => {
                Parts::linear(Linear { of_joint: Some(scale(1.0)), ..Linear::NONE })
            }
            Op::Negate(a) => self.image(self.vectors[a], own, &scale(-1.0), new(|a, _| Op::Negate(a), 0)),
            Op::Scale(a, k) => {
                let by = self.graph.constants.get(k).copied().unwrap_or(f64::NAN);
                self.image(self.vectors[a], own, &scale(by), new(Op::Scale, k))
            }
            Op::Image(k, a) => {
                let by = self.graph.matrices.get(k).copied().unwrap_or([[f64::NAN; 3]; 3]);
                self.image(self.vectors[a], own, &by, new(|a, k| Op::Image(k, a), k))
            }
            Op::Add(a, b) => {
                let of = [a, b].map(|a| self.vectors[a]);
                self.sum(of, own, 1.0, [&|a, b| Operation::Vector(Op::Add(a, b)), negate])
            }
            Op::Subtract(a, b) => {
                let of = [a, b].map(|a| self.vectors[a]);
                self.sum(of, own, -1.0, [&|a, b| Operation::Vector(Op::Subtract(a, b)), negate])
            }
            Op::Times(a, b) => match (self.vectors[a].constant(), self.numbers[b].constant()) {
                (_, Some([by, ..])) => self.image(self.vectors[a], own, &scale(by), new(Op::Times, b)),
                (Some([x, y, z]), _) => {
                    let column = [[x, 0.0, 0.0], [y, 0.0, 0.0], [z, 0.0, 0.0]];
                    let by_number = move |place| Operation::Vector(Op::Times(a, place));
                    self.image(self.numbers[b], own, &column, by_number)
                }
                _ => self.whole(Operation::Vector(operation), own),
            },
            Op::Cross(a, b) => match (self.vectors[a].constant(), self.vectors[b].constant()) {
                (_, Some([x, y, z])) => {
                    let by = [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]];
                    self.image(self.vectors[a], own, &by, new(Op::Cross, b))
                }
                (Some([x, y, z]), _) => {
                    let by = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
                    self.image(self.vectors[b], own, &by, new(|b, a| Op::Cross(a, b), a))
                }
                _ => self.whole(Operation::Vector(operation), own),
            },
            Op::Of(numbers) => self.of_components(numbers, own),
            _ => self.whole(Operation::Vector(operation), own),
        }
    }

    /// Returns the parts of a linear map of a value. `new`: the same map of a part.
    fn image(&mut self, of: Parts, own: usize, by: &Matrix, new: impl Fn(usize) -> Operation) -> Parts {
        match of {
            Parts { linear: None, timed: Some(_), rest: None } => {
                Parts { timed: Some(own), ..Parts::default() }
            }
            Parts { linear: None, timed: None, rest: Some(_) } => {
                Parts { rest: Some(own), ..Parts::default() }
            }
            Parts { linear, timed, rest } => Parts {
                linear: linear.map(|linear| linear.image(by)),
                timed: timed.map(|place| self.place(new(place))),
                rest: rest.map(|place| self.place(new(place))),
            },
        }
    }

    /// Returns the parts of a + b or, for the sign −1, of a − b.
    fn sum(
        &mut self,
        [a, b]: [Parts; 2],
        own: usize,
        sign: f64,
        new: [&dyn Fn(usize, usize) -> Operation; 2],
    ) -> Parts {
        let [join, negate] = new;
        let is_pure = a.linear.is_none() && b.linear.is_none();
        let mut both = |[a, b]: [Option<usize>; 2], is_all: bool| match (a, b) {
            (Some(_), Some(_)) if is_all && is_pure => Some(own),
            (Some(a), Some(b)) => Some(self.place(join(a, b))),
            (None, Some(b)) if sign < 0.0 => Some(self.place(negate(b, b))),
            (a, b) => a.or(b),
        };
        let (timed, rest) = ([a.timed, b.timed], [a.rest, b.rest]);
        Parts {
            timed: both(timed, rest == [None; 2]),
            rest: both(rest, timed == [None; 2]),
            linear: match (a.linear, b.linear.map(|b| b.image(&scale(sign)))) {
                (Some(a), Some(b)) => Some(a.plus(&b)),
                (a, b) => a.or(b),
            },
        }
    }

    /// Returns the parts of a vector with these components.
    fn of_components(&mut self, numbers: [usize; 3], own: usize) -> Parts {
        let parts = numbers.map(|place| self.numbers[place]);
        let linear = parts.iter().enumerate().filter_map(|(row, part)| {
            let mut to_row = [[0.0; 3]; 3];
            to_row[row][0] = 1.0;
            part.linear.as_ref().map(|linear| linear.image(&to_row))
        });
        let linear = linear.reduce(|a, b| a.plus(&b));
        let places = |which: fn(&Parts) -> Option<usize>| [0, 1, 2].map(|k| which(&parts[k]));
        let mut vector = |places: [Option<usize>; 3]| {
            if places == [None; 3] {
                return None;
            }
            if places == numbers.map(Some) {
                return Some(own);
            }
            let numbers = places.map(|place| place.unwrap_or_else(|| self.graph.constant(0.0)));
            Some(self.graph.vector(VectorOperation::Of(numbers)))
        };
        Parts { timed: vector(places(|part| part.timed)), rest: vector(places(|part| part.rest)), linear }
    }

    /// Returns the parts of a value that is not separated: a function of time, or the rest.
    fn whole(&self, operation: Operation, own: usize) -> Parts {
        let mut is_of_time = !depends_on_motion(operation);
        operation.with_operands(|operand| {
            let parts = match operand {
                Operand::Number(place) => self.numbers.get(place),
                Operand::Vector(place) => self.vectors.get(place),
            };
            // The factor of an integral may follow it, and depends on the same value.
            is_of_time &= parts.is_none_or(Parts::is_of_time);
            operand.place()
        });
        if is_of_time {
            Parts { timed: Some(own), ..Parts::default() }
        } else {
            Parts { rest: Some(own), ..Parts::default() }
        }
    }

    fn place(&mut self, operation: Operation) -> usize {
        match operation {
            Operation::Scalar(operation) => self.graph.number(operation),
            Operation::Vector(operation) => self.graph.vector(operation),
        }
    }
}

/// True for operations that use the motion, an orbit or the state at the start of a step.
fn depends_on_motion(operation: Operation) -> bool {
    use ScalarOperation as S;
    use VectorOperation as V;
    match operation {
        Operation::Scalar(operation) => matches!(
            operation,
            S::Norm(_)
                | S::TurnScalar(_)
                | S::OrbitSquare(_)
                | S::OrbitInverseCube(_)
                | S::OrbitDistance(_)
                | S::OrbitStrength(_)
                | S::HalfAngleOverSine(_)
                | S::HalfAngleSlope(_)
                | S::Rough
        ),
        Operation::Vector(operation) => {
            matches!(operation, V::Omega | V::Wheels | V::Fixed(_) | V::Orbit(_) | V::Turn(_))
        }
    }
}

fn scale(by: f64) -> Matrix {
    [[by, 0.0, 0.0], [0.0, by, 0.0], [0.0, 0.0, by]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{InertiaTensor, MassProperties};
    use crate::math::formula::{Binary, Formula, Instruction, Unary};
    use crate::math::vector::Position;
    use crate::motion::model::rotor::Rotor;
    use crate::motion::model::torque::{FormulaTorque, TorqueModel};

    /// Returns the separated torque of formulas a ωx + f(sin t) + g(ωy²), each with its factor.
    fn separated(factors: [[f64; 3]; 3]) -> Separated {
        let (times, plus) = (Instruction::Binary(Binary::Multiply), Instruction::Binary(Binary::Add));
        let formula = |[linear, timed, square]: [f64; 3]| {
            let mut all = vec![Instruction::Constant(0.7)];
            let terms = [
                (linear, vec![Instruction::Variable(1)]),
                (timed, vec![Instruction::Variable(0), Instruction::Unary(Unary::Sin)]),
                (square, vec![Instruction::Variable(2), Instruction::Unary(Unary::Power(2))]),
            ];
            for (factor, term) in terms.into_iter().filter(|(factor, _)| *factor != 0.0) {
                all.extend(term);
                all.extend([Instruction::Constant(factor), times, plus]);
            }
            Formula::new(all).unwrap()
        };
        let torque = TorqueModel::Formula(Box::new(FormulaTorque::Body(factors.map(formula))));
        // The principal axes are the body axes.
        let inertia = InertiaTensor::diagonal([1.0, 2.0, 2.5]).unwrap();
        let rotor = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia).unwrap());
        Graph::of([&torque], &rotor).separated(|_| true)
    }

    #[test]
    fn each_term_is_where_it_belongs() {
        let all = separated([[0.2, 0.3, 0.0], [-0.4, 0.0, 0.5], [0.0, 0.0, 0.0]]);
        let linear = all.linear.unwrap();
        assert_eq!(linear.constant, [0.7; 3]);
        assert_eq!(linear.of_omega, [[0.2, -0.4, 0.0], [0.0; 3], [0.0; 3]]);
        assert!(all.joint.is_none() && all.forcing.is_some() && all.rest.is_some());
        let linear_and_timed = separated([[0.2, 0.3, 0.0], [-0.4, 0.0, 0.0], [0.1, -0.6, 0.0]]);
        assert!(linear_and_timed.linear.is_some() && linear_and_timed.forcing.is_some());
        assert!(linear_and_timed.rest.is_none());
        let only_linear = separated([[0.2, 0.0, 0.0], [-0.4, 0.0, 0.0], [0.1, 0.0, 0.0]]);
        assert!(only_linear.forcing.is_none() && only_linear.rest.is_none());
    }

    #[test]
    fn an_infinite_factor_stays_in_the_law() {
        let infinite = separated([[f64::INFINITY, 0.3, 0.0], [0.1, 0.2, 0.3], [0.0; 3]]);
        assert!(infinite.linear.is_none() && infinite.forcing.is_none() && infinite.rest.is_some());
    }
}
