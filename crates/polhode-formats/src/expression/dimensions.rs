//! What the parts of a formula measure: from its variables and units to its value.

use polhode::math::formula::{Binary, Instruction, Unary};

use super::function::FUNCTIONS;
use super::{ExpressionError, ExpressionErrorKind};
use crate::unit::Dimension;

/// An instruction, where the text has it, and, of a number, what its unit measures.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    pub(super) instruction: Instruction,
    pub(super) column: usize,
    pub(super) dimension: Dimension,
}

/// What a value measures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Measured {
    /// Nothing yet: it is a 0 that fits everywhere.
    Zero,
    As(Dimension),
}

/// On the stack: what a value measures, and the value if it is a number in the text.
type Operand = (Measured, Option<f64>);

/// What the value measures, angles not counted; everything is of the dimension that its place asks for.
pub(super) fn measure(steps: &[Step], variables: &[Dimension]) -> Result<Measured, ExpressionError> {
    let mut stack: Vec<Operand> = Vec::new();
    for step in steps {
        let at = stack.len().saturating_sub(step.instruction.operands());
        let operands = stack.split_off(at);
        let result = step.result(&operands, variables);
        stack.push(result.map_err(|kind| ExpressionError { kind, column: step.column })?);
    }
    Ok(stack.pop().map_or(Measured::Zero, |(value, _)| value))
}

impl Step {
    fn result(&self, operands: &[Operand], variables: &[Dimension]) -> Result<Operand, ExpressionErrorKind> {
        let measured = match (self.instruction, operands) {
            (Instruction::Constant(value), _) => {
                let bare_zero = value == 0.0 && self.dimension == Dimension::NONE;
                let measured = if bare_zero { Measured::Zero } else { Measured::As(self.dimension) };
                return Ok((measured, Some(value)));
            }
            (Instruction::Variable(k), _) => {
                Measured::As(variables.get(k).copied().unwrap_or(Dimension::NONE))
            }
            (Instruction::Unary(Unary::Negate), &[(a, number)]) => return Ok((a, number.map(|x| -x))),
            (Instruction::Unary(Unary::Abs), &[(a, _)]) => a,
            (Instruction::Unary(Unary::Sqrt), &[(a, _)]) => self.raised(a, 0.5)?,
            (Instruction::Unary(Unary::Power(n)), &[(a, _)]) => self.raised(a, f64::from(n))?,
            (Instruction::Unary(_), &[(a, _)]) => self.plain(a)?,
            (Instruction::Binary(Binary::Multiply), &[(a, _), (b, _)]) => a.times(b, 1),
            (Instruction::Binary(Binary::Divide), &[(a, _), (b, _)]) => a.times(b, -1),
            (Instruction::Binary(Binary::Power), &[(a, _), (b, number)]) => {
                self.plain(b)?;
                match number {
                    Some(power) => self.raised(a, power)?,
                    None => self.plain(a)?,
                }
            }
            (Instruction::Binary(Binary::Add | Binary::Subtract), &[(a, _), (b, _)])
            | (Instruction::Binary(Binary::Min | Binary::Max | Binary::Hypot), &[(a, _), (b, _)]) => {
                self.equal(a, b)?
            }
            // an angle, or yes or no
            (Instruction::Binary(_), &[(a, _), (b, _)]) => {
                self.equal(a, b)?;
                Measured::PLAIN
            }
            (Instruction::If, &[(condition, _), (a, _), (b, _)]) => {
                self.plain(condition)?;
                self.equal(a, b)?
            }
            _ => Measured::PLAIN,
        };
        Ok((measured, None))
    }

    fn equal(&self, a: Measured, b: Measured) -> Result<Measured, ExpressionErrorKind> {
        match (a, b) {
            (Measured::Zero, other) | (other, Measured::Zero) => Ok(other),
            (Measured::As(a), Measured::As(b)) if a == b => Ok(Measured::As(a)),
            (Measured::As(a), Measured::As(b)) => Err(ExpressionErrorKind::Unequal {
                operation: self.name(),
                left: a.with_angle(),
                right: b.with_angle(),
            }),
        }
    }

    fn plain(&self, a: Measured) -> Result<Measured, ExpressionErrorKind> {
        match a {
            Measured::Zero | Measured::PLAIN => Ok(Measured::PLAIN),
            Measured::As(found) => {
                let (function, found) = (self.name(), found.with_angle());
                Err(ExpressionErrorKind::NotPlain { function, found })
            }
        }
    }

    fn raised(&self, a: Measured, power: f64) -> Result<Measured, ExpressionErrorKind> {
        let Measured::As(found) = a else { return Ok(if power > 0.0 { a } else { Measured::PLAIN }) };
        let broken = || ExpressionErrorKind::BrokenPower { function: self.name(), found: found.with_angle() };
        found.raised(power).map(Measured::As).ok_or_else(broken)
    }

    /// The function or the sign.
    fn name(&self) -> &'static str {
        match self.instruction {
            Instruction::Binary(Binary::Add) => "+",
            Instruction::Binary(Binary::Subtract) => "-",
            Instruction::Binary(Binary::Power) => "^",
            Instruction::Binary(Binary::Less) => "<",
            Instruction::Binary(Binary::LessOrEqual) => "<=",
            Instruction::Binary(Binary::Greater) => ">",
            Instruction::Binary(Binary::GreaterOrEqual) => ">=",
            instruction => FUNCTIONS.iter().find(|f| f.op == instruction).map_or("a product", |f| f.name),
        }
    }
}

impl Measured {
    const PLAIN: Self = Self::As(Dimension::NONE);

    /// `self` × `other`^power
    fn times(self, other: Self, power: i8) -> Self {
        match (self, other) {
            (Self::Zero, _) => Self::Zero,
            (_, Self::Zero) if power > 0 => Self::Zero,
            (a, Self::Zero) => a,
            (Self::As(a), Self::As(b)) => Self::As(a.times(b, power)),
        }
    }
}
