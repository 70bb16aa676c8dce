//! Dimensional analysis of formulas: from variables and units to the dimension of the value.

use std::f64::consts::PI;

use polhode::math::formula::{Binary, Instruction, Unary};

use super::function::FUNCTIONS;
use super::{ExpressionError, ExpressionErrorKind};
use crate::unit::Dimension;

/// Instruction with its column in the text; for a number also the dimension of its unit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    pub instruction: Instruction,
    pub column: usize,
    pub dimension: Dimension,
}

/// Dimension of a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Measured {
    /// A 0 without a unit; it fits every dimension.
    Zero,
    As(Dimension),
}

/// Value on the stack of the analysis.
#[derive(Clone, Copy, Debug)]
struct Operand {
    measured: Measured,
    /// Numerical value, if it is a literal.
    number: Option<f64>,
    angle: Angle,
}

/// Classification of a dimensionless value with respect to angles.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Angle {
    /// An angle: an angle variable, or a number with an angle unit.
    Is,
    /// A number without a unit; the author may have meant degrees.
    Bare(f64),
    /// The sum, or a similar combination, of an angle and a number without a unit.
    Mixed(f64),
    Open,
}

impl Angle {
    /// Returns the number without a unit if the other operand is an angle.
    const fn bare_beside(self, other: Self) -> Option<f64> {
        match (self, other) {
            (Self::Mixed(x), _)
            | (_, Self::Mixed(x))
            | (Self::Is, Self::Bare(x))
            | (Self::Bare(x), Self::Is) => Some(x),
            _ => None,
        }
    }

    /// Returns the class of a sum, or of the greater of two values.
    const fn joined(self, other: Self) -> Self {
        match (self.bare_beside(other), self, other) {
            (Some(x), ..) => Self::Mixed(x),
            (None, Self::Is, _) | (None, _, Self::Is) => Self::Is,
            _ => Self::Open,
        }
    }
}

/// Returns the dimension of the value, not counting angles. Checks that every operand has the
/// required dimension.
pub(crate) fn measure(steps: &[Step], variables: &[Dimension]) -> Result<Measured, ExpressionError> {
    let mut stack: Vec<Operand> = Vec::new();
    for step in steps {
        let at = stack.len().saturating_sub(step.instruction.operands());
        let operands = stack.split_off(at);
        let result = step.result(&operands, variables);
        stack.push(result.map_err(|kind| ExpressionError { kind, column: step.column })?);
    }
    Ok(stack.pop().map_or(Measured::Zero, |value| value.measured))
}

impl Step {
    fn result(&self, operands: &[Operand], variables: &[Dimension]) -> Result<Operand, ExpressionErrorKind> {
        let is_angle = |dimension: Dimension| {
            if dimension == Dimension::ANGLE { Angle::Is } else { Angle::Open }
        };
        let measured = match (self.instruction, operands) {
            (Instruction::Constant(value), _) => {
                let is_bare = value != 0.0 && value != PI && self.dimension == Dimension::NONE;
                let is_zero = value == 0.0 && self.dimension == Dimension::NONE;
                let measured = Measured::As(self.dimension.without_angle());
                return Ok(Operand {
                    measured: if is_zero { Measured::Zero } else { measured },
                    number: Some(value),
                    angle: if is_bare { Angle::Bare(value) } else { is_angle(self.dimension) },
                });
            }
            (Instruction::Variable(k), _) => {
                let dimension = variables.get(k).copied().unwrap_or(Dimension::NONE);
                let measured = Measured::As(dimension.without_angle());
                return Ok(Operand { measured, number: None, angle: is_angle(dimension) });
            }
            (Instruction::Unary(Unary::Negate), &[a]) => {
                return Ok(Operand { number: a.number.map(|x| -x), ..a });
            }
            (Instruction::Unary(Unary::Abs), &[a]) => return Ok(Operand { number: None, ..a }),
            (Instruction::Unary(Unary::Asin | Unary::Acos | Unary::Atan), &[a]) => {
                let measured = self.plain(a.measured)?;
                return Ok(Operand { measured, number: None, angle: Angle::Is });
            }
            (Instruction::Unary(Unary::Sqrt), &[a]) => self.raised(a.measured, 0.5)?,
            (Instruction::Unary(Unary::Power(n)), &[a]) => self.raised(a.measured, f64::from(n))?,
            (Instruction::Unary(_), &[a]) => self.plain(a.measured)?,
            // A number times an angle is an angle.
            (Instruction::Binary(Binary::Multiply | Binary::Divide), &[a, b]) => {
                let is_product = self.instruction == Instruction::Binary(Binary::Multiply);
                let angle = match (a.angle, b.angle) {
                    (Angle::Is | Angle::Mixed(_), _) if b.number.is_some() => a.angle,
                    (_, Angle::Is | Angle::Mixed(_)) if a.number.is_some() && is_product => b.angle,
                    _ => Angle::Open,
                };
                let measured = a.measured.times(b.measured, if is_product { 1 } else { -1 });
                return Ok(Operand { measured, number: None, angle });
            }
            (Instruction::Binary(Binary::Power), &[a, b]) => {
                self.plain(b.measured)?;
                match b.number {
                    Some(power) => self.raised(a.measured, power)?,
                    None => self.plain(a.measured)?,
                }
            }
            (Instruction::Binary(Binary::Add | Binary::Subtract), &[a, b])
            | (Instruction::Binary(Binary::Min | Binary::Max | Binary::Hypot | Binary::Mod), &[a, b]) => {
                let measured = self.equal(a.measured, b.measured)?;
                return Ok(Operand { measured, number: None, angle: a.angle.joined(b.angle) });
            }
            (Instruction::Binary(Binary::And | Binary::Or), &[a, b]) => {
                self.plain(a.measured)?;
                self.plain(b.measured)?
            }
            (Instruction::Binary(Binary::Atan2), &[a, b]) => {
                self.equal(a.measured, b.measured)?;
                return Ok(Operand { measured: Measured::PLAIN, number: None, angle: Angle::Is });
            }
            // Comparisons and logical operators.
            (Instruction::Binary(_), &[a, b]) => {
                if let Some(number) = a.angle.bare_beside(b.angle) {
                    let (operation, found) = (self.name(), number.to_string());
                    return Err(ExpressionErrorKind::BareAngle { operation, found });
                }
                self.equal(a.measured, b.measured)?;
                Measured::PLAIN
            }
            (Instruction::Clip, &[a, low, high]) => {
                let measured = self.equal(a.measured, self.equal(low.measured, high.measured)?)?;
                let angle = a.angle.joined(low.angle).joined(high.angle);
                return Ok(Operand { measured, number: None, angle });
            }
            (Instruction::If, &[condition, a, b]) => {
                self.plain(condition.measured)?;
                self.equal(a.measured, b.measured)?
            }
            _ => Measured::PLAIN,
        };
        Ok(Operand { measured, number: None, angle: Angle::Open })
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

    /// Returns the name of the function or the operator sign.
    fn name(&self) -> &'static str {
        match self.instruction {
            Instruction::Binary(Binary::Add) => "+",
            Instruction::Binary(Binary::Subtract) => "-",
            Instruction::Binary(Binary::Power) => "^",
            Instruction::Binary(Binary::Less) => "<",
            Instruction::Binary(Binary::LessOrEqual) => "<=",
            Instruction::Binary(Binary::Greater) => ">",
            Instruction::Binary(Binary::GreaterOrEqual) => ">=",
            Instruction::Binary(Binary::And) => "and",
            Instruction::Binary(Binary::Or) => "or",
            instruction => FUNCTIONS.iter().find(|f| f.op == instruction).map_or("a product", |f| f.name),
        }
    }
}

impl Measured {
    const PLAIN: Self = Self::As(Dimension::NONE);

    /// Returns `self` × `other`^power.
    fn times(self, other: Self, power: i8) -> Self {
        match (self, other) {
            (Self::Zero, _) => Self::Zero,
            (_, Self::Zero) if power > 0 => Self::Zero,
            (a, Self::Zero) => a,
            (Self::As(a), Self::As(b)) => Self::As(a.times(b, power)),
        }
    }
}
