//! Symbols, random values and random points for the other tests.

use std::cell::RefCell;
use std::collections::BTreeMap;

use polhode_algebra::{Kind, Polynomial, Rational, RationalFunction, Symbols, Variable, parse};

/// Generator SplitMix64 (Steele, Lea and Flood, 2014).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Returns an integer from 0 up to, but not including, a bound.
    pub(crate) fn below(&mut self, bound: u64) -> u64 {
        self.next() % bound
    }

    /// Returns a rational number that is not zero.
    pub(crate) fn rational(&mut self) -> Rational {
        let above = self.below(9) as i64 + 1;
        let sign = if self.below(2) == 0 { 1 } else { -1 };
        Rational::new(sign * above, self.below(6) as i64 + 1).unwrap()
    }

    /// Returns a polynomial in some variables, with up to `terms` terms of degree up to 3.
    pub(crate) fn polynomial(&mut self, variables: &[Variable], terms: u64) -> Polynomial {
        let mut sum = Polynomial::from(self.rational());
        for _ in 0..1 + self.below(terms) {
            let mut product = Polynomial::from(self.rational());
            for _ in 0..self.below(4) {
                let variable = variables[self.below(variables.len() as u64) as usize];
                product = product * Polynomial::variable(variable);
            }
            sum = sum + product;
        }
        if sum.is_zero() { Polynomial::one() } else { sum }
    }

    /// Returns a quotient of two polynomials.
    pub(crate) fn quotient(&mut self, variables: &[Variable]) -> RationalFunction {
        loop {
            let (above, below) = (self.polynomial(variables, 4), self.polynomial(variables, 3));
            if let Some(quotient) = RationalFunction::new(&above, &below) {
                return quotient;
            }
        }
    }
}

/// Returns the symbols of the tests, in the order of the lecture notes.
pub(crate) fn symbols() -> Symbols {
    let mut symbols = Symbols::new();
    for name in ["M", "m_1", "m_2", "I_1", "I_2", "I_3", "rho", "R", "r", "a", "b", "h", "g"] {
        symbols.declare(name, Kind::Positive).unwrap();
    }
    for name in ["omega_1", "omega_2", "omega_3", "theta", "phi", "psi"] {
        symbols.declare(name, Kind::Coordinate).unwrap();
    }
    for name in ["omega", "alpha", "lambda", "x", "y", "z", "u", "v", "w"] {
        symbols.declare(name, Kind::Constant).unwrap();
    }
    symbols
}

/// Returns the value of a formula in the symbols of the tests.
pub(crate) fn value(text: &str) -> RationalFunction {
    parse(text, &symbols()).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// Returns a variable of the tests: `x`, `sin(alpha)`, `sqrt(3)`.
pub(crate) fn variable(text: &str) -> Variable {
    *value(text).numerator().variables().first().unwrap()
}

pub(crate) fn variables<const N: usize>(names: [&str; N]) -> [Variable; N] {
    names.map(variable)
}

/// Point with a random rational value of each variable; sine and cosine of an angle are
/// 2t/(1 + t²) and (1 − t²)/(1 + t²).
pub(crate) struct Point {
    random: RefCell<Random>,
    values: RefCell<BTreeMap<Variable, Rational>>,
}

impl Point {
    pub(crate) fn new(seed: u64) -> Self {
        Self { random: RefCell::new(Random(seed)), values: RefCell::default() }
    }

    pub(crate) fn value(&self, variable: Variable) -> Rational {
        if let Some(value) = self.values.borrow().get(&variable) {
            return value.clone();
        }
        let t = self.random.borrow_mut().rational() + Rational::new(1, 7).unwrap();
        let mut values = self.values.borrow_mut();
        match variable {
            Variable::Sine(angle) | Variable::Cosine(angle) => {
                let one = Rational::one();
                let below = &one + &t * &t;
                values.insert(Variable::Sine(angle), (&t + &t).over(&below).unwrap());
                values.insert(Variable::Cosine(angle), (&one - &t * &t).over(&below).unwrap());
            }
            Variable::Symbol(_) => {
                values.insert(variable, t);
            }
            Variable::Root(_) => panic!("√p has no rational value"),
        }
        values[&variable].clone()
    }

    /// Returns the value of a function; `None` at a pole.
    pub(crate) fn at(&self, function: &RationalFunction) -> Option<Rational> {
        function.evaluate_exactly(&|variable| Some(self.value(variable)))
    }
}
