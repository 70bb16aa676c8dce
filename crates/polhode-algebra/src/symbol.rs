//! Symbols, and the variables that polynomials have.

/// Symbol of a [`Symbols`](crate::Symbols) table, or one of its time derivatives.
///
/// The order is that of the declarations; θ is followed by θ̇ and θ̈.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol {
    /// Place in the table.
    pub(crate) place: u16,
    /// Order of the time derivative.
    pub(crate) order: u8,
}

impl Symbol {
    /// Returns the time derivative; `None` beyond the order of 255.
    pub fn dot(self) -> Option<Self> {
        Some(Self { order: self.order.checked_add(1)?, ..self })
    }

    /// Returns the order of the time derivative: 0 for θ, 1 for θ̇.
    pub const fn order(self) -> u8 {
        self.order
    }
}

/// Variable of polynomials.
///
/// Square roots, and sines, are algebraic over the other variables: (√p)² = p and sin² θ = 1 −
/// cos² θ. The order is that of factors in a product.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Variable {
    /// Square root of a prime number.
    Root(u32),
    /// Symbol itself, or its derivative.
    Symbol(Symbol),
    /// Sine of an angle.
    Sine(Symbol),
    /// Cosine of an angle.
    Cosine(Symbol),
}

impl Variable {
    /// Returns true for √p and sin θ, whose squares are polynomials in other variables.
    pub const fn is_algebraic(self) -> bool {
        matches!(self, Self::Root(_) | Self::Sine(_))
    }
}
