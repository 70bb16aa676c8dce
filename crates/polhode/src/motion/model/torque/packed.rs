//! Packing of recorded laws: three numbers that are computed alike become one vector.
//!
//! Many laws treat the components alike, such as N = −k atan(ω/ω₀). A register holds a vector, so
//! that one operation on it replaces three.

use super::condensed::Operand;
use super::graph::{Graph, Operation, ScalarOperation, VectorOperation, index};

impl Graph {
    /// Returns the graph with vectors in place of numbers that are computed alike. Returns it
    /// unchanged if no function of three components is.
    pub(in crate::motion) fn packed(self) -> Self {
        let (scalars, operations): (Vec<_>, _) = (self.scalars().collect(), self.operations.clone());
        let graph = Self { operations: Vec::new(), counts: [0; 2], places: Vec::new(), ..self.clone() };
        let mut packer = Packer { graph, scalars, vectors: Vec::new(), known: Vec::new(), functions: 0 };
        operations.into_iter().for_each(|operation| packer.take(operation));
        if packer.functions == 0 {
            return self;
        }
        let torque = packer.vectors.get(self.torque).copied().unwrap_or_default();
        let (graph, kept) = packer.graph.condensed(&[torque]);
        Self { torque: kept.first().copied().unwrap_or_default(), ..graph }.with_own_matrices()
    }

    /// Gives each image a matrix of its own, so that operations do not depend on which matrices of a
    /// body are equal.
    fn with_own_matrices(mut self) -> Self {
        let matrices = core::mem::take(&mut self.matrices);
        for operation in &mut self.operations {
            if let Operation::Vector(VectorOperation::Image(k, _)) = operation {
                self.matrices.push(matrices[*k]);
                *k = self.matrices.len() - 1;
            }
        }
        self
    }

    fn scalars(&self) -> impl Iterator<Item = ScalarOperation> + '_ {
        self.operations.iter().filter_map(|operation| match operation {
            Operation::Scalar(operation) => Some(*operation),
            Operation::Vector(_) => None,
        })
    }
}

/// Builds a graph from the operations of another one. Numbers keep their places.
struct Packer {
    graph: Graph,
    /// Operations of all numbers.
    scalars: Vec<ScalarOperation>,
    /// Place in the new graph of each vector of the old one.
    vectors: Vec<usize>,
    /// Numbers that were packed, and the place of their vector.
    known: Vec<([usize; 3], usize)>,
    /// Number of packed functions that are not linear.
    functions: usize,
}

impl Packer {
    fn take(&mut self, operation: Operation) {
        if let Operation::Vector(VectorOperation::Of(numbers)) = operation
            && let Some(place) = self.pack_if_worthwhile(numbers)
        {
            self.vectors.push(place);
            return;
        }
        let operation = operation.with_operands(|operand| match operand {
            Operand::Number(place) => place,
            Operand::Vector(place) => self.vectors[place],
        });
        match operation {
            // Numbers are not merged: an integral refers to those that follow it.
            Operation::Scalar(_) => {
                self.graph.push(operation);
            }
            Operation::Vector(vector) => self.vectors.push(self.graph.vector(vector)),
        }
    }

    fn pack_if_worthwhile(&mut self, numbers: [usize; 3]) -> Option<usize> {
        let before = self.functions;
        self.pack(numbers).filter(|_| self.functions > before)
    }

    /// Returns the place of a vector of these numbers, packed as far as possible.
    fn operand(&mut self, numbers: [usize; 3]) -> usize {
        self.pack(numbers).unwrap_or_else(|| self.graph.vector(VectorOperation::Of(numbers)))
    }

    /// Packs numbers whose last operations are alike.
    fn pack(&mut self, numbers: [usize; 3]) -> Option<usize> {
        if let Some((_, place)) = self.known.iter().find(|(known, _)| *known == numbers) {
            return Some(*place);
        }
        let place = self.packed(numbers)?;
        self.known.push((numbers, place));
        Some(place)
    }

    fn packed(&mut self, numbers: [usize; 3]) -> Option<usize> {
        use ScalarOperation as S;
        use VectorOperation as V;
        let operations = numbers.map(|place| self.scalars[place]);
        let operation = match operations {
            [S::Constant(a), S::Constant(b), S::Constant(c)] => self.constant([a, b, c]),
            [S::Component(v, 0), S::Component(w, 1), S::Component(x, 2)] if v == w && w == x => {
                return self.vectors.get(v).copied();
            }
            [S::Negate(a), S::Negate(b), S::Negate(c)] => V::Negate(self.operand([a, b, c])),
            [S::Scale(a, k), S::Scale(b, l), S::Scale(c, m)] => {
                let [x, y, z] = [k, l, m].map(|k| self.constant_value(k));
                let diagonal = [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]];
                V::Image(index(&mut self.graph.matrices, diagonal, |a, b| a == b), self.operand([a, b, c]))
            }
            [S::Add(a, d), S::Add(b, e), S::Add(c, f)] => {
                V::Add(self.operand([a, b, c]), self.operand([d, e, f]))
            }
            [S::Subtract(a, d), S::Subtract(b, e), S::Subtract(c, f)] => {
                V::Subtract(self.operand([a, b, c]), self.operand([d, e, f]))
            }
            [S::Multiply(a, d), S::Multiply(b, e), S::Multiply(c, f)] => {
                self.functions += 1;
                match ([a, b, c], [d, e, f]) {
                    (vector, number) if number == [d; 3] => V::Times(self.operand(vector), d),
                    (number, vector) if number == [a; 3] => V::Times(self.operand(vector), a),
                    (first, second) => V::Product(self.operand(first), self.operand(second)),
                }
            }
            [S::Divide(a, d), S::Divide(b, e), S::Divide(c, f)] => {
                self.functions += 1;
                V::Quotient(self.operand([a, b, c]), self.operand([d, e, f]))
            }
            [
                S::IntegralOver { start, of: a, over: d },
                S::IntegralOver { start: second, of: b, over: e },
                S::IntegralOver { start: third, of: c, over: f },
            ] if [second, third] == [start; 2] => {
                self.functions += 1;
                let (of, over) = (self.operand([a, b, c]), self.operand([d, e, f]));
                V::IntegralOver { start, of, over }
            }
            [S::IntegralBy { .. }, S::IntegralBy { .. }, S::IntegralBy { .. }] => {
                return self.circle(numbers);
            }
            _ => return None,
        };
        Some(self.graph.vector(operation))
    }

    /// Returns the value of a constant, by index.
    fn constant_value(&self, k: usize) -> f64 {
        self.graph.constants.get(k).copied().unwrap_or(f64::NAN)
    }

    fn constant(&mut self, places: [usize; 3]) -> VectorOperation {
        let values = places.map(|k| self.constant_value(k));
        let is_same = |one: &[f64; 3], other: &[f64; 3]| one.map(f64::to_bits) == other.map(f64::to_bits);
        VectorOperation::Constant(index(&mut self.graph.vectors, values, is_same))
    }

    /// Packs three circles of numbers that need each other's coefficients, such as sine, cosine and
    /// negative sine.
    fn circle(&mut self, numbers: [usize; 3]) -> Option<usize> {
        let lengths = numbers.map(|place| self.circle_length(place));
        let length = lengths[0]?;
        if lengths != [Some(length); 3] || (1..3).any(|k| numbers[k - 1] + length > numbers[k]) {
            return None;
        }
        let all: Vec<[ScalarOperation; 3]> =
            (0..length).map(|k| numbers.map(|first| self.scalars[first + k])).collect();
        let is_inside = |place: usize, lane: usize| (numbers[lane]..numbers[lane] + length).contains(&place);
        // Operands of the circle first: its own vectors must follow each other.
        let mut outside = Vec::new();
        for operations in &all {
            let [a, b, c] = [0, 1, 2].map(|lane| operands(&operations[lane]));
            for ((a, b), c) in a?.into_iter().zip(b?).zip(c?) {
                let inside = [is_inside(a, 0), is_inside(b, 1), is_inside(c, 2)];
                match inside {
                    [true, true, true] => {
                        let offset = a - numbers[0];
                        if [b - numbers[1], c - numbers[2]] != [offset; 2] {
                            return None;
                        }
                    }
                    [false, false, false] => outside.push([a, b, c]),
                    _ => return None,
                }
            }
        }
        let kinds = |operations: &[ScalarOperation; 3]| operations.map(|one| core::mem::discriminant(&one));
        if all.iter().map(kinds).any(|[a, b, c]| a != b || b != c) {
            return None;
        }
        outside.iter().for_each(|numbers| {
            let place = self.operand(*numbers);
            self.known.push((*numbers, place));
        });
        let first = self.graph.counts[1];
        for operations in &all {
            let place = |packer: &Self, at: [usize; 3]| {
                if is_inside(at[0], 0) {
                    return Some(first + at[0] - numbers[0]);
                }
                packer.known.iter().find(|(known, _)| *known == at).map(|(_, place)| *place)
            };
            use ScalarOperation as S;
            use VectorOperation as V;
            let vector = match *operations {
                [
                    S::IntegralBy { start, of: a, by: d },
                    S::IntegralBy { start: second, of: b, by: e },
                    S::IntegralBy { start: third, of: c, by: f },
                ] if [second, third] == [start; 2] => {
                    V::IntegralBy { start, of: place(self, [a, b, c])?, by: place(self, [d, e, f])? }
                }
                [S::Negate(a), S::Negate(b), S::Negate(c)] => V::Negate(place(self, [a, b, c])?),
                [S::Multiply(a, d), S::Multiply(b, e), S::Multiply(c, f)] => {
                    V::Product(place(self, [a, b, c])?, place(self, [d, e, f])?)
                }
                [S::Add(a, d), S::Add(b, e), S::Add(c, f)] => {
                    V::Add(place(self, [a, b, c])?, place(self, [d, e, f])?)
                }
                [S::Subtract(a, d), S::Subtract(b, e), S::Subtract(c, f)] => {
                    V::Subtract(place(self, [a, b, c])?, place(self, [d, e, f])?)
                }
                _ => return None,
            };
            self.graph.push(Operation::Vector(vector));
        }
        for k in 0..length {
            self.known.push((numbers.map(|first| first + k), first + k));
        }
        self.functions += 1;
        Some(first)
    }

    /// Returns the number of numbers from an integral to the last one that its circle needs.
    fn circle_length(&self, first: usize) -> Option<usize> {
        let mut length = 1;
        let mut k = 0;
        while k < length {
            if let ScalarOperation::IntegralBy { by, .. } = *self.scalars.get(first + k)? {
                length = length.max((by + 1).saturating_sub(first));
            }
            k += 1;
        }
        Some(length)
    }
}

/// Returns the operands of the operations that occur in circles.
fn operands(operation: &ScalarOperation) -> Option<Vec<usize>> {
    use ScalarOperation as S;
    match *operation {
        S::IntegralBy { of, by, .. } => Some(vec![of, by]),
        S::Negate(a) => Some(vec![a]),
        S::Multiply(a, b) | S::Add(a, b) | S::Subtract(a, b) => Some(vec![a, b]),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{InertiaTensor, MassProperties};
    use crate::math::formula::{Binary, Formula, Instruction, Unary};
    use crate::math::vector::Position;
    use crate::motion::model::rotor::Rotor;
    use crate::motion::model::torque::{FormulaTorque, TorqueModel};

    /// Returns the packed torque with components kᵢ f(ωᵢ).
    fn packed(functions: [Unary; 3]) -> Graph {
        let formula = |k: usize| {
            let factor = Instruction::Constant(0.3 + k as f64);
            let times = Instruction::Binary(Binary::Multiply);
            let all = [Instruction::Variable(1 + k), Instruction::Unary(functions[k]), factor, times];
            Formula::new(all).unwrap()
        };
        let torque = TorqueModel::Formula(Box::new(FormulaTorque::Body([0, 1, 2].map(formula))));
        let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
        let rotor = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia).unwrap());
        Graph::of([&torque], &rotor).packed()
    }

    fn count(graph: &Graph, is_wanted: impl Fn(&Operation) -> bool) -> usize {
        graph.operations.iter().filter(|operation| is_wanted(operation)).count()
    }

    #[test]
    fn three_functions_are_one() {
        let is_number = |operation: &Operation| matches!(operation, Operation::Scalar(of) if !matches!(of, ScalarOperation::Constant(_)));
        let arctangent = packed([Unary::Atan; 3]);
        assert_eq!(count(&arctangent, is_number), 0);
        let integrals = |operation: &Operation| {
            matches!(operation, Operation::Vector(VectorOperation::IntegralOver { .. }))
        };
        assert_eq!(count(&arctangent, integrals), 1);
        // the sine, the cosine and the negative sine
        let sine = packed([Unary::Sin; 3]);
        assert_eq!(count(&sine, is_number), 0);
        let circle = |operation: &Operation| {
            matches!(operation, Operation::Vector(VectorOperation::IntegralBy { .. }))
        };
        assert_eq!(count(&sine, circle), 2);
        // Other functions stay numbers.
        assert!(count(&packed([Unary::Sin, Unary::Cos, Unary::Exp]), is_number) > 0);
    }
}
