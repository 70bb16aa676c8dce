//! Evaluation of formulas with generic components.
//!
//! A symbol without a definition has a generic value: a number, three components, or a symmetric
//! tensor. Particles α and axes i both run from 1 to 3. `R_ij` is the product of three rotations by
//! Euler's angles φ, θ, ψ (3-1-3), and `x̂_i`, `ê_i` are unit vectors along fixed axes. Masses,
//! moments of inertia, lengths and g are constant; other symbols depend on time.

use std::collections::HashMap;

use polhode_algebra::{
    Angle, Formula, Kind, Matrix, Polynomial, Rational, RationalFunction, Relation, Symbol, SymbolError,
    Symbols, Variable, Vector,
};
use polhode_course::derivation::notation;

use super::name::{INDICES, Name, digit, name};
use super::value::Value;

/// Symbols that do not depend on time, among them the imaginary unit.
const CONSTANT: &str = "mMIJKAbgci";
/// Tensors that are symmetric unless they are defined.
const SYMMETRIC: &str = "IJKk";
/// Largest number of definitions within each other.
const DEEPEST: usize = 20;

/// Reason why a formula has no value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum EvaluationError {
    /// A text that is not a formula.
    Notation(String),
    /// An index without value.
    Free(char),
    /// A formula of another kind than the evaluation supports.
    Unsupported(Formula),
    /// A symbol that cannot be declared.
    Symbol(SymbolError),
}

pub(super) type Evaluated = Result<Value, EvaluationError>;

/// Definitions, and the generic symbols that were used so far.
#[derive(Debug, Default)]
pub(super) struct Scope {
    /// Symbols with the formulas that define them; the last one counts.
    definitions: Vec<(Name, Formula)>,
    pub(super) indices: HashMap<char, usize>,
    symbols: Symbols,
    /// Symbols that stand for the argument of a sine, such as Ω t.
    phases: Vec<(RationalFunction, Symbol)>,
    known: HashMap<Name, Value>,
    depth: usize,
}

impl Scope {
    /// Adds the definitions a = b and a ≡ b of symbols a. Other equations define nothing.
    pub(super) fn define(&mut self, formula: &Formula) {
        for equation in equations(formula) {
            let Formula::Relation(first, others) = equation else { continue };
            let value =
                others.first().filter(|(sign, _)| matches!(sign, Relation::Equal | Relation::Defined));
            if let (Some((name, 0)), Some((_, value))) = (name(first), value) {
                self.definitions.push((name, value.clone()));
                self.known.clear();
            }
        }
    }

    /// Returns both sides of each equation of a formula, for all values of its free indices.
    pub(super) fn sides(&mut self, notation: &str) -> Result<Vec<[Value; 2]>, EvaluationError> {
        let formula =
            notation::read(notation).ok_or_else(|| EvaluationError::Notation(notation.to_owned()))?;
        let (mut pairs, mut left) = (Vec::new(), &formula);
        for row in equations(&formula) {
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
    pub(super) fn are_equal(&self, [a, b]: &[Value; 2]) -> bool {
        let difference = a.clone().plus(b.map(RationalFunction::negated));
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

    /// Returns the value of a symbol whose indices have values.
    pub(super) fn symbol(&mut self, name: &Name) -> Evaluated {
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

    /// Returns cosine and sine. An argument other than a sum of symbols gets its own symbol.
    pub(super) fn cosine_and_sine(
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
    pub(super) fn rate(&mut self, value: &Value) -> Value {
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
    pub(super) fn generic(&mut self, name: &str) -> Result<RationalFunction, EvaluationError> {
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

/// Returns the equations of lists and rows.
fn equations(formula: &Formula) -> Vec<&Formula> {
    match formula {
        Formula::Rows(parts) | Formula::List(parts) => parts.iter().flat_map(equations).collect(),
        other => vec![other],
    }
}
