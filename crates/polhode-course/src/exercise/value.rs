//! Values of questions: one number, the components of a vector, or the six elements of a tensor.

use polhode_algebra::RationalFunction;

use super::topic::Form;

/// Largest accepted difference, relative to the largest component: three digits are right.
pub(super) const TOLERANCE: f64 = 0.005;

/// Value of an answer.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    /// Numbers in SI units.
    Numbers(Vec<f64>),
    /// Formulas in the symbols of the problem.
    Formulas(Vec<RationalFunction>),
}

impl Value {
    /// Returns true if an answer is this value: within the tolerance, or identical as a formula.
    pub(super) fn is_met_by(&self, answer: &Self, form: Form) -> bool {
        match (self, answer) {
            (Self::Numbers(value), Self::Numbers(answer)) => {
                distance(value, answer, form) <= TOLERANCE * (1.0 + 1e-9)
            }
            (value, answer) => value == answer,
        }
    }

    /// Returns the value times a number.
    pub(super) fn scaled(&self, factor: f64) -> Option<Self> {
        match self {
            Self::Numbers(numbers) => Some(Self::Numbers(numbers.iter().map(|x| x * factor).collect())),
            Self::Formulas(formulas) => {
                // Factors of formulas are dyadic: 2, 1/2 and −1.
                let factor = factor.to_string().parse::<polhode_algebra::Rational>().ok()?;
                Some(Self::Formulas(formulas.iter().map(|f| f.scaled(&factor)).collect()))
            }
        }
    }
}

/// Returns the quantity whose formula has this value.
pub(super) fn finished(inner: f64, form: Form) -> f64 {
    match form {
        Form::Plain | Form::Axis => inner,
        Form::Square(_) => inner.sqrt(),
        Form::Tangent(_) => libm::atan(inner),
        Form::SquaredTangent(_) => libm::atan(inner.sqrt()),
    }
}

/// Returns the largest difference of components, relative to the largest component of `value`. Of
/// two axes, those of unit vectors in the same half space.
pub(super) fn distance(value: &[f64], answer: &[f64], form: Form) -> f64 {
    if form == Form::Axis {
        let dot: f64 = value.iter().zip(answer).map(|(a, b)| a * b).sum();
        let [a, b] = [value, answer].map(|v| v.iter().map(|x| x * x).sum::<f64>().sqrt());
        let sign = if dot < 0.0 { -1.0 } else { 1.0 };
        let [a, b] = [(value, 1.0 / a), (answer, sign / b)]
            .map(|(v, scale)| v.iter().map(|x| x * scale).collect::<Vec<_>>());
        return distance(&a, &b, Form::Plain);
    }
    let size = largest(value);
    let differences = value.iter().zip(answer).map(|(a, b)| (a - b).abs());
    // NaN, the distance from a vector of length 0, is kept, and is not accepted.
    differences.fold(0.0, |most, d| if d <= most { most } else { d }) / size
}

/// Returns the largest absolute value.
pub(super) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, x| f64::max(most, x.abs()))
}
