//! Derivatives, and Lagrange's equations.

use crate::rational_function::RationalFunction;
use crate::symbol::{Symbol, Variable};
use crate::symbols::{Kind, Symbols};

impl RationalFunction {
    /// Returns the partial derivative with respect to a symbol: sin θ and cos θ depend on θ, and no
    /// other symbol does.
    pub fn derivative(&self, symbol: Symbol) -> Self {
        let (sine, cosine) = (Variable::Sine(symbol), Variable::Cosine(symbol));
        let by_sine = self.partial(sine) * Self::from(cosine);
        let by_cosine = self.partial(cosine) * Self::from(sine);
        self.partial(Variable::Symbol(symbol)) + by_sine - by_cosine
    }

    /// Returns (n′ d − n d′)/d² with all other variables constant.
    fn partial(&self, variable: Variable) -> Self {
        let (n, d) = (self.numerator(), self.denominator());
        let above = n.derivative(variable) * d - n * d.derivative(variable);
        Self::new(&above, &(d * d)).unwrap_or_else(Self::zero)
    }

    /// Returns the symbols that occur, also within sines and cosines.
    pub fn symbols(&self) -> impl Iterator<Item = Symbol> {
        let variables = self.numerator().variables().into_iter().chain(self.denominator().variables());
        let symbols = variables.filter_map(|variable| match variable {
            Variable::Root(_) => None,
            Variable::Symbol(symbol) | Variable::Sine(symbol) | Variable::Cosine(symbol) => Some(symbol),
        });
        symbols.collect::<std::collections::BTreeSet<_>>().into_iter()
    }

    /// Returns the total time derivative Σ ∂f/∂q q̇ + ∂f/∂q̇ q̈ + … over the coordinates q.
    pub fn time_derivative(&self, symbols: &Symbols) -> Self {
        let moving = self.symbols().filter(|&symbol| symbols.kind(symbol) == Kind::Coordinate);
        let terms = moving.filter_map(|symbol| Some(self.derivative(symbol) * Self::from(symbol.dot()?)));
        terms.fold(Self::zero(), |sum, term| sum + term)
    }

    /// Returns the left side d/dt ∂L/∂q̇ − ∂L/∂q of Lagrange's equation for this Lagrangian L
    /// (Goldstein, *Classical Mechanics*, eq. 1.57).
    pub fn lagrange_equation(&self, coordinate: Symbol, symbols: &Symbols) -> Self {
        self.momentum(coordinate).time_derivative(symbols) - self.derivative(coordinate)
    }

    /// Returns the conjugate momentum p = ∂L/∂q̇ for this Lagrangian (Goldstein, eq. 2.44).
    pub fn momentum(&self, coordinate: Symbol) -> Self {
        coordinate.dot().map_or_else(Self::zero, |velocity| self.derivative(velocity))
    }

    /// Returns the energy function h = Σ q̇ ∂L/∂q̇ − L for this Lagrangian, which is constant if L
    /// does not depend on time explicitly (Goldstein, eq. 2.53).
    pub fn energy_function(&self, coordinates: &[Symbol]) -> Self {
        let terms = coordinates.iter().filter_map(|&q| Some(Self::from(q.dot()?) * self.momentum(q)));
        terms.fold(-self, |sum, term| sum + term)
    }
}
