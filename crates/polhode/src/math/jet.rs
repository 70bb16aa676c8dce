//! Numbers with first and second derivative, to differentiate formulas and torque laws exactly,
//! operation by operation.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::algebra::Scalar;
use super::formula::{Binary, Formula, Instruction, Unary};

/// Values of f, f′ and f″ at one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Jet {
    pub(crate) value: f64,
    pub(crate) first: f64,
    pub(crate) second: f64,
}

impl Jet {
    pub(crate) const fn constant(value: f64) -> Self {
        Self { value, first: 0.0, second: 0.0 }
    }

    /// Returns f(u), with f′ = f′(u) u′ and f″ = f″(u) u′² + f′(u) u″; the argument holds f(u),
    /// f′(u), f″(u).
    fn chain(self, [value, first, second]: [f64; 3]) -> Self {
        // If u is constant, f(u) is constant, even if its derivatives with respect to u are
        // infinite.
        if self.first == 0.0 && self.second == 0.0 {
            return Self::constant(value);
        }
        Self {
            value,
            first: first * self.first,
            second: second * self.first * self.first + first * self.second,
        }
    }
}

impl Scalar for Jet {
    fn unary(self, function: Unary) -> Self {
        let x = self.value;
        let f = function.of(x);
        self.chain(match function {
            Unary::Negate => return -self,
            // √(½ f″ ε²) = √(½ f″) ε on this side; the second derivative is unknown.
            Unary::Sqrt if x == 0.0 && self.first == 0.0 && self.second > 0.0 => {
                return Self { value: 0.0, first: libm::sqrt(0.5 * self.second), second: f64::NAN };
            }
            Unary::Sqrt => [f, 0.5 / f, -0.25 / (f * x)],
            Unary::Exp => [f, f, f],
            Unary::Log => [f, 1.0 / x, -1.0 / (x * x)],
            Unary::Sin => [f, libm::cos(x), -f],
            Unary::Cos => [f, -libm::sin(x), -f],
            Unary::Tan => [f, 1.0 + f * f, 2.0 * f * (1.0 + f * f)],
            Unary::Asin => {
                let rate = 1.0 / libm::sqrt((1.0 - x) * (1.0 + x));
                [f, rate, x * rate * rate * rate]
            }
            Unary::Acos => {
                let rate = -1.0 / libm::sqrt((1.0 - x) * (1.0 + x));
                [f, rate, x * rate * rate * rate]
            }
            Unary::Atan => {
                let rate = 1.0 / (1.0 + x * x);
                [f, rate, -2.0 * x * rate * rate]
            }
            Unary::Sinh => [f, libm::cosh(x), f],
            Unary::Cosh => [f, libm::sinh(x), f],
            Unary::Tanh => {
                let rate = (1.0 - f) * (1.0 + f);
                [f, rate, -2.0 * f * rate]
            }
            Unary::Log1p => {
                let rate = 1.0 / (1.0 + x);
                [f, rate, -rate * rate]
            }
            Unary::Expm1 => [f, libm::exp(x), libm::exp(x)],
            Unary::Floor => [f, 0.0, 0.0],
            // At the corner, the right-hand derivative.
            Unary::Abs => return if x < 0.0 { -self } else { self },
            Unary::Power(n) => {
                let power = |k: i32| if k == 0 { 1.0 } else { Unary::Power(k).of(x) };
                let [n0, n1] = [f64::from(n), f64::from(n - 1)];
                // A power whose derivative vanishes identically is zero, also at x = 0.
                let first = if n == 0 { 0.0 } else { n0 * power(n - 1) };
                let second = if n == 0 || n == 1 { 0.0 } else { n0 * n1 * power(n - 2) };
                [f, first, second]
            }
        })
    }

    fn binary(self, function: Binary, b: Self) -> Self {
        let a = self;
        match function {
            Binary::Add => a + b,
            Binary::Subtract => a - b,
            Binary::Multiply => a * b,
            Binary::Divide => a / b,
            Binary::Power if b.first == 0.0 && b.second == 0.0 => a.power(b.value),
            // aᵇ = exp(b ln a).
            Binary::Power => {
                let exact = function.of(a.value, b.value);
                Self { value: exact, ..(b * a.unary(Unary::Log)).chain([exact; 3]) }
            }
            // θ′ = (x y′ − y x′)/(x² + y²), with y as the first operand.
            Binary::Atan2 => {
                let value = function.of(a.value, b.value);
                let square = a.value * a.value + b.value * b.value;
                let turn = b.value * a.first - a.value * b.first;
                let growth = 2.0 * (a.value * a.first + b.value * b.first);
                let change = b.value * a.second - a.value * b.second;
                Self { value, first: turn / square, second: (change - turn * growth / square) / square }
            }
            Binary::Hypot => {
                let value = function.of(a.value, b.value);
                if value == 0.0 {
                    return Self { value, first: libm::hypot(a.first, b.first), second: f64::NAN };
                }
                // h′ = (a a′ + b b′)/h, h″ = (a′² + b′² − h′² + a a″ + b b″)/h.
                let (x, y) = (a.value / value, b.value / value);
                let first = x * a.first + y * b.first;
                let squares = a.first * a.first + b.first * b.first - first * first;
                Self { value, first, second: squares / value + x * a.second + y * b.second }
            }
            // The quotient ⌊a/b⌋ is constant between jumps.
            Binary::Mod => {
                let value = function.of(a.value, b.value);
                let quotient = libm::round((a.value - value) / b.value);
                Self { value, ..(a - b.scaled(quotient)) }
            }
            Binary::Min | Binary::Max => {
                let value = function.of(a.value, b.value);
                let chosen = if value == a.value { a } else { b };
                Self { value, ..chosen }
            }
            Binary::Less
            | Binary::LessOrEqual
            | Binary::Greater
            | Binary::GreaterOrEqual
            | Binary::And
            | Binary::Or => Self::constant(function.of(a.value, b.value)),
        }
    }

    fn scaled(self, by: f64) -> Self {
        Self { value: self.value * by, first: self.first * by, second: self.second * by }
    }

    fn power(self, p: f64) -> Self {
        let power = |k: f64| Binary::Power.of(self.value, p - k);
        self.chain([power(0.0), p * power(1.0), p * (p - 1.0) * power(2.0)])
    }

    fn power_difference(self, delta: Self, p: f64) -> Self {
        // D(p) = aᵖ − sᵖ with s = a + δ: D(p)′ = p (D(p−1) a′ − sᵖ⁻¹ δ′).
        let (a, s) = (self, self + delta);
        let of = |p: f64| a.value.power_difference(delta.value, p);
        let first = |p: f64| p * (of(p - 1.0) * a.first - s.value.power(p - 1.0) * delta.first);
        let of_delta = s.power(p - 1.0);
        let second = p
            * (first(p - 1.0) * a.first + of(p - 1.0) * a.second
                - of_delta.first * delta.first
                - of_delta.value * delta.second);
        Self { value: of(p), first: first(p), second }
    }

    /// Returns self/d, or zero without derivatives (NaN) if d is zero.
    fn over_or_zero(self, d: Self) -> Self {
        if d.value == 0.0 { Self { value: 0.0, first: f64::NAN, second: f64::NAN } } else { self / d }
    }

    fn wrapped(self) -> Self {
        Self { value: self.value.wrapped(), ..self }
    }

    fn half_angle_over_sine(self) -> Self {
        let w = self.value;
        let (f, square) = (w.half_angle_over_sine(), (1.0 - w) * (1.0 + w));
        // f = Σ n!/(2n + 1)!! xⁿ, x = 1 − w; (1 − w²) f′ = w f − 1, (1 − w²) f″ = 3 w f′ + f.
        let x = 1.0 - w;
        if x > 0.3 {
            let first = (w * f - 1.0) / square;
            return self.chain([f, first, (3.0 * w * first + f) / square]);
        }
        let (mut term, mut first, mut second) = (1.0, 0.0, 0.0);
        for n in 1..30 {
            let n = f64::from(n);
            // n!/(2n + 1)!! xⁿ⁻¹.
            term *= n / (2.0 * n + 1.0);
            first -= n * term;
            second += (n + 1.0) * n * term * (n + 1.0) / (2.0 * n + 3.0);
            term *= x;
        }
        self.chain([f, first, second])
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        Self { value: self.value + b.value, first: self.first + b.first, second: self.second + b.second }
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self + -b
    }
}

impl Neg for Jet {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, first: -self.first, second: -self.second }
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        Self {
            value: self.value * b.value,
            first: self.first * b.value + self.value * b.first,
            second: self.second * b.value + 2.0 * self.first * b.first + self.value * b.second,
        }
    }
}

impl Div for Jet {
    type Output = Self;
    /// Returns q = a/b, with q′ = (a′ − q b′)/b and q″ = (a″ − 2 q′ b′ − q b″)/b.
    fn div(self, b: Self) -> Self {
        let value = self.value / b.value;
        let first = (self.first - value * b.first) / b.value;
        let second = (self.second - 2.0 * first * b.first - value * b.second) / b.value;
        Self { value, first, second }
    }
}

impl Formula {
    /// Returns the value and the first and second derivative with respect to the only variable.
    /// They are exact except for rounding, without differences.
    ///
    /// Derivatives at a corner of the formula (`abs`, `min`, `max`, `if`) are one-sided.
    ///
    /// ```
    /// use polhode::math::formula::{Formula, Instruction, Unary};
    /// // sin(t²)
    /// let formula = Formula::new([
    ///     Instruction::Variable(0),
    ///     Instruction::Unary(Unary::Power(2)),
    ///     Instruction::Unary(Unary::Sin),
    /// ])?;
    /// let [value, first, second] = formula.derivatives(0.5);
    /// let (s, c) = 0.25_f64.sin_cos();
    /// assert!((value - s).abs() < 1e-16 && (first - c).abs() < 1e-15);
    /// assert!((second - (2.0 * c - s)).abs() < 1e-15);
    /// # Ok::<(), polhode::math::formula::FormulaError>(())
    /// ```
    pub fn derivatives(&self, variable: f64) -> [f64; 3] {
        let nothing = Jet::constant(f64::NAN);
        let mut stack: Vec<Jet> = Vec::with_capacity(16);
        for instruction in self.instructions() {
            let mut take = || stack.pop().unwrap_or(nothing);
            let result = match *instruction {
                Instruction::Constant(value) => Jet::constant(value),
                Instruction::Variable(0) => Jet { value: variable, first: 1.0, second: 0.0 },
                Instruction::Variable(_) => nothing,
                Instruction::Unary(function) => take().unary(function),
                Instruction::Binary(function) => {
                    let (b, a) = (take(), take());
                    a.binary(function, b)
                }
                Instruction::If => {
                    let (otherwise, then, condition) = (take(), take(), take());
                    match condition.value {
                        c if c.is_nan() => nothing,
                        0.0 => otherwise,
                        _ => then,
                    }
                }
                Instruction::Clip => {
                    let (high, low) = (take(), take());
                    take().binary(Binary::Max, low).binary(Binary::Min, high)
                }
                Instruction::Local(k) => stack.get(k).copied().unwrap_or(nothing),
                Instruction::EndLocal => {
                    let top = take();
                    take();
                    top
                }
            };
            stack.push(result);
        }
        let Jet { value, first, second } = stack.pop().unwrap_or(nothing);
        [value, first, second]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Instruction as I;

    /// Returns operands that depend on t: a = 0.3 + 0.2 sin t … between 0.1 and 0.5, and
    /// b = 1.2 + 0.1 t².
    fn operands() -> ([I; 6], [I; 6]) {
        let a = [
            I::Variable(0),
            I::Unary(Unary::Sin),
            I::Constant(0.2),
            I::Binary(Binary::Multiply),
            I::Constant(0.3),
            I::Binary(Binary::Add),
        ];
        let b = [
            I::Variable(0),
            I::Unary(Unary::Power(2)),
            I::Constant(0.1),
            I::Binary(Binary::Multiply),
            I::Constant(1.2),
            I::Binary(Binary::Add),
        ];
        (a, b)
    }

    fn agrees(instructions: &[I]) {
        let formula = Formula::new(instructions.iter().copied()).unwrap();
        let (t, h) = (0.8, 1e-3);
        let [value, first, second] = formula.derivatives(t);
        let f = |k: f64| formula.evaluate(&[t + k * h]);
        assert!((value - f(0.0)).abs() <= 2e-16 * value.abs(), "{instructions:?}");
        // Central differences of fourth order.
        let slope = (8.0 * (f(1.0) - f(-1.0)) - (f(2.0) - f(-2.0))) / (12.0 * h);
        let bend = (16.0 * (f(1.0) + f(-1.0)) - (f(2.0) + f(-2.0)) - 30.0 * f(0.0)) / (12.0 * h * h);
        assert!((first - slope).abs() < 1e-10 * (1.0 + slope.abs()), "{instructions:?}: {first} {slope}");
        assert!((second - bend).abs() < 1e-8 * (1.0 + bend.abs()), "{instructions:?}: {second} {bend}");
    }

    #[test]
    fn every_function_is_differentiated() {
        let (a, b) = operands();
        for function in [
            Unary::Negate,
            Unary::Sqrt,
            Unary::Exp,
            Unary::Log,
            Unary::Sin,
            Unary::Cos,
            Unary::Tan,
            Unary::Asin,
            Unary::Acos,
            Unary::Atan,
            Unary::Sinh,
            Unary::Cosh,
            Unary::Tanh,
            Unary::Log1p,
            Unary::Expm1,
            Unary::Abs,
            Unary::Floor,
            Unary::Power(0),
            Unary::Power(1),
            Unary::Power(5),
            Unary::Power(-3),
        ] {
            agrees(&[&a[..], &[I::Unary(function)]].concat());
        }
        for function in [
            Binary::Add,
            Binary::Subtract,
            Binary::Multiply,
            Binary::Divide,
            Binary::Power,
            Binary::Atan2,
            Binary::Min,
            Binary::Max,
            Binary::Hypot,
            Binary::Mod,
            Binary::Less,
        ] {
            agrees(&[&a[..], &b, &[I::Binary(function)]].concat());
            agrees(&[&b[..], &a, &[I::Binary(function)]].concat());
        }
        agrees(&[&a[..], &[I::Constant(2.7), I::Binary(Binary::Power)]].concat());
        agrees(&[&[I::Variable(0)][..], &a, &b, &[I::If]].concat());
        agrees(&[&[I::Constant(0.0)][..], &a, &b, &[I::If]].concat());
        for [low, high] in [[-9.0, 9.0], [-9.0, 0.1], [0.9, 9.0]] {
            agrees(&[&a[..], &[I::Constant(low), I::Constant(high), I::Clip]].concat());
        }
    }

    #[test]
    fn powers_of_zero_and_corners_have_the_derivatives_of_a_side() {
        let power = |n| Formula::new([I::Variable(0), I::Unary(Unary::Power(n))]).unwrap().derivatives(0.0);
        assert_eq!(power(1), [0.0, 1.0, 0.0]);
        assert_eq!(power(2), [0.0, 0.0, 2.0]);
        assert_eq!(power(3), [0.0, 0.0, 0.0]);
        let corner = Formula::new([I::Variable(0), I::Unary(Unary::Abs)]).unwrap();
        assert_eq!(corner.derivatives(0.0), [0.0, 1.0, 0.0]);
        assert_eq!(corner.derivatives(-2.0), [2.0, -1.0, -0.0]);
        // The square root of a constant zero is not singular.
        let root = Formula::new([I::Constant(0.0), I::Unary(Unary::Sqrt)]).unwrap();
        assert_eq!(root.derivatives(1.0), [0.0; 3]);
        assert!(Formula::new([I::Variable(1)]).unwrap().derivatives(1.0)[0].is_nan());
    }
}
