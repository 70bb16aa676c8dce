//! Equations and conserved quantities along the computed motion.

use polhode::math::{Direction, Frame, Vector};
use polhode_algebra::{Monomial, Polynomial, RationalFunction, Symbol, Variable};

use super::system::System;

/// Largest number of instants at which equations are evaluated.
const MOST_INSTANTS: usize = 2001;
/// Scale of an equation whose terms all vanish, relative to the scale of the motion.
const LEAST_SCALE: f64 = 1e-3;

/// Motion in the coordinates of a system.
pub(super) struct Motion {
    pub instants: Vec<Instant>,
    /// Number of samples at which the coordinates are singular.
    pub left_out: usize,
}

/// Coordinates at one time.
pub(super) struct Instant {
    pub time: f64,
    /// q, q̇ and q̈ of each coordinate, SI.
    pub coordinates: Vec<[f64; 3]>,
    /// Values of other symbols, such as a force of constraint.
    pub others: Vec<(Symbol, f64)>,
}

/// Values of all symbols of a system along a motion.
pub(super) struct Course {
    rows: Vec<(f64, Vec<(Symbol, f64)>)>,
    /// Largest kinetic energy, J.
    energy: f64,
    /// Largest rate q̇ divided by the size of its coordinate, rad/s.
    rate: f64,
}

/// Largest departure of an equation from zero, or of a quantity from its first value.
#[derive(Clone, Copy)]
pub(super) struct Departure {
    /// Departure relative to the largest term along the motion.
    pub relative: f64,
    /// Time of the departure, s.
    pub time: f64,
}

impl Course {
    /// Evaluates the momenta; `None` if a value is not finite.
    pub(super) fn of(system: &System, motion: &Motion) -> Option<Self> {
        let lagrangian = system.lagrangian();
        let momenta: Vec<_> = system.coordinates.iter().map(|c| lagrangian.momentum(c.symbol)).collect();
        let kinetic = system.kinetic_energy();
        let mut course = Self { rows: Vec::new(), energy: 0.0, rate: 0.0 };
        let step = motion.instants.len().div_ceil(MOST_INSTANTS).max(1);
        for instant in motion.instants.iter().step_by(step) {
            let mut row: Vec<_> = system.constants.iter().map(|c| (c.symbol, c.value)).collect();
            row.extend_from_slice(&instant.others);
            for (c, values) in system.coordinates.iter().zip(&instant.coordinates) {
                let velocity = c.symbol.dot();
                let symbols = [Some(c.symbol), velocity, velocity.and_then(Symbol::dot)];
                row.extend(symbols.into_iter().flatten().zip(*values));
                course.rate = course.rate.max(values[1].abs() / c.size);
            }
            for (c, momentum) in system.coordinates.iter().zip(&momenta) {
                row.push((c.momentum, momentum.evaluate(&|symbol| value(&row, symbol))?));
            }
            course.energy = course.energy.max(kinetic.evaluate(&|symbol| value(&row, symbol))?);
            course.rows.push((instant.time, row));
        }
        let all = || course.rows.iter().flat_map(|(_, row)| row);
        (!course.rows.is_empty() && all().all(|(_, x)| x.is_finite())).then_some(course)
    }

    pub(super) const fn count(&self) -> usize {
        self.rows.len()
    }

    /// Returns the largest kinetic energy, J.
    pub(super) const fn energy(&self) -> f64 {
        self.energy
    }

    /// Returns the largest rate of an angle, rad/s.
    pub(super) const fn rate(&self) -> f64 {
        self.rate
    }

    /// Returns the scale of the momentum of a coordinate with a size.
    pub(super) fn momentum_scale(&self, size: f64) -> f64 {
        if self.rate > 0.0 { self.energy / (self.rate * size) } else { 0.0 }
    }

    /// Returns the value of a function at the first instant.
    pub(super) fn first(&self, function: &RationalFunction) -> Option<f64> {
        let (_, row) = self.rows.first()?;
        function.evaluate(&|symbol| value(row, symbol))
    }

    /// Returns the largest residual of the equation `function = 0`, relative to its largest term.
    ///
    /// `scale` is the scale of the motion in the unit of the equation. A thousandth of it replaces
    /// the largest term of an equation whose terms vanish up to rounding.
    pub(super) fn residual(&self, function: &RationalFunction, scale: f64) -> Option<Departure> {
        self.departure(function, scale, false)
    }

    /// Returns the largest departure of a conserved quantity from its first value, relative to its
    /// largest term.
    pub(super) fn drift(&self, quantity: &RationalFunction, scale: f64) -> Option<Departure> {
        self.departure(quantity, scale, true)
    }

    fn departure(&self, function: &RationalFunction, scale: f64, from_first: bool) -> Option<Departure> {
        let (terms, below) = (terms(function), in_sines(function.denominator()));
        let (mut largest, mut worst, mut first) = (LEAST_SCALE * scale, [0.0, 0.0], None);
        for (time, row) in &self.rows {
            let below = evaluated(&below, row)?;
            let mut sum = 0.0;
            for term in &terms {
                let term = evaluated(term, row)? / below;
                sum += term;
                largest = f64::max(largest, term.abs());
            }
            let departure = (sum - if from_first { *first.get_or_insert(sum) } else { 0.0 }).abs();
            // Negated so that NaN is found.
            if !(departure <= worst[0]) {
                worst = [departure, *time];
            }
        }
        let relative = if worst[0] == 0.0 { 0.0 } else { worst[0] / largest };
        Some(Departure { relative, time: worst[1] })
    }
}

/// Returns the components of a vector without its unit.
pub(super) fn plain<Q, F: Frame>(vector: Vector<Q, F>) -> Direction<F> {
    Direction::from_array(vector.to_array())
}

fn value(row: &[(Symbol, f64)], symbol: Symbol) -> Option<f64> {
    row.iter().find(|(other, _)| *other == symbol).map(|&(_, value)| value)
}

/// Returns the terms of a numerator, where those that differ only in sines and cosines are one: I₁ φ̈
/// sin² θ has no cancelling parts I₁ φ̈ and −I₁ φ̈ cos² θ.
fn terms(function: &RationalFunction) -> Vec<Polynomial> {
    let mut groups: Vec<(Monomial, Polynomial)> = Vec::new();
    for (monomial, coefficient) in function.numerator().terms() {
        let is_angle = |v: &Variable| matches!(v, Variable::Sine(_) | Variable::Cosine(_));
        let angles = monomial.powers().iter().map(|(v, _)| *v).filter(is_angle);
        let key = angles.fold(monomial.clone(), |key, v| key.without(v));
        let term = Polynomial::term(coefficient.clone(), monomial.clone());
        match groups.iter_mut().find(|(other, _)| *other == key) {
            Some((_, sum)) => *sum = &*sum + term,
            None => groups.push((key, term)),
        }
    }
    groups.into_iter().map(|(_, sum)| in_sines(&sum)).collect()
}

/// Returns a polynomial with 1 − sin² θ in place of cos² θ, so that sin⁴ θ is one term. Its value as
/// 1 − 2 cos² θ + cos⁴ θ would lose all digits near the pole.
fn in_sines(polynomial: &Polynomial) -> Polynomial {
    polynomial.variables().into_iter().fold(polynomial.clone(), |sum, variable| {
        let Variable::Cosine(angle) = variable else { return sum };
        let cosine = Polynomial::variable(variable);
        let square = Polynomial::one() - Polynomial::variable(Variable::Sine(angle)).pow(2);
        let powers = sum.coefficients_in(variable).into_iter().zip(0_u32..);
        let terms = powers.map(|(coefficient, k)| coefficient * cosine.pow(k % 2) * square.pow(k / 2));
        terms.fold(Polynomial::zero(), |sum, term| sum + term)
    })
}

fn evaluated(polynomial: &Polynomial, row: &[(Symbol, f64)]) -> Option<f64> {
    let mut sum = 0.0;
    for (monomial, coefficient) in polynomial.terms() {
        let mut product = coefficient.to_f64();
        for &(variable, exponent) in monomial.powers() {
            let base = match variable {
                Variable::Root(prime) => f64::from(prime).sqrt(),
                Variable::Symbol(symbol) => value(row, symbol)?,
                Variable::Sine(angle) => value(row, angle)?.sin(),
                Variable::Cosine(angle) => value(row, angle)?.cos(),
            };
            product *= base.powi(i32::try_from(exponent).ok()?);
        }
        sum += product;
    }
    Some(sum)
}
