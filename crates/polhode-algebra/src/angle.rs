//! Sines and cosines of sums of angles.

use crate::rational_function::RationalFunction;
use crate::symbol::{Symbol, Variable};

/// Largest absolute value of a multiple of an angle.
const LARGEST_MULTIPLE: i64 = 16;

/// Sum of integer multiples of symbols, such as 2θ − φ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Angle {
    multiples: Vec<(i8, Symbol)>,
}

impl Angle {
    /// Returns the angle with a value; `None` if the value is not a sum of integer multiples of
    /// symbols, each within ±16.
    pub fn new(value: &RationalFunction) -> Option<Self> {
        let multiples = value.numerator().terms().map(|(monomial, coefficient)| match monomial.powers() {
            &[(Variable::Symbol(symbol), 1)] if coefficient.is_integer() => {
                let multiple = i64::try_from(coefficient.numerator()).ok()?;
                let is_small = multiple.abs() <= LARGEST_MULTIPLE;
                is_small.then_some((i8::try_from(multiple).ok()?, symbol))
            }
            _ => None,
        });
        let multiples = multiples.collect::<Option<Vec<_>>>()?;
        value.is_polynomial().then_some(Self { multiples })
    }

    /// Returns the sine in terms of sines and cosines of the symbols.
    pub fn sine(&self) -> RationalFunction {
        self.cosine_and_sine().1
    }

    /// Returns the cosine in terms of sines and cosines of the symbols.
    pub fn cosine(&self) -> RationalFunction {
        self.cosine_and_sine().0
    }

    /// Adds one angle after the other: cos(α + β) = cos α cos β − sin α sin β, sin(α + β) = sin α
    /// cos β + cos α sin β.
    fn cosine_and_sine(&self) -> (RationalFunction, RationalFunction) {
        let mut sum = (RationalFunction::one(), RationalFunction::zero());
        for &(multiple, symbol) in &self.multiples {
            let cosine = RationalFunction::from(Variable::Cosine(symbol));
            let sine = RationalFunction::from(Variable::Sine(symbol));
            let sine = if multiple < 0 { -sine } else { sine };
            for _ in 0..multiple.unsigned_abs() {
                let (c, s) = &sum;
                sum = (c * &cosine - s * &sine, s * &cosine + c * &sine);
            }
        }
        sum
    }
}

impl From<Symbol> for Angle {
    fn from(symbol: Symbol) -> Self {
        Self { multiples: vec![(1, symbol)] }
    }
}
