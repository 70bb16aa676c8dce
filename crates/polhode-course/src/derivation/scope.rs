//! Evaluation of formulas with generic components.
//!
//! A symbol without a definition has a generic value: a number, three components, or a symmetric
//! tensor. Particles α and axes i both run from 1 to 3. `R_ij` is the product of three rotations by
//! Euler's angles φ, θ, ψ (3-1-3), and `x̂_i`, `ê_i` are unit vectors along fixed axes. Masses,
//! moments of inertia, lengths and g are constant; other symbols depend on time.

use std::collections::HashMap;

use polhode_algebra::{
    Accent, Angle, Fence, Formula, Kind, Large, Matrix, Operator, Polynomial, Rational, RationalFunction,
    Relation, Style, Symbol, SymbolError, Symbols, Variable, Vector,
};

use super::value::Value;

/// Letters that are indices.
const INDICES: &str = "ijklαβ";
/// Symbols that do not depend on time, among them the imaginary unit.
const CONSTANT: &str = "mMIJKAbgci";
/// Tensors that are symmetric unless they are defined.
const SYMMETRIC: &str = "IJKk";
/// Largest number of definitions within each other.
const DEEPEST: usize = 20;

/// Reason why a formula has no value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EvaluationError {
    /// A text that is not a formula.
    Notation(String),
    /// An index without value.
    Free(char),
    /// A formula of another kind than the evaluation supports.
    Unsupported(Formula),
    /// A symbol that cannot be declared.
    Symbol(SymbolError),
}

type Evaluated = Result<Value, EvaluationError>;

/// Symbol apart from its dots.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
struct Name {
    letter: String,
    is_hat: bool,
    is_bold: bool,
    is_matrix: bool,
    index: Vec<char>,
}

/// Definitions, and the generic symbols that were used so far.
#[derive(Debug, Default)]
pub(super) struct Scope {
    /// Symbols with the formulas that define them; the last one counts.
    definitions: Vec<(Name, Formula)>,
    indices: HashMap<char, usize>,
    symbols: Symbols,
    /// Symbols that stand for the argument of a sine, such as Ω t.
    phases: Vec<(RationalFunction, Symbol)>,
    known: HashMap<Name, Value>,
    depth: usize,
}

impl Scope {
    /// Adds the definitions a = b and a ≡ b of symbols a. Other formulas define nothing.
    pub(super) fn define(&mut self, formula: &Formula) {
        match formula {
            Formula::Relation(first, others) => {
                if let (Some((name, 0)), [(Relation::Equal | Relation::Defined, value), ..]) =
                    (name(first), &others[..])
                {
                    self.definitions.push((name, value.clone()));
                    self.known.clear();
                }
            }
            Formula::List(parts) | Formula::Rows(parts) => parts.iter().for_each(|part| self.define(part)),
            _ => {}
        }
    }

    /// Returns both sides of each equation of a formula, for all values of its free indices.
    pub(super) fn sides(&mut self, formula: &Formula) -> Result<Vec<[Value; 2]>, EvaluationError> {
        let mut pairs = Vec::new();
        let rows = match formula {
            Formula::Rows(rows) | Formula::List(rows) => &rows[..],
            other => core::slice::from_ref(other),
        };
        let mut left = formula;
        for row in rows {
            let Formula::Relation(first, others) = row else {
                return Err(EvaluationError::Unsupported(row.clone()));
            };
            left = if matches!(&**first, Formula::Text(_)) { left } else { first };
            for (sign, right) in others {
                if *sign != Relation::Equal {
                    return Err(EvaluationError::Unsupported(row.clone()));
                }
                self.pairs(left, right, &mut pairs)?;
            }
        }
        Ok(pairs)
    }

    /// Adds two sides for all values of the free indices.
    fn pairs(
        &mut self,
        a: &Formula,
        b: &Formula,
        pairs: &mut Vec<[Value; 2]>,
    ) -> Result<(), EvaluationError> {
        match self.value(a).and_then(|a| Ok([a, self.value(b)?])) {
            Ok(pair) => {
                pairs.push(pair);
                Ok(())
            }
            Err(EvaluationError::Free(index)) if !self.indices.contains_key(&index) => {
                for value in 1..=3 {
                    self.indices.insert(index, value);
                    let result = self.pairs(a, b, pairs);
                    self.indices.remove(&index);
                    result?;
                }
                Ok(())
            }
            Err(error) => Err(error),
        }
    }

    /// Returns true if the sides are equal, with i² = −1.
    pub(super) fn are_equal(&self, [a, b]: [Value; 2]) -> bool {
        let difference = a.plus(b.map(RationalFunction::negated));
        let imaginary = self.symbols.find("i");
        let reduced = |value: &RationalFunction| {
            let Some(i) = imaginary.map(Variable::Symbol) else { return value.clone() };
            let parts = value.numerator().coefficients_in(i).into_iter().enumerate();
            let numerator = parts.fold(Polynomial::zero(), |sum, (power, part)| {
                let sign = Rational::from(if power % 4 < 2 { 1 } else { -1 });
                sum + (part * Polynomial::variable(i).pow(power as u32 % 2)).scaled(&sign)
            });
            RationalFunction::from(numerator)
        };
        difference.is_some_and(|difference| difference.map(reduced).is_zero())
    }

    fn value(&mut self, formula: &Formula) -> Evaluated {
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

    /// Returns cosine and sine. An argument that is no sum of symbols gets a symbol of its own.
    fn cosine_and_sine(
        &mut self,
        argument: &RationalFunction,
    ) -> Result<[RationalFunction; 2], EvaluationError> {
        let found = self.phases.iter().find(|(other, _)| other == argument).map(|(_, symbol)| *symbol);
        let angle = match Angle::new(argument).or_else(|| found.map(Angle::from)) {
            Some(angle) => angle,
            None => {
                let symbol = self.declared(&format!("phase{}", self.phases.len()))?;
                self.phases.push((argument.clone(), symbol));
                symbol.into()
            }
        };
        Ok([angle.cosine(), angle.sine()])
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

    /// Returns the value of a symbol whose indices have values.
    fn symbol(&mut self, name: &Name) -> Evaluated {
        let mut name = name.clone();
        for index in &mut name.index {
            if INDICES.contains(*index) {
                let value = *self.indices.get(index).ok_or(EvaluationError::Free(*index))?;
                *index = digit(value);
            }
        }
        if name.is_hat && name.index.is_empty() {
            // x̂, ŷ and ẑ are x̂₁, x̂₂ and x̂₃.
            let axis = "xyz".find(&name.letter).unwrap_or(0);
            name = Name { letter: "x".to_owned(), index: vec![digit(axis + 1)], ..name };
        }
        if let Some(value) = self.known.get(&name) {
            return Ok(value.clone());
        }
        let found = self
            .definitions
            .iter()
            .rev()
            .find_map(|(pattern, formula)| Some((pattern.matched(&name)?, formula)));
        let value = match found.map(|(indices, formula)| (indices, formula.clone())) {
            Some((_, formula)) if self.depth == DEEPEST => return Err(EvaluationError::Unsupported(formula)),
            Some((indices, formula)) => {
                let outer = core::mem::replace(&mut self.indices, indices);
                self.depth += 1;
                let value = self.value(&formula);
                self.depth -= 1;
                self.indices = outer;
                match value? {
                    value if name.is_bold && value.is_zero() => Value::Vector(Vector::zero()),
                    value => value,
                }
            }
            None => self.undefined(&name)?,
        };
        self.known.insert(name, value.clone());
        Ok(value)
    }

    /// Returns the value of a symbol without a definition.
    fn undefined(&mut self, name: &Name) -> Evaluated {
        let axes: Vec<usize> =
            name.index.iter().filter_map(|c| c.to_digit(10)).map(|digit| digit as usize).collect();
        let element = |index: Vec<char>, is_matrix| Name { index, is_matrix, ..name.clone() };
        let text: String = name.letter.chars().chain(name.index.iter().copied()).collect();
        let text = text.replace('\'', "prime");
        Ok(match (name, &axes[..]) {
            (Name { is_hat: true, .. }, &[axis @ 1..=3]) => Value::Vector(Vector::unit(axis - 1)),
            (Name { is_matrix: true, .. }, _) => {
                let mut rows = Matrix::zero();
                for (k, component) in rows.0.iter_mut().flatten().enumerate() {
                    let index = vec![digit(k / 3 + 1), digit(k % 3 + 1)];
                    *component =
                        self.symbol(&element(index, false))?.scalar().unwrap_or_else(RationalFunction::zero);
                }
                Value::Matrix(rows)
            }
            (Name { is_bold: true, .. }, _) => {
                let mut component = |k: usize| self.generic(&format!("{text}_{k}"));
                Value::Vector(Vector([component(1)?, component(2)?, component(3)?]))
            }
            (_, &[i, j]) if name.letter == "δ" => Value::from(i64::from(i == j)),
            (_, &[i @ 1..=3, j @ 1..=3]) if name.letter == "R" => {
                Value::Scalar(self.rotation()?.0[i - 1][j - 1].clone())
            }
            (_, &[i @ 1..=3, j @ 1..=3])
                if self.definitions.iter().any(|(other, _)| *other == element(Vec::new(), true)) =>
            {
                match self.symbol(&element(Vec::new(), true))? {
                    Value::Matrix(matrix) => Value::Scalar(matrix.0[i - 1][j - 1].clone()),
                    other => other,
                }
            }
            (_, &[i, j]) if i > j && SYMMETRIC.contains(&name.letter) => {
                return self.symbol(&element(vec![digit(j), digit(i)], false));
            }
            _ => Value::Scalar(self.generic(&text)?),
        })
    }

    /// Returns the rotation to the body axes by Euler's angles: R₃(ψ) R₁(θ) R₃(φ).
    fn rotation(&mut self) -> Result<Matrix, EvaluationError> {
        let mut product = Matrix::identity();
        for (axis, angle) in [(2, "ψ"), (0, "θ"), (2, "φ")] {
            let angle = self.generic(angle)?;
            let [cosine, sine] = self.cosine_and_sine(&angle)?;
            let turn = Matrix::from_elements(|i, j| match ((i + 3 - axis) % 3, (j + 3 - axis) % 3) {
                (0, 0) => RationalFunction::one(),
                (1, 1) | (2, 2) => cosine.clone(),
                (1, 2) => sine.clone(),
                (2, 1) => -&sine,
                _ => RationalFunction::zero(),
            });
            product = product * turn;
        }
        Ok(product)
    }

    /// Returns the time derivative; components are along fixed axes.
    fn rate(&mut self, value: &Value) -> Value {
        let time = self.symbols.find("t").and_then(Symbol::dot);
        let phases: Vec<_> =
            self.phases.iter().filter_map(|(phase, symbol)| Some((symbol.dot()?, phase.clone()))).collect();
        let derivative = |component: &RationalFunction| {
            let rate = component.time_derivative(&self.symbols);
            let known = |variable| match variable {
                Variable::Symbol(symbol) if Some(symbol) == time => Some(RationalFunction::one()),
                Variable::Symbol(symbol) => {
                    let phase = phases.iter().find(|(other, _)| *other == symbol);
                    Some(
                        phase
                            .map_or_else(|| symbol.into(), |(_, phase)| phase.time_derivative(&self.symbols)),
                    )
                }
                other => Some(other.into()),
            };
            // The argument Ω t has the derivative Ω ṫ, and ṫ = 1.
            let rate = rate.replaced(&known).and_then(|rate| rate.replaced(&known));
            rate.unwrap_or_else(RationalFunction::zero)
        };
        value.map(derivative)
    }

    /// Returns the generic value with a name.
    fn generic(&mut self, name: &str) -> Result<RationalFunction, EvaluationError> {
        Ok(self.declared(name)?.into())
    }

    fn declared(&mut self, name: &str) -> Result<Symbol, EvaluationError> {
        let is_constant = name.starts_with(|c| CONSTANT.contains(c));
        let kind = if is_constant { Kind::Constant } else { Kind::Coordinate };
        match self.symbols.find(name) {
            Some(symbol) => Ok(symbol),
            None => self.symbols.declare_as(name, Formula::text(name), kind).map_err(EvaluationError::Symbol),
        }
    }
}

impl Name {
    /// Returns the values of the indices of a defined name that make it another name.
    fn matched(&self, name: &Self) -> Option<HashMap<char, usize>> {
        let is_alike = Self { index: name.index.clone(), ..self.clone() } == *name;
        let mut values = HashMap::new();
        for (pattern, value) in self.index.iter().zip(&name.index) {
            let is_match = match value.to_digit(10).map(|number| number as usize) {
                Some(number) if INDICES.contains(*pattern) => {
                    *values.entry(*pattern).or_insert(number) == number
                }
                _ => pattern == value,
            };
            if !is_match {
                return None;
            }
        }
        (is_alike && self.index.len() == name.index.len()).then_some(values)
    }
}

fn digit(value: usize) -> char {
    char::from_digit(value as u32, 10).unwrap_or('?')
}

/// Returns the name of a symbol and the number of its dots; `None` for other formulas.
fn name(formula: &Formula) -> Option<(Name, usize)> {
    let plain = |letter: &str, is_bold| Name {
        letter: letter.to_owned(),
        is_hat: false,
        is_bold,
        is_matrix: false,
        index: Vec::new(),
    };
    match formula {
        Formula::Letter(letter, style) => Some((plain(letter, *style == Style::Bold), 0)),
        Formula::Group(Fence::Braces, inside) => {
            let (name, dots) = name(inside)?;
            Some((Name { is_bold: false, is_matrix: true, ..name }, dots))
        }
        Formula::Accent(accent, base) => {
            let (name, dots) = name(base)?;
            match accent {
                Accent::Hat => Some((Name { is_hat: true, ..name }, dots)),
                Accent::Dot => Some((name, dots + 1)),
                Accent::DoubleDot => Some((name, dots + 2)),
                _ => None,
            }
        }
        Formula::Subscript(base, index) => {
            let (name, dots) = name(base)?;
            match &**index {
                // A word is a part of the name: T_rot.
                Formula::Letter(word, Style::Upright) => {
                    let letter = name.letter + word;
                    Some((Name { letter, ..name }, dots))
                }
                Formula::Letter(index, _) | Formula::Number(index) => {
                    Some((Name { index: index.chars().collect(), ..name }, dots))
                }
                _ => None,
            }
        }
        _ => None,
    }
}
