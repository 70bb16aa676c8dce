//! Scenario in symbols.

use polhode_algebra::{Matrix, RationalFunction, SquareRoot, Symbol, Symbols, Vector};

use super::body::SymbolicBody;
use super::gap::Gap;

/// Exact formulas of a scenario, as far as its file has them.
#[derive(Clone, Debug)]
pub enum Exact {
    /// None: the file has numbers only.
    None,
    /// Fractions in SI units: all lengths and masses are short decimals.
    Fractions(Symbolic),
    /// Formulas of its symbols.
    Symbols(Symbolic),
    /// Symbols, but no exact formula of the body.
    Gap(Gap),
}

impl Exact {
    /// Returns the formulas of the symbols, if there are any.
    pub fn symbols(&self) -> Option<&Symbolic> {
        if let Self::Symbols(symbolic) = self { Some(symbolic) } else { None }
    }
}

/// Body and start of a scenario, as exact formulas of its symbols.
///
/// A quantity is `None` where the scenario has none, and a [`Gap`] where its value is not a formula.
#[derive(Clone, Debug)]
pub struct Symbolic {
    /// Symbols of the algebra.
    pub symbols: Symbols,
    /// The symbols of the file, with their values.
    pub known: Vec<Known>,
    /// Symbol of π.
    pub pi: Symbol,
    /// Parts of the body.
    pub body: SymbolicBody,
    /// Mass of the body.
    pub mass: RationalFunction,
    /// Centre of mass c, body axes.
    pub center: Vector,
    /// Inertia tensor about the reference point, the pivot or the centre of mass.
    pub tensor: Matrix,
    /// Angular velocity ω at the start, body axes.
    pub omega: Option<Result<Vector, Gap>>,
    /// Angular acceleration dω/dt of a prescribed motion, body axes.
    pub acceleration: Option<Result<Vector, Gap>>,
    /// Acceleration of gravity, space axes.
    pub gravity: Option<Result<Vector, Gap>>,
    /// Gravity and axis of a pendulum.
    pub pendulum: Option<Result<SymbolicPendulum, Gap>>,
}

/// Symbol with its value.
#[derive(Clone, Debug)]
pub struct Known {
    /// Symbol in formulas.
    pub symbol: Symbol,
    /// Name, `=` and the quantity of the file: `b = 0.3 m`.
    pub written: String,
    /// Value, SI units.
    pub value: f64,
}

/// Body that turns about a fixed axis under gravity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SymbolicPendulum {
    /// Unit vector along the axis, body axes.
    pub axis: Vector,
    /// Component of gravity across the axis.
    pub gravity: SquareRoot,
}

impl Symbolic {
    /// Returns the value of a symbol.
    pub fn value(&self, symbol: Symbol) -> Option<f64> {
        if symbol == self.pi {
            return Some(std::f64::consts::PI);
        }
        self.known.iter().find(|known| known.symbol == symbol).map(|known| known.value)
    }

    /// Returns the value of a formula, SI units.
    pub fn evaluate(&self, formula: &RationalFunction) -> Option<f64> {
        formula.evaluate(&|symbol| self.value(symbol))
    }

    /// Returns the values of the components of a vector.
    pub fn evaluate_vector(&self, vector: &Vector) -> Option<[f64; 3]> {
        let [x, y, z] = vector.0.each_ref().map(|component| self.evaluate(component));
        Some([x?, y?, z?])
    }

    /// Returns the reference point: the pivot, or the centre of mass.
    pub fn point(&self) -> &Vector {
        self.body.pivot.as_ref().unwrap_or(&self.center)
    }
}
