//! Monomials: products of powers of variables.

use core::cmp::Ordering;

use crate::symbol::Variable;

/// Product of powers of variables.
///
/// The order is graded lexicographic (Cox, Little and O'Shea, *Ideals, Varieties, and Algorithms*,
/// §2.2): by total degree, then by the exponent of the first variable that differs.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Monomial {
    /// Variables in order with their exponents, which are positive.
    powers: Vec<(Variable, u32)>,
}

impl Monomial {
    /// Returns the empty product.
    pub const fn one() -> Self {
        Self { powers: Vec::new() }
    }

    /// Returns a power of one variable.
    pub fn power(variable: Variable, exponent: u32) -> Self {
        Self { powers: if exponent == 0 { Vec::new() } else { vec![(variable, exponent)] } }
    }

    /// Returns the variables in order with their exponents.
    pub fn powers(&self) -> &[(Variable, u32)] {
        &self.powers
    }

    /// Returns true for the empty product.
    pub fn is_one(&self) -> bool {
        self.powers.is_empty()
    }

    /// Returns the sum of the exponents.
    pub fn degree(&self) -> u32 {
        self.powers.iter().fold(0, |sum, &(_, exponent)| sum.saturating_add(exponent))
    }

    /// Returns the exponent of a variable.
    pub fn exponent(&self, variable: Variable) -> u32 {
        self.powers.iter().find(|(other, _)| *other == variable).map_or(0, |&(_, exponent)| exponent)
    }

    /// Returns the product. Exponents are limited to 2³² − 1, which no polynomial of a formula
    /// reaches.
    pub fn times(&self, other: &Self) -> Self {
        self.combined(other, |a, b| Some(a.saturating_add(b))).unwrap_or_default()
    }

    /// Returns the quotient; `None` if it is not a monomial.
    pub fn over(&self, divisor: &Self) -> Option<Self> {
        self.combined(divisor, u32::checked_sub)
    }

    /// Returns the greatest common divisor.
    pub fn gcd(&self, other: &Self) -> Self {
        self.combined(other, |a, b| Some(a.min(b))).unwrap_or_default()
    }

    /// Returns the monomial without a variable.
    pub fn without(&self, variable: Variable) -> Self {
        Self { powers: self.powers.iter().filter(|(other, _)| *other != variable).copied().collect() }
    }

    /// Merges the exponents of two monomials variable by variable.
    fn combined(&self, other: &Self, rule: impl Fn(u32, u32) -> Option<u32>) -> Option<Self> {
        let (mut left, mut right) = (self.powers.iter().peekable(), other.powers.iter().peekable());
        let mut powers = Vec::with_capacity(self.powers.len() + other.powers.len());
        loop {
            let variable = match (left.peek(), right.peek()) {
                (None, None) => return Some(Self { powers }),
                (Some(&&(a, _)), Some(&&(b, _))) => a.min(b),
                (Some(&&(a, _)), None) | (None, Some(&&(a, _))) => a,
            };
            let a = left.next_if(|(other, _)| *other == variable).map_or(0, |&(_, exponent)| exponent);
            let b = right.next_if(|(other, _)| *other == variable).map_or(0, |&(_, exponent)| exponent);
            match rule(a, b)? {
                0 => {}
                exponent => powers.push((variable, exponent)),
            }
        }
    }
}

impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_degree = self.degree().cmp(&other.degree());
        by_degree.then_with(|| {
            for (&(a, m), &(b, n)) in self.powers.iter().zip(&other.powers) {
                // The monomial with the earlier variable is the greater one.
                match b.cmp(&a).then(m.cmp(&n)) {
                    Ordering::Equal => {}
                    unequal => return unequal,
                }
            }
            self.powers.len().cmp(&other.powers.len())
        })
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
