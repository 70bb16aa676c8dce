//! Matrices with three rows and three columns.

use crate::gcd::{gcd_of, lcm};
use crate::operators::operators;
use crate::polynomial::Polynomial;
use crate::rational_function::RationalFunction;
use crate::univariate::Univariate;
use crate::vector::Vector;

/// Matrix with its elements by row.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Matrix(pub [[RationalFunction; 3]; 3]);

impl Matrix {
    /// Returns the matrix with the elements of a function of row and column.
    pub fn from_elements(element: impl Fn(usize, usize) -> RationalFunction) -> Self {
        Self(core::array::from_fn(|i| core::array::from_fn(|j| element(i, j))))
    }

    /// Returns the zero matrix.
    pub fn zero() -> Self {
        Self::from_elements(|_, _| RationalFunction::zero())
    }

    /// Returns the unit matrix.
    pub fn identity() -> Self {
        Self::from_elements(|i, j| RationalFunction::from(i64::from(i == j)))
    }

    /// Returns the tensor product aᵢ bⱼ.
    pub fn outer(a: &Vector, b: &Vector) -> Self {
        Self::from_elements(|i, j| &a.0[i] * &b.0[j])
    }

    /// Returns the sum.
    pub fn plus(&self, other: &Self) -> Self {
        Self::from_elements(|i, j| &self.0[i][j] + &other.0[i][j])
    }

    /// Returns the matrix product.
    pub fn times(&self, other: &Self) -> Self {
        let columns = other.transposed();
        Self::from_elements(|i, j| self.row(i).dot(&columns.row(j)))
    }

    /// Returns the product with a column vector.
    pub fn times_vector(&self, vector: &Vector) -> Vector {
        Vector(core::array::from_fn(|i| self.row(i).dot(vector)))
    }

    /// Returns the matrix with the other sign.
    pub fn negated(&self) -> Self {
        self.map(RationalFunction::negated)
    }

    /// Returns the product with a scalar.
    pub fn scaled(&self, factor: &RationalFunction) -> Self {
        self.map(|element| element * factor)
    }

    /// Returns the matrix with a function applied to each element.
    pub fn map(&self, function: impl Fn(&RationalFunction) -> RationalFunction) -> Self {
        Self::from_elements(|i, j| function(&self.0[i][j]))
    }

    /// Returns a row.
    pub fn row(&self, row: usize) -> Vector {
        Vector(self.0[row].clone())
    }

    /// Returns the transpose.
    pub fn transposed(&self) -> Self {
        Self::from_elements(|i, j| self.0[j][i].clone())
    }

    /// Returns true if the matrix equals its transpose.
    pub fn is_symmetric(&self) -> bool {
        *self == self.transposed()
    }

    /// Returns the sum of the diagonal elements.
    pub fn trace(&self) -> RationalFunction {
        &self.0[0][0] + &self.0[1][1] + &self.0[2][2]
    }

    /// Returns the determinant.
    pub fn determinant(&self) -> RationalFunction {
        self.row(0).dot(&self.row(1).cross(&self.row(2)))
    }

    /// Returns the inverse, from the vector products of the rows; `None` if the determinant is zero.
    pub fn inverse(&self) -> Option<Self> {
        let scale = RationalFunction::one().over(&self.determinant())?;
        let rows = [0, 1, 2].map(|k| self.row((k + 1) % 3).cross(&self.row((k + 2) % 3)).0);
        Some(Self(rows).transposed().scaled(&scale))
    }

    /// Returns det(λ − A) = λ³ − tr A λ² + M λ − det A, where M is the sum of the principal minors.
    pub fn characteristic_polynomial(&self) -> Univariate {
        let minor = |[i, j]: [usize; 2]| &self.0[i][i] * &self.0[j][j] - &self.0[i][j] * &self.0[j][i];
        let [a, b, c] = [[0, 1], [0, 2], [1, 2]].map(minor);
        Univariate::new(vec![-self.determinant(), a + b + c, -self.trace(), RationalFunction::one()])
    }

    /// Returns the common factor of all elements and the matrix without it: M b² and a matrix of
    /// numbers. Numbers stay in the matrix.
    pub fn factored(&self) -> (RationalFunction, Self) {
        let elements = || self.0.iter().flatten();
        let numerators: Vec<Polynomial> = elements().map(|e| e.numerator().clone()).collect();
        let denominator = elements().fold(Polynomial::one(), |all, e| lcm(&all, e.denominator()));
        let Some(factor) = RationalFunction::new(&gcd_of(&numerators), &denominator).filter(|f| !f.is_zero())
        else {
            return (RationalFunction::one(), self.clone());
        };
        let rest = self.map(|element| element.over(&factor).unwrap_or_else(RationalFunction::zero));
        (factor, rest)
    }
}

operators!(Matrix);
