//! Reduction of graphs to fewer operations with the same values.
//!
//! The recorded derivatives of a law in many directions contain repeated and unused operations. The
//! reduction has three parts. A linear function of a vector becomes one matrix. A cross product of
//! two images of the same vector x becomes linear in the six products x xᵀ, whose series are
//! computed once for all directions. Unused operations are removed. The matrices belong to one
//! body, so batches of bodies keep the recorded operations.

use super::graph::{Graph, Operation, ScalarOperation, VectorOperation};

type Matrix = [[f64; 3]; 3];

/// Linear form Σ M v over vectors of the graph, each of which occurs once.
type Form = Vec<(usize, Matrix)>;

/// Maximum number of terms of a form that stays symbolic. A longer sum is evaluated once, not at
/// each use.
const MOST: usize = 3;

/// Maximum number of terms of a sum that is multiplied by a number term by term.
const FEW: usize = 2;

const UNIT: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Cyclic permutation: (y, z, x) of (x, y, z).
const CYCLE: Matrix = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];

impl Graph {
    /// Returns a reduced graph for one body, restricted to the operations that the vectors `kept`
    /// need, and the new places of these vectors.
    pub(super) fn condensed(&self, kept: &[usize]) -> (Self, Vec<usize>) {
        let mut condenser = Condenser {
            graph: Self { operations: Vec::new(), counts: [0; 2], places: Vec::new(), ..self.clone() },
            forms: Vec::new(),
            places: Vec::new(),
            taken: 0,
        };
        let vectors: Vec<_> = self.vectors().collect();
        for operation in &self.operations {
            condenser.take(*operation, &vectors);
        }
        let kept: Vec<_> = kept.iter().map(|&place| condenser.place(place)).collect();
        condenser.graph.with_what_is_needed(&kept)
    }

    fn vectors(&self) -> impl Iterator<Item = VectorOperation> + '_ {
        self.operations.iter().filter_map(|operation| match operation {
            Operation::Vector(operation) => Some(*operation),
            Operation::Scalar(_) => None,
        })
    }

    /// Returns the operations that these vectors need, and the new places of the vectors.
    pub(super) fn with_what_is_needed(&self, kept: &[usize]) -> (Self, Vec<usize>) {
        // Index of the operation that produces each number and each vector.
        let mut made_by = [Vec::new(), Vec::new()];
        for (k, operation) in self.operations.iter().enumerate() {
            made_by[usize::from(matches!(operation, Operation::Vector(_)))].push(k);
        }
        let maker = |operand: Operand| match operand {
            Operand::Number(place) => made_by[0][place],
            Operand::Vector(place) => made_by[1][place],
        };
        let mut is_needed = vec![false; self.operations.len()];
        let mut open: Vec<_> = kept.iter().map(|&place| Operand::Vector(place)).collect();
        while let Some(operand) = open.pop() {
            let k = maker(operand);
            if !core::mem::replace(&mut is_needed[k], true) {
                self.operations[k].with_operands(|operand| {
                    open.push(operand);
                    operand.place()
                });
            }
        }
        let mut counts = [0; 2];
        let places: Vec<_> = self
            .operations
            .iter()
            .zip(&is_needed)
            .map(|(operation, needed)| {
                let count = &mut counts[usize::from(matches!(operation, Operation::Vector(_)))];
                *count += usize::from(*needed);
                count.saturating_sub(1)
            })
            .collect();
        let renumbered = |operand: Operand| places[maker(operand)];
        let mut graph = Self { operations: Vec::new(), counts: [0; 2], places: Vec::new(), ..self.clone() };
        for (operation, _) in self.operations.iter().zip(&is_needed).filter(|(_, needed)| **needed) {
            graph.push(operation.with_operands(renumbered));
        }
        (graph, kept.iter().map(|&place| renumbered(Operand::Vector(place))).collect())
    }
}

/// Builds a graph from the operations of another graph.
struct Condenser {
    graph: Graph,
    /// Linear form of each vector of the source graph.
    forms: Vec<Form>,
    /// Place of each vector of the source graph in the new graph, if it is there.
    places: Vec<Option<usize>>,
    /// Number of vectors of the source graph so far.
    taken: usize,
}

impl Condenser {
    fn take(&mut self, operation: Operation, source: &[VectorOperation]) {
        use VectorOperation as Op;
        if matches!(operation, Operation::Vector(_)) {
            self.taken += 1;
            // The vector belongs to a circle that is complete.
            if self.taken <= self.forms.len() {
                return;
            }
        }
        if let Operation::Vector(Op::IntegralBy { .. }) = operation {
            self.circle(source);
            return;
        }
        let form = match operation {
            // Numbers keep their places: every number is copied and none is added.
            Operation::Scalar(_) => {
                let operation = operation.with_operands(|operand| self.moved(operand));
                self.graph.push(operation);
                return;
            }
            Operation::Vector(Op::Negate(a)) => scaled(&self.forms[a], -1.0),
            Operation::Vector(Op::Scale(a, k)) => scaled(&self.forms[a], self.graph.constants[k]),
            Operation::Vector(Op::Image(k, a)) => {
                let matrix = self.graph.matrices[k];
                self.forms[a].iter().map(|(base, m)| (*base, product(&matrix, m))).collect()
            }
            Operation::Vector(Op::Add(a, b)) => self.sum([a, b], 1.0),
            Operation::Vector(Op::Subtract(a, b)) => self.sum([a, b], -1.0),
            // (M x + …) b = M (x b) + …: all directions share the same few x.
            Operation::Vector(Op::Times(a, b)) if self.forms[a].len() <= FEW => {
                let terms = self.forms[a].clone();
                terms.into_iter().map(|(x, matrix)| (self.graph.vector(Op::Times(x, b)), matrix)).collect()
            }
            Operation::Vector(Op::Cross(a, b)) => match (&self.forms[a][..], &self.forms[b][..]) {
                (&[(base, m)], &[(other, n)]) if base == other => self.bilinear(base, &m, &n),
                _ => self.as_it_is(operation),
            },
            Operation::Vector(_) => self.as_it_is(operation),
        };
        self.places.push(match &form[..] {
            [(place, matrix)] if *matrix == UNIT => Some(*place),
            _ => None,
        });
        self.forms.push(form);
    }

    /// Copies an integral with the vectors that it needs and that follow it. They keep their
    /// distances.
    fn circle(&mut self, source: &[VectorOperation]) {
        let first = self.forms.len();
        let (mut last, mut k) = (first, first);
        while k <= last {
            if let Some(VectorOperation::IntegralBy { by, .. }) = source.get(k) {
                last = last.max(*by);
            }
            k += 1;
        }
        let circle = source.get(first..=last).unwrap_or_default();
        let is_inside =
            |operand: Operand| matches!(operand, Operand::Vector(at) if (first..=last).contains(&at));
        // Other operands first, because these may add vectors.
        for operation in circle {
            Operation::Vector(*operation).with_operands(|operand| match operand {
                inside if is_inside(inside) => inside.place(),
                outside => self.moved(outside),
            });
        }
        let start = self.graph.counts[1];
        for operation in circle {
            let moved = Operation::Vector(*operation).with_operands(|operand| match operand {
                inside if is_inside(inside) => start + inside.place() - first,
                outside => self.moved(outside),
            });
            self.graph.push(moved);
        }
        for place in start..start + circle.len() {
            self.forms.push(vec![(place, UNIT)]);
            self.places.push(Some(place));
        }
    }

    fn as_it_is(&mut self, operation: Operation) -> Form {
        let operation = operation.with_operands(|operand| self.moved(operand));
        let place = self.graph.place_of(operation).unwrap_or_else(|| self.graph.push(operation));
        vec![(place, UNIT)]
    }

    fn moved(&mut self, operand: Operand) -> usize {
        match operand {
            Operand::Number(place) => place,
            Operand::Vector(place) => self.place(place),
        }
    }

    /// Returns the place in the new graph of a vector of the source graph, adding it if needed.
    fn place(&mut self, place: usize) -> usize {
        if let Some(known) = self.places[place] {
            return known;
        }
        let form = self.forms[place].clone();
        let terms: Vec<_> = form.iter().map(|(base, matrix)| self.image(*base, matrix)).collect();
        let sum = terms.into_iter().reduce(|a, b| self.graph.vector(VectorOperation::Add(a, b)));
        let made = sum.unwrap_or_else(|| {
            self.graph.vectors.push([0.0; 3]);
            self.graph.vector(VectorOperation::Constant(self.graph.vectors.len() - 1))
        });
        self.places[place] = Some(made);
        made
    }

    fn image(&mut self, base: usize, matrix: &Matrix) -> usize {
        if *matrix == UNIT {
            return base;
        }
        let matrices = &mut self.graph.matrices;
        let k = matrices.iter().position(|known| known == matrix).unwrap_or_else(|| {
            matrices.push(*matrix);
            matrices.len() - 1
        });
        self.graph.vector(VectorOperation::Image(k, base))
    }

    /// Returns a ± b.
    fn sum(&mut self, [a, b]: [usize; 2], sign: f64) -> Form {
        let sum = added(&self.forms[a], &scaled(&self.forms[b], sign));
        if sum.len() <= MOST {
            return sum;
        }
        let [a, b] = [a, b].map(|k| vec![(self.place(k), UNIT)]);
        added(&a, &scaled(&b, sign))
    }

    /// Returns M x × N x as a form in (x², y², z²) and (xy, yz, zx).
    fn bilinear(&mut self, x: usize, m: &Matrix, n: &Matrix) -> Form {
        let term = |i: usize, p: usize, q: usize| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            m[j][p] * n[k][q] - m[k][p] * n[j][q]
        };
        let squares: Matrix = core::array::from_fn(|i| core::array::from_fn(|p| term(i, p, p)));
        let mixed: Matrix = core::array::from_fn(|i| {
            core::array::from_fn(|p| term(i, p, (p + 1) % 3) + term(i, (p + 1) % 3, p))
        });
        let mut form = Form::new();
        if squares != [[0.0; 3]; 3] {
            form.push((self.graph.vector(VectorOperation::Product(x, x)), squares));
        }
        if mixed != [[0.0; 3]; 3] {
            let cycled = self.image(x, &CYCLE);
            form.push((self.graph.vector(VectorOperation::Product(x, cycled)), mixed));
        }
        form
    }
}

fn scaled(form: &Form, by: f64) -> Form {
    form.iter().map(|(base, matrix)| (*base, matrix.map(|row| row.map(|x| x * by)))).collect()
}

fn added(a: &Form, b: &Form) -> Form {
    let mut sum = a.clone();
    for (base, matrix) in b {
        match sum.iter_mut().find(|(known, _)| known == base) {
            Some((_, known)) => {
                known.as_flattened_mut().iter_mut().zip(matrix.as_flattened()).for_each(|(x, y)| *x += y);
            }
            None => sum.push((*base, *matrix)),
        }
    }
    sum
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    a.map(|row| core::array::from_fn(|k| row[0] * b[0][k] + row[1] * b[1][k] + row[2] * b[2][k]))
}

/// Operand of an operation.
#[derive(Clone, Copy, Debug)]
pub(super) enum Operand {
    Number(usize),
    Vector(usize),
}

impl Operand {
    pub(super) fn place(self) -> usize {
        match self {
            Self::Number(place) | Self::Vector(place) => place,
        }
    }
}

impl Operation {
    /// Replaces the operands of the operation.
    pub(super) fn with_operands(self, mut of: impl FnMut(Operand) -> usize) -> Self {
        match self {
            Self::Scalar(operation) => Self::Scalar(operation.with_operands(of)),
            Self::Vector(operation) => {
                use VectorOperation as Op;
                let (number, vector) = (Operand::Number, Operand::Vector);
                Self::Vector(match operation {
                    Op::Constant(_) | Op::Omega | Op::Wheels | Op::Fixed(_) | Op::Orbit(_) | Op::Turn(_) => {
                        operation
                    }
                    Op::Negate(a) => Op::Negate(of(vector(a))),
                    Op::Scale(a, k) => Op::Scale(of(vector(a)), k),
                    Op::Add(a, b) => Op::Add(of(vector(a)), of(vector(b))),
                    Op::Subtract(a, b) => Op::Subtract(of(vector(a)), of(vector(b))),
                    Op::Times(a, b) => Op::Times(of(vector(a)), of(number(b))),
                    Op::Cross(a, b) => Op::Cross(of(vector(a)), of(vector(b))),
                    Op::Product(a, b) => Op::Product(of(vector(a)), of(vector(b))),
                    Op::Quotient(a, b) => Op::Quotient(of(vector(a)), of(vector(b))),
                    Op::IntegralBy { start, of: a, by } => {
                        Op::IntegralBy { start, of: of(vector(a)), by: of(vector(by)) }
                    }
                    Op::IntegralOver { start, of: a, over } => {
                        Op::IntegralOver { start, of: of(vector(a)), over: of(vector(over)) }
                    }
                    Op::Image(k, a) => Op::Image(k, of(vector(a))),
                    Op::Of(numbers) => Op::Of(numbers.map(|a| of(number(a)))),
                })
            }
        }
    }
}

impl ScalarOperation {
    fn with_operands(self, mut of: impl FnMut(Operand) -> usize) -> Self {
        match self {
            Self::Dot(a, b) => return Self::Dot(of(Operand::Vector(a)), of(Operand::Vector(b))),
            Self::Component(v, k) => return Self::Component(of(Operand::Vector(v)), k),
            Self::Norm(v) => return Self::Norm(of(Operand::Vector(v))),
            _ => {}
        }
        let mut number = |a: usize| of(Operand::Number(a));
        match self {
            Self::Constant(_)
            | Self::Time
            | Self::TurnScalar(_)
            | Self::OrbitSquare(_)
            | Self::OrbitInverseCube(_)
            | Self::OrbitDistance(_)
            | Self::OrbitStrength(_)
            | Self::Rough => self,
            Self::Negate(a) => Self::Negate(number(a)),
            Self::Scale(a, k) => Self::Scale(number(a), k),
            Self::Add(a, b) => Self::Add(number(a), number(b)),
            Self::Subtract(a, b) => Self::Subtract(number(a), number(b)),
            Self::Multiply(a, b) => Self::Multiply(number(a), number(b)),
            Self::Divide(a, b) => Self::Divide(number(a), number(b)),
            Self::DivideOrZero(a, b) => Self::DivideOrZero(number(a), number(b)),
            Self::Power(a, p) => Self::Power(number(a), p),
            Self::PowerDifference(all, p) => Self::PowerDifference(all.map(&mut number), p),
            Self::GeneralPower(a, b, exponent) => Self::GeneralPower(number(a), number(b), number(exponent)),
            Self::Hypot(a, b) => Self::Hypot(number(a), number(b)),
            Self::IntegralBy { start, of, by } => Self::IntegralBy { start, of: number(of), by: number(by) },
            Self::IntegralOver { start, of, over } => {
                Self::IntegralOver { start, of: number(of), over: number(over) }
            }
            Self::Angle(a, b, square) => Self::Angle(number(a), number(b), number(square)),
            Self::Wrapped(a) => Self::Wrapped(number(a)),
            Self::HalfAngleOverSine(a) => Self::HalfAngleOverSine(number(a)),
            Self::HalfAngleSlope(a) => Self::HalfAngleSlope(number(a)),
            // Handled above.
            Self::Dot(..) | Self::Component(..) | Self::Norm(_) => self,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{InertiaTensor, MassProperties};
    use crate::math::vector::{Position, Velocity};
    use crate::motion::model::orbit::Orbit;
    use crate::motion::model::rotor::Rotor;
    use crate::motion::model::torque::linearization::Linearization;
    use crate::motion::model::torque::{Attracted, Drag, DragLaw, GravityGradient, TorqueModel};

    fn rotor() -> Rotor {
        let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
        Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia).unwrap())
    }

    /// Counts the operations of a kind.
    fn count(torque: &TorqueModel, is_wanted: impl Fn(&VectorOperation) -> bool) -> usize {
        let graph = Linearization::of(&rotor(), &[torque], &[]).graph;
        let wanted = |operation: &&Operation| matches!(operation, Operation::Vector(of) if is_wanted(of));
        graph.operations.iter().filter(wanted).count()
    }

    #[test]
    fn images_of_one_vector_are_multiplied_once_for_all_directions() {
        let orbit =
            Orbit::through(0.25, Position::new(1.0, 0.2, -0.1), Velocity::new(0.1, 0.5, 0.3), 0.0).unwrap();
        let torque = GravityGradient { orbit, attracted: Attracted::Tensor };
        let torque = TorqueModel::GravityGradient(Box::new(torque));
        assert_eq!(count(&torque, |of| matches!(of, VectorOperation::Cross(..))), 0);
        // ρ∘ρ and ρ∘(ρ2, ρ3, ρ1), each times µ/r₀³ |ρ|⁻⁵
        assert_eq!(count(&torque, |of| matches!(of, VectorOperation::Product(..))), 2);
        assert_eq!(count(&torque, |of| matches!(of, VectorOperation::Times(..))), 2);
    }

    #[test]
    fn what_comes_to_nothing_is_left_out() {
        let drag = Drag::new(DragLaw::Linear, [[0.3, 0.1, 0.0], [0.1, 0.4, -0.1], [0.0, -0.1, 0.2]]).unwrap();
        // Its derivatives are constant: nothing is computed from ω, which is always present.
        assert_eq!(count(&TorqueModel::Drag(drag), |of| matches!(of, VectorOperation::Omega)), 1);
        assert_eq!(count(&TorqueModel::Drag(drag), |of| matches!(of, VectorOperation::Scale(..))), 0);
    }
}
