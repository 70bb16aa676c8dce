//! Display of numbers for people.

use core::fmt;

/// Number with as many digits as distinguish it from all others, or as many as the formatter
/// requests; very large and very small numbers with a power of ten.
pub(crate) struct Shown(pub(crate) f64);

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0 == 0.0 || !self.0.is_finite() || (1e-4..1e16).contains(&self.0.abs()) {
            fmt::Display::fmt(&self.0, f)
        } else {
            fmt::LowerExp::fmt(&self.0, f)
        }
    }
}

/// Writes numbers in parentheses.
pub(crate) fn row(f: &mut fmt::Formatter<'_>, numbers: &[f64]) -> fmt::Result {
    f.write_str("(")?;
    for (k, number) in numbers.iter().enumerate() {
        if k > 0 {
            f.write_str(", ")?;
        }
        fmt::Display::fmt(&Shown(*number), f)?;
    }
    f.write_str(")")
}
