//! Conversion of numbers of one unit to SI.

/// Conversion factor of a unit. It divides for powers of ten below one, so that each value is
/// rounded only once.
#[derive(Clone, Copy, Debug)]
pub enum Scale {
    /// Multiplies by a factor.
    Times(f64),
    /// Divides by a factor.
    Over(f64),
}

impl Scale {
    /// Creates a scale from its factor.
    pub fn from_factor(factor: f64) -> Self {
        let inverse = (1.0 / factor).round();
        let exact = factor < 1.0 && 1.0 / inverse == factor;
        if exact { Self::Over(inverse) } else { Self::Times(factor) }
    }

    /// Returns a value in SI units.
    pub fn apply(self, value: f64) -> f64 {
        match self {
            Self::Times(factor) => value * factor,
            Self::Over(inverse) => value / inverse,
        }
    }
}
