//! A formula as a list of instructions for a machine with a stack, which runs over many points at a time.

/// One instruction: takes its operands from the top of the stack and leaves its result there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Op {
    Constant(f64),
    /// By its place among the variables.
    Variable(usize),
    Unary(Unary),
    Binary(Binary),
    /// Condition, then, else.
    If,
}

/// A function of one number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Unary {
    Negate,
    Sqrt,
    Exp,
    Log,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Abs,
    /// xⁿ for a small whole n.
    Power(i32),
}

/// A function of two numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Atan2,
    Min,
    Max,
    Hypot,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
}

/// Instructions that leave exactly one number.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Tape {
    ops: Vec<Op>,
    /// Numbers on the stack now, and at most.
    height: usize,
    deepest: usize,
}

/// Points in a row of the stack, while it is not deep.
const WIDTH: usize = 256;

/// Numbers in a deep stack.
const ROOM: usize = 1 << 16;

impl Tape {
    /// Appends an instruction. Small whole powers become products.
    pub(super) fn push(&mut self, op: Op) {
        if let (Op::Binary(Binary::Power), Some(&Op::Constant(power))) = (op, self.ops.last())
            && power.abs() <= 32.0
            && power.fract() == 0.0
        {
            self.ops.pop();
            self.height -= 1;
            self.ops.push(Op::Unary(Unary::Power(power as i32)));
            return;
        }
        self.height = match op {
            Op::Constant(_) | Op::Variable(_) => self.height + 1,
            Op::Unary(_) => self.height,
            Op::Binary(_) => self.height - 1,
            Op::If => self.height - 2,
        };
        self.deepest = self.deepest.max(self.height);
        self.ops.push(op);
    }

    /// The values at the points.
    pub(super) fn run<const N: usize>(&self, points: &[[f64; N]], values: &mut [f64]) {
        let width = (ROOM / self.deepest.max(1)).clamp(1, WIDTH).min(points.len().max(1));
        let mut stack = vec![0.0; width * self.deepest];
        for (points, values) in points.chunks(width).zip(values.chunks_mut(width)) {
            self.run_row(&mut stack, width, points);
            values.iter_mut().zip(&stack).for_each(|(value, &top)| *value = top);
        }
    }

    /// The values of up to `width` points, into the start of the stack.
    fn run_row<const N: usize>(&self, stack: &mut [f64], width: usize, points: &[[f64; N]]) {
        let mut height = 0;
        for &op in &self.ops {
            let (below, above) = stack.split_at_mut(height * width);
            // The last rows of the stack, as far as they are there.
            let row = |back: usize| height.saturating_sub(back) * width;
            match op {
                Op::Constant(value) => {
                    above[..width].fill(value);
                    height += 1;
                }
                Op::Variable(k) => {
                    for (slot, point) in above.iter_mut().zip(points) {
                        *slot = point.get(k).copied().unwrap_or(f64::NAN);
                    }
                    height += 1;
                }
                Op::Unary(unary) => unary.apply(&mut below[row(1)..]),
                Op::Binary(binary) => {
                    let (a, b) = below[row(2)..].split_at_mut(width);
                    binary.apply(a, b);
                    height -= 1;
                }
                Op::If => {
                    let (condition, branches) = below[row(3)..].split_at_mut(width);
                    let (then, otherwise) = branches.split_at(width);
                    for ((c, &a), &b) in condition.iter_mut().zip(then).zip(otherwise) {
                        *c = if c.is_nan() { *c } else { [a, b][usize::from(*c == 0.0)] };
                    }
                    height -= 2;
                }
            }
        }
    }
}

impl Unary {
    fn apply(self, row: &mut [f64]) {
        let each = |row: &mut [f64], f: fn(f64) -> f64| row.iter_mut().for_each(|x| *x = f(*x));
        match self {
            Self::Negate => each(row, |x| -x),
            Self::Sqrt => each(row, f64::sqrt),
            Self::Exp => each(row, libm::exp),
            Self::Log => each(row, libm::log),
            Self::Sin => each(row, libm::sin),
            Self::Cos => each(row, libm::cos),
            Self::Tan => each(row, libm::tan),
            Self::Asin => each(row, libm::asin),
            Self::Acos => each(row, libm::acos),
            Self::Atan => each(row, libm::atan),
            Self::Abs => each(row, f64::abs),
            Self::Power(n) => row.iter_mut().for_each(|x| *x = power(*x, n)),
        }
    }
}

impl Binary {
    /// a becomes a ∘ b.
    fn apply(self, a: &mut [f64], b: &[f64]) {
        let each = |a: &mut [f64], f: fn(f64, f64) -> f64| {
            a.iter_mut().zip(b).for_each(|(a, &b)| *a = f(*a, b));
        };
        match self {
            Self::Add => each(a, |a, b| a + b),
            Self::Subtract => each(a, |a, b| a - b),
            Self::Multiply => each(a, |a, b| a * b),
            Self::Divide => each(a, |a, b| a / b),
            Self::Power => each(a, libm::pow),
            Self::Atan2 => each(a, libm::atan2),
            // Nothing is larger or smaller than what is no number.
            Self::Min => each(a, |a, b| if a.is_nan() || a < b { a } else { b }),
            Self::Max => each(a, |a, b| if a.is_nan() || a > b { a } else { b }),
            Self::Hypot => each(a, libm::hypot),
            Self::Less => each(a, |a, b| holds(a < b)),
            Self::LessOrEqual => each(a, |a, b| holds(a <= b)),
            Self::Greater => each(a, |a, b| holds(a > b)),
            Self::GreaterOrEqual => each(a, |a, b| holds(a >= b)),
        }
    }
}

fn holds(condition: bool) -> f64 {
    f64::from(u8::from(condition))
}

/// xⁿ by squaring: a few roundings, and the same bits on every platform.
fn power(x: f64, n: i32) -> f64 {
    let (mut result, mut square, mut rest) = (1.0, x, n.unsigned_abs());
    while rest > 0 {
        if rest & 1 == 1 {
            result *= square;
        }
        square *= square;
        rest >>= 1;
    }
    if n < 0 { 1.0 / result } else { result }
}
