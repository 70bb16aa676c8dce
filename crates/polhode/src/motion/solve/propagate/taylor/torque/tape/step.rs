//! Operations of a tape: which of their operands change during a step, and which need each other.

use crate::motion::model::torque::graph::{Operation, ScalarOperation, VectorOperation};

/// Operation, and the index of its result.
#[derive(Clone, Copy, Debug)]
pub(super) struct TapeStep {
    pub(super) operation: Operation,
    pub(super) place: usize,
    /// Index of the norm or composition, if the operation is one.
    pub(super) beside: usize,
    pub(super) constant: Constant,
}

/// Operands that do not change during a step, or only in proportion to time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Constant {
    None,
    First,
    Second,
    All,
    /// The operand of an integral is linear in time.
    Linear,
}

/// Degree of a value as a polynomial in time: 0, 1, or [`MANY`] for all others.
pub(super) type Degree = u8;
const MANY: Degree = 2;

/// Returns the number of operations, from the first one on, that need each other's coefficients.
pub(super) fn circle_length(steps: &[TapeStep]) -> usize {
    let mut length = 1;
    for k in 0.. {
        let Some(step) = steps.get(k).filter(|_| k < length) else { break };
        if let Operation::Scalar(ScalarOperation::IntegralBy { by, .. }) = step.operation {
            let is_factor =
                |step: &TapeStep| matches!(step.operation, Operation::Scalar(_)) && step.place == by;
            length = length.max(steps.iter().position(is_factor).map_or(0, |at| at + 1));
        }
    }
    length
}

/// Classifies an operation, and returns the degree of its result, from those of the numbers and
/// vectors so far.
pub(super) fn classify(operation: Operation, [numbers, vectors]: &[Vec<Degree>; 2]) -> (Constant, Degree) {
    use ScalarOperation as S;
    use VectorOperation as V;
    let number = |place: usize| numbers.get(place).copied().unwrap_or(MANY);
    let vector = |place: usize| vectors.get(place).copied().unwrap_or(MANY);
    let constant = |first: Degree, second: Degree| match (first, second) {
        (0, 0) => Constant::All,
        (0, _) => Constant::First,
        (_, 0) => Constant::Second,
        _ => Constant::None,
    };
    let one = |degree: Degree| (constant(degree, degree), degree);
    let sum = |a: Degree, b: Degree| (constant(a, b), a.max(b));
    let product = |a: Degree, b: Degree| (constant(a, b), a.saturating_add(b).min(MANY));
    let function = |degree: Degree| one(if degree == 0 { 0 } else { MANY });
    match operation {
        Operation::Scalar(operation) => match operation {
            S::Constant(_) | S::OrbitDistance(_) | S::OrbitStrength(_) => one(0),
            S::Time => one(1),
            S::Negate(a) | S::Scale(a, _) => one(number(a)),
            S::Power(a, _) => function(number(a)),
            S::Add(a, b) | S::Subtract(a, b) => sum(number(a), number(b)),
            S::Multiply(a, b) => product(number(a), number(b)),
            S::Divide(a, b) if number(b) == 0 => (constant(number(a), 0), number(a)),
            S::Divide(a, b) => (constant(number(a), number(b)), MANY),
            S::IntegralBy { of, .. } if number(of) == 1 => (Constant::Linear, MANY),
            S::Component(v, _) => one(vector(v)),
            S::Dot(a, b) => product(vector(a), vector(b)),
            _ => one(MANY),
        },
        Operation::Vector(operation) => match operation {
            V::Constant(_) => one(0),
            V::Negate(a) | V::Scale(a, _) | V::Image(_, a) => one(vector(a)),
            V::Add(a, b) | V::Subtract(a, b) => sum(vector(a), vector(b)),
            V::Cross(a, b) | V::Product(a, b) => product(vector(a), vector(b)),
            V::Times(a, b) => product(vector(a), number(b)),
            V::Of(places) => one(places.into_iter().map(number).max().unwrap_or(MANY)),
            _ => one(MANY),
        },
    }
}
