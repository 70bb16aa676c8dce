//! Numbers of one unit as SI.

/// A unit's value, so that powers of ten below one are divided by and round once only.
#[derive(Clone, Copy, Debug)]
pub enum Scale {
    /// Multiplies by a factor.
    Times(f64),
    /// Divides by a factor.
    Over(f64),
}

impl Scale {
    /// Scale that multiplies by a factor.
    pub fn by(factor: f64) -> Self {
        let inverse = (1.0 / factor).round();
        let exact = factor < 1.0 && 1.0 / inverse == factor;
        if exact { Self::Over(inverse) } else { Self::Times(factor) }
    }

    /// Value in SI.
    pub fn apply(self, value: f64) -> f64 {
        match self {
            Self::Times(factor) => value * factor,
            Self::Over(inverse) => value / inverse,
        }
    }
}
