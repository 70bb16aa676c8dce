//! Mechanical systems in symbols: T, U, momenta, equations of motion and the Hamiltonian.

use polhode_algebra::{
    Formula, Kind, Matrix, Monomial, Polynomial, RationalFunction, Symbol, SymbolError, Symbols, Variable,
};

/// System with up to three coordinates, whose kinetic energy is quadratic in the velocities.
pub(super) struct System {
    pub symbols: Symbols,
    /// Constants with the values of the scenario.
    pub constants: Vec<Constant>,
    pub coordinates: Vec<Coordinate>,
    /// Terms of T, each of which is printed with its own factors.
    pub kinetic: Vec<RationalFunction>,
    /// Terms of T in the components of ω, if they are shorter.
    pub body: Option<BodyRates>,
    pub potential: RationalFunction,
}

/// Constant of a system.
pub(super) struct Constant {
    pub symbol: Symbol,
    pub value: f64,
    pub unit: &'static str,
    pub meaning: &'static str,
}

/// Generalized coordinate and its momentum.
pub(super) struct Coordinate {
    pub symbol: Symbol,
    pub momentum: Symbol,
    pub unit: &'static str,
    /// Length that corresponds to an angle of 1 rad, m; 1 for an angle.
    pub size: f64,
}

/// Components of ω along the principal axes as abbreviations.
pub(super) struct BodyRates {
    pub omega: [Symbol; 3],
    pub momenta: [Symbol; 3],
    pub moments: [RationalFunction; 3],
    /// ω₁, ω₂, ω₃ in coordinates and velocities.
    pub values: [RationalFunction; 3],
}

/// Hamiltonian of a system.
pub(super) struct Hamiltonian {
    /// Velocities q̇ in coordinates and momenta.
    pub velocities: Vec<RationalFunction>,
    /// Terms of H.
    pub terms: Vec<RationalFunction>,
    pub function: RationalFunction,
}

impl BodyRates {
    /// Returns Σ Iₖ ωₖ ∂ωₖ/∂x term by term, which is ∂T/∂x.
    pub(super) fn derivative(&self, symbol: Symbol) -> Vec<RationalFunction> {
        let term = |k: usize| {
            let slope = in_letters(self.values[k].derivative(symbol), &self.values, &self.omega);
            slope * &self.moments[k] * RationalFunction::from(self.omega[k])
        };
        (0..3).map(term).filter(|term| !term.is_zero()).collect()
    }
}

impl System {
    pub(super) fn new() -> Self {
        Self {
            symbols: Symbols::new(),
            constants: Vec::new(),
            coordinates: Vec::new(),
            kinetic: Vec::new(),
            body: None,
            potential: RationalFunction::zero(),
        }
    }

    /// Declares a positive constant.
    pub(super) fn constant(
        &mut self,
        name: &str,
        value: f64,
        unit: &'static str,
        meaning: &'static str,
    ) -> Result<RationalFunction, SymbolError> {
        let symbol = self.symbols.declare(name, Kind::Positive)?;
        self.constants.push(Constant { symbol, value, unit, meaning });
        Ok(symbol.into())
    }

    /// Declares a coordinate with its momentum; `size` is the length that corresponds to 1 rad.
    pub(super) fn coordinate(
        &mut self,
        name: &str,
        unit: &'static str,
        size: f64,
    ) -> Result<Symbol, SymbolError> {
        let symbol = self.symbols.declare(name, Kind::Coordinate)?;
        let momentum = self.symbols.declare(&format!("p_{name}"), Kind::Coordinate)?;
        self.coordinates.push(Coordinate { symbol, momentum, unit, size });
        Ok(symbol)
    }

    pub(super) fn kinetic_energy(&self) -> RationalFunction {
        self.kinetic.iter().fold(RationalFunction::zero(), |sum, term| sum + term)
    }

    pub(super) fn lagrangian(&self) -> RationalFunction {
        self.kinetic_energy() - &self.potential
    }

    pub(super) fn energy(&self) -> RationalFunction {
        self.kinetic_energy() + &self.potential
    }

    /// Returns true if L does not contain the coordinate, so that its momentum is constant.
    pub(super) fn is_cyclic(&self, coordinate: &Coordinate) -> bool {
        self.lagrangian().derivative(coordinate.symbol).is_zero()
    }

    /// Returns the velocities and accelerations as variables, by which terms are collected.
    pub(super) fn rates(&self) -> Vec<Variable> {
        let of = |c: &Coordinate| [c.symbol.dot(), c.symbol.dot().and_then(Symbol::dot)];
        self.coordinates.iter().flat_map(of).flatten().map(Variable::Symbol).collect()
    }

    /// Returns the Hamiltonian H = Σ p q̇ − L, with q̇ from p = M q̇, where M is the matrix
    /// ∂²T/∂q̇∂q̇; `None` if M has no inverse.
    pub(super) fn hamiltonian(&self) -> Option<Hamiltonian> {
        let kinetic = self.kinetic_energy();
        let element = |i: usize, j: usize| match (self.coordinates.get(i), self.coordinates.get(j)) {
            (Some(a), Some(b)) => kinetic.momentum(a.symbol).momentum(b.symbol),
            _ => RationalFunction::from(i64::from(i == j)),
        };
        let inverse = Matrix::from_elements(element).inverse()?;
        let momenta = || self.coordinates.iter().map(|c| RationalFunction::from(c.momentum));
        let velocity = |i: usize| {
            let terms = momenta().zip(inverse.row(i).0).map(|(p, element)| p * element);
            terms.fold(RationalFunction::zero(), |sum, term| sum + term)
        };
        let velocities: Vec<_> = (0..self.coordinates.len()).map(velocity).collect();
        let in_momenta = |f: &RationalFunction| self.with_velocities(f, &velocities);
        let products = momenta().zip(&velocities).map(|(p, v)| p * v);
        let products = products.fold(RationalFunction::zero(), |sum, term| sum + term);
        let function = products - in_momenta(&self.lagrangian())?;
        let mut terms = self.kinetic.iter().map(in_momenta).collect::<Option<Vec<_>>>()?;
        terms.push(self.potential.clone());
        terms.retain(|term| !term.is_zero());
        Some(Hamiltonian { velocities, terms, function })
    }

    /// Returns L₁, L₂, L₃ along the principal axes in coordinates and momenta.
    pub(super) fn body_momenta(&self, h: &Hamiltonian) -> Vec<RationalFunction> {
        let of = |body: &BodyRates| {
            let value =
                |k: usize| self.with_velocities(&body.values[k].times(&body.moments[k]), &h.velocities);
            (0..3).map(value).collect::<Option<Vec<_>>>()
        };
        self.body.as_ref().and_then(of).unwrap_or_default()
    }

    /// Returns ∂H/∂x term by term; with the letters L₁, L₂, L₃, where H = Σ Lₖ²/2Iₖ.
    pub(super) fn slope(&self, h: &Hamiltonian, symbol: Symbol) -> Vec<RationalFunction> {
        let mut terms: Vec<_> = match &self.body {
            None => h.terms.iter().map(|term| term.derivative(symbol)).collect(),
            Some(body) => {
                let letters = body.momenta.iter().zip(&body.moments);
                let factors = letters.filter_map(|(l, moment)| RationalFunction::from(*l).over(moment));
                let values = self.body_momenta(h);
                let slope = |l: &RationalFunction| in_letters(l.derivative(symbol), &values, &body.momenta);
                factors.zip(&values).map(|(factor, l)| slope(l) * factor).collect()
            }
        };
        terms.retain(|term| !term.is_zero());
        terms
    }

    /// Returns a function with values in place of the velocities.
    pub(super) fn with_velocities(
        &self,
        function: &RationalFunction,
        velocities: &[RationalFunction],
    ) -> Option<RationalFunction> {
        let rates = || self.coordinates.iter().map(|c| c.symbol.dot().map(Variable::Symbol));
        let place = |v: Variable| rates().position(|rate| rate == Some(v));
        function.replaced(&|v| Some(place(v).map_or_else(|| v.into(), |k| velocities[k].clone())))
    }

    /// Returns the value as a sum over the powers of some variables. Terms with accelerations come
    /// first; each has its own denominator.
    pub(super) fn collected(&self, value: &RationalFunction, variables: &[Variable]) -> Formula {
        collected(value, variables, &self.symbols)
    }

    /// Returns the sum of terms, each with its common factors outside.
    pub(super) fn sum(&self, terms: &[RationalFunction]) -> Formula {
        Formula::sum(terms.iter().map(|term| term.to_formula(&self.symbols)).collect())
    }

    /// Returns the printed form of a symbol.
    pub(super) fn letter(&self, symbol: Symbol) -> Formula {
        self.symbols.notation(symbol)
    }
}

/// Returns a value as a sum over the powers of some variables, or of all if there are none.
pub(super) fn collected(value: &RationalFunction, variables: &[Variable], symbols: &Symbols) -> Formula {
    let mut groups: Vec<(Monomial, Polynomial)> = Vec::new();
    for (monomial, coefficient) in value.numerator().terms() {
        let powers = monomial.powers().iter().filter(|(v, _)| variables.is_empty() || variables.contains(v));
        let key =
            powers.fold(Monomial::one(), |key, &(v, exponent)| key.times(&Monomial::power(v, exponent)));
        let term = Polynomial::term(coefficient.clone(), monomial.clone());
        match groups.iter_mut().find(|(other, _)| *other == key) {
            Some((_, sum)) => *sum = &*sum + term,
            None => groups.push((key, term)),
        }
    }
    let order = |key: &Monomial| {
        let orders =
            key.powers().iter().map(|(v, _)| if let Variable::Symbol(s) = v { s.order() } else { 0 });
        orders.max().unwrap_or(0)
    };
    groups.sort_by(|(a, _), (b, _)| (order(b) > 1).cmp(&(order(a) > 1)).then_with(|| b.cmp(a)));
    let term = |(_, sum): &(Monomial, Polynomial)| RationalFunction::new(sum, value.denominator());
    let mut terms: Vec<_> = groups.iter().filter_map(term).map(|term| term.to_formula(symbols)).collect();
    let is_positive = |term: &Formula| !matches!(term, Formula::Negative(_));
    if let Some(first) = terms.iter().position(is_positive) {
        terms[..=first].rotate_right(1);
    }
    Formula::sum(terms)
}

/// Returns the letter of a component in place of its value or negative value, such as ω₂ for ∂ω₁/∂ψ;
/// other values are returned as they are.
fn in_letters(value: RationalFunction, values: &[RationalFunction], letters: &[Symbol]) -> RationalFunction {
    for (other, letter) in values.iter().zip(letters) {
        if value == *other {
            return (*letter).into();
        }
        if value == -other {
            return -RationalFunction::from(*letter);
        }
    }
    value
}

/// Returns the velocity of a coordinate.
pub(super) fn velocity(coordinate: Symbol) -> RationalFunction {
    coordinate.dot().map_or_else(RationalFunction::zero, Into::into)
}

pub(super) fn sine(angle: Symbol) -> RationalFunction {
    Variable::Sine(angle).into()
}

pub(super) fn cosine(angle: Symbol) -> RationalFunction {
    Variable::Cosine(angle).into()
}

/// Returns ½ a b².
pub(super) fn half_square(a: &RationalFunction, b: &RationalFunction) -> RationalFunction {
    (a * b * b).over(&RationalFunction::from(2)).unwrap_or_else(RationalFunction::zero)
}

/// Returns a function at the angle whose sine and cosine are given; the angle itself is replaced by
/// zero.
pub(super) fn at_angle(
    function: &RationalFunction,
    angle: Symbol,
    [sine, cosine]: [i64; 2],
) -> Option<RationalFunction> {
    function.replaced(&|variable| {
        Some(match variable {
            Variable::Sine(other) if other == angle => RationalFunction::from(sine),
            Variable::Cosine(other) if other == angle => RationalFunction::from(cosine),
            Variable::Symbol(other) if other == angle => RationalFunction::zero(),
            other => other.into(),
        })
    })
}
