//! Formulas: instructions for a stack machine, compiled once and evaluated at one or many points.
//!
//! The instructions are executed in order. Each takes its operands from the top of the stack and
//! pushes its result; at the end one number, the value, is left. The parser of formula texts is in
//! `polhode-source`.
//!
//! Functions are those of `libm`, and powers of small integers are products. The bits of the
//! results are therefore the same on every platform, for one point and for many.

use core::fmt;

/// Function of numbered variables, as a list of instructions.
///
/// ```
/// use polhode::math::formula::{Binary, Formula, Instruction, Unary};
/// // 3 sin(x) − y, of the variables x and y
/// let formula = Formula::new([
///     Instruction::Constant(3.0),
///     Instruction::Variable(0),
///     Instruction::Unary(Unary::Sin),
///     Instruction::Binary(Binary::Multiply),
///     Instruction::Variable(1),
///     Instruction::Binary(Binary::Subtract),
/// ])?;
/// assert_eq!(formula.evaluate(&[0.0, 0.25]), -0.25);
/// assert!(formula.evaluate(&[0.0]).is_nan()); // y is not given
/// assert!(Formula::new([Instruction::Unary(Unary::Sin)]).is_err());
/// # Ok::<(), polhode::math::formula::FormulaError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    instructions: Vec<Instruction>,
    /// Maximum number of values on the stack.
    deepest: usize,
}

/// Instruction: takes its operands from the top of the stack and pushes its result.
#[derive(Clone, Copy, Debug)]
pub enum Instruction {
    /// Pushes a constant.
    Constant(f64),
    /// Pushes a variable, given by its index among the values of a point.
    Variable(usize),
    /// Applies a function of one number.
    Unary(Unary),
    /// Applies a function of two numbers; the second is on top.
    Binary(Binary),
    /// Selects a branch: with condition, then, else on the stack, the result is *then* if the
    /// condition is not 0.
    If,
    /// Restricts a to the interval from low to high, with a, low, high on the stack: the lesser of
    /// high and the greater of low and a.
    Clip,
    /// Pushes a copy of a value on the stack, given by its index from the bottom: a local value,
    /// computed once and used several times.
    Local(usize),
    /// Removes the value below the top: a local value that is no longer needed.
    EndLocal,
}

/// Constants are equal if their bits are: 1/0 and 1/(−0) are different formulas.
impl PartialEq for Instruction {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Constant(a), Self::Constant(b)) => a.to_bits() == b.to_bits(),
            (Self::Variable(a), Self::Variable(b)) | (Self::Local(a), Self::Local(b)) => a == b,
            (Self::Unary(a), Self::Unary(b)) => a == b,
            (Self::Binary(a), Self::Binary(b)) => a == b,
            (Self::If, Self::If) | (Self::Clip, Self::Clip) | (Self::EndLocal, Self::EndLocal) => true,
            _ => false,
        }
    }
}

/// Function of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the names are the documentation")]
pub enum Unary {
    Negate,
    Sqrt,
    Exp,
    /// Natural logarithm ln x.
    Log,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    /// Logarithm ln(1 + x), with the relative accuracy of x near 0.
    Log1p,
    /// Exponential eˣ − 1, with the relative accuracy of x near 0.
    Expm1,
    Abs,
    /// Largest integer that is at most x.
    Floor,
    /// Power xⁿ for a small integer n, by multiplication.
    Power(i32),
}

/// Function of two numbers a and b. Comparisons, *and* and *or* return NaN if an operand is NaN.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the names are the documentation")]
pub enum Binary {
    Add,
    /// Difference a − b.
    Subtract,
    Multiply,
    /// Quotient a / b.
    Divide,
    /// Power aᵇ.
    Power,
    /// Angle of the point (b, a) from the first axis, rad.
    Atan2,
    Min,
    Max,
    /// Hypotenuse √(a² + b²).
    Hypot,
    /// Remainder a − b ⌊a/b⌋: it has the sign of b, and is exact.
    Mod,
    /// Returns 1 if a < b, else 0.
    Less,
    /// Returns 1 if a ≤ b, else 0.
    LessOrEqual,
    /// Returns 1 if a > b, else 0.
    Greater,
    /// Returns 1 if a ≥ b, else 0.
    GreaterOrEqual,
    /// Returns 1 if neither a nor b is 0, else 0.
    And,
    /// Returns 0 if both a and b are 0, else 1.
    Or,
}

/// Error: the instructions are not a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FormulaError {
    /// An instruction needs more operands, or another local value, than the stack has.
    MissingOperand {
        /// Index of the instruction, from 0.
        instruction: usize,
    },
    /// The number of values left at the end is not one.
    Left {
        /// Number of values that are left.
        count: usize,
    },
}

/// Number of points in a row of the stack, if the stack is not deep.
const WIDTH: usize = 256;

/// Maximum number of values in the stack of a multi-point evaluation.
const ROOM: usize = 1 << 16;

/// Number of values in a stack that needs no memory allocation.
const SHALLOW: usize = 32;

impl Formula {
    /// Returns a formula from its instructions. Small integer powers become products.
    ///
    /// # Errors
    /// [`FormulaError`] if an instruction lacks operands, or if the number of values left is not
    /// one.
    pub fn new(instructions: impl IntoIterator<Item = Instruction>) -> Result<Self, FormulaError> {
        let mut kept: Vec<Instruction> = Vec::new();
        let (mut height, mut deepest) = (0_usize, 0);
        for (n, instruction) in instructions.into_iter().enumerate() {
            let below = height.checked_sub(instruction.operands());
            let is_missing = matches!(instruction, Instruction::Local(k) if k >= height);
            let below = below.filter(|_| !is_missing);
            height = 1 + below.ok_or(FormulaError::MissingOperand { instruction: n })?;
            deepest = deepest.max(height);
            match (instruction, kept.last()) {
                (Instruction::Binary(Binary::Power), Some(&Instruction::Constant(power)))
                    if power.abs() <= 32.0 && power.fract() == 0.0 =>
                {
                    kept.pop();
                    kept.push(Instruction::Unary(Unary::Power(power as i32)));
                }
                _ => kept.push(instruction),
            }
        }
        if height == 1 {
            Ok(Self { instructions: kept, deepest })
        } else {
            Err(FormulaError::Left { count: height })
        }
    }

    /// Returns a constant formula.
    pub fn constant(value: f64) -> Self {
        Self { instructions: vec![Instruction::Constant(value)], deepest: 1 }
    }

    /// Returns the instructions of the formula.
    pub fn instructions(&self) -> &[Instruction] {
        &self.instructions
    }

    /// Returns true if a variable occurs in the formula.
    pub fn depends_on(&self, variable: usize) -> bool {
        self.instructions.contains(&Instruction::Variable(variable))
    }

    /// Returns true if the value is that of a comparison, or of comparisons joined by *and* and
    /// *or*: 1 or 0.
    pub fn is_condition(&self) -> bool {
        let mut from_last = self.instructions.iter().rev();
        from_last.find(|last| **last != Instruction::EndLocal).is_some_and(|last| last.is_condition())
    }

    /// Returns the first function that is not smooth (it has a corner or a jump, and therefore no
    /// power series), if there is one.
    pub fn rough_function(&self) -> Option<&'static str> {
        self.instructions.iter().find_map(|instruction| instruction.roughness())
    }

    /// Returns the value at a point; a missing variable is NaN.
    ///
    /// No memory is allocated for formulas of usual length.
    pub fn evaluate(&self, point: &[f64]) -> f64 {
        let mut shallow = [0.0; SHALLOW];
        let mut deep = Vec::new();
        let stack = if self.deepest <= SHALLOW {
            &mut shallow[..]
        } else {
            deep.resize(self.deepest, 0.0);
            &mut deep[..]
        };
        self.run(stack, 1, |k, row| row.fill(point.get(k).copied().unwrap_or(f64::NAN)));
        stack[0]
    }

    /// Computes the values at many points; the shorter of the two lists determines their number.
    pub fn evaluate_all<const N: usize>(&self, points: &[[f64; N]], values: &mut [f64]) {
        let width = (ROOM / self.deepest).clamp(1, WIDTH).min(points.len().max(1));
        let mut stack = vec![0.0; width * self.deepest];
        for (points, values) in points.chunks(width).zip(values.chunks_mut(width)) {
            self.run(&mut stack, width, |k, row| {
                for (slot, point) in row.iter_mut().zip(points) {
                    *slot = point.get(k).copied().unwrap_or(f64::NAN);
                }
            });
            values.iter_mut().zip(&stack).for_each(|(value, &top)| *value = top);
        }
    }

    /// Computes the values of `width` points into the start of the stack; `variable` fills a row
    /// with the values of one variable.
    fn run(&self, stack: &mut [f64], width: usize, variable: impl Fn(usize, &mut [f64])) {
        let mut height = 0;
        for &instruction in &self.instructions {
            let (below, above) = stack.split_at_mut(height * width);
            // The last rows of the stack are the operands.
            let operands = &mut below[(height - instruction.operands()) * width..];
            match instruction {
                Instruction::Constant(value) => above[..width].fill(value),
                Instruction::Variable(k) => variable(k, &mut above[..width]),
                Instruction::Unary(unary) => unary.apply(operands),
                Instruction::Binary(binary) => {
                    let (a, b) = operands.split_at_mut(width);
                    binary.apply(a, b);
                }
                Instruction::If => {
                    let (condition, branches) = operands.split_at_mut(width);
                    let (then, otherwise) = branches.split_at(width);
                    for ((c, &a), &b) in condition.iter_mut().zip(then).zip(otherwise) {
                        *c = if c.is_nan() { *c } else { [a, b][usize::from(*c == 0.0)] };
                    }
                }
                Instruction::Clip => {
                    let (a, limits) = operands.split_at_mut(width);
                    let (low, high) = limits.split_at(width);
                    Binary::Max.apply(a, low);
                    Binary::Min.apply(a, high);
                }
                Instruction::Local(k) => {
                    above[..width].copy_from_slice(&below[k * width..(k + 1) * width]);
                }
                Instruction::EndLocal => {
                    let (local, top) = operands.split_at_mut(width);
                    local.copy_from_slice(top);
                }
            }
            height = height + 1 - instruction.operands();
        }
    }
}

impl Instruction {
    /// Returns the number of operands that it takes from the stack.
    pub const fn operands(self) -> usize {
        match self {
            Self::Constant(_) | Self::Variable(_) | Self::Local(_) => 0,
            Self::Unary(_) => 1,
            Self::Binary(_) | Self::EndLocal => 2,
            Self::If | Self::Clip => 3,
        }
    }

    /// Returns true if the result is always 1 or 0.
    const fn is_condition(self) -> bool {
        use Binary::{And, Greater, GreaterOrEqual, Less, LessOrEqual, Or};
        matches!(self, Self::Binary(Less | LessOrEqual | Greater | GreaterOrEqual | And | Or))
    }

    /// Returns the name of the function if it is not smooth.
    const fn roughness(self) -> Option<&'static str> {
        match self {
            Self::Unary(Unary::Abs) => Some("abs"),
            Self::Unary(Unary::Floor) => Some("floor"),
            Self::Binary(Binary::Mod) => Some("mod"),
            Self::Binary(Binary::Min) => Some("min"),
            Self::Binary(Binary::Max) => Some("max"),
            Self::Binary(Binary::Less | Binary::LessOrEqual | Binary::Greater | Binary::GreaterOrEqual) => {
                Some("a comparison")
            }
            Self::Binary(Binary::And) => Some("and"),
            Self::Binary(Binary::Or) => Some("or"),
            Self::If => Some("if"),
            Self::Clip => Some("clip"),
            _ => None,
        }
    }
}

impl Unary {
    /// Returns the value of the function at x.
    pub fn of(self, x: f64) -> f64 {
        let mut row = [x];
        self.apply(&mut row);
        row[0]
    }

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
            Self::Sinh => each(row, libm::sinh),
            Self::Cosh => each(row, libm::cosh),
            Self::Tanh => each(row, libm::tanh),
            Self::Log1p => each(row, libm::log1p),
            Self::Expm1 => each(row, libm::expm1),
            Self::Abs => each(row, f64::abs),
            Self::Floor => each(row, f64::floor),
            Self::Power(n) => row.iter_mut().for_each(|x| *x = power(*x, n)),
        }
    }
}

impl Binary {
    /// Returns the value of the function at a and b.
    pub fn of(self, a: f64, b: f64) -> f64 {
        let mut row = [a];
        self.apply(&mut row, &[b]);
        row[0]
    }

    /// Replaces a by a ∘ b.
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
            // NaN is neither larger nor smaller than any number.
            Self::Min => each(a, |a, b| if a.is_nan() || a < b { a } else { b }),
            Self::Max => each(a, |a, b| if a.is_nan() || a > b { a } else { b }),
            Self::Hypot => each(a, libm::hypot),
            Self::Mod => each(a, remainder),
            Self::Less => each(a, |a, b| holds(a < b, a, b)),
            Self::LessOrEqual => each(a, |a, b| holds(a <= b, a, b)),
            Self::Greater => each(a, |a, b| holds(a > b, a, b)),
            Self::GreaterOrEqual => each(a, |a, b| holds(a >= b, a, b)),
            Self::And => each(a, |a, b| holds(a != 0.0 && b != 0.0, a, b)),
            Self::Or => each(a, |a, b| holds(a != 0.0 || b != 0.0, a, b)),
        }
    }
}

/// Returns the remainder of a/b with the sign of b; NaN for b = 0.
fn remainder(a: f64, b: f64) -> f64 {
    let rest = libm::fmod(a, b);
    if rest == 0.0 {
        0.0_f64.copysign(b)
    } else if (rest < 0.0) == (b < 0.0) {
        rest
    } else {
        rest + b
    }
}

/// Returns 1 or 0, or NaN if an operand is NaN.
fn holds(condition: bool, a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { f64::from(u8::from(condition)) }
}

/// Returns xⁿ by repeated squaring, with few roundings and identical bits on every platform.
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

impl fmt::Display for FormulaError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::MissingOperand { instruction } => {
                write!(f, "instruction {instruction} needs more operands than there are")
            }
            Self::Left { count } => write!(f, "{count} numbers are left, where a formula has one value"),
        }
    }
}

impl core::error::Error for FormulaError {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_formulas_are_formulas() {
        use Instruction as I;
        assert_eq!(Formula::new([]), Err(FormulaError::Left { count: 0 }));
        assert_eq!(Formula::new([I::Constant(1.0), I::Variable(0)]), Err(FormulaError::Left { count: 2 }));
        let short = [I::Constant(1.0), I::Binary(Binary::Add)];
        assert_eq!(Formula::new(short), Err(FormulaError::MissingOperand { instruction: 1 }));
        for short in [[I::Local(0), I::Constant(1.0)], [I::Constant(1.0), I::Local(1)]] {
            assert!(matches!(Formula::new(short), Err(FormulaError::MissingOperand { .. })));
        }
        let short = [I::Constant(1.0), I::Constant(1.0), I::If];
        assert_eq!(Formula::new(short), Err(FormulaError::MissingOperand { instruction: 2 }));
    }

    #[test]
    fn a_deep_formula_has_the_value_of_its_parts() {
        // 0 + 1·(x + 2·(x + 3·( … ))), deeper than the preallocated stack.
        let mut instructions = Vec::new();
        for n in 0..100 {
            instructions.extend([Instruction::Variable(0), Instruction::Constant(f64::from(n))]);
        }
        instructions.push(Instruction::Constant(0.5));
        for _ in 0..100 {
            instructions.extend([Instruction::Binary(Binary::Multiply), Instruction::Binary(Binary::Add)]);
        }
        let formula = Formula::new(instructions).unwrap();
        assert!(formula.deepest > SHALLOW);
        let x = 0.3;
        let expected = (0..100).rev().fold(0.5, |rest, n| x + f64::from(n) * rest);
        assert_eq!(formula.evaluate(&[x]), expected);
        let mut many = [0.0; 3];
        formula.evaluate_all(&[[x]; 3], &mut many);
        assert_eq!(many, [expected; 3]);
    }

    #[test]
    fn new_functions_have_the_values_of_their_definitions() {
        for x in [-1.7, -0.3, 1e-9, 0.4, 2.3_f64] {
            let near = |unary: Unary, y: f64| {
                let got = unary.of(x);
                assert!((got - y).abs() <= 4e-16 * y.abs(), "{unary:?}({x}): {got} {y}");
            };
            near(Unary::Sinh, x.sinh());
            near(Unary::Cosh, x.cosh());
            near(Unary::Tanh, x.tanh());
            near(Unary::Expm1, x.exp_m1());
            near(Unary::Floor, x.floor());
            if x > -1.0 {
                near(Unary::Log1p, x.ln_1p());
            }
        }
        for (a, b) in [(7.3, 2.5), (-7.3, 2.5), (7.3, -2.5), (-7.3, -2.5), (0.3, 2.5)] {
            let want: f64 = a - b * f64::floor(a / b);
            let got = Binary::Mod.of(a, b);
            assert!((got - want).abs() < 1e-15 && (got < 0.0) == (b < 0.0), "{a} mod {b}: {got} {want}");
        }
        assert_eq!(Binary::Mod.of(1.0, 0.1), 1.0 % 0.1); // exact: 1/0.1 would round to 10
        assert_eq!(Binary::Mod.of(-5.0, 2.5), 0.0);
        assert!(Binary::Mod.of(1.0, 0.0).is_nan());
        use Instruction as I;
        let clip = [I::Variable(0), I::Constant(-0.5), I::Constant(1.5), I::Clip];
        let clip = Formula::new(clip).unwrap();
        let mut values = [0.0; 4];
        clip.evaluate_all(&[[-3.0], [0.2], [7.0], [f64::NAN]], &mut values);
        assert_eq!(values[..3], [-0.5, 0.2, 1.5]);
        assert!(values[3].is_nan());
        assert_eq!(clip.rough_function(), Some("clip"));
    }

    #[test]
    fn a_local_value_is_used_several_times() {
        use Instruction as I;
        // a = sin x; b = a + 3; a b − a/b
        let [add, subtract] = [Binary::Add, Binary::Subtract].map(I::Binary);
        let [times, over] = [Binary::Multiply, Binary::Divide].map(I::Binary);
        let mut instructions = vec![I::Variable(0), I::Unary(Unary::Sin), I::Local(0), I::Constant(3.0), add];
        instructions.extend([I::Local(0), I::Local(1), times, I::Local(0), I::Local(1), over, subtract]);
        assert_eq!(Formula::new(instructions.clone()), Err(FormulaError::Left { count: 3 }));
        let formula = Formula::new(instructions.into_iter().chain([I::EndLocal; 2])).unwrap();
        let want = |x: f64| {
            let (a, b) = (libm::sin(x), libm::sin(x) + 3.0);
            a * b - a / b
        };
        let mut values = [0.0; 2];
        formula.evaluate_all(&[[0.7], [-1.9]], &mut values);
        assert_eq!(values, [want(0.7), want(-1.9)]);
        assert_eq!(formula.evaluate(&[0.7]), want(0.7));
        let [value, first, _] = formula.derivatives(0.7);
        let slope = (want(0.7 + 1e-5) - want(0.7 - 1e-5)) / 2e-5;
        assert!(value == want(0.7) && (first - slope).abs() < 1e-9);
        let condition = [I::Variable(0), I::Local(0), I::Constant(1.0), I::Binary(Binary::Less), I::EndLocal];
        assert!(Formula::new(condition).unwrap().is_condition());
    }

    #[test]
    fn nothing_is_known_of_what_is_no_number() {
        let of = [
            Binary::Less,
            Binary::LessOrEqual,
            Binary::Greater,
            Binary::GreaterOrEqual,
            Binary::And,
            Binary::Or,
        ];
        for binary in of {
            assert!(binary.of(f64::NAN, 1.0).is_nan() && binary.of(1.0, f64::NAN).is_nan(), "{binary:?}");
            assert!([0.0, 1.0].contains(&binary.of(0.0, 1.0)));
        }
    }

    #[test]
    fn what_is_not_smooth_is_named() {
        use Instruction as I;
        let smooth = Formula::new([I::Variable(0), I::Constant(1.5), I::Binary(Binary::Power)]).unwrap();
        assert_eq!(smooth.rough_function(), None);
        assert!(smooth.depends_on(0) && !smooth.depends_on(1));
        let rough = Formula::new([I::Variable(0), I::Unary(Unary::Abs)]).unwrap();
        assert_eq!(rough.rough_function(), Some("abs"));
    }
}
