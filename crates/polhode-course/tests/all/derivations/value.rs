//! Exact values of formulas, and their arithmetic.

use polhode_algebra::{Matrix, RationalFunction, Vector};

/// Exact value of a formula.
#[derive(Clone, Debug, PartialEq, Eq)]
#[expect(clippy::large_enum_variant, reason = "few values exist at a time")]
pub(super) enum Value {
    /// Scalar value.
    Scalar(RationalFunction),
    /// Vector, along fixed axes.
    Vector(Vector),
    /// Tensor or rotation.
    Matrix(Matrix),
}

impl Value {
    pub(super) fn zero() -> Self {
        Self::from(0)
    }

    /// Returns true for a value of any kind whose components are zero.
    pub(super) fn is_zero(&self) -> bool {
        match self {
            Self::Scalar(value) => value.is_zero(),
            Self::Vector(value) => value.is_zero(),
            Self::Matrix(value) => *value == Matrix::zero(),
        }
    }

    /// Returns the value with a function applied to each component.
    pub(super) fn map(&self, function: impl Fn(&RationalFunction) -> RationalFunction) -> Self {
        match self {
            Self::Scalar(value) => Self::Scalar(function(value)),
            Self::Vector(value) => Self::Vector(value.map(function)),
            Self::Matrix(value) => Self::Matrix(value.map(function)),
        }
    }

    /// Returns the sum; 0 can be added to a value of any kind.
    pub(super) fn plus(self, other: Self) -> Option<Self> {
        Some(match (self, other) {
            (Self::Scalar(a), Self::Scalar(b)) => Self::Scalar(a + b),
            (Self::Vector(a), Self::Vector(b)) => Self::Vector(a + b),
            (Self::Matrix(a), Self::Matrix(b)) => Self::Matrix(a + b),
            (Self::Scalar(zero), other) | (other, Self::Scalar(zero)) if zero.is_zero() => other,
            _ => return None,
        })
    }

    /// Returns the product without a sign.
    pub(super) fn times(self, other: Self) -> Option<Self> {
        Some(match (self, other) {
            (Self::Scalar(a), other) | (other, Self::Scalar(a)) => other.map(|b| b * &a),
            (Self::Matrix(a), Self::Matrix(b)) => Self::Matrix(a * b),
            (Self::Matrix(a), Self::Vector(b)) => Self::Vector(a.times_vector(&b)),
            _ => return None,
        })
    }

    /// Returns the product with the sign ·.
    pub(super) fn dot(self, other: Self) -> Option<Self> {
        match (self, other) {
            (Self::Vector(a), Self::Vector(b)) => Some(Self::Scalar(a.dot(&b))),
            (Self::Vector(a), Self::Matrix(b)) => Some(Self::Vector(b.transposed().times_vector(&a))),
            (a, b) => a.times(b),
        }
    }

    /// Returns the product with the sign ×.
    pub(super) fn cross(self, other: Self) -> Option<Self> {
        match (self, other) {
            (Self::Vector(a), Self::Vector(b)) => Some(Self::Vector(a.cross(&b))),
            _ => None,
        }
    }

    /// Returns the power; the square of a vector is its scalar product with itself.
    pub(super) fn power(self, exponent: i32) -> Option<Self> {
        match self {
            Self::Scalar(base) => base.pow(exponent).map(Self::Scalar),
            Self::Vector(base) if exponent == 2 => Some(Self::Scalar(base.dot(&base))),
            _ => None,
        }
    }

    pub(super) fn scalar(self) -> Option<RationalFunction> {
        if let Self::Scalar(value) = self { Some(value) } else { None }
    }
}

impl From<i64> for Value {
    fn from(value: i64) -> Self {
        Self::Scalar(value.into())
    }
}
