//! Formulas as a graph: each value that occurs once, with where it comes from.

use super::super::super::function::{angle, constant_power, hypotenuse, integral_by, integral_over};
use super::super::super::scalar::{Scalars, product, quotient};
use crate::math::formula::{Binary, Formula, Instruction, Unary};
use crate::math::rotation::wrap;
use crate::motion::state_variables::StateVariables;

/// A value, by its place in the graph: after those that it is of.
pub(super) type Place = usize;

/// Where a value comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Node {
    Constant(f64),
    Input(Input),
    Negate(Place),
    Scale(Place, f64),
    Add(Place, Place),
    Subtract(Place, Place),
    Multiply(Place, Place),
    Divide(Place, Place),
    /// aᵖ
    Power(Place, f64),
    Hypot(Place, Place),
    /// ∫ of' by, from the function of `of` at the start; `by` may come later in the graph.
    IntegralBy {
        start: Unary,
        of: Place,
        by: Place,
    },
    /// ∫ of'/over, from the function of `of` at the start.
    IntegralOver {
        start: Unary,
        of: Place,
        over: Place,
    },
    /// The angle of (b, a), and a² + b².
    Angle(Place, Place, Place),
    /// An angle brought between −π and π at the start.
    Wrapped(Place),
    /// aᵇ = exp(b log a), the exponent last.
    GeneralPower(Place, Place, Place),
    /// What has no series.
    Rough,
}

/// What the motion itself gives, each component by its number from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Input {
    Time,
    /// ω, body axes.
    Omega(usize),
    /// I ω, body axes.
    Carrier(usize),
    /// Σ h a of the wheels, body axes.
    Wheels(usize),
    /// The quaternion of the attitude.
    Attitude(usize),
}

/// Nodes, those that others are of first.
#[derive(Clone, Debug, Default)]
pub(super) struct Graph {
    pub(super) nodes: Vec<Node>,
}

impl Graph {
    /// Three formulas of a state, along body axes: their places.
    pub(super) fn components(&mut self, formulas: &[Formula; 3], in_space: bool) -> [Place; 3] {
        let [x, y, z] = formulas;
        let given = [x, y, z].map(|formula| self.formula(formula));
        if !in_space {
            return given;
        }
        // N_body = R_body_space N_space
        [0, 1, 2].map(|column| {
            let cosines = [0, 1, 2].map(|row| self.cosine(row, column));
            self.dot(cosines, given)
        })
    }

    /// A formula of a state.
    pub(super) fn formula(&mut self, formula: &Formula) -> Place {
        let mut stack: Vec<Place> = Vec::new();
        for &instruction in formula.instructions() {
            let operands = stack.split_off(stack.len().saturating_sub(instruction.operands()));
            let place = match (instruction, &operands[..]) {
                (Instruction::Constant(value), _) => self.constant(value),
                (Instruction::Variable(k), _) => self.variable(k),
                (Instruction::Unary(unary), &[a]) => self.unary(unary, a),
                (Instruction::Binary(binary), &[a, b]) => self.binary(binary, a, b),
                _ => self.node(Node::Rough),
            };
            stack.push(place);
        }
        stack.pop().unwrap_or_else(|| self.node(Node::Rough))
    }

    /// The place of a node, new or not.
    fn node(&mut self, node: Node) -> Place {
        if let Some(place) = self.nodes.iter().position(|known| *known == node) {
            return place;
        }
        self.nodes.push(node);
        self.nodes.len() - 1
    }

    fn constant(&mut self, value: f64) -> Place {
        self.node(Node::Constant(value))
    }

    fn value(&self, place: Place) -> Option<f64> {
        match self.nodes.get(place) {
            Some(&Node::Constant(value)) => Some(value),
            _ => None,
        }
    }

    /// A variable, by its place among those of a state.
    fn variable(&mut self, k: usize) -> Place {
        let inputs = |input: fn(usize) -> Input| [0, 1, 2].map(|k| Node::Input(input(k)));
        match StateVariables::NAMES.get(k).copied().unwrap_or_default() {
            "t" => self.node(Node::Input(Input::Time)),
            "T_rot" => {
                let [omega, carrier] = [inputs(Input::Omega), inputs(Input::Carrier)];
                let [omega, carrier] = [omega, carrier].map(|v| v.map(|node| self.node(node)));
                let twice = self.dot(omega, carrier);
                self.node(Node::Scale(twice, 0.5))
            }
            "phi" => self.precession_or_spin(Binary::Add),
            "psi" => self.precession_or_spin(Binary::Subtract),
            "theta" => {
                // θ = 2 atan2(√(x² + y²), √(w² + z²))
                let [w, x, y, z] = self.quaternion();
                let (sine, cosine) = (self.node(Node::Hypot(x, y)), self.node(Node::Hypot(w, z)));
                let half = self.binary(Binary::Atan2, sine, cosine);
                self.node(Node::Scale(half, 2.0))
            }
            name => match name.as_bytes() {
                &[b'w', axis @ b'x'..=b'z'] => self.node(Node::Input(Input::Omega(usize::from(axis - b'x')))),
                &[b'L', axis @ b'x'..=b'z'] => self.momentum(usize::from(axis - b'x')),
                &[b'q', component] => {
                    let [w, x, y, z] = self.quaternion();
                    match component {
                        b'x' => x,
                        b'y' => y,
                        b'z' => z,
                        _ => w,
                    }
                }
                &[b'r', row @ b'1'..=b'3', column @ b'1'..=b'3'] => {
                    self.cosine(usize::from(row - b'1'), usize::from(column - b'1'))
                }
                &[of @ (b'w' | b'L'), row @ b'X'..=b'Z'] => {
                    let row = usize::from(row - b'X');
                    let cosines = [0, 1, 2].map(|column| self.cosine(row, column));
                    let vector = [0, 1, 2].map(|k| match of {
                        b'w' => self.node(Node::Input(Input::Omega(k))),
                        _ => self.momentum(k),
                    });
                    self.dot(cosines, vector)
                }
                _ => self.node(Node::Rough),
            },
        }
    }

    fn quaternion(&mut self) -> [Place; 4] {
        [0, 1, 2, 3].map(|k| self.node(Node::Input(Input::Attitude(k))))
    }

    /// L = I ω + Σ h a
    fn momentum(&mut self, k: usize) -> Place {
        let carrier = self.node(Node::Input(Input::Carrier(k)));
        let wheels = self.node(Node::Input(Input::Wheels(k)));
        self.node(Node::Add(carrier, wheels))
    }

    /// φ = atan2(z, w) + atan2(y, x), ψ = atan2(z, w) − atan2(y, x)
    fn precession_or_spin(&mut self, sign: Binary) -> Place {
        let [w, x, y, z] = self.quaternion();
        let half_sum = self.binary(Binary::Atan2, z, w);
        let half_difference = self.binary(Binary::Atan2, y, x);
        let angle = self.binary(sign, half_sum, half_difference);
        self.node(Node::Wrapped(angle))
    }

    /// An element of R_space_body, by the quaternion's.
    fn cosine(&mut self, row: usize, column: usize) -> Place {
        let [w, x, y, z] = self.quaternion();
        let vector = [x, y, z];
        if row == column {
            // w² + xᵢ² − xⱼ² − xₖ²
            let [i, j, k] = [0, 1, 2].map(|k| vector[(row + k) % 3]);
            let [ww, ii, jj, kk] = [w, i, j, k].map(|a| self.node(Node::Multiply(a, a)));
            let (with, without) = (self.node(Node::Add(ww, ii)), self.node(Node::Add(jj, kk)));
            return self.node(Node::Subtract(with, without));
        }
        // 2 (xᵢ xⱼ ∓ w xₖ): minus where row, column, k are in cyclic order
        let (a, b) = (vector[row.min(column)], vector[row.max(column)]);
        let third = vector[3 - row - column];
        let (pair, turn) = (self.node(Node::Multiply(a, b)), self.node(Node::Multiply(w, third)));
        let sum = if (row + 1) % 3 == column { Node::Subtract(pair, turn) } else { Node::Add(pair, turn) };
        let half = self.node(sum);
        self.node(Node::Scale(half, 2.0))
    }

    fn dot(&mut self, a: [Place; 3], b: [Place; 3]) -> Place {
        let [x, y, z] = [0, 1, 2].map(|k| self.binary(Binary::Multiply, a[k], b[k]));
        let sum = self.node(Node::Add(x, y));
        self.node(Node::Add(sum, z))
    }

    fn unary(&mut self, unary: Unary, a: Place) -> Place {
        if let Some(value) = self.value(a) {
            return self.constant(unary.of(value));
        }
        match unary {
            Unary::Negate => self.node(Node::Negate(a)),
            Unary::Sqrt => self.node(Node::Power(a, 0.5)),
            Unary::Power(n) => self.whole_power(a, n),
            Unary::Exp => {
                // exp' = exp: it is its own factor
                let by = self.nodes.len();
                self.integral_by(Node::IntegralBy { start: unary, of: a, by }, |_, _| {})
            }
            Unary::Sin => self.sine_and_cosine(a),
            Unary::Cos => self.sine_and_cosine(a) + 1,
            Unary::Tan => {
                // 1 + tan² comes after it
                let one = self.constant(1.0);
                let tan = Node::IntegralBy { start: unary, of: a, by: self.nodes.len() + 2 };
                self.integral_by(tan, |graph, tan| {
                    graph.nodes.push(Node::Multiply(tan, tan));
                    graph.nodes.push(Node::Add(tan + 1, one));
                })
            }
            Unary::Log => self.node(Node::IntegralOver { start: unary, of: a, over: a }),
            Unary::Atan => {
                let (one, square) = (self.constant(1.0), self.node(Node::Multiply(a, a)));
                let over = self.node(Node::Add(one, square));
                self.node(Node::IntegralOver { start: unary, of: a, over })
            }
            Unary::Asin | Unary::Acos => {
                // √((1 − a)(1 + a)) keeps its digits near 1
                let one = self.constant(1.0);
                let (less, more) = (self.node(Node::Subtract(one, a)), self.node(Node::Add(one, a)));
                let square = self.node(Node::Multiply(less, more));
                let root = self.node(Node::Power(square, 0.5));
                let over = if unary == Unary::Asin { root } else { self.node(Node::Negate(root)) };
                self.node(Node::IntegralOver { start: unary, of: a, over })
            }
            Unary::Abs => self.node(Node::Rough),
        }
    }

    fn binary(&mut self, binary: Binary, a: Place, b: Place) -> Place {
        match (binary, self.value(a), self.value(b)) {
            (_, Some(x), Some(y)) => self.constant(binary.of(x, y)),
            (Binary::Add, ..) => self.node(Node::Add(a, b)),
            (Binary::Subtract, ..) => self.node(Node::Subtract(a, b)),
            (Binary::Multiply, Some(x), _) => self.node(Node::Scale(b, x)),
            (Binary::Multiply, _, Some(y)) => self.node(Node::Scale(a, y)),
            (Binary::Multiply, ..) => self.node(Node::Multiply(a, b)),
            (Binary::Divide, ..) => self.node(Node::Divide(a, b)),
            (Binary::Power, _, Some(p)) if p.fract() == 0.0 && p.abs() <= 1e6 => {
                self.whole_power(a, p as i32)
            }
            (Binary::Power, _, Some(p)) => self.node(Node::Power(a, p)),
            (Binary::Power, ..) => {
                let log = self.unary(Unary::Log, a);
                let exponent = self.binary(Binary::Multiply, b, log);
                self.node(Node::GeneralPower(a, b, exponent))
            }
            (Binary::Hypot, ..) => self.node(Node::Hypot(a, b)),
            (Binary::Atan2, ..) => {
                let [aa, bb] = [a, b].map(|a| self.node(Node::Multiply(a, a)));
                let square = self.node(Node::Add(aa, bb));
                self.node(Node::Angle(a, b, square))
            }
            _ => self.node(Node::Rough),
        }
    }

    /// aⁿ by squaring: a may pass through zero.
    fn whole_power(&mut self, a: Place, n: i32) -> Place {
        let (mut result, mut square, mut rest) = (None, a, n.unsigned_abs());
        while rest > 0 {
            if rest & 1 == 1 {
                result = Some(result.map_or(square, |known| self.node(Node::Multiply(known, square))));
            }
            rest >>= 1;
            if rest > 0 {
                square = self.node(Node::Multiply(square, square));
            }
        }
        let one = self.constant(1.0);
        match result {
            None => one,
            Some(power) if n < 0 => self.node(Node::Divide(one, power)),
            Some(power) => power,
        }
    }

    /// The place of the sine, which the cosine and its negative follow.
    fn sine_and_cosine(&mut self, a: Place) -> Place {
        let sine = Node::IntegralBy { start: Unary::Sin, of: a, by: self.nodes.len() + 1 };
        self.integral_by(sine, |graph, sine| {
            graph.nodes.push(Node::IntegralBy { start: Unary::Cos, of: a, by: sine + 2 });
            graph.nodes.push(Node::Negate(sine));
        })
    }

    /// The place of an integral whose factor follows it, as `after` adds it; of the same one, if it is there.
    fn integral_by(&mut self, node: Node, after: impl FnOnce(&mut Self, Place)) -> Place {
        let same = |known: &Node| match (*known, node) {
            (Node::IntegralBy { start: s, of: a, .. }, Node::IntegralBy { start: t, of: b, .. }) => {
                s == t && a == b
            }
            _ => false,
        };
        if let Some(place) = self.nodes.iter().position(same) {
            return place;
        }
        let place = self.nodes.len();
        self.nodes.push(node);
        after(self, place);
        place
    }
}

impl Node {
    /// Its value at the start of a step; `rows` holds those before it.
    pub(super) fn start(self, rows: &[Scalars]) -> f64 {
        let at = |place: Place| rows.get(place).map_or(f64::NAN, |row| row[0]);
        match self {
            Self::Constant(value) => value,
            Self::Negate(a) => -at(a),
            Self::Scale(a, factor) => factor * at(a),
            Self::Add(a, b) => at(a) + at(b),
            Self::Subtract(a, b) => at(a) - at(b),
            Self::Multiply(a, b) => at(a) * at(b),
            Self::Divide(a, b) => at(a) / at(b),
            Self::Power(a, 0.5) => at(a).sqrt(),
            Self::Power(a, p) => libm::pow(at(a), p),
            Self::Hypot(a, b) => libm::hypot(at(a), at(b)),
            Self::IntegralBy { start, of, .. } | Self::IntegralOver { start, of, .. } => start.of(at(of)),
            Self::Angle(a, b, _) => libm::atan2(at(a), at(b)),
            Self::Wrapped(a) => wrap(at(a)),
            Self::GeneralPower(a, b, _) => libm::pow(at(a), at(b)),
            Self::Input(_) | Self::Rough => f64::NAN,
        }
    }

    /// Coefficient n ≥ 1; `rows` holds those before it up to n, its own and those after it up to n − 1.
    #[inline(always)]
    pub(super) fn coefficient(self, own: Place, rows: &[Scalars], n: usize) -> f64 {
        match self {
            Self::Constant(_) => 0.0,
            Self::Negate(a) => -rows[a][n],
            Self::Scale(a, factor) => factor * rows[a][n],
            Self::Add(a, b) => rows[a][n] + rows[b][n],
            Self::Subtract(a, b) => rows[a][n] - rows[b][n],
            Self::Multiply(a, b) => product(&rows[a], &rows[b], n),
            Self::Divide(a, b) => quotient(&rows[a], &rows[b], &rows[own], n),
            Self::Power(a, p) => constant_power(&rows[a], p, &rows[own], n),
            Self::Hypot(a, b) => hypotenuse(&rows[a], &rows[b], &rows[own], n),
            Self::IntegralBy { of, by, .. } => integral_by(&rows[of], &rows[by], n),
            Self::IntegralOver { of, over, .. } => integral_over(&rows[of], &rows[over], &rows[own], n),
            Self::Angle(a, b, square) => angle(&rows[a], &rows[b], &rows[square], &rows[own], n),
            Self::Wrapped(a) => rows[a][n],
            Self::GeneralPower(_, _, exponent) => integral_by(&rows[exponent], &rows[own], n),
            Self::Input(_) | Self::Rough => f64::NAN,
        }
    }
}
