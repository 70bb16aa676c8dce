//! Sums that carry their rounding errors.

/// a + b as rounded sum and exact error (Knuth, TAOCP 2, §4.2.2, Theorem B).
pub(crate) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let bb = s - a;
    (s, (a - (s - bb)) + (b - bb))
}

/// A running sum of many terms whose error does not grow with their number.
///
/// Ogita, Rump & Oishi, SIAM J. Sci. Comput. 26 (2005) 1955, algorithm 4.4 (`Sum2`):
/// |error| ≤ ε |Σ aᵢ| + γ² Σ |aᵢ|.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sum {
    high: f64,
    low: f64,
}

impl Sum {
    pub(crate) fn add(&mut self, term: f64) {
        let (high, error) = two_sum(self.high, term);
        self.high = high;
        self.low += error;
    }

    pub(crate) fn value(self) -> f64 {
        self.high + self.low
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_keeps_what_plain_addition_loses() {
        let mut sum = Sum::default();
        let terms = [1e16, 3.25, -1e16, 1e-3, 7e15, -7e15, -0.25];
        for t in terms {
            sum.add(t);
        }
        assert_eq!(sum.value(), 3.001);
        assert_ne!(terms.iter().sum::<f64>(), 3.001);
    }
}
