//! Laws as graphs: each distinct value, with the operation that computes it from others.
//!
//! A law that runs over a `Recorder` (`recorder.rs`) stores its operations here: those of numbers,
//! and those of vectors along principal axes. They are in topological order: each operation follows
//! its operands. `propagate/taylor/torque/tape.rs` computes their Taylor coefficients. Data that
//! differ between bodies (constants, directions, orbits) are stored separately, so that bodies with
//! the same operations can be computed in a batch.

use crate::math::formula::{Binary, Unary};
use crate::math::frame::Space;
use crate::math::rotation::Attitude;
use crate::math::vector::Direction;
use crate::motion::model::orbit::Orbit;

/// Operation. Its result is the next number, or the next vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::motion) enum Operation {
    Scalar(ScalarOperation),
    Vector(VectorOperation),
}

/// Operation that produces a number. Operands are places among the numbers or among the vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::motion) enum ScalarOperation {
    /// Constant, by index.
    Constant(usize),
    Time,
    Negate(usize),
    /// Product with a constant, by index.
    Scale(usize, usize),
    Add(usize, usize),
    Subtract(usize, usize),
    Multiply(usize, usize),
    Divide(usize, usize),
    /// Quotient; zero if the divisor is zero at the start of a step.
    DivideOrZero(usize, usize),
    /// aᵖ; p is given by its bits.
    Power(usize, u64),
    /// aᵖ − (a + δ)ᵖ, from a, δ, aᵖ and a + δ.
    PowerDifference([usize; 4], u64),
    /// aᵇ = exp(b log a); the exponent is the last operand.
    GeneralPower(usize, usize, usize),
    Hypot(usize, usize),
    /// ∫ of' by, with the function `start` of `of` as initial value. `by` may follow this
    /// operation.
    IntegralBy {
        start: Unary,
        of: usize,
        by: usize,
    },
    /// ∫ of'/over, with the function `start` of `of` as initial value.
    IntegralOver {
        start: Unary,
        of: usize,
        over: usize,
    },
    /// Angle of (b, a); the last operand is a² + b².
    Angle(usize, usize, usize),
    /// Angle reduced to −π … π at the start of a step.
    Wrapped(usize),
    /// arccos w/√(1 − w²), and its derivative with respect to w.
    HalfAngleOverSine(usize),
    HalfAngleSlope(usize),
    Dot(usize, usize),
    /// Component along a principal axis.
    Component(usize, usize),
    Norm(usize),
    /// Scalar part w of a rotation quaternion, by index.
    TurnScalar(usize),
    /// |ρ|², |ρ|⁻³, r₀ and µ/r₀³ of an orbit, by index.
    OrbitSquare(usize),
    OrbitInverseCube(usize),
    OrbitDistance(usize),
    OrbitStrength(usize),
    /// Value without a power series.
    Rough,
}

/// Operation that produces a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::motion) enum VectorOperation {
    /// Constant vector, by index.
    Constant(usize),
    Omega,
    /// Angular momentum Σ h a of the wheels.
    Wheels,
    /// Vector fixed in space, by index.
    Fixed(usize),
    /// ρ of an orbit, by index.
    Orbit(usize),
    /// Vector part v of a rotation quaternion, by index.
    Turn(usize),
    Negate(usize),
    /// Product with a constant, by index.
    Scale(usize, usize),
    Add(usize, usize),
    Subtract(usize, usize),
    /// Product of a vector and a number.
    Times(usize, usize),
    Cross(usize, usize),
    /// Component-wise product.
    Product(usize, usize),
    /// Quotient, component by component.
    Quotient(usize, usize),
    /// ∫ of' by, component by component; see [`ScalarOperation::IntegralBy`].
    IntegralBy {
        start: Unary,
        of: usize,
        by: usize,
    },
    /// ∫ of'/over, component by component.
    IntegralOver {
        start: Unary,
        of: usize,
        over: usize,
    },
    /// Product with a matrix, by index.
    Image(usize, usize),
    /// Vector from three numbers, along principal axes.
    Of([usize; 3]),
}

/// Operations of one or several laws, and the data of a body that they use.
#[derive(Clone, Debug, Default)]
pub(in crate::motion) struct Graph {
    pub(in crate::motion) operations: Vec<Operation>,
    pub(in crate::motion) constants: Vec<f64>,
    pub(in crate::motion) vectors: Vec<[f64; 3]>,
    /// Matrices, by rows.
    pub(in crate::motion) matrices: Vec<[[f64; 3]; 3]>,
    pub(in crate::motion) fixed: Vec<Direction<Space>>,
    pub(in crate::motion) orbits: Vec<Orbit>,
    /// Rest attitudes of rotations, each with true if w is made positive.
    pub(in crate::motion) turns: Vec<(Attitude, bool)>,
    /// Numbers of scalar and of vector values.
    pub(in crate::motion) counts: [usize; 2],
    /// Place of the torque among the vectors.
    pub(in crate::motion) torque: usize,
    /// Place of the result of each operation.
    pub(super) places: Vec<usize>,
    /// True if a law used the rotor itself.
    pub(super) asks_for_rotor: bool,
}

impl Graph {
    /// True if some value has no power series.
    pub(super) fn is_rough(&self) -> bool {
        self.operations.contains(&Operation::Scalar(ScalarOperation::Rough))
    }

    pub(super) fn place_of(&self, operation: Operation) -> Option<usize> {
        let at = self.operations.iter().position(|known| *known == operation)?;
        self.places.get(at).copied()
    }

    pub(super) fn push(&mut self, operation: Operation) -> usize {
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

    /// Returns the place of a number, adding it if needed.
    pub(super) fn number(&mut self, operation: ScalarOperation) -> usize {
        let operation = Operation::Scalar(operation);
        self.place_of(operation).unwrap_or_else(|| self.push(operation))
    }

    /// Returns the place of a vector, adding it if needed.
    pub(super) fn vector(&mut self, operation: VectorOperation) -> usize {
        let operation = Operation::Vector(operation);
        self.place_of(operation).unwrap_or_else(|| self.push(operation))
    }

    pub(super) fn constant(&mut self, x: f64) -> usize {
        let k = index(&mut self.constants, x, |a, b| a.to_bits() == b.to_bits());
        self.number(ScalarOperation::Constant(k))
    }

    /// Returns the value of a number if it is a constant.
    pub(super) fn value(&self, place: usize) -> Option<f64> {
        let mut numbers = self.operations.iter().filter_map(|operation| match operation {
            Operation::Scalar(operation) => Some(operation),
            Operation::Vector(_) => None,
        });
        match numbers.nth(place) {
            Some(&ScalarOperation::Constant(k)) => self.constants.get(k).copied(),
            _ => None,
        }
    }

    /// Returns the components of a vector if it is a constant.
    pub(super) fn vector_value(&self, place: usize) -> Option<[f64; 3]> {
        let mut vectors = self.operations.iter().filter_map(|operation| match operation {
            Operation::Vector(operation) => Some(operation),
            Operation::Scalar(_) => None,
        });
        match vectors.nth(place) {
            Some(&VectorOperation::Constant(k)) => self.vectors.get(k).copied(),
            _ => None,
        }
    }

    pub(super) fn scaled(&mut self, place: usize, by: f64) -> usize {
        match self.value(place) {
            Some(x) => self.constant(x * by),
            None if by == 1.0 => place,
            None => {
                let k = index(&mut self.constants, by, |a, b| a.to_bits() == b.to_bits());
                self.number(ScalarOperation::Scale(place, k))
            }
        }
    }

    pub(super) fn unary(&mut self, function: Unary, a: usize) -> usize {
        use ScalarOperation::{Add, IntegralOver, Multiply, Negate, Power, Subtract};
        if let Some(value) = self.value(a) {
            return self.constant(function.of(value));
        }
        let next = self.counts[0];
        match function {
            Unary::Negate => self.number(Negate(a)),
            Unary::Sqrt => self.number(Power(a, 0.5_f64.to_bits())),
            Unary::Power(n) => self.whole_power(a, n),
            // sinh' = cosh, cosh' = sinh
            Unary::Sinh => self.hyperbolic(a),
            Unary::Cosh => self.hyperbolic(a) + 1,
            Unary::Tanh => {
                // the factor 1 − tanh² follows the hyperbolic tangent
                let one = self.constant(1.0);
                let by = self.counts[0] + 2;
                self.integral_by(function, a, by, |graph, tanh| {
                    graph.push(Operation::Scalar(Multiply(tanh, tanh)));
                    graph.push(Operation::Scalar(Subtract(one, tanh + 1)));
                })
            }
            Unary::Expm1 => {
                let by = self.unary(Unary::Exp, a);
                self.integral_by(function, a, by, |_, _| {})
            }
            Unary::Log1p => {
                let one = self.constant(1.0);
                let over = self.number(Add(one, a));
                self.number(IntegralOver { start: function, of: a, over })
            }
            // exp' = exp: the integrand factor is the function itself
            Unary::Exp => self.integral_by(function, a, next, |_, _| {}),
            Unary::Sin => self.sine_and_cosine(a),
            Unary::Cos => self.sine_and_cosine(a) + 1,
            Unary::Tan => {
                // the factor 1 + tan² follows the tangent
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
                // √((1 − a)(1 + a)) is accurate near 1
                let one = self.constant(1.0);
                let (less, more) = (self.number(Subtract(one, a)), self.number(Add(one, a)));
                let square = self.number(Multiply(less, more));
                let root = self.number(Power(square, 0.5_f64.to_bits()));
                let over = if function == Unary::Asin { root } else { self.number(Negate(root)) };
                self.number(IntegralOver { start: function, of: a, over })
            }
            Unary::Abs | Unary::Floor => self.number(ScalarOperation::Rough),
        }
    }

    pub(super) fn binary(&mut self, function: Binary, a: usize, b: usize) -> usize {
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

    /// Computes aⁿ by squaring: a may pass through zero.
    pub(super) fn whole_power(&mut self, a: usize, n: i32) -> usize {
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

    /// Returns the place of the sine. The cosine and the negative sine follow it.
    pub(super) fn sine_and_cosine(&mut self, a: usize) -> usize {
        let by = self.counts[0] + 1;
        self.integral_by(Unary::Sin, a, by, |graph, sine| {
            let cosine = ScalarOperation::IntegralBy { start: Unary::Cos, of: a, by: sine + 2 };
            graph.push(Operation::Scalar(cosine));
            graph.push(Operation::Scalar(ScalarOperation::Negate(sine)));
        })
    }

    /// Returns the place of the hyperbolic sine. The hyperbolic cosine follows it.
    fn hyperbolic(&mut self, a: usize) -> usize {
        let by = self.counts[0] + 1;
        self.integral_by(Unary::Sinh, a, by, |graph, sinh| {
            let cosh = ScalarOperation::IntegralBy { start: Unary::Cosh, of: a, by: sinh };
            graph.push(Operation::Scalar(cosh));
        })
    }

    /// Returns the place of an integral whose factor follows it and is added by `after`. An
    /// identical integral is reused.
    pub(super) fn integral_by(
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

/// Places of `R_principal_body`, `R_body_principal` and the inertia tensor among the matrices.
pub(super) const TO_PRINCIPAL: usize = 0;
pub(super) const TO_BODY: usize = 1;
pub(super) const INERTIA: usize = 2;

/// Returns the index of a value in a list, appending it if needed.
pub(super) fn index<T>(list: &mut Vec<T>, value: T, is_same: impl Fn(&T, &T) -> bool) -> usize {
    list.iter().position(|known| is_same(known, &value)).unwrap_or_else(|| {
        list.push(value);
        list.len() - 1
    })
}
