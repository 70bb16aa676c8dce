//! Table of the declared symbols.

use core::fmt;

use crate::formula::{Accent, Formula};
use crate::symbol::{Symbol, Variable};

/// Names that formulas use for functions.
const RESERVED: [&str; 4] = ["cos", "pi", "sin", "sqrt"];

/// Largest number of symbols.
const MOST: usize = 1000;

/// Table of symbols in the order in which products and sums are printed.
#[derive(Clone, Debug, Default)]
pub struct Symbols {
    declared: Vec<Declared>,
}

#[derive(Clone, Debug)]
struct Declared {
    name: String,
    notation: Formula,
    kind: Kind,
}

/// Assumption about a symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Constant of any sign.
    Constant,
    /// Positive constant, whose square has it as its root.
    Positive,
    /// Function of time, which has derivatives.
    Coordinate,
}

/// Name that cannot be declared.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SymbolError {
    /// The name is not a letter followed by letters, digits and `_`.
    Form {
        /// Name that was given.
        name: String,
    },
    /// The name is that of a function.
    Reserved {
        /// Name that was given.
        name: String,
    },
    /// Another symbol has the same name, or is printed in the same way: `m1` and `m_1`.
    Duplicate {
        /// Name that was given.
        name: String,
        /// Name of the symbol that is declared already.
        other: String,
    },
    /// The table is full.
    TooMany,
}

impl Symbols {
    /// Returns an empty table.
    pub const fn new() -> Self {
        Self { declared: Vec::new() }
    }

    /// Declares a symbol, which is printed as [`Formula::named`] has it.
    ///
    /// # Errors
    /// [`SymbolError`] if the name cannot be used.
    pub fn declare(&mut self, name: &str, kind: Kind) -> Result<Symbol, SymbolError> {
        self.declare_as(name, Formula::named(name), kind)
    }

    /// Declares a symbol that is printed in a form of its own.
    ///
    /// # Errors
    /// [`SymbolError`] if the name cannot be used.
    pub fn declare_as(&mut self, name: &str, notation: Formula, kind: Kind) -> Result<Symbol, SymbolError> {
        let mut letters = name.chars();
        let is_name = letters.next().is_some_and(char::is_alphabetic)
            && letters.all(|c| c.is_alphanumeric() || c == '_');
        let name = name.to_owned();
        if !is_name {
            return Err(SymbolError::Form { name });
        }
        if RESERVED.contains(&name.as_str()) {
            return Err(SymbolError::Reserved { name });
        }
        if let Some(other) = self.declared.iter().find(|d| d.name == name || d.notation == notation) {
            return Err(SymbolError::Duplicate { name, other: other.name.clone() });
        }
        let place = u16::try_from(self.declared.len()).ok().filter(|place| usize::from(*place) < MOST);
        let place = place.ok_or(SymbolError::TooMany)?;
        self.declared.push(Declared { name, notation, kind });
        Ok(Symbol { place, order: 0 })
    }

    /// Returns the symbol with a name; `theta_dot` and `theta_ddot` are derivatives of a coordinate.
    pub fn find(&self, name: &str) -> Option<Symbol> {
        let of = |name: &str, order| {
            let place = self.declared.iter().position(|d| d.name == name)?;
            (order == 0 || self.declared[place].kind == Kind::Coordinate)
                .then_some(Symbol { place: place as u16, order })
        };
        let derivative = |suffix, order| of(name.strip_suffix(suffix)?, order);
        of(name, 0).or_else(|| derivative("_dot", 1)).or_else(|| derivative("_ddot", 2))
    }

    /// Returns the declared names in order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.declared.iter().map(|declared| declared.name.as_str())
    }

    /// Returns the name of a symbol, with `_dot` for its time derivative.
    pub fn name(&self, symbol: Symbol) -> String {
        let name = self.get(symbol).map_or("?", |declared| &declared.name);
        match symbol.order {
            0 => name.to_owned(),
            order => format!("{name}_{}dot", "d".repeat(usize::from(order) - 1)),
        }
    }

    /// Returns the assumption about a symbol.
    pub fn kind(&self, symbol: Symbol) -> Kind {
        self.get(symbol).map_or(Kind::Constant, |declared| declared.kind)
    }

    /// Returns the printed form of a symbol, with dots for time derivatives.
    pub fn notation(&self, symbol: Symbol) -> Formula {
        let letter =
            self.get(symbol).map_or_else(|| Formula::text("?"), |declared| declared.notation.clone());
        match symbol.order {
            0 => letter,
            1 => letter.accented(Accent::Dot),
            2 => letter.accented(Accent::DoubleDot),
            3 => letter.accented(Accent::TripleDot),
            order => {
                letter.power(Formula::integer(i64::from(order)).grouped(crate::formula::Fence::Parentheses))
            }
        }
    }

    /// Returns true for positive symbols and square roots of primes.
    pub fn is_positive(&self, variable: Variable) -> bool {
        match variable {
            Variable::Root(_) => true,
            Variable::Symbol(symbol) => self.kind(symbol) == Kind::Positive,
            Variable::Sine(_) | Variable::Cosine(_) => false,
        }
    }

    fn get(&self, symbol: Symbol) -> Option<&Declared> {
        self.declared.get(usize::from(symbol.place))
    }
}

impl fmt::Display for SymbolError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Form { name } => {
                write!(f, "`{name}` is not a symbol: a letter, then letters, digits and _, such as m_1")
            }
            Self::Reserved { name } => write!(f, "`{name}` is the name of a function; choose another symbol"),
            Self::Duplicate { name, other } if name == other => {
                write!(f, "symbol `{name}` is declared twice")
            }
            Self::Duplicate { name, other } => {
                write!(f, "symbols `{name}` and `{other}` are printed in the same way; rename one")
            }
            Self::TooMany => write!(f, "more than {MOST} symbols"),
        }
    }
}

impl core::error::Error for SymbolError {}
