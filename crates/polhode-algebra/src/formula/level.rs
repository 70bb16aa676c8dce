//! Precedence: where a formula within another one needs parentheses or a dot.

use super::{Formula, Operator, Style};

/// Precedence of a formula, from the weakest to the strongest binding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Level {
    /// a = b, lists, rows.
    Relation,
    /// a + b, −a, a ± b.
    Sum,
    /// a × b, a · b.
    Operation,
    /// a b, sin a, Σ a; in text also a/b.
    Product,
    /// aⁿ, dx; a quotient with its numerator above its denominator.
    Power,
    /// Letters, numbers and whatever has brackets.
    Atom,
}

/// Form of quotients, which decides on parentheses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quotients {
    /// Numerator above denominator.
    Stacked,
    /// a/b on one line.
    Linear,
}

/// Place of a formula within another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// First term of a sum.
    FirstTerm,
    /// Other term of a sum, and the value after a minus sign.
    Term,
    /// Operand of × and ·, summand of Σ.
    Operand,
    /// Factor of a product, except the last one.
    Factor,
    /// Last factor of a product.
    LastFactor,
    /// Numerator of a/b.
    Numerator,
    /// Denominator of a/b.
    Denominator,
    /// Variable of a differential.
    Differential,
    /// Base of a power.
    Base,
}

impl Formula {
    /// Returns true if the formula needs parentheses at a place.
    pub(super) fn needs_parentheses(&self, place: Place, quotients: Quotients) -> bool {
        let level = self.level(quotients);
        match place {
            Place::Numerator | Place::Denominator if quotients == Quotients::Stacked => false,
            Place::FirstTerm => level < Level::Sum,
            Place::Term => level < Level::Operation,
            Place::Operand | Place::LastFactor => level < Level::Product,
            Place::Factor => level < Level::Product || matches!(self, Self::Limits { .. }),
            Place::Numerator => {
                level < Level::Product
                    || matches!(self, Self::Fraction(..) | Self::Limits { .. })
                    || self.is_open_ended()
            }
            Place::Denominator | Place::Differential => level < Level::Power,
            Place::Base => level < Level::Atom,
        }
    }

    fn level(&self, quotients: Quotients) -> Level {
        match self {
            Self::Relation(..) | Self::List(_) | Self::Rows(_) | Self::Cases(_) => Level::Relation,
            Self::Sum(_) | Self::Negative(_) | Self::Operation(Operator::PlusMinus, _) => Level::Sum,
            Self::Operation(..) => Level::Operation,
            Self::Product(factors) => {
                let has_fraction = factors.iter().any(|factor| matches!(factor, Self::Fraction(..)));
                let is_split = quotients == Quotients::Linear && has_fraction;
                if is_split { Level::Operation } else { Level::Product }
            }
            Self::Fraction(..) if quotients == Quotients::Linear => Level::Product,
            Self::Function(..) | Self::Limits { .. } => Level::Product,
            Self::Fraction(..) | Self::Power(..) | Self::Differential { .. } => Level::Power,
            _ => Level::Atom,
        }
    }

    /// Returns true if a formula written after this one might be read as a part of it: sin θ.
    fn is_open_ended(&self) -> bool {
        match self {
            Self::Product(factors) => factors.last().is_some_and(Self::is_open_ended),
            _ => self.is_function(),
        }
    }

    /// Returns true for numbers, their quotients and square roots: a coefficient.
    pub(super) fn is_numeric(&self) -> bool {
        match self {
            Self::Number(_) => true,
            Self::Fraction(a, b) => a.is_numeric() && b.is_numeric(),
            Self::Root(value) | Self::Negative(value) => value.is_numeric(),
            Self::Product(factors) => factors.iter().all(Self::is_numeric),
            _ => false,
        }
    }

    /// Returns true if a factor needs a dot before the next one: sin a · b, 2 · 3, and in text a/b ·
    /// c.
    pub(super) fn needs_dot_before(&self, next: &Self, quotients: Quotients) -> bool {
        let is_quotient = |f: &Self| matches!(f, Self::Fraction(..)) && !f.is_numeric();
        let is_number =
            |f: &Self| matches!(f, Self::Number(_)) || (f.is_numeric() && !matches!(f, Self::Root(_)));
        // A unit vector after sin θ is not part of the angle.
        let is_closed = match next {
            Self::Function(..) | Self::Accent(..) => true,
            Self::Subscript(base, _) | Self::Power(base, _) => {
                matches!(**base, Self::Accent(..) | Self::Function(..))
            }
            _ => false,
        };
        let is_linear = quotients == Quotients::Linear;
        (is_linear && (is_quotient(self) || is_quotient(next)))
            || (is_number(next) && (is_linear || is_number(self)))
            || (self.is_open_ended() && !is_closed)
    }

    /// Returns true if a factor needs more than the usual space before the next one: x dx, sin θ x̂.
    pub(super) fn needs_space_before(&self, next: &Self) -> bool {
        matches!(next, Self::Differential { .. }) || (self.is_open_ended() && !next.is_function())
    }

    /// Returns true for sin θ and sin² θ.
    pub(crate) fn is_function(&self) -> bool {
        match self {
            Self::Function(..) => true,
            Self::Power(base, _) => matches!(**base, Self::Function(..)),
            _ => false,
        }
    }

    /// Returns true if the argument of a function needs no parentheses.
    pub(super) fn is_bare_argument_of(&self, function: &Self) -> bool {
        match function {
            Self::Letter(_, Style::Upright) => self.level(Quotients::Linear) >= Level::Power,
            // d/dt
            Self::Fraction(..) => self.level(Quotients::Stacked) >= Level::Power,
            _ => false,
        }
    }

    /// Returns true if brackets around the formula are to be larger than a letter.
    pub(super) fn is_tall(&self) -> bool {
        match self {
            Self::Fraction(..) | Self::Matrix(..) | Self::Cases(_) | Self::Limits { .. } | Self::Rows(_) => {
                true
            }
            Self::Sum(parts) | Self::Product(parts) | Self::Operation(_, parts) | Self::List(parts) => {
                parts.iter().any(Self::is_tall)
            }
            Self::Negative(a)
            | Self::Root(a)
            | Self::Group(_, a)
            | Self::Subscript(a, _)
            | Self::Power(a, _) => a.is_tall(),
            Self::Function(f, a) => f.is_tall() || a.is_tall(),
            Self::Relation(first, others) => first.is_tall() || others.iter().any(|(_, f)| f.is_tall()),
            _ => false,
        }
    }
}
