//! Formulas as trees, printed as text, LaTeX and MathML.
//!
//! The tree has no parentheses except those of [`Formula::Group`]: each writer adds the necessary
//! ones. In text a quotient is written a/b, so that its parts may need parentheses.

mod block;
mod latex;
mod letter;
mod level;
mod mathml;
mod name;
mod text;
mod writer;

/// Formula as a tree.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Formula {
    /// Number without sign, in digits: `2`, `0.25`.
    Number(String),
    /// Letter, or a word such as `max`.
    Letter(String, Style),
    /// Words or units within a formula; empty for an omitted left side.
    Text(String),
    /// Negative value −a.
    Negative(Box<Formula>),
    /// a + b − c, where −c is [`Formula::Negative`].
    Sum(Vec<Formula>),
    /// Product a b c.
    Product(Vec<Formula>),
    /// a × b, with one operator between all operands.
    Operation(Operator, Vec<Formula>),
    /// Numerator and denominator.
    Fraction(Box<Formula>, Box<Formula>),
    /// Base and exponent.
    Power(Box<Formula>, Box<Formula>),
    /// Base and index.
    Subscript(Box<Formula>, Box<Formula>),
    /// Square root √a.
    Root(Box<Formula>),
    /// Function or operator with its argument: sin θ, f(t), d/dt (…).
    Function(Box<Formula>, Box<Formula>),
    /// Differential: dx, or ∂x if partial.
    Differential {
        /// True for ∂.
        is_partial: bool,
        /// Variable that changes.
        of: Box<Formula>,
    },
    /// Letter with a mark above it.
    Accent(Accent, Box<Formula>),
    /// Sum or integral with its limits.
    Limits {
        /// Σ or ∫.
        operator: Large,
        /// Lower limit, or index of summation.
        below: Option<Box<Formula>>,
        /// Upper limit, if any.
        above: Option<Box<Formula>>,
        /// Summand or integrand.
        body: Box<Formula>,
    },
    /// Matrix; a determinant has [`Fence::Bars`].
    Matrix(Fence, Vec<Vec<Formula>>),
    /// Formula in brackets.
    Group(Fence, Box<Formula>),
    /// Formulas separated by commas.
    List(Vec<Formula>),
    /// Relations a = b = c, as the first side and the others with their signs.
    Relation(Box<Formula>, Vec<(Relation, Formula)>),
    /// Alternatives, each with its condition.
    Cases(Vec<(Formula, Formula)>),
    /// Lines, aligned at the first sign of each relation.
    Rows(Vec<Formula>),
}

/// Type face of a letter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Style {
    /// Symbol of a number.
    Italic,
    /// Name of a function.
    Upright,
    /// Symbol of a vector or tensor.
    Bold,
}

/// Mark above a letter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Accent {
    /// First time derivative.
    Dot,
    /// Second time derivative.
    DoubleDot,
    /// Third time derivative.
    TripleDot,
    /// Mark of unit vectors.
    Hat,
    /// Mark of mean values.
    Bar,
}

/// Operator between operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operator {
    /// Vector product, and product of numbers: ×.
    Cross,
    /// Scalar product: ·.
    Dot,
    /// Either sign: ±.
    PlusMinus,
}

/// Operator with limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Large {
    /// Sum, with Σ.
    Sum,
    /// Integral, with ∫.
    Integral,
}

/// Pair of brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fence {
    /// Parentheses ( ).
    Parentheses,
    /// Square brackets [ ].
    Brackets,
    /// Curly braces { }.
    Braces,
    /// Vertical bars | |.
    Bars,
}

/// Sign of a relation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Relation {
    /// Equal sign =.
    Equal,
    /// Unequal sign ≠.
    Unequal,
    /// ≡, equal by definition.
    Defined,
    /// ≃, equal up to terms of higher order.
    Approximate,
    /// Less than: <.
    Less,
    /// Less or equal: ≤.
    AtMost,
    /// Greater than: >.
    Greater,
    /// Greater or equal: ≥.
    AtLeast,
    /// Leads to: →.
    To,
    /// Implies the next: ⇒.
    Implies,
}

impl Formula {
    /// Returns an integer.
    pub fn integer(value: i64) -> Self {
        let number = Self::Number(value.unsigned_abs().to_string());
        if value < 0 { number.negative() } else { number }
    }

    /// Returns a decimal such as `-3.3e-5` as −3.3 × 10⁻⁵.
    pub fn decimal(text: &str) -> Self {
        let (digits, is_negative) = text.strip_prefix('-').map_or((text, false), |digits| (digits, true));
        let number = match digits.split_once('e') {
            None => Self::Number(digits.to_owned()),
            Some((mantissa, exponent)) => {
                let exponent = Self::integer(exponent.parse().unwrap_or_default());
                let power = Self::integer(10).power(exponent);
                Self::Operation(Operator::Cross, vec![Self::Number(mantissa.to_owned()), power])
            }
        };
        if is_negative { number.negative() } else { number }
    }

    /// Returns a bold letter with the index of a [`Formula::named`] symbol.
    pub fn vector(name: &str) -> Self {
        Self::named(name).bold()
    }

    /// Returns the formula with the letter of its base in bold.
    #[must_use]
    pub fn bold(self) -> Self {
        match self {
            Self::Letter(letter, _) => Self::Letter(letter, Style::Bold),
            Self::Subscript(base, index) => Self::Subscript(Box::new(base.bold()), index),
            Self::Accent(accent, base) => Self::Accent(accent, Box::new(base.bold())),
            other => other,
        }
    }

    /// Returns words within a formula.
    pub fn text(words: &str) -> Self {
        Self::Text(words.to_owned())
    }

    /// Returns the sum of terms; the only term, or 0. Sums among them are not nested.
    pub fn sum(terms: Vec<Self>) -> Self {
        let mut flat = Vec::new();
        for term in terms {
            match term {
                Self::Sum(inner) => flat.extend(inner),
                other => flat.push(other),
            }
        }
        match flat.len() {
            0 => Self::integer(0),
            1 => flat.swap_remove(0),
            _ => Self::Sum(flat),
        }
    }

    /// Returns the product of factors; the only factor, or 1. Products among them are not nested.
    pub fn product(factors: Vec<Self>) -> Self {
        let mut flat = Vec::new();
        for factor in factors {
            match factor {
                Self::Product(inner) => flat.extend(inner),
                other => flat.push(other),
            }
        }
        match flat.len() {
            0 => Self::integer(1),
            1 => flat.swap_remove(0),
            _ => Self::Product(flat),
        }
    }

    /// Returns the product of this formula and another, with a minus sign outside.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        match self {
            Self::Negative(value) => Self::product(vec![*value, other]).negative(),
            value => Self::product(vec![value, other]),
        }
    }

    /// Returns −a; a for −a.
    #[must_use]
    pub fn negative(self) -> Self {
        match self {
            Self::Negative(value) => *value,
            other => Self::Negative(Box::new(other)),
        }
    }

    /// Returns the quotient of this formula and another.
    #[must_use]
    pub fn over(self, denominator: Self) -> Self {
        Self::Fraction(Box::new(self), Box::new(denominator))
    }

    /// Returns the power of this formula.
    #[must_use]
    pub fn power(self, exponent: Self) -> Self {
        Self::Power(Box::new(self), Box::new(exponent))
    }

    /// Returns the square of this formula.
    #[must_use]
    pub fn squared(self) -> Self {
        self.power(Self::integer(2))
    }

    /// Returns the formula with an index.
    #[must_use]
    pub fn index(self, index: Self) -> Self {
        Self::Subscript(Box::new(self), Box::new(index))
    }

    /// Returns the square root of this formula.
    #[must_use]
    pub fn root(self) -> Self {
        Self::Root(Box::new(self))
    }

    /// Returns this formula with an accent on the letter of its base: ω̇₁ for ω₁.
    #[must_use]
    pub fn accented(self, accent: Accent) -> Self {
        match self {
            Self::Subscript(base, index) => Self::Subscript(Box::new(base.accented(accent)), index),
            other => Self::Accent(accent, Box::new(other)),
        }
    }

    /// Returns a function, such as `sin`, of this formula.
    #[must_use]
    pub fn applied(self, function: &str) -> Self {
        let name = Self::Letter(function.to_owned(), Style::Upright);
        Self::Function(Box::new(name), Box::new(self))
    }

    /// Returns d(…)/dx of this formula, or ∂(…)/∂x.
    #[must_use]
    pub fn derivative(self, variable: Self, is_partial: bool) -> Self {
        let differential = |of| Self::Differential { is_partial, of: Box::new(of) };
        differential(self).over(differential(variable))
    }

    /// Returns d/dt (…) of this formula.
    #[must_use]
    pub fn time_derivative(self) -> Self {
        let letter = |name: &str| Self::Letter(name.to_owned(), Style::Italic);
        let time = Self::Differential { is_partial: false, of: Box::new(letter("t")) };
        Self::Function(Box::new(letter("d").over(time)), Box::new(self))
    }

    /// Returns this formula in brackets.
    #[must_use]
    pub fn grouped(self, fence: Fence) -> Self {
        Self::Group(fence, Box::new(self))
    }

    /// Returns `self = other`, or a longer chain if this formula is already a relation.
    #[must_use]
    pub fn equals(self, other: Self) -> Self {
        self.related(Relation::Equal, other)
    }

    /// Returns this formula and another with the sign of a relation between them.
    #[must_use]
    pub fn related(self, sign: Relation, other: Self) -> Self {
        match self {
            Self::Relation(first, mut others) => {
                others.push((sign, other));
                Self::Relation(first, others)
            }
            first => Self::Relation(Box::new(first), vec![(sign, other)]),
        }
    }

    /// Returns a determinant.
    pub fn determinant(rows: Vec<Vec<Self>>) -> Self {
        Self::Matrix(Fence::Bars, rows)
    }

    /// Returns Σ of a formula over an index.
    pub fn sum_over(index: Self, body: Self) -> Self {
        let below = Some(Box::new(index));
        Self::Limits { operator: Large::Sum, below, above: None, body: Box::new(body) }
    }

    /// Returns the integral of a formula between limits.
    pub fn integral(below: Self, above: Self, body: Self) -> Self {
        let [below, above] = [below, above].map(|limit| Some(Box::new(limit)));
        Self::Limits { operator: Large::Integral, below, above, body: Box::new(body) }
    }
}
