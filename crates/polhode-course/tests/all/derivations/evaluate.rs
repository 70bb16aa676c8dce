//! Values of formulas, by the kind of formula.

use polhode_algebra::{Fence, Formula, Large, Matrix, Operator, RationalFunction, Style, Variable, Vector};

use super::name::name;
use super::scope::{Evaluated, EvaluationError, Scope};
use super::value::Value;

impl Scope {
    pub(super) fn value(&mut self, formula: &Formula) -> Evaluated {
        if let Some((name, dots)) = name(formula) {
            let value = self.symbol(&name)?;
            return Ok((0..dots).fold(value, |value, _| self.rate(&value)));
        }
        let unsupported = || EvaluationError::Unsupported(formula.clone());
        let value = match formula {
            Formula::Number(digits) => digits.parse().ok().map(|number: i64| Value::from(number)),
            Formula::Negative(inside) => Some(self.value(inside)?.map(RationalFunction::negated)),
            Formula::Sum(terms) => self.folded(terms, Value::zero(), Value::plus)?,
            Formula::Product(factors) => self.folded(factors, Value::from(1), Value::times)?,
            Formula::Operation(operator, parts) => {
                let first = parts.first().map_or_else(|| Err(unsupported()), |first| self.value(first))?;
                let others = parts.get(1..).unwrap_or_default();
                self.folded(
                    others,
                    first,
                    if *operator == Operator::Dot { Value::dot } else { Value::cross },
                )?
            }
            Formula::Fraction(above, below) => self.quotient(above, below)?,
            Formula::Power(base, exponent) => self.power(base, exponent)?,
            Formula::Function(function, argument) => self.function(function, argument)?,
            Formula::Limits { operator: Large::Sum, below: Some(index), body, .. } => {
                Some(self.sum(index, body)?)
            }
            Formula::Limits { below: Some(below), above: Some(above), body, .. } => {
                self.integral([below, above], body)?
            }
            Formula::Group(Fence::Parentheses, inside) => match &**inside {
                Formula::List(cells) => self.vector(cells)?,
                _ => None,
            },
            Formula::Group(Fence::Braces, inside) if **inside == Formula::integer(1) => {
                Some(Value::Matrix(Matrix::identity()))
            }
            Formula::Group(Fence::Brackets, inside) => Some(self.value(inside)?),
            Formula::Matrix(fence, rows) => self.matrix(*fence, rows)?,
            _ => None,
        };
        value.ok_or_else(unsupported)
    }

    fn folded(
        &mut self,
        parts: &[Formula],
        start: Value,
        with: fn(Value, Value) -> Option<Value>,
    ) -> Result<Option<Value>, EvaluationError> {
        let mut result = Some(start);
        for part in parts {
            let part = self.value(part)?;
            result = result.and_then(|result| with(result, part));
        }
        Ok(result)
    }

    /// Returns a quotient or a derivative.
    fn quotient(&mut self, above: &Formula, below: &Formula) -> Result<Option<Value>, EvaluationError> {
        Ok(match (above, below) {
            (Formula::Differential { is_partial: false, of }, Formula::Differential { .. }) => {
                let value = self.value(of)?;
                Some(self.rate(&value))
            }
            (Formula::Differential { of, .. }, Formula::Differential { of: variable, .. }) => {
                let (value, variable) = (self.value(of)?, self.value(variable)?.scalar());
                let variable = variable.and_then(|variable| variable.symbols().next());
                variable.map(|variable| value.map(|component| component.derivative(variable)))
            }
            _ => {
                let (above, below) = (self.value(above)?, self.value(below)?.scalar());
                let inverse = below.and_then(|below| RationalFunction::one().over(&below));
                inverse.and_then(|inverse| above.times(Value::Scalar(inverse)))
            }
        })
    }

    /// Returns a power, a transpose, or cos x + i sin x for e^(i x).
    fn power(&mut self, base: &Formula, exponent: &Formula) -> Result<Option<Value>, EvaluationError> {
        let letter =
            |formula: &Formula, letter| matches!(formula, Formula::Letter(text, _) if text == letter);
        if letter(base, "e") {
            let (i, exponent) = (self.generic("i")?, self.value(exponent)?.scalar());
            let Some(angle) = exponent.and_then(|exponent| exponent.over(&i)) else { return Ok(None) };
            let [cosine, sine] = self.cosine_and_sine(&angle)?;
            return Ok(Some(Value::Scalar(cosine + i * sine)));
        }
        Ok(match (self.value(base)?, exponent) {
            (Value::Matrix(base), exponent) if letter(exponent, "T") => {
                Some(Value::Matrix(base.transposed()))
            }
            (base, Formula::Number(digits)) => digits.parse().ok().and_then(|exponent| base.power(exponent)),
            _ => None,
        })
    }

    fn function(&mut self, function: &Formula, argument: &Formula) -> Result<Option<Value>, EvaluationError> {
        let argument = self.value(argument)?;
        Ok(match (function, argument) {
            (Formula::Fraction(..), argument) => Some(self.rate(&argument)),
            (Formula::Letter(name, _), Value::Matrix(matrix)) if name == "det" => {
                Some(Value::Scalar(matrix.determinant()))
            }
            (Formula::Letter(name, _), Value::Scalar(angle)) => {
                let [cosine, sine] = self.cosine_and_sine(&angle)?;
                match name.as_str() {
                    "sin" => Some(sine),
                    "cos" => Some(cosine),
                    "tan" => sine.over(&cosine),
                    _ => None,
                }
                .map(Value::Scalar)
            }
            _ => None,
        })
    }

    fn sum(&mut self, index: &Formula, body: &Formula) -> Evaluated {
        let Formula::Letter(letters, _) = index else {
            return Err(EvaluationError::Unsupported(index.clone()));
        };
        let Some(letter) = letters.chars().next() else { return self.value(body) };
        let rest = Formula::Letter(letters[letter.len_utf8()..].to_owned(), Style::Italic);
        let outer = self.indices.get(&letter).copied();
        let mut sum = Ok(Value::zero());
        for value in 1..=3 {
            self.indices.insert(letter, value);
            let term = self.sum(&rest, body);
            let unsupported = || EvaluationError::Unsupported(body.clone());
            sum = sum.and_then(|sum| sum.plus(term?).ok_or_else(unsupported));
        }
        match outer {
            Some(outer) => self.indices.insert(letter, outer),
            None => self.indices.remove(&letter),
        };
        sum
    }

    /// Returns the integral of a polynomial in the variable of the differential in the body.
    fn integral(&mut self, limits: [&Formula; 2], body: &Formula) -> Result<Option<Value>, EvaluationError> {
        let factors =
            if let Formula::Product(factors) = body { &factors[..] } else { core::slice::from_ref(body) };
        let (mut variable, mut integrand) = (None, Value::from(1));
        for factor in factors {
            if let Formula::Differential { of, .. } = factor {
                variable = self.value(of)?.scalar().and_then(|value| value.symbols().next());
            } else {
                let Some(product) = integrand.times(self.value(factor)?) else { return Ok(None) };
                integrand = product;
            }
        }
        let [from, to] = [self.value(limits[0])?.scalar(), self.value(limits[1])?.scalar()];
        let (Some(variable), Some(integrand), Some(from), Some(to)) =
            (variable, integrand.scalar(), from, to)
        else {
            return Ok(None);
        };
        let coefficients = integrand.numerator().coefficients_in(Variable::Symbol(variable));
        let sum = (1..).zip(coefficients).try_fold(RationalFunction::zero(), |sum, (power, coefficient)| {
            let difference = to.pow(power)? - from.pow(power)?;
            let number = RationalFunction::from(i64::from(power));
            Some(sum + (difference * RationalFunction::from(coefficient)).over(&number)?)
        });
        Ok(sum
            .and_then(|sum| sum.over(&RationalFunction::from(integrand.denominator().clone())))
            .map(Value::Scalar))
    }

    fn vector(&mut self, cells: &[Formula]) -> Result<Option<Value>, EvaluationError> {
        let mut components = Vec::new();
        for cell in cells {
            components.extend(self.value(cell)?.scalar());
        }
        Ok(<[_; 3]>::try_from(components).ok().map(|components| Value::Vector(Vector(components))))
    }

    /// Returns a matrix, a column vector or a determinant.
    fn matrix(&mut self, fence: Fence, rows: &[Vec<Formula>]) -> Result<Option<Value>, EvaluationError> {
        if rows.iter().all(|row| row.len() == 1) {
            return self.vector(&rows.concat());
        }
        let mut elements = Vec::new();
        for row in rows {
            elements.extend(
                self.vector(row)?
                    .and_then(|row| if let Value::Vector(row) = row { Some(row.0) } else { None }),
            );
        }
        let matrix = <[_; 3]>::try_from(elements).ok().map(Matrix);
        Ok(matrix.map(|matrix| match fence {
            Fence::Bars => Value::Scalar(matrix.determinant()),
            _ => Value::Matrix(matrix),
        }))
    }
}
