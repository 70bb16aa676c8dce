//! Roots of polynomials of degree up to three in closed form, and eigenvalues and eigenvectors.

use crate::lifting::rational_roots;
use crate::matrix::Matrix;
use crate::rational::Rational;
use crate::rational_function::RationalFunction;
use crate::square_root::SquareRoot;
use crate::univariate::Univariate;
use crate::vector::Vector;

/// Roots of a polynomial.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Roots {
    /// Roots in the field of rational functions and square roots of numbers, each with its
    /// multiplicity; ascending where that holds for all positive values of the symbols.
    pub rational: Vec<(RationalFunction, usize)>,
    /// Roots besides these.
    pub rest: RemainingRoots,
}

/// Roots that are not rational functions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RemainingRoots {
    /// All roots are rational functions.
    None,
    /// The two roots of a quadratic equation.
    Pair(RootPair),
    /// A polynomial without closed form here: no root of it was found, and its degree is above 2.
    NoClosedForm(Univariate),
}

/// Pair of roots a ± c √d.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RootPair {
    /// Mean value a.
    pub center: RationalFunction,
    /// Deviation c √d.
    pub deviation: SquareRoot,
}

impl Univariate {
    /// Returns the roots in closed form.
    pub fn roots(&self) -> Roots {
        self.roots_with(&[])
    }

    /// Returns the roots in closed form; `candidates` are tried first.
    pub fn roots_with(&self, candidates: &[RationalFunction]) -> Roots {
        let mut result = Roots { rational: Vec::new(), rest: RemainingRoots::None };
        let mut rest = self.monic();
        for candidate in candidates {
            result.take(candidate, &mut rest);
        }
        // Roots of f/gcd(f, f′) are those of f, each once.
        let simple =
            |f: &Self| f.divided(&f.gcd(&f.derivative())).map_or_else(|| f.clone(), |(q, _)| q.monic());
        let mut single = simple(&rest);
        if single.degree() > 2 {
            for root in rational_roots(&single).unwrap_or_default() {
                result.take(&root, &mut rest);
            }
            single = simple(&rest);
        }
        if single.degree() == 1 {
            result.take(&-&single.coefficients()[0], &mut rest);
        } else if single.degree() == 2 {
            result.take_pair(&single, &mut rest);
        } else if single.degree() > 2 {
            result.rest = RemainingRoots::NoClosedForm(rest);
        }
        result.sort();
        result
    }
}

impl Roots {
    /// Divides `rest` by λ − root as often as possible, and keeps the root if it is one.
    fn take(&mut self, root: &RationalFunction, rest: &mut Univariate) {
        let mut multiplicity = 0;
        while rest.degree() > 0 && rest.at(root).is_zero() {
            let Some((quotient, _)) = rest.divided(&Univariate::linear(root)) else { break };
            *rest = quotient;
            multiplicity += 1;
        }
        if multiplicity > 0 {
            self.rational.push((root.clone(), multiplicity));
        }
    }

    /// Solves λ² + p λ + q = 0: λ = −p/2 ± √(p²/4 − q).
    fn take_pair(&mut self, quadratic: &Univariate, rest: &mut Univariate) {
        let [q, p] = [0, 1].map(|k| &quadratic.coefficients()[k]);
        let half = Rational::new(1, 2).unwrap_or_else(Rational::one);
        let center = -p.scaled(&half);
        let deviation = (&center * &center - q).square_split();
        match deviation.as_rational_function() {
            Some(deviation) => {
                for root in [&center - &deviation, &center + &deviation] {
                    self.take(&root, rest);
                }
            }
            None => self.rest = RemainingRoots::Pair(RootPair { center, deviation }),
        }
    }

    /// Sorts neighbours whose difference has only positive coefficients.
    fn sort(&mut self) {
        for end in (1..self.rational.len()).rev() {
            for k in 0..end {
                if (&self.rational[k].0 - &self.rational[k + 1].0).has_positive_coefficients() {
                    self.rational.swap(k, k + 1);
                }
            }
        }
    }
}

impl Matrix {
    /// Returns the eigenvalues in closed form.
    pub fn eigenvalues(&self) -> Roots {
        // Diagonal elements are tried because sines in the others exclude factorization.
        let diagonal: Vec<RationalFunction> = (0..3).map(|k| self.0[k][k].clone()).collect();
        self.characteristic_polynomial().roots_with(&diagonal)
    }

    /// Returns a basis of the eigenvectors of a symmetric matrix for one eigenvalue: orthogonal, and
    /// each [primitive](Vector::primitive), such as (1, 1, 1). It is empty if the value is not an
    /// eigenvalue.
    pub fn eigenvectors(&self, value: &RationalFunction) -> Vec<Vector> {
        let shifted = self - &Self::identity().scaled(value);
        let rows = [0, 1, 2].map(|k| shifted.row(k));
        // Two independent rows leave the direction of their vector product.
        let normal = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| rows[i].cross(&rows[j]));
        match (normal.iter().find(|n| !n.is_zero()), rows.iter().find(|row| !row.is_zero())) {
            (Some(_), _) if !shifted.determinant().is_zero() => Vec::new(),
            (Some(normal), _) => vec![normal.primitive()],
            (None, None) => (0..3).map(Vector::unit).collect(),
            // The plane across the only independent row n: e × n and n × (e × n).
            (None, Some(row)) => {
                let first = (0..3).rev().map(|k| Vector::unit(k).cross(row)).find(|v| !v.is_zero());
                let first = first.unwrap_or_else(Vector::zero).primitive();
                let second = row.cross(&first).primitive();
                vec![first, second]
            }
        }
    }
}
