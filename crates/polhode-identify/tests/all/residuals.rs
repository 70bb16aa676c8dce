//! Acceptance rate of the residuals of a right model.

use std::fmt;

use polhode_identify::ResidualTest;

use crate::draws::{draws, is_about_one, tolerance};

/// Excess of the residuals over the noise in many draws, standard deviations.
#[derive(Default)]
pub(super) struct Excess {
    all: Vec<f64>,
    odd: usize,
}

impl Excess {
    pub(super) fn add(&mut self, test: &ResidualTest) {
        self.all.push(test.excess());
        self.odd += usize::from(test.is_too_large() || test.is_correlated());
    }

    fn mean(&self) -> f64 {
        self.all.iter().sum::<f64>() / self.all.len() as f64
    }

    fn deviation(&self) -> f64 {
        let mean = self.mean();
        (self.all.iter().map(|z| (z - mean).powi(2)).sum::<f64>() / self.all.len() as f64).sqrt()
    }

    /// Returns the share above the 95 % quantile of a normal distribution.
    fn beyond(&self) -> f64 {
        self.all.iter().filter(|z| **z > 1.645).count() as f64 / self.all.len() as f64
    }

    /// Checks the mean against zero, the deviation against one, the share beyond 1.645 against one
    /// in twenty, and that none is beyond 5. With 300 draws the standard errors are 0.06, 0.04 and
    /// 0.013.
    pub(super) fn hold(&self) {
        println!("{self}");
        assert!(self.all.len() as u64 >= draws(300) && self.odd == 0, "{self}");
        assert!(self.mean().abs() < tolerance(0.25) && is_about_one(self.deviation(), 0.2), "{self}");
        assert!((self.beyond() - 0.05).abs() < tolerance(0.04), "{self}");
    }
}

impl fmt::Display for Excess {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (mean, deviation, beyond) = (self.mean(), self.deviation(), self.beyond());
        write!(f, "excess {mean:.3} ± {deviation:.3}, beyond 1.645 {beyond:.3}, findings {}", self.odd)
    }
}
